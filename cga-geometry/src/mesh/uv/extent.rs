//! The range of texture coordinates, and its length on the surface.
//!
//! Metres come from the stretch of the surface along a coordinate: the length of the derivative of the position by the
//! coordinate, with the other coordinate constant. The mean stretch is weighted by area in texture space. So a street
//! with u from 0 to 1 gets the mean length of its lines of constant v, which is about the length of its centre line,
//! however u is distributed among its faces. For a flat face with an affine chart the result is exact.
//!
//! Faces on one line of texture space, such as slopes that a projection sees edge-on, have no area there and do not count.
//! If the coordinates span no area, because v is constant or depends on u, the mean width of the bands between lines of
//! constant u is used instead.

use glam::{DVec2, DVec3};

use super::UvAxis;
use crate::each::Each;
use crate::mesh::{Bounds, Mesh};
use crate::tol::{CHART_EPSILON, NEXT_EPSILON};
use crate::triangulate::Triangulator;
use crate::work;

/// The units of work of a corner whose stretch is measured.
const CORNER: usize = 16;

/// The smallest and largest coordinates of a texture set, and the metres between them on the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UvExtent {
    /// The smallest u and the smallest v.
    pub low: DVec2,
    /// The largest u and the largest v.
    pub high: DVec2,
    /// The length of `high - low` on the surface in metres; 0 if a coordinate is constant or the surface has no area.
    pub metres: DVec2,
}

impl UvExtent {
    /// The largest minus the smallest coordinates.
    pub fn size(&self) -> DVec2 {
        self.high - self.low
    }

    /// The coordinate at a distance in metres from the smallest one, for the lines of a split in unit space. If the
    /// extent is 0 metres, it is the smallest coordinate.
    pub fn at_metres(&self, axis: UvAxis, metres: f64) -> f64 {
        let (low, high, all) = (self.low[axis.index()], self.high[axis.index()], self.metres[axis.index()]);
        if all == 0.0 {
            return low;
        }
        let share = metres / all;
        let at = low + (high - low) * share;
        if at.is_finite() { at } else { low * (1.0 - share) + high * share }
    }
}

/// The smallest and the largest coordinates of a list; `None` if it is empty.
pub fn range(uvs: &[DVec2]) -> Option<[DVec2; 2]> {
    let first = *uvs.first()?;
    Some(uvs.iter().fold([first; 2], |[low, high], &uv| [low.min(uv), high.max(uv)]))
}

/// The largest minus the smallest coordinates; 0 if the difference is a rounding error.
pub fn spread([low, high]: [DVec2; 2]) -> DVec2 {
    let size = high - low;
    let far = low.abs().max(high.abs()).max(DVec2::ONE);
    DVec2::select(size.cmple(far * NEXT_EPSILON), DVec2::ZERO, size)
}

/// Sums over triangles of the surface, for u and for v.
#[derive(Default)]
struct Sums {
    /// The sum of stretch times area in texture space, and the sum of that area.
    stretched: DVec2,
    chart: f64,
    /// The sum of areas on the surface, and the sum of these areas times the gradient of the coordinate.
    area: DVec2,
    change: DVec2,
}

impl Mesh {
    /// The smallest and the largest coordinates of a set, without metres. `None` if the mesh does not have the set.
    pub fn uv_range(&self, set: usize) -> Option<[DVec2; 2]> {
        range(self.uv_set(set))
    }

    /// The range of a texture set and its metres, after the mesh is stretched along its axes. `None` if the mesh does
    /// not have the set.
    pub fn uv_extent(&self, set: usize, stretch: DVec3) -> Option<UvExtent> {
        let [low, high] = self.uv_range(set)?;
        // Powers of two scale positions and coordinates to about 1, so that products do not overflow and scaling does
        // not round.
        let bounds = self.bounds();
        let stretched = Bounds::of([bounds.low * stretch, bounds.high * stretch]);
        let unit = stretched.scale_to_one();
        let one = |low: f64, high: f64| Bounds { low: DVec3::splat(low), high: DVec3::splat(high) }.scale_to_one();
        let scale = DVec2::new(one(low.x, high.x), one(low.y, high.y));
        let range = high * scale - low * scale;
        // A difference that is only rounding, relative to the largest of both coordinates, counts as constant.
        let far = low.abs().max(high.abs()).max_element();
        let is_constant = (high * 0.5 - low * 0.5).cmple(DVec2::splat(far * 0.5 * NEXT_EPSILON));
        let varied = DVec2::select(is_constant, DVec2::INFINITY, range);
        let sums = self.sum_stretch(set, stretch, unit, scale, varied);
        let metres = [0, 1].each(|axis| {
            let mean =
                if sums.chart == 0.0 { sums.area[axis] / sums.change[axis] } else { sums.stretched[axis] / sums.chart };
            let metres = range[axis] * mean / unit;
            if metres.is_finite() { metres } else { 0.0 }
        });
        Some(UvExtent { low, high, metres: DVec2::from(metres) })
    }

