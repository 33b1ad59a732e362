//! Buildings in each other.

use std::f64::consts::PI;

use cga::glam::DVec3;
use cga::mesh::Bounds;

use crate::finding::Finding;
use crate::survey::{Survey, Triangle};

/// The depth in metres from which a part is inside of another building.
const DEPTH: f64 = 0.03;

/// A building: its box and its triangles.
struct Building {
    bounds: Bounds,
    triangles: Vec<Triangle>,
}

/// The triangles of buildings that lie inside of another building.
pub fn nested(survey: &Survey) -> Vec<Finding> {
    let count = survey.parts.iter().map(|part| part.building + 1).max().unwrap_or(0);
    let mut buildings: Vec<Building> =
        (0..count).map(|_| Building { bounds: Bounds::EMPTY, triangles: Vec::new() }).collect();
    for triangle in &survey.triangles {
        let building = &mut buildings[survey.parts[triangle.part as usize].building as usize];
        for corner in triangle.corners {
            building.bounds.low = building.bounds.low.min(corner);
            building.bounds.high = building.bounds.high.max(corner);
        }
        building.triangles.push(*triangle);
    }
    let mut findings = Vec::new();
    for (at, inner) in buildings.iter().enumerate() {
        let others = buildings.iter().enumerate().filter(|(other, _)| *other != at);
        for (_, outer) in others {
            for triangle in inner.triangles.iter().filter(|triangle| outer.may_contain(triangle)) {
                let is_inside = |place: &DVec3| {
                    let sides = [DEPTH, -DEPTH].map(|depth| *place + triangle.normal * depth);
                    sides.iter().all(|side| outer.contains(*side))
                };
                let place = samples(triangle).find(is_inside);
                findings.extend(place.map(|place| Finding { parts: vec![triangle.part], place, side: None }));
            }
        }
    }
    findings
}

/// Places on a triangle, about half a metre apart.
fn samples(triangle: &Triangle) -> impl Iterator<Item = DVec3> {
    let [a, b, c] = triangle.corners;
    let longest = [a - b, b - c, c - a].iter().map(|side| side.length()).fold(0.0, f64::max);
    let count = (longest / 0.5).ceil().clamp(1.0, 24.0) as usize;
    let place = move |column: usize, row: usize| {
        let [u, v] = [column, row].map(|at| (at as f64 + 1.0 / 3.0) / count as f64);
        a + (b - a) * u + (c - a) * v
    };
    (0..count).flat_map(move |row| (0..count - row).map(move |column| place(column, row)))
}

impl Building {
    /// Returns true if the boxes of the building and of a triangle overlap.
    fn may_contain(&self, triangle: &Triangle) -> bool {
        let Bounds { low, high } = self.bounds;
        let [a, b, c] = triangle.corners;
        (low + DEPTH).cmplt(a.max(b).max(c)).all() && a.min(b).min(c).cmplt(high - DEPTH).all()
    }

    /// Returns true if a point is inside: the surfaces fill more than half of the directions from there.
    fn contains(&self, point: DVec3) -> bool {
        let Bounds { low, high } = self.bounds;
        let within = (low + DEPTH).cmplt(point).all() && point.cmplt(high - DEPTH).all();
        within && 0.6 < self.share_of_directions(point)
    }

    /// The share of the directions from a point that surfaces fill, positive where their backs are seen.
    ///
    /// Half of the solid angle of a triangle is the angle of a complex number. So the sum for all triangles is the angle of their product, and its
    /// full turns are counted on the way.
    fn share_of_directions(&self, point: DVec3) -> f64 {
        let (mut turns, mut re, mut im) = (0.0, 1.0, 0.0);
        for triangle in &self.triangles {
            let (along, across) = half_solid_angle(triangle, point);
            let length = libm::sqrt(along * along + across * across);
            if length == 0.0 {
                continue;
            }
            let product = ((re * along - im * across) / length, (re * across + im * along) / length);
            if 0.0 <= im && 0.0 <= across && product.1 < 0.0 {
                turns += 1.0;
            } else if im < 0.0 && across < 0.0 && 0.0 <= product.1 {
                turns -= 1.0;
            }
            (re, im) = product;
        }
        turns + libm::atan2(im, re) / (2.0 * PI)
    }
}

/// A complex number with half of the signed solid angle of a triangle, which is positive if its back is seen.
fn half_solid_angle(triangle: &Triangle, point: DVec3) -> (f64, f64) {
    let [a, b, c] = triangle.corners.map(|corner| corner - point);
    let [la, lb, lc] = [a.length(), b.length(), c.length()];
    (la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb, a.dot(b.cross(c)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A star of triangles around the origin: from each edge of some polygons to its neighbours.
    fn sphere(rows: u32, columns: u32, inwards: bool) -> Building {
        let place = |row: u32, column: u32| {
            let (up, around) =
                (PI * f64::from(row) / f64::from(rows), 2.0 * PI * f64::from(column) / f64::from(columns));
            DVec3::new(libm::sin(up) * libm::cos(around), libm::cos(up), libm::sin(up) * libm::sin(around))
        };
        let mut triangles = Vec::new();
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            let [a, b] = [place(row, column), place(row, column + 1)];
            let [c, d] = [place(row + 1, column + 1), place(row + 1, column)];
            for corners in [[a, b, c], [a, c, d]] {
                let corners = if inwards { [corners[0], corners[2], corners[1]] } else { corners };
                triangles.push(Triangle { corners, normal: DVec3::Y, part: 0 });
            }
        }
        Building { bounds: Bounds::EMPTY, triangles }
    }

    fn by_angles(building: &Building, point: DVec3) -> f64 {
        let angle = |triangle: &Triangle| {
            let (along, across) = half_solid_angle(triangle, point);
            libm::atan2(across, along)
        };
        building.triangles.iter().map(angle).sum::<f64>() / (2.0 * PI)
    }

    #[test]
    fn the_share_is_the_sum_of_the_angles() {
        for inwards in [false, true] {
            for (rows, columns) in [(2, 3), (5, 8), (20, 31)] {
                let mut building = sphere(rows, columns, inwards);
                for number in 0..60 {
                    let at = f64::from(number) * 0.05 - 1.51;
                    let point = DVec3::new(at, 0.3 * at, 0.17 - 0.2 * at);
                    let [share, sum] = [building.share_of_directions(point), by_angles(&building, point)];
                    assert!((share - sum).abs() < 1e-9, "{share} {sum}");
                }
                // Also twice around, and with a hole.
                building.triangles.extend_from_within(..);
                building.triangles.pop();
                let [share, sum] =
                    [building.share_of_directions(DVec3::splat(0.1)), by_angles(&building, DVec3::splat(0.1))];
                assert!((share - sum).abs() < 1e-9 && 1.5 < share.abs(), "{share} {sum}");
            }
        }
    }
}
