//! Laws of measurement on random shapes, and documented behaviour.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::*;
use crate::geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use crate::geometry::rotation::turn;
use crate::geometry::{Axis, Frame, work};
use crate::op::{self, Length::Absolute, rotate};
use crate::run::env::Env;
use crate::run::settings::Settings;
use crate::shape::scope::Scope;
use crate::shape::seed::Seed;
use crate::shape::unit::UnitMesh;
use crate::shape::{Geometry, Inserted, Placed, Shape};
use crate::value::array::Array;

const SELECTORS: [Word; 28] = [
    Word::All,
    Word::Front,
    Word::Back,
    Word::Left,
    Word::Right,
    Word::Top,
    Word::Bottom,
    Word::Side,
    Word::ObjectFront,
    Word::ObjectBack,
    Word::ObjectLeft,
    Word::ObjectRight,
    Word::ObjectTop,
    Word::ObjectBottom,
    Word::ObjectSide,
    Word::WorldSouth,
    Word::WorldNorth,
    Word::WorldWest,
    Word::WorldEast,
    Word::WorldUp,
    Word::WorldDown,
    Word::WorldSide,
    Word::StreetFront,
    Word::StreetBack,
    Word::StreetLeft,
    Word::StreetRight,
    Word::StreetSide,
    Word::NotStreetFront,
];

const ANGLES: [AngleType; 3] = [AngleType::MaxSlope, AngleType::Azimuth, AngleType::Zenith];

/// Half of the numbers are small integers, also negative ones and sometimes zero.
fn number(seed: &mut Seed) -> f64 {
    let value = 20.0 * seed.draw() - 10.0;
    if seed.draw() < 0.5 { value.round() } else { value }
}

fn point(seed: &mut Seed) -> DVec3 {
    DVec3::new(number(seed), number(seed), number(seed))
}

fn random_scope(seed: &mut Seed) -> Scope {
    let axes = turn(360.0 * seed.draw(), 360.0 * seed.draw(), 360.0 * seed.draw());
    Scope { origin: point(seed), axes, size: point(seed) }
}

/// The same shape with a mesh as its geometry.
fn meshed(shape: &Shape) -> Shape {
    let mut other = shape.clone();
    other.geometry = Geometry::Mesh(Arc::new(Placed {
        mesh: shape.to_mesh(),
        low: DVec3::ZERO,
        size: shape.scope.size,
        inserted: Inserted::No,
        mirrored: shape.looks_inwards(),
    }));
    other
}

/// All numbers that functions return for a shape.
fn measures(env: &mut Env, shape: &Shape) -> Vec<f64> {
    let flag = |truth: bool| f64::from(u8::from(truth));
    let mut list: Vec<f64> = SELECTORS.iter().map(|&selector| geometry_area(env, shape, selector)).collect();
    list.extend(SELECTORS.iter().map(|&selector| flag(geometry_is_oriented(env, shape, selector))));
    list.extend(ANGLES.iter().map(|&angle| geometry_angle(shape, angle)));
    let plain: [fn(&crate::shape::Shape) -> f64; 7] = [
        |s| geometry_volume(s),
        |s| geometry_height(s),
        |s| geometry_boundary_length(s),
        |s| geometry_n_vertices(s),
        |s| geometry_n_edges(s),
        |s| geometry_n_faces(s),
        |s| geometry_n_holes(s),
    ];
    list.extend(plain.iter().map(|function| function(shape)));
    list.push(flag(geometry_is_concave(shape)));
    list.push(flag(geometry_is_closed_surface(shape)));
    for tolerance in [-1.0, 0.0, 0.25, 100.0] {
        list.push(flag(geometry_is_rectangular(env, shape, tolerance)));
        list.push(flag(geometry_is_planar(env, shape, tolerance)));
    }
    list
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * (1.0 + a.abs().max(b.abs()))
}

/// A courtyard house: a concave footprint with a hole, 10 m high. The footprint has the area 100 - 16 - 4.
fn courtyard() -> Mesh {
    let on = |list: &[(f64, f64)]| list.iter().map(|&(x, z)| DVec3::new(x, 0.0, -z)).collect::<Vec<_>>();
    let outer = on(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (4.0, 10.0), (4.0, 6.0), (0.0, 6.0)]);
    let hole = on(&[(6.0, 2.0), (8.0, 2.0), (8.0, 4.0), (6.0, 4.0)]);
    let flat = Mesh::from_polygon(&outer, &[hole]).expect("a polygon");
    crate::geometry::extrude::extrude(&flat, crate::geometry::extrude::Extrude::FaceNormal, 10.0)
}

