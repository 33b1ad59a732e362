//! Extrudes faces to closed volumes.
//!
//! Each face gives sides in the order of its edges (outline, then holes), a top, and a bottom, which is the reversed
//! face itself. The first edge of a side is its bottom edge, in the direction of the face. No wall is made between
//! faces that move alike: coplanar neighbours along their normals, all neighbours in other modes. Points that do not
//! move give no wall either. A negative distance mirrors: the faces look inwards.
//!
//! A point of the top was moved from a point of the face: an upright edge has the tags of its vertex, and the edges and vertices of
//! the top have none.

use glam::DVec3;

use crate::average_normal::AverageNormal;
use crate::derive::{CornerValues, Derivation, FaceOrigin, PointOrigin};
use crate::disjoint::DisjointSets;
use crate::each::Each;
use crate::mesh::pair_table::PairTable;
use crate::mesh::{Bounds, FaceRef, Mesh, flip};
use crate::provenance::Extruded;
use crate::tol::{ANGLE_EPSILON, COPLANAR_EPSILON};
use crate::work;

/// The units of work of a corner whose edge is joined, and of one that grows.
const JOINING: usize = 8;
const GROWING: usize = 64;

/// The direction of an extrusion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extrude {
    /// Each face along its own normal.
    FaceNormal,
    /// Each point along the average of the normals around it, by the distance.
    VertexNormal,
    /// All points along one unit vector.
    Vector(DVec3),
    /// All points along one unit vector to the same height. The height is the distance from the lowest point, or from
    /// the highest point if the distance is negative, and at least reaches the other end.
    FlatTop(DVec3),
}

/// The volumes on the faces of a mesh, by a distance in metres. Faces without area, or thinner than rounding, have no normal
/// and are not extruded along it. A
/// distance or a vector that is not finite leaves the mesh unchanged. So does a distance of zero, except for a flat top.
/// Points that overflow are infinite, as in [`Mesh::map`]. Empty if the work is to end.
///
/// ```
/// use cga_geometry::extrude::{Extrude, extrude};
/// use cga_geometry::primitive;
///
/// let tower = extrude(&primitive::quad(), Extrude::FaceNormal, 3.0);
/// assert_eq!((tower.face_count(), tower.volume(), tower.is_closed()), (6, 3.0, true));
/// ```
pub fn extrude(mesh: &Mesh, along: Extrude, distance: f64) -> Mesh {
    let up = match along {
        Extrude::FaceNormal | Extrude::VertexNormal => DVec3::Y,
        Extrude::Vector(vector) | Extrude::FlatTop(vector) => vector,
    };
    if distance == 0.0 && !matches!(along, Extrude::FlatTop(_)) || !(up * distance).is_finite() {
        return mesh.clone();
    }
    let Some(normals) = mesh.sound_normals_in_time() else { return Mesh::default() };
    let joints = Joints::of(mesh, &normals, along != Extrude::FaceNormal);
    // The displacement of each point, by body or by point.
    let ways: Vec<DVec3> = match along {
        Extrude::FaceNormal => normals.iter().map(|normal| *normal * distance).collect(),
        Extrude::VertexNormal => match vertex_normals_in_time(mesh) {
            Some(normals) => normals.into_iter().map(|normal| normal * distance).collect(),
            None => return Mesh::default(),
        },
        Extrude::Vector(vector) => vec![vector * distance; mesh.points().len()],
        Extrude::FlatTop(vector) => flat_top(mesh.points(), vector, distance),
    };
    let way = |body: u32, point: u32| ways[if along == Extrude::FaceNormal { body } else { point } as usize];
    let corners = mesh.corners().len();
    let mut grown = Grown {
        source: mesh,
        made: Derivation::new(mesh, CornerValues::Coordinates, 6 * corners),
        low: vec![u32::MAX; mesh.points().len()],
        high: PairTable::with_capacity(if joints.are_one_body() { 0 } else { mesh.points().len() }),
        only_high: vec![u32::MAX; if joints.are_one_body() { mesh.points().len() } else { 0 }],
        bottom: Vec::new(),
        top: Vec::new(),
    };
    // A bottom and a top with all corners, and a wall of four corners at each edge.
    let walls = joints.inner.iter().filter(|is_inner| !**is_inner).count();
    grown.made.make_room(2 * mesh.points().len(), 2 * corners + 4 * walls, 2 * mesh.loop_ends.len() + walls);
    for (index, face) in mesh.faces().enumerate() {
        if !work::spend(GROWING * face.corner_count()) {
            return Mesh::default();
        }
        let body = joints.body[index];
        if face.corner_range().any(|corner| way(body, mesh.corners()[corner]) != DVec3::ZERO) {
            grown.body(&face, body, &joints.inner, &way);
        }
    }
    grown.made.finish()
}

