//! Faces pulled out into closed volumes (*extrude operation*).
//!
//! Each face gives its sides in the order of its edges (outline, then holes), its top, and its bottom, which is the face
//! itself turned over. The first edge of a side is the edge it stands on, in the direction it has in the face. Where
//! coplanar faces share an edge there is no wall between them. A negative distance mirrors: the faces look inwards.

use glam::DVec3;

use super::map::flip;
use super::table::PairTable;
use super::{FaceTag, Mesh};
use crate::tol::COPLANAR_EPSILON;

/// Which way faces are pulled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extrude {
    /// Each along its own normal.
    FaceNormal,
    /// All along one unit vector.
    Vector(DVec3),
}

/// The volumes above the faces of a mesh. Faces without area have no normal and give nothing along it. A distance that is
/// zero or not finite leaves the mesh as it is.
pub fn extrude(mesh: &Mesh, along: Extrude, distance: f64) -> Mesh {
    let up = match along {
        Extrude::FaceNormal => DVec3::Y,
        Extrude::Vector(vector) => vector,
    };
    if distance == 0.0 || !(up * distance).is_finite() {
        return mesh.clone();
    }
    let normals: Vec<DVec3> = mesh.faces().map(|face| face.normal()).collect();
    let joints = Joints::of(mesh, &normals);
    let mut grown = Grown {
        source: mesh,
        mesh: Mesh {
            uvs: mesh.uvs.alike(6 * mesh.corners.len()),
            groups: mesh.groups.clone(),
            materials: mesh.materials.clone(),
            ..Mesh::default()
        },
        low: vec![u32::MAX; mesh.points.len()],
        high: PairTable::with_capacity(mesh.points.len()),
    };
    for (index, face) in mesh.faces().enumerate() {
        let body = joints.body[index];
        let by = match along {
            Extrude::FaceNormal => normals[body as usize] * distance,
            Extrude::Vector(vector) => vector * distance,
        };
        if by == DVec3::ZERO {
            // Without area there is no direction.
            continue;
        }
        let tag = FaceTag { cap: false, ..face.tag() };
        for ring in face.loop_ranges() {
            for corner in ring.clone() {
                let next = if corner + 1 == ring.end { ring.start } else { corner + 1 };
                if !joints.inner[corner] {
                    let [a, b] = [corner, next].map(|c| (grown.low(c), grown.high(c, body, by)));
                    grown.mesh.corners.extend([a.0, b.0, b.1, a.1]);
                    grown.copy_uvs(&[corner, next, next, corner]);
                    grown.end_loop();
                    grown.end_face(tag);
                }
            }
        }
        for top in [true, false] {
            for ring in face.loop_ranges() {
                let mut order: Vec<usize> = ring.collect();
                if !top {
                    flip(&mut order);
                }
                for &corner in &order {
                    let point = if top { grown.high(corner, body, by) } else { grown.low(corner) };
                    grown.mesh.corners.push(point);
                }
                grown.copy_uvs(&order);
                grown.end_loop();
            }
            grown.end_face(tag);
        }
    }
    grown.mesh
}

/// Which corners start an edge between coplanar faces, and which faces hang together by such edges.
struct Joints {
    inner: Vec<bool>,
    /// For each face the first face of its body.
    body: Vec<u32>,
}

impl Joints {
    fn of(mesh: &Mesh, normals: &[DVec3]) -> Self {
        // Each directed edge belongs to the first corner that has it, so that walls are left out in pairs.
        let mut edges = PairTable::with_capacity(mesh.corners.len());
        let mut face_of = vec![0u32; mesh.corners.len()];
        each_edge(mesh, |face, corner, a, b| {
            face_of[corner] = face as u32;
            edges.entry(a, b, corner as u32);
        });
        let mut joints =
            Joints { inner: vec![false; mesh.corners.len()], body: (0..mesh.face_count() as u32).collect() };
        each_edge(mesh, |face, corner, a, b| {
            if edges.get(a, b) != Some(corner as u32) {
                return;
            }
            let Some(opposite) = edges.get(b, a) else { return };
            let other = face_of[opposite as usize] as usize;
            let coplanar = (normals[face] - normals[other]).length() <= COPLANAR_EPSILON;
            if other != face && coplanar && normals[face] != DVec3::ZERO {
                joints.inner[corner] = true;
                let [a, b] = [face, other].map(|f| joints.root(f as u32));
                joints.body[a.max(b) as usize] = a.min(b);
            }
        });
        for face in 0..joints.body.len() as u32 {
            joints.body[face as usize] = joints.root(face);
        }
        joints
    }

