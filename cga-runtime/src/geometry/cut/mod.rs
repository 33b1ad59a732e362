//! Cutting a mesh into slabs across an axis, and closing what the cut opens.
//!
//! One pass for all planes. The side of a point is one comparison of its coordinate with the offset: exact, and nothing
//! moves. Where an edge meets a plane the point is made once, from the end that comes first in lexicographic order, with
//! the cut coordinate set to the offset itself; every face and both sides use that point. From there on everything is
//! decided by index: which pieces meet, which edges a side lacks a partner for, which loops those make.
//!
//! A face in a plane goes to the side its normal points away from, which it closes (of a mesh that is inside out, to the
//! other). A closed piece without thickness in a plane, a sheet, goes to the side below as a whole (`caps/sheet_search.rs`). Caps
//! are what is still missing then: polygons with holes whose rim is made of the edges left without a partner in the plane, the same points on both
//! sides. Where the mesh was open before, it stays open.

mod caps;
mod class;
mod crossings;
mod edges;
mod faces;
mod iso;
mod plane;
mod points;
mod segment;
mod slab;
mod state;

use std::cell::RefCell;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use crate::geometry::Axis;
use crate::geometry::mesh::Mesh;

pub use iso::iso_bands;
pub(crate) use plane::above;
pub use plane::{Plane, halves};

use caps::{Caps, sheet_search};
use class::Span;
use faces::general::General;
use faces::near_coplanar::Rough;
use faces::simple::Simple;
use faces::triangle;
use points::Place;
use state::State;

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
/// A face in a plane goes to the slab that it closes. A sheet, a closed piece without thickness, goes to the slab below its
/// plane as a whole; a plane that the mesh only touches has all of the mesh on one side, sheets included.
///
/// A slab that holds all of the mesh gets the same mesh, not a copy; so does one whose planes the mesh only touches. Offsets
/// that do not rise or are not numbers cut nothing: the slab below them stays empty.
///
/// Faces of a part come in the order of the mesh, caps after them, low plane first; but a part that has nothing of the
/// mesh's first face begins with the cap towards it (*CGA changelog 2025.1*). What corners carry is interpolated, tags stay.
/// Caps ([`FaceTag::cap`](crate::geometry::mesh::FaceTag::cap)) are of no group and no material of the mesh, so that they look as the
/// shape's own material says; their texture coordinates are lengths of the mesh in the plane, in all sets that the mesh has.
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
    Cutter::with(|cutter| cutter.slabs(mesh, axis, offsets))
}

/// The same of a mesh that is stretched: its point `low` is the origin of texture coordinates of caps, and `stretch` leads to metres.
pub(crate) fn stretched_slabs(mesh: &Arc<Mesh>, axis: Axis, offsets: &[f64], low: DVec3, stretch: DVec3) -> Slabs {
    Cutter::with(|cutter| {
        cutter.caps.in_metres(low, stretch);
        let slabs = cutter.slabs(mesh, axis, offsets);
        cutter.caps.in_metres(DVec3::ZERO, DVec3::ONE);
        slabs
    })
}

/// Buffers kept from one cut to the next.
#[derive(Default)]
pub(crate) struct Cutter {
    state: State,
    simple: Simple,
    general: General,
    rough: Rough,
    caps: Caps,
    /// Places of a block of corners.
    block: Vec<Place>,
}

/// How many corners are looked up at a time. The look-ups of a block do not wait for each other.
const BLOCK: usize = 512;

impl Cutter {
    /// With the buffers of this thread.
    fn with<T>(work: impl FnOnce(&mut Cutter) -> T) -> T {
        thread_local! {
            static CUTTER: RefCell<Cutter> = RefCell::default();
        }
        CUTTER.with(|cutter| match cutter.try_borrow_mut() {
            Ok(mut cutter) => {
                let made = work(&mut cutter);
                if cutter.state.is_large() {
                    *cutter = Cutter::default();
                }
                made
            }
            Err(_) => work(&mut Cutter::default()),
        })
    }