#[test]
fn boxes_and_rectangles_answer_as_their_meshes_do() {
    let (env, mut seed) = (&mut Env::for_tests(), Seed::new(3));
    env.initial.object = Frame { origin: DVec3::ONE, axes: turn(10.0, 20.0, 30.0) };
    for round in 0..600 {
        let scope = random_scope(&mut seed);
        // Rounding decides between two equally near directions. Turned scopes have no such ties.
        let scope = if round % 2 == 0 { Scope { axes: DMat3::IDENTITY, ..scope } } else { scope };
        for geometry in [Geometry::Empty, Geometry::Box(UnitMesh::cuboid())]
            .into_iter()
            .chain([Axis::X, Axis::Y, Axis::Z].map(|axis| Geometry::Rect(axis, UnitMesh::rectangle(axis))))
        {
            let mut shape = Shape::cuboid(1.0, 1.0, 1.0);
            (shape.scope, shape.geometry) = (scope, geometry);
            let mesh = meshed(&shape);
            let (plain, meshed) = (measures(env, &shape), measures(env, &mesh));
            let wrong = (0..plain.len()).find(|&at| !near(plain[at], meshed[at]));
            assert_eq!(wrong, None, "{shape:?}\n{plain:?}\n{meshed:?}");
        }
    }
    assert_eq!(env.take_faults().0.len(), 0);
}

#[test]
fn a_box_holds_the_product_of_its_sides() {
    let mut seed = Seed::new(4);
    for _ in 0..200 {
        let mut shape = Shape::cuboid(1.0, 1.0, 1.0);
        shape.scope = random_scope(&mut seed);
        let size = shape.scope.size;
        assert_eq!(geometry_volume(&shape), (size.x * size.y * size.z).abs());
    }
}

#[test]
fn turning_and_moving_change_no_measure_and_stretching_scales_it() {
    let (env, mut seed) = (&mut Env::for_tests(), Seed::new(5));
    let plain = Shape::mesh_axis_aligned(courtyard());
    let (area, volume) = (geometry_area(env, &plain, Word::All), geometry_volume(&plain));
    let walls = geometry_area(env, &plain, Word::Side);
    assert!(near(volume, 800.0) && near(area, 160.0 + 480.0) && near(walls, 480.0));
    assert!(geometry_is_concave(&plain) && geometry_is_closed_surface(&plain));
    for _ in 0..100 {
        let mut shape = plain.clone();
        let scope = random_scope(&mut seed);
        shape.set_scope(Scope { size: plain.scope.size, ..scope });
        assert!(near(geometry_area(env, &shape, Word::All), area));
        assert!(near(geometry_area(env, &shape, Word::Side), walls));
        assert!(near(geometry_volume(&shape), volume));
        let stretched = DVec3::new(scope.size.x, scope.size.y, scope.size.z);
        let times = stretched / plain.scope.size;
        shape.set_scope(Scope { size: stretched, ..scope });
        assert!(near(geometry_volume(&shape), (volume * times.x * times.y * times.z).abs()));
        let map = shape.scope.placement();
        let world = shape.to_mesh().map(&map);
        assert!(near(geometry_area(env, &shape, Word::All), world.area()));
        assert!(near(geometry_height(&shape), world.bounds().size().y));
    }
}

#[test]
fn a_prism_with_a_hole_is_counted() {
    let hole = vec![[4.0, 4.0], [6.0, 4.0], [5.0, 6.0]];
    let square = [[0.0, 0.0], [0.0, 10.0], [10.0, 10.0], [10.0, 0.0]];
    let (env, shape) = (&mut Env::for_tests(), &mut Shape::footprint(&square, &[hole]).expect("a footprint"));
    assert!(geometry_is_concave(shape) && !geometry_is_closed_surface(shape));
    assert_eq!((geometry_n_holes(shape), geometry_n_edges(shape)), (1.0, 7.0));
    let rim = 40.0 + 2.0 + 2.0 * 5.0f64.sqrt();
    assert!(near(geometry_boundary_length(shape), rim));
    op::extrude(env, shape, Absolute(10.0));
    let counts = (geometry_n_vertices(shape), geometry_n_faces(shape), geometry_n_holes(shape));
    assert_eq!(counts, (14.0, 9.0, 2.0));
    assert_eq!((geometry_n_edges(shape), geometry_boundary_length(shape)), (21.0, 0.0));
    assert!(near(geometry_volume(shape), 980.0) && geometry_is_closed_surface(shape));
}

