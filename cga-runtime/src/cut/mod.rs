//! Cutting a mesh into slabs across an axis, and closing what the cut opens.
//!
//! One pass for all planes. The side of a point is one comparison of its coordinate with the offset: exact, and nothing
//! moves. Where an edge meets a plane the point is made once, from the end that comes first in lexicographic order, with
//! the cut coordinate set to the offset itself; every face and both sides use that point. From there on everything is
//! decided by index: which pieces meet, which edges a side lacks a partner for, which loops those make.
//!
//! A face in a plane goes to the side its normal points away from, which it closes (of a mesh that is inside out, to the
//! other). Caps are what is still missing then:
//! polygons with holes whose rim is made of the edges left without a partner in the plane, the same points on both
//! sides. Where the mesh was open before, it stays open.

mod caps;
mod chain;
mod contour;
mod crossing;
mod general;
mod nest;
mod part;
mod pieces;
mod rim;
mod simple;

use std::cell::RefCell;
use std::sync::Arc;

use glam::DVec3;

use crate::mesh::{Mesh, unit};
use crate::scope::Axis;

use caps::Caps;
use crossing::Crossings;
use general::General;
use part::{Part, Place};
use rim::{Rim, Side};
use simple::Simple;

/// What a cut makes of a mesh.
#[derive(Clone, Debug, Default)]
pub struct Slabs {
    /// One more than there are planes, from low to high; nothing where there is no face.
    pub parts: Vec<Option<Arc<Mesh>>>,
    /// What could not be closed, because the mesh is open there.
    pub open: Vec<OpenChain>,
}

/// A run of edges in a cut plane that does not close.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenChain {
    /// Which plane.
    pub plane: usize,
    /// Its points, one more than it has edges.
    pub points: Vec<DVec3>,
}

/// Cuts a mesh by the planes where its coordinate along `axis` equals an offset; offsets rise strictly.
///
/// A slab that holds all of the mesh gets the same mesh, not a copy. Offsets that do not rise or are not numbers cut
/// nothing: the slab below them stays empty.
///
/// ```
/// use std::sync::Arc;
/// use cga_runtime::{cut, mesh::primitive, scope::Axis};
///
/// let cube = Arc::new(primitive::cube());
/// let slabs = cut::slabs(&cube, Axis::X, &[0.25, 2.0]);
/// let volumes: Vec<f64> = slabs.parts.iter().flatten().map(|part| part.volume()).collect();
/// assert_eq!(volumes, [0.25, 0.75]);
/// assert!(slabs.parts.iter().flatten().all(|part| part.is_closed()));
/// assert!(slabs.parts[2].is_none() && slabs.open.is_empty());
/// ```
pub fn slabs(mesh: &Arc<Mesh>, axis: Axis, offsets: &[f64]) -> Slabs {
    thread_local! {
        static CUTTER: RefCell<Cutter> = RefCell::default();
    }
    CUTTER.with(|cutter| match cutter.try_borrow_mut() {
        Ok(mut cutter) => cutter.slabs(mesh, axis, offsets),
        Err(_) => Cutter::default().slabs(mesh, axis, offsets),
    })
}

/// Buffers kept from one cut to the next.
#[derive(Default)]
pub(crate) struct Cutter {
    state: State,
    simple: Simple,
    general: General,
    caps: Caps,
}

/// What all steps of a cut share.
#[derive(Default)]
struct State {
    axis: usize,
    /// The planes that reach the mesh.
    offsets: Vec<f64>,
    /// Where each point is: those of the mesh, then crossings.
    places: Vec<Place>,
    crossings: Crossings,
    parts: Vec<Part>,
    rim: Rim,
    /// Whether the mesh encloses its volume inside out, once it matters.
    inverted: Option<bool>,
}

impl Cutter {
    pub(crate) fn slabs(&mut self, mesh: &Arc<Mesh>, axis: Axis, offsets: &[f64]) -> Slabs {
        let mut slabs = Slabs { parts: vec![None; offsets.len() + 1], open: Vec::new() };
        if mesh.is_empty() {
            return slabs;
        }
        // Planes out of order would be met twice: each counts only when it is above all before it.
        let rising = offsets.windows(2).all(|w| w[0] < w[1]) && offsets.iter().all(|o| !o.is_nan());
        let kept: Vec<usize>;
        let sorted: Vec<f64>;
        let (planes, slab_of): (&[f64], Option<&[usize]>) = if rising {
            (offsets, None)
        } else {
            let mut top = f64::NEG_INFINITY;
            kept = (0..offsets.len())
                .filter(|&i| {
                    let above = top < offsets[i];
                    top = if above { offsets[i] } else { top };
                    above
                })
                .collect();
            sorted = kept.iter().map(|&i| offsets[i]).collect();
            (&sorted, Some(&kept))
        };
        let bounds = mesh.bounds();
        let (low, high) = (bounds.low[axis.index()], bounds.high[axis.index()]);
        let first = planes.partition_point(|&o| o < low);
        let end = planes.partition_point(|&o| o <= high).max(first);
        // Slab number among all, of a slab among the planes that count: the last one that is not pressed flat.
        let number = |slab: usize| match slab_of {
            None => slab,
            Some(kept) => kept.get(slab).copied().unwrap_or(offsets.len()),
        };
        if first == end {
            slabs.parts[number(first)] = Some(mesh.clone());
            return slabs;
        }
        self.state.axis = axis.index();
        self.state.offsets.clear();
        self.state.offsets.extend_from_slice(&planes[first..end]);
        self.cut(mesh, &mut slabs.open);
        for chain in &mut slabs.open {
            chain.plane = number(chain.plane + first);
        }
        let closed = mesh.derived.closed.get() == Some(&true) && slabs.open.is_empty();
        for (slab, part) in self.state.parts.drain(..).enumerate() {
            slabs.parts[number(slab + first)] = part.finish(mesh, closed);
        }
        slabs
    }

