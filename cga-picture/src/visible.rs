//! The visible surface in each sample of a picture.

use cga_geometry::each::Each;
use glam::DVec3;

use crate::raster;
use crate::scene::{PLAIN, Scene};
use crate::viewport::{FAR, Guard, Viewport};

/// The mark of the background.
pub(crate) const SKY: u32 = u32::MAX;
/// The mark of the ground plane.
pub(crate) const GROUND: u32 = u32::MAX - 1;

/// One layer of samples, row by row from the upper left.
#[derive(Debug)]
pub(crate) struct VisibilityBuffer {
    pub(crate) width: usize,
    pub(crate) height: usize,
    /// The nearness of each sample; see [`Viewport::project`].
    pub(crate) near: Vec<f32>,
    /// The triangle of each sample, or [`SKY`] or [`GROUND`].
    pub(crate) seen: Vec<u32>,
}

impl VisibilityBuffer {
    fn new(width: usize, height: usize) -> Self {
        let count = width * height;
        VisibilityBuffer { width, height, near: vec![f32::NEG_INFINITY; count], seen: vec![SKY; count] }
    }

    /// The middle of a sample, from the upper left corner of the picture.
    pub(crate) fn place(&self, sample: usize) -> [f64; 2] {
        [(sample % self.width) as f64 + 0.5, (sample / self.width) as f64 + 0.5]
    }

    /// The plane of each sample: samples in one plane have equal numbers.
    pub(crate) fn planes(&self, scene: &Scene) -> Vec<u32> {
        self.seen.iter().map(|&seen| scene.triangles.get(seen as usize).map_or(seen, |t| t.plane)).collect()
    }
}

/// The layer of opaque triangles, and if there are any, the layer of the nearest transparent triangles in front of
/// it.
pub(crate) fn layers(
    scene: &Scene,
    view: &Viewport,
    width: usize,
    height: usize,
) -> (VisibilityBuffer, Option<VisibilityBuffer>) {
    let mut opaque = VisibilityBuffer::new(width, height);
    draw(scene, view, &mut opaque, |opacity| OPAQUE <= opacity);
    if scene.paints.iter().all(|paint| paint.opacity == 1.0 && paint.opacity_image.is_none()) {
        return (opaque, None);
    }
    let mut clear = VisibilityBuffer::new(width, height);
    draw(scene, view, &mut clear, |opacity| CLEAR < opacity && opacity < OPAQUE);
    for (near, (seen, behind)) in clear.near.iter().zip(clear.seen.iter_mut().zip(&opaque.near)) {
        if near <= behind {
            *seen = SKY;
        }
    }
    (opaque, Some(clear))
}

/// From `OPAQUE` on, a surface hides everything behind it. Below `CLEAR`, the surface itself is invisible. Images are
/// rarely exact.
const OPAQUE: f32 = 0.995;
const CLEAR: f32 = 0.005;

/// The later of two faces in one place is drawn, as their nearness differs by rounding alone.
const TIE: f32 = 1.0 + 3e-7;

fn draw(scene: &Scene, view: &Viewport, layer: &mut VisibilityBuffer, wanted: impl Fn(f32) -> bool) {
    let (width, height) = (layer.width, layer.height);
    let limit = view.near;
    for (id, triangle) in scene.triangles.iter().enumerate() {
        let paint = &scene.paints[triangle.paint as usize];
        let has_map = paint.opacity_image.is_some() && triangle.uvs != PLAIN;
        if !has_map && !wanted(paint.opacity) {
            continue;
        }
        let corners = triangle.corners();
        // Of two faces back to back, the one that faces the viewer is drawn.
        let away = 0.0 < (corners[0] - view.eye).dot(triangle.normal());
        let mut put = |corners: [DVec3; 3]| {
            raster::triangle(corners.each(|p| view.project(p)), width, height, |at, near| {
                let near = if away { near - near.abs() * 1e-6 } else { near } as f32;
                let opacity = || {
                    let [x, y] = [(at % width) as f64 + 0.5, (at / width) as f64 + 0.5];
                    scene.paint_at(triangle, view, [x, y], view.unproject(x, y, near.into())).opacity
                };
                if layer.near[at] < near * TIE && (!has_map || wanted(opacity())) {
                    layer.near[at] = near;
                    layer.seen[at] = id as u32;
                }
            });
        };
        let can_be_drawn = |p: &DVec3| {
            let [x, y, _] = view.project(*p);
            limit < view.depth(*p) && x.abs().max(y.abs()) < FAR
        };
        if corners.iter().all(can_be_drawn) {
            put(corners);
            continue;
        }
        let mut polygon = clipped(&corners, |p| view.depth(p) - limit);
        for guard in Guard::ALL {
            polygon = clipped(&polygon, |p| view.guard(p, guard));
        }
        for i in 1..polygon.len().saturating_sub(1) {
            put([polygon[0], polygon[i], polygon[i + 1]]);
        }
    }
}

/// The part of a convex polygon where `inside` is positive.
fn clipped(corners: &[DVec3], inside: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for i in 0..corners.len() {
        let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
        let (da, db) = (inside(a), inside(b));
        if 0.0 < da {
            kept.push(a);
        }
        if (0.0 < da) != (0.0 < db) {
            // A little inside, so that divisions by the distance stay finite.
            kept.push(a.lerp(b, da / (da - db)));
        }
    }
    kept
}

/// Adds a horizontal ground to all samples without a surface, if the camera is above it.
pub(crate) fn ground(layer: &mut VisibilityBuffer, view: &Viewport, height: f64) {
    for sample in 0..layer.seen.len() {
        if layer.seen[sample] != SKY {
            continue;
        }
        let [x, y] = layer.place(sample);
        let (start, along) = view.ray(x, y);
        if along.y < -1e-9 && height < start.y {
            let point = start + along * ((height - start.y) / along.y);
            layer.seen[sample] = GROUND;
            layer.near[sample] = view.project(point)[2] as f32;
        }
    }
}

#[cfg(test)]
mod tests {
    use cga_geometry::mesh::Bounds;

    use super::*;
    use crate::paint::Paint;
    use crate::renderer::Renderer;

    #[test]
    fn of_two_faces_in_one_place_the_later_one_is_seen() {
        let mut scene = Scene::new(Bounds { low: DVec3::ZERO, high: DVec3::new(40.0, 7.3, 40.0) });
        let paint = scene.add_paint(Paint::default());
        for [x, z, width] in [[0.0, 0.0, 30.1], [3.7, 2.9, 13.3], [9.1, 5.3, 29.7]] {
            let corner = |right: f64, front: f64| DVec3::new(x + right * width, 7.3, z + front * width);
            let [a, b, c, d] = [corner(0.0, 0.0), corner(0.0, 1.0), corner(1.0, 1.0), corner(1.0, 0.0)];
            scene.add_triangle([a, b, c], paint);
            scene.add_triangle([a, c, d], paint);
        }
        let (_, view) = Renderer::new(400, 300).viewport(&scene, 400, 300);
        let (layer, _) = layers(&scene, &view, 400, 300);
        let covers = |triangle: usize, at: usize| {
            let mut is_covered = false;
            let corners = scene.triangles[triangle].corners().each(|p| view.project(p));
            raster::triangle(corners, 400, 300, |pixel, _| is_covered |= pixel == at);
            is_covered
        };
        for at in (0..400 * 300).step_by(37) {
            let last = (0..6).rev().find(|triangle| covers(*triangle, at));
            assert_eq!(layer.seen[at], last.map_or(SKY, |triangle| triangle as u32), "pixel {at}");
        }
    }
}
