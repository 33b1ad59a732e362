//! The triangles of faces.

use glam::DVec3;

use super::{FaceRef, Mesh};
use crate::bounds::Bounds;
use crate::each::Each;
use crate::tol::GRID_EPSILON;
use crate::triangulate::{Triangulator, is_surely_convex};

impl Triangulator {
    /// Appends the triangles of a face as indices into [`Mesh::corners`], and so into its texture coordinates and
    /// normals.
    ///
    /// The caps on both sides of a cut have the same triangles, reversed.
    ///
    /// # Panics
    /// Panics if the face does not exist.
    pub fn face(&mut self, mesh: &Mesh, face: usize, out: &mut Vec<[u32; 3]>) {
        let face = mesh.face(face);
        let place = |corner| face.position(corner);
        if !self.simple_face(&face, place, out) {
            self.other_face(&face, face.normal(), place, out);
        }
    }

    /// The same for a mesh whose points are at other places, if the triangles follow from the order of the corners: triangles, and convex
    /// quadrilaterals. Returns false for other faces.
    ///
    /// # Panics
    /// Panics if the face does not exist, or if one of its points has no place.
    pub fn simple_face_at(&mut self, mesh: &Mesh, face: usize, places: &[DVec3], out: &mut Vec<[u32; 3]>) -> bool {
        let face = mesh.face(face);
        !face.is_bent() && self.simple_face(&face, |corner| places[mesh.corners[corner] as usize], out)
    }

    /// The same for operations whose results depend on the triangles. Rounding errors do not change the triangles where corners are
    /// on a line, at the same height, or on the edge between two others: positions are first rounded to a grid.
    pub(crate) fn steady_face(&mut self, mesh: &Mesh, face: usize, out: &mut Vec<[u32; 3]>) {
        let face = mesh.face(face);
        if self.simple_face(&face, |corner| face.position(corner), out) {
            return;
        }
        let Some(cells) = cells_per_metre(&face) else { return self.face(mesh, face.index(), out) };
        let normal = (face.normal() / GRID_EPSILON).round();
        self.other_face(&face, normal, |corner| (face.position(corner) * cells).round() / cells, out);
    }

    /// Appends the triangles of a face whose triangles do not depend on rounding. Returns false for other faces.
    fn simple_face(&mut self, face: &FaceRef<'_>, place: impl Fn(usize) -> DVec3, out: &mut Vec<[u32; 3]>) -> bool {
        let range = face.corner_range();
        if range.len() == 3 {
            let start = range.start as u32;
            out.push([start, start + 1, start + 2]);
            return true;
        }
        if let Some(unbent) = face.unbent() {
            out.extend(unbent);
            return true;
        }
        if range.len() == 4 && !face.tag().cap && is_surely_convex([0, 1, 2, 3].each(|at| place(range.start + at))) {
            let [a, b, c, d] = [0, 1, 2, 3].each(|at| range.start as u32 + at);
            out.extend([[a, b, c], [a, c, d]]);
            return true;
        }
        false
    }

    fn other_face(
        &mut self,
        face: &FaceRef<'_>,
        normal: DVec3,
        place: impl Fn(usize) -> DVec3,
        out: &mut Vec<[u32; 3]>,
    ) {
        let from = out.len();
        let normal = (!face.tag().cap).then_some(normal);
        self.polygon_in_space(face.loop_ranges(), place, normal, out);
        if face.corner_count() > 4 {
            // If loops touch, triangles without area join corners that are the same point.
            let point = |c: u32| face.mesh.corners[c as usize];
            let mut kept = from;
            for i in from..out.len() {
                let [a, b, c] = out[i].each(point);
                if a != b && b != c && c != a {
                    out[kept] = out[i];
                    kept += 1;
                }
            }
            out.truncate(kept);
        }
    }
}

/// The number of grid cells per metre for a face, a power of two. `None` if the face is too small or too far from the origin.
fn cells_per_metre(face: &FaceRef<'_>) -> Option<f64> {
    // Simple sizes such as 2 are not where the number changes.
    const UNEVEN: f64 = 1.381_966;
    let bounds = Bounds::of(face.corner_range().map(|corner| face.position(corner)));
    let extent = bounds.size().max_element() * UNEVEN;
    let cells = Bounds { low: DVec3::ZERO, high: DVec3::splat(extent) }.scale_to_one() / GRID_EPSILON;
    let far = bounds.low.abs().max(bounds.high.abs()).max_element();
    (0.0 < cells && (far * cells).is_finite() && f64::MIN_POSITIVE <= 1.0 / cells).then_some(cells)
}

