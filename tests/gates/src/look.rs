//! A model from one side.

use cga::glam::DVec3;
use cga::mesh::Bounds;

use crate::raster;
use crate::survey::{Survey, Triangle};

/// The mark of a pixel without a triangle.
const NOTHING: u32 = u32::MAX;

/// Triangles whose edges meet leave no pixel between them.
const AROUND: f64 = -0.02;

/// Triangles that only touch have no pixel in common.
const WITHIN: f64 = 0.05;

/// Surfaces at this share of the diagonal of a model are in one place for the depth buffer of a graphics card.
const ONE_PLACE: f64 = 1e-5;

/// A model from one side, without perspective.
pub struct Look {
    /// The azimuth and the elevation of the viewer, in degrees.
    pub side: [f64; 2],
    pub width: usize,
    pub height: usize,
    right: DVec3,
    up: DVec3,
    /// From the model to the viewer.
    towards: DVec3,
    scale: f64,
    centre: DVec3,
    /// The nearest triangle of each pixel.
    nearest: Vec<u32>,
    /// The nearest triangle of each pixel that light does not pass through.
    opaque: Vec<u32>,
    depth: Vec<f64>,
    /// The pixels with two surfaces of different materials in one place, and both triangles.
    pub(crate) doubled: Vec<(usize, [u32; 2])>,
}

/// The looks from twelve sides, from low, from the height of roofs and from above.
pub fn looks(survey: &Survey, pixels: usize) -> Vec<Look> {
    let sides = (0..12)
        .map(|side| Look::of(survey, 30.0 * f64::from(side) + 13.0, [9.0, 27.0, 52.0][side as usize % 3], pixels));
    sides.collect()
}

impl Look {
    /// The look from an azimuth and an elevation in degrees, with that many pixels along the longer side.
    pub fn of(survey: &Survey, azimuth: f64, elevation: f64, pixels: usize) -> Self {
        let (a, e) = (azimuth.to_radians(), elevation.to_radians());
        let towards = DVec3::new(libm::sin(a) * libm::cos(e), libm::sin(e), libm::cos(a) * libm::cos(e));
        let right = DVec3::Y.cross(towards).normalize_or(DVec3::X);
        let up = towards.cross(right);
        let Bounds { low, high } = survey.bounds;
        let centre = (low + high) * 0.5;
        let half = (high - low) * 0.5;
        let reach = |axis: DVec3| (axis.abs()).dot(half);
        let scale = 0.5 * (pixels as f64 - 4.0) / reach(right).max(reach(up));
        let side = |axis: DVec3| (2.0 * reach(axis) * scale).ceil() as usize + 4;
        let (width, height) = (side(right), side(up));
        let count = width * height;
        let mut look = Look {
            side: [azimuth, elevation],
            width,
            height,
            right,
            up,
            towards,
            scale,
            centre,
            nearest: vec![NOTHING; count],
            opaque: vec![NOTHING; count],
            depth: vec![f64::NEG_INFINITY; count],
            doubled: Vec::new(),
        };
        look.draw(survey);
        look.double(survey, ONE_PLACE * (high - low).length());
        look
    }

    fn project(&self, point: DVec3) -> [f64; 3] {
        let from = point - self.centre;
        let [x, y] = [self.width, self.height].map(|side| 0.5 * side as f64);
        [x + from.dot(self.right) * self.scale, y - from.dot(self.up) * self.scale, from.dot(self.towards)]
    }

    /// Returns true if the viewer sees the back of a triangle.
    pub(crate) fn is_back(&self, triangle: &Triangle) -> bool {
        triangle.normal.dot(self.towards) < 0.0
    }

    fn draw(&mut self, survey: &Survey) {
        let size = [self.width, self.height];
        // Of two surfaces back to back, the one that faces the viewer is seen.
        let behind = 2.0 * ONE_PLACE * (survey.bounds.high - survey.bounds.low).length();
        let mut solid = vec![f64::NEG_INFINITY; self.depth.len()];
        for (number, triangle) in survey.triangles.iter().enumerate() {
            let is_back = self.is_back(triangle);
            let corners = triangle.corners.map(|corner| self.project(corner));
            let clear = survey.parts[triangle.part as usize].clear;
            let (inset, later) = if is_back { (0.0, behind) } else { (AROUND, 0.0) };
            raster::pixels(corners, size, inset, &mut |pixel, depth| {
                let depth = depth - later;
                if self.depth[pixel] < depth {
                    self.depth[pixel] = depth;
                    self.nearest[pixel] = number as u32;
                }
                if !clear && solid[pixel] < depth {
                    solid[pixel] = depth;
                    self.opaque[pixel] = number as u32;
                }
            });
        }
    }

