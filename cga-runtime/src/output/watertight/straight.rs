//! Corners of faces that are inside of a straight side.

use glam::DVec3;

use crate::geometry::mesh::{FaceRef, Mesh};

/// The straight corners of a face.
#[derive(Default)]
pub(super) struct StraightCorners {
    /// For each corner of the face, true if it is straight. Empty if none is.
    marks: Vec<bool>,
}

impl StraightCorners {
    /// Finds the corners of a face that are at most `near` from the line between the corners around them. `places` has the points of the
    /// mesh in the world. Returns true if there are some.
    pub(super) fn find(&mut self, face: &FaceRef<'_>, places: &[DVec3], near: f64) -> bool {
        self.marks.clear();
        if face.corner_count() == 3 || face.is_bent() {
            return false;
        }
        let range = face.corner_range();
        self.marks.resize(range.len(), false);
        for (ring, corners) in face.loop_ranges().zip(face.loops()) {
            let marks = &mut self.marks[ring.start - range.start..ring.end - range.start];
            mark(marks, |at| places[corners[at] as usize], near);
        }
        let is_reduced = self.marks.contains(&true);
        if !is_reduced {
            self.marks.clear();
        }
        is_reduced
    }

    /// Notes a face without straight corners.
    pub(super) fn has_none(&mut self) -> bool {
        self.marks.clear();
        false
    }

    /// Returns true if a corner of the face is straight.
    pub(super) fn has(&self, corner: usize) -> bool {
        self.marks.get(corner).copied().unwrap_or_default()
    }

    /// Returns true if a face of the mesh has straight corners.
    pub(super) fn are_in(&mut self, mesh: &Mesh, places: &[DVec3], near: f64) -> bool {
        mesh.faces().any(|face| self.find(&face, places, near))
    }
}

/// Marks the straight corners of a loop, unless fewer than three others would remain.
fn mark(marks: &mut [bool], place: impl Fn(usize) -> DVec3, near: f64) {
    let count = marks.len();
    // The first corner in the order of coordinates is not straight.
    let order = |a: &usize, b: &usize| {
        let [a, b] = [*a, *b].map(|at| place(at).to_array());
        a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]))
    };
    let Some(start) = (0..count).min_by(order) else { return };
    let (mut before, mut kept) = (start, 1);
    for step in 1..count {
        let [at, next] = [start + step, start + step + 1].map(|at| at % count);
        let (offset, side) = (place(at) - place(before), place(next) - place(before));
        let length = side.length();
        let along = offset.dot(side) / length;
        let is_between = 0.0 < along && along < length;
        if is_between && (offset - side * (along / length)).length() <= near {
            marks[at] = true;
        } else {
            (before, kept) = (at, kept + 1);
        }
    }
    if kept < 3 {
        marks.fill(false);
    }
}