#[test]
fn zenith_and_slope_make_a_right_angle() {
    let mut seed = Seed::new(6);
    for _ in 0..100 {
        let mut shape = Shape::rectangle(2.0, 3.0);
        shape.scope.axes = turn(360.0 * seed.draw(), 360.0 * seed.draw(), 360.0 * seed.draw());
        let [slope, azimuth, zenith] = ANGLES.map(|angle| geometry_angle(&shape, angle));
        assert_eq!(zenith, 90.0 - slope);
        assert!((0.0..=90.0).contains(&slope) && (0.0..360.0).contains(&azimuth));
    }
}

#[test]
fn azimuths_run_clockwise_from_the_north() {
    let env = &mut Env::for_tests();
    // A shape that looks up, then leans by 30 degrees towards a side.
    let leaned = |env: &mut Env, x: f64, z: f64| {
        let mut shape = Shape::rectangle(2.0, 3.0);
        rotate(env, &mut shape, x, 0.0, z);
        let [slope, azimuth, _] = ANGLES.map(|angle| geometry_angle(&shape, angle));
        assert!(near(slope, x.abs() + z.abs()), "{slope}");
        azimuth
    };
    let list = [(-30.0, 0.0), (0.0, -30.0), (30.0, 0.0), (0.0, 30.0)].map(|(x, z)| leaned(env, x, z));
    assert!(list.iter().zip([0.0, 90.0, 180.0, 270.0]).all(|(a, b)| near(*a, b)), "{list:?}");
    let flat = Shape::rectangle(2.0, 3.0);
    assert_eq!(ANGLES.map(|angle| geometry_angle(&flat, angle)), [0.0, 0.0, 90.0]);
    assert_eq!(geometry_angle(&Shape::cuboid(1.0, 2.0, 3.0), AngleType::MaxSlope), 90.0);
}

#[test]
fn selectors_follow_their_axes() {
    let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(2.0, 3.0, 5.0));
    let area = |env: &mut Env, shape: &Shape, selector| geometry_area(env, shape, selector);
    use Word as F;
    assert_eq!([F::Front, F::Right, F::Top, F::Side].map(|s| area(env, shape, s)), [6.0, 15.0, 10.0, 42.0]);
    // A quarter turn: faces in the direction of z now look east.
    shape.scope.axes = turn(0.0, 90.0, 0.0);
    assert_eq!([F::Front, F::WorldEast, F::WorldSouth].map(|s| area(env, shape, s)), [6.0, 6.0, 15.0]);
    env.initial.object.axes = turn(0.0, 90.0, 0.0);
    assert_eq!([F::ObjectFront, F::StreetFront, F::ObjectTop].map(|s| area(env, shape, s)), [6.0, 6.0, 10.0]);
    assert!(geometry_is_oriented(env, shape, F::WorldDown));
    let wall = &mut Shape::rectangle(4.0, 5.0);
    assert!(geometry_is_oriented(env, wall, F::Top) && !geometry_is_oriented(env, wall, F::Side));
    // *CGA changelog 2017.0*: front becomes back when the depth is negative.
    let mut builder = MeshBuilder::new();
    for quad in &crate::shape::filled_scope::cuboid(&Scope::new(DVec3::ONE), UnitMesh::cuboid()).faces()[..2] {
        let ring = quad.corners().map(|p| builder.point(p));
        builder.face(&ring, &[], FaceTag::PLAIN);
    }
    let mut corner = Shape::mesh_axis_aligned(builder.build().expect("front and right"));
    assert_eq!([F::Front, F::Back, F::Right].map(|s| area(env, &corner, s)), [1.0, 0.0, 1.0]);
    corner.set_scope(Scope::new(DVec3::new(1.0, 1.0, -1.0)));
    assert_eq!([F::Front, F::Back, F::Right].map(|s| area(env, &corner, s)), [0.0, 1.0, 1.0]);
}

