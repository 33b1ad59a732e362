//! Single streets: lengths, first edges, kinds, heights, errors.

use std::collections::HashSet;

use glam::{DVec2, DVec3};

use super::*;

fn network(lines: &[Centerline]) -> Network {
    Network::new(lines, &NetworkOptions::default()).unwrap()
}

fn of_kind(network: &Network, kind: Kind) -> Vec<&NetworkPart> {
    network.parts().iter().filter(|part| part.kind == kind).collect()
}

fn counts(network: &Network) -> [usize; 5] {
    [Kind::Street, Kind::Sidewalk, Kind::Joint, Kind::Junction, Kind::Crossing].map(|kind| of_kind(network, kind).len())
}

fn points(part: &NetworkPart) -> HashSet<[u64; 3]> {
    part.mesh.points().iter().map(|point| point.to_array().map(f64::to_bits)).collect()
}

#[test]
fn a_straight_street_has_lengths_in_metres() {
    let network = network(&[Centerline::new(&[[-30.0, 0.0], [50.0, 0.0]]).sidewalks(3.0, 1.5)]);
    let [left, right] =
        [Side::Left, Side::Right].map(|side| network.parts().iter().find(|part| part.side == Some(side)).unwrap());
    let street = of_kind(&network, Kind::Street)[0];
    assert_eq!((street.length, street.width, left.width, right.width), (80.0, 8.0, 3.0, 1.5));
    assert_eq!([street, left, right].map(|part| part.mesh.area()), [640.0, 240.0, 120.0]);
    // x east, z south: the left side of a street to the east is in the north.
    assert!(
        left.mesh.points().iter().all(|point| point.z <= -4.0)
            && right.mesh.points().iter().all(|point| 4.0 <= point.z)
    );
    for (part, width) in [(street, 8.0), (left, 3.0), (right, 1.5)] {
        for (&corner, at) in part.mesh.corners().iter().zip(0..) {
            let [unit, from, to] = [0, 1, 2].map(|set| part.mesh.uv_set(set)[at]);
            let point = part.mesh.points()[corner as usize];
            let across = match part.side {
                None => 4.0 - point.z,
                Some(_) => point.z.abs() - 4.0,
            };
            assert_eq!(from, DVec2::new(point.x + 30.0, across));
            assert_eq!(to, DVec2::new(50.0 - point.x, across));
            assert_eq!(unit, from / DVec2::new(80.0, width));
        }
    }
}

#[test]
fn first_edges_run_along_the_line_and_at_the_kerb() {
    // The same network with its lines in both directions.
    for reverse in [false, true] {
        let mut points = [[-40.0, 5.0], [0.0, 0.0], [40.0, 10.0]];
        if reverse {
            points.reverse();
        }
        let lines = [Centerline::new(&points), Centerline::new(&[[0.0, 60.0], [0.0, 0.0]])];
        let network = network(&lines);
        for part in network.parts().iter().filter(|part| part.line.is_some()) {
            let face = part.mesh.face(0);
            let uv = |corner: usize| part.mesh.uv_set(0)[face.corner_range().start + corner];
            assert_eq!((uv(0).y, uv(1).y), (0.0, 0.0), "{part:?}");
            if part.kind == Kind::Street {
                assert!(uv(0) == DVec2::ZERO && uv(0).x < uv(1).x);
            }
            let line = &points;
            let shape = part.shape();
            let x = shape.scope().axes.x_axis;
            if part.line == Some(0) && part.kind == Kind::Street {
                let along = DVec2::new(line[2][0] - line[0][0], line[2][1] - line[0][1]);
                assert!(0.0 < DVec2::new(x.x, x.z).dot(along));
            }
            assert_eq!(shape.scope().axes.y_axis, DVec3::Y);
        }
    }
}

#[test]
fn coordinates_grow_along_and_across_round_bends() {
    let line: Vec<[f64; 2]> = (0..30).map(|at| [f64::from(at) * 4.0, 25.0 * libm::sin(f64::from(at) * 0.2)]).collect();
    let network = network(&[Centerline::new(&line)]);
    assert_eq!(counts(&network), [1, 2, 0, 0, 0]);
    let street = of_kind(&network, Kind::Street)[0];
    assert!(20 < street.mesh.face_count());
    let mut reached = 0.0;
    for face in street.mesh.faces() {
        let uvs: Vec<DVec2> = face.corner_range().map(|corner| street.mesh.uvs()[corner]).collect();
        assert_eq!(uvs.len(), 4);
        assert_eq!((uvs[0].x, uvs[3].x), (reached, reached));
        assert!(uvs[0].x < uvs[1].x && uvs[1].x == uvs[2].x);
        assert_eq!([uvs[0].y, uvs[1].y, uvs[2].y, uvs[3].y], [0.0, 0.0, 1.0, 1.0]);
        reached = uvs[1].x;
    }
    assert_eq!(reached, 1.0);
    let length: f64 = line.windows(2).map(|ends| DVec2::from(ends[0]).distance(DVec2::from(ends[1]))).sum();
    assert!((street.length - length).abs() < 1e-3 * length);
}

