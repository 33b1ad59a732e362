//! Planes against layers, and holes.

use glam::DVec3;

use super::{EnvelopePart, EnvelopeRefusal, EnvelopeSide, Ground, begun_at_outline, envelope, layers, planes};
use crate::mesh::{FlatFace, Mesh};
use crate::random::Rng;

type Ring = Vec<(f64, f64)>;

fn face_of(rings: &[Ring]) -> Mesh {
    let ring = |ring: &Ring| -> Vec<DVec3> { ring.iter().map(|&(x, y)| DVec3::new(x, 0.0, -y)).collect() };
    let holes: Vec<Vec<DVec3>> = rings[1..].iter().map(ring).collect();
    Mesh::from_polygon(&ring(&rings[0]), &holes).expect("a polygon")
}

/// Points around the origin, at random angles.
fn around(rng: &mut Rng, corners: usize, mut radius: impl FnMut(&mut Rng) -> f64) -> Ring {
    (0..corners)
        .map(|k| {
            let angle = (k as f64 + 0.7 * rng.unit()) / corners as f64 * std::f64::consts::TAU;
            let radius = radius(rng);
            (radius * libm::cos(angle), radius * libm::sin(angle))
        })
        .collect()
}

fn sides(rng: &mut Rng, count: usize) -> Vec<EnvelopeSide> {
    let side = |_| EnvelopeSide {
        base: (rng.unit() * 4.0).floor(),
        angle: [30.0, 45.0, 60.0, 75.0, 90.0][(rng.unit() * 5.0) as usize],
    };
    (0..count).map(side).collect()
}

/// In a convex lot slopes end at each other where their planes meet, so both ways give the same volume, with one exception: a
/// side that its neighbours have covered below its base height has no slope in layers. Then more is left.
#[test]
fn planes_and_layers_give_nearly_the_same_volumes_over_convex_lots() {
    let rng = &mut Rng(31);
    let (mut refused, mut same) = (0, 0);
    for round in 0..200 {
        let outline = around(rng, 5 + round % 6, |_| 10.0);
        let mesh = face_of(&[outline]);
        let face = mesh.face(0);
        let sides = sides(rng, face.corner_count());
        let flat = FlatFace::of(&face).unwrap();
        let ground = Ground { up: flat.normal, flat, sides, top: 5.0 };
        let cut = planes::cut(&ground).unwrap();
        assert!(cut.is_closed());
        match layers::stack(&ground) {
            Ok(stacked) => {
                let (cut, stacked) = (cut.volume(), begun_at_outline(&ground, &stacked).volume());
                assert!(cut <= stacked * (1.0 + 1e-7), "{cut} {stacked} {mesh:?} {:?}", ground.sides);
                assert!(stacked <= cut * 1.03, "{cut} {stacked} {mesh:?} {:?}", ground.sides);
                same += usize::from((cut / stacked - 1.0).abs() < 1e-7);
            }
            Err(why) => {
                assert_eq!(why, EnvelopeRefusal::Tangled);
                refused += 1;
            }
        }
    }
    assert_eq!(refused, 0);
    assert!(120 <= same, "{same} of 200");
}

