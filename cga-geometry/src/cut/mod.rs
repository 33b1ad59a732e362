//! Cuts a mesh into slabs across an axis and closes the cuts with caps.
//!
//! One pass cuts at all planes. The side of a point is one comparison of its coordinate with the offset: exact, and no
//! point moves. The crossing of an edge with a plane is computed once, from the end that comes first in lexicographic
//! order, with the cut coordinate set to the offset itself. Every face and both sides use that point. All further
//! decisions use indices: which pieces meet, which edges of a side have no partner, and which loops these edges form.
//!
//! A face in a plane goes to the side that its normal points away from, because it closes that side (to the other side
//! in a mesh that is inside out). A closed piece without thickness in a plane, a sheet, goes to the side below as a
//! whole (`caps/sheet_search.rs`). Caps close the rest. A cap is a polygon with holes. Its rim consists of the edges in
//! the plane without a partner, with the same points on both sides. Where the mesh was open before, it stays open.

mod caps;
mod class;
mod crossings;
mod edges;
mod faces;
mod iso;
mod origins;
mod plane;
mod points;
mod segment;
mod slab;
mod snap;
mod state;

use std::cell::RefCell;
use std::ops::Range;
use std::sync::Arc;

use glam::DVec3;

use crate::Axis;
use crate::mesh::Mesh;
use crate::origin::PointOrigin;
use crate::work;

pub use iso::iso_bands;
pub use iso::traced_iso_bands;
pub use plane::above;
pub use plane::{Plane, halves};
pub use snap::snap;

use caps::{Caps, sheet_search};
use class::ClassRange;
use faces::chain::Chain;
use faces::general::General;
use faces::near_coplanar::Rough;
use faces::{simple, triangle};
use points::Location;
use state::CutState;

/// The result of a cut.
#[derive(Clone, Debug, Default)]
pub struct Slabs {
    /// The slabs from low to high, one more than there are planes; `None` for a slab without a face.
    pub parts: Vec<Option<Arc<Mesh>>>,
    /// The chains that could not be closed, because the mesh is open there.
    pub open: Vec<OpenChain>,
    /// The origins of the points of each part, if the mesh has a trace.
    pub points: Vec<Vec<PointOrigin>>,
}

/// A run of edges in a cut plane that does not close.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenChain {
    /// The number of the plane.
    pub plane: usize,
    /// Its points, one more than the number of its edges.
    pub points: Vec<DVec3>,
}

/// Cuts a mesh by the planes where its coordinate along `axis` equals an offset. Offsets must increase strictly.
///
/// A face in a plane goes to the slab that it closes. A sheet, a closed piece without thickness, goes to the slab below
/// its plane as a whole. If the mesh only touches a plane, all of it is on one side, sheets included.
///
/// A slab that contains the whole mesh gets the same mesh, not a copy, also if the mesh touches its planes. Offsets
/// that are NaN or do not increase cut nothing: the slab below them stays empty.
///
/// The faces of a part have the order of the mesh. Caps come after them, low plane first. A part without a piece of the
/// mesh's first face begins with the cap towards that face instead. The values of corners are
/// interpolated; tags stay. Caps ([`FaceTag::cap`](crate::mesh::FaceTag::cap)) have no group and no material
/// of the mesh. Their texture coordinates are (0, 0) in all
/// sets of the mesh.
///
/// ```
/// use std::sync::Arc;
/// use cga_geometry::{Axis, cut, primitive};
///
/// let cube = Arc::new(primitive::cube());
/// let slabs = cut::slabs(&cube, Axis::X, &[0.25, 2.0]);
/// let volumes: Vec<f64> = slabs.parts.iter().flatten().map(|part| part.volume()).collect();
/// assert_eq!(volumes, [0.25, 0.75]);
/// assert!(slabs.parts.iter().flatten().all(|part| part.is_closed()));
/// assert!(slabs.parts[2].is_none() && slabs.open.is_empty());
/// ```
///
/// Faces must be planar, or volumes of parts do not add up: see [`planar_faces`](crate::unbent::planar_faces). The parts have as many
/// points as the planes make; [`slabs_within`] has a limit.
pub fn slabs(mesh: &Arc<Mesh>, axis: Axis, offsets: &[f64]) -> Slabs {
    slabs_within(mesh, axis, offsets, usize::MAX).unwrap_or_default()
}

/// As [`slabs()`], with a limit on memory. `None`, before memory is taken for them, if the parts without caps would have more than
/// `most` corners. Cuts at few planes are not counted.
pub fn slabs_within(mesh: &Arc<Mesh>, axis: Axis, offsets: &[f64], most: usize) -> Option<Slabs> {
    Cutter::with(|cutter| {
        cutter.state.most_corners = most;
        let slabs = cutter.slabs(mesh, axis, offsets);
        (!std::mem::take(&mut cutter.state.is_too_large)).then_some(slabs)
    })
}

/// Buffers that are reused by the next cut.
#[derive(Default)]
pub(crate) struct Cutter {
    state: CutState,
    chain: Chain,
    general: General,
    rough: Rough,
    caps: Caps,
    /// The places of a block of corners.
    block: Vec<Location>,
}

/// The units of work of a corner, or of the crossing of an edge with a plane.
const CROSSING: usize = 4;

/// The planes that a face may cross without a count of its own: its corners are counted.
const FEW_PLANES: u32 = 2;

/// The number of corners whose places are read at once. The memory accesses of a block overlap.
const BLOCK: usize = 512;

