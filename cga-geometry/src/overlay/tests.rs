//! Regions against windings at random places, areas, and edges that nearly meet.

use glam::{DMat2, DVec2};

use super::{Region, wound};
use crate::random::Rng;

fn area_of(points: &[DVec2], ring: &[u32]) -> f64 {
    let at = |i: usize| points[ring[i] as usize] - points[ring[0] as usize];
    0.5 * (1..ring.len() - 1).map(|i| at(i).perp_dot(at(i + 1))).sum::<f64>()
}

pub(crate) fn area(region: &Region) -> f64 {
    region.polygons.iter().flatten().map(|ring| area_of(&region.points, ring)).sum()
}

/// The winding number of rings around a point.
fn winding(points: &[DVec2], rings: &[Vec<u32>], p: DVec2) -> i32 {
    let crosses = |a: DVec2, b: DVec2| match (a.y <= p.y, b.y <= p.y) {
        (true, false) if 0.0 < (b - a).perp_dot(p - a) => 1,
        (false, true) if (b - a).perp_dot(p - a) < 0.0 => -1,
        _ => 0,
    };
    let at = |ring: &[u32], i: usize| points[ring[i % ring.len()] as usize];
    rings.iter().flat_map(|ring| (0..ring.len()).map(|i| crosses(at(ring, i), at(ring, i + 1)))).sum()
}

fn check(points: &[DVec2], rings: &[Vec<u32>], rng: &mut Rng, near: f64) -> Region {
    let region = wound(points, rings.iter().map(Vec::as_slice), 0);
    let region = region.unwrap_or_else(|why| panic!("{why:?} {points:?} {rings:?}"));
    let all: Vec<Vec<u32>> = region.polygons.iter().flatten().cloned().collect();
    let low = points.iter().copied().reduce(DVec2::min).unwrap();
    let high = points.iter().copied().reduce(DVec2::max).unwrap();
    for _ in 0..200 {
        let p = low + (high - low) * DVec2::new(rng.unit(), rng.unit());
        let at = |ring: &Vec<u32>, i: usize| points[ring[i % ring.len()] as usize];
        let is_near = rings.iter().any(|ring| {
            (0..ring.len()).any(|i| {
                let share = crate::segment::nearest_share(p, [at(ring, i), at(ring, i + 1)]);
                at(ring, i).lerp(at(ring, i + 1), share).distance(p) < near
            })
        });
        if !is_near {
            let expected = i32::from(0 < winding(points, rings, p));
            assert_eq!(winding(&region.points, &all, p), expected, "{p} {points:?}");
        }
    }
    region
}

#[test]
fn random_triangles_unite_and_are_taken_away() {
    let rng = &mut Rng(7);
    for round in 0..200 {
        let count = 1 + (rng.unit() * 12.0) as usize;
        // Every second set is on a coarse grid, so that edges and corners coincide.
        let coordinate = |rng: &mut Rng| if round % 2 == 0 { rng.unit() } else { (rng.unit() * 6.0).floor() };
        let points: Vec<DVec2> = (0..3 * count).map(|_| DVec2::new(coordinate(rng), coordinate(rng))).collect();
        let rings: Vec<Vec<u32>> = (0..count as u32).map(|i| vec![3 * i, 3 * i + 1, 3 * i + 2]).collect();
        // Turned, moved far away, and very small or large.
        for (turn, scale, by) in [(0.0, 1.0, 0.0), (0.6, 1.0, 0.0), (0.3, 1e-9, 0.0), (1.1, 1e9, 1e9), (0.9, 1.0, 1e5)]
        {
            let turned: Vec<DVec2> =
                points.iter().map(|p| DMat2::from_angle(turn) * *p * scale + DVec2::splat(by)).collect();
            check(&turned, &rings, rng, 1e-6 * scale);
        }
    }
}

#[test]
fn squares_side_by_side_become_one_without_the_corners_between() {
    // Ten squares in a row, each with points of its own, turned: their corners differ by rounding.
    for turn in [0.0, 0.1, 0.7, 1.3] {
        let corner = |i: usize, k: usize| DVec2::new((i + [0, 1, 1, 0][k]) as f64 * 0.1, [0.0, 0.0, 0.3, 0.3][k]);
        let points: Vec<DVec2> =
            (0..10).flat_map(|i| (0..4).map(move |k| DMat2::from_angle(turn) * corner(i, k))).collect();
        let rings: Vec<Vec<u32>> = (0..10).map(|i| (4 * i..4 * i + 4).collect()).collect();
        let region = wound(&points, rings.iter().map(Vec::as_slice), 0).unwrap();
        assert_eq!(region.polygons.len(), 1);
        assert_eq!(region.polygons[0].len(), 1);
        assert_eq!(region.polygons[0][0].len(), 4);
        assert!((area(&region) - 0.3).abs() < 1e-9);
        assert_eq!(region.points.len(), points.len(), "no new points");
    }
}

#[test]
fn a_frame_has_a_hole_and_parts_stay_apart() {
    let square = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from);
    let points: Vec<DVec2> = [square(0.0, 4.0), square(1.0, 3.0), square(1.5, 2.5)].concat();
    let hole = [7, 6, 5, 4];
    let region = wound(&points, [&[0, 1, 2, 3][..], &hole, &[8, 9, 10, 11]], 0).unwrap();
    assert_eq!(region.polygons, [vec![vec![0, 1, 2, 3], vec![4, 7, 6, 5]], vec![vec![8, 9, 10, 11]]]);
    assert!((area(&region) - 13.0).abs() < 1e-9);
    // Slits and needles are dropped.
    let gap = 1e-9;
    let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.5, 0.1), (0.5 + gap, 0.1), (0.5, 0.9)];
    let region = wound(&points.map(DVec2::from), [&[0, 1, 2, 3][..], &[4, 6, 5]], 0).unwrap();
    assert_eq!(region.polygons, [vec![vec![0, 1, 2, 3]]]);
    assert!(wound(&points.map(DVec2::from), [&[4, 5, 6][..]], 0).unwrap().polygons.is_empty());
}

#[test]
fn many_triangles_at_random_end() {
    let rng = &mut Rng(3);
    for (count, size) in [(300, 1.0), (3000, 0.05)] {
        let points: Vec<DVec2> = (0..count)
            .flat_map(|_| {
                let at = DVec2::new(rng.unit(), rng.unit());
                [0; 3].map(|_| at + size * DVec2::new(rng.unit(), rng.unit()))
            })
            .collect();
        let rings: Vec<Vec<u32>> = (0..count)
            .map(|i| {
                let ring = vec![3 * i, 3 * i + 1, 3 * i + 2];
                if area_of(&points, &ring) < 0.0 { vec![3 * i, 3 * i + 2, 3 * i + 1] } else { ring }
            })
            .collect();
        check(&points, &rings, rng, 1e-6);
    }
}