#[test]
fn a_line_that_continues_another_has_a_chart_of_its_own_and_shares_the_border() {
    let network =
        network(&[Centerline::new(&[[0.0, 0.0], [50.0, 0.0]]), Centerline::new(&[[90.0, 10.0], [50.0, 0.0]])]);
    assert_eq!(counts(&network), [2, 4, 0, 0, 0]);
    let streets = of_kind(&network, Kind::Street);
    assert_eq!(points(streets[0]).intersection(&points(streets[1])).count(), 2);
    assert!((streets[1].length - DVec2::new(40.0, 10.0).length()).abs() < 1e-9);
    for street in streets {
        let start = if street.line == Some(0) { 0.0 } else { 85.0 };
        let first = street.mesh.points()[street.mesh.face(0).outer()[0] as usize];
        assert!((first.x - start).abs() < 10.0, "each begins where its line begins");
    }
}

#[test]
fn junctions_are_named_by_their_arms() {
    let arm = |degrees: f64| {
        Centerline::new(&[[0.0, 0.0], [60.0 * libm::cos(degrees.to_radians()), 60.0 * libm::sin(degrees.to_radians())]])
    };
    let named = |degrees: &[f64]| {
        let network = network(&degrees.iter().map(|&degrees| arm(degrees)).collect::<Vec<_>>());
        let junctions: Vec<(Kind, usize)> =
            network.parts().iter().filter(|part| 0 < part.arms).map(|part| (part.kind, part.arms)).collect();
        junctions
    };
    assert_eq!(named(&[0.0, 180.0, 90.0]), [(Kind::Junction, 3)]);
    assert_eq!(named(&[0.0, 120.0, 240.0]), [(Kind::Crossing, 3)]);
    assert_eq!(named(&[0.0, 90.0, 180.0, 270.0]), [(Kind::Crossing, 4)]);
    assert_eq!(named(&[0.0, 70.0, 140.0, 210.0, 280.0]), [(Kind::Crossing, 5)]);
    assert_eq!(named(&[0.0, 180.0]), []);
    let tapered = network(&[arm(0.0), arm(180.0).roadway(12.0)]);
    assert_eq!(counts(&tapered), [2, 6, 1, 0, 0]);
}

#[test]
fn a_crossing_of_sharp_corners_is_a_square() {
    let lines = [Centerline::new(&[[-40.0, 0.0], [40.0, 0.0]]), Centerline::new(&[[0.0, -40.0], [0.0, 40.0]])];
    let sharp = NetworkOptions { corner_radius: 0.0, ..NetworkOptions::default() };
    let network = Network::new(&lines, &sharp).unwrap();
    // The area up to the edges of the sidewalks: 12 m by 12 m without four squares of 2 m.
    assert_eq!(of_kind(&network, Kind::Crossing)[0].mesh.area(), 144.0 - 4.0 * 4.0);
    let all: f64 = network.parts().iter().map(|part| part.mesh.area()).sum();
    assert_eq!(all, 2.0 * 80.0 * 12.0 - 144.0);
    // Kerbs have a radius of 4 m, and outer borders of sidewalks a radius of 2 m.
    let rounded = Network::new(&lines, &NetworkOptions::default()).unwrap();
    let all: f64 = rounded.parts().iter().map(|part| part.mesh.area()).sum();
    let corner = 2.0 * 2.0 * (1.0 - std::f64::consts::FRAC_PI_4);
    assert!((all - (2.0 * 80.0 * 12.0 - 144.0) - 4.0 * corner).abs() < 0.2, "{all}");
}

#[test]
fn outlines_go_round_each_part() {
    let network = network(&[Centerline::new(&[[-30.0, 0.0], [30.0, 0.0], [50.0, 30.0]])]);
    for part in network.parts() {
        let [outline] = &part.outlines()[..] else { panic!("one loop") };
        let at = |index: usize| DVec2::new(outline[index % outline.len()][0], -outline[index % outline.len()][2]);
        let area: f64 = (0..outline.len()).map(|index| at(index).perp_dot(at(index + 1)) / 2.0).sum();
        assert!((area - part.mesh.area()).abs() < 1e-9, "{area}");
    }
}

