//! Tangents of vertices, for materials with a normal map: without them every reader computes its own.

use crate::geometry::each::Each;
use glam::{Vec2, Vec3};

use super::triangles::Vertex;

/// The direction of growing u on the surface at each vertex, and the side of growing v (1 or −1). `uv` gives the image
/// coordinates of a vertex, v upwards. A vertex belongs to one face, so the triangles around it are nearly always in
/// one plane.
pub(super) fn tangents(vertices: &[Vertex], indices: &[u32], uv: impl Fn(usize) -> Vec2) -> Vec<[f32; 4]> {
    let mut sums = vec![[Vec3::ZERO; 2]; vertices.len()];
    for triangle in indices.as_chunks::<3>().0 {
        let triangle = triangle.each(|at| at as usize);
        let [a, b, c] = triangle.each(|at| Vec3::from_slice(&vertices[at]));
        let [p, q, r] = triangle.each(&uv);
        let ([e, f], [s, t]) = ([b - a, c - a], [q - p, r - p]);
        // Only directions matter. Their sign is the sign of the area in texture space.
        let turn = (s.x * t.y - t.x * s.y).signum();
        let along = [(e * t.y - f * s.y) * turn, (f * s.x - e * t.x) * turn];
        for at in triangle {
            sums[at] = [sums[at][0] + unit(along[0]), sums[at][1] + unit(along[1])];
        }
    }
    let tangent = |([u, v], vertex): ([Vec3; 2], &Vertex)| {
        let normal = Vec3::from_slice(&vertex[3..]);
        let flat = unit(u - normal * normal.dot(u));
        let tangent = if flat == Vec3::ZERO { across(normal) } else { flat };
        let side = if normal.cross(tangent).dot(v) < 0.0 { -1.0 } else { 1.0 };
        [tangent.x, tangent.y, tangent.z, side]
    };
    sums.into_iter().zip(vertices).map(tangent).collect()
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
        let vertices = [[0.0, 0.0], [2.0, 0.0], [0.0, 3.0]].map(|[x, y]| [x, y, 0.0, 0.0, 0.0, 1.0]);
        for (uvs, wanted) in [
            ([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], [1.0, 0.0, 0.0, 1.0]),
            ([[0.0, 0.0], [-1.0, 0.0], [0.0, 1.0]], [-1.0, 0.0, 0.0, -1.0]),
            ([[0.0, 0.0], [0.0, 1.0], [-1.0, 0.0]], [0.0, -1.0, 0.0, 1.0]),
            ([[0.5; 2]; 3], [1.0, 0.0, 0.0, 1.0]),
        ] {
            let found = tangents(&vertices, &[0, 1, 2], |at| Vec2::from_array(uvs[at]));
            assert!(found.iter().all(|tangent| *tangent == wanted), "{found:?}");
        }
    }
}