    pub(crate) fn slabs(&mut self, mesh: &Arc<Mesh>, axis: Axis, offsets: &[f64]) -> Slabs {
        let mut slabs = Slabs { parts: vec![None; offsets.len() + 1], open: Vec::new() };
        if mesh.is_empty() {
            return slabs;
        }
        let all_rise = offsets.windows(2).all(|w| w[0] < w[1]) && offsets.iter().all(|o| !o.is_nan());
        let kept: Vec<usize>;
        let sorted: Vec<f64>;
        let (planes, slab_of): (&[f64], Option<&[usize]>) = if all_rise {
            (offsets, None)
        } else {
            kept = rising(offsets);
            sorted = kept.iter().map(|&i| offsets[i]).collect();
            (&sorted, Some(&kept))
        };
        let bounds = mesh.bounds();
        let (low, high) = (bounds.low[axis.index()], bounds.high[axis.index()]);
        // A plane that the mesh only touches has all of it on one side, whichever way faces in it look. So has one in which
        // lies all of a mesh whose faces are back to back: it is below.
        let flat = low == high;
        let first = planes.partition_point(|&o| o < low || (o == low && !flat));
        let apart = flat && !mesh.is_closed();
        let end = planes.partition_point(|&o| o < high || (o == high && apart)).max(first);
        // Slab number among all, of a slab among the planes that count: the last one that is not pressed flat.
        let number = |slab: usize| match slab_of {
            None => slab,
            Some(kept) => kept.get(slab).copied().unwrap_or(offsets.len()),
        };
        if first == end {
            slabs.parts[number(first)] = Some(mesh.clone());
            return slabs;
        }
        self.state.points.axis = axis.index();
        self.state.points.planes.clear();
        // No plane is at -0: its points would be.
        self.state.points.planes.extend(planes[first..end].iter().map(|&at| at + 0.0));
        self.cut_faces(mesh);
        self.caps.close(&mut self.state, mesh, |points, plane, chain| {
            let lift = |point| points.lift(plane as u32, point);
            let points = chain.into_iter().map(lift).collect();
            slabs.open.push(OpenChain { plane: number(plane + first), points });
        });
        let closed = mesh.derived.closed.get() == Some(&true) && slabs.open.is_empty();
        for (slab, part) in self.state.parts.drain(..).enumerate() {
            slabs.parts[number(slab + first)] = part.finish(mesh, closed);
        }
        slabs
    }

    /// Hands every face, or its pieces, to the slabs; again when sheets were torn apart.
    fn cut_faces(&mut self, mesh: &Mesh) {
        self.state.inverted = None;
        self.state.sheets.clear();
        self.cut_faces_once(mesh);
        if sheet_search::find(&mut self.state, mesh) {
            self.cut_faces_once(mesh);
        }
    }

    /// Reads the places of a block of corners that begins with those of a face; gives where it ends.
    #[inline(never)]
    fn read_block(&mut self, mesh: &Mesh, first_loop: usize, corners: Range<usize>) -> usize {
        let end = corners.end.max(corners.start + BLOCK).min(mesh.corners.len());
        let places = &self.state.points.places;
        self.block.clear();
        self.block.extend(mesh.corners[corners.start..end].iter().map(|&point| places[point as usize]));
        if self.state.reads_ahead {
            self.state.points.read_ahead(mesh, first_loop, end);
        }
        end
    }

    fn cut_faces_once(&mut self, mesh: &Mesh) {
        self.state.start(mesh);
        self.rough.start(mesh);
        let (mut start, mut block_start, mut block_end) = (0, 0, 0);
        let runs = mesh.tags.runs().iter().scan(0, |from, &(end, tag)| Some((std::mem::replace(from, end)..end, tag)));
        for (face, tag) in runs.flat_map(|(faces, tag)| faces.map(move |face| (face as usize, tag))) {
            let loops = mesh.face_loops(face);
            let corners = start..mesh.loop_ends[loops.end - 1] as usize;
            start = corners.end;
            if block_end < corners.end {
                (block_start, block_end) = (corners.start, self.read_block(mesh, loops.start, corners.clone()));
            }
            let places = &self.block[corners.start - block_start..corners.end - block_start];
            if let [p, q, r] = *places {
                // By far the most faces of large meshes are triangles inside one slab.
                if p.class == q.class && q.class == r.class && !p.class.is_on_plane() {
                    let part = &mut self.state.parts[p.class.slab() as usize];
                    part.keep_triangle(mesh, tag, corners, [p.number, q.number, r.number]);
                    continue;
                }
            }
            let span = Span::of(places.iter().map(|place| place.class));
            let (bottom, top) = (span.bottom(), span.top());
            if let [p, q, r] = *places
                && !(p.class.is_on_plane() | q.class.is_on_plane() | r.class.is_on_plane())
                && top == bottom + 1
            {
                let lone = if q.class == r.class { 0 } else { 1 + usize::from(p.class == q.class) };
                triangle::clip(&mut self.state, mesh, tag, corners, [p, q, r], bottom, lone);
                continue;
            }
            if bottom == top {
                self.state.keep(mesh, face, tag, top, span.touches_plane());
            } else if span.is_flat() {
                self.state.keep_flat(mesh, face, tag, span.low.plane());
            } else if places.len() > 3
                && self.rough.may_be(mesh, corners.clone(), self.state.points.axis)
                && self.rough.clip(&mut self.state, mesh, face, tag)
            {
                continue;
            } else if loops.len() > 1 || !self.simple.clip(&mut self.state, mesh, tag, corners, places, span) {
                self.general.clip(&mut self.state, mesh, face, tag);
            }
        }
    }
}

/// Which offsets are above all before them: planes out of order would be met twice.
fn rising(offsets: &[f64]) -> Vec<usize> {
    let mut kept: Vec<usize> = Vec::new();
    for (index, &offset) in offsets.iter().enumerate() {
        let top = kept.last().map_or(f64::NEG_INFINITY, |&last| offsets[last]);
        if top < offset {
            kept.push(index);
        }
    }
    kept
}