#[test]
fn faces_are_concave_rectangular_and_planar_within_their_tolerance() {
    let env = &mut Env::for_tests();
    let polygon = |list: &[(f64, f64)]| {
        let points: Vec<DVec3> = list.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect();
        Shape::mesh_axis_aligned(Mesh::from_polygon(&points, &[]).expect("a polygon"))
    };
    let leaning = polygon(&[(0.0, 0.0), (10.0, 0.0), (10.5, 10.0), (0.5, 10.0)]);
    let off = libm::atan(0.05).to_degrees();
    assert!(!geometry_is_rectangular(env, &leaning, off - 1e-6) && geometry_is_rectangular(env, &leaning, off + 1e-6));
    assert!(!geometry_is_concave(&leaning) && geometry_is_planar(env, &leaning, 0.0));
    // A straight corner is neither a fifth angle nor a reflex corner.
    let straight = polygon(&[(0.0, 0.0), (0.1, 0.1), (0.3, 0.3), (0.0, 4.0)]);
    assert!(!geometry_is_concave(&straight) && geometry_is_planar(env, &straight, 0.0));
    assert!(geometry_is_concave(&polygon(&[(0.0, 0.0), (4.0, 0.0), (1.0, 1.0), (0.0, 4.0)])));
    let mut builder = MeshBuilder::new();
    let bent = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.1], [0.0, 1.0, 0.0]].map(|p| builder.point(p));
    builder.face(&bent, &[], FaceTag::PLAIN);
    let bent = Shape::mesh_axis_aligned(builder.build().expect("a face"));
    assert!(!geometry_is_planar(env, &bent, 1.0) && geometry_is_planar(env, &bent, 10.0));
    let mut flat = bent.clone();
    flat.set_scope(Scope { size: DVec3::new(1.0, 1.0, 0.0), ..flat.scope });
    assert!(geometry_is_planar(env, &flat, 0.0), "*CGA changelog 2024.1*: flattened by its scope");
    let nothing = Shape::mesh_axis_aligned(Mesh::default());
    assert!(!geometry_is_planar(env, &nothing, 1.0) && !geometry_is_rectangular(env, &nothing, 1.0));
    assert!(!geometry_is_closed_surface(&nothing) && !geometry_is_concave(&nothing));
    assert_eq!(env.take_faults().0.len(), 0);
    assert!(geometry_is_planar(env, &leaning, f64::NAN));
    assert_eq!(env.take_faults().0.len(), 1);
}

#[test]
fn an_edge_of_four_faces_closes_nothing() {
    let mut builder = MeshBuilder::new();
    let corner = |low: DVec3| Scope { origin: low, ..Scope::new(DVec3::ONE) };
    for low in [DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0)] {
        for quad in crate::shape::filled_scope::cuboid(&corner(low), UnitMesh::cuboid()).faces() {
            let ring = quad.corners().map(|p| builder.point(p));
            builder.face(&ring, &[], FaceTag::PLAIN);
        }
    }
    let two = Shape::mesh_axis_aligned(builder.build().expect("two boxes"));
    assert_eq!((geometry_n_vertices(&two), geometry_n_edges(&two)), (14.0, 23.0));
    assert!(!geometry_is_closed_surface(&two) && near(geometry_volume(&two), 2.0));
}

#[test]
fn names_are_those_that_faces_have() {
    let mut builder = MeshBuilder::new();
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|p| builder.point(p));
    for (group, material) in [(FaceTag::NONE, 1), (2, 1), (0, 0)] {
        builder.face(&points, &[], FaceTag { group, material, ..FaceTag::PLAIN });
    }
    builder.groups(["wall", "unused", "roof"].map(str::to_owned).to_vec());
    let named = |name: &str| crate::material::Material::with(|look| look.name = Some(name.into()));
    builder.materials([named("brick"), named("tile"), named("unused")]);
    let shape = Shape::mesh_axis_aligned(builder.build().expect("three faces"));
    let strings =
        |list: Array<crate::value::text::Text>| list.as_slice().iter().map(ToString::to_string).collect::<Vec<_>>();
    let env = &mut Env::for_tests();
    assert_eq!(strings(geometry_groups(env, &shape)), ["wall", "roof", ""]);
    assert_eq!(strings(geometry_materials(env, &shape)), ["brick", "tile"]);
    assert_eq!(strings(geometry_groups(env, &Shape::cuboid(1.0, 1.0, 1.0))), [""]);
    // *CGA changelog 2021.0*: the initial shape's name, until something is inserted.
    for start in [Shape::rectangle(2.0, 1.0), Shape::rectangle(2.0, 1.0).held_as_meshes(), shape] {
        let mut shape = start.named("Lot 7");
        let env = &mut Env::with_names(&Settings::default(), &[], &shape, "Init");
        assert_eq!(strings(geometry_groups(env, &shape)).last().map(String::as_str), Some("Lot 7"));
        op::extrude(env, &mut shape, Absolute(1.0));
        assert_eq!(strings(geometry_groups(env, &shape)).last().map(String::as_str), Some("Lot 7"));
        op::cube(env, &mut shape);
        assert_eq!(strings(geometry_groups(env, &shape)), [""]);
        op::cylinder(env, &mut shape);
        assert_eq!(strings(geometry_groups(env, &shape)), [""]);
    }
    assert_eq!(strings(geometry_materials(env, &Shape::mesh_axis_aligned(Mesh::default()))), [""; 0]);
}

