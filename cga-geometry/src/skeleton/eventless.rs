//! Wavefronts of triangles and convex quadrilaterals in which nothing happens before the end: most offsets and setbacks. The result is
//! the one of the wavefront with events, by formula.

use glam::DVec2;

use super::wavefront::{MovingLine, SIZES, twice_area, velocity};
use super::{BLUNT, FrontCorner, Speeds, Strip, Swept};

/// The shortest edge, and the root of the smallest area, relative to the extent. Below it contacts decide.
const SHORTEST: f64 = 1e-4;

/// The largest cosine of the angle between neighbouring edges, in either direction. Beyond it corners are blunt or sharp.
const FLATTEST: f64 = BLUNT;

/// Moves the edges of a triangle or a convex quadrilateral, or of the region outside it. `None` for other polygons, and if an event may
/// come before the end.
pub(super) fn sweep_without_events(
    points: &[DVec2],
    rings: &[Vec<u32>],
    speeds: Speeds<'_>,
    until: f64,
) -> Option<Swept> {
    let [ring] = rings else { return None };
    let count = ring.len();
    if !(3..=4).contains(&count) || points.len() != count || !(0.0 < until && until < f64::INFINITY) {
        return None;
    }
    let corner = |i: usize| points[ring[i % count] as usize];
    let extent =
        ring.iter().fold(0.0, |most: f64, &point| most.max((points[point as usize] - corner(0)).abs().max_element()));
    if !SIZES.contains(&extent) || *SIZES.end() < until {
        return None;
    }
    let mut lines = [MovingLine { along: DVec2::X, at: 0.0, speed: 0.0 }; 4];
    for (i, line) in lines[..count].iter_mut().enumerate() {
        let edge = corner(i + 1) - corner(i);
        let length = edge.length();
        let speed = speeds.of(i);
        if !(SHORTEST * extent < length && length < f64::INFINITY && (0.0..=1.0).contains(&speed)) {
            return None;
        }
        let along = edge / length;
        *line = MovingLine { along, at: along.perp().dot(corner(i)), speed };
    }
    // The sense of the ring: inwards, or outwards.
    let sense = twice_area(points, ring).signum();
    let mut velocities = [DVec2::ZERO; 4];
    for (i, moves) in velocities[..count].iter_mut().enumerate() {
        let [before, after] = [lines[(i + count - 1) % count], lines[i]];
        let is_plain =
            0.0 < sense * before.along.perp_dot(after.along) && before.along.dot(after.along).abs() <= FLATTEST;
        if !is_plain {
            return None;
        }
        *moves = velocity(&before, &after)?;
    }
    let place = |i: usize| corner(i) + velocities[i % count] * until;
    let is_long = |i: usize| SHORTEST * extent < lines[i].along.dot(place(i + 1) - place(i));
    let mut all: Vec<DVec2> = Vec::with_capacity(2 * count);
    all.extend_from_slice(points);
    all.extend((0..count).map(place));
    let front: Vec<u32> = (count as u32..2 * count as u32).collect();
    let least = SHORTEST * extent * SHORTEST * extent;
    if !(0..count).all(is_long) || sense * twice_area(&all, ring) <= least || sense * twice_area(&all, &front) <= least
    {
        return None;
    }
    // Where only places count, a corner that stays is the same point.
    let is_one = |i: usize| !speeds.has_heights() && velocities[i % count] == DVec2::ZERO;
    let end = |i: usize| if is_one(i) { ring[i % count] } else { (count + i % count) as u32 };
    let strip = |i: usize| {
        let corners = [ring[i], ring[(i + 1) % count], end(i + 1), end(i)];
        let keeps = [true, true, !is_one(i + 1), !is_one(i)];
        let kept: Vec<u32> =
            corners.into_iter().zip(keeps).filter_map(|(corner, keeps)| keeps.then_some(corner)).collect();
        // The front is the side before the last corner, or the one before a corner that stays.
        let front =
            (0..kept.len()).map(|side| [kept[side], kept[(side + 1) % kept.len()]] == [end(i + 1), end(i)]).collect();
        (2 < kept.len()).then_some(Strip { edge: i as u32, ring: kept, front })
    };
    let mut times = vec![0.0; count];
    times.resize(2 * count, until);
    Some(Swept {
        strips: (0..count).filter_map(strip).collect(),
        left: vec![(0..count).map(|i| FrontCorner { point: end(i), edge: i as u32 }).collect()],
        points: all,
        times,
        deviation: 0.0,
    })
}
