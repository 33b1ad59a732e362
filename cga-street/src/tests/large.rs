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
    assert!(divide(&fan, 50_000).is_some());
    assert!(divide(&fan, 5_000).is_none());
    // 1,000 segments on one line do not cross, and are compared 1,000,000 times.
    let line: Vec<[Point; 2]> = (0..1000).map(|at| [Point { x: at, y: 0 }, Point { x: 10_000 - at, y: 0 }]).collect();
    assert!(divide(&line, 1_000).is_none());
}

#[test]
fn borders_with_too_many_edges_are_an_error() {
    let ring = |count: i64| -> Vec<Point> { (0..count).map(|x| Point { x, y: x * x % 7 }).collect() };
    let made = Subdivision::new(&[ring(1_000_000), ring(9_000_001)]);
    assert_eq!(made.err(), Some(StreetError::TooLarge { most: 10_000_000 }));
}