/// For each point the average of the normals of the faces around it. Faces with the same normal count once, so that the
/// result does not depend on how a plane is divided. Zero if the normals cancel.
///
/// If the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile, all are zero.
pub fn vertex_normals(mesh: &Mesh) -> Vec<DVec3> {
    vertex_normals_in_time(mesh).unwrap_or_else(|| vec![DVec3::ZERO; mesh.points().len()])
}

/// [`vertex_normals`]. `None` if the work is to end.
fn vertex_normals_in_time(mesh: &Mesh) -> Option<Vec<DVec3>> {
    let adjacency = mesh.adjacency_in_time()?;
    let face_normals = mesh.sound_normals_in_time()?;
    let mut average = AverageNormal::default();
    let at_point = |point: usize| {
        let corners = adjacency.at(point).len();
        work::spend(JOINING * corners).then(|| {
            average.clear();
            adjacency.faces_around(point).for_each(|face| average.add(face_normals[face as usize]));
            average.unit()
        })
    };
    (0..mesh.points().len()).map(at_point).collect()
}

/// The displacement of each point up to a flat top.
pub(crate) fn flat_top(points: &[DVec3], up: DVec3, distance: f64) -> Vec<DVec3> {
    let heights: Vec<f64> = points.iter().map(|p| p.dot(up)).collect();
    let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let top = match distance {
        d if 0.0 <= d && high - low < d => low + d,
        d if 0.0 <= d => high,
        d if high - low < -d => high + d,
        _ => low,
    };
    let near = ANGLE_EPSILON * Bounds::of(points.iter().copied()).size().max_element();
    heights.iter().map(|height| if (top - height).abs() <= near { DVec3::ZERO } else { up * (top - height) }).collect()
}

/// The corners whose edges get no wall, and the bodies: faces connected by such edges.
struct Joints {
    inner: Vec<bool>,
    /// For each face the first face of its body.
    body: Vec<u32>,
}

impl Joints {
    fn of(mesh: &Mesh, normals: &[DVec3], at_all_angles: bool) -> Self {
        if mesh.face_count() == 1 {
            return Joints { inner: vec![false; mesh.corners().len()], body: vec![0] };
        }
        // Each directed edge belongs to the first corner that has it, so that walls are omitted in pairs.
        let mut edges = PairTable::with_capacity(mesh.corners().len());
        let mut face_of = vec![0u32; mesh.corners().len()];
        each_edge(mesh, |face, corner, a, b| {
            face_of[corner] = face as u32;
            edges.entry(a, b, corner as u32);
        });
        let mut inner = vec![false; mesh.corners().len()];
        let mut bodies = DisjointSets::new(mesh.face_count());
        each_edge(mesh, |face, corner, a, b| {
            if edges.get(a, b) != Some(corner as u32) {
                return;
            }
            let Some(opposite) = edges.get(b, a) else { return };
            let other = face_of[opposite as usize] as usize;
            let coplanar =
                (normals[face] - normals[other]).length() <= COPLANAR_EPSILON && normals[face] != DVec3::ZERO;
            if other != face && (at_all_angles || coplanar) {
                inner[corner] = true;
                bodies.unite(face as u32, other as u32);
            }
        });
        bodies.flatten();
        // If points move independently of their faces, there is one body.
        let body = |face: u32| if at_all_angles { 0 } else { bodies.find(face) };
        Joints { inner, body: (0..mesh.face_count() as u32).map(body).collect() }
    }

    /// Returns true if all faces are one body, the first.
    fn are_one_body(&self) -> bool {
        self.body.iter().all(|body| *body == 0)
    }
}

/// Calls `visit` with the face, the corner and the two points of every edge, as long as the work goes on.
fn each_edge(mesh: &Mesh, mut visit: impl FnMut(usize, usize, u32, u32)) {
    for (index, face) in mesh.faces().enumerate() {
        if !work::spend(JOINING * face.corner_count()) {
            return;
        }
        for ring in face.loop_ranges() {
            for corner in ring.clone() {
                let next = if corner + 1 == ring.end { ring.start } else { corner + 1 };
                visit(index, corner, mesh.corners()[corner], mesh.corners()[next]);
            }
        }
    }
}

