//! Sunlight and skylight: the share of each that reaches a visible surface.
//!
//! The sun and a few dozen lamps that make up the sky each have a depth map. Every other sample, as on a chessboard,
//! tests the sun and some of the lamps, and its neighbours test the other lamps. The average over a block of 4×4
//! samples on one surface then covers all lamps, without noise.

use cga_geometry::each::Each;
use glam::{DVec3, Vec3};

use crate::raster;
use crate::scene::Scene;
use crate::threads::on_all_cores;
use crate::viewport::{Viewport, direction};
use crate::visible::{GROUND, SKY, VisibilityBuffer};

/// The samples along a side of a block, and the number of them with tests of their own.
const BLOCK: usize = 4;
const CLASSES: usize = BLOCK * BLOCK / 2;
/// The distance, in texels, by which a point is moved off its surface before the look-up.
const BIAS: f32 = 1.2;
/// The degrees between consecutive lamps: with the golden angle, no two lamps are in the same place.
const GOLDEN: f64 = 137.507_764_050_037_85;

/// The light that reaches each sample, 0 to 1.
#[derive(Debug)]
pub(crate) struct Light {
    pub(crate) sun: Vec<f32>,
    pub(crate) sky: Vec<f32>,
}

/// A distant lamp and its depth map of the scene.
struct Lamp {
    to: Vec3,
    /// The map from the scene to texels: a row each for x and y, and the summand.
    x: (Vec3, f32),
    y: (Vec3, f32),
    /// The metres per texel.
    texel: f32,
    size: usize,
    near: Vec<f32>,
}

impl Lamp {
    /// A lamp. `half` is half the size of the scene, a box about the origin; `shift` moves the map's grid by a part
    /// of a texel.
    fn new(casters: &[[Vec3; 3]], half: DVec3, to: DVec3, size: usize, shift: [f64; 2], mut near: Vec<f32>) -> Lamp {
        let right = to.cross(if to.y.abs() < 0.99 { DVec3::Y } else { DVec3::X }).normalize();
        let up = right.cross(to);
        let reach = |axis: DVec3| axis.abs().dot(half).max(1e-6);
        let scale = |axis: DVec3| 0.5 * (size - 4) as f64 / reach(axis);
        let row = |axis: DVec3, shift: f64| ((axis * scale(axis)).as_vec3(), (0.5 * size as f64 - 0.5 + shift) as f32);
        let texel = (1.0 / scale(right)).max(1.0 / scale(up)) as f32;
        near.clear();
        near.resize(size * size, f32::NEG_INFINITY);
        let (x, y, to) = (row(right, shift[0]), row(up, shift[1]), to.as_vec3());
        for triangle in casters {
            let corners = triangle.each(|p| [p.dot(x.0) + x.1, p.dot(y.0) + y.1, p.dot(to)]);
            raster::raise(corners, size, &mut near);
        }
        Lamp { to, x, y, texel, size, near }
    }

    /// The light at a place of the map: 1 or 0.
    #[inline]
    fn open(&self, x: f32, y: f32, near: f32) -> f32 {
        let size = self.size as f32;
        // Light from outside the map is unobstructed.
        let inside = 0.0 <= x && 0.0 <= y && x < size && y < size;
        if inside && near < self.near[y as usize * self.size + x as usize] { 0.0 } else { 1.0 }
    }

    /// The light that reaches a point: 1 or 0.
    #[inline]
    fn hard(&self, point: Vec3, normal: Vec3) -> f32 {
        let p = point + normal * BIAS * self.texel;
        self.open(p.dot(self.x.0) + self.x.1, p.dot(self.y.0) + self.y.1, p.dot(self.to) + 0.5 * self.texel)
    }

    /// The share of light that reaches a point: a weighted mean of the nine texels around it.
    #[inline]
    fn soft(&self, point: Vec3, normal: Vec3) -> f32 {
        let p = point + normal * BIAS * self.texel;
        let near = p.dot(self.to) + 0.5 * self.texel;
        let (x, y) = (p.dot(self.x.0) + self.x.1, p.dot(self.y.0) + self.y.1);
        let (fx, fy) = (x - x as i32 as f32, y - y as i32 as f32);
        let row = |y: f32| {
            self.open(x - 1.0, y, near) * (1.0 - fx) + self.open(x, y, near) + self.open(x + 1.0, y, near) * fx
        };
        0.25 * (row(y - 1.0) * (1.0 - fy) + row(y) + row(y + 1.0) * fy)
    }
}

/// The texels along a side of the maps of the sun and of a lamp in the sky: about as fine as the picture.
fn map_sizes(layer: &VisibilityBuffer) -> (usize, usize) {
    let side = layer.width.max(layer.height);
    (side.clamp(256, 2048), (side / 5).clamp(96, 384))
}

