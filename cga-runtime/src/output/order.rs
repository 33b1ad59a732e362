//! The order in which flat faces are painted over each other.
//!
//! If two faces overlap in the picture, their depth at a common point decides. Faces that do not overlap need no
//! order, and the farther one comes first. Cycles, which only cutting could resolve, are broken at the farthest face.

use crate::geometry::each::Each;
use glam::{DVec2, DVec3};

/// A face in the picture. Depth grows towards the viewer.
#[derive(Debug)]
pub(crate) struct DepthFace {
    outline: Vec<DVec2>,
    low: DVec2,
    high: DVec2,
    /// The depth as a plane over the picture: the middle, and the slopes.
    middle: DVec3,
    slope: DVec2,
}

impl DepthFace {
    /// A face from corners in the picture with depth: at least three, not on a line.
    pub(crate) fn new(corners: &[DVec3]) -> DepthFace {
        let outline: Vec<DVec2> = corners.iter().map(|corner| corner.truncate()).collect();
        let low = outline.iter().copied().fold(DVec2::INFINITY, DVec2::min);
        let high = outline.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
        let count = corners.len() as f64;
        let middle = corners.iter().fold(DVec3::ZERO, |sum, &corner| sum + corner / count);
        // The normal, as a sum over all edges.
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        let n = edges.fold(DVec3::ZERO, |sum, (&a, &b)| sum + (a - middle).cross(b - middle));
        let slope = if n.z == 0.0 { DVec2::ZERO } else { -n.truncate() / n.z };
        DepthFace { outline, low, high, middle, slope }
    }

    fn depth(&self, at: DVec2) -> f64 {
        self.middle.z + self.slope.x * (at.x - self.middle.x) + self.slope.y * (at.y - self.middle.y)
    }
}

/// Faces that overlap by less than this, in the units of the picture, only touch.
const SLIGHT: f64 = 0.05;

/// The amount by which `a` is nearer than `b` where they overlap; 0 if they do not overlap or the order is unclear.
fn nearer(a: &DepthFace, b: &DepthFace) -> f64 {
    if (a.high - SLIGHT).cmple(b.low).any() || (b.high - SLIGHT).cmple(a.low).any() {
        return 0.0;
    }
    // For small faces, the common part of the convex hulls is close enough to the common part of the faces.
    let common = clip(&a.outline, &b.outline);
    if area(&common).abs() < SLIGHT * SLIGHT {
        return 0.0;
    }
    let count = common.len() as f64;
    let middle = common.iter().fold(DVec2::ZERO, |sum, &point| sum + point / count);
    a.depth(middle) - b.depth(middle)
}

fn area(ring: &[DVec2]) -> f64 {
    let twice: f64 = ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum();
    0.5 * twice
}

/// The part of one outline within another, which is treated as convex.
fn clip(subject: &[DVec2], window: &[DVec2]) -> Vec<DVec2> {
    let mut kept = subject.to_vec();
    let turn = area(window).signum();
    for (a, b) in window.iter().zip(window.iter().cycle().skip(1)) {
        let side = |p: DVec2| turn * (b - a).perp_dot(p - a);
        let mut next = Vec::with_capacity(kept.len() + 1);
        for (&p, &q) in kept.iter().zip(kept.iter().cycle().skip(1)) {
            let (sp, sq) = (side(p), side(q));
            if 0.0 <= sp {
                next.push(p);
            }
            if (0.0 < sp && sq < 0.0) || (sp < 0.0 && 0.0 < sq) {
                next.push(p + (q - p) * (sp / (sp - sq)));
            }
        }
        kept = next;
    }
    kept
}

/// The indices of the faces in the order of painting.
pub(crate) fn back_to_front(faces: Vec<&DepthFace>) -> Vec<usize> {
    // Farther middles first, as a start and wherever other rules do not decide; equal ones in their given order.
    let mut start: Vec<usize> = (0..faces.len()).collect();
    start.sort_by(|&a, &b| faces[a].middle.z.total_cmp(&faces[b].middle.z).then(a.cmp(&b)));
    let behind = behind(&faces, &start);
    // Paints the faces behind a face before it: a depth-first walk, without recursion.
    let mut order = Vec::with_capacity(faces.len());
    let mut state = vec![0u8; faces.len()];
    let mut stack: Vec<(usize, usize)> = Vec::new();
    for &root in &start {
        if state[root] != 0 {
            continue;
        }
        state[root] = 1;
        stack.push((root, 0));
        while let Some((face, next)) = stack.pop() {
            match behind[face].get(next) {
                Some(&other) => {
                    stack.push((face, next + 1));
                    if state[other] == 0 {
                        state[other] = 1;
                        stack.push((other, 0));
                    }
                }
                None => order.push(face),
            }
        }
    }
    order
}

/// For each face the faces behind it, found among neighbours on a grid.
fn behind(faces: &[&DepthFace], start: &[usize]) -> Vec<Vec<usize>> {
    let mut behind = vec![Vec::new(); faces.len()];
    let low = faces.iter().fold(DVec2::INFINITY, |low, face| low.min(face.low));
    let high = faces.iter().fold(DVec2::NEG_INFINITY, |high, face| high.max(face.high));
    let cells = 1.max((faces.len() as f64).sqrt() as usize / 2).min(256);
    let size = (high - low).max(DVec2::splat(1e-9));
    let cell = |at: DVec2| ((at - low) / size * cells as f64).to_array().each(|place| (place as usize).min(cells - 1));
    let mut grid = vec![Vec::new(); cells * cells];
    for &face in start {
        let ([left, bottom], [right, top]) = (cell(faces[face].low), cell(faces[face].high));
        for y in bottom..=top {
            for x in left..=right {
                let list: &mut Vec<usize> = &mut grid[y * cells + x];
                for &other in list.iter() {
                    // Each pair is compared once: in the cell where the common part of their boxes begins.
                    if cell(faces[other].low.max(faces[face].low)) != [x, y] {
                        continue;
                    }
                    match nearer(faces[face], faces[other]) {
                        d if 1e-9 < d => behind[face].push(other),
                        d if d < -1e-9 => behind[other].push(face),
                        _ => {}
                    }
                }
                list.push(face);
            }
        }
    }
    behind
}
