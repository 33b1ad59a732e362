//! The area of a junction: the ends of its arms, and the corners between them with rounded kerbs.

use cga_geometry::each::Each;
use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::cell::{SidePoint, SideStrip, strip};
use super::chain::{ChainNode, Polyline, turn};
use super::grid::{Point, are_apart, orient, twice_area};
use super::section::{CrossSection, Station};

/// The distance in metres from a junction within which its corners are searched.
const REACH: f64 = 120.0;

/// The shortest arm inside a junction, in metres.
const LEAST_ARM: f64 = 0.25;

/// Corners with a smaller radius than this, in metres, are sharp.
const LEAST_RADIUS: f64 = 0.2;

/// The longest tangent of a rounded corner, as a multiple of the desired radius.
const MOST_TANGENT: f64 = 4.0;

/// The largest angle between two parts of a rounded corner, in degrees.
const CORNER_STEP: f64 = 15.0;

/// The layout of a junction.
#[derive(Default)]
pub(super) struct JunctionLayout {
    /// The stations where the arms end, by chain and end.
    pub(super) stations: Vec<(u32, usize, Station)>,
    /// The area of the roadway, in one or more rings.
    pub(super) roadway: Vec<Vec<Point>>,
    /// The sidewalks around the corners.
    pub(super) corners: Vec<SideStrip>,
}

/// A chain as seen from the junction.
struct Leg {
    chain: Polyline,
    number: u32,
    end: usize,
}

impl Leg {
    /// The section at a station of the arm, from its left to its right. It is computed along the chain, so that its
    /// points are exactly the points of the chain.
    fn section(&self, chains: &[Polyline], station: Station) -> CrossSection {
        if self.end == 0 {
            return chains[self.number as usize].section(station);
        }
        let chain = &chains[self.number as usize];
        let mut section = chain.section(self.chain.reversed_station(station));
        section.borders.reverse();
        section
    }
}

impl Leg {
    /// The distance along the arm of a point beside a segment.
    fn along(&self, segment: usize, place: DVec2) -> f64 {
        let off = (place - self.chain.place(segment)).dot(self.chain.direction(segment));
        (self.chain.along[segment] + off).max(0.0)
    }
}

/// The line between two neighbouring arms that joins their borders.
struct Meeting {
    /// The points of the fillet, from the first arm to the second.
    points: Vec<DVec2>,
    /// The distances along the arms where it begins and ends.
    along: [f64; 2],
    /// The radius of the fillet, 0 for none.
    radius: f64,
}

impl Meeting {
    /// Points at the node itself. The arms are not shortened.
    fn plain(points: Vec<DVec2>) -> Self {
        Meeting { points, along: [0.0; 2], radius: 0.0 }
    }
}

/// The arms of a node in counter-clockwise order.
fn arms(node: &ChainNode, chains: &[Polyline]) -> Vec<Leg> {
    let arm = |&(number, end): &(u32, usize)| {
        let chain = &chains[number as usize];
        Leg { chain: if end == 0 { chain.clone() } else { chain.reversed() }, number, end }
    };
    let mut arms: Vec<Leg> = node.arms.iter().map(arm).collect();
    let angle = |arm: &Leg| {
        let direction = arm.chain.direction(0);
        libm::atan2(direction.y, direction.x)
    };
    arms.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    arms
}

/// The counter-clockwise angle from an arm to the next one.
fn gap(a: &Leg, b: &Leg) -> f64 {
    let angle = turn(a.chain.direction(0), b.chain.direction(0));
    if angle <= 0.0 { angle + TAU } else { angle }
}

