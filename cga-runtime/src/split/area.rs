//! The distribution of a shape's area along an axis, which gives the cuts for parts of given areas.

use glam::DVec3;

use crate::geometry::Axis;
use crate::geometry::each::Each;
use crate::geometry::long_sort::long_sort_by;
use crate::geometry::mesh::FaceRef;
use crate::geometry::tol::{ACROSS_EPSILON, AREA_EPSILON, EDGE_EPSILON};
use crate::geometry::work;
use crate::shape::{Geometry, Placed, Shape};

/// The units of work of a corner, and of a change of the width.
const CORNER: usize = 16;
const CHANGE: usize = 8;

/// The area up to a distance from the scope's low end, as a function of the distance.
#[derive(Debug)]
pub(super) enum Profile {
    /// A total area that is evenly distributed.
    Even(f64),
    /// Sections in which the area grows quadratically. The last one is at the end of the geometry.
    Sections(Vec<WidthSection>),
}

/// The section between two consecutive vertices along the axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct WidthSection {
    /// The start.
    at: f64,
    /// The area before it.
    before: f64,
    /// The width of the geometry at the start.
    width: f64,
    /// The growth of the width per metre.
    growth: f64,
}

impl Profile {
    pub(super) fn new(shape: &Shape, axis: Axis) -> Self {
        let size = shape.scope.size.abs();
        let (other, third) = match axis {
            Axis::X => (size.y, size.z),
            Axis::Y => (size.x, size.z),
            Axis::Z => (size.x, size.y),
        };
        let along = size[axis.index()];
        match &shape.geometry {
            Geometry::Empty | Geometry::Edge | Geometry::Vertex | Geometry::Wire(_) => Profile::Even(0.0),
            Geometry::Box(_) => Profile::Even(2.0 * along * (other + third)),
            Geometry::Rect(normal, _) if *normal == axis => Profile::Even(0.0),
            Geometry::Rect(normal, _) => {
                let mut sides = size;
                sides[normal.index()] = 1.0;
                Profile::Even(sides.element_product())
            }
            Geometry::Mesh(placed) => Profile::Sections(sections(placed, shape.scope.size, axis)),
        }
    }

    /// The total area.
    pub(super) fn total(&self) -> f64 {
        match self {
            Profile::Even(area) => *area,
            Profile::Sections(list) => list.last().map_or(0.0, |end| end.before),
        }
    }

    /// The distance from the low end up to which the area is `area`. In a gap of the geometry it is the low end of the gap. For
    /// the total area it is the end of the scope, so parts fill the scope.
    pub(super) fn distance(&self, area: f64, extent: f64) -> f64 {
        let Profile::Sections(list) = self else { return 0.0 };
        let rounding = self.total() * AREA_EPSILON;
        if self.total() <= area + rounding {
            return extent;
        }
        // The first border that is not below.
        let next = list.partition_point(|section| section.before < area - rounding);
        let Some(border) = list.get(next) else { return list.last().map_or(0.0, |end| end.at) };
        let section = match next.checked_sub(1) {
            Some(index) if area + rounding < border.before => list[index],
            _ => return border.at,
        };
        // width · h + growth / 2 · h² = rest, in the form without cancellation.
        let rest = area - section.before;
        let root = (section.width * section.width + 2.0 * section.growth * rest).max(0.0).sqrt();
        (section.at + 2.0 * rest / (section.width + root)).clamp(section.at, border.at)
    }
}

/// A change of the width and of its growth, at the start or the end of an edge.
#[derive(Clone, Copy)]
struct WidthChange {
    at: f64,
    /// Its number: changes at one place are added in their order.
    number: u32,
    width: f64,
    growth: f64,
}

/// The sections of a mesh; none if the work is to end.
fn sections(placed: &Placed, size: DVec3, axis: Axis) -> Vec<WidthSection> {
    let stretch = placed.stretch(size).abs();
    // Edges without an extent along the axis, except for rounding.
    let across = size[axis.index()].abs() * EDGE_EPSILON;
    // The start of the scope.
    let base = (placed.low * stretch)[axis.index()];
    let mut events = Vec::new();
    for face in placed.mesh.faces() {
        if !work::spend(CORNER * face.corner_count()) {
            return Vec::new();
        }
        add_face(&face, stretch, (axis, base, across), &mut events);
    }
    if !long_sort_by(&mut events, |a, b| a.at.total_cmp(&b.at).then(a.number.cmp(&b.number))) {
        return Vec::new();
    }
    let mut list: Vec<WidthSection> = Vec::new();
    let (mut width, mut growth, mut area) =
        (CompensatedSum::default(), CompensatedSum::default(), CompensatedSum::default());
    for (index, event) in events.iter().enumerate() {
        if !work::spend(CHANGE) {
            return Vec::new();
        }
        // The width at the event, and the area between it and the previous one.
        if let Some(before) = index.checked_sub(1).map(|index| events[index]) {
            let step = event.at - before.at;
            let more = growth.value() * step;
            area.add(((width.value() + 0.5 * more) * step).max(0.0));
            width.add(more);
        }
        width.add(event.width);
        growth.add(event.growth);
        let section =
            WidthSection { at: event.at, before: area.value(), width: width.value().max(0.0), growth: growth.value() };
        match list.last_mut() {
            Some(last) if last.at == event.at => *last = section,
            _ => list.push(section),
        }
    }
    list
}

/// A running sum with twice the digits. A steep edge adds a large number and subtracts it again, which leaves no error here.
#[derive(Clone, Copy, Default)]
struct CompensatedSum {
    high: f64,
    low: f64,
}

impl CompensatedSum {
    fn add(&mut self, value: f64) {
        let sum = self.high + value;
        let part = sum - self.high;
        // The rounding error of the sum (Knuth).
        let lost = (self.high - (sum - part)) + (value - part);
        let low = self.low + lost;
        self.high = sum + low;
        self.low = low - (self.high - sum);
    }

    fn value(self) -> f64 {
        self.high
    }
}

/// Adds the edges of a face that are longer than `least` along the axis, as events at places relative to `base`.
/// The area below a place is the signed sum of the areas below the edges, each up to its end. The line that closes
/// the face at the place runs across the axis and adds nothing.
fn add_face(face: &FaceRef<'_>, stretch: DVec3, (axis, base, least): (Axis, f64, f64), events: &mut Vec<WidthChange>) {
    let at = axis.index();
    let normal = face.stretched_normal(stretch);
    // The direction of the axis within the face: a metre in it is `slant` along the axis.
    let mut axis_vector = DVec3::ZERO;
    axis_vector[at] = 1.0;
    let within = axis_vector - normal * normal[at];
    let slant = within.length();
    if normal == DVec3::ZERO || slant <= ACROSS_EPSILON {
        return;
    }
    let across = normal.cross(within / slant);
    let origin = face.position(face.corner_range().start) * stretch;
    for ring in face.loop_ranges() {
        let count = ring.len();
        for corner in 0..count {
            let [a, b] = [corner, (corner + 1) % count].each(|corner| face.position(ring.start + corner) * stretch);
            let (low, high, sign) = if a[at] < b[at] { (a, b, -1.0) } else { (b, a, 1.0) };
            let length = high[at] - low[at];
            if length <= least {
                continue;
            }
            let width = |point: DVec3| sign * across.dot(point - origin) / slant;
            let (first, last) = (width(low), width(high));
            let growth = (last - first) / length;
            let number = events.len() as u32;
            events.push(WidthChange { at: low[at] - base, number, width: first, growth });
            events.push(WidthChange { at: high[at] - base, number: number + 1, width: -last, growth: -growth });
        }
    }
}
