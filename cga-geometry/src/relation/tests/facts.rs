//! The documented cases, in every order of the axes and under rigid motions.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::{all_ways, block, motions, orders};
use crate::mesh::{Mesh, MeshBuilder};
use crate::relation::{Occluder, Occluders, QueryGeometry, Relation};

const fn answers(touches: bool, overlaps: bool, inside: bool) -> Relation {
    Relation { inside, overlaps, touches }
}

/// A box or a rectangle between two corners, and the answers for the cube from 0 to 2.
const CASES: [(&str, [f64; 3], [f64; 3], Relation); 18] = [
    ("a: sticks out of a wall", [1.0, 1.0, 2.0], [3.0, 3.0, 2.0], answers(true, false, false)),
    ("b: partly on the roof", [1.0, 2.0, 0.0], [3.0, 4.0, 2.0], answers(true, false, false)),
    ("c: upright on the roof", [0.5, 2.0, 1.0], [1.5, 3.0, 1.0], answers(false, false, false)),
    ("d: shares an edge", [-2.0, 2.0, 0.0], [0.0, 4.0, 2.0], answers(false, false, false)),
    ("e: a rectangle half inside", [-1.0, 1.0, 1.0], [1.0, 3.0, 1.0], answers(true, true, false)),
    ("f: a box half inside", [-1.0, 1.0, 1.0], [1.0, 3.0, 3.0], answers(true, true, false)),
    ("g: around, faces apart", [-1.0, -1.0, -1.0], [3.0, 3.0, 3.0], answers(true, true, false)),
    ("g: around, flush at the front", [-1.0, 0.0, -1.0], [3.0, 3.0, 2.0], answers(true, true, false)),
    ("h: on a wall", [0.0, 0.0, 2.0], [1.0, 1.0, 2.0], answers(true, false, true)),
    ("i: inside, an edge on the floor", [0.5, 0.0, 1.0], [1.5, 1.0, 1.0], answers(true, true, true)),
    ("j: inside, flush", [0.5, 0.0, 1.0], [1.5, 1.0, 2.0], answers(true, true, true)),
    ("the same box", [0.0, 0.0, 0.0], [2.0, 2.0, 2.0], answers(true, true, true)),
    ("the whole wall", [0.0, 0.0, 2.0], [2.0, 2.0, 2.0], answers(true, false, true)),
    ("around a wall", [-1.0, -1.0, 2.0], [3.0, 3.0, 2.0], answers(true, false, false)),
    ("through the cube", [0.5, 0.5, -1.0], [1.5, 1.5, 3.0], answers(true, true, false)),
    ("the neighbour of equal height", [2.0, 0.0, 0.0], [4.0, 2.0, 2.0], answers(true, false, false)),
    ("a wall beside the neighbour's", [2.0, 0.0, 2.0], [4.0, 2.0, 2.0], answers(false, false, false)),
    ("a part in common with equal sides", [1.0, 0.0, 0.0], [3.0, 2.0, 2.0], answers(true, true, false)),
];

#[test]
fn the_documented_cases_hold_in_all_positions() {
    for (name, low, high, expected) in CASES {
        for order in orders() {
            let [low, high] = [low, high].map(|corner| order.map(|axis| corner[axis]));
            for motion in motions(4, 1e3) {
                let cube = block([0.0; 3], [2.0; 3]);
                for found in all_ways(&block(low, high), &cube, &motion) {
                    assert_eq!(found, expected, "{name}, {order:?}");
                }
            }
        }
    }
}

#[test]
fn contact_does_not_depend_on_normals_and_tolerates_a_tenth_of_a_millimetre() {
    for (name, low, high, expected) in CASES {
        let mesh = block(low, high);
        for off in [-1e-4, 1e-4] {
            for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
                let moved = mesh.map(&DAffine3::from_translation(axis * off));
                for mesh in [&moved, &moved.reversed()] {
                    let found = all_ways(mesh, &block([0.0; 3], [2.0; 3]), &DAffine3::IDENTITY);
                    assert!(found.iter().all(|found| *found == expected), "{name}, {off} along {axis}: {found:?}");
                }
            }
        }
    }
}

