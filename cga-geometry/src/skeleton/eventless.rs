//! Wavefronts of convex polygons in which nothing happens before the end: most offsets and setbacks. The result is the one of the
//! wavefront with events, by formula.

use glam::DVec2;

use super::wavefront::{MovingLine, SIZES, twice_area, velocity};
use super::{BLUNT, FrontCorner, Speeds, Strip, Swept};

/// The shortest edge, and the root of the smallest area, relative to the extent. Below it contacts decide.
const SHORTEST: f64 = 1e-4;

/// The smallest sine of the angle between neighbouring edges of one speed. Below it corners may count as straight.
const STRAIGHTEST: f64 = 1e-3;

/// Moves the edges of a convex polygon, or of the region outside it. `None` for other polygons, and if an event may come before the
/// end.
pub(super) fn sweep_without_events(
    points: &[DVec2],
    rings: &[Vec<u32>],
    speeds: Speeds<'_>,
    until: f64,
) -> Option<Swept> {
    let [ring] = rings else { return None };
    let count = ring.len();
    if count < 3 || points.len() != count || !(0.0 < until && until < f64::INFINITY) {
        return None;
    }
    let corner = |i: usize| points[ring[i % count] as usize];
    let extent =
        ring.iter().fold(0.0, |most: f64, &point| most.max((points[point as usize] - corner(0)).abs().max_element()));
    if !SIZES.contains(&extent) || *SIZES.end() < until {
        return None;
    }
    let mut lines = Vec::with_capacity(count);
    for i in 0..count {
        let edge = corner(i + 1) - corner(i);
        let length = edge.length();
        let speed = speeds.of(i);
        if !(SHORTEST * extent < length && length < f64::INFINITY && (0.0..=1.0).contains(&speed)) {
            return None;
        }
        // As in the wavefront with events, bit for bit.
        let along = edge.normalize_or(DVec2::X);
        lines.push(MovingLine { along, at: along.perp().dot(corner(i)), speed });
    }
    // The sense of the ring: inwards, or outwards.
    let sense = twice_area(points, ring).signum();
    if turns(&lines, sense) != 1 {
        return None;
    }
    let mut velocities = Vec::with_capacity(count);
    for i in 0..count {
        let [before, after] = [lines[(i + count - 1) % count], lines[i]];
        let (sine, cosine) = (sense * before.along.perp_dot(after.along), before.along.dot(after.along));
        // Corners between edges of different speeds are divided if they are blunt.
        let is_blunt = if before.speed == after.speed { sine <= STRAIGHTEST } else { BLUNT < cosine };
        let is_left = 0.0 < sine;
        if !is_left || is_blunt || cosine < -BLUNT {
            return None;
        }
        velocities.push(velocity(&before, &after)?);
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

/// The number of turns of a polygon whose corners all turn in the sense `sense`: more than one for a star that crosses itself.
fn turns(lines: &[MovingLine], sense: f64) -> usize {
    let is_up = |line: &MovingLine| 0.0 <= sense * line.along.y;
    let before = lines.iter().cycle().skip(lines.len() - 1);
    before.zip(lines).filter(|(before, after)| !is_up(before) && is_up(after)).count()
}
