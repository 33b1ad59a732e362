//! Planes against layers, and envelopes of concave lots with holes.

use glam::DVec3;

use super::{EnvelopeRefusal, EnvelopeSide, Ground, begun_at_outline, envelope, layers, planes};
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

/// In a convex lot slopes end at each other where their planes meet, so both ways give the same volume, with two exceptions:
/// layers end slopes at the lines of holes, and a side that its neighbours have covered below its base height has no slope.
/// Then more is left.
#[test]
fn planes_and_layers_give_nearly_the_same_volumes_over_convex_lots() {
    let rng = &mut Rng(31);
    let (mut refused, mut same) = (0, 0);
    for round in 0..200 {
        let mut rings = vec![around(rng, 5 + round % 6, |_| 10.0)];
        if round % 4 == 3 {
            let mut hole = around(rng, 4, |rng| 0.5 + rng.unit());
            hole.reverse();
            rings.push(hole);
        }
        let mesh = face_of(&rings);
        let face = mesh.face(0);
        let sides = sides(rng, face.corner_count());
        let flat = FlatFace::of(&face).unwrap();
        let ground = Ground { up: flat.normal, flat, sides, top: 5.0, outer: face.outer().len() };
        let cut = planes::cut(&ground).unwrap();
        assert!(cut.is_closed());
        match layers::stack(&ground) {
            Ok(stacked) => {
                let (cut, stacked) = (cut.volume(), begun_at_outline(&ground, &stacked).volume());
                assert!(cut <= stacked * (1.0 + 1e-7), "{cut} {stacked} {rings:?} {:?}", ground.sides);
                assert!(stacked <= cut * 1.03, "{cut} {stacked} {rings:?} {:?}", ground.sides);
                same += usize::from((cut / stacked - 1.0).abs() < 1e-7);
            }
            Err(why) => {
                assert_eq!(why, EnvelopeRefusal::Tangled);
                refused += 1;
            }
        }
    }
    assert!(refused <= 2, "{refused} of 200");
    assert!(120 <= same, "{same} of 200");
}

#[test]
fn concave_lots_with_holes_have_envelopes() {
    let rng = &mut Rng(77);
    let mut refused = 0;
    for round in 0..200 {
        let outline = around(rng, 4 + round % 8, |rng| 5.0 + 6.0 * rng.unit());
        let mut hole = around(rng, 3 + round % 3, |rng| 0.4 + rng.unit());
        hole.reverse();
        let mesh = face_of(&[outline, hole]);
        let face = mesh.face(0);
        let sides = sides(rng, face.corner_count());
        match envelope(&face, &sides, 5.0, None) {
            Ok(volume) => {
                assert!(
                    volume.is_closed() && volume.check().is_empty(),
                    "{:?} {:?} {sides:?}",
                    volume.check(),
                    mesh.points()
                );
                assert!(0.0 < volume.volume() && volume.volume() <= 5.0 * mesh.area() * (1.0 + 1e-9));
            }
            Err(_) => refused += 1,
        }
    }
    // Slopes that go around a hole with different speeds are the hardest wavefronts.
    assert!(refused <= 20, "{refused} of 200");
}