/// Lays out a junction with kerbs of a given radius. `None` if the arms do not fit.
pub(super) fn layout(node: &ChainNode, chains: &[Polyline], radius: f64) -> Option<JunctionLayout> {
    let arms = arms(node, chains);
    let count = arms.len();
    let pair = |at: usize| (&arms[at], &arms[(at + 1) % count]);
    let mut reach = vec![LEAST_ARM; count];
    let mut meetings = Vec::new();
    for at in 0..count {
        let (a, b) = pair(at);
        let (wide_a, wide_b) = (a.chain.widths, b.chain.widths);
        let most_tangent = MOST_TANGENT * radius;
        let kerb = meet(a, b, [wide_a.half, -wide_b.half], radius, most_tangent)?;
        let walk = wide_a.left.max(wide_b.right);
        let outer = [wide_a.half + wide_a.left, -(wide_b.half + wide_b.right)];
        let inner_radius = (kerb.radius - walk).max(0.0);
        let outer = if walk == 0.0 { None } else { Some(meet(a, b, outer, inner_radius, most_tangent)?) };
        for meeting in [Some(&kerb), outer.as_ref()].into_iter().flatten() {
            reach[at] = reach[at].max(meeting.along[0]);
            reach[(at + 1) % count] = reach[(at + 1) % count].max(meeting.along[1]);
        }
        if count == 2 {
            // Kerbs run obliquely where the widths change.
            let change = (wide_a.half - wide_b.half).abs() + (wide_a.left - wide_b.right).abs();
            reach.iter_mut().for_each(|reach| *reach = reach.max(change));
        }
        meetings.push((kerb, outer, walk));
    }
    let fits = |at: usize| reach[at] <= arms[at].chain.length();
    if !(0..count).all(fits) {
        return None;
    }
    let stations: Vec<Station> = (0..count).map(|at| arms[at].chain.station_after(reach[at])).collect();
    let sections: Vec<CrossSection> = (0..count).map(|at| arms[at].section(chains, stations[at])).collect();
    let (mut roadway, mut corners) = (Vec::new(), Vec::new());
    for (at, (kerb, outer, width)) in meetings.iter().enumerate() {
        let ((a, b), next) = (pair(at), (at + 1) % count);
        let ends = [&sections[at], &sections[next]];
        let line = |meeting: &Meeting, border: usize| {
            let [from, to] = [(ends[0], a, border), (ends[1], b, 3 - border)];
            let mut line: Vec<SidePoint> = trace(from, chains, meeting.along[0]).collect();
            line.reverse();
            line.iter_mut().for_each(|trace| trace.key = (0, -trace.key.1));
            line.extend(arc(&meeting.points, node.point.z));
            line.extend(trace(to, chains, meeting.along[1]));
            line.dedup_by_key(|trace| trace.point);
            line
        };
        let kerb = line(kerb, 1);
        if let Some(outer) = outer {
            corners.push(strip(&kerb, &line(outer, 0), *width)?);
        }
        roadway.extend(kerb.iter().map(|trace| trace.point));
    }
    roadway.dedup();
    if 1 < roadway.len() && roadway[0] == roadway[roadway.len() - 1] {
        roadway.pop();
    }
    if twice_area(&roadway) <= 0 || !is_simple(&roadway) {
        return None;
    }
    let to_chain = |at: usize| {
        let arm = &arms[at];
        let station = if arm.end == 0 { stations[at] } else { arm.chain.reversed_station(stations[at]) };
        (arm.number, arm.end, station)
    };
    Some(JunctionLayout { stations: (0..count).map(to_chain).collect(), roadway: vec![roadway], corners })
}

impl CrossSection {
    /// The distance of the section from the junction of an arm.
    fn along_arm(&self, arm: &Leg) -> f64 {
        if arm.end == 0 { self.along } else { arm.chain.length() - self.along }
    }
}

/// The points of an arm's border from a distance on: the points at the chain's vertices, and last the point of the
/// section where the arm ends.
fn trace(
    (end, arm, border): (&CrossSection, &Leg, usize),
    chains: &[Polyline],
    from: f64,
) -> impl Iterator<Item = SidePoint> {
    let to = end.along_arm(arm);
    let between = move |at: &usize| from + 1e-6 < arm.chain.along[*at] && arm.chain.along[*at] < to - 1e-6;
    let inner = (1..arm.chain.len()).filter(between).map(|at| arm.section(chains, Station::Vertex(at)));
    inner.chain([*end]).map(move |section| SidePoint {
        point: section.borders[border],
        height: section.height,
        key: (2, section.along_arm(arm)),
    })
}

