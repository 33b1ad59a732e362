//! Checks of the invariants of a mesh. In debug builds everything that makes a mesh checks its structure.

use std::collections::BTreeSet;
use std::fmt;

use glam::DVec3;

use super::Mesh;
use crate::exact::winding;
use crate::tol::PLANAR_EPSILON;
use crate::triangulate::PlaneProjection;

/// A violated invariant of [`Mesh`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Flaw {
    /// The ends of loops or faces do not increase, or do not cover the corners.
    Layout,
    /// The index of a corner's point is out of range.
    OutOfRange {
        /// The number of the corner.
        corner: usize,
    },
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// The number of the point.
        point: usize,
    },
    /// A loop has fewer than three corners.
    ShortLoop {
        /// The number of the face.
        face: usize,
    },
    /// A corner equals its predecessor.
    Repeated {
        /// The number of the face.
        face: usize,
    },
    /// A point is not used by any face.
    Unused {
        /// The number of the point.
        point: usize,
    },
    /// A corner is off the plane of its face by more than a rounding error, in a mesh that has no bent faces.
    NotPlanar {
        /// The number of the face.
        face: usize,
        /// The distance from the plane.
        by: f64,
    },
    /// A hole has the same winding as the outline, or a corner outside the outline.
    Hole {
        /// The number of the face.
        face: usize,
        /// The number of the loop; 1 is the first hole.
        ring: usize,
    },
    /// The mesh is cached as closed but is not, or the reverse.
    Pairing,
    /// An edge or a vertex has tags, but does not exist.
    Tags,
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Flaw::Layout => write!(f, "loops and faces do not cover the corners"),
            Flaw::OutOfRange { corner } => write!(f, "corner {corner} uses a point that does not exist"),
            Flaw::NotFinite { point } => write!(f, "point {point} is not finite"),
            Flaw::ShortLoop { face } => write!(f, "face {face} has a loop of fewer than three corners"),
            Flaw::Repeated { face } => write!(f, "face {face} repeats a corner"),
            Flaw::Unused { point } => write!(f, "point {point} is not used"),
            Flaw::NotPlanar { face, by } => write!(f, "face {face} is not planar by {by:e}"),
            Flaw::Hole { face, ring } => write!(f, "loop {ring} of face {face} is not a hole in its outline"),
            Flaw::Pairing => write!(f, "edges are not paired as claimed"),
            Flaw::Tags => write!(f, "an edge or a vertex that does not exist has tags"),
        }
    }
}

impl Mesh {
    /// All violated invariants; an empty list for a valid mesh. An open mesh is valid.
    pub fn check(&self) -> Vec<Flaw> {
        let mut flaws = self.structural_flaws();
        if flaws.iter().any(|flaw| matches!(flaw, Flaw::Layout | Flaw::OutOfRange { .. })) {
            return flaws;
        }
        let points = self.points.len();
        flaws.extend((0..points).filter(|&p| !self.points[p].is_finite()).map(|point| Flaw::NotFinite { point }));
        let mut used = vec![false; points];
        self.corners.iter().for_each(|&c| used[c as usize] = true);
        flaws.extend((0..points).filter(|&p| !used[p]).map(|point| Flaw::Unused { point }));
        (0..self.face_count()).for_each(|face| self.check_face(face, &mut flaws));
        if self.derived.closed.get().is_some_and(|&closed| self.count_closed().is_some_and(|counted| counted != closed))
        {
            flaws.push(Flaw::Pairing);
        }
        flaws
    }

    /// In debug builds, panics if the structure of the mesh is wrong, whatever its points are.
    #[inline]
    pub(crate) fn check_structure(&self) {
        debug_assert_eq!(self.structural_flaws(), []);
    }

    /// The same mesh, whose structure is checked in debug builds.
    #[inline]
    pub(crate) fn checked(self) -> Mesh {
        self.check_structure();
        self
    }

    fn structural_flaws(&self) -> Vec<Flaw> {
        if !self.layout_holds() {
            return vec![Flaw::Layout];
        }
        let points = self.points.len();
        let out_of_range = (0..self.corners.len()).filter(|&corner| self.corners[corner] as usize >= points);
        let mut flaws: Vec<Flaw> = out_of_range.map(|corner| Flaw::OutOfRange { corner }).collect();
        if !flaws.is_empty() {
            return flaws;
        }
        for face in self.faces() {
            for ring in face.loops() {
                if ring.len() < 3 {
                    flaws.push(Flaw::ShortLoop { face: face.index() });
                }
                if (0..ring.len()).any(|i| ring[i] == ring[(i + 1) % ring.len()]) {
                    flaws.push(Flaw::Repeated { face: face.index() });
                }
            }
        }
        if !self.tags_hold() {
            flaws.push(Flaw::Tags);
        }
        flaws
    }

    fn layout_holds(&self) -> bool {
        let rises = |ends: &[u32], total: usize| {
            ends.iter().try_fold(0, |last, &end| (last < end).then_some(end)) == Some(total as u32)
        };
        let corners = self.corners.len();
        rises(&self.loop_ends, corners)
            && self.face_ends.cover(self.loop_ends.len())
            && self.tags.len() == self.face_ends.len()
            && self.uvs.fit(corners)
            && [0, corners].contains(&self.normals.len())
    }

    /// Returns true if only edges and vertices of faces have tags.
    fn tags_hold(&self) -> bool {
        let tags = &self.subcomponent_tags;
        let edges: BTreeSet<[u32; 2]> = match tags.edges().len() {
            0 => BTreeSet::new(),
            _ => self.face_edges().map(|[a, b]| [a.min(b), a.max(b)]).collect(),
        };
        tags.hold(self.points.len()) && tags.edges().all(|(ends, _)| edges.contains(&ends))
    }

    fn check_face(&self, index: usize, flaws: &mut Vec<Flaw>) {
        let face = self.face(index);
        let normal = face.normal();
        if normal == DVec3::ZERO {
            return;
        }
        let at = |c: u32| self.points[c as usize];
        let from = at(face.outer()[0]);
        let corners = &self.corners[face.corner_range()];
        let extent = corners.iter().fold(0.0f64, |m, &c| m.max((at(c) - from).abs().max_element()));
        let size = corners.iter().fold(extent, |m, &c| m.max(at(c).abs().max_element()));
        let by = corners.iter().fold(0.0f64, |m, &c| m.max((at(c) - from).dot(normal).abs()));
        // The normal of a thin face is inaccurate, so the tolerance grows with thinness.
        let thin = extent * extent / face.area().max(f64::MIN_POSITIVE);
        if self.bent == DVec3::ZERO && by > PLANAR_EPSILON * extent + 64.0 * f64::EPSILON * size * thin.max(1.0) {
            flaws.push(Flaw::NotPlanar { face: index, by });
        }
        let flat = PlaneProjection::along(normal);
        let outer: Vec<_> = face.outer().iter().map(|&c| flat.apply(at(c))).collect();
        for (ring, hole) in face.holes().enumerate() {
            let hole: Vec<_> = hole.iter().map(|&c| flat.apply(at(c))).collect();
            let area: f64 = hole.windows(2).map(|w| (w[0] - hole[0]).perp_dot(w[1] - hole[0])).sum();
            if area > 0.0 || hole.iter().any(|&p| winding(&outer, p) == Some(0)) {
                flaws.push(Flaw::Hole { face: index, ring: ring + 1 });
            }
        }
    }
}
