//! Laws of strips and the remaining interior, on polygons of many kinds.

pub(crate) mod polygons;

use std::f64::consts::{FRAC_PI_4, TAU};

use super::wavefront::twice_area;
use super::*;
use crate::exact::winding;
use crate::random::Rng;
use polygons::{Cells, Polygon};

fn left_area(swept: &Swept) -> f64 {
    let points = |ring: &[FrontCorner]| ring.iter().map(|left| left.point).collect::<Vec<_>>();
    swept.left.iter().map(|ring| twice_area(&swept.points, &points(ring)) * 0.5).sum()
}

/// Sweeps a polygon and checks laws that need no reference result: areas add up, no strip is reversed, sides have a
/// length.
fn checked(polygon: &Polygon, distance: f64) -> Result<Swept, String> {
    let swept = sweep(&polygon.points, &polygon.rings, distance).map_err(|failure| format!("{failure:?}"))?;
    let strips: Vec<f64> = swept.strips.iter().map(|strip| twice_area(&swept.points, &strip.ring) * 0.5).collect();
    let whole: f64 = polygon.rings.iter().map(|ring| twice_area(&polygon.points, ring) * 0.5).sum();
    let sum = strips.iter().sum::<f64>() + left_area(&swept);
    let size = whole.abs() + strips.iter().sum::<f64>().abs();
    if (sum - whole).abs() > 1e-9 * size {
        return Err(format!("areas: {sum} of {whole}"));
    }
    if let Some(bad) = strips.iter().position(|&area| area < -1e-9 * size) {
        return Err(format!("strip {bad} has area {}", strips[bad]));
    }
    let extent = size.sqrt();
    for strip in &swept.strips {
        let at = |i: usize| swept.points[strip.ring[i % strip.ring.len()] as usize];
        let new = |i: usize| polygon.points.len() <= strip.ring[i % strip.ring.len()] as usize;
        let count = strip.ring.len();
        if (0..count).any(|i| new(i) && new(i + 1) && at(i).distance(at(i + 1)) < 1e-12 * extent) {
            return Err(format!("a side of the strip of {} is a point", strip.edge));
        }
    }
    Ok(swept)
}

fn complain(failures: &[String], of: usize) {
    assert!(failures.is_empty(), "{} of {of}: {:#?}", failures.len(), &failures[..failures.len().min(5)]);
}

/// Returns true if a point is in the remaining interior; `None` on its rim.
fn is_left(swept: &Swept, p: DVec2) -> Option<bool> {
    let mut turns = 0;
    for ring in &swept.left {
        let ring: Vec<DVec2> = ring.iter().map(|left| swept.points[left.point as usize]).collect();
        turns += winding(&ring, p)?;
    }
    Some(turns == 1)
}