    /// Finds the pixels whose nearest surface is in one place with another one of another look.
    fn double(&mut self, survey: &Survey, one_place: f64) {
        let mut first = vec![NOTHING; self.depth.len()];
        let mut second = first.clone();
        for (number, triangle) in survey.triangles.iter().enumerate() {
            let part = &survey.parts[triangle.part as usize];
            // Viewers do not draw the inside of closed parts.
            if part.closed && self.is_back(triangle) {
                continue;
            }
            let corners = triangle.corners.map(|corner| self.project(corner));
            raster::pixels(corners, [self.width, self.height], WITHIN, &mut |pixel, depth| {
                if depth < self.depth[pixel] - one_place {
                    return;
                }
                if first[pixel] == NOTHING {
                    first[pixel] = number as u32;
                    return;
                }
                let other = &survey.triangles[first[pixel] as usize];
                let differs = survey.part(first[pixel]).material != part.material;
                if differs && 0.999 < other.normal.dot(triangle.normal).abs() {
                    second[pixel] = number as u32;
                }
            });
        }
        let pairs = first.into_iter().zip(second).map(<[u32; 2]>::from).enumerate();
        self.doubled = pairs.filter(|(_, pair)| pair[1] != NOTHING).collect();
    }

    /// The nearest triangle of a pixel, through clear parts or not.
    pub(crate) fn nearest(&self, pixel: usize) -> Option<u32> {
        Some(self.nearest[pixel]).filter(|seen| *seen != NOTHING)
    }

    pub(crate) fn opaque(&self, pixel: usize) -> Option<u32> {
        Some(self.opaque[pixel]).filter(|seen| *seen != NOTHING)
    }

    /// The place in the world that a pixel shows.
    pub(crate) fn place(&self, pixel: usize) -> DVec3 {
        let [x, y] = [pixel % self.width, pixel / self.width].map(|at| at as f64 + 0.5);
        let [cx, cy] = [self.width, self.height].map(|side| 0.5 * side as f64);
        let depth = if self.depth[pixel].is_finite() { self.depth[pixel] } else { 0.0 };
        self.centre + (self.right * (x - cx) - self.up * (y - cy)) / self.scale + self.towards * depth
    }

    /// The eight pixels around a pixel; `None` at the border of the picture.
    pub(crate) fn around(&self, pixel: usize) -> Option<[usize; 8]> {
        let (x, y, width) = (pixel % self.width, pixel / self.width, self.width);
        let is_inside = 0 < x && x + 1 < width && 0 < y && y + 1 < self.height;
        is_inside.then(|| {
            let (above, below) = (pixel - width, pixel + width);
            [pixel - 1, pixel + 1, above - 1, above, above + 1, below - 1, below, below + 1]
        })
    }

    /// The pixels of background from which the border of the picture can be reached, in steps to one of eight neighbours.
    pub(crate) fn outside(&self) -> Vec<bool> {
        let mut outside: Vec<bool> = vec![false; self.pixels()];
        let is_open = |pixel: usize, outside: &[bool]| self.nearest[pixel] == NOTHING && !outside[pixel];
        // The model is two pixels away from the border. A run of a row is filled at once.
        let mut open = vec![self.width + 1];
        while let Some(pixel) = open.pop() {
            if !is_open(pixel, &outside) {
                continue;
            }
            let row = pixel - pixel % self.width;
            let begin = (row..pixel).rev().take_while(|at| is_open(*at, &outside)).last().unwrap_or(pixel);
            let end = (pixel..row + self.width).find(|at| !is_open(*at, &outside)).unwrap_or(row + self.width);
            outside[begin..end].fill(true);
            let around = begin.saturating_sub(1).max(row)..(end + 1).min(row + self.width);
            for below in [false, true] {
                let beside = |at: usize| if below { Some(at + self.width) } else { at.checked_sub(self.width) };
                let mut before = false;
                for at in around.clone().filter_map(beside).filter(|at| *at < self.pixels()) {
                    let is = is_open(at, &outside);
                    if is && !before {
                        open.push(at);
                    }
                    before = is;
                }
            }
        }
        outside
    }

    /// The distance of the nearest surface of a pixel in metres, growing towards the viewer.
    pub(crate) fn depth(&self, pixel: usize) -> f64 {
        self.depth[pixel]
    }

    /// The side of a pixel in metres.
    pub(crate) fn pixel(&self) -> f64 {
        1.0 / self.scale
    }

    pub(crate) fn pixels(&self) -> usize {
        self.nearest.len()
    }
}