#[test]
fn an_inserted_asset_is_an_instance_until_it_is_changed() {
    let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(2.0, 3.0, 5.0));
    assert!(!geometry_is_instanced(shape));
    op::cylinder(env, shape);
    assert!(geometry_is_instanced(shape));
    op::extrude(env, shape, Absolute(1.0));
    assert!(!geometry_is_instanced(shape));
}

type Step = fn(&mut Env, &mut crate::shape::Shape);

/// Operations that do not change geometry, then operations that do. Some insert other geometry.
const STEPS: [Step; 18] = [
    |env, shape| op::size(env, shape, Absolute(3.0), Absolute(2.0), Absolute(-1.0)),
    |env, shape| op::size(env, shape, Absolute(3.0), Absolute(0.0), Absolute(1.0)),
    |env, shape| op::rotate(env, shape, 0.0, 30.0, 0.0),
    |env, shape| op::rotate_scope(env, shape, 0.0, 90.0, 0.0),
    |env, shape| op::rotate_scope(env, shape, 90.0, 0.0, 0.0),
    |env, shape| op::rotate_scope(env, shape, 0.0, 20.0, 0.0),
    |env, shape| op::mirror_scope(env, shape, true, false, true),
    |env, shape| op::set_pivot(env, shape, op::AxisMap::Yzx, 3.0),
    |env, shape| op::mirror(env, shape, false, false, false),
    |env, shape| op::cube_sized(env, shape, 1.0, 2.0, 3.0),
    |env, shape| op::cube(env, shape),
    |env, shape| op::quad(env, shape),
    |env, shape| op::quad_sized(env, shape, 2.0, 1.0),
    |env, shape| op::disk(env, shape, 5.0),
    |env, shape| op::mirror(env, shape, true, false, false),
    |env, shape| op::reverse_normals(env, shape),
    |env, shape| op::extrude(env, shape, Absolute(1.0)),
    |env, shape| op::offset_selected(env, shape, -0.25, op::OffsetFaces::Inside),
];

#[test]
fn a_cube_and_a_quad_are_instances_until_they_are_changed() {
    let seed = &mut Seed::new(5);
    let (mut instances, mut others) = (0, 0);
    for _ in 0..2000 {
        let start = if seed.draw() < 0.5 { Shape::rectangle(4.0, 2.0) } else { Shape::cuboid(4.0, 3.0, 2.0) };
        let mut pair = [start.clone(), start.held_as_meshes()].map(|shape| {
            let env = Env::with_names(&Settings::default(), &[], &shape, "Init");
            (env, shape)
        });
        let mut inserted = false;
        for _ in 0..4 {
            let number = (seed.draw() * STEPS.len() as f64) as usize;
            inserted = match number {
                0..9 => inserted,
                9..14 => true,
                _ => false,
            };
            for (env, shape) in &mut pair {
                STEPS[number](env, shape);
                assert_eq!(geometry_is_instanced(shape), inserted, "{number}: {:?}", shape.geometry);
            }
            if inserted { instances += 1 } else { others += 1 }
        }
    }
    assert!(500 < instances && 500 < others, "{instances}, {others}");
}

