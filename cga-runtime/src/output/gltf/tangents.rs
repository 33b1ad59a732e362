//! Tangents of vertices, for materials with a normal map: without them every reader computes its own.

use glam::{Vec2, Vec3};

use super::binary::FourBytes;
use super::primitive::Primitive;
use super::textures::NormalSpace;

impl Primitive {
    /// Writes the direction of growing u on the surface at each vertex, and the side of growing v. A vertex belongs
    /// to one face, so the triangles around it are nearly always in one plane.
    pub(super) fn write_tangents(&self, space: &NormalSpace, to: &mut Vec<FourBytes>) {
        let Some(uvs) = self.uvs.get(space.list) else { return };
        let mut sums = vec![[Vec3::ZERO; 2]; self.vertices().len()];
        for triangle in self.indices().as_chunks::<3>().0 {
            let triangle = triangle.map(|at| at as usize);
            let [a, b, c] = triangle.map(|at| Vec3::from_slice(&self.vertices()[at]));
            let [p, q, r] = triangle.map(|at| {
                let uv = Vec2::new(uvs[at][0], 1.0 - uvs[at][1]);
                Vec2::new(space.rows[0].dot(uv), space.rows[1].dot(uv))
            });
            let ([e, f], [s, t]) = ([b - a, c - a], [q - p, r - p]);
            // Only directions matter. Their sign is the sign of the area in texture space.
            let turn = (s.x * t.y - t.x * s.y).signum();
            let along = [(e * t.y - f * s.y) * turn, (f * s.x - e * t.x) * turn];
            for at in triangle {
                sums[at] = [sums[at][0] + unit(along[0]), sums[at][1] + unit(along[1])];
            }
        }
        for ([u, v], vertex) in sums.into_iter().zip(self.vertices()) {
            let normal = Vec3::from_slice(&vertex[3..]);
            let flat = unit(u - normal * normal.dot(u));
            let tangent = if flat == Vec3::ZERO { across(normal) } else { flat };
            let side = if normal.cross(tangent).dot(v) < 0.0 { -1.0 } else { 1.0 };
            to.extend([tangent.x, tangent.y, tangent.z, side].map(f32::to_le_bytes));
        }
    }
}

/// The vector scaled to length one; zero if it has no direction.
fn unit(v: Vec3) -> Vec3 {
    let scale = v.abs().max_element();
    if 0.0 < scale && scale.is_finite() { (v / scale).normalize() } else { Vec3::ZERO }
}

/// A unit vector perpendicular to a normal.
fn across(normal: Vec3) -> Vec3 {
    let axis = if normal.x.abs() < 0.9 { Vec3::X } else { Vec3::Y };
    unit(axis - normal * normal.dot(axis))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangents_follow_the_coordinates() {
        let mut primitive = Primitive::default();
        let vertices = [[0.0, 0.0], [2.0, 0.0], [0.0, 3.0]].map(|[x, y]| [x, y, 0.0, 0.0, 0.0, 1.0]);
        primitive.triangles.vertices.extend(vertices.into_iter());
        primitive.triangles.indices.extend([0, 1, 2].into_iter());
        // Coordinates as in the file, with v downwards.
        for (uvs, wanted) in [
            ([[0.0, 1.0], [1.0, 1.0], [0.0, 0.0]], [1.0, 0.0, 0.0, 1.0]),
            ([[0.0, 1.0], [-1.0, 1.0], [0.0, 0.0]], [-1.0, 0.0, 0.0, -1.0]),
            ([[0.0, 1.0], [0.0, 0.0], [-1.0, 1.0]], [0.0, -1.0, 0.0, 1.0]),
            ([[0.5; 2]; 3], [1.0, 0.0, 0.0, 1.0]),
        ] {
            primitive.uvs = vec![uvs.to_vec()];
            let mut words = Vec::new();
            primitive.write_tangents(&NormalSpace { list: 0, rows: [Vec2::X, Vec2::Y] }, &mut words);
            let tangents: Vec<f32> = words.into_iter().map(f32::from_le_bytes).collect();
            assert!(tangents.as_chunks::<4>().0.iter().all(|tangent| *tangent == wanted), "{tangents:?}");
        }
    }
}
