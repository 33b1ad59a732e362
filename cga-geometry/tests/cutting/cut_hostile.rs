//! Meshes made to break the cutter. Each of them once did.

use std::sync::Arc;

use crate::cut_support::{closed_by_position, together};
use cga_geometry::Axis;
use cga_geometry::cut::{self, Plane, slabs};
use cga_geometry::glam::{DVec2, DVec3};
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};

fn mesh(points: &[[f64; 3]], faces: &[&[u32]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    for &point in points {
        builder.point(point);
    }
    for face in faces {
        builder.face(face, &[], FaceTag::PLAIN);
    }
    builder.build().unwrap()
}

/// A box; inside out if it is a cavity.
fn block(low: [f64; 3], high: [f64; 3], cavity: bool) -> Mesh {
    let at = |i: usize| std::array::from_fn(|axis| if i >> axis & 1 == 0 { low[axis] } else { high[axis] });
    let points: Vec<[f64; 3]> = (0..8).map(at).collect();
    let faces: [&[u32]; 6] = [&[0, 4, 6, 2], &[1, 3, 7, 5], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 2, 3, 1], &[4, 5, 7, 6]];
    let mesh = mesh(&points, &faces);
    if cavity { mesh.reversed() } else { mesh }
}

fn twice(mesh: &Mesh) -> Mesh {
    together(&[mesh.clone(), mesh.clone()])
}

/// The areas of the caps, in rising order. Checks that every part is closed and has its holes in its outlines.
fn caps(mesh: &Arc<Mesh>, axis: Axis, at: f64) -> Vec<f64> {
    let cut = slabs(mesh, axis, &[at]);
    assert!(cut.open.is_empty());
    let mut found = Vec::new();
    for (part, side) in cut.parts.iter().flatten().zip([1.0, -1.0]) {
        assert_eq!(part.check(), []);
        assert!(closed_by_position(part));
        let mut areas: Vec<f64> = part.faces().filter(|face| face.tag().cap).map(|cap| cap.area()).collect();
        assert!(part.faces().all(|face| !face.tag().cap || face.normal()[axis.index()] == side));
        areas.sort_by(f64::total_cmp);
        found.push(areas);
    }
    assert_eq!(found[0], found[1]);
    found.swap_remove(0)
}

#[test]
fn an_island_that_touches_its_cavity_has_no_holes() {
    let solid = block([0.0; 3], [4.0; 3], false);
    let cavity = block([1.0; 3], [3.0; 3], true);
    let island = block([1.75, 1.0, 1.75], [2.25, 2.25, 2.25], false);
    let all = Arc::new(together(&[solid, cavity, island]));
    assert_eq!(caps(&all, Axis::X, 2.0), [0.625, 12.0]);
    assert_eq!(caps(&all, Axis::Y, 2.0), [0.25, 12.0]);
    assert_eq!(caps(&all, Axis::Z, 2.0), [0.625, 12.0]);
}