#[test]
fn coordinates_go_from_system_to_system_and_back() {
    // *convert function*, its example: a turned lot whose scope is moved and turned.
    let mut shape = Shape::cuboid(1.0, 3.0, 1.0);
    let start = Frame { origin: DVec3::new(0.34, 0.0, 1.5), axes: turn(0.0, -46.540_214_537, 0.0) };
    (shape.pivot, shape.scope.origin, shape.scope.axes) =
        (start, start.to_world(DVec3::new(0.4, 0.0, -0.6)), start.axes);
    let env = &mut Env::with_names(&Settings::default(), &[], &shape, "Init");
    rotate(env, &mut shape, -10.0, 70.0, 0.0);
    let convert = |env: &mut Env, from, to, what, given| convert::convert_all(env, &shape, from, to, what, given);
    let close = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| near(*a, b));
    use ConvertWhat::{Orient, Pos};
    assert!(close(convert(env, System::Scope, System::Pivot, Pos, [0.0; 3]), [0.4, 0.0, -0.6]));
    assert!(close(convert(env, System::Scope, System::World, Orient, [0.0; 3]), [-10.0, 23.459_785_463, 0.0]));
    let systems = [System::Scope, System::Pivot, System::Object, System::World];
    let mut seed = Seed::new(8);
    for (from, to) in systems.iter().flat_map(|&from| systems.map(|to| (from, to))) {
        let position = point(&mut seed).to_array();
        let there = convert(env, from, to, Pos, position);
        assert!(close(convert(env, to, from, Pos, there), position));
        let angles = [30.0, -40.0, 50.0];
        let there = convert(env, from, to, Orient, angles);
        assert!(close(convert(env, to, from, Orient, there), angles));
    }
    let array = |list: &[f64]| Array::from(list.to_vec());
    let there = convert_array(env, &shape, System::Scope, System::Pivot, Pos, array(&[0.0, 0.0, 0.0]));
    assert_eq!(there.as_slice(), convert(env, System::Scope, System::Pivot, Pos, [0.0; 3]));
    assert_eq!(env.take_faults().0.len(), 0);
    for odd in [&[] as &[f64], &[1.0, 2.0], &[1.0, 2.0, 3.0, 4.0]] {
        assert_eq!(convert_array(env, &shape, System::World, System::World, Pos, array(odd)).len(), 3);
        assert_eq!(env.take_faults().0.len(), 1);
    }
    let y = super::convert(env, &shape, Axis::Y, System::Scope, System::World, Pos, 1.0, 2.0, 3.0);
    assert_eq!(y, convert(env, System::Scope, System::World, Pos, [1.0, 2.0, 3.0])[1]);
    assert_eq!(env.take_faults().0.len(), 0);
    assert_eq!(convert(env, System::Scope, System::Scope, Pos, [f64::NAN, 1.0, 2.0]), [0.0, 1.0, 2.0]);
    let far = convert(env, System::Scope, System::World, Pos, [f64::MAX; 3]);
    assert!(far.iter().all(|number| number.is_finite()) && !env.take_faults().0.is_empty());
}

/// Rules that read a large mesh again and again end with the run.
#[test]
fn a_run_that_was_stopped_reads_no_mesh() {
    let answers = |shape: &Shape, env: &mut Env| {
        let numbers = [
            geometry_n_vertices(shape),
            geometry_n_faces(shape),
            geometry_n_edges(shape),
            geometry_area(env, shape, Word::All),
            geometry_volume(shape),
            geometry_height(shape),
            geometry_du(env, shape, 0.0, TextureSpace::Uv),
            geometry_v_max(env, shape, 0.0),
        ];
        let truths = [
            geometry_has_uvs(env, shape),
            geometry_has_uv_set(env, shape, 0.0),
            geometry_is_closed_surface(shape),
            geometry_is_oriented(env, shape, Word::Side),
            !geometry_materials(env, shape).is_empty(),
        ];
        (numbers.map(|number| number != 0.0), truths)
    };
    let env = &mut Env::for_tests();
    let mut shape = Shape::cuboid(2.0, 2.0, 2.0);
    op::sphere_sides(env, &mut shape, 8.0, 4.0);
    assert_eq!(answers(&shape, env), ([true; 8], [true; 5]));
    let base = env.base(shape.clone());
    let _supervisor = work::Supervisor::new(|_| false);
    assert!(!work::ask());
    assert_eq!(answers(&shape, env), ([false; 8], [false; 5]));
    assert!(matches!(env.whole(&base.shape()).geometry, Geometry::Empty));
}
