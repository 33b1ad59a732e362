//! The fallback: a constrained Delaunay triangulation, its regions kept or dropped as wholes.
//!
//! Asking of each triangle whether its own middle is inside keeps slivers between a nearly straight wall and the convex
//! hull. So triangles are gathered into regions between the loops first, and each region is asked once, at the middle of
//! its largest triangle.

use std::collections::HashMap;

use glam::DVec2;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};

use crate::mesh::check::winding;

/// A vertex, and the first polygon corner there. One that a crossing of loops made has none.
#[derive(Clone, Copy)]
struct Vertex {
    at: Point2<f64>,
    corner: Option<u32>,
}

impl HasPosition for Vertex {
    type Scalar = f64;
    fn position(&self) -> Point2<f64> {
        self.at
    }
}

/// Appends the triangles, or nothing when the loops cross.
pub(super) fn triangulate(points: &[DVec2], loop_ends: &[u32], out: &mut Vec<[u32; 3]>) {
    let from = points[0];
    let extent = points.iter().fold(0.0f64, |m, p| m.max((*p - from).abs().max_element()));
    if !(extent > 0.0 && extent < f64::INFINITY) {
        return;
    }
    // By a power of two: moves no digit, and keeps sizes in the range the triangulation takes.
    let scale = libm::exp2(-libm::floor(libm::log2(extent)));
    let flat: Vec<DVec2> = points.iter().map(|&p| (p - from) * scale).collect();
    let from_len = out.len();
    if fill(&flat, loop_ends, out).is_none() {
        out.truncate(from_len);
    }
}

fn fill(flat: &[DVec2], loop_ends: &[u32], out: &mut Vec<[u32; 3]>) -> Option<()> {
    let mut net = ConstrainedDelaunayTriangulation::<Vertex>::new();
    let mut handles = Vec::with_capacity(flat.len());
    // The corner that follows and precedes each, and all corners at a vertex.
    let mut next = vec![0u32; flat.len()];
    let mut places: HashMap<usize, Vec<u32>> = HashMap::new();
    for (i, p) in flat.iter().enumerate() {
        let at = Point2::new(p.x, p.y);
        let handle = net.insert(Vertex { at, corner: Some(i as u32) }).ok()?;
        places.entry(handle.index()).or_default().push(i as u32);
        handles.push(handle);
    }
    let mut start = 0;
    for &end in loop_ends {
        let end = end as usize;
        for i in start..end {
            let j = if i + 1 == end { start } else { i + 1 };
            next[i] = j as u32;
            if handles[i] != handles[j] {
                net.add_constraint_and_split(handles[i], handles[j], |at| Vertex { at, corner: None });
            }
        }
        start = end;
    }
    if net.vertices().any(|v| v.data().corner.is_none()) {
        return None;
    }

    // Regions: triangles joined across edges that are no constraint. Face 0 is the outer one.
    let faces = net.num_all_faces();
    let mut region = vec![u32::MAX; faces];
    let mut stack = Vec::new();
    let mut kept = Vec::new();
    for seed in net.inner_faces() {
        if region[seed.index()] != u32::MAX {
            continue;
        }
        let id = kept.len() as u32;
        region[seed.index()] = id;
        stack.push(seed);
        let mut outside = false;
        let mut largest = (-1.0, DVec2::ZERO);
        while let Some(face) = stack.pop() {
            let [a, b, c] = face.positions().map(|p| DVec2::new(p.x, p.y));
            let area = (b - a).perp_dot(c - a);
            if largest.0 < area {
                largest = (area, (a + b + c) / 3.0);
            }
            for edge in face.adjacent_edges() {
                if edge.is_constraint_edge() {
                    continue;
                }
                match edge.rev().face().as_inner() {
                    None => outside = true,
                    Some(other) if region[other.index()] == u32::MAX => {
                        region[other.index()] = id;
                        stack.push(other);
                    }
                    Some(_) => {}
                }
            }
        }
        kept.push(!outside && inside(flat, loop_ends, largest.1));
    }

    for face in net.inner_faces() {
        if !kept[region[face.index()] as usize] {
            continue;
        }
        let vertices = face.vertices();
        let corner = |k: usize| {
            let here = &places[&vertices[k].index()];
            if here.len() == 1 {
                return here[0];
            }
            // Loops touch here: the corner whose edge this triangle has.
            let [after, before] = [vertices[(k + 1) % 3].index(), vertices[(k + 2) % 3].index()];
            let leads = |c: u32, to: usize| handles[next[c as usize] as usize].index() == to;
            let at = |place: usize| places[&place].iter().copied();
            here.iter()
                .copied()
                .find(|&c| leads(c, after))
                .or_else(|| at(before).map(|c| next[c as usize]).find(|c| here.contains(c)))
                .unwrap_or(here[0])
        };
        out.push([corner(0), corner(1), corner(2)]);
    }
    Some(())
}

/// Even-odd.
fn inside(flat: &[DVec2], loop_ends: &[u32], p: DVec2) -> bool {
    let (mut start, mut odd) = (0, false);
    for &end in loop_ends {
        odd ^= winding(&flat[start..end as usize], p).unwrap_or(0) % 2 != 0;
        start = end as usize;
    }
    odd
}
