use glam::{DAffine3, DMat3, DVec3};

use super::{EnvelopeAlong, envelope_all, envelope_edges, envelope_front};
use crate::geometry::mesh::Mesh;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::array::Array;

const NORMAL: EnvelopeAlong = EnvelopeAlong::Normal;

fn array(values: &[f64]) -> Array<f64> {
    Array::new(values.to_vec(), values.len(), 1)
}

/// The envelope of a shape, with a base height and an angle for each edge.
fn built(shape: &Shape, along: EnvelopeAlong, height: f64, sides: &[[f64; 2]]) -> Shape {
    let (bases, angles): (Vec<f64>, Vec<f64>) = sides.iter().map(|side| (side[0], side[1])).unzip();
    checked(shape, |env, shape| envelope_edges(env, shape, along, height, array(&bases), array(&angles)))
}

fn checked(shape: &Shape, build: impl FnOnce(&mut Env, &mut Shape)) -> Shape {
    let (env, mut made) = (&mut Env::for_tests(), shape.clone());
    build(env, &mut made);
    assert_eq!(env.take_faults().0, []);
    assert_eq!(made.pivot, shape.pivot);
    let mesh = made.to_mesh();
    assert!(mesh.check().is_empty(), "{:?}", mesh.check());
    assert!(mesh.is_closed(), "{mesh:?}");
    assert!(0.0 < mesh.volume());
    made
}

/// The faces with a tag.
fn tagged(shape: &Shape, tag: &str) -> Vec<usize> {
    let mesh = shape.to_mesh();
    let has = |face: usize| mesh.tag_sets()[mesh.face(face).tag().tags as usize].has(tag);
    (0..mesh.face_count()).filter(|&face| has(face)).collect()
}

fn counts(shape: &Shape) -> [usize; 5] {
    ["envelope.bottom", "envelope.side.base", "envelope.side.slope", "envelope.side.inner", "envelope.top"]
        .map(|tag| tagged(shape, tag).len())
}

fn volume(shape: &Shape) -> f64 {
    shape.to_mesh().volume()
}

fn area(shape: &Shape, face: usize) -> f64 {
    shape.to_mesh().face(face).area()
}

fn polygon(outline: &[(f64, f64)], holes: &[&[(f64, f64)]]) -> Shape {
    // Anticlockwise as seen from above, with y upwards in the list.
    let ring = |ring: &[(f64, f64)]| -> Vec<DVec3> { ring.iter().map(|&(x, y)| DVec3::new(x, 0.0, -y)).collect() };
    let holes: Vec<Vec<DVec3>> = holes.iter().map(|hole| ring(hole)).collect();
    Shape::mesh_axis_aligned(Mesh::from_polygon(&ring(outline), &holes).expect("a polygon"))
}