#[test]
fn segments_and_points_are_inside_on_or_across() {
    let cube = block([0.0; 3], [2.0; 3]);
    let segments = [
        ("inside", [0.5, 0.5, 0.5], [1.5, 1.0, 1.5], answers(true, true, true)),
        ("across", [0.5, 0.5, 0.5], [3.5, 1.0, 1.5], answers(true, true, false)),
        ("through", [-1.0, 0.5, 0.5], [3.5, 1.0, 1.5], answers(true, true, false)),
        ("on a face", [0.5, 2.0, 0.5], [1.5, 2.0, 1.5], answers(true, false, true)),
        ("on an edge", [0.0, 2.0, 2.0], [2.0, 2.0, 2.0], answers(true, false, true)),
        ("half on a face", [0.5, 2.0, 0.5], [3.5, 2.0, 1.5], answers(false, false, false)),
        ("upright on a face", [0.5, 2.0, 0.5], [0.5, 3.0, 0.5], answers(false, false, false)),
        ("from wall to wall", [0.0, 0.5, 0.5], [2.0, 1.0, 1.5], answers(true, true, true)),
        ("beside", [3.0, 0.5, 0.5], [3.0, 1.0, 1.5], answers(false, false, false)),
        ("across a corner, outside", [1.5, 2.5, 1.0], [2.5, 1.8, 1.0], answers(false, false, false)),
    ];
    let points = [
        ("inside", [0.5, 0.5, 0.5], Relation::ALL),
        ("on a face", [0.5, 2.0, 0.5], answers(true, false, true)),
        ("on a corner", [2.0, 2.0, 0.0], answers(true, false, true)),
        ("outside", [0.5, 2.5, 0.5], Relation::NONE),
    ];
    for motion in motions(6, 1e3) {
        let mesh = Arc::new(cube.clone());
        let by_mesh = Occluders::new([(Arc::new(super::bulged(&mesh)), motion)]);
        let by_box = Occluders::new([(mesh, motion)]);
        for occluders in [by_box, by_mesh] {
            let ask = |geometry: &QueryGeometry<'_>| occluders.query(geometry, Relation::ALL, &mut |_| true);
            for (name, a, b, expected) in segments {
                let ends = [a, b].map(|end| motion.transform_point3(DVec3::from(end)));
                assert_eq!(ask(&QueryGeometry::segment(ends)), expected, "{name}");
                // A face without area.
                let sides = [(ends[1] - ends[0]) * 0.5, (ends[1] - ends[0]) * 0.5];
                assert_eq!(ask(&QueryGeometry::rectangle(ends[0], sides)), expected, "{name}");
            }
            for (name, at, expected) in points {
                let at = motion.transform_point3(DVec3::from(at));
                assert_eq!(ask(&QueryGeometry::point(at)), expected, "{name}");
                assert_eq!(ask(&QueryGeometry::segment([at, at])), expected, "{name}");
            }
        }
    }
}

/// A tile on the joint of two blocks of 10 and 20 m that are in contact.
#[test]
fn tiles_of_a_joint_touch_where_the_neighbour_reaches() {
    let blocks = [block([0.0; 3], [10.0, 10.0, 10.0]), block([10.0, 0.0, 0.0], [20.0, 20.0, 10.0])];
    for motion in motions(5, 1e5) {
        let occluders = Occluders::new(blocks.each_ref().map(|block| (Arc::new(block.clone()), motion)));
        let mut counts = [0; 3];
        for storey in 0..5 {
            for bay in 0..5 {
                let corner = motion.transform_point3(DVec3::new(10.0, f64::from(4 * storey), f64::from(2 * bay)));
                let sides = [DVec3::Z * 2.0, DVec3::Y * 4.0].map(|side| motion.matrix3 * side);
                let tile = QueryGeometry::rectangle(corner, sides);
                let found = occluders.query(&tile, Relation::ALL, &mut |number| number == 0);
                let expected = match storey {
                    0 | 1 => answers(true, false, true),
                    2 => answers(true, false, false),
                    _ => Relation::NONE,
                };
                assert_eq!(found, expected, "storey {storey}");
                counts[usize::from(found.touches) + usize::from(found.inside)] += 1;
                // Tiles at the street touch their own block alone.
                let corner =
                    motion.transform_point3(DVec3::new(10.0 + f64::from(2 * bay), f64::from(4 * storey), 10.0));
                let sides = [DVec3::X * 2.0, DVec3::Y * 4.0].map(|side| motion.matrix3 * side);
                let tile = QueryGeometry::rectangle(corner, sides);
                assert_eq!(occluders.query(&tile, Relation::ALL, &mut |number| number == 0), Relation::NONE);
            }
        }
        assert_eq!(counts, [10, 5, 10]);
    }
}