/// The points of an arc from its start to its end.
fn arc(points: &[DVec2], height: f64) -> impl Iterator<Item = SidePoint> {
    let last = points.len().max(2) - 1;
    let key = move |at: usize| (1, at as f64 / last as f64);
    points.iter().enumerate().map(move |(at, &place)| SidePoint { point: Point::near(place), height, key: key(at) })
}

/// Joins the left border of an arm with the right border of the next one.
fn meet(a: &Leg, b: &Leg, distances: [f64; 2], radius: f64, most_tangent: f64) -> Option<Meeting> {
    let gap = gap(a, b);
    let lines = [a.chain.border(distances[0]), b.chain.border(distances[1])];
    if gap < PI - 1e-9
        && let Some((at, place)) = crossing(&lines, [a, b])
    {
        let corner = Meeting {
            points: vec![place],
            along: [0, 1].each(|which| [a, b][which].along(at[which], place)),
            radius: 0.0,
        };
        let mut radii =
            [1.0, 0.5, 0.25, 0.125].each(|part| part * radius).into_iter().filter(|&one| LEAST_RADIUS < one);
        let rounded = radii.find_map(|radius| rounded(&corner, [a, b], distances, radius, most_tangent));
        return rounded.or(Some(corner));
    }
    let off = (gap - PI).abs();
    let directions = [a.chain.direction(0), b.chain.direction(0)];
    if off < 2f64.to_radians() {
        return Some(Meeting::plain(Vec::new()));
    }
    let node = a.chain.place(0);
    let widest = distances[0].abs().max(distances[1].abs());
    if off < 100f64.to_radians() {
        // The mitre, on the other side of the junction.
        let [p, q] = [lines[0][0], lines[1][0]];
        let part = (q - p).perp_dot(directions[1]) / directions[0].perp_dot(directions[1]);
        let mitre = p + directions[0] * part;
        if mitre.distance(node) < 3.0 * widest && PI < gap {
            return Some(Meeting::plain(vec![mitre]));
        }
    }
    if gap < PI {
        // The gap is below a half turn, and the borders do not meet.
        return (off < 20f64.to_radians()).then_some(Meeting::plain(Vec::new()));
    }
    Some(Meeting::plain(fan(node, lines[0][0], lines[1][0])))
}

/// The points of an arc about a place, counter-clockwise.
fn fan(centre: DVec2, from: DVec2, to: DVec2) -> Vec<DVec2> {
    let (from, to) = (from - centre, to - centre);
    let angle = turn(from, to);
    let angle = if angle < 0.0 { angle + TAU } else { angle };
    let steps = (angle.to_degrees() / CORNER_STEP).ceil().max(1.0) as usize;
    let (low, high) = (from.length(), to.length());
    let point = |step: usize| {
        let part = step as f64 / steps as f64;
        let (sin, cos) = (libm::sin(angle * part), libm::cos(angle * part));
        centre + DVec2::new(cos, sin).rotate(from) * ((low + (high - low) * part) / low)
    };
    (0..=steps).map(point).collect()
}

/// The first crossing of two borders: the segments and the position.
fn crossing(lines: &[Vec<DVec2>; 2], arms: [&Leg; 2]) -> Option<([usize; 2], DVec2)> {
    let near = |which: usize| (0..arms[which].chain.len()).take_while(move |&at| arms[which].chain.along[at] < REACH);
    for i in near(0) {
        let [p, q] = [lines[0][i], lines[0][i + 1]];
        for j in near(1) {
            let [r, s] = [lines[1][j], lines[1][j + 1]];
            let across = (q - p).perp_dot(s - r);
            if across.abs() <= 1e-12 * (q - p).length() * (s - r).length() {
                continue;
            }
            let (part, other) = ((r - p).perp_dot(s - r) / across, (r - p).perp_dot(q - p) / across);
            if (0.0..=1.0).contains(&part) && (0.0..=1.0).contains(&other) {
                return Some(([i, j], p + (q - p) * part));
            }
        }
    }
    None
}

