//! The inside of a closed surface.

use glam::{DVec2, DVec3};

use crate::geometry::exact::orient;
use crate::geometry::mesh::Bounds;
use crate::value::each::Each;

/// The most columns along an axis.
const MOST_COLUMNS: usize = 256;

/// The triangles of a closed surface, sorted into columns along y.
#[derive(Debug)]
pub(super) struct Solid {
    triangles: Vec<[DVec3; 3]>,
    /// The low corner of the columns in x and z, and the columns per length.
    low: DVec2,
    per_length: DVec2,
    columns: usize,
    /// The triangles of each column, by number.
    lists: Vec<Vec<u32>>,
}

fn flat(point: DVec3) -> DVec2 {
    DVec2::new(point.x, point.z)
}

impl Solid {
    pub(super) fn new(triangles: Vec<[DVec3; 3]>) -> Self {
        let bounds = Bounds::of(triangles.iter().flatten().copied());
        let columns = ((triangles.len() as f64 / 4.0).sqrt() as usize).clamp(1, MOST_COLUMNS);
        let extent = flat(bounds.high) - flat(bounds.low);
        let per_length = DVec2::select(extent.cmpgt(DVec2::ZERO), columns as f64 / extent, DVec2::ZERO);
        let low = flat(bounds.low);
        let mut solid = Solid { triangles, low, per_length, columns, lists: vec![Vec::new(); columns * columns] };
        for (number, triangle) in (0..).zip(&solid.triangles) {
            let corners = triangle.each(flat);
            let first = solid.column(corners[0].min(corners[1]).min(corners[2]));
            let last = solid.column(corners[0].max(corners[1]).max(corners[2]));
            for row in first[1]..=last[1] {
                for column in first[0]..=last[0] {
                    solid.lists[row * columns + column].push(number);
                }
            }
        }
        solid
    }

    fn column(&self, point: DVec2) -> [usize; 2] {
        let place = (point - self.low) * self.per_length;
        // A cast takes negative numbers to 0.
        [place.x, place.y].each(|at| (at as usize).min(self.columns - 1))
    }

    pub(super) fn bounds(&self) -> Bounds {
        Bounds::of(self.triangles.iter().flatten().copied())
    }

    pub(super) fn all(&self) -> Vec<u32> {
        (0..self.triangles.len() as u32).collect()
    }

    /// Returns true if the surface winds around a point. A point above or below an edge is on the side of it that [`side`] tells, for
    /// both triangles at the edge, so it meets one of them.
    pub(super) fn contains(&self, point: DVec3) -> bool {
        let ([column, row], at) = (self.column(flat(point)), flat(point));
        let mut winding = 0;
        for &number in &self.lists[row * self.columns + column] {
            let triangle = self.triangles[number as usize];
            let [a, b, c] = triangle.each(flat);
            let sides = [side(a, b, at), side(b, c, at), side(c, a, at)];
            // A triangle that is upright is never met.
            if sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2] && point.y < height(triangle, at) {
                winding += sides[0];
            }
        }
        winding != 0
    }

    /// The triangles of a list that may come into a box.
    pub(super) fn crossing(&self, list: &[u32], low: DVec3, high: DVec3) -> Vec<u32> {
        list.iter().copied().filter(|&number| may_cross(&self.triangles[number as usize], low, high)).collect()
    }
}

/// The side of a line on which a point is after an infinitely small move to the right, and a far smaller one upwards: 1 on the left, -1 on
/// the right, 0 if the line has no direction.
fn side(a: DVec2, b: DVec2, at: DVec2) -> i32 {
    let sign = |number: f64| i32::from(0.0 < number) - i32::from(number < 0.0);
    match orient(a, b, at) {
        0 if a.y != b.y => sign(a.y - b.y),
        0 => sign(b.x - a.x),
        known => known,
    }
}

/// The height of the plane of a triangle over a point.
fn height([a, b, c]: [DVec3; 3], at: DVec2) -> f64 {
    let normal = (b - a).cross(c - a);
    a.y - (normal.x * (at.x - a.x) + normal.z * (at.y - a.z)) / normal.y
}

/// Returns false if the triangle is beyond a side of the box, or if the box is on one side of its plane.
fn may_cross([a, b, c]: &[DVec3; 3], low: DVec3, high: DVec3) -> bool {
    if a.min(*b).min(*c).cmpgt(high).any() || a.max(*b).max(*c).cmplt(low).any() {
        return false;
    }
    let normal = (*b - *a).cross(*c - *a);
    let (centre, half) = ((low + high) * 0.5, (high - low) * 0.5);
    let (distance, reach) = (normal.dot(centre - *a).abs(), normal.abs().dot(half));
    // The margin covers rounding.
    distance <= reach + 1e-12 * normal.length() * (1.0 + centre.abs().max_element())
}
