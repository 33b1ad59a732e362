//! Cracks between triangles, as graphics cards show them.

use std::collections::HashMap;

use cga::glam::DVec3;

use crate::raster;

/// A list of triangles with corners of 32-bit floats.
pub struct Triangles<'a> {
    pub positions: &'a [[f32; 3]],
    pub indices: &'a [u32],
}

/// Cards round corners to parts of a pixel.
const GRID: f64 = 256.0;

/// Points at this share of the largest coordinate from an edge are in it.
const IN_EDGE: f64 = 2e-7;

/// Triangles whose normals have at least this product are in one plane.
const FLAT: f64 = 0.999_999;

/// A pinhole is deeper than the surfaces around it by this share of the diagonal.
const DEEPER: f64 = 0.005;

impl Triangles<'_> {
    fn corners(&self) -> impl Iterator<Item = [DVec3; 3]> + '_ {
        self.indices.chunks_exact(3).map(|ids| [0, 1, 2].map(|k| point(self.positions[ids[k] as usize])))
    }

    /// The number of distinct points that lie inside of distinct edges. An edge between two triangles of one plane does not count: both have
    /// it, and the surface goes on, so a point that touches it is no crack.
    pub fn points_inside_edges(&self) -> usize {
        let mut numbers: HashMap<[u32; 3], usize> = HashMap::new();
        let mut points: Vec<DVec3> = Vec::new();
        // The ends of the edges of triangles, the lower one first, with the normal and whether the triangle goes from the lower end.
        let mut uses: Vec<([usize; 2], bool, DVec3)> = Vec::new();
        for ids in self.indices.chunks_exact(3) {
            let ends = [0, 1, 2].map(|k| {
                let position = self.positions[ids[k] as usize];
                *numbers.entry(position.map(|c| (c + 0.0).to_bits())).or_insert_with(|| {
                    points.push(point(position));
                    points.len() - 1
                })
            });
            let [a, b, c] = ends.map(|end| points[end]);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            uses.extend([[0, 1], [1, 2], [2, 0]].map(|[from, to]| {
                let [from, to] = [ends[from], ends[to]];
                ([from.min(to), from.max(to)], from < to, normal)
            }));
        }
        uses.sort_by_key(|(ends, ..)| *ends);
        let is_flat = |uses: &[([usize; 2], bool, DVec3)]| {
            uses.iter().any(|(_, from_low, a)| uses.iter().any(|(_, other, b)| from_low != other && FLAT <= a.dot(*b)))
        };
        let edges: Vec<[usize; 2]> =
            uses.chunk_by(|a, b| a.0 == b.0).filter(|uses| !is_flat(uses)).map(|uses| uses[0].0).collect();
        let reach = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
        // Points along x, so that an edge is compared with those between its ends alone.
        points.sort_unstable_by(|a, b| a.x.total_cmp(&b.x));
        let near = IN_EDGE * reach;
        let mut places: Vec<DVec3> = vec![DVec3::ZERO; numbers.len()];
        numbers.iter().for_each(|(bits, number)| places[*number] = point(bits.map(f32::from_bits)));
        let inside = |&[a, b]: &[usize; 2]| {
            let [from, to] = [places[a], places[b]];
            let (length, low, high) = ((to - from).length(), from.min(to) - near, from.max(to) + near);
            let along = (to - from) / length;
            let first = points.partition_point(|point| point.x < low.x);
            let between = points[first..].iter().take_while(move |point| point.x <= high.x);
            between
                .filter(|point| low.cmple(**point).all() && point.cmple(high).all())
                .filter(|point| {
                    let distance = (**point - from).dot(along);
                    let is_between = 8.0 * near < distance && distance < length - 8.0 * near;
                    is_between && (**point - from - along * distance).length() <= near
                })
                .count()
        };
        edges.iter().map(inside).sum()
    }

    /// The number of pixels in a picture from one side, in degrees, in which a crack shows what is behind the surfaces around it.
    pub fn pinholes(&self, azimuth: f64, elevation: f64, pixels: usize) -> usize {
        let (a, e) = (azimuth.to_radians(), elevation.to_radians());
        let towards = DVec3::new(libm::sin(a) * libm::cos(e), libm::sin(e), libm::cos(a) * libm::cos(e));
        let right = DVec3::Y.cross(towards).normalize_or(DVec3::X);
        let up = towards.cross(right);
        let all = || self.positions.iter().map(|position| point(*position));
        let low = all().fold(DVec3::INFINITY, DVec3::min);
        let high = all().fold(DVec3::NEG_INFINITY, DVec3::max);
        let (centre, diagonal) = ((low + high) * 0.5, (high - low).length());
        let scale = (pixels as f64 - 8.0) / diagonal;
        let middle = 0.5 * pixels as f64;
        let project = |corner: DVec3| {
            let from = corner - centre;
            // Cards compute in 32 bits.
            let at = [middle + from.dot(right) * scale, middle - from.dot(up) * scale].map(|c| f64::from(c as f32));
            [at[0], at[1], from.dot(towards)]
        };
        let mut exact = vec![-diagonal; pixels * pixels];
        let mut closed = exact.clone();
        for corners in self.corners() {
            let corners = corners.map(project);
            raster::snapped(corners, GRID, pixels, &mut |pixel, depth| exact[pixel] = depth.max(exact[pixel]));
            raster::pixels(corners, [pixels; 2], -2.0 / GRID, &mut |pixel, depth| {
                closed[pixel] = depth.max(closed[pixel])
            });
        }
        let is_pinhole = |pixel: &usize| {
            let (x, y) = (pixel % pixels, pixel / pixels);
            if x == 0 || y == 0 || x + 1 == pixels || y + 1 == pixels {
                return false;
            }
            let around = [-1, 0, 1].iter().flat_map(|row: &isize| [-1, 0, 1].map(|column: isize| (*row, column)));
            let others = around
                .filter(|step| *step != (0, 0))
                .map(|(row, column)| exact[(y as isize + row) as usize * pixels + (x as isize + column) as usize]);
            let nearest_behind = others.fold(f64::INFINITY, f64::min) - DEEPER * diagonal;
            exact[*pixel] < nearest_behind && nearest_behind <= closed[*pixel]
        };
        (0..pixels * pixels).filter(is_pinhole).count()
    }
}