    fn sum_stretch(&self, set: usize, stretch: DVec3, unit: f64, scale: DVec2, range: DVec2) -> Sums {
        let uvs = self.uv_set(set);
        let mut triangulator = Triangulator::new();
        let (mut triangles, mut sums) = (Vec::new(), Sums::default());
        for face in 0..self.face_count() {
            if !work::spend(CORNER * self.face_corners(face).len()) {
                break;
            }
            triangles.clear();
            triangulator.face(self, face, &mut triangles);
            for triangle in &triangles {
                let [a, b, c] = triangle.each(|corner| {
                    let corner = corner as usize;
                    (self.points[self.corners[corner] as usize] * stretch * unit, uvs[corner] * scale)
                });
                sums.add([b.0 - a.0, c.0 - a.0], [b.1 - a.1, c.1 - a.1], range);
            }
        }
        sums
    }
}

impl Sums {
    /// Adds a triangle, given by two of its edges in space and in texture space. A constant coordinate has no stretch.
    fn add(&mut self, [p, q]: [DVec3; 2], [a, b]: [DVec2; 2], range: DVec2) {
        let varies = a.abs().max(b.abs()).max((a - b).abs()).cmpgt(range * CHART_EPSILON);
        let chart = (a.x * b.y - a.y * b.x).abs();
        // Relative to the longest edge: a slope that is seen edge-on is on a line of texture space, except for rounding.
        let longest = [a, b, a - b].into_iter().fold(0.0, |most: f64, edge| most.max((edge / range).length_squared()));
        if varies.all() && CHART_EPSILON * longest * range.x * range.y < chart {
            self.stretched += DVec2::new((p * b.y - q * a.y).length(), (q * a.x - p * b.x).length());
            self.chart += chart;
        }
        let area = p.cross(q).length();
        for axis in [0, 1].into_iter().filter(|&axis| varies.test(axis)) {
            self.area[axis] += area;
            self.change[axis] += (q * a[axis] - p * b[axis]).length();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{FaceTag, MeshBuilder};

    /// Faces by their corners, each with a position on the ground and its coordinates.
    fn mesh(faces: &[&[([f64; 2], [f64; 2])]]) -> Mesh {
        let mut builder = MeshBuilder::new();
        for face in faces {
            let corners: Vec<u32> = face.iter().map(|(p, _)| builder.point([p[0], 0.0, -p[1]])).collect();
            let uvs: Vec<DVec2> = face.iter().map(|&(_, uv)| uv.into()).collect();
            builder.face(&corners, &[], FaceTag::PLAIN).uvs(&uvs);
        }
        builder.build().unwrap()
    }

    fn extent(mesh: &Mesh) -> UvExtent {
        mesh.uv_extent(0, DVec3::ONE).unwrap()
    }

    /// A quad in the order of its corners, with u from one number to another and v from 0 to 1.
    fn quad(corners: [[f64; 2]; 4], u: [f64; 2]) -> [([f64; 2], [f64; 2]); 4] {
        let [a, b, c, d] = corners;
        [(a, [u[0], 0.0]), (b, [u[1], 0.0]), (c, [u[1], 1.0]), (d, [u[0], 1.0])]
    }

    #[test]
    fn a_flat_rectangle_is_measured_exactly() {
        for (width, height) in [(10.0, 3.0), (13.7, 0.1), (1e-3, 1e7), (3e199, 1e200), (1e-200, 5e-190)] {
            let corners = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
            let found = extent(&mesh(&[&quad(corners, [0.0, 1.0])]));
            assert_eq!((found.metres, found.size()), (DVec2::new(width, height), DVec2::ONE), "{width} {height}");
            let metric = corners.map(|p| (p, p));
            assert_eq!(extent(&mesh(&[&metric])).metres, DVec2::new(width, height));
            let mirrored = corners.map(|p| (p, [-2.0 * p[1], 3.0 * p[0]]));
            let metres = extent(&mesh(&[&mirrored])).metres;
            assert!((metres / DVec2::new(height, width) - 1.0).abs().max_element() < 1e-12, "{metres}");
        }
    }

    #[test]
    fn a_coordinate_that_is_constant_but_for_rounding_does_not_count() {
        let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
        let even = extent(&mesh(&[&corners.map(|p| (p, [p[0] / 4.0 + p[1] / 6.0, 0.3]))]));
        let rounded = [0.3, 0.3 + 6e-17, 0.3, 0.3 + 1.2e-16];
        let noisy: Vec<_> = corners.iter().zip(rounded).map(|(&p, v)| (p, [p[0] / 4.0 + p[1] / 6.0, v])).collect();
        assert_eq!(extent(&mesh(&[&noisy])).metres.x, even.metres.x);
    }

    /// A slope seen edge-on: both coordinates change upwards, and along it they are constant except for rounding.
    #[test]
    fn a_face_on_a_line_of_texture_space_does_not_count() {
        let front = quad([[0.0, 0.0], [8.0, 0.0], [8.0, 2.0], [0.0, 2.0]], [0.0, 1.0]);
        let slope = |noise: f64| {
            let places = [[8.0, 0.0], [8.0, 50.0], [9.0, 25.0]];
            let [a, b, c] = [[1.0, 0.0], [1.0 + noise, 0.0], [0.5, 1.0]];
            [(places[0], a), (places[1], b), (places[2], c)]
        };
        for noise in [0.0, f64::EPSILON, -f64::EPSILON, 1e-13] {
            let metres = extent(&mesh(&[&front, &slope(noise)])).metres;
            assert!((metres - DVec2::new(8.0, 2.0)).abs().max_element() < 1e-11, "{metres} with {noise}");
        }
        // A narrow face counts.
        assert!(8.1 < extent(&mesh(&[&front, &slope(1e-3)])).metres.x);
    }

    #[test]
    fn stretching_the_mesh_stretches_its_metres() {
        let square = mesh(&[&quad([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [0.0, 4.0])]);
        let found = square.uv_extent(0, DVec3::new(12.0, 7.0, 5.0)).unwrap();
        assert_eq!(found.metres, DVec2::new(12.0, 5.0));
        assert_eq!(found.at_metres(UvAxis::U, 3.0), 1.0);
        assert!(square.uv_extent(1, DVec3::ONE).is_none() && square.uv_range(12).is_none());
    }

    #[test]
    fn a_street_is_as_long_as_its_centre_line() {
        // A straight street with one half of u on a tenth of the length.
        let straight = mesh(&[
            &quad([[0.0, 0.0], [10.0, 0.0], [10.0, 6.0], [0.0, 6.0]], [0.0, 0.5]),
            &quad([[10.0, 0.0], [100.0, 0.0], [100.0, 6.0], [10.0, 6.0]], [0.5, 1.0]),
        ]);
        assert!((extent(&straight).metres - DVec2::new(100.0, 6.0)).abs().max_element() < 1e-12);
        // Around a mitred corner: the centre line has a length of 20 + 20.
        let bent = mesh(&[
            &quad([[0.0, -3.0], [23.0, -3.0], [17.0, 3.0], [0.0, 3.0]], [0.0, 0.5]),
            &quad([[23.0, -3.0], [23.0, 20.0], [17.0, 20.0], [17.0, 3.0]], [0.5, 1.0]),
        ]);
        assert!((extent(&bent).metres.x - 40.0).abs() < 1e-12);
    }

    #[test]
    fn a_constant_coordinate_measures_nothing_and_disturbs_nothing() {
        let corners = [[0.0, 0.0], [8.0, 0.0], [8.0, 2.0], [0.0, 2.0]];
        let only_u = corners.map(|p| (p, [p[0] / 8.0, 0.25]));
        assert_eq!(extent(&mesh(&[&only_u])).metres, DVec2::new(8.0, 0.0));
        let diagonal = corners.map(|p| (p, [p[0] / 8.0, p[0] / 4.0]));
        assert_eq!(extent(&mesh(&[&diagonal])).metres, DVec2::new(8.0, 8.0));
        let nothing = corners.map(|p| (p, [0.5, 0.25]));
        let found = extent(&mesh(&[&nothing]));
        assert_eq!((found.metres, found.at_metres(UvAxis::U, 3.0)), (DVec2::ZERO, 0.5));
        // A wall seen edge-on, beside a wall seen from the front.
        let side = [[8.0, 0.0], [8.0, -50.0], [9.0, -50.0], [9.0, 0.0]].map(|p: [f64; 2]| (p, [1.0, p[1] * 0.02]));
        let front = corners.map(|p| (p, [p[0] / 8.0, p[1] / 2.0]));
        assert_eq!(extent(&mesh(&[&front, &side])).metres.x, 8.0);
        // A surface without area.
        let line = corners.map(|p| ([p[0] + p[1] * 3.0, 0.0], [p[0], p[1]]));
        assert!(extent(&mesh(&[&line])).metres.is_finite());
    }

    #[test]
    fn the_measure_of_many_faces_can_end() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|p| (p, p));
        let mesh = mesh(&[&square[..]; 5000]);
        let asked = std::rc::Rc::new(std::cell::Cell::new(0));
        let count = asked.clone();
        let _supervisor = work::Supervisor::new(move |_| count.replace(count.get() + 1) < 2);
        assert!(mesh.uv_extent(0, DVec3::ONE).is_some());
        assert_eq!(asked.get(), 3);
    }
}