    fn cut(&mut self, mesh: &Mesh, open: &mut Vec<OpenChain>) {
        self.state.start(mesh);
        let (mut first_loop, mut start) = (0, 0);
        for (face, &end_loop) in mesh.face_ends.iter().enumerate() {
            let loops = first_loop..end_loop as usize;
            first_loop = loops.end;
            let corners = start..mesh.loop_ends[loops.end - 1] as usize;
            start = corners.end;
            let (mut low, mut high) = (u32::MAX, 0);
            for &point in &mesh.corners[corners.clone()] {
                let class = self.state.places[point as usize].class;
                low = low.min(class);
                high = high.max(class);
            }
            // The lowest and highest slab it has a part in; the other way round when it lies in a plane.
            let (bottom, top) = (low.div_ceil(2), high / 2);
            if bottom == top {
                self.state.keep(mesh, face, top, low | high);
            } else if top < bottom {
                self.state.keep_flat(mesh, face, top);
            } else if loops.len() > 1 || !self.simple.clip(&mut self.state, mesh, face, corners, low, high) {
                self.general.clip(&mut self.state, mesh, face);
            }
        }
        self.caps.close(&mut self.state, mesh, open);
    }
}

impl State {
    /// Classifies every point: 2s strictly inside slab s, 2j + 1 on plane j. Points inside a slab get their number there.
    fn start(&mut self, mesh: &Mesh) {
        let planes = &self.offsets;
        let axis = self.axis;
        self.places.clear();
        self.places.reserve(mesh.points.len());
        let classify = |x: f64| -> u32 {
            let below = planes.partition_point(|&o| o < x) as u32;
            2 * below + u32::from(planes.get(below as usize) == Some(&x))
        };
        if let [plane] = planes[..] {
            let class = |x: f64| 2 * u32::from(plane < x) + u32::from(plane == x);
            self.places.extend(mesh.points.iter().map(|p| Place::new(class(p[axis]))));
        } else {
            self.places.extend(mesh.points.iter().map(|p| Place::new(classify(p[axis]))));
        }
        let slabs = planes.len() + 1;
        let mut counts = vec![0usize; slabs];
        self.places.iter().for_each(|place| counts[place.class as usize / 2] += 1);
        self.parts.clear();
        self.parts.extend(counts.into_iter().map(|count| Part::new(mesh, count)));
        for (place, &p) in self.places.iter_mut().zip(&mesh.points) {
            if place.class & 1 == 0 {
                let points = &mut self.parts[place.class as usize / 2].mesh.points;
                place.low = points.len() as u32;
                points.push(p);
            }
        }
        self.inverted = None;
        self.crossings.reset(mesh.points.len());
        self.rim.reset();
    }

    /// A face that is all in one slab. `classes` is odd when it touches a plane.
    fn keep(&mut self, mesh: &Mesh, face: usize, slab: u32, classes: u32) {
        let State { parts, places, crossings, .. } = self;
        let part = &mut parts[slab as usize];
        part.whole += 1;
        let loops = mesh.face_loops(face);
        let corners = mesh.loop_range(loops.start).start..mesh.loop_range(loops.end - 1).end;
        let shift = part.mesh.corners.len() as u32;
        let base = corners.start as u32;
        let points = &mesh.corners[corners.clone()];
        if classes & 1 == 0 {
            part.mesh.corners.extend(points.iter().map(|&point| places[point as usize].low));
        } else {
            for &point in points {
                let number = part.number(places, mesh, crossings, point, slab);
                part.mesh.corners.push(number);
            }
        }
        part.mesh.loop_ends.extend(mesh.loop_ends[loops].iter().map(|end| end - base + shift));
        part.mesh.face_ends.push(part.mesh.loop_ends.len() as u32);
        part.mesh.tags.push(mesh.tags[face]);
        if !mesh.uvs.is_empty() {
            part.mesh.uvs.extend_from_slice(&mesh.uvs[corners.clone()]);
        }
        if !mesh.normals.is_empty() {
            part.mesh.normals.extend_from_slice(&mesh.normals[corners]);
        }
        if classes & 1 != 0 {
            for ring in mesh.face(face).loops() {
                let mut last = ring[ring.len() - 1];
                for &here in ring {
                    let class = self.places[here as usize].class;
                    if class & 1 == 1 && class == self.places[last as usize].class {
                        self.rim.edge(class / 2, last, here, Side::of(slab, class / 2));
                    }
                    last = here;
                }
            }
        }
    }

    /// A face in a plane goes to the side that its normal points away from, which it closes; of a mesh that is inside out
    /// to the other.
    fn keep_flat(&mut self, mesh: &Mesh, face: usize, plane: u32) {
        let inverted = *self.inverted.get_or_insert_with(|| mesh.is_closed() && mesh.volume() < 0.0);
        let up = unit(mesh.face(face).area_vector())[self.axis];
        let above = if inverted { up > 0.0 } else { up < 0.0 };
        self.keep(mesh, face, plane + u32::from(above), 1);
    }
}