fn point(position: [f32; 3]) -> DVec3 {
    DVec3::from_array(position.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two rows of rectangles in front of nothing, the lower one of `below` and the upper one of `above` rectangles.
    fn rows(below: u32, above: u32) -> (Vec<[f32; 3]>, Vec<u32>) {
        let (mut positions, mut indices) = (Vec::new(), Vec::new());
        for (row, count) in [(0.0, below), (1.0, above)] {
            for at in 0..count {
                let [from, to] = [at, at + 1].map(|at| 7.0 * at as f32 / count as f32);
                let start = positions.len() as u32;
                positions.extend([[from, row, 0.0], [to, row, 0.0], [to, row + 1.0, 0.0], [from, row + 1.0, 0.0]]);
                indices.extend([0, 1, 2, 0, 2, 3].map(|corner| start + corner));
            }
        }
        (positions, indices)
    }

    #[test]
    fn rows_of_different_rectangles_have_cracks() {
        let cracks = |below, above| {
            let (positions, indices) = rows(below, above);
            let triangles = Triangles { positions: &positions, indices: &indices };
            let pinholes: usize = (0..24).map(|view| triangles.pinholes(f64::from(view) * 3.0 - 35.0, 11.0, 400)).sum();
            [triangles.points_inside_edges(), pinholes]
        };
        assert_eq!(cracks(4, 4), [0, 0]);
        // The corner of a triangle that touches the diagonal of a rectangle.
        let (mut positions, mut indices) = rows(1, 0);
        positions.extend([[3.5, 0.5, 0.0], [3.5, 0.5, 1.0], [4.5, 0.5, 1.0]]);
        indices.extend([4, 5, 6]);
        assert_eq!(Triangles { positions: &positions, indices: &indices }.points_inside_edges(), 0);
        // The same corner in the edge of one triangle.
        indices.drain(3..6);
        assert_eq!(Triangles { positions: &positions, indices: &indices }.points_inside_edges(), 1);
        let [points, pinholes] = cracks(3, 7);
        assert!(points == 8 && 0 < pinholes, "{points} points, {pinholes} pinholes");
    }
}
