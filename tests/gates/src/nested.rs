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
        within && 0.6 < self.triangles.iter().map(|triangle| solid_angle(triangle, point)).sum::<f64>() / (4.0 * PI)
    }
}

/// The signed solid angle of a triangle, positive if its back is seen.
fn solid_angle(triangle: &Triangle, point: DVec3) -> f64 {
    let [a, b, c] = triangle.corners.map(|corner| corner - point);
    let [la, lb, lc] = [a.length(), b.length(), c.length()];
    let volume = a.dot(b.cross(c));
    let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * libm::atan2(volume, below)
}