/// The mesh under construction.
struct Grown<'a> {
    source: &'a Mesh,
    made: Derivation<'a>,
    /// The new index of each point of the source.
    low: Vec<u32>,
    /// The index of each point's displaced copy, one per body.
    high: PairTable,
    /// The same if there is only one body.
    only_high: Vec<u32>,
    /// The corners of the bottom and of the top of a body, in the order of the face's corners.
    bottom: Vec<u32>,
    top: Vec<u32>,
}

impl Grown<'_> {
    /// Adds the faces over a face: the bottom, the top, and a wall at each edge that is not inner.
    fn body(&mut self, face: &FaceRef<'_>, body: u32, inner: &[bool], way: &dyn Fn(u32, u32) -> DVec3) {
        // Vertices of the bottom come first, then vertices of the top. The order of faces is the same, with the sides
        // last.
        let (range, corners) = (face.corner_range(), self.source.corners());
        let mut bottom = std::mem::take(&mut self.bottom);
        let mut top = std::mem::take(&mut self.top);
        bottom.clear();
        bottom.extend(range.clone().map(|corner| self.low(corners[corner])));
        top.clear();
        top.extend(range.clone().map(|corner| self.high(corners[corner], body, way)));
        // The rings of the face within these lists.
        let rings = || face.loop_ranges().map(|ring| ring.start - range.start..ring.end - range.start);
        rings().for_each(|ring| flip(&mut bottom[ring]));
        self.made.face(rings().map(|ring| &bottom[ring]), FaceOrigin::over(face, Extruded::Bottom.tag()).turned());
        rings().for_each(|ring| flip(&mut bottom[ring]));
        self.made.face(rings().map(|ring| &top[ring]), FaceOrigin::over(face, Extruded::Top.tag()));
        for (number, ring) in rings().enumerate() {
            let part = if number == 0 { Extruded::Outer } else { Extruded::Inner };
            for at in ring.clone() {
                let next = if at + 1 == ring.end { ring.start } else { at + 1 };
                let [a, b, c, d] = [bottom[at], bottom[next], top[next], top[at]];
                let wall: &[u32] = match (a == d, b == c) {
                    (true, true) => continue,
                    // An end that did not move gives one corner.
                    (true, false) => &[a, b, c],
                    (false, true) => &[a, b, d],
                    (false, false) => &[a, b, c, d],
                };
                let edge = [at, next].each(|at| range.start + at);
                if !inner[edge[0]] {
                    self.made.face([wall], FaceOrigin::over_edge(face, part.tag(), edge));
                }
            }
        }
        (self.bottom, self.top) = (bottom, top);
    }

    fn low(&mut self, point: u32) -> u32 {
        let number = &mut self.low[point as usize];
        if *number == u32::MAX {
            *number = self.made.old_point(point);
        }
        *number
    }

    /// The displaced copy of a point; the point itself if it does not move.
    fn high(&mut self, point: u32, body: u32, way: &dyn Fn(u32, u32) -> DVec3) -> u32 {
        let by = way(body, point);
        if by == DVec3::ZERO {
            return self.low(point);
        }
        let next = self.made.point_count() as u32;
        let (number, is_new) = match self.only_high.get_mut(point as usize) {
            Some(number) if *number == u32::MAX => {
                *number = next;
                (number, true)
            }
            Some(number) => (number, false),
            None => self.high.entry(body, point, next),
        };
        if is_new {
            self.made.point(self.source.points()[point as usize] + by, PointOrigin::Moved(point));
        }
        *number
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{FaceTag, MeshBuilder};

    fn square(x: f64) -> Vec<DVec3> {
        [(x, 0.0), (x + 2.0, 0.0), (x + 2.0, -2.0), (x, -2.0)].map(|(x, z)| DVec3::new(x, 0.0, z)).to_vec()
    }

    #[test]
    fn a_rectangle_becomes_four_sides_a_top_and_a_bottom() {
        let base = Mesh::from_polygon(&square(0.0), &[]).unwrap();
        let body = extrude(&base, Extrude::FaceNormal, 3.0);
        assert_eq!(body.face_count(), 6);
        assert!(body.is_closed() && body.check().is_empty());
        assert_eq!(body.volume(), 12.0);
        let normals: Vec<DVec3> = body.faces().map(|f| f.normal()).collect();
        assert_eq!(normals, [DVec3::NEG_Y, DVec3::Y, DVec3::Z, DVec3::X, DVec3::NEG_Z, DVec3::NEG_X]);
        // The bottom keeps the first edge, reversed; vertices go around the bottom, then around the top.
        let faces: Vec<&[u32]> = body.faces().map(|face| face.outer()).collect();
        assert_eq!(faces[..3], [[1, 0, 3, 2], [4, 5, 6, 7], [0, 1, 5, 4]]);
        assert_eq!(faces[3..], [[1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]);
        assert_eq!(body.points()[..4], base.points()[..]);
        assert_eq!(extrude(&base, Extrude::FaceNormal, -3.0).volume(), -12.0);
        assert_eq!(extrude(&base, Extrude::Vector(DVec3::Y), 3.0).volume(), 12.0);
    }

    #[test]
    fn holes_give_inner_sides() {
        let hole = [(0.5, -0.5), (1.0, -0.5), (1.0, -1.0)].map(|(x, z)| DVec3::new(x, 0.0, z)).to_vec();
        let base = Mesh::from_polygon(&square(0.0), &[hole]).unwrap();
        let body = extrude(&base, Extrude::FaceNormal, 2.0);
        // n + 2 faces and 2n vertices, holes in top and bottom.
        assert_eq!((body.face_count(), body.points().len()), (9, 14));
        assert!(body.is_closed() && body.check().is_empty());
        assert_eq!(body.volume(), 2.0 * (4.0 - 0.125));
    }

    #[test]
    fn coplanar_neighbours_have_no_wall_between_them() {
        let mut b = MeshBuilder::new();
        for x in [0.0, 2.0] {
            let p: Vec<u32> = square(x).into_iter().map(|p| b.point(p)).collect();
            b.face(&p, &[], FaceTag::PLAIN);
        }
        let body = extrude(&b.build().unwrap(), Extrude::FaceNormal, 1.0);
        assert_eq!(body.face_count(), 10);
        assert_eq!(body.points().len(), 12);
        assert!(body.is_closed());
        assert_eq!(body.volume(), 8.0);
    }

    #[test]
    fn neighbours_at_an_angle_are_bodies_of_their_own() {
        let cube = crate::primitive::cube();
        let body = extrude(&cube, Extrude::FaceNormal, 0.5);
        assert_eq!(body.face_count(), 36);
        assert!(body.is_closed());
        assert!((body.volume() - 3.0).abs() < 1e-12);
    }

    /// Two slopes that meet in a fold along x, at a height of 1. The outer edges are at 0.
    fn folded() -> Mesh {
        let mut b = MeshBuilder::new();
        let at =
            [[0.0, 0.0, 2.0], [5.0, 0.0, 2.0], [5.0, 1.0, 0.0], [0.0, 1.0, 0.0], [5.0, 0.0, -2.0], [0.0, 0.0, -2.0]];
        let p = at.map(|p| b.point(p));
        b.face(&[p[0], p[1], p[2], p[3]], &[], FaceTag::PLAIN).face(&[p[3], p[2], p[4], p[5]], &[], FaceTag::PLAIN);
        b.build().unwrap()
    }

    #[test]
    fn upwards_and_along_vertex_normals_neighbours_stay_together() {
        // No faces inside.
        for along in [Extrude::Vector(DVec3::Y), Extrude::VertexNormal] {
            let body = extrude(&folded(), along, 3.0);
            assert_eq!((body.face_count(), body.points().len()), (10, 12));
            assert!(body.is_closed());
            assert_eq!(body.check(), []);
        }
        assert!((extrude(&folded(), Extrude::Vector(DVec3::Y), 3.0).volume() - 60.0).abs() < 1e-12);
        let body = extrude(&folded(), Extrude::VertexNormal, 3.0);
        // At the fold along the average, which is vertical; elsewhere along the normals of the slopes.
        let fold = body.points().iter().filter(|p| p.z == 0.0).map(|p| p.y).collect::<Vec<_>>();
        assert_eq!(fold, [1.0, 1.0, 4.0, 4.0]);
        assert_eq!(extrude(&folded(), Extrude::FaceNormal, 3.0).face_count(), 12);
        let inwards = extrude(&folded(), Extrude::VertexNormal, -0.5);
        assert!(inwards.is_closed() && inwards.volume() < 0.0);
    }

    #[test]
    fn vertex_normals_do_not_depend_on_how_planes_are_divided() {
        let cube = crate::primitive::cube();
        let mut b = MeshBuilder::new();
        let p: Vec<u32> = cube.points().iter().map(|p| b.point(*p)).collect();
        for face in cube.faces() {
            let [i, j, k, l] = [0, 1, 2, 3].map(|at| p[face.outer()[at] as usize]);
            b.face(&[i, j, k], &[], FaceTag::PLAIN).face(&[i, k, l], &[], FaceTag::PLAIN);
        }
        let triangles = b.build().unwrap();
        for mesh in [&cube, &triangles] {
            for (point, normal) in mesh.points().iter().zip(vertex_normals(mesh)) {
                assert!((normal - (*point - 0.5).normalize()).length() < 1e-12);
            }
            // A closed mesh becomes a shell without walls.
            let shell = extrude(mesh, Extrude::VertexNormal, libm::sqrt(3.0));
            assert!(shell.is_closed() && shell.face_count() == 2 * mesh.face_count());
            assert!((shell.volume() - 26.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_flat_top_is_at_least_as_high_as_the_highest_point() {
        let up = Extrude::FlatTop(DVec3::Y);
        // Distance, top, number of faces. Where nothing moves there is no wall, and a wall with one fixed end has three
        // corners.
        for (distance, top, faces) in
            [(0.0, 1.0, 10), (0.5, 1.0, 10), (1.0, 1.0, 10), (4.0, 4.0, 10), (-0.5, 0.0, 8), (-4.0, -3.0, 10)]
        {
            let body = extrude(&folded(), up, distance);
            assert_eq!(body.face_count(), faces, "{distance}");
            assert!(body.is_closed() && body.check().is_empty(), "{distance}: {:?}", body.check());
            let prism = 20.0 * top - 10.0;
            assert!((body.volume() - prism).abs() < 1e-12, "{distance}: {}", body.volume());
            let bounds = body.bounds();
            assert_eq!((bounds.low.y, bounds.high.y), (f64::min(top, 0.0), f64::max(top, 1.0)));
        }
        let flat = Mesh::from_polygon(&square(0.0), &[]).unwrap();
        assert!(extrude(&flat, up, 0.0).is_empty());
        assert_eq!(extrude(&flat, up, 2.0).volume(), 8.0);
    }

    #[test]
    fn faces_back_to_back_have_vertices_without_a_normal() {
        let mut b = MeshBuilder::new();
        let p: Vec<u32> = square(0.0).into_iter().map(|p| b.point(p)).collect();
        b.face(&p, &[], FaceTag::PLAIN).face(&[p[1], p[0], p[3], p[2]], &[], FaceTag::PLAIN);
        let mesh = b.build().unwrap();
        assert!(extrude(&mesh, Extrude::VertexNormal, 1.0).is_empty());
    }

    #[test]
    fn a_face_thinner_than_rounding_has_no_normal() {
        // A square on the ground, and a strip at its right side that stands on edge.
        let with_strip = |width: Option<f64>| {
            let mut b = MeshBuilder::new();
            let p: Vec<u32> = square(9.0).into_iter().map(|p| b.point(p + DVec3::Y * 7.0)).collect();
            b.face(&p, &[], FaceTag::PLAIN);
            if let Some(width) = width {
                let [c, d] = [-2.0, 0.0].map(|z| b.point([11.0, 7.0 + width, z]));
                b.face(&[p[1], p[2], c, d], &[], FaceTag::PLAIN);
            }
            b.build().unwrap()
        };
        let ground = with_strip(None);
        for width in [2e-14, -2e-14] {
            let both = with_strip(Some(width));
            let [alone, made] = [&ground, &both].map(|mesh| extrude(mesh, Extrude::FaceNormal, 2.0));
            assert_eq!((made.face_count(), made.volume()), (alone.face_count(), alone.volume()), "{width}");
            assert_eq!(vertex_normals(&both)[..4], [DVec3::Y; 4], "{width}");
        }
        // As wide as a hair it is a face.
        let hair = with_strip(Some(1e-4));
        assert_eq!(extrude(&hair, Extrude::FaceNormal, 2.0).face_count(), 12);
        assert_ne!(vertex_normals(&hair)[1], DVec3::Y);
    }
}