#[test]
fn a_square_shrinks() {
    let square = Polygon::of(&[&[(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]]);
    let swept = checked(&square, 1.0).unwrap();
    assert_eq!((swept.strips.len(), swept.left.len(), left_area(&swept)), (4, 1, 4.0));
    for distance in [2.0, 3.0, 1e9] {
        let swept = checked(&square, distance).unwrap();
        assert_eq!((swept.strips.len(), swept.left.len(), swept.points.len()), (4, 0, 5));
    }
    let swept = checked(&square.inverted(), 1e6).unwrap();
    assert_eq!((swept.strips.len(), swept.left.len()), (4, 1));
}

#[test]
fn unions_of_cells_shrink_and_grow_as_a_raster_says() {
    let (mut failures, mut count) = (Vec::new(), 0);
    let kinds: [(f64, f64, f64); 11] = [
        (0.0, 0.0, 0.0),
        (0.3, 0.0, 0.0),
        (FRAC_PI_4, 0.0, 0.0),
        (0.3, 0.0, 500e3),
        (0.3, 1e-12, 0.0),
        (0.3, 1e-10, 0.0),
        (0.3, 1e-9, 0.0),
        (0.3, 1e-7, 0.0),
        (0.3, 1e-6, 0.0),
        (0.3, 1e-4, 0.0),
        (0.3, 2e-2, 0.0),
    ];
    for seed in 0..24 {
        let cells = Cells::random(&mut Rng(seed), 6);
        for (eighths, outside) in [1, 3, 4, 5, 8, 12].into_iter().flat_map(|e| [(e, false), (e, true)]) {
            let truth = cells.eroded(eighths, outside);
            for (turn, jitter, far) in kinds {
                let polygon = cells.polygon().turned(turn, far).jittered(jitter, &mut Rng(seed + 7));
                let polygon = if outside { polygon.inverted() } else { polygon };
                let found = checked(&polygon, eighths as f64 / 8.0).map(|swept| left_area(&swept));
                if !found.as_ref().is_ok_and(|found| (found - truth).abs() <= 1e-8 + 200.0 * jitter + 1e-9 * far) {
                    let case =
                        format!("seed {seed}, {eighths}/8, outside {outside}, turned {turn} by {jitter} at {far}");
                    failures.push(format!("{case}: {found:?} instead of {truth}"));
                }
                count += 1;
            }
        }
    }
    complain(&failures, count);
}

/// Events with nothing else near take a short way. The general way gives the same, to the bit.
#[test]
fn the_short_way_is_the_general_way() {
    use super::wavefront::Wavefront;
    let (usual, lone) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
    for seed in 0..240 {
        let rng = &mut Rng(seed);
        let polygon = match seed % 4 {
            0 => Cells::random(rng, 3 + (seed % 5) as i32).polygon().turned(0.3, 10.0),
            1 => Cells::random(rng, 4).polygon().jittered(0.02, rng),
            2 => Polygon::star(rng, 5 + (seed % 30) as usize, seed % 8 == 2),
            _ => Polygon::convex(rng, 3 + (seed % 20) as usize),
        };
        let count = polygon.rings.iter().map(Vec::len).sum();
        let speeds: Vec<f64> = (0..count).map(|edge| if edge % 4 == 1 { 0.5 } else { 1.0 }).collect();
        for (speeds, until) in [(Speeds::Equal, 1.0), (Speeds::Equal, f64::INFINITY), (Speeds::Heights(&speeds), 2.0)] {
            let front = || Wavefront::new(&polygon.points, &polygon.rings, speeds, MEETING_EPSILONS[0], until);
            let counted = |front: &mut Wavefront, events: &[_]| {
                let made = front.handle_lone(events);
                usual.set(usual.get() + 1);
                lone.set(lone.get() + usize::from(made.is_some()));
                made
            };
            let short = front().and_then(|front| front.run_by(counted));
            assert_eq!(short, front().and_then(|front| front.run_by(|_, _| None)), "seed {seed}, until {until}");
        }
    }
    assert!(usual.get() / 2 < lone.get(), "{lone:?} of {usual:?} steps");
}

/// A failure found with random polygons: with one contact distance, an edge continued in two pieces.
#[test]
fn a_strip_is_in_one_piece() {
    let cells = Cells::random(&mut Rng(10_764), 8);
    let polygon = cells.polygon().turned(0.3, 0.0).jittered(1e-8, &mut Rng(10_771)).inverted();
    let swept = checked(&polygon, 0.625).unwrap();
    assert!((left_area(&swept) - cells.eroded(5, true)).abs() < 1e-5);
    let area = |strip: &Strip| twice_area(&swept.points, &strip.ring);
    let mut edges: Vec<u32> = swept.strips.iter().filter(|strip| 1e-6 < area(strip)).map(|strip| strip.edge).collect();
    edges.dedup();
    assert_eq!(edges.len(), polygon.rings.iter().map(Vec::len).sum::<usize>());
}

/// Points closer to the outline than the distance are swept. Points farther away than the fastest corner that is not
/// convex can move are not.
#[test]
fn points_near_the_outline_are_swept_and_far_ones_are_left() {
    let (mut failures, mut count) = (Vec::new(), 0);
    for seed in 0..300 {
        let rng = &mut Rng(seed);
        let mut polygon = Polygon::star(rng, 3 + (seed % 40) as usize, seed % 3 == 0);
        if seed % 2 == 0 {
            polygon = polygon.rounded(6.0 + 20.0 * rng.unit());
        }
        for (distance, outside) in [0.01, 0.05, 0.1, 0.2, 0.5, 2.0].into_iter().flat_map(|d| [(d, false), (d, true)]) {
            let polygon = if outside { polygon.inverted() } else { polygon.clone() };
            let case = format!("seed {seed}, {distance}, outside {outside}");
            let swept = match checked(&polygon, distance) {
                Ok(swept) => swept,
                Err(why) => {
                    failures.push(format!("{case}: {why}"));
                    continue;
                }
            };
            let farthest = distance * polygon.sharpest();
            for _ in 0..40 {
                let p = (DVec2::new(rng.unit(), rng.unit()) - 0.5) * 3.0;
                if polygon.holds(p) == outside {
                    continue;
                }
                count += 1;
                let (from, left) = (polygon.distance(p), is_left(&swept, p));
                // The loops of the region outside do not contain infinity: a point remains where no loop winds around
                // it.
                let left = left.map(|left| {
                    left || (outside
                        && !swept.strips.iter().any(|strip| polygons::holds(&swept.points, &strip.ring, p)))
                });
                if from < distance - 1e-9 && left == Some(true) || farthest + 1e-9 < from && left == Some(false) {
                    failures.push(format!("{case}: {p} at {from} is left: {left:?}"));
                }
            }
        }
    }
    assert!(10_000 < count);
    complain(&failures, count);
}

#[test]
fn convex_polygons_shrink_to_what_is_behind_all_moved_edges() {
    for seed in 0..300 {
        let rng = &mut Rng(seed);
        let polygon = Polygon::convex(rng, 3 + (seed % 20) as usize);
        for distance in [0.01, 0.1, 0.3, 0.6, 1.2] {
            let truth = polygon.clipped(distance);
            let found = left_area(&checked(&polygon, distance).unwrap());
            assert!((truth - found).abs() < 1e-9, "seed {seed}: {found} instead of {truth}");
            // Outwards: Steiner's formula, with mitred corners.
            let grown = -left_area(&checked(&polygon.inverted(), distance).unwrap());
            let truth = polygon.mitred(distance);
            assert!((truth - grown).abs() < 1e-9 * truth, "seed {seed}: {grown} instead of {truth}");
        }
    }
}

#[test]
fn turned_and_mirrored_polygons_give_turned_and_mirrored_results() {
    for seed in 0..100 {
        let polygon = Polygon::star(&mut Rng(seed), 5 + (seed % 20) as usize, seed % 2 == 0);
        let turn = DVec2::new(libm::cos(1.0), libm::sin(1.0));
        let distance = 0.02 * (seed % 9 + 1) as f64;
        let here = checked(&polygon, distance).unwrap();
        let there = checked(&polygon.turned(1.0, 0.0), distance).unwrap();
        assert_eq!((&here.strips, &here.left), (&there.strips, &there.left), "seed {seed}");
        let near = |(p, q): (&DVec2, &DVec2)| turn.rotate(*p).distance(*q) < 1e-9;
        assert!(here.points.iter().zip(&there.points).all(near), "seed {seed}");
        let mirrored = checked(&polygon.mirrored(), distance).unwrap();
        assert_eq!(mirrored.strips.len(), here.strips.len());
        assert!((left_area(&mirrored) - left_area(&here)).abs() < 1e-12);
    }
}

#[test]
fn what_happens_at_once_stays_symmetric() {
    for tips in 3..30 {
        let ring: Vec<(f64, f64)> = (0..2 * tips)
            .map(|i| (TAU * f64::from(i) / f64::from(2 * tips), if i % 2 == 0 { 2.0 } else { 1.0 }))
            .map(|(angle, radius)| (radius * libm::cos(angle), radius * libm::sin(angle)))
            .collect();
        let star = Polygon::of(&[&ring]);
        for (polygon, distance) in [(star.clone(), 5.0), (star.clone(), 0.1), (star.inverted(), 0.4)] {
            let swept = checked(&polygon, distance).unwrap();
            let areas: Vec<f64> = swept.strips.iter().map(|strip| twice_area(&swept.points, &strip.ring)).collect();
            assert_eq!(areas.len(), 2 * tips as usize);
            assert!(areas.iter().all(|area| (area - areas[0]).abs() < 1e-12), "{tips} tips: {areas:?}");
        }
        // All strips end at one point in the middle.
        assert_eq!(checked(&star, 5.0).unwrap().strips[0].ring.len(), 3);
    }
}

/// Thousands of edges that meet at one point or along one line.
#[test]
fn many_events_happen_at_once() {
    let around = |count: u32, radius: &dyn Fn(u32) -> f64| -> Vec<(f64, f64)> {
        let angle = |i: u32| TAU * f64::from(i) / f64::from(count);
        (0..count).map(|i| (radius(i) * libm::cos(angle(i)), radius(i) * libm::sin(angle(i)))).collect()
    };
    let disk = around(1000, &|_| 1.0);
    let spikes = around(800, &|i| if i % 2 == 0 { 1.0 } else { 0.5 });
    let gear = around(800, &|i| if i / 2 % 2 == 0 { 1.0 } else { 0.8 });
    let walls = (0..500).map(|i| (f64::from(i), 0.0)).chain((0..500).map(|i| (499.0 - f64::from(i), 10.0)));
    for ring in [disk, spikes, gear, walls.collect()] {
        let polygon = Polygon::of(&[&ring]);
        for (polygon, distance) in [(polygon.inverted(), 0.01), (polygon, 6.0)] {
            let swept = checked(&polygon, distance).unwrap();
            assert_eq!((swept.strips.len(), swept.left.len()), (ring.len(), usize::from(distance < 1.0)));
        }
    }
}

/// Teeth of different lengths above one edge. Each tooth that reaches the edge divides the target of the others.
#[test]
fn an_edge_is_reached_again_and_again() {
    let rng = &mut Rng(3);
    let tips: Vec<f64> = (0..150).map(|_| 1.0 + rng.unit()).collect();
    let above = (0..150).rev().flat_map(|i| [(f64::from(i) + 0.8, 5.0), (f64::from(i) + 0.3, tips[i as usize])]);
    let ring: Vec<(f64, f64)> = [(0.0, 0.0), (150.0, 0.0)].into_iter().chain(above).collect();
    let polygon = Polygon::of(&[&ring]);
    for distance in [0.45, 0.6, 0.8, 1.2] {
        assert_eq!(checked(&polygon, distance).unwrap().strips.len(), ring.len(), "{distance}");
    }
}

#[test]
fn corners_that_are_none_divide_strips_and_nothing_else() {
    let plain = Polygon::of(&[&[(0.0, 0.0), (10.0, 0.0), (10.0, 4.0), (0.0, 4.0)]]);
    let divided = [(0.0, 0.0), (3.0, 0.0), (5.0, 0.0), (10.0, 0.0), (10.0, 1.0), (10.0, 4.0), (5.5, 4.0), (0.0, 4.0)];
    let divided = Polygon::of(&[&divided]);
    for distance in [0.5, 1.5, 2.0, 3.0] {
        for (a, b) in [(&plain, &divided), (&plain.inverted(), &divided.inverted())] {
            let (a, b) = (checked(a, distance).unwrap(), checked(b, distance).unwrap());
            assert!((left_area(&a) - left_area(&b)).abs() < 1e-12);
            assert_eq!((a.strips.len(), b.strips.len()), (4, 8));
        }
    }
}

#[test]
fn a_bridge_to_a_hole_is_not_there() {
    let outline = [(0.0, 0.0), (8.0, 0.0), (8.0, 6.0), (0.0, 6.0)];
    let hole = [(3.0, 2.0), (3.0, 4.0), (5.0, 4.0), (5.0, 2.0)];
    let bridged = [&outline[..1], &[hole[0], hole[1], hole[2], hole[3], hole[0], outline[0]], &outline[1..]].concat();
    for distance in [0.5, 1.0, 1.5, 2.5] {
        let (a, b) = (
            checked(&Polygon::of(&[&outline, &hole]), distance).unwrap(),
            checked(&Polygon::of(&[&bridged]), distance).unwrap(),
        );
        assert!((left_area(&a) - left_area(&b)).abs() < 1e-12);
        assert_eq!((a.strips.len(), a.left.len()), (b.strips.len(), b.left.len()));
    }
}

/// Loops that cross, repeat corners or reverse their direction are refused, or give areas that add up.
#[test]
fn any_loops_end() {
    let mut results = [0, 0];
    for seed in 0..400 {
        let rng = &mut Rng(seed);
        let (count, size) = (3 + (seed % 20) as u32, 2.0 + 6.0 * rng.unit());
        let points: Vec<DVec2> = (0..count).map(|_| (DVec2::new(rng.unit(), rng.unit()) * size).round()).collect();
        let half = if seed % 2 == 0 || count < 6 { 0 } else { count / 2 };
        let rings: Vec<Vec<u32>> = [0..half, half..count].into_iter().map(Iterator::collect).collect();
        let rings = rings.into_iter().filter(|ring: &Vec<u32>| !ring.is_empty()).collect();
        let polygon = Polygon { points, rings };
        for distance in [0.1, 0.5, 1.0, 5.0] {
            match checked(&polygon, distance) {
                Ok(_) => results[0] += 1,
                Err(why) => {
                    assert_eq!(why, "Tangled");
                    results[1] += 1;
                }
            }
        }
    }
    assert!(results[0] > 100 && results[1] > 100, "{results:?}");
}

#[test]
fn what_no_number_holds_is_refused() {
    let square = |size: f64| Polygon::of(&[&[(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)]]);
    let result = |polygon: &Polygon, distance| sweep(&polygon.points, &polygon.rings, distance).map(|_| ());
    assert_eq!(result(&square(1e200), 1.0), Err(SkeletonError::Tangled));
    assert_eq!(result(&square(1.0).inverted(), f64::MAX), Err(SkeletonError::Tangled));
    assert_eq!(result(&square(1e-200), 1.0), Err(SkeletonError::Tangled));
    assert_eq!(result(&square(1e-90), 1e-91), Ok(()));
    let many = Polygon::star(&mut Rng(1), MOST_CORNERS + 1, false);
    assert_eq!(result(&many, 0.1), Err(SkeletonError::TooMany));
}

#[test]
fn wavefronts_without_events_are_those_with_them() {
    let mut rng = Rng(11);
    let (mut compared, mut refused) = (0, 0);
    for round in 0..3000 {
        let mut unit = |low: f64, high: f64| low + (high - low) * rng.unit();
        let (w, d) = (unit(0.5, 8.0), unit(0.5, 8.0));
        let shift = if round % 3 == 0 { 0.0 } else { 0.4 };
        let corners = [[0.0, 0.0], [w, 0.0], [w, d], [0.0, d]]
            .map(|corner| DVec2::from_array(corner) + DVec2::new(unit(-shift, shift), unit(-shift, shift)) * w.min(d));
        let count = if round % 5 == 0 { 3 } else { 4 };
        let turn = DVec2::from_angle(unit(0.0, 7.0));
        let from = DVec2::new(unit(-50.0, 50.0), unit(-50.0, 50.0));
        let points: Vec<DVec2> = corners[..count].iter().map(|corner| from + turn.rotate(*corner)).collect();
        let mut ring: Vec<u32> = (0..count as u32).collect();
        ring.rotate_left(round % count);
        if round % 2 == 0 {
            ring.reverse();
        }
        let mut speed = || [0.0, 1.0, 1.0, unit(0.05, 1.0)][round / 7 % 4];
        let each: Vec<f64> = (0..count).map(|i| if i == round % count { 1.0 } else { speed() }).collect();
        let until = unit(0.001, 0.6) * w.min(d);
        for speeds in [Speeds::Equal, Speeds::Places(&each), Speeds::Heights(&each), Speeds::Slopes(&each)] {
            let rings = [ring.clone()];
            let Some(own) = eventless::sweep_without_events(&points, &rings, speeds, until) else {
                refused += 1;
                continue;
            };
            let other = sweep_with_events(&points, &rings, speeds, until).expect("a wavefront");
            assert_eq!(own.strips, other.strips, "{points:?} {rings:?} {speeds:?} {until}");
            assert_eq!(own.left, other.left, "{points:?} {rings:?} {speeds:?} {until}");
            assert_eq!(
                (&own.points, &own.times),
                (&other.points, &other.times),
                "{points:?} {rings:?} {speeds:?} {until}"
            );
            compared += 1;
        }
    }
    assert!(3000 < compared && 1000 < refused, "{compared} compared, {refused} refused");
}

#[test]
fn convex_polygons_of_many_corners_have_wavefronts_without_events() {
    let mut rng = Rng(12);
    let mut compared = 0;
    for round in 0..600 {
        let count = [5, 6, 8, 12, 48, 200][round % 6];
        // Corners on an ellipse, at angles that are even or drawn.
        let mut angles: Vec<f64> =
            (0..count).map(|i| if round % 4 < 2 { i as f64 } else { i as f64 + 0.8 * rng.unit() }).collect();
        angles.iter_mut().for_each(|angle| *angle *= std::f64::consts::TAU / count as f64);
        let size = DVec2::new(1.0 + 9.0 * rng.unit(), 1.0 + 9.0 * rng.unit());
        let from = DVec2::new(100.0 * rng.unit(), 100.0 * rng.unit());
        let points: Vec<DVec2> = angles.iter().map(|angle| from + DVec2::from_angle(*angle) * size).collect();
        let mut ring: Vec<u32> = (0..count as u32).collect();
        ring.rotate_left(round % count);
        if round % 2 == 0 {
            ring.reverse();
        }
        let until = (0.001 + 0.3 * rng.unit()) * size.min_element();
        for speeds in [Speeds::Equal, Speeds::Heights(&vec![1.0; count])] {
            let rings = [ring.clone()];
            let Some(own) = eventless::sweep_without_events(&points, &rings, speeds, until) else { continue };
            let other = sweep_with_events(&points, &rings, speeds, until).expect("a wavefront");
            let told = || format!("{points:?} {rings:?} {speeds:?} {until}");
            assert_eq!((&own.strips, &own.left), (&other.strips, &other.left), "{}", told());
            assert_eq!((&own.points, &own.times), (&other.points, &other.times), "{}", told());
            compared += 1;
        }
    }
    assert!(500 < compared, "{compared} compared");
}

#[test]
fn a_star_that_crosses_itself_has_no_wavefront_without_events() {
    let corner = |i: u32| DVec2::from_angle(f64::from(2 * i) * std::f64::consts::TAU / 5.0);
    let star: Vec<DVec2> = (0..5).map(corner).collect();
    for ring in [vec![0, 1, 2, 3, 4], vec![4, 3, 2, 1, 0]] {
        assert!(eventless::sweep_without_events(&star, &[ring], Speeds::Equal, 0.01).is_none());
    }
}

#[test]
fn hostile_numbers_have_no_wavefront_without_events() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
    let made = |points: &[DVec2], until| {
        eventless::sweep_without_events(points, &[vec![0, 1, 2, 3]], Speeds::Equal, until).is_some()
    };
    assert!(made(&square, 1.0));
    for until in [0.0, -1.0, 2.0, 1e300, f64::NAN, f64::INFINITY] {
        assert!(!made(&square, until), "{until}");
    }
    for odd in [[f64::NAN, 0.0], [f64::INFINITY, 0.0], [1e308, 0.0], [4.0, 4.0], [1.0, 3.0]] {
        let points = [square[0], DVec2::from_array(odd), square[2], square[3]];
        assert!(!made(&points, 0.1), "{odd:?}");
    }
}
