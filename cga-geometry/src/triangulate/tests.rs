//! Each case is checked by count, area and rim.

use glam::DVec2;

use super::*;

fn loops(rings: &[&[(f64, f64)]]) -> (Vec<DVec2>, Vec<u32>) {
    let (mut points, mut ends) = (Vec::new(), Vec::new());
    for ring in rings {
        points.extend(ring.iter().map(|&(x, y)| DVec2::new(x, y)));
        ends.push(points.len() as u32);
    }
    (points, ends)
}

/// Returns true if the net use of each edge cancels, by position: loops minus triangles.
fn rim_is_kept(points: &[DVec2], ends: &[u32], triangles: &[[u32; 3]]) -> bool {
    let key = |i: u32| points[i as usize].to_array().map(|c| (c + 0.0).to_bits());
    let mut net = std::collections::HashMap::new();
    let mut count = |a: u32, b: u32, by: i32| {
        let (a, b) = (key(a), key(b));
        if a < b {
            *net.entry((a, b)).or_insert(0) += by;
        } else if b < a {
            *net.entry((b, a)).or_insert(0) -= by;
        }
    };
    let mut start = 0;
    for &end in ends {
        (start..end).for_each(|i| count(i, if i + 1 == end { start } else { i + 1 }, 1));
        start = end;
    }
    for t in triangles {
        (0..3).for_each(|k| count(t[k], t[(k + 1) % 3], -1));
    }
    net.values().all(|&v| v == 0)
}

fn area(points: &[DVec2], triangles: &[[u32; 3]]) -> f64 {
    triangles.iter().map(|t| t.map(|i| points[i as usize])).map(|[a, b, c]| (b - a).perp_dot(c - a) / 2.0).sum()
}

/// Checks a valid polygon: no triangle is reversed, so unsigned areas add up.
fn check(rings: &[&[(f64, f64)]], expected: f64) {
    let (points, ends) = loops(rings);
    let mut out = Vec::new();
    Triangulator::new().polygon(&points, &ends, &mut out);
    let sum: f64 = out.iter().map(|&t| area(&points, &[t]).abs()).sum();
    assert!((sum - expected).abs() < 1e-12, "{rings:?} {out:?}");
    check_signed(rings, expected);
}

fn check_signed(rings: &[&[(f64, f64)]], expected: f64) {
    let (points, ends) = loops(rings);
    let mut out = Vec::new();
    Triangulator::new().polygon(&points, &ends, &mut out);
    assert!((area(&points, &out) - expected).abs() < 1e-12, "area {} not {expected}", area(&points, &out));
    assert!(rim_is_kept(&points, &ends, &out), "{rings:?} {out:?}");
}

const SQUARE: &[(f64, f64)] = &[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];

#[test]
fn convex_polygons_are_fans() {
    check(&[SQUARE], 16.0);
    check(&[&[(0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]], 16.0);
    check(&[&[(0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (2.0, 2.0), (0.0, 4.0), (0.0, 2.0)]], 8.0);
}

#[test]
fn concave_polygons_and_holes_are_covered() {
    check(&[&[(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 1.0), (1.0, 4.0), (0.0, 4.0)]], 7.0);
    check(&[SQUARE, &[(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0)]], 15.0);
}

#[test]
fn collinear_corners_are_kept() {
    let mut outline = Vec::new();
    (0..10).for_each(|i| outline.push((f64::from(i), 0.0)));
    outline.extend([(10.0, 0.0), (10.0, 3.0)]);
    (0..10).for_each(|i| outline.push((9.0 - f64::from(i), 3.0)));
    check(&[&outline], 30.0);
    let windows: Vec<Vec<(f64, f64)>> =
        (0..9).map(|i| f64::from(i) + 0.25).map(|x| vec![(x, 1.0), (x, 2.0), (x + 0.5, 2.0), (x + 0.5, 1.0)]).collect();
    let mut rings: Vec<&[(f64, f64)]> = vec![&outline];
    rings.extend(windows.iter().map(Vec::as_slice));
    check(&rings, 30.0 - 4.5);
}

#[test]
fn loops_may_touch_at_corners() {
    check(&[SQUARE, &[(0.0, 0.0), (1.0, 2.0), (2.0, 1.0)]], 16.0 - 1.5);
    let holes: [&[(f64, f64)]; 2] =
        [&[(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0)], &[(2.0, 2.0), (2.0, 3.0), (3.0, 3.0), (3.0, 2.0)]];
    check(&[SQUARE, holes[0], holes[1]], 14.0);
}

#[test]
fn crossing_loops_keep_their_rim_and_signed_area() {
    check_signed(&[&[(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 4.0)]], 0.0);
    check_signed(&[SQUARE, &[(3.0, 1.0), (3.0, 2.0), (6.0, 2.0), (6.0, 1.0)]], 13.0);
}

#[test]
fn degenerate_polygons_do_no_harm() {
    check(&[&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (1.0, 0.0)]], 0.0);
    check(&[&[(0.0, 0.0); 5]], 0.0);
    let mut out = Vec::new();
    Triangulator::new().polygon(&[DVec2::ZERO], &[1], &mut out);
    Triangulator::new().polygon(&[], &[], &mut out);
    assert!(out.is_empty());
}