#[test]
fn inside_out_the_caps_are_the_same_turned_over() {
    // Four blocks that touch in a ring.
    let ring = [[1.0, 0.0], [0.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
    let ring = together(&ring.map(|[x, y]| block([x, y, 0.0], [x + 1.0, y + 1.0, 1.0], false)));
    // A cavity with an island at each side.
    let mut blocks = vec![block([0.0; 3], [4.0; 3], false), block([1.0; 3], [3.0; 3], true)];
    for [x, y] in [[1.75, 1.0], [1.75, 2.5], [1.0, 1.75], [2.5, 1.75]] {
        blocks.push(block([x, y, 1.75], [x + 0.5, y + 0.5, 2.25], false));
    }
    let islands = together(&blocks);
    for (mesh, at, expected) in [(ring, 0.5, 4), (islands, 2.0, 5)] {
        let caps = |mesh: Mesh| {
            let cut = slabs(&Arc::new(mesh), Axis::Z, &[at]);
            let parts = cut.parts.iter().flatten().map(|part| {
                assert!(part.is_closed());
                let caps = part.faces().filter(|face| face.tag().cap);
                let mut found: Vec<(f64, usize, f64)> =
                    caps.map(|cap| (cap.area(), cap.holes().len(), cap.normal().z)).collect();
                found.sort_by(|a, b| a.partial_cmp(b).unwrap());
                found
            });
            parts.collect::<Vec<_>>()
        };
        let (right, mut reversed) = (caps(mesh.clone()), caps(mesh.reversed()));
        assert_eq!(right[0].len(), expected);
        reversed.iter_mut().flatten().for_each(|(_, _, up)| *up = -*up);
        assert_eq!(right, reversed);
    }
}

#[test]
fn what_is_there_twice_has_its_holes_twice() {
    let hollow = together(&[
        block([0.0; 3], [12.0; 3], false),
        block([1.0; 3], [5.0, 11.0, 11.0], true),
        block([6.0, 1.0, 1.0], [11.0; 3], true),
    ]);
    let doubled = Arc::new(twice(&hollow));
    assert_eq!(caps(&doubled, Axis::X, 3.0), [44.0, 44.0]);
    assert_eq!(caps(&doubled, Axis::Y, 3.0), [54.0, 54.0]);
}

#[test]
fn a_cavity_beside_the_solid_is_not_its_hole() {
    let outline = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
    let points: Vec<[f64; 3]> = [0.0, 2.0].iter().flat_map(|&z| outline.map(|[x, y]| [x, y, z])).collect();
    let sides: Vec<[u32; 4]> = (0..6).map(|i| [i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6]).collect();
    let mut faces: Vec<&[u32]> = sides.iter().map(|side| &side[..]).collect();
    faces.extend([&[5, 4, 3, 2, 1, 0][..], &[6, 7, 8, 9, 10, 11][..]]);
    let all = together(&[mesh(&points, &faces), block([2.0, 2.0, 0.5], [3.0, 3.0, 1.5], true)]);
    for part in slabs(&Arc::new(all), Axis::Z, &[1.0]).parts.iter().flatten() {
        assert_eq!(part.check(), []);
        assert!(part.is_closed() && part.faces().all(|face| face.holes().len() == 0));
    }
}

#[test]
fn a_fin_on_an_edge_leaves_the_solid_closed() {
    let mut points = Vec::new();
    for y in [0.0, 1.0] {
        points.extend([[-1.0, y, 0.0], [0.0, y, -1.0], [1.0, y, 0.0], [0.0, y, 1.0]]);
    }
    let solid: [&[u32]; 6] = [&[0, 1, 2, 3], &[7, 6, 5, 4], &[1, 0, 4, 5], &[2, 1, 5, 6], &[3, 2, 6, 7], &[0, 3, 7, 4]];
    points.push([2.0, 0.5, -1.0]);
    let cut_with = |fin: &[u32]| {
        let faces: Vec<&[u32]> = solid.iter().copied().chain([fin]).collect();
        let cut = slabs(&Arc::new(mesh(&points, &faces)), Axis::Z, &[0.0]);
        let caps = cut.parts.iter().flatten().flat_map(|part| part.faces().filter(|face| face.tag().cap));
        (caps.map(|cap| cap.area()).collect::<Vec<_>>(), cut.open.len())
    };
    assert_eq!(cut_with(&[6, 2, 8]), (vec![2.0, 2.0], 0));
    // Reversed, the fin could be the partner of the solid's edge below the plane. The open one of the two cannot be
    // determined, so the section is reported as open.
    assert_eq!(cut_with(&[2, 6, 8]), (vec![], 1));
}

#[test]
fn many_edges_at_one_point_of_a_section_are_paired_without_harm() {
    // Spikes around the origin. Every other one is collinear with it, so that its crossing is the point itself.
    let around = [[2, 1], [2, -1], [2, 1], [1, 1], [-1, 1], [0, 1], [1, 2], [2, -1], [-1, 1], [2, -1], [1, -2]];
    let spikes = |scale: f64| {
        let (mut points, mut faces) = (vec![[0.0; 3]], Vec::new());
        for i in 0..21 {
            let (first, step) = (points.len() as u32, f64::from(i) + 1.0);
            if i % 2 == 0 {
                points.extend([[-1.0, -step, 1.0], [1.0, step, -1.0]]);
            } else {
                let [y, z] = around[i as usize / 2].map(f64::from);
                points.extend([[-step, y, z], [step, y, z]]);
            }
            faces.push([0, first + 1, first]);
        }
        points.iter_mut().flatten().for_each(|c| *c *= scale);
        let faces: Vec<&[u32]> = faces.iter().map(|face| &face[..]).collect();
        mesh(&points, &faces)
    };
    for scale in [1.0, 1e-160, 1e155] {
        let cut = slabs(&Arc::new(spikes(scale)), Axis::X, &[0.0]);
        assert!(cut.parts.iter().all(Option::is_some));
    }
}

#[test]
fn a_face_that_coils_around_a_zigzag_does_not_multiply() {
    // A band around a zigzag whose corners are in the plane.
    let turns = 400;
    let mut points: Vec<[f64; 3]> = Vec::new();
    for i in 0..turns {
        points.push([f64::from(i), if i % 2 == 0 { 0.0 } else { 0.25 }, 0.0]);
    }
    for turn in 0..turns {
        let far = f64::from(turn) * 0.5 + 1.0;
        let right = f64::from(turns) + far;
        points.extend([[right, 1.0 + far, 0.0], [-far, 1.0 + far, 0.0], [-far, -far, 0.0], [right + 0.25, -far, 0.0]]);
    }
    let face: Vec<u32> = (0..points.len() as u32).collect();
    let parts = slabs(&Arc::new(mesh(&points, &[&face])), Axis::Y, &[0.0]).parts;
    let corners: usize = parts.iter().flatten().map(|part| part.corners().len()).sum();
    assert!(corners < 6 * points.len(), "{corners} corners of {}", points.len());
}

#[test]
fn a_cap_begins_with_an_edge_of_the_wall_itself() {
    let points = [
        [0.0, 0.0, 0.0],
        [3.0, 0.0, 0.0],
        [3.0, 0.0, 1.0],
        [0.0, 0.0, 1.0],
        [0.0, 2.0, 0.0],
        [3.0, 2.0, 0.0],
        [3.0, 2.0, 1.0],
        [0.0, 2.0, 1.0],
        [2.0, 2.0, 1.0],
        [2.0, 1.0, 1.0],
        [1.0, 1.0, 1.0],
        [1.0, 2.0, 1.0],
    ];
    // The wall at the back of the first edge is a U, filled by another face.
    let faces: [&[u32]; 7] = [
        &[2, 3, 0, 1],
        &[10, 9, 8, 11],
        &[3, 2, 6, 8, 9, 10, 11, 7],
        &[1, 0, 4, 5],
        &[2, 1, 5, 6],
        &[0, 3, 7, 4],
        &[7, 11, 8, 6, 5, 4],
    ];
    let cut = slabs(&Arc::new(mesh(&points, &faces)), Axis::Y, &[1.5]);
    let above = cut.parts[1].as_ref().unwrap();
    let [a, b] = [0, 1].map(|i| above.points()[above.corners()[i] as usize]);
    assert!(above.face(0).tag().cap && [a.x, b.x] != [2.0, 1.0], "{a} {b}");
    assert!(a.z == 1.0 && b.z == 1.0 && a.x > b.x);
}

#[test]
fn a_plane_at_minus_zero_is_at_zero() {
    let cut = slabs(&Arc::new(block([-1.0; 3], [1.0; 3], false)), Axis::X, &[-0.0]);
    let points = cut.parts.iter().flatten().flat_map(|part| part.points());
    assert!(points.into_iter().all(|p| p.x != 0.0 || p.x.is_sign_positive()));
}

#[test]
fn caps_of_any_plane_have_coordinates_of_zero() {
    let base = block([0.0; 3], [1.0; 3], false);
    let mut builder = MeshBuilder::new();
    for point in base.points() {
        builder.point(point.to_array());
    }
    for face in base.faces() {
        builder.face(face.outer(), &[], face.tag());
        builder.uvs(&vec![DVec2::ONE; face.outer().len()]);
    }
    let cube = Arc::new(builder.build().unwrap());
    let of_caps = |parts: &[Option<Arc<Mesh>>]| {
        let mut found = Vec::new();
        for (side, part) in parts.iter().enumerate() {
            let part = part.as_ref().unwrap();
            for corner in part.faces().filter(|face| face.tag().cap).flat_map(|face| face.corner_range()) {
                let (p, uv) = (part.points()[part.corners()[corner] as usize], part.uvs()[corner]);
                found.push((side, p.to_array(), uv.to_array()));
            }
        }
        found.sort_by(|a, b| a.partial_cmp(b).unwrap());
        found
    };
    // The results equal the results of slabs for every point of the plane.
    for (axis, normal) in [(Axis::X, DVec3::X), (Axis::Y, DVec3::Y), (Axis::Z, DVec3::Z)] {
        for beside in [DVec3::ZERO, DVec3::new(0.25, -3.0, 7.0)] {
            let point = normal * 0.5 + beside * (DVec3::ONE - normal);
            let halves = of_caps(&cut::halves(&cube, &Plane { point, normal }, 0.0).parts);
            let slabs = of_caps(&slabs(&cube, axis, &[0.5]).parts);
            assert_eq!(halves.len(), slabs.len());
            for (a, b) in halves.iter().zip(&slabs) {
                assert!(a.0 == b.0 && (DVec3::from(a.1) - DVec3::from(b.1)).length() < 1e-12, "{a:?} {b:?}");
                assert!(a.2 == [0.0; 2] && b.2 == [0.0; 2], "{a:?} {b:?}");
            }
        }
    }
}
