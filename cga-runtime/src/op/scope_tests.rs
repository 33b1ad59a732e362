//! Operations that change scope and pivot only: the geometry stays in the world, face by face and corner by corner.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::*;
use crate::geometry::Axis;
use crate::geometry::mesh::Mesh;
use crate::geometry::rotation::turn;
use crate::shape::unit::UnitMesh;
use crate::shape::{Geometry, Placed, Shape};

type Step = dyn Fn(&mut Env, &mut Shape);

/// The corners of each face, in the world.
fn world(shape: &Shape) -> Vec<Vec<DVec3>> {
    let mesh = shape.to_mesh();
    let at = |&corner: &u32| shape.scope.frame().to_world(mesh.points()[corner as usize]);
    mesh.faces()
        .flat_map(|face| face.loops().map(|ring| ring.iter().map(at).collect::<Vec<_>>()).collect::<Vec<_>>())
        .collect()
}

#[track_caller]
fn same(a: &[Vec<DVec3>], b: &[Vec<DVec3>], what: &str) {
    let near =
        |a: &Vec<DVec3>, b: &Vec<DVec3>| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (*a - *b).length() < 1e-9);
    assert!(a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(a, b)), "{what}\n{a:?}\n{b:?}");
}

/// Checks that frames are right-handed and orthonormal, and that the geometry is between 0 and the size of the scope.
#[track_caller]
fn sound(shape: &Shape, filled: bool, what: &str) {
    for axes in [shape.scope.axes, shape.pivot.axes] {
        assert!((axes.transpose() * axes).abs_diff_eq(DMat3::IDENTITY, 1e-12), "{what}: {axes}");
        assert!((axes.determinant() - 1.0).abs() < 1e-12, "{what}");
    }
    let mesh = shape.to_mesh();
    if mesh.is_empty() {
        return;
    }
    let (low, high) = (DVec3::ZERO.min(shape.scope.size), DVec3::ZERO.max(shape.scope.size));
    let bounds = mesh.bounds();
    let slack = (bounds.low - low).min(high - bounds.high);
    assert!(-1e-9 < slack.min_element(), "{what}: {bounds:?} in {:?}", shape.scope);
    assert!(!filled || slack.max_element() < 1e-9, "{what}: {bounds:?} in {:?}", shape.scope);
}

fn with_hole() -> Shape {
    let hole = vec![[1.0, 1.0], [2.0, 1.0], [2.0, 2.5]];
    Shape::footprint(&[[0.0, 0.0], [5.0, 0.5], [4.0, 3.0], [0.0, 4.0]], &[hole]).unwrap()
}

fn rect(axis: Axis, size: [f64; 3]) -> Shape {
    let mut shape = Shape::cuboid(1.0, 1.0, 1.0);
    (shape.scope.size, shape.geometry) = (DVec3::from_array(size), Geometry::Rect(axis, UnitMesh::rectangle(axis)));
    shape
}

/// Shapes of every kind.
fn kinds() -> Vec<(&'static str, Shape)> {
    let env = &mut Env::for_tests();
    let mut body = with_hole();
    extrude(env, &mut body, Length::Absolute(3.0));
    let mut round = Shape::cuboid(2.0, 3.0, 4.0);
    cone(env, &mut round, 5.0);
    let (mut mirrored, mut inside_out) = (round.clone(), Shape::cuboid(2.0, 3.0, 4.0));
    mirrored.resize(DVec3::new(-2.0, 3.0, -1.0));
    inside_out.resize(DVec3::new(2.0, -3.0, 4.0));
    // As after a split with `noAdjust`: larger than its geometry.
    let mut loose = round.clone();
    if let Geometry::Mesh(placed) = &mut loose.geometry {
        let placed = Arc::make_mut(placed);
        *placed = Placed { low: placed.low - 0.5, size: placed.size + 2.0, ..placed.clone() };
    }
    let mut thick = with_hole();
    thick.scope.size.y = 2.0;
    vec![
        ("box", Shape::cuboid(2.0, 3.0, 4.0)),
        ("lot", Shape::rectangle(5.0, 3.0)),
        ("façade", rect(Axis::Z, [4.0, 3.0, 0.0])),
        ("side", rect(Axis::X, [0.0, 3.0, 2.0])),
        ("thick rectangle", rect(Axis::Z, [4.0, 3.0, 2.0])),
        ("mirrored rectangle", rect(Axis::Y, [-4.0, 0.0, 2.0])),
        ("mirrored box", inside_out),
        ("body", body),
        ("round", round),
        ("mirrored round", mirrored),
        ("loose", loose),
        ("flat", with_hole()),
        ("thick and flat", thick),
    ]
}