/// The number of sky lamps for each sample: fewer for large models, whose detail hides the difference.
fn lamps(casters: usize) -> usize {
    match casters {
        0..80_000 => 6,
        80_000..400_000 => 4,
        _ => 2,
    }
}

/// A lamp of the sky; all lamps are spread evenly.
fn sky_lamp(index: usize, count: usize) -> DVec3 {
    let y = (index as f64 + 0.5) / count as f64;
    let around = direction(index as f64 * GOLDEN, 0.0) * (1.0 - y * y).sqrt();
    DVec3::new(around.x, y, around.z)
}

/// The relative brightness of the sky: higher above than at the horizon.
fn sky_weight(up: f32) -> f32 {
    0.5 + 0.5 * up
}

/// The column and the row of a class in each block.
fn class_offset(class: usize) -> [usize; 2] {
    [class % 2 * 2 + class / 2 % 2, class / 2]
}

/// The samples of a class.
fn class_samples(layer: &VisibilityBuffer, class: usize) -> impl Iterator<Item = usize> {
    let [column, row] = class_offset(class);
    let (width, height) = (layer.width, layer.height);
    (row..height).step_by(BLOCK).flat_map(move |y| (column..width).step_by(BLOCK).map(move |x| y * width + x))
}

/// The light on the surfaces visible in `layer`; `half` is half the size of the scene.
pub(crate) fn light(scene: &Scene, layer: &VisibilityBuffer, view: &Viewport, half: DVec3, sun: DVec3) -> Light {
    // Thin glass casts no visible shadow.
    let casters: Vec<[Vec3; 3]> = scene
        .triangles
        .iter()
        .filter(|t| 0.6 <= scene.mean_opacity(t))
        .map(|t| t.corners().each(|corner| corner.as_vec3()))
        .collect();
    let count = lamps(casters.len());
    let (sun_map, sky_map) = map_sizes(layer);
    let bright = Lamp::new(&casters, half, sun, sun_map, [0.0; 2], Vec::new());
    let classes = on_all_cores(CLASSES, Vec::new, |spare: &mut Vec<Vec<f32>>, class| {
        // The grids of the maps differ, so that their steps do not add up.
        let [column, row] = class_offset(class);
        let shift = [column, row].each(|s| s as f64 / BLOCK as f64);
        let sky: Vec<Lamp> = (0..count)
            .map(|i| {
                let to = sky_lamp(i * CLASSES + class, count * CLASSES);
                Lamp::new(&casters, half, to, sky_map, shift, spare.pop().unwrap_or_default())
            })
            .collect();
        let mut tests = Vec::new();
        class_samples(layer, class).for_each(|sample| {
            let Some((point, normal)) = surface(scene, layer, view, sample) else {
                tests.push(Raw::default());
                return;
            };
            let lit = 0.0 < normal.dot(sun);
            let (point, normal) = (point.as_vec3(), normal.as_vec3());
            let sun = if lit { bright.soft(point, normal) } else { 1.0 };
            let (mut given, mut possible) = (0.0, 0.0);
            for lamp in &sky {
                let share = normal.dot(lamp.to) * sky_weight(lamp.to.y);
                if 0.0 < share {
                    possible += share;
                    given += share * lamp.hard(point, normal);
                }
            }
            let byte = |share: f32| (share * 255.0 + 0.5) as u8;
            let part = 1.0 / count as f32;
            tests.push(Raw { sun: byte(sun), given: byte(given * part), possible: byte(possible * part) });
        });
        spare.extend(sky.into_iter().map(|lamp| lamp.near));
        tests
    });
    let mut raw = vec![Raw::default(); layer.seen.len()];
    for (class, tests) in classes.into_iter().enumerate() {
        class_samples(layer, class).zip(tests).for_each(|(sample, test)| raw[sample] = test);
    }
    let planes = layer.planes(scene);
    let mut light = average(scene, layer, &planes, &raw);
    smooth(layer, &planes, &mut light.sky);
    light
}

/// The light of one sample. It is small, as all samples are visited many times. The sky's light is a part of the
/// possible light from its lamps.
#[derive(Clone, Copy, Default)]
struct Raw {
    sun: u8,
    given: u8,
    possible: u8,
}

#[derive(Default)]
struct LightSum {
    count: u32,
    sun: u32,
    given: u32,
    possible: u32,
}

impl LightSum {
    #[inline]
    fn add(&mut self, told: Raw) {
        self.count += 1;
        self.sun += u32::from(told.sun);
        self.given += u32::from(told.given);
        self.possible += u32::from(told.possible);
    }
}