#[test]
fn answers_of_several_occluders_are_not_united() {
    let halves = [block([0.0; 3], [1.0, 2.0, 2.0]), block([1.0, 0.0, 0.0], [2.0; 3])];
    let occluders = Occluders::new(halves.map(Arc::new));
    let across = QueryGeometry::rectangle(DVec3::new(0.5, 0.5, 1.0), [DVec3::X, DVec3::Y]);
    assert_eq!(occluders.query(&across, Relation::ALL, &mut |_| true), answers(true, true, false));
    let joint = QueryGeometry::rectangle(DVec3::new(1.0, 0.5, 0.5), [DVec3::Z, DVec3::Y]);
    assert_eq!(occluders.query(&joint, Relation::ALL, &mut |_| true), answers(true, false, true));
    // Only some answers are asked for.
    for wanted in [Relation::INSIDE, Relation::OVERLAPS, Relation::TOUCHES] {
        for geometry in [&across, &joint] {
            let all = occluders.query(geometry, Relation::ALL, &mut |_| true);
            assert_eq!(occluders.query(geometry, wanted, &mut |_| true), all.and(wanted));
        }
    }
}

#[test]
fn cavities_are_outside_and_walls_within_a_solid_are_inside() {
    // A block with a cavity, as one mesh.
    let outer = block([0.0; 3], [4.0; 3]);
    let cavity = block([1.0; 3], [3.0; 3]).reversed();
    let hollow = crate::mesh::join::join([&outer, &cavity].into_iter());
    // Two blocks that cross, as one mesh.
    let crossing = crate::mesh::join::join([&outer, &block([2.0, 1.0, 1.0], [6.0, 3.0, 3.0])].into_iter());
    let cases: [(&Mesh, &str, Mesh, Relation); 9] = [
        (&hollow, "in the cavity", block([1.5; 3], [2.5; 3]), answers(false, false, false)),
        (&hollow, "fills the cavity", block([1.0; 3], [3.0; 3]), answers(true, false, false)),
        (&hollow, "around the cavity", block([0.5; 3], [3.5; 3]), answers(true, true, false)),
        (&hollow, "in the wall", block([0.25; 3], [0.75; 3]), answers(true, true, true)),
        (&hollow, "on the cavity", block([1.0, 1.5, 1.5], [1.0, 2.5, 2.5]), answers(true, false, true)),
        (&hollow, "across the cavity", block([0.0, 2.0, 0.0], [4.0, 2.0, 4.0]), answers(true, true, false)),
        (&crossing, "on a wall within", block([4.0, 1.5, 1.5], [4.0, 2.5, 2.5]), answers(true, true, true)),
        (&crossing, "through a wall within", block([3.0, 1.5, 1.5], [5.0, 2.5, 2.5]), answers(true, true, true)),
        (&crossing, "sticks out", block([3.0, 0.5, 1.5], [5.0, 2.5, 2.5]), answers(true, true, false)),
    ];
    for (occluder, name, geometry, expected) in cases {
        for motion in motions(4, 1e3) {
            for occluder in [occluder, &occluder.reversed()] {
                let occluders = Occluders::new([(Arc::new(occluder.clone()), motion)]);
                let found = occluders.query(&QueryGeometry::mesh(&geometry, motion), Relation::ALL, &mut |_| true);
                assert_eq!(found, expected, "{name}");
            }
        }
    }
}

