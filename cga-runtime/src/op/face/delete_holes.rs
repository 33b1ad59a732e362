//! `deleteHoles`: fills the holes of faces.

use std::sync::Arc;

use crate::geometry::holes::without_holes;
use crate::run::env::Env;
use crate::shape::{Geometry, Inserted, Placed, Shape};

/// `deleteHoles()`: removes the holes of all faces (*deleteHoles operation*). Outlines stay as they are, bent ones too, and so
/// do the scope, the first edges and all values at corners. A mesh that is closed by faces around its holes is open
/// afterwards, because these faces stay.
pub fn delete_holes(env: &mut Env, shape: &mut Shape) {
    let Geometry::Mesh(placed) = &shape.geometry else { return };
    let Some(filled) = without_holes(&placed.mesh) else { return };
    if env.count_vertices(&filled).is_break() {
        return;
    }
    let placed = Placed { mesh: Arc::new(filled), inserted: Inserted::No, ..Placed::clone(placed) };
    shape.geometry = Geometry::Mesh(Arc::new(placed));
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use super::*;
    use crate::geometry::extrude::{Extrude, extrude};
    use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};

    fn square(low: f64, high: f64) -> Vec<DVec3> {
        [(low, high), (high, high), (high, low), (low, low)].map(|(x, z)| DVec3::new(x, 0.0, z)).to_vec()
    }

    fn filled(mut shape: Shape) -> Shape {
        let env = &mut Env::for_tests();
        let before = shape.scope;
        delete_holes(env, &mut shape);
        assert!(env.take_faults().0.is_empty());
        assert_eq!(shape.scope, before);
        assert!(shape.to_mesh().check().is_empty(), "{:?}", shape.to_mesh().check());
        shape
    }

    #[test]
    fn all_holes_are_filled() {
        let yard = Mesh::from_polygon(&square(0.0, 10.0), &[square(1.0, 3.0), square(5.0, 9.0)]).unwrap();
        assert_eq!(yard.area(), 80.0);
        let shape = filled(Shape::mesh_axis_aligned(yard));
        let mesh = shape.to_mesh();
        assert_eq!((mesh.area(), mesh.points().len(), mesh.face(0).loops().len()), (100.0, 4, 1));
        assert_eq!(mesh.face(0).outer(), [0, 1, 2, 3]);
    }

    #[test]
    fn faces_around_holes_stay() {
        let yard = Mesh::from_polygon(&square(0.0, 4.0), &[square(1.0, 3.0)]).unwrap();
        let block = extrude(&yard, Extrude::FaceNormal, 2.0);
        assert!(block.is_closed());
        let mesh = filled(Shape::mesh_axis_aligned(block.clone())).to_mesh();
        assert_eq!((mesh.face_count(), mesh.points().len(), mesh.is_closed()), (10, 16, false));
        assert_eq!(mesh.area(), block.area() + 2.0 * 4.0);
    }

    #[test]
    fn a_bent_face_with_a_hole_keeps_its_corners_and_their_values() {
        let mut builder = MeshBuilder::new();
        let outer = [(0.0, 0.0, 4.0), (4.0, 1.0, 4.0), (4.0, 0.0, 0.0), (0.0, 1.0, 0.0)];
        let hole = [(1.0, 0.5, 3.0), (1.0, 0.5, 2.0), (2.0, 0.5, 3.0)];
        let mut add = |(x, y, z): (f64, f64, f64)| builder.point([x, y, z]);
        let (outer, hole) = (outer.map(&mut add), hole.map(&mut add));
        let uvs: Vec<DVec2> = (0..7).map(|k| DVec2::new(f64::from(k), 0.5)).collect();
        builder.face(&outer, &[&hole], FaceTag::PLAIN).uvs(&uvs).normals(&[DVec3::Y; 7]);
        let mesh = builder.build().unwrap();
        let mut shape = Shape::mesh_axis_aligned(mesh.clone());
        delete_holes(&mut Env::for_tests(), &mut shape);
        let filled = shape.to_mesh();
        assert_eq!(filled.points(), &mesh.points()[..4]);
        assert_eq!((filled.uvs(), filled.normals()), (&uvs[..4], &[DVec3::Y; 4][..]));
    }

    #[test]
    fn without_holes_nothing_changes() {
        let asset = Shape::cuboid(1.0, 2.0, 3.0);
        assert!(matches!(filled(asset).geometry, Geometry::Box(_)));
    }
}