/// The visible point in a sample and the normal there, turned to the viewer.
#[inline]
pub(crate) fn surface(
    scene: &Scene,
    layer: &VisibilityBuffer,
    view: &Viewport,
    sample: usize,
) -> Option<(DVec3, DVec3)> {
    let seen = layer.seen[sample];
    if seen == SKY {
        return None;
    }
    let [x, y] = layer.place(sample);
    let point = view.unproject(x, y, f64::from(layer.near[sample]));
    if seen == GROUND {
        return Some((point, DVec3::Y));
    }
    let triangle = &scene.triangles[seen as usize];
    let flat = triangle.normal();
    // The visible side. Near a silhouette a smooth normal may still look away; the flat one then replaces it.
    let side = if view.faces(point, flat) { 1.0 } else { -1.0 };
    let smooth = scene.normal_at(triangle, point) * side;
    Some((point, if view.faces(point, smooth) { smooth } else { flat * side }))
}

/// Averages the light of a block of samples that belong to one surface.
fn average(scene: &Scene, layer: &VisibilityBuffer, planes: &[u32], raw: &[Raw]) -> Light {
    let (width, height) = (layer.width, layer.height);
    let count = layer.seen.len();
    let mut light = Light { sun: vec![1.0; count], sky: vec![1.0; count] };
    if width < BLOCK || height < BLOCK {
        return light;
    }
    for y in 0..height {
        let top = y.saturating_sub(BLOCK / 2).min(height - BLOCK);
        for x in 0..width {
            let sample = y * width + x;
            if layer.seen[sample] == SKY {
                continue;
            }
            let left = x.saturating_sub(BLOCK / 2).min(width - BLOCK);
            let plane = planes[sample];
            let mut sum = LightSum::default();
            let tested = || {
                let row = |row| (row * width + left + (row + left) % 2..).step_by(2).take(BLOCK / 2);
                (top..top + BLOCK).flat_map(row)
            };
            let is_alike = |near: &usize| planes[*near] == plane || alike(scene, layer, sample, *near);
            tested().filter(is_alike).for_each(|near| sum.add(raw[near]));
            if sum.count == 0 {
                // A surface so thin that none of its samples has a test.
                tested().for_each(|near| sum.add(raw[near]));
            }
            light.sun[sample] = sum.sun as f32 / (255 * sum.count) as f32;
            light.sky[sample] = if sum.possible == 0 { 1.0 } else { sum.given as f32 / sum.possible as f32 };
        }
    }
    light
}

/// Smooths the sky's light within each plane, along rows and then columns. This removes the edges of the faint
/// shadows of single lamps.
fn smooth(layer: &VisibilityBuffer, planes: &[u32], sky: &mut [f32]) {
    let (width, height) = (layer.width, layer.height);
    let radius = height / 120;
    let mut sums = Vec::new();
    for y in 0..height {
        smooth_line(planes, sky, y * width, 1, width, radius, &mut sums);
    }
    for x in 0..width {
        smooth_line(planes, sky, x, width, height, radius, &mut sums);
    }
}

/// Smooths one row or column: `start` is its first sample, `step` the distance between samples, `count` their number.
fn smooth_line(
    planes: &[u32],
    sky: &mut [f32],
    start: usize,
    step: usize,
    count: usize,
    radius: usize,
    sums: &mut Vec<f32>,
) {
    let mut first = 0;
    while first < count {
        let plane = planes[start + first * step];
        let same = |i: &usize| planes[start + i * step] == plane;
        let end = (first + 1..count).find(|i| !same(i)).unwrap_or(count);
        if 2 < end - first {
            sums.clear();
            sums.push(0.0);
            let mut sum = 0.0;
            for i in first..end {
                sum += sky[start + i * step];
                sums.push(sum);
            }
            for i in 0..end - first {
                let (low, high) = (i.saturating_sub(radius), (i + radius + 1).min(end - first));
                sky[start + (first + i) * step] = (sums[high] - sums[low]) / (high - low) as f32;
            }
        }
        first = end;
    }
}

/// Returns true if two samples in different planes still belong to one smooth surface.
#[inline]
fn alike(scene: &Scene, layer: &VisibilityBuffer, a: usize, b: usize) -> bool {
    if !scene.round {
        return false;
    }
    let [Some(ta), Some(tb)] = [a, b].each(|i| scene.triangles.get(layer.seen[i] as usize)) else { return false };
    let (qa, qb) = (layer.near[a], layer.near[b]);
    0.95 < ta.normal().dot(tb.normal()) && (qa - qb).abs() < 0.003 * qa.abs()
}
