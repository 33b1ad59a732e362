//! Leaves with the same mesh and the same changes of its texture coordinates share one mesh.

use std::sync::Arc;

use super::Coordinates;
use crate::geometry::mesh::Mesh;
use crate::shape::{Geometry, Placed, Shape};

/// The number of results that are kept: few kinds of leaves alternate.
const KEPT: usize = 8;

/// The last results whose coordinates do not depend on the place of the leaf.
#[derive(Debug, Default)]
pub(crate) struct SharedSets {
    results: Vec<SharedMesh>,
    /// The result that is replaced next.
    oldest: usize,
}

#[derive(Debug)]
struct SharedMesh {
    mesh: Arc<Mesh>,
    coordinates: Coordinates,
    result: Arc<Mesh>,
}

impl SharedSets {
    /// Writes the implicit coordinates of a leaf into the sets of its mesh.
    pub(crate) fn write(&mut self, leaf: &mut Shape) {
        let mesh = match &leaf.geometry {
            Geometry::Mesh(placed) if leaf.state.coordinates().follow_the_mesh() => placed.mesh.clone(),
            _ => return leaf.write_sets_of_mesh(),
        };
        let coordinates = leaf.state.coordinates();
        let is_known = |known: &&SharedMesh| Arc::ptr_eq(&known.mesh, &mesh) && known.coordinates == *coordinates;
        if let Some(SharedMesh { result, .. }) = self.results.iter().find(is_known) {
            if let Geometry::Mesh(placed) = &mut leaf.geometry {
                *placed = Arc::new(Placed { mesh: result.clone(), ..Placed::clone(placed) });
            }
            return;
        }
        let coordinates = coordinates.clone();
        leaf.write_sets_of_mesh();
        let Geometry::Mesh(placed) = &leaf.geometry else { return };
        let new = SharedMesh { mesh, coordinates, result: placed.mesh.clone() };
        match self.results.get_mut(self.oldest) {
            Some(old) => *old = new,
            None => self.results.push(new),
        }
        self.oldest = (self.oldest + 1) % KEPT;
    }
}

#[cfg(test)]
mod tests {
    use glam::{DAffine2, DVec2};

    use super::*;
    use crate::geometry::primitive;

    fn leaf(mesh: &Arc<Mesh>, scale: f64, at: f64) -> Shape {
        let mut shape = Shape::cuboid(1.0, 1.0, 1.0).at([at, 0.0, 0.0]);
        shape.geometry = Geometry::Mesh(Arc::new(Placed::fitted(mesh.clone())));
        let coordinates = &mut shape.state.change_look().coordinates;
        assert!(coordinates.change(0, &DAffine2::from_scale(DVec2::splat(scale))));
        shape
    }

    fn mesh_of(leaf: &Shape) -> &Arc<Mesh> {
        match &leaf.geometry {
            Geometry::Mesh(placed) => &placed.mesh,
            _ => panic!("the leaf is a mesh"),
        }
    }

    #[test]
    fn equal_changes_of_one_mesh_make_one_mesh() {
        let (one, other) = (Arc::new(primitive::cylinder(8)), Arc::new(primitive::cylinder(9)));
        let mut shared = SharedSets::default();
        let mut write = |mesh: &Arc<Mesh>, scale: f64, at: f64| {
            let mut alone = leaf(mesh, scale, at);
            let mut leaf = alone.clone();
            shared.write(&mut leaf);
            alone.write_sets_of_mesh();
            assert_eq!(mesh_of(&leaf).uvs(), mesh_of(&alone).uvs());
            assert_ne!(mesh_of(&leaf).uvs(), mesh.uvs());
            mesh_of(&leaf).clone()
        };
        let first = write(&one, 2.0, 0.0);
        assert!(Arc::ptr_eq(&first, &write(&one, 2.0, 5.0)));
        assert!(!Arc::ptr_eq(&first, &write(&one, 3.0, 0.0)));
        assert!(!Arc::ptr_eq(&first, &write(&other, 2.0, 0.0)));
        // Old results make room for new ones.
        (10..10 + 2 * KEPT).for_each(|scale| drop(write(&one, scale as f64, 0.0)));
        assert!(!Arc::ptr_eq(&first, &write(&one, 2.0, 0.0)));
        assert_eq!(shared.results.len(), KEPT);
    }

    #[test]
    fn coordinates_that_depend_on_the_place_are_not_shared() {
        let mesh = Arc::new(primitive::cylinder(8));
        let mut shared = SharedSets::default();
        let mut write = |at: f64| {
            let mut shape = leaf(&mesh, 1.0, at);
            let cube = super::super::UvSource::of_cube(&shape.scope);
            shape.state.change_look().coordinates.set(0, cube);
            shared.write(&mut shape);
            mesh_of(&shape).clone()
        };
        assert!(!Arc::ptr_eq(&write(0.0), &write(0.0)));
    }
}