/// All kinds, straight and turned.
fn shapes() -> Vec<(String, Shape)> {
    let turns = [[0.0, 0.0, 0.0], [0.0, 90.0, 0.0], [90.0, 0.0, 180.0], [20.0, 30.0, 40.0]];
    let each = kinds().into_iter().flat_map(|(name, shape)| {
        turns.map(|[x, y, z]| {
            let (env, mut turned) = (&mut Env::for_tests(), shape.clone().at([1.0, 2.0, 3.0]));
            rotate(env, &mut turned, x, y, z);
            (format!("{name} turned by {x} {y} {z}"), turned)
        })
    });
    each.collect()
}

const ALL_AXES: [AlignAxes; 8] = [
    AlignAxes::WorldX,
    AlignAxes::WorldY,
    AlignAxes::WorldZ,
    AlignAxes::WorldXyz,
    AlignAxes::ObjectX,
    AlignAxes::ObjectY,
    AlignAxes::ObjectZ,
    AlignAxes::ObjectXyz,
];
const ALL_BOXES: [BoxAxes; 6] = [BoxAxes::Xy, BoxAxes::Yx, BoxAxes::Xz, BoxAxes::Zx, BoxAxes::Yz, BoxAxes::Zy];
const MAPS: [AxisMap; 3] = [AxisMap::Xyz, AxisMap::Yzx, AxisMap::Zxy];

#[test]
fn alignment_moves_no_geometry_and_fits_the_scope() {
    for (name, start) in shapes() {
        let before = world(&start);
        let check = |what: String, change: &dyn Fn(&mut Env, &mut Shape)| {
            let (env, mut shape) = (&mut Env::for_tests(), start.clone());
            change(env, &mut shape);
            let what = format!("{name}: {what}");
            same(&before, &world(&shape), &what);
            sound(&shape, true, &what);
            assert!(0.0 <= shape.scope.size.min_element(), "{what}");
            assert!(env.take_faults().0.is_empty(), "{what}");
            shape
        };
        for axes in ALL_AXES {
            let shape = check(format!("{axes:?}"), &|env, shape| align_to_axes(env, shape, axes));
            assert_eq!(shape.pivot, shape.scope.frame());
        }
        for axes in ALL_BOXES {
            let shape = check(format!("{axes:?}"), &|env, shape| align_to_box(env, shape, axes));
            assert_eq!(shape.pivot, shape.scope.frame());
        }
        for angles in [[0.0, 0.0, 0.0], [0.0, 0.0, 90.0], [30.0, -200.0, 7.0]] {
            let [x, y, z] = angles;
            let shape = check(format!("{angles:?}"), &|env, shape| rotate_scope(env, shape, x, y, z));
            assert_eq!(shape.pivot, start.pivot);
            let turned = start.pivot.axes * turn(x, y, z) * start.pivot.axes.transpose() * start.scope.axes;
            assert!(shape.scope.axes.abs_diff_eq(turned, 1e-12));
        }
        for up in [UpAxis::YUp, UpAxis::ZUp] {
            for face in [AlignFace::WorldLowest, AlignFace::Largest, AlignFace::Any] {
                for edge in [AlignEdge::WorldLowest, AlignEdge::Longest] {
                    let what = format!("{up:?} {face:?} {edge:?}");
                    check(what, &|env, shape| align_to_selected(env, shape, up, face, edge));
                }
            }
            check(format!("{up:?} auto"), &|env, shape| align_to_auto(env, shape, up, AlignAuto::Auto));
            for (face, edge) in [(0.0, 0.0), (-1.0, -1.0), (7.0, 9.0)] {
                let shape = check(format!("{face} {edge}"), &|env, shape| align_to_indices(env, shape, up, face, edge));
                // The edge starts at the pivot and runs along x.
                let mesh = start.to_mesh();
                let ring = mesh.face((face as isize).rem_euclid(mesh.face_count() as isize) as usize);
                let loops = &before[..];
                let first = mesh.faces().take(ring.index()).map(|face| face.loops().len()).sum::<usize>();
                let edges: Vec<[DVec3; 2]> = loops[first..first + ring.loops().len()]
                    .iter()
                    .flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]).collect::<Vec<_>>())
                    .collect();
                let [a, b] = edges[(edge as isize).rem_euclid(edges.len() as isize) as usize];
                assert!((shape.pivot.origin - a).length() < 1e-9 && shape.pivot.axes == shape.scope.axes);
                assert!(((b - a).normalize() - shape.scope.axes.x_axis).length() < 1e-9);
            }
        }
    }
}

