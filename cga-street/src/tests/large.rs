//! Networks that are too large, and doubled lines.

use super::*;
use crate::grid::Point;
use crate::rounding::divide;
use crate::subdivision::Subdivision;

#[test]
fn doubled_lines_count_once() {
    let line = [[0.0, 0.0], [100.0, 0.0]];
    let back = [[100.0, 0.0], [0.0, 0.0]];
    let once = Network::new(&[Centerline::new(&line)], &NetworkOptions::default());
    // Comparing all of them with each other would take minutes.
    let many: Vec<Centerline> =
        (0..200_000).map(|at| Centerline::new(if at % 2 == 0 { &line } else { &back })).collect();
    assert_eq!(Network::new(&many, &NetworkOptions::default()), once);
}

#[test]
fn segments_that_cross_too_often_are_an_error() {
    let fan: Vec<[Point; 2]> =
        (0..300).map(|at| [Point { x: 2 * at, y: 0 }, Point { x: 601 - 2 * at, y: 1000 }]).collect();
    assert!(divide(&fan, 50_000).is_ok());
    assert!(divide(&fan, 5_000).is_err());
    // 1,000 segments on one line do not cross, and are compared 1,000,000 times.
    let line: Vec<[Point; 2]> = (0..1000).map(|at| [Point { x: at, y: 0 }, Point { x: 10_000 - at, y: 0 }]).collect();
    assert!(divide(&line, 1_000).is_err());
}

#[test]
fn borders_with_too_many_edges_are_an_error() {
    let ring = |count: i64| -> Vec<Point> { (0..count).map(|x| Point { x, y: x * x % 7 }).collect() };
    let made = Subdivision::new(&[ring(1_000_000), ring(9_000_001)]);
    assert_eq!(made.err(), Some(StreetError::TooLarge { most: 10_000_000 }));
}

/// The borders of 2,000 arms would cross 8 million times.
#[test]
fn very_many_streets_at_one_point_are_an_error() {
    let fan = |count: usize| -> Vec<Centerline> {
        let angle = |at: usize| std::f64::consts::PI * at as f64 / count as f64;
        let line = |at: usize| (libm::sin(angle(at)) * 100.0, libm::cos(angle(at)) * 100.0);
        (0..count).map(line).map(|(x, z)| Centerline::new(&[[5.0 - x, 7.0 - z], [5.0 + x, 7.0 + z]])).collect()
    };
    let options = NetworkOptions::default();
    let Err(StreetError::TooManyArms { point: [x, z], most: 256 }) = Network::new(&fan(1000), &options) else {
        panic!("2,000 arms");
    };
    assert!((x - 5.0).abs() < 1e-6 && (z - 7.0).abs() < 1e-6, "{x} {z}");
    assert!(Network::new(&fan(12), &options).is_ok());
}

/// Faces in the middle of polygons that lie over each other are covered by all of them.
#[test]
fn very_many_polygons_over_each_other_are_an_error() {
    let nested = |at: i64| {
        let (low, high) = (at, 1_000_000 - at);
        [[low, low], [high, low], [high, high], [low, high]].map(|[x, y]| Point { x, y }).into()
    };
    let squares: Vec<Vec<Point>> = (0..200).map(nested).collect();
    assert!(Subdivision::within(&squares, 50_000).is_ok());
    let dense = Subdivision::within(&squares, 10_000);
    assert_eq!(dense.err(), Some(StreetError::TooDense { most: MOST_CROSSINGS }));
}

/// A watch that is stopped at the question with a number.
fn stopped_at(last: u64) -> (Watch, std::sync::Arc<std::sync::atomic::AtomicU64>) {
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::time::Duration;
    let count = std::sync::Arc::new(AtomicU64::new(0));
    let seen = count.clone();
    let clock = move || if seen.fetch_add(1, Ordering::Relaxed) <= last { Duration::ZERO } else { Duration::MAX };
    (Watch::deadline_by(Duration::from_secs(1), clock), count)
}

#[test]
fn a_layout_can_be_stopped_at_any_question() {
    let town: Vec<Centerline> = (0..16)
        .flat_map(|at| {
            let at = f64::from(at) * 60.0;
            [Centerline::new(&[[at, -30.0], [at, 960.0]]), Centerline::new(&[[-30.0, at], [960.0, at]])]
        })
        .collect();
    let options = NetworkOptions::default();
    let (watch, count) = stopped_at(u64::MAX);
    let whole = Network::with_watch(&town, &options, &watch).unwrap();
    let questions = count.load(std::sync::atomic::Ordering::Relaxed);
    // About 5,000 corners.
    assert!(100 < questions, "{questions} questions");
    assert_eq!(Network::new(&town, &options), Ok(whole));
    for last in [1, questions / 4, questions / 2, questions * 3 / 4, questions - 2] {
        let stopped = Network::with_watch(&town, &options, &stopped_at(last).0);
        assert_eq!(stopped, Err(StreetError::Stopped), "{last} of {questions}");
    }
}

/// Segments on one line divide each other without a crossing: 300 of them have 45,000 parts.
#[test]
fn segments_on_one_line_with_too_many_parts_are_an_error() {
    let line = |count: i64| -> Vec<[Point; 2]> {
        (0..count).map(|at| [Point { x: at, y: 0 }, Point { x: 10_000 - at, y: 0 }]).collect()
    };
    assert!(divide(&line(300), 20_000).is_ok());
    assert!(divide(&line(300), 2_000).is_err());
}

/// Comparing all components with each other would take minutes.
#[test]
fn each_of_many_components_knows_the_polygons_around_it() {
    let square = |x: i64, y: i64, size: i64| -> Vec<Point> {
        [[0, 0], [size, 0], [size, size], [0, size]].map(|[u, v]| Point { x: x + u, y: y + v }).into()
    };
    let side = 100;
    let places = || (0..side * side).map(|at| [10 + at % side * 100, 10 + at / side * 100]);
    let mut polygons = vec![square(0, 0, 100 * side)];
    polygons.extend(places().flat_map(|[x, y]| [square(x, y, 80), square(x + 10, y + 10, 60)]));
    let made = Subdivision::new(&polygons).expect("few edges");
    let count = |number: usize| made.covers.iter().filter(|covers| covers.len() == number).count();
    let cells = (side * side) as usize;
    // The outer border of a component is a cycle of the area around it.
    assert_eq!([0, 1, 2, 3].map(count), [1, 1 + cells, 2 * cells, cells]);
    for covers in made.covers.iter().filter(|covers| covers.len() == 3) {
        assert!(covers[0] == 0 && covers[1] % 2 == 1 && covers[2] == covers[1] + 1, "{covers:?}");
    }
}