#[cfg(test)]
mod tests {
    use glam::Vec3Swizzles;

    use super::*;
    use crate::random::Rng;

    /// A wall with notches of two depths at its lower edge, as a pattern along the edge makes them.
    fn notched() -> Vec<DVec3> {
        let notch = |k: u32| {
            let x = f64::from(k) * 2.469_156_9;
            [(x, 0.0), (x + 1.749_748, 0.0), (x + 1.749_748, 0.133), (x + 2.469_156_9, 0.133)]
        };
        let end = 6.0 * 2.469_156_9;
        let outline = (0..6).flat_map(notch).chain([(end, 0.377), (0.0, 0.377)]);
        outline.map(|(x, y)| DVec3::new(x, y, 0.0)).collect()
    }

    #[test]
    fn rounding_does_not_change_the_triangles_of_a_steady_face() {
        // A triangle with corners on two of its edges, in a plane that is not upright.
        let [a, b, c] = [DVec3::new(0.313, 2.0, 0.7), DVec3::new(1.0, 0.0, 0.3), DVec3::new(-0.5, 1.0, -0.7)];
        let divided = vec![a, a.lerp(b, 0.613), b, c, c.lerp(a, 0.2717), c.lerp(a, 0.713)];
        let mut random = Rng(5);
        let mut differing = 0;
        for outline in [notched(), divided] {
            let mut triangles = |noise: f64| {
                let mut nudge = || DVec3::new(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5) * noise;
                let points: Vec<DVec3> = outline.iter().map(|&point| point + nudge()).collect();
                let mesh = Mesh::from_polygon(&points, &[]).unwrap();
                let (mut steady, mut other) = (Vec::new(), Vec::new());
                Triangulator::new().steady_face(&mesh, 0, &mut steady);
                Triangulator::new().face(&mesh, 0, &mut other);
                (steady, other)
            };
            let (steady, other) = triangles(0.0);
            assert_eq!(steady.len(), outline.len() - 2);
            for _ in 0..100 {
                let (found, rounded) = triangles(1e-15);
                assert_eq!(found, steady);
                differing += usize::from(rounded != other);
            }
        }
        assert!(100 < differing, "{differing}");
    }

    #[test]
    fn steady_faces_of_any_size_have_triangles() {
        for scale in [1e-300, 1e-150, 1e-7, 1.0, 1e150, 1e300] {
            for far in [0.0, 1e12, 1e200] {
                let points: Vec<DVec3> =
                    notched().iter().map(|&point| point * scale + DVec3::Z * (far * scale).min(1e305)).collect();
                let Ok(mesh) = Mesh::from_polygon(&points, &[]) else { continue };
                let mut triangles = Vec::new();
                Triangulator::new().steady_face(&mesh, 0, &mut triangles);
                assert_eq!(triangles.len(), 24, "{scale:e} {far:e}");
            }
        }
    }

    #[test]
    fn faces_with_their_points_at_other_places_have_the_same_triangles() {
        let mesh = crate::primitive::cube();
        let mut places: Vec<DVec3> = mesh.points().iter().map(|point| point.zxy() * 3.0).collect();
        let triangles = |places: &[DVec3]| {
            let (moved, mut own) = (mesh.with_points(places.to_vec()), Vec::new());
            (0..mesh.face_count()).for_each(|face| Triangulator::new().face(&moved, face, &mut own));
            own
        };
        let mut found = Vec::new();
        assert!((0..6).all(|face| Triangulator::new().simple_face_at(&mesh, face, &places, &mut found)));
        assert_eq!(found, triangles(&places));
        // A face with a straight corner is left to exact arithmetic.
        let outer = mesh.face(0).outer();
        places[outer[1] as usize] = (places[outer[0] as usize] + places[outer[2] as usize]) * 0.5;
        assert!(!Triangulator::new().simple_face_at(&mesh, 0, &places, &mut found) && found.len() == 12);
    }
}