#[test]
fn other_corners_and_mirrored_scopes_move_no_geometry() {
    for (name, start) in shapes() {
        let before = world(&start);
        for map in MAPS {
            for corner in 0..8 {
                let (env, mut shape) = (&mut Env::for_tests(), start.clone());
                set_pivot(env, &mut shape, map, f64::from(corner));
                let what = format!("{name}: {map:?} {corner}");
                same(&before, &world(&shape), &what);
                sound(&shape, false, &what);
                assert_eq!(shape.pivot, shape.scope.frame());
                assert!(env.take_faults().0.is_empty());
            }
        }
        for flips in 0..8 {
            let (env, mut shape) = (&mut Env::for_tests(), start.clone());
            let [x, y, z] = [1, 2, 4].map(|bit| flips & bit != 0);
            mirror_scope(env, &mut shape, x, y, z);
            let what = format!("{name}: mirrored {x} {y} {z}");
            same(&before, &world(&shape), &what);
            sound(&shape, false, &what);
            assert_eq!((shape.pivot, shape.scope.axes), (start.pivot, start.scope.axes));
            let old = start.scope.size;
            let signs = [x, y, z].map(|flip| if flip { -1.0 } else { 1.0 });
            assert_eq!(shape.scope.size, old * DVec3::from_array(signs));
            assert!((shape.scope.centre() - start.scope.centre()).length() < 1e-12);
            // A second call restores the shape.
            mirror_scope(env, &mut shape, x, y, z);
            assert!((shape.scope.origin - start.scope.origin).length() < 1e-12 && shape.scope.size == old);
            same(&before, &world(&shape), &what);
        }
    }
}

#[test]
fn the_axes_at_the_corners_are_those_of_the_pictures() {
    // *setPivot operation*: for each corner its place and the axes there, for `xyz`.
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let table = [
        ([0.0, 0.0, 0.0], [x, y, z]),
        ([1.0, 0.0, 0.0], [z, y, -x]),
        ([1.0, 0.0, 1.0], [-x, y, -z]),
        ([0.0, 0.0, 1.0], [-z, y, x]),
        ([0.0, 1.0, 0.0], [z, -y, x]),
        ([1.0, 1.0, 0.0], [-x, -y, z]),
        ([1.0, 1.0, 1.0], [-z, -y, -x]),
        ([0.0, 1.0, 1.0], [x, -y, -z]),
    ];
    for (corner, (place, [x, y, z])) in table.into_iter().enumerate() {
        for (map, axes) in MAPS.into_iter().zip([[x, y, z], [z, x, y], [y, z, x]]) {
            let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(2.0, 3.0, 4.0).at([5.0, 6.0, 7.0]));
            set_pivot(env, shape, map, corner as f64);
            let [x, y, z] = axes;
            assert_eq!(shape.scope.axes, DMat3::from_cols(x, y, z), "{map:?} {corner}");
            let size = DVec3::new(2.0, 3.0, 4.0);
            assert_eq!(shape.scope.origin, DVec3::new(5.0, 6.0, 7.0) + size * DVec3::from_array(place));
            assert_eq!(shape.scope.size, DVec3::from_array(axes.map(|axis| axis.abs().dot(size))));
            assert_eq!((crate::query::get::scope_tx(shape), crate::query::get::scope_rx(shape)), (0.0, 0.0));
        }
    }
    let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(2.0, 3.0, 4.0));
    let before = (shape.scope, shape.pivot);
    for odd in [-1.0, 8.0, 0.5, 1e300] {
        set_pivot(env, shape, AxisMap::Xyz, odd);
        assert_eq!((env.take_faults().0.len(), (shape.scope, shape.pivot)), (1, before));
    }
}