#[test]
fn a_hole_in_a_face_is_no_surface() {
    let square = |from: f64, to: f64, y: f64| [[from, y, to], [to, y, to], [to, y, from], [from, y, from]];
    let outline = square(0.0, 4.0, 0.0).map(DVec3::from);
    let hole = square(1.0, 3.0, 0.0).map(DVec3::from).to_vec();
    let frame = Mesh::from_polygon(&outline, &[hole]).unwrap();
    let court = crate::extrude::extrude(&frame, crate::extrude::Extrude::FaceNormal, 4.0);
    assert!(court.is_closed());
    let cases = [
        ("over the court", block([1.25, 4.0, 1.25], [2.75, 4.0, 2.75]), Relation::NONE),
        ("over court and roof", block([0.5, 4.0, 0.5], [2.0, 4.0, 2.0]), answers(true, false, false)),
        ("over the roof", block([0.25, 4.0, 0.25], [0.75, 4.0, 0.75]), answers(true, false, true)),
        ("over all", block([-1.0, 4.0, -1.0], [5.0, 4.0, 5.0]), answers(true, false, false)),
        ("the court", block([1.0, 0.0, 1.0], [3.0, 4.0, 3.0]), answers(true, false, false)),
        ("court and walls", block([0.0; 3], [4.0; 3]), answers(true, true, false)),
        ("a wall of the court", block([1.0, 1.0, 1.0], [1.0, 3.0, 3.0]), answers(true, false, true)),
    ];
    for motion in motions(4, 1e3) {
        let occluders = Occluders::new([(Arc::new(court.clone()), motion)]);
        for (name, geometry, expected) in &cases {
            let found = occluders.query(&QueryGeometry::mesh(geometry, motion), Relation::ALL, &mut |_| true);
            assert_eq!(found, *expected, "{name}");
        }
        // The building itself, and a frame that is open.
        let found = occluders.query(&QueryGeometry::mesh(&court, motion), Relation::ALL, &mut |_| true);
        assert_eq!(found, Relation::ALL);
        let found = occluders.query(&QueryGeometry::mesh(&frame, motion), Relation::ALL, &mut |_| true);
        assert_eq!(found, answers(true, false, true));
    }
}

#[test]
fn open_flat_and_wrong_occluders_have_numbers_and_no_relations() {
    let mut wrong = block([0.0; 3], [2.0; 3]);
    wrong.change_points(|point| point.x = f64::NAN);
    let open = crate::primitive::quad();
    let occluders = Occluders::new([
        Occluder::from(Arc::new(wrong)),
        Occluder::from(Arc::new(open)),
        Occluder::from(Arc::new(Mesh::default())),
        Occluder::cuboid(DAffine3::from_scale(DVec3::new(2.0, 0.0, 2.0))),
        Occluder::cuboid(DAffine3::from_scale(DVec3::splat(f64::INFINITY))),
        Occluder::cuboid(DAffine3::from_scale(DVec3::splat(1e200))),
        Occluder::cuboid(DAffine3::from_scale(DVec3::splat(2.0))),
    ]);
    assert_eq!((occluders.len(), occluders.is_empty()), (7, false));
    let mut asked = Vec::new();
    let inner = QueryGeometry::cuboid(DAffine3::IDENTITY);
    let found = occluders.query(&inner, Relation::ALL, &mut |number| {
        asked.push(number);
        true
    });
    assert_eq!((found, asked), (Relation::ALL, vec![6]));
}

#[test]
fn hostile_geometries_end_without_a_relation() {
    let mut builder = MeshBuilder::new();
    let hinge = [0.0, 1.0].map(|y| builder.point([0.0, y, 0.0]));
    for number in 0..40 {
        let tip = builder.point([f64::from(number) * 1e-9, 0.5, f64::from(number)]);
        builder.polygon(&[hinge[0], hinge[1], tip]);
    }
    let fans = builder.build().unwrap();
    let numbers = [0.0, 1e-300, 1e-9, 1e50, 1e60, 1e308, f64::NAN];
    let mut scales = vec![DVec3::ONE];
    for number in numbers {
        scales.extend([DVec3::splat(number), DVec3::new(1.0, -number, 1.0)]);
    }
    let sphere = Arc::new(crate::primitive::sphere(8, 6));
    for scale in &scales {
        let placement = DAffine3::from_scale(*scale);
        let occluders = Occluders::new([
            Occluder::cuboid(placement),
            Occluder::from((sphere.clone(), placement)),
            Occluder::from(sphere.clone()),
        ]);
        for scale in &scales {
            let placement = DAffine3::from_scale(*scale);
            let geometries = [
                QueryGeometry::cuboid(placement),
                QueryGeometry::mesh(&sphere, placement),
                QueryGeometry::mesh(&fans, placement),
                QueryGeometry::rectangle(*scale, [DVec3::X * scale.x, DVec3::Y]),
                QueryGeometry::segment([DVec3::ZERO, *scale]),
                QueryGeometry::point(*scale),
            ];
            for geometry in geometries {
                let found = occluders.query(&geometry, Relation::ALL, &mut |_| true);
                assert!(found.touches || found == Relation::NONE, "{found:?}");
                assert!(scale.is_finite() || found == Relation::NONE);
            }
        }
    }
}