/// Lots with edges that face the same way: an L, a step, a T, a U and a comb.
fn lots_of_wings() -> Vec<Ring> {
    let lots: [&[(f64, f64)]; 5] = [
        &[(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (5.0, 5.0), (5.0, 10.0), (0.0, 10.0)],
        &[(0.0, 0.0), (20.0, 0.0), (20.0, 8.0), (12.0, 8.0), (12.0, 10.0), (0.0, 10.0)],
        &[(0.0, 0.0), (9.0, 0.0), (9.0, 4.0), (6.0, 4.0), (6.0, 10.0), (3.0, 10.0), (3.0, 4.0), (0.0, 4.0)],
        &[(0.0, 0.0), (12.0, 0.0), (12.0, 9.0), (8.0, 9.0), (8.0, 4.0), (4.0, 4.0), (4.0, 7.0), (0.0, 7.0)],
        &[
            (0.0, 0.0),
            (18.0, 0.0),
            (18.0, 9.0),
            (15.0, 9.0),
            (15.0, 5.0),
            (12.0, 5.0),
            (12.0, 8.0),
            (9.0, 8.0),
            (9.0, 5.0),
            (5.0, 5.0),
            (5.0, 10.0),
            (0.0, 10.0),
        ],
    ];
    lots.map(<[_]>::to_vec).into()
}

/// Where a wing ends, its slope and the slope of the edge beside it are in one line.
#[test]
fn parallel_edges_of_different_slopes_are_not_refused() {
    let rng = &mut Rng(5);
    for round in 0..1500 {
        let lots = lots_of_wings();
        let mut lot = lots[round % lots.len()].clone();
        if round % 2 == 1 {
            // Turned, so that no edge is along an axis.
            lot.iter_mut().for_each(|p| *p = (0.8 * p.0 - 0.6 * p.1, 0.6 * p.0 + 0.8 * p.1));
        }
        let mesh = face_of(&[lot]);
        let sides = sides(rng, mesh.corners().len());
        let volume =
            envelope(&mesh.face(0), &sides, 6.0, None).unwrap_or_else(|why| panic!("{why:?} {mesh:?} {sides:?}"));
        assert!(volume.is_closed() && volume.check().is_empty(), "{:?} {mesh:?} {sides:?}", volume.check());
        assert!(0.0 < volume.volume() && volume.volume() < 6.0 * mesh.area() * (1.0 + 1e-9));
    }
}

/// The flatter slope goes on over the edge in its line, as if that had been upright.
#[test]
fn a_flatter_slope_goes_on_over_its_neighbour() {
    let mesh = face_of(&lots_of_wings()[..1]);
    let volume = |angle: f64| {
        let sides = [90.0, 90.0, 90.0, angle, 30.0, 90.0].map(|angle| EnvelopeSide { base: 0.0, angle });
        envelope(&mesh.face(0), &sides, 3.0, None).expect("a volume").volume()
    };
    // The slope reaches the end of the wing at a height of 5 tan 30, and goes on over the other wing.
    let (tan, end) = (libm::tan(30f64.to_radians()), 5.0 * libm::tan(30f64.to_radians()));
    let wedge = |height: f64| 5.0 * 0.5 * height * height / tan;
    assert!((volume(90.0) - (225.0 - wedge(3.0) - wedge(3.0 - end))).abs() < 1e-9, "{}", volume(90.0));
    assert!((volume(89.999) - volume(90.0)).abs() < 1e-2, "{}", volume(89.999));
}

/// The part of the ground that a slope covers, less the hole, is the ground of the volume with the hole.
#[test]
fn slopes_go_on_behind_holes() {
    let rng = &mut Rng(77);
    for round in 0..400 {
        let outline = around(rng, 4 + round % 8, |rng| 5.0 + 6.0 * rng.unit());
        let mut hole = around(rng, 3 + round % 3, |rng| 0.4 + rng.unit());
        hole.reverse();
        let (whole, mesh) = (face_of(std::slice::from_ref(&outline)), face_of(&[outline, hole]));
        let sides = sides(rng, mesh.corners().len());
        let whole = envelope(&whole.face(0), &sides[..whole.corners().len()], 5.0, None).unwrap();
        let volume = envelope(&mesh.face(0), &sides, 5.0, None).unwrap();
        assert!(volume.is_closed() && volume.check().is_empty(), "{:?} {:?}", volume.check(), mesh.points());
        let parts = |mesh: &Mesh, kind: fn(EnvelopePart) -> bool| -> f64 {
            mesh.faces().filter(|face| kind(EnvelopePart::of_mark(face.tag().tags))).map(|face| face.area()).sum()
        };
        let areas = |kind: fn(EnvelopePart) -> bool| [parts(&whole, kind), parts(&volume, kind)];
        // Only the shaft is gone: bases stay, and what is level or sloped above the hole.
        let [base, kept] = areas(|part| matches!(part, EnvelopePart::Base(_)));
        assert!((base - kept).abs() < 1e-7 * base, "{base} {kept} {:?} {sides:?}", mesh.points());
        let [bottom, kept] = areas(|part| part == EnvelopePart::Bottom);
        assert!((mesh.area() - kept).abs() < 1e-7 * bottom);
        let [inner, drilled] = areas(|part| matches!(part, EnvelopePart::Inner(_)));
        assert!(inner == 0.0 && 0.0 < drilled);
        // The shaft has at least the volume of the lowest place above the hole, and at most the volume of the top.
        let lost = whole.volume() - volume.volume();
        assert!(0.0 < lost && lost <= 5.0 * (bottom - kept) * (1.0 + 1e-7));
    }
}

#[test]
fn corners_at_one_place_stay_apart() {
    // An edge without a length: as numbers of points its ends differ.
    let places = [[0.0, 0.0], [6.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
    let mut mesh = Mesh { points: places.map(|[x, z]| DVec3::new(x, 0.0, -z)).to_vec(), ..Mesh::default() };
    mesh.corners.extend(0..6);
    mesh.end_loop();
    mesh.end_face(crate::mesh::FaceTag::PLAIN);
    let sides = [EnvelopeSide { base: 2.0, angle: 60.0 }; 6];
    let (made, refused) = super::envelopes(&mesh, &sides, 5.0, None);
    assert!(refused.is_empty() && made.is_closed(), "{refused:?}");
    assert!(
        made.faces()
            .all(|face| (0..face.outer().len()).all(|k| face.outer()[k] != face.outer()[(k + 1) % face.outer().len()]))
    );
}
