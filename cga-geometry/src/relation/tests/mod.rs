//! Relations of geometries in all positions.

mod facts;
mod near;
mod random;

use std::sync::Arc;

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::{Occluder, Occluders, QueryGeometry, Relation};
use crate::mesh::{Mesh, MeshBuilder};
use crate::primitive::cube;
use crate::random::Rng;

/// A box between two corners, or a rectangle if they are in one plane.
fn block(low: [f64; 3], high: [f64; 3]) -> Mesh {
    let [low, high] = [low, high].map(DVec3::from);
    let size = high - low;
    if let Some(axis) = (0..3).find(|axis| size[*axis] == 0.0) {
        let [a, b] = [(axis + 1) % 3, (axis + 2) % 3].map(|axis| DVec3::AXES[axis] * size[axis]);
        let mut builder = MeshBuilder::new();
        let corners = [low, low + a, low + a + b, low + b].map(|corner| builder.point(corner));
        builder.polygon(&corners);
        return builder.build().unwrap();
    }
    cube().map(&DAffine3 { matrix3: DMat3::from_diagonal(size), translation: low })
}

/// All orders of the axes.
fn orders() -> [[usize; 3]; 6] {
    [[0, 1, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0], [1, 0, 2], [0, 2, 1]]
}

/// The identity, a move, and random rotations with moves up to a distance.
fn motions(count: u64, far: f64) -> Vec<DAffine3> {
    let mut rng = Rng(17);
    let mut motions = vec![DAffine3::IDENTITY, DAffine3::from_translation(DVec3::new(0.1, 0.7, 0.3) * far)];
    motions.extend((0..count).map(|_| motion(&mut rng, far)));
    motions
}

fn motion(rng: &mut Rng, far: f64) -> DAffine3 {
    let mut number = || 2.0 * rng.unit() - 1.0;
    let [x, y, z, w] = [number(), number(), number(), number()];
    let turn = DQuat::from_xyzw(x, y, z, w + 1e-3).normalize();
    DAffine3::from_rotation_translation(turn, DVec3::new(number(), number(), number()) * far)
}

/// The same solid or face with a further corner in an edge, so that it is not found to be a box or a rectangle.
fn bulged(mesh: &Mesh) -> Mesh {
    let mut builder = MeshBuilder::new();
    let points: Vec<u32> = mesh.points().iter().map(|point| builder.point(*point)).collect();
    let first = mesh.face(0).outer();
    let split = [first[0], first[1]];
    let middle = builder.point((mesh.points()[split[0] as usize] + mesh.points()[split[1] as usize]) * 0.5);
    for face in mesh.faces() {
        let outer = face.outer();
        let mut corners = Vec::new();
        for (number, &corner) in outer.iter().enumerate() {
            corners.push(points[corner as usize]);
            let next = outer[(number + 1) % outer.len()];
            if [corner, next] == split || [next, corner] == split {
                corners.push(middle);
            }
        }
        builder.polygon(&corners);
    }
    builder.build().unwrap()
}

/// The relation of a mesh to another one, both moved, by all ways to compare them: as boxes or rectangles where they are, and as meshes.
fn all_ways(geometry: &Mesh, occluder: &Mesh, motion: &DAffine3) -> Vec<Relation> {
    let mut found = Vec::new();
    for occluder in [occluder.clone(), bulged(occluder)] {
        let occluders = Occluders::new([Occluder::mesh(Arc::new(occluder), *motion)]);
        for geometry in [geometry, &bulged(geometry)] {
            let moved = QueryGeometry::mesh(geometry, *motion);
            let all = occluders.query(&moved, Relation::ALL, &mut |_| true);
            for wanted in [Relation::INSIDE, Relation::OVERLAPS, Relation::TOUCHES] {
                assert_eq!(occluders.query(&moved, wanted, &mut |_| true), all.and(wanted), "{wanted:?} alone");
            }
            found.push(all);
        }
    }
    found
}