/// A corner rounded by an arc of a given radius. Borders shifted outwards by the radius cross at the centre of the arc.
fn rounded(corner: &Meeting, arms: [&Leg; 2], distances: [f64; 2], radius: f64, most_tangent: f64) -> Option<Meeting> {
    let lines = [arms[0].chain.border(distances[0] + radius), arms[1].chain.border(distances[1] - radius)];
    let (at, centre) = crossing(&lines, arms)?;
    let along = [0, 1].each(|which| arms[which].along(at[which], centre));
    let fits = |which: usize| {
        let tangent = along[which] - corner.along[which];
        (0.0..=most_tangent).contains(&tangent) && along[which] < arms[which].chain.length()
    };
    if !(fits(0) && fits(1)) {
        return None;
    }
    let out = [0, 1].each(|which| arms[which].chain.direction(at[which]).perp() * radius);
    let (from, to) = (centre - out[0], centre + out[1]);
    let sweep = turn(from - centre, to - centre);
    // Clockwise as seen from the junction.
    if !(-3.1..=-0.02).contains(&sweep) {
        return None;
    }
    let steps = (-sweep.to_degrees() / CORNER_STEP).ceil() as usize;
    let point = |step: usize| {
        let part = sweep * step as f64 / steps as f64;
        centre + DVec2::new(libm::cos(part), libm::sin(part)).rotate(from - centre)
    };
    Some(Meeting { points: (0..=steps).map(point).collect(), along, radius })
}

/// Returns true if edges of a ring meet only at common points of neighbours.
fn is_simple(ring: &[Point]) -> bool {
    let count = ring.len();
    let edge = |at: usize| (ring[at], ring[(at + 1) % count]);
    let meets = |(a, b): (Point, Point), (c, d): (Point, Point)| {
        !are_apart([a, b], [c, d])
            && orient(a, b, c).signum() * orient(a, b, d).signum() <= 0
            && orient(c, d, a).signum() * orient(c, d, b).signum() <= 0
    };
    (0..count).all(|i| (i + 2..count).filter(|j| (j + 1) % count != i).all(|j| !meets(edge(i), edge(j))))
}

/// The fans that fill the outer sides of a junction whose arms begin at its node: triangles of roadway, and sidewalks.
pub(super) fn fans(node: &ChainNode, chains: &[Polyline]) -> JunctionLayout {
    let arms = arms(node, chains);
    let mut layout = JunctionLayout::default();
    let centre = Point::near(node.point.truncate());
    for at in 0..arms.len() {
        let (a, b) = (&arms[at], &arms[(at + 1) % arms.len()]);
        if arms.len() < 2 || gap(a, b) < PI + 1e-9 {
            continue;
        }
        let ends = [a.section(chains, Station::Vertex(0)), b.section(chains, Station::Vertex(0))];
        let line = |border: usize| {
            let [from, to] = [ends[0].borders[border], ends[1].borders[3 - border]];
            let mut line: Vec<SidePoint> =
                arc(&fan(node.point.truncate(), from.place(), to.place()), node.point.z).collect();
            // The ends must be exactly the ends of the arms.
            let last = line.len() - 1;
            (line[0].point, line[last].point) = (from, to);
            line.dedup_by_key(|trace| trace.point);
            line
        };
        let (kerb, width) = (line(1), a.chain.widths.left.max(b.chain.widths.right));
        let triangle = |edge: &[SidePoint]| vec![centre, edge[0].point, edge[1].point];
        layout.roadway.extend(kerb.windows(2).map(triangle).filter(|ring| 0 < twice_area(ring)));
        layout.corners.extend(strip(&kerb, &line(0), width).filter(|_| 0.0 < width));
    }
    layout
}
