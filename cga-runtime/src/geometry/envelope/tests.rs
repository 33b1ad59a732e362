//! Planes against layers, and holes.

use glam::DVec3;

use super::{EnvelopePart, EnvelopeRefusal, EnvelopeSide, Ground, begun_at_outline, envelope, layers, planes};
use crate::geometry::mesh::{FlatFace, Mesh};
use crate::geometry::random::Rng;

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
        // The shaft has at least the volume of the lowest place above the hole, and at most that of the top.
        let lost = whole.volume() - volume.volume();
        assert!(0.0 < lost && lost <= 5.0 * (bottom - kept) * (1.0 + 1e-7));
    }
}