#[test]
fn boxes_and_rectangles_stay_what_they_are_where_they_can() {
    let env = &mut Env::for_tests();
    let shape = &mut Shape::cuboid(2.0, 3.0, 4.0).at([1.0, 2.0, 3.0]);
    set_pivot(env, shape, AxisMap::Xyz, 0.0);
    align_to_axes(env, shape, AlignAxes::WorldXyz);
    align_to_axes(env, shape, AlignAxes::ObjectY);
    align_to_geometry_of(env, shape);
    align_to_box(env, shape, BoxAxes::Zx);
    rotate_scope(env, shape, 0.0, 0.0, 0.0);
    mirror(env, shape, true, false, false);
    assert!(matches!(shape.geometry, Geometry::Box(_)) && shape.scope.size == DVec3::new(2.0, 3.0, 4.0));
    let wall = &mut rect(Axis::Z, [4.0, 3.0, 0.0]);
    rotate(env, wall, 0.0, 30.0, 0.0);
    align_to_axes(env, wall, AlignAxes::WorldY);
    align_to_geometry_of(env, wall);
    mirror(env, wall, true, false, false);
    assert!(matches!(wall.geometry, Geometry::Rect(Axis::Z, _)));
    // On its back: the same rectangle, looking along y.
    align_to_indices(env, wall, UpAxis::YUp, 0.0, 0.0);
    assert!(matches!(wall.geometry, Geometry::Rect(Axis::Y, _)));
    assert!((wall.scope.size - DVec3::new(4.0, 0.0, 3.0)).length() < 1e-12);
    assert!(env.take_faults().0.is_empty());
}

/// Aligns to the first edge of the first face, in its direction.
fn align_to_geometry_of(env: &mut Env, shape: &mut Shape) {
    align_to_indices(env, shape, UpAxis::ZUp, 0.0, 0.0);
}

#[test]
fn the_scope_of_a_turned_box_is_upright_again() {
    // *alignScopeToAxes operation*, its example: the pivot is at the corner, with and without `y`.
    for (axes, expected) in [(AlignAxes::WorldXyz, None), (AlignAxes::WorldY, Some(()))] {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(8.0, 24.0, 8.0).at([5.0, 0.0, 4.0]));
        rotate(env, shape, 10.0, 20.0, 30.0);
        let x = shape.scope.axes.x_axis;
        align_to_axes(env, shape, axes);
        let x = if expected.is_some() { x.with_y(0.0).normalize() } else { DVec3::X };
        assert!(shape.scope.axes.abs_diff_eq(DMat3::from_cols(x, DVec3::Y, x.cross(DVec3::Y)), 1e-12));
        assert_eq!(crate::query::get::scope_ty(shape), 0.0);
    }
    // The projection fails, as the old x is along the axis.
    for (axes, angles) in [
        (AlignAxes::WorldY, [0.0, 0.0, 90.0]),
        (AlignAxes::WorldX, [0.0, 90.0, 0.0]),
        (AlignAxes::WorldZ, [0.0, -90.0, 0.0]),
    ] {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 2.0, 3.0));
        rotate(env, shape, angles[0], angles[1], angles[2]);
        let before = world(shape);
        align_to_axes(env, shape, axes);
        sound(shape, true, "upright");
        same(&before, &world(shape), "upright");
    }
}