const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
/// Clockwise.
const HOLE: [(f64, f64); 4] = [(3.0, 3.0), (3.0, 7.0), (7.0, 7.0), (7.0, 3.0)];
const L: [(f64, f64); 6] = [(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (5.0, 5.0), (5.0, 10.0), (0.0, 10.0)];

#[test]
fn a_slope_from_the_front_rises_to_the_back() {
    // 15 metres at the front, 15 + 30 tan 30 at the back.
    let lot = polygon(&[(0.0, 0.0), (20.0, 0.0), (20.0, 30.0), (0.0, 30.0)], &[]);
    let shape = checked(&lot, |env, shape| envelope_front(env, shape, NORMAL, 50.0, 15.0, 30.0));
    assert_eq!(counts(&shape), [1, 4, 1, 0, 0]);
    let rise = 30.0 * libm::tan(30f64.to_radians());
    assert!((shape.scope.size.y - (15.0 + rise)).abs() < 1e-9);
    assert!((volume(&shape) - 600.0 * (15.0 + rise / 2.0)).abs() < 1e-6);
}

#[test]
fn four_equal_sides_leave_a_top() {
    // All four sides have a base of 2 and 45 degrees, which moves the edges of the top inwards by 2.
    let lot = polygon(&SQUARE, &[]);
    let shape = checked(&lot, |env, shape| {
        envelope_all(env, shape, NORMAL, 4.0, 2.0, 45.0, 2.0, 45.0, 2.0, 45.0, 2.0, 45.0);
    });
    assert_eq!(counts(&shape), [1, 4, 4, 0, 1]);
    assert!((area(&shape, tagged(&shape, "envelope.top")[0]) - 36.0).abs() < 1e-9);
    assert_eq!(tagged(&shape, "envelope.side").len(), 8);
    // A frustum of 2 metres over a box.
    let expected = 200.0 + 2.0 / 3.0 * (100.0 + 36.0 + 60.0);
    assert!((volume(&shape) - expected).abs() < 1e-9);
    // Every slope begins with its lowest edge.
    let mesh = shape.to_mesh();
    for face in tagged(&shape, "envelope.side.slope") {
        let ring = mesh.face(face).outer();
        let low = |k: usize| mesh.points()[ring[k] as usize].y;
        assert!((low(0) - 2.0).abs() < 1e-12 && (low(1) - 2.0).abs() < 1e-12);
    }
    // Bases stand on the bottom, and begin there.
    for (edge, face) in tagged(&shape, "envelope.side.base").into_iter().enumerate() {
        let ring = mesh.face(face).outer();
        assert_eq!([0, 1].map(|k| mesh.points()[ring[k] as usize].y), [0.0, 0.0], "{edge}");
    }
}

#[test]
fn sides_without_numbers_are_upright() {
    // The *envelope* page: missing elements are 0 and 90.
    let shape = built(&polygon(&SQUARE, &[]), NORMAL, 6.0, &[]);
    assert_eq!(counts(&shape), [1, 4, 0, 0, 1]);
    assert!((volume(&shape) - 600.0).abs() < 1e-9);
    let shape = built(&polygon(&SQUARE, &[]), NORMAL, 6.0, &[[2.0, 45.0]]);
    assert_eq!(counts(&shape), [1, 4, 1, 0, 1]);
    assert!((volume(&shape) - (600.0 - 10.0 * 8.0)).abs() < 1e-9);
}

#[test]
fn a_lower_slope_cuts_into_a_higher_base() {
    // The front begins at 1, the right side at 4: its base has a slanted corner and five edges.
    let shape = built(&polygon(&SQUARE, &[]), NORMAL, 8.0, &[[1.0, 45.0], [4.0, 45.0]]);
    let mesh = shape.to_mesh();
    let bases = tagged(&shape, "envelope.side.base");
    assert_eq!(mesh.face(bases[1]).outer().len(), 5);
    assert_eq!(mesh.face(bases[0]).outer().len(), 4);
}

#[test]
fn without_a_base_the_slope_begins_at_the_ground() {
    // The other three sides keep their bases.
    let shape = built(&polygon(&SQUARE, &[]), NORMAL, 4.0, &[[0.0, 45.0], [2.0, 45.0], [2.0, 45.0], [2.0, 45.0]]);
    assert_eq!(counts(&shape), [1, 3, 4, 0, 1]);
    let mesh = shape.to_mesh();
    let slope = mesh.face(tagged(&shape, "envelope.side.slope")[0]);
    assert_eq!([0, 1].map(|k| mesh.points()[slope.outer()[k] as usize].y), [0.0, 0.0]);
}

#[test]
fn holes_have_upright_walls_and_notch_the_slopes() {
    // The walls of the hole go up to the top.
    let lot = polygon(&SQUARE, &[&HOLE]);
    let shape = built(&lot, NORMAL, 4.0, &[[2.0, 45.0]; 8]);
    assert_eq!(counts(&shape), [1, 4, 4, 4, 1]);
    let expected = 200.0 + 2.0 / 3.0 * (100.0 + 36.0 + 60.0) - 16.0 * 4.0;
    assert!((volume(&shape) - expected).abs() < 1e-9);
    // From the front a slope of 30 degrees reaches beyond the hole.
    let shape = built(&lot, NORMAL, 5.0, &[[0.0, 30.0]]);
    let slope = tagged(&shape, "envelope.side.slope");
    let mesh = shape.to_mesh();
    assert_eq!((slope.len(), tagged(&shape, "envelope.side.inner").len()), (1, 4));
    assert_eq!(mesh.face(slope[0]).outer().len() + mesh.face(slope[0]).holes().map(<[u32]>::len).sum::<usize>(), 8);
}

#[test]
fn base_heights_at_the_top_leave_the_top() {
    // A base that reaches the height leaves no room for the slope.
    for base in [4.0, 5.0] {
        let shape = built(&polygon(&SQUARE, &[]), NORMAL, 4.0, &[[base, 45.0], [2.0, 45.0], [base, 45.0], [2.0, 45.0]]);
        assert_eq!(counts(&shape), [1, 4, 2, 0, 1]);
        assert!((area(&shape, tagged(&shape, "envelope.top")[0]) - 60.0).abs() < 1e-9);
        let shape = built(&polygon(&SQUARE, &[]), NORMAL, 4.0, &[[base, 45.0]; 4]);
        assert_eq!(counts(&shape), [1, 4, 0, 0, 1]);
        assert!((volume(&shape) - 400.0).abs() < 1e-9);
    }
}

#[test]
fn slopes_that_meet_leave_no_top() {
    let shape = built(&polygon(&SQUARE, &[]), NORMAL, 40.0, &[[1.0, 45.0]; 4]);
    assert_eq!(counts(&shape), [1, 4, 4, 0, 0]);
    assert!((volume(&shape) - (100.0 + 100.0 * 5.0 / 3.0)).abs() < 1e-9);
}

#[test]
fn concave_outlines_have_valleys() {
    let sides = [[2.0, 45.0]; 6];
    let shape = built(&polygon(&L, &[]), NORMAL, 3.0, &sides);
    assert_eq!(counts(&shape), [1, 6, 6, 0, 1]);
    // Offset inwards by 1: two rectangles of 8 by 3 and 3 by 5.
    assert!((area(&shape, tagged(&shape, "envelope.top")[0]) - (24.0 + 15.0)).abs() < 1e-8);
    // No top: the roof of an L.
    let shape = built(&polygon(&L, &[]), NORMAL, 30.0, &sides);
    assert_eq!(counts(&shape), [1, 6, 6, 0, 0]);
    // Different bases: layers.
    let sides = [[2.0, 45.0], [1.0, 60.0], [0.0, 45.0], [1.5, 30.0], [2.0, 90.0], [3.0, 70.0]];
    let shape = built(&polygon(&L, &[]), NORMAL, 3.5, &sides);
    assert_eq!(counts(&shape)[0], 1);
    assert_eq!(counts(&shape)[3], 0);
    // Sampled: the height over a place in the foot of the L, beyond the line of the other wing, obeys its own slopes.
    assert!(volume(&shape) < 75.0 * 3.5);
}

#[test]
fn a_level_slope_is_the_top_of_a_concave_lot() {
    // An L: its inner corner makes slopes end at each other. Level slopes at 3 and 5 leave an upright block of 3.
    let lot = polygon(&[(0.0, 0.0), (10.0, 0.0), (10.0, 4.0), (4.0, 4.0), (4.0, 10.0), (0.0, 10.0)], &[]);
    let mut sides = [[0.0, 90.0]; 6];
    (sides[2], sides[3]) = ([3.0, 0.0], [5.0, 0.0]);
    let made = built(&lot, NORMAL, 12.0, &sides);
    assert!((volume(&made) - 64.0 * 3.0).abs() < 1e-9);
    assert_eq!(counts(&made), [1, 6, 0, 0, 1]);
    // Just above level, the slopes leave almost the same.
    (sides[2], sides[3]) = ([3.0, 0.001], [5.0, 0.001]);
    assert!((volume(&built(&lot, NORMAL, 3.0, &sides)) - volume(&made)).abs() < 1e-9);
    // Other slopes below the level one stay; those that begin above it are cut away.
    (sides[0], sides[1], sides[2], sides[3]) = ([1.0, 45.0], [4.0, 45.0], [3.0, 0.0], [0.0, 90.0]);
    let mixed = built(&lot, NORMAL, 12.0, &sides);
    sides[2] = [0.0, 90.0];
    assert!((volume(&mixed) - volume(&built(&lot, NORMAL, 3.0, &sides))).abs() < 1e-9);
}

#[test]
fn a_slope_at_a_long_edge_of_a_concave_lot_covers_all_of_it() {
    // Only the front has a slope; the whole lot is behind it.
    let shape = built(&polygon(&L, &[]), NORMAL, 30.0, &[[2.0, 45.0]]);
    assert_eq!(counts(&shape), [1, 6, 1, 0, 0]);
    // 2 + y over the L.
    assert!((volume(&shape) - (2.0 * 75.0 + 50.0 * 2.5 + 25.0 * 7.5)).abs() < 1e-8);
}

#[test]
fn collinear_corners_do_no_harm() {
    // Corners on the straight front and back, with equal numbers for the parts of an edge.
    let outline = [(0.0, 0.0), (4.0, 0.0), (10.0, 0.0), (10.0, 10.0), (5.0, 10.0), (0.0, 10.0)];
    let shape = built(&polygon(&outline, &[]), NORMAL, 4.0, &[[2.0, 45.0]; 6]);
    let plain = built(&polygon(&SQUARE, &[]), NORMAL, 4.0, &[[2.0, 45.0]; 4]);
    assert!((volume(&shape) - volume(&plain)).abs() < 1e-9);
    // Different numbers on one line: the lower one counts.
    let mut sides = [[2.0, 45.0]; 6];
    sides[1] = [3.0, 60.0];
    assert!((volume(&built(&polygon(&outline, &[]), NORMAL, 4.0, &sides)) - volume(&plain)).abs() < 1e-9);
}

#[test]
fn every_face_has_a_volume_of_its_own() {
    let far: Vec<(f64, f64)> = SQUARE.iter().map(|(x, y)| (x + 20.0, *y)).collect();
    let mut builder = crate::geometry::mesh::MeshBuilder::new();
    for outline in [&SQUARE[..], &far] {
        let ring: Vec<u32> = outline.iter().map(|&(x, y)| builder.point([x, 0.0, -y])).collect();
        builder.face(&ring, &[], Default::default());
    }
    let shape = Shape::mesh_axis_aligned(builder.build().unwrap());
    // Element 4 is the first edge of the second face.
    let mut sides = [[0.0, 90.0]; 8];
    sides[4] = [1.0, 45.0];
    let shape = built(&shape, NORMAL, 3.0, &sides);
    assert_eq!(counts(&shape), [2, 8, 1, 0, 2]);
    assert!((volume(&shape) - (600.0 - 10.0 * 2.0)).abs() < 1e-9);
}

#[test]
fn a_slanted_lot_has_upright_sides_along_the_world() {
    // Rises by 1 in 2 towards the back.
    let lift = DAffine3::from_mat3(DMat3::from_cols(DVec3::X, DVec3::Y, DVec3::new(0.0, -0.5, 1.0)));
    for outline in [&SQUARE[..], &L] {
        let flat = polygon(outline, &[]);
        let lot = Shape::mesh_axis_aligned(flat.to_mesh().map(&lift));
        let up = EnvelopeAlong::WorldUp;
        let shape = built(&lot, up, 20.0, &[]);
        assert_eq!(shape.scope.axes, lot.scope.axes);
        assert!((shape.scope.size.y - 20.0).abs() < 1e-9);
        // Slopes from all edges, above the ground.
        let sides = vec![[2.0, 70.0]; outline.len()];
        let shape = built(&lot, up, 8.0, &sides);
        let top = tagged(&shape, "envelope.top");
        assert!(top.iter().all(|&face| (shape.to_mesh().face(face).normal() - DVec3::Y).length() < 1e-9));
        assert!((shape.scope.size.y - 8.0).abs() < 1e-9);
        // Along the normal the same numbers give the envelope of the flat lot of that form.
        let shape = built(&lot, NORMAL, 8.0, &sides);
        assert!((shape.scope.axes.y_axis - lot.to_mesh().face(0).normal()).length() < 1e-9);
    }
}

/// *CGA changelog 2021.1*: on bent shapes with a turned scope.
#[test]
fn the_bottom_stays_on_a_bent_lot_with_a_turned_scope() {
    let ring = [[0.0, 0.0, 0.0], [10.0, 0.4, 0.0], [10.0, 0.0, -8.0], [0.0, 0.4, -8.0]].map(DVec3::from);
    for turn in [0.0, 25.0, 90.0, -130.0] {
        let mut lot = Shape::mesh_axis_aligned(Mesh::from_polygon(&ring, &[]).expect("a face"));
        crate::op::rotate_scope(&mut Env::for_tests(), &mut lot, 10.0, turn, -5.0);
        let world = |shape: &Shape| -> Vec<DVec3> {
            let place = shape.scope.frame();
            shape.to_mesh().points().iter().map(|point| place.to_world(*point)).collect()
        };
        let corners = world(&lot);
        assert!(ring.iter().all(|at| corners.iter().any(|corner| corner.distance(*at) < 1e-9)));
        for along in [NORMAL, EnvelopeAlong::WorldUp] {
            let (env, mut made) = (&mut Env::for_tests(), lot.clone());
            envelope_edges(env, &mut made, along, 6.0, array(&[2.0, 1.0]), array(&[60.0, 45.0]));
            assert_eq!(env.take_faults().0, []);
            assert!(made.to_mesh().is_closed());
            let points = world(&made);
            for at in ring {
                let near = points.iter().map(|point| point.distance(at)).fold(f64::INFINITY, f64::min);
                assert!(near < 1e-9, "{turn} {along:?}: {at} is {near} away");
            }
        }
    }
}

#[test]
fn planes_and_layers_agree() {
    // The same convex lot, with a notch that has upright sides and no influence but its own area.
    let plain = polygon(&SQUARE, &[]);
    let sides = [[2.0, 45.0], [1.0, 60.0], [0.5, 30.0], [3.0, 80.0]];
    let whole = volume(&built(&plain, NORMAL, 4.0, &sides));
    // A tooth outwards at the first edge that is not outermost: 1 by 0.5, upright, with a base of 0 under its slope.
    let notched =
        [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (6.0, 10.0), (6.0, 9.999), (4.0, 9.999), (4.0, 10.0), (0.0, 10.0)];
    let upright = [0.0, 90.0];
    let sides = [sides[0], sides[1], sides[2], upright, [0.5, 30.0], upright, sides[2], sides[3]];
    let layered = built(&polygon(&notched, &[]), NORMAL, 4.0, &sides);
    assert!((volume(&layered) - whole).abs() < 0.05, "{} {whole}", volume(&layered));
}

#[test]
fn random_lots_turn_with_their_envelopes() {
    let rng = &mut crate::shape::seed::Seed::new(11);
    let mut refused = 0;
    for round in 0..300 {
        let count = 3 + (rng.draw() * 9.0) as usize;
        let convex = round % 2 == 0;
        let radius = |rng: &mut crate::shape::seed::Seed| if convex { 10.0 } else { 4.0 + 8.0 * rng.draw() };
        let mut angles: Vec<f64> = (0..count).map(|_| rng.draw() * std::f64::consts::TAU).collect();
        angles.sort_unstable_by(f64::total_cmp);
        angles.dedup_by(|a, b| *a - *b < 0.1);
        if angles.len() < 3
            || (0..angles.len()).any(|k| {
                let next = angles.get(k + 1).copied().unwrap_or(angles[0] + std::f64::consts::TAU);
                3.0 < next - angles[k]
            })
        {
            continue;
        }
        let outline: Vec<(f64, f64)> = angles
            .iter()
            .map(|&angle| {
                let radius = radius(rng);
                (radius * libm::cos(angle), radius * libm::sin(angle))
            })
            .collect();
        let sides: Vec<[f64; 2]> = outline
            .iter()
            .map(|_| [(rng.draw() * 4.0).floor(), [30.0, 45.0, 60.0, 90.0, 75.0][(rng.draw() * 5.0) as usize]])
            .collect();
        let lot = polygon(&outline, &[]);
        let (bases, slopes): (Vec<f64>, Vec<f64>) = sides.iter().map(|side| (side[0], side[1])).unzip();
        let env = &mut Env::for_tests();
        let mut shape = lot.clone();
        envelope_edges(env, &mut shape, NORMAL, 5.0, array(&bases), array(&slopes));
        let faults = env.take_faults().0;
        if !faults.is_empty() {
            assert!(!convex, "{outline:?} {sides:?}");
            refused += 1;
            continue;
        }
        let mesh = shape.to_mesh();
        assert!(mesh.is_closed() && mesh.check().is_empty(), "{:?} {outline:?} {sides:?}", mesh.check());
        assert!(mesh.volume() <= lot.to_mesh().area() * 5.0 * (1.0 + 1e-9));
        // Below every slope of a convex lot.
        let angle = 0.1 + rng.draw() * 6.0;
        let turn = DMat3::from_rotation_y(angle);
        let mut turned = Shape::mesh_axis_aligned(lot.to_mesh().map(&DAffine3::from_mat3(turn)));
        envelope_edges(env, &mut turned, NORMAL, 5.0, array(&bases), array(&slopes));
        assert!(env.take_faults().0.is_empty(), "turned {outline:?} {sides:?}");
        assert!((volume(&turned) - mesh.volume()).abs() < 1e-6 * mesh.volume(), "{outline:?} {sides:?}");
        if convex {
            assert_eq!(counts(&turned), counts(&shape), "{outline:?} {sides:?}");
        }
    }
    assert_eq!(refused, 0, "of 150 concave lots");
}

#[test]
fn what_cannot_be_built_stays_with_a_fault() {
    let lot = polygon(&SQUARE, &[]);
    let mut builder = crate::geometry::mesh::MeshBuilder::new();
    let bow = [(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 7.0)].map(|(x, y)| builder.point([x, 0.0, -y]));
    builder.face(&bow, &[], Default::default());
    let bow = Shape::mesh_axis_aligned(builder.build().unwrap());
    for (shape, height, base, angle) in [
        (&lot, 0.0, 1.0, 45.0),
        (&lot, -3.0, 1.0, 45.0),
        (&lot, f64::NAN, 1.0, 45.0),
        (&lot, 5.0, -1.0, 45.0),
        (&lot, 5.0, 1.0, 120.0),
        (&lot, 5.0, 1.0, -5.0),
        (&lot, 5.0, 0.0, 0.0),
        (&bow, 5.0, 1.0, 45.0),
    ] {
        let (env, mut made) = (&mut Env::for_tests(), shape.clone());
        envelope_front(env, &mut made, NORMAL, height, base, angle);
        assert!(!env.take_faults().0.is_empty(), "{height} {base} {angle}");
        assert_eq!((made.scope, made.to_mesh().face_count()), (shape.scope, 1));
    }
    // Walls do not look up.
    let wall = [(0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (3.0, 2.0, 0.0), (0.0, 2.0, 0.0)].map(DVec3::from);
    let mut wall = Shape::mesh_axis_aligned(Mesh::from_polygon(&wall, &[]).unwrap());
    let env = &mut Env::for_tests();
    envelope_front(env, &mut wall, EnvelopeAlong::WorldUp, 5.0, 1.0, 45.0);
    assert_eq!(env.take_faults().0.len(), 1);
    // Lines have no faces.
    let mut line = Shape::line([0.0; 3], [2.0, 0.0, 0.0]).unwrap();
    envelope_front(env, &mut line, NORMAL, 5.0, 1.0, 45.0);
    assert!(env.take_faults().0.is_empty());
}

#[test]
fn very_small_very_large_and_distant_lots_have_envelopes() {
    for (scale, by) in [(1e-9, 0.0), (1e9, 0.0), (1.0, 1e9), (1.0, 5e5)] {
        for outline in [&SQUARE[..], &L] {
            let scaled: Vec<(f64, f64)> = outline.iter().map(|(x, y)| (x * scale + by, y * scale - by)).collect();
            let sides = vec![[2.0 * scale, 45.0]; outline.len()];
            let plain = volume(&built(&polygon(outline, &[]), NORMAL, 4.0, &vec![[2.0, 45.0]; outline.len()]));
            let made = volume(&built(&polygon(&scaled, &[]), NORMAL, 4.0 * scale, &sides));
            assert!((made / (scale * scale * scale) / plain - 1.0).abs() < 1e-5, "{scale} {by}");
        }
    }
}

#[test]
fn a_round_lot_takes_little_time() {
    let at = |k: usize| {
        let angle = k as f64 / 1000.0 * std::f64::consts::TAU;
        (20.0 * libm::cos(angle), 20.0 * libm::sin(angle))
    };
    let outline: Vec<(f64, f64)> = (0..1000).map(at).collect();
    let shape = built(&polygon(&outline, &[]), NORMAL, 4.0, &vec![[2.0, 45.0]; 1000]);
    assert_eq!(counts(&shape), [1, 1000, 1000, 0, 1]);
}
