//! Smooth normals.

use glam::DVec3;

use crate::average_normal::AverageNormal;
use crate::buckets::Buckets;
use crate::disjoint::DisjointSets;
use crate::mesh::Mesh;
use crate::tol::ANGLE_EPSILON;
use crate::work;

/// Edges with more faces are hard. Every pair of faces at an edge is compared.
const MOST_FACES: usize = 16;

/// The units of work of a corner in a pass.
const CORNER: usize = 8;

impl Mesh {
    /// The mesh with smooth normals: at an edge whose faces meet at an angle below `limit` in degrees, the corners of both faces
    /// at each end have one normal. It is the average of the normals of all faces that such edges connect at the point; faces
    /// in one plane count once. Other edges are hard. Without smooth edges the mesh has no normals at corners, so that the
    /// normals of faces count. A limit that is NaN or not positive gives no smooth edge.
    ///
    /// If the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile, the mesh is empty.
    pub fn softened(&self, limit: f64) -> Mesh {
        self.softened_in_time(limit).unwrap_or_default()
    }

    /// [`softened`](Self::softened). `None` if the work is to end.
    fn softened_in_time(&self, limit: f64) -> Option<Mesh> {
        let adjacency = self.adjacency_in_time()?;
        let normals = self.face_normals_in_time()?;
        let normal = |corner: u32| normals[adjacency.face(corner) as usize];
        let mut groups = DisjointSets::new(self.corners.len());
        let mut is_soft = false;
        for edge in 0..adjacency.edge_count() {
            let uses = Some(adjacency.uses(edge)).filter(|uses| uses.len() <= MOST_FACES).unwrap_or_default();
            if !work::spend(2 * CORNER * uses.len()) {
                return None;
            }
            for (k, &one) in uses.iter().enumerate() {
                for &other in &uses[k + 1..] {
                    if !is_below(normal(one), normal(other), limit) {
                        continue;
                    }
                    is_soft = true;
                    let along = self.corners[one as usize] == self.corners[other as usize];
                    let [start, end] =
                        if along { [other, adjacency.next(other)] } else { [adjacency.next(other), other] };
                    groups.unite(one, start);
                    groups.unite(adjacency.next(one), end);
                }
            }
        }
        let mut mesh = Mesh { normals: Vec::new(), ..self.clone() };
        if is_soft {
            mesh.normals = (0..self.corners.len() as u32).map(normal).collect();
            let mut average = AverageNormal::default();
            groups.flatten();
            let sets =
                Buckets::by(self.corners.len(), (0..self.corners.len() as u32).map(|corner| groups.find(corner)));
            // Each set is at the place of its first corner.
            for group in (0..self.corners.len()).map(|first| sets.of(first)).filter(|group| 1 < group.len()) {
                if !work::spend(CORNER * group.len()) {
                    return None;
                }
                average.clear();
                group.iter().for_each(|&corner| average.add(normal(corner)));
                let found = average.unit();
                if found != DVec3::ZERO {
                    group.iter().for_each(|&corner| mesh.normals[corner as usize] = found);
                }
            }
        }
        Some(mesh)
    }
}

/// Returns true if the angle between unit normals is below a limit in degrees. An angle that equals the limit except for
/// rounding is not below it, and the angle of a face without an area is not either.
fn is_below(a: DVec3, b: DVec3, limit: f64) -> bool {
    if a == DVec3::ZERO || b == DVec3::ZERO {
        return false;
    }
    let angle = libm::atan2(a.cross(b).length(), a.dot(b)).to_degrees();
    angle < limit - ANGLE_EPSILON * 180.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{FaceTag, MeshBuilder};
    use crate::primitive;

    fn near(a: DVec3, b: DVec3) -> bool {
        (a - b).length() < 1e-12
    }

    #[test]
    fn corners_of_a_cube_share_the_average_of_three_faces() {
        let cube = primitive::cube();
        let soft = cube.softened(180.0);
        for (corner, normal) in soft.normals().iter().enumerate() {
            let outwards = cube.points()[cube.corners()[corner] as usize] - DVec3::splat(0.5);
            assert!(near(*normal, outwards.normalize()), "{normal}");
        }
        // The faces meet at 90 degrees, and an angle equal to the limit is hard.
        assert!(cube.softened(90.0).normals().is_empty() && cube.softened(0.0).normals().is_empty());
        assert!(!cube.softened(90.1).normals().is_empty());
    }

    #[test]
    fn sides_of_a_prism_are_smooth_below_the_angle_at_which_they_meet() {
        for (sides, angle) in [(12, 30.0), (36, 10.0), (6, 60.0), (7, 360.0 / 7.0)] {
            let prism = primitive::cylinder(sides);
            assert!(prism.softened(angle).normals().is_empty(), "{sides}");
            let soft = prism.softened(angle * 1.001);
            for face in soft.faces() {
                let is_side = face.outer().len() == 4;
                for corner in face.corner_range() {
                    let at = face.position(corner) - DVec3::new(0.5, 0.0, 0.5);
                    let radial = DVec3::new(at.x, 0.0, at.z).normalize();
                    let expected = if is_side { radial } else { face.normal() };
                    assert!((soft.normals()[corner] - expected).length() < 1e-9, "{sides}");
                }
            }
        }
    }

    #[test]
    fn normals_do_not_depend_on_how_faces_are_divided_and_do_not_pass_hard_edges() {
        let mut builder = MeshBuilder::new();
        let mut at = |x: f64, y: f64, z: f64| builder.point([x, y, z]);
        // A floor in two triangles, a wall at 90 degrees, and a fold of 20 degrees.
        let [a, b, c, d] = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(1.0, 0.0, -1.0), at(0.0, 0.0, -1.0)];
        let (rise, run) = libm::sincos(20f64.to_radians());
        let [e, f] = [at(1.0 + run, rise, 0.0), at(1.0 + run, rise, -1.0)];
        let [g, h] = [at(0.0, 1.0, 0.0), at(0.0, 1.0, -1.0)];
        for face in [&[a, b, c][..], &[a, c, d], &[b, e, f, c], &[a, d, h, g]] {
            builder.face(face, &[], FaceTag::PLAIN);
        }
        let mesh = builder.build().unwrap();
        let soft = mesh.softened(30.0);
        let at = |face: usize, point: u32| {
            let corner = mesh.face(face).corner_range().find(|&corner| mesh.corners()[corner] == point).unwrap();
            soft.normals()[corner]
        };
        let between = (DVec3::Y + mesh.face(2).normal()).normalize();
        assert!([at(0, b), at(2, b), at(0, c), at(1, c), at(2, c)].iter().all(|normal| near(*normal, between)));
        assert!(near(at(1, d), DVec3::Y) && near(at(3, d), DVec3::X) && near(at(2, e), mesh.face(2).normal()));
        // A hole in the middle has corners like any others.
        let all = mesh.softened(180.0);
        assert!(all.check().is_empty() && all.normals().iter().all(|normal| (normal.length() - 1.0).abs() < 1e-12));
    }

    #[test]
    fn faces_back_to_back_and_faces_without_area_are_hard() {
        let mut builder = MeshBuilder::new();
        let [a, b, c] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|p| builder.point(p));
        let d = builder.point([0.5, 0.0, 0.0]);
        for face in [[a, b, c], [c, b, a], [a, d, b]] {
            builder.face(&face, &[], FaceTag::PLAIN);
        }
        assert!(builder.build().unwrap().softened(180.0).normals().is_empty());
    }
}