#[test]
fn a_scope_turned_with_its_geometry_left_flat_has_no_size_there() {
    // *primitiveQuad operation*, its examples: `rotateScope(0, 0, 90)` on a lot leaves no size along x.
    for (angles, flat) in [([0.0, 0.0, 90.0], 0), ([-90.0, 0.0, 0.0], 2)] {
        for mut lot in [Shape::rectangle(27.0, 19.0), with_hole()] {
            let env = &mut Env::for_tests();
            rotate(env, &mut lot, 0.0, 33.0, 0.0);
            lot.pivot = lot.scope.frame();
            rotate_scope(env, &mut lot, angles[0], angles[1], angles[2]);
            assert_eq!(lot.scope.size[flat], 0.0);
            quad_sized(env, &mut lot, 10.0, 2.0);
            assert_eq!((lot.scope.size[flat], lot.to_mesh().face(0).normal()[flat]), (0.0, 1.0));
        }
    }
}

#[test]
fn edges_and_faces_are_found_by_words() {
    let env = &mut Env::for_tests();
    // A ramp: its lowest edge is the third.
    let ramp =
        [[0.0, 2.0, 0.0], [0.0, 2.0, 4.0], [0.0, 0.0, 4.0], [0.0, 0.0, 0.0]].map(|[z, y, x]| DVec3::new(x, y, z + y));
    let shape = &mut Shape::mesh_axis_aligned(Mesh::from_polygon(&ramp, &[]).unwrap());
    let normal = shape.to_mesh().face(0).normal();
    align_to_selected(env, shape, UpAxis::ZUp, AlignFace::Any, AlignEdge::WorldLowest);
    assert!((shape.scope.axes.z_axis - normal).length() < 1e-12 && 0.5 < shape.scope.axes.y_axis.y, "y goes up");
    assert_eq!((shape.pivot.origin, shape.scope.size.z), (ramp[2], 0.0));
    // The largest face of a box, its longest edge. The lowest face is the bottom, although the sides reach as low.
    let shape = &mut Shape::cuboid(2.0, 3.0, 9.0);
    align_to_selected(env, shape, UpAxis::YUp, AlignFace::Largest, AlignEdge::Longest);
    assert_eq!((shape.scope.axes.y_axis, shape.scope.axes.x_axis.abs()), (DVec3::X, DVec3::Z));
    let shape = &mut Shape::cuboid(2.0, 3.0, 9.0);
    align_to_face(env, shape, UpAxis::YUp, AlignFace::WorldLowest, 0.0);
    assert_eq!(shape.scope.axes.y_axis, DVec3::NEG_Y);
    align_to_edge(env, shape, UpAxis::ZUp, -2.0, AlignEdge::WorldLowest);
    assert_eq!(shape.scope.axes.z_axis, DVec3::Y);
    // Of several equally low edges the first; in the old form the longest.
    let shape = &mut Shape::cuboid(2.0, 3.0, 9.0);
    align_to_selected(env, shape, UpAxis::ZUp, AlignFace::Any, AlignEdge::WorldLowest);
    assert_eq!(shape.scope.size.to_array(), [2.0, 3.0, 9.0]);
    align_to_auto(env, shape, UpAxis::ZUp, AlignAuto::Auto);
    assert_eq!(shape.scope.size.to_array(), [9.0, 3.0, 2.0]);
    assert!(env.take_faults().0.is_empty());
    align_to_indices(env, shape, UpAxis::ZUp, 0.5, f64::NAN);
    assert_eq!(env.take_faults().0.len(), 2);
}

