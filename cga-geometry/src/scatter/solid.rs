//! The inside of a closed surface.

use glam::{DVec2, DVec3};

use crate::each::Each;
use crate::mesh::Bounds;
use crate::upward_ray::{flat, winding_part};
use crate::work;

/// The most columns along an axis.
const MOST_COLUMNS: usize = 256;

/// The triangles that are tested between two counts of work.
const PART: usize = 4096;

/// The most columns of a triangle on average, and the units of work of each.
const MOST_OF_ONE: usize = 16;
const COLUMN: usize = 4;

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

impl Solid {
    pub(super) fn new(triangles: Vec<[DVec3; 3]>) -> Self {
        let bounds = Bounds::of(triangles.iter().flatten().copied());
        let columns = ((triangles.len() as f64 / 4.0).sqrt() as usize).clamp(1, MOST_COLUMNS);
        let low = flat(bounds.low);
        let mut solid = Solid { triangles, low, per_length: DVec2::ZERO, columns, lists: Vec::new() };
        let extent = flat(bounds.high) - low;
        loop {
            solid.per_length = DVec2::select(extent.cmpgt(DVec2::ZERO), solid.columns as f64 / extent, DVec2::ZERO);
            let count = |triangle: &[DVec3; 3]| {
                let [first, last] = solid.columns_of(triangle);
                (last[0] - first[0] + 1) * (last[1] - first[1] + 1)
            };
            let parts = solid.triangles.chunks(PART).take_while(|part| work::spend(2 * part.len()));
            let all: usize = parts.flatten().map(count).sum();
            // Long triangles across the columns are in many of them.
            if solid.columns == 1 || all <= MOST_OF_ONE * solid.triangles.len() {
                break;
            }
            solid.columns /= 2;
        }
        let columns = solid.columns;
        solid.lists = vec![Vec::new(); columns * columns];
        for (number, triangle) in (0..).zip(&solid.triangles) {
            let [first, last] = solid.columns_of(triangle);
            if !work::spend(COLUMN * (last[0] - first[0] + 1) * (last[1] - first[1] + 1)) {
                break;
            }
            for row in first[1]..=last[1] {
                for column in first[0]..=last[0] {
                    solid.lists[row * columns + column].push(number);
                }
            }
        }
        solid
    }

    /// The first and the last column over a triangle, along x and z.
    fn columns_of(&self, triangle: &[DVec3; 3]) -> [[usize; 2]; 2] {
        let corners = triangle.each(flat);
        let [low, high] = [corners[0].min(corners[1]).min(corners[2]), corners[0].max(corners[1]).max(corners[2])];
        [low, high].each(|corner| self.column(corner))
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

    /// Returns true if the surface winds around a point, without rounding.
    pub(super) fn contains(&self, point: DVec3) -> bool {
        let [column, row] = self.column(flat(point));
        let list = &self.lists[row * self.columns + column];
        if !work::spend(4 * list.len()) {
            return false;
        }
        let parts = list.iter().map(|&number| winding_part(point, self.triangles[number as usize]));
        parts.sum::<i32>() != 0
    }

    /// The triangles of a list that may come into a box. Some are missing if the work is to end.
    pub(super) fn crossing(&self, list: &[u32], low: DVec3, high: DVec3) -> Vec<u32> {
        let may_cross = |&number: &u32| may_cross(&self.triangles[number as usize], low, high);
        let parts = list.chunks(PART).take_while(|part| work::spend(2 * part.len()));
        parts.flatten().copied().filter(may_cross).collect()
    }
}

/// Returns false if the triangle is beyond a side of the box, or if the box is on one side of its plane. Triangles that only touch the
/// box may cross it, so that rounding does not decide.
fn may_cross([a, b, c]: &[DVec3; 3], low: DVec3, high: DVec3) -> bool {
    let (centre, half) = ((low + high) * 0.5, (high - low) * 0.5);
    let margin = 1e-12 * (1.0 + centre.abs().max_element());
    if a.min(*b).min(*c).cmpgt(high + margin).any() || a.max(*b).max(*c).cmplt(low - margin).any() {
        return false;
    }
    let normal = (*b - *a).cross(*c - *a);
    let (distance, reach) = (normal.dot(centre - *a).abs(), normal.abs().dot(half));
    distance <= reach + margin * normal.length()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Rng;

    /// A tetrahedron with whole coordinates, whose first three corners are counter-clockwise from above.
    fn tetrahedron(rng: &mut Rng) -> [DVec3; 4] {
        let mut coordinate = || ((rng.next() % (1 << 20)) as f64 - f64::from(1 << 19)) * 64.0;
        let mut corner = || DVec3::new(coordinate(), coordinate(), coordinate());
        let [a, b, c] = [corner(), corner(), corner()];
        let [a, b, c] = if (b - a).cross(c - a).y < 0.0 { [a, c, b] } else { [a, b, c] };
        let middle = ((a + b + c) / 192.0).floor() * 64.0;
        [a, b, c, middle - DVec3::Y * f64::from(1 << 27)]
    }

    #[test]
    fn one_ulp_inside_is_inside_and_one_ulp_outside_is_outside() {
        let mut rng = Rng(11);
        for _ in 0..2000 {
            let [a, b, c, d] = tetrahedron(&mut rng);
            let solid = Solid::new(vec![[a, b, c], [a, d, b], [b, d, c], [c, d, a]]);
            // A point with whole coordinates in the face above, on an edge or on a corner of it.
            let i = (rng.next() % 65) as f64;
            let j = (rng.next() % (65 - i as u64)) as f64;
            let on = a + (b - a) / 64.0 * i + (c - a) / 64.0 * j;
            let is_within = 0.0 < i && 0.0 < j && i + j < 64.0;
            assert!(!solid.contains(on.with_y(on.y.next_up())), "{a} {b} {c}: above {on}");
            assert!(!is_within || solid.contains(on.with_y(on.y.next_down())), "{a} {b} {c}: below {on}");
        }
    }
}