#[test]
fn heights_are_kept_along_lines_and_shared_at_borders() {
    let network = network(&[
        Centerline::with_heights(&[[-60.0, 0.0, 0.0], [-10.0, 5.0, 4.0], [60.0, 8.0, -10.0]]),
        Centerline::with_heights(&[[0.0, 20.0, 60.0], [0.0, 4.0, 0.0]]),
    ]);
    laws::check(&network, "heights");
    let heights = || network.parts().iter().flat_map(|part| part.mesh.points()).map(|point| point.y);
    assert_eq!(heights().fold(f64::INFINITY, f64::min), 0.0);
    assert_eq!(heights().fold(0.0, f64::max), 20.0);
    let raised =
        Network::new(&[Centerline::with_heights(&[[0.0, 7.25, 0.0], [9.0, 7.25, 0.0]])], &NetworkOptions::default());
    assert!(raised.unwrap().parts().iter().all(|part| part.mesh.points().iter().all(|point| point.y == 7.25)));
}

#[test]
fn moving_and_mirroring_lines_moves_and_mirrors_streets() {
    let lines = |map: &dyn Fn([f64; 2]) -> [f64; 2]| {
        [[[-40.0, 0.0], [40.0, 0.0]], [[5.0, 0.0], [20.0, 48.0]]].map(|points| Centerline::new(&points.map(map)))
    };
    let areas = |lines: &[Centerline]| -> Vec<f64> {
        let mut areas: Vec<f64> = network(lines).parts().iter().map(|part| part.mesh.area()).collect();
        areas.sort_by(f64::total_cmp);
        areas
    };
    let plain = areas(&lines(&|p| p));
    for (name, moved) in [
        ("far away", areas(&lines(&|[x, z]| [x + 5_400_000.0, z - 500_000.0]))),
        ("mirrored", areas(&lines(&|[x, z]| [-x, z]))),
        ("turned", areas(&lines(&|[x, z]| [0.6 * x - 0.8 * z, 0.8 * x + 0.6 * z]))),
    ] {
        assert_eq!(plain.len(), moved.len(), "{name}");
        for (a, b) in plain.iter().zip(&moved) {
            assert!((a - b).abs() < 1e-4, "{name}: {a} {b}");
        }
    }
}

#[test]
fn bad_input_is_named() {
    let line = |points: &[[f64; 2]]| Centerline::new(points);
    let good = || line(&[[0.0, 0.0], [9.0, 0.0]]);
    let error = |lines: &[Centerline]| Network::new(lines, &NetworkOptions::default()).unwrap_err();
    assert_eq!(error(&[good(), line(&[[0.0, 0.0], [f64::NAN, 0.0]])]), StreetError::Point { line: 1, point: 1 });
    assert_eq!(error(&[line(&[[0.0, 1e300]])]), StreetError::Point { line: 0, point: 0 });
    assert_eq!(error(&[good().roadway(0.0)]), StreetError::Roadway { line: 0, width: 0.0 });
    assert_eq!(error(&[good().sidewalks(1.0, -1.0)]), StreetError::Sidewalk { line: 0, width: -1.0 });
    assert_eq!(
        error(&[good().roadway(0.0)]).to_string(),
        "line 0 has a roadway of 0 m; give a width from 0.01 to 10,000"
    );
    for options in [
        NetworkOptions { snap: -1.0, ..NetworkOptions::default() },
        NetworkOptions { corner_radius: f64::INFINITY, ..NetworkOptions::default() },
        NetworkOptions { arc_above: f64::NAN, ..NetworkOptions::default() },
    ] {
        assert!(matches!(Network::new(&[good()], &options), Err(StreetError::Option { .. })));
    }
    assert!(network(&[]).parts().is_empty());
}

#[test]
fn thousands_of_streets_are_laid_out() {
    let lines: Vec<Centerline> = (0..1000)
        .map(|at| {
            let (x, z) = (f64::from(at % 40) * 120.0, f64::from(at / 40) * 90.0);
            let [dx, dz] = [[120.0, 0.0], [0.0, 90.0], [115.0, 80.0]][at as usize % 3];
            Centerline::new(&[[x, z], [x + dx, z + dz]])
        })
        .collect();
    let network = network(&lines);
    assert!(1000 <= of_kind(&network, Kind::Street).len());
    let again = self::network(&lines);
    assert!(network.parts().iter().zip(again.parts()).all(|(a, b)| a.mesh.points() == b.mesh.points()));
}