impl Cutter {
    /// Runs `work` with the buffers of this thread.
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
        let mut slabs = Slabs { parts: vec![None; offsets.len() + 1], ..Slabs::default() };
        if mesh.is_empty() {
            return slabs;
        }
        let kept = rising(offsets);
        let bounds = mesh.bounds();
        let (low, high) = (bounds.low[axis.index()], bounds.high[axis.index()]);
        // If the mesh only touches a plane, all of it is on one side, whatever the normals of faces in the plane. The
        // same holds for a plane that contains a whole closed mesh, with faces back to back: the mesh is below.
        let flat = low == high;
        let first = kept.partition_point(|&at| offsets[at] < low || (offsets[at] == low && !flat));
        let apart = flat && !mesh.is_closed();
        let end = kept.partition_point(|&at| offsets[at] < high || (offsets[at] == high && apart)).max(first);
        // Maps a slab between the counted planes to its number among all slabs: the slab directly below its upper
        // plane.
        let number = |slab: usize| kept.get(slab).copied().unwrap_or(offsets.len());
        if first == end {
            slabs.parts[number(first)] = Some(mesh.clone());
            return slabs;
        }
        self.state.points.axis = axis.index();
        self.state.points.planes.clear();
        // Adds 0.0 because a plane at -0 would give points at -0.
        self.state.points.planes.extend(kept[first..end].iter().map(|&at| offsets[at] + 0.0));
        self.cut_faces(mesh);
        self.caps.close(&mut self.state, mesh, |points, plane, chain| {
            let lift = |point| points.lift(plane as u32, point);
            let points = chain.into_iter().map(lift).collect();
            slabs.open.push(OpenChain { plane: number(plane + first), points });
        });
        let closed = mesh.derived.closed.get() == Some(&true) && slabs.open.is_empty();
        let mut origins = self.state.needed_origins(mesh);
        if !mesh.trace.is_empty() {
            slabs.points = vec![Vec::new(); offsets.len() + 1];
        }
        for (slab, part) in self.state.parts.drain(..).enumerate() {
            let (slab, points) = (number(slab + first), origins.next().unwrap_or_default());
            slabs.parts[slab] = part.finish(mesh, closed, &points);
            if let Some(list) = slabs.points.get_mut(slab) {
                *list = points;
            }
        }
        slabs
    }

    /// Passes every face, or its pieces, to the slabs. Runs a second time if sheets were torn apart.
    fn cut_faces(&mut self, mesh: &Mesh) {
        self.state.inverted = None;
        self.state.sheets.clear();
        self.cut_faces_once(mesh);
        if sheet_search::find(&mut self.state, mesh) {
            self.cut_faces_once(mesh);
        }
    }

    /// Reads the places of a block of corners that begins with the corners of a face. Returns the end of the block.
    #[inline(never)]
    fn read_block(&mut self, mesh: &Mesh, corners: Range<usize>) -> usize {
        let end = corners.end.max(corners.start + BLOCK).min(mesh.corners.len());
        let places = &self.state.points.places;
        self.block.clear();
        self.block.extend(mesh.corners[corners.start..end].iter().map(|&point| places[point as usize]));
        end
    }

    fn cut_faces_once(&mut self, mesh: &Mesh) {
        if !self.state.start(mesh) {
            return;
        }
        self.rough.start(mesh);
        let (mut start, mut block_start, mut block_end) = (0, 0, 0);
        let runs = mesh.tags.runs().iter().scan(0, |from, &(end, tag)| Some((std::mem::replace(from, end)..end, tag)));
        for (face, tag) in runs.flat_map(|(faces, tag)| faces.map(move |face| (face as usize, tag))) {
            let loops = mesh.face_loops(face);
            let corners = start..mesh.loop_ends[loops.end - 1] as usize;
            start = corners.end;
            if block_end < corners.end {
                (block_start, block_end) = (corners.start, self.read_block(mesh, corners.clone()));
                // Most faces meet few planes; the others are counted below.
                if !work::spend(CROSSING * (block_end - block_start)) {
                    return;
                }
            }
            let places = &self.block[corners.start - block_start..corners.end - block_start];
            if let [p, q, r] = *places {
                // In large meshes nearly all faces are triangles inside one slab.
                if p.class == q.class && q.class == r.class && !p.class.is_on_plane() {
                    let part = &mut self.state.parts[p.class.slab() as usize];
                    part.keep_triangle(mesh, tag, corners, [p.number, q.number, r.number]);
                    continue;
                }
            }
            let span = ClassRange::of(places.iter().map(|place| place.class));
            let (bottom, top) = (span.bottom(), span.top());
            if let [p, q, r] = *places
                && !(p.class.is_on_plane() | q.class.is_on_plane() | r.class.is_on_plane())
                && top == bottom + 1
            {
                let lone = if q.class == r.class { 0 } else { 1 + usize::from(p.class == q.class) };
                triangle::clip(&mut self.state, mesh, tag, corners, [p, q, r], bottom, lone);
                continue;
            }
            if bottom + FEW_PLANES < top && !work::spend(CROSSING * (top - bottom) as usize) {
                return;
            }
            if bottom == top {
                self.state.keep(mesh, face, tag, top, span.touches_plane());
            } else if span.is_flat() {
                self.state.keep_flat(mesh, face, tag, span.low.plane());
            } else if places.len() > 3
                && (mesh.bent != DVec3::ZERO || self.rough.may_be(mesh, corners.clone(), self.state.points.axis))
                && self.rough.clip(&mut self.state, mesh, face, tag)
            {
                continue;
            } else if loops.len() > 1
                || !simple::clip(&mut self.chain, &mut self.state, mesh, tag, corners, places, span)
            {
                self.general.clip(&mut self.state, mesh, face, tag);
            }
        }
    }
}

/// The offsets that are greater than all offsets before them. Planes out of order would be met twice.
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