#[test]
fn the_smallest_rectangle_has_its_longer_side_along_the_first_axis() {
    for (turned, axes, size) in [
        (0.0, BoxAxes::Xz, [7.0, 1.0, 2.0]),
        (33.0, BoxAxes::Xz, [7.0, 1.0, 2.0]),
        (33.0, BoxAxes::Zx, [2.0, 1.0, 7.0]),
        (-77.0, BoxAxes::Zx, [2.0, 1.0, 7.0]),
    ] {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(7.0, 1.0, 2.0));
        rotate(env, shape, 0.0, turned, 0.0);
        align_to_axes(env, shape, AlignAxes::WorldXyz);
        align_to_box(env, shape, axes);
        assert!((shape.scope.size - DVec3::from_array(size)).length() < 1e-9, "{axes:?} {}", shape.scope.size);
        assert_eq!(shape.scope.axes.y_axis, DVec3::Y);
    }
    // No rectangle at other angles is smaller.
    let (env, mut shape) = (&mut Env::for_tests(), with_hole());
    align_to_axes(env, &mut shape, AlignAxes::WorldXyz);
    align_to_box(env, &mut shape, BoxAxes::Xz);
    let area = shape.scope.size.x * shape.scope.size.z;
    for angle in 0..180 {
        let mut other = shape.clone();
        rotate_scope(env, &mut other, 0.0, f64::from(angle), 0.0);
        assert!(area <= other.scope.size.x * other.scope.size.z * (1.0 + 1e-12));
    }
}

#[test]
fn shapes_without_faces_have_scopes_too() {
    let env = &mut Env::for_tests();
    let line = || Shape::line([1.0, 2.0, 3.0], [4.0, 6.0, 3.0]).unwrap();
    let mut shape = line();
    align_to_axes(env, &mut shape, AlignAxes::WorldXyz);
    assert!((shape.scope.size - DVec3::new(3.0, 4.0, 0.0)).length() < 1e-12);
    assert!((shape.scope.origin - DVec3::new(1.0, 2.0, 3.0)).length() < 1e-12);
    let mut shape = line();
    rotate_scope(env, &mut shape, 0.0, 0.0, 0.0);
    align_to_geometry_of(env, &mut shape);
    assert!(matches!(shape.geometry, Geometry::Edge) && shape.scope.size.x == 5.0);
    // Lines along other axes are still lines, with their ends at the same places in the world.
    let ends = |shape: &Shape| match &shape.geometry {
        Geometry::Wire(placed) => {
            let wire = placed.in_scope(shape.scope.size);
            wire.ends(0).map(|end| shape.scope.frame().to_world(end))
        }
        other => panic!("{other:?}"),
    };
    let steps: [&Step; 6] = [
        &|env, shape| set_pivot(env, shape, AxisMap::Xyz, 2.0),
        &|env, shape| align_to_axes(env, shape, AlignAxes::WorldXyz),
        &|env, shape| mirror_scope(env, shape, true, false, true),
        &|env, shape| set_pivot(env, shape, AxisMap::Zxy, 5.0),
        &|env, shape| align_to_box(env, shape, BoxAxes::Yx),
        &|env, shape| rotate_scope(env, shape, 10.0, 20.0, 30.0),
    ];
    for (number, step) in steps.iter().enumerate() {
        step(env, &mut shape);
        let [from, to] = ends(&shape);
        let near = (from - DVec3::new(1.0, 2.0, 3.0)).length() + (to - DVec3::new(4.0, 6.0, 3.0)).length();
        assert!(near < 1e-9, "step {number}: {from} {to}");
        sound(&shape, false, "a line");
    }
    mirror(env, &mut shape, true, true, true);
    assert!((ends(&shape)[0] - DVec3::new(4.0, 6.0, 3.0)).length() < 1e-9);
    let mut point = Shape::point([1.0, 2.0, 3.0]);
    rotate(env, &mut point, 10.0, 20.0, 30.0);
    align_to_axes(env, &mut point, AlignAxes::WorldXyz);
    align_to_box(env, &mut point, BoxAxes::Xy);
    mirror_scope(env, &mut point, true, true, true);
    mirror(env, &mut point, true, true, true);
    reverse_normals(env, &mut point);
    assert!(matches!(point.geometry, Geometry::Vertex));
    assert_eq!((point.scope.origin, point.scope.axes), (DVec3::new(1.0, 2.0, 3.0), DMat3::IDENTITY));
    assert!(env.take_faults().0.is_empty());
}