    fn root(&self, mut face: u32) -> u32 {
        while self.body[face as usize] != face {
            face = self.body[face as usize];
        }
        face
    }
}

/// Calls back with face, corner and the two points of every edge.
fn each_edge(mesh: &Mesh, mut visit: impl FnMut(usize, usize, u32, u32)) {
    for (index, face) in mesh.faces().enumerate() {
        for ring in face.loop_ranges() {
            for corner in ring.clone() {
                let next = if corner + 1 == ring.end { ring.start } else { corner + 1 };
                visit(index, corner, mesh.corners[corner], mesh.corners[next]);
            }
        }
    }
}

/// The mesh being made.
struct Grown<'a> {
    source: &'a Mesh,
    mesh: Mesh,
    /// New index of a point of the source.
    low: Vec<u32>,
    /// Index of its moved copy, one for each body that has it.
    high: PairTable,
}

impl Grown<'_> {
    fn low(&mut self, corner: usize) -> u32 {
        let point = self.source.corners[corner] as usize;
        if self.low[point] == u32::MAX {
            self.low[point] = self.mesh.points.len() as u32;
            self.mesh.points.push(self.source.points[point]);
        }
        self.low[point]
    }

    fn high(&mut self, corner: usize, body: u32, by: DVec3) -> u32 {
        let point = self.source.corners[corner];
        let (index, new) = self.high.entry(body, point, self.mesh.points.len() as u32);
        if new {
            self.mesh.points.push(self.source.points[point as usize] + by);
        }
        *index
    }

    fn copy_uvs(&mut self, corners: &[usize]) {
        corners.iter().for_each(|&corner| self.mesh.uvs.push_from(&self.source.uvs, |list| list[corner]));
    }

    fn end_loop(&mut self) {
        self.mesh.loop_ends.push(self.mesh.corners.len() as u32);
    }

    fn end_face(&mut self, tag: FaceTag) {
        self.mesh.face_ends.push(self.mesh.loop_ends.len());
        self.mesh.tags.push(tag);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::MeshBuilder;

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
        assert_eq!(normals, [DVec3::Z, DVec3::X, DVec3::NEG_Z, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y]);
        let first = body.face(0).outer();
        assert_eq!(body.points()[first[0] as usize], base.points()[0]);
        assert_eq!(body.points()[first[1] as usize], base.points()[1]);
        assert_eq!(extrude(&base, Extrude::FaceNormal, -3.0).volume(), -12.0);
        assert_eq!(extrude(&base, Extrude::Vector(DVec3::Y), 3.0).volume(), 12.0);
    }

    #[test]
    fn holes_give_inner_sides() {
        let hole = [(0.5, -0.5), (1.0, -0.5), (1.0, -1.0)].map(|(x, z)| DVec3::new(x, 0.0, z)).to_vec();
        let base = Mesh::from_polygon(&square(0.0), &[hole]).unwrap();
        let body = extrude(&base, Extrude::FaceNormal, 2.0);
        // *extrude operation*: n + 2 faces and 2n vertices, holes in top and bottom.
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
        let cube = crate::mesh::primitive::cube();
        let body = extrude(&cube, Extrude::FaceNormal, 0.5);
        assert_eq!(body.face_count(), 36);
        assert!(body.is_closed());
        assert!((body.volume() - 3.0).abs() < 1e-12);
    }
}
