//! Faces that are across the axis except for rounding, with a plane within the rounding errors.
//!
//! The line where such a face meets the plane is noise, and so is the order of points on it: wrong pairs of points
//! would make pieces that cover some of the face several times. Triangles need no order, because each meets a plane in
//! one stretch. So the face is cut triangle by triangle. The edges between triangles are crossed like all others, so
//! closed parts stay closed, and together the pieces cover the face whatever the heights of its corners.
//!
//! Bent faces are cut in the same way, because they are the triangles.

use std::ops::Range;

use glam::DVec2;

use super::pieces::Rings;
use crate::cut::caps::rim::PlaneSide;
use crate::cut::class::ClassRange;
use crate::cut::points::PieceCorner;
use crate::cut::state::CutState;
use crate::each::Each;
use crate::mesh::{Bounds, FaceRef, FaceTag, Mesh};
use crate::small_sort::SmallSort;
use crate::tol::{ACROSS_EPSILON, LINE_EPSILON};
use crate::triangulate::{PlaneProjection, Triangulator};

/// Buffers.
#[derive(Default)]
pub(crate) struct Rough {
    /// The rise above which a face is not across the axis.
    steep: f64,
    triangulator: Triangulator,
    triangles: Vec<[u32; 3]>,
    /// The rim of a triangle, with crossings.
    nodes: Vec<PieceCorner>,
    rings: Rings,
}

impl Rough {
    /// Prepares for a mesh. Call it before the mesh is cut.
    pub(crate) fn start(&mut self, mesh: &Mesh) {
        self.steep = ACROSS_EPSILON * mesh.bounds().size().max_element();
    }

    /// Returns true if a face may be of this kind, by its corners.
    #[inline]
    pub(crate) fn may_be(&self, mesh: &Mesh, corners: Range<usize>, axis: usize) -> bool {
        let mut heights = mesh.corners[corners].iter().map(|&point| mesh.points[point as usize][axis]);
        let first = heights.next().unwrap_or(0.0);
        // For nearly all faces the second or third corner decides.
        heights.all(|height| (height - first).abs() <= self.steep)
    }

    /// Cuts a face into its slabs. Returns `false`, without any change, if the face is not of this kind.
    #[cold]
    pub(crate) fn clip(&mut self, state: &mut CutState, mesh: &Mesh, face: usize, tag: FaceTag) -> bool {
        let view = mesh.face(face);
        let is_rough = view.is_bent() || has_rough_line(&view, state.points.axis);
        if is_rough {
            self.clip_triangles(state, mesh, &view, tag);
        }
        is_rough
    }

    fn clip_triangles(&mut self, state: &mut CutState, mesh: &Mesh, face: &FaceRef<'_>, tag: FaceTag) {
        let outline = face.loop_ranges().next().unwrap_or(0..0);
        self.triangles.clear();
        self.triangulator.face(mesh, face.index(), &mut self.triangles);
        // The first piece has the first edge.
        let first = [outline.start as u32, outline.start as u32 + 1];
        let with_first = |triangle: &[u32; 3]| first.iter().all(|corner| triangle.contains(corner));
        if let Some(at) = self.triangles.iter().position(with_first) {
            self.triangles[..=at].rotate_right(1);
        }
        self.rings.start(PlaneProjection::along(face.normal()), tag, outline);
        for at in 0..self.triangles.len() {
            self.clip_triangle(state, mesh, self.triangles[at].each(|corner| corner as usize));
        }
        self.mark_unused(state, mesh, face);
    }

    /// Marks parts with unused points. A face that turns back on itself has corners outside all triangles, whose points
    /// may be unused.
    fn mark_unused(&self, state: &mut CutState, mesh: &Mesh, face: &FaceRef<'_>) {
        let mut used: Vec<u32> = self.triangles.iter().flatten().map(|&corner| mesh.corners[corner as usize]).collect();
        used.small_sort();
        for point in &mesh.corners[face.corner_range()] {
            let place = state.points.places[*point as usize];
            if !place.class.is_on_plane() && used.binary_search(point).is_err() {
                state.parts[place.class.slab() as usize].dropped = true;
            }
        }
    }

    fn clip_triangle(&mut self, state: &mut CutState, mesh: &Mesh, corners: [usize; 3]) {
        let places = corners.each(|corner| state.points.places[mesh.corners[corner] as usize]);
        self.nodes.clear();
        for (at, next) in [(0, 1), (1, 2), (2, 0)] {
            let [from, to] = [at, next].each(|i| PieceCorner::corner(corners[i], places[i]));
            self.nodes.push(from);
            state.points.cross(&mut state.parts, mesh, from, to, &mut self.nodes);
        }
        let span = ClassRange::of(places.iter().map(|place| place.class));
        let slabs = if span.is_flat() {
            let plane = span.low.plane();
            let slab = plane + u32::from(state.is_triangle_above(mesh, places, plane));
            slab..=slab
        } else {
            span.slabs()
        };
        for slab in slabs {
            let inside = self.nodes.iter().filter(|node| node.class().touches(slab));
            for (a, b) in inside.clone().zip(inside.clone().cycle().skip(1)) {
                if a.class().is_on_plane() && a.class() == b.class() {
                    let plane = a.class().plane();
                    state.rim.edge(plane, a.place.number, b.place.number, PlaneSide::of(slab, plane));
                }
            }
            self.rings.nodes.extend(inside);
            self.rings.end_ring();
            self.rings.emit(state, mesh, slab);
        }
    }
}

/// Returns true if a face is across an axis and its line with a plane is lost in rounding: because its corners are not
/// exactly in its plane, or because of the rounding of coordinates of this size.
fn has_rough_line(face: &FaceRef<'_>, axis: usize) -> bool {
    let corners = || face.corner_range().map(|corner| face.position(corner));
    let bounds = Bounds::of(corners());
    let width = bounds.size().max_element();
    if ACROSS_EPSILON * width < bounds.size()[axis] {
        return false;
    }
    let normal = face.normal();
    let sine = DVec2::new(normal[(axis + 1) % 3], normal[(axis + 2) % 3]).length();
    let from = face.position(face.corner_range().start);
    let off = corners().fold(0.0, |off: f64, corner| off.max((corner - from).dot(normal).abs()));
    let reach = bounds.low.abs().max(bounds.high.abs()).max_element();
    LINE_EPSILON * width * sine < off.max(f64::EPSILON * reach)
}