#[test]
fn mirrored_geometry_stays_in_its_scope_and_looks_outwards() {
    for (name, start) in shapes() {
        for flips in 0..8 {
            let (env, mut shape) = (&mut Env::for_tests(), start.clone());
            let [x, y, z] = [1, 2, 4].map(|bit| flips & bit != 0);
            mirror(env, &mut shape, x, y, z);
            let what = format!("{name}: {x} {y} {z}");
            assert_eq!((shape.scope, shape.pivot), (start.scope, start.pivot));
            sound(&shape, false, &what);
            let (old, new) = (start.to_mesh(), shape.to_mesh());
            assert!((old.volume() - new.volume()).abs() < 1e-9 && old.face_count() == new.face_count(), "{what}");
            // Every point is the mirror image of an old one.
            let image = |p: &DVec3| {
                DVec3::from_array(
                    [0, 1, 2].map(|axis| if [x, y, z][axis] { shape.scope.size[axis] - p[axis] } else { p[axis] }),
                )
            };
            assert!(
                new.points().iter().all(|p| old.points().iter().any(|q| (image(p) - *q).length() < 1e-9)),
                "{what}"
            );
            // Faces look in the mirrored directions: a flat one that is reversed looks back.
            if old.face_count() == 1 {
                let normal =
                    old.face(0).normal() * DVec3::from_array([x, y, z].map(|flip| if flip { -1.0 } else { 1.0 }));
                assert!((new.face(0).normal() - normal).length() < 1e-9, "{what}");
            }
        }
    }
}

#[test]
fn faces_turned_over_keep_their_first_edge() {
    for (name, start) in shapes() {
        let (env, mut shape) = (&mut Env::for_tests(), start.clone());
        reverse_normals(env, &mut shape);
        assert_eq!((shape.scope, shape.pivot), (start.scope, start.pivot));
        let (before, after) = (world(&start), world(&shape));
        for (old, new) in before.iter().zip(&after) {
            // *reverseNormals operation*: 0 1 2 3 becomes 1 0 3 2.
            assert!((old[0] - new[1]).length() < 1e-9 && (old[1] - new[0]).length() < 1e-9, "{name}");
            assert!((old[2] - new[new.len() - 1]).length() < 1e-9);
        }
        assert!((start.to_mesh().volume() + shape.to_mesh().volume()).abs() < 1e-9 || !start.to_mesh().is_closed());
        reverse_normals(env, &mut shape);
        same(&before, &world(&shape), &name);
    }
}

#[test]
fn numbers_beyond_all_bounds_leave_the_shape_as_it_is() {
    for huge in [1e200, 1e308] {
        for start in [Shape::cuboid(huge, huge, huge), Shape::rectangle(huge, 1.0)] {
            for odd in [f64::NAN, f64::INFINITY, 45.0] {
                let (env, mut shape) = (&mut Env::for_tests(), start.clone());
                rotate_scope(env, &mut shape, odd, 30.0, odd);
                align_to_axes(env, &mut shape, AlignAxes::WorldXyz);
                align_to_box(env, &mut shape, BoxAxes::Yx);
                align_to_selected(env, &mut shape, UpAxis::YUp, AlignFace::Largest, AlignEdge::Longest);
                set_pivot(env, &mut shape, AxisMap::Yzx, 6.0);
                mirror_scope(env, &mut shape, true, true, true);
                mirror(env, &mut shape, false, true, false);
                assert!(shape.scope.size.is_finite() && shape.scope.origin.is_finite());
                assert!(shape.scope.axes.is_finite() && shape.pivot.origin.is_finite() && shape.pivot.axes.is_finite());
            }
        }
    }
}
