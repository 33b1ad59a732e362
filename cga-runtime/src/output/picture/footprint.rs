//! The paint of a triangle at a sample, with its images.
//!
//! A visible point is known in space. So its texture coordinates follow from its place in the triangle, without
//! correction for the perspective. The points of neighbouring samples on the same plane give the part of the image
//! that a sample shows.

use crate::geometry::each::Each;
use glam::{DVec2, DVec3};

use super::camera::Viewport;
use super::scene::{Paint, Scene, Triangle};
use super::texel::{Alpha, CornerUvs, PLAIN};
use super::texture::{Texel, Texture};

/// The part of a surface that a sample shows.
#[derive(Clone, Copy, Debug)]
struct Footprint {
    /// The point as weights of the second and the third corner of its triangle.
    at: DVec2,
    /// The differences to the samples to the right and below.
    sides: [DVec2; 2],
}

impl Footprint {
    fn of(triangle: &Triangle, view: &Viewport, [x, y]: [f64; 2], point: DVec3) -> Self {
        let [a, b, c] = triangle.corners();
        let normal = triangle.normal();
        let (e, f) = (b - a, c - a);
        let (ee, ef, ff) = (e.dot(e), e.dot(f), f.dot(f));
        let area = ee * ff - ef * ef;
        let weights = |v: DVec3| {
            let (p, q) = (v.dot(e), v.dot(f));
            if area <= 0.0 { DVec2::ZERO } else { DVec2::new(ff * p - ef * q, ee * q - ef * p) / area }
        };
        let beside = |x: f64, y: f64| {
            let (start, along) = view.ray(x, y);
            let to = start + along * ((a - start).dot(normal) / along.dot(normal));
            if to.is_finite() { weights(to - point) } else { DVec2::ZERO }
        };
        Footprint { at: weights(point - a), sides: [beside(x + 1.0, y), beside(x, y + 1.0)] }
    }

    fn sample(&self, texture: &Texture, corners: &CornerUvs) -> Texel {
        let [a, b, c] = corners.each(|[u, v]| DVec2::new(u.into(), v.into()));
        let (e, f) = (b - a, c - a);
        let along = |weights: DVec2| e * weights.x + f * weights.y;
        texture.sample(a + along(self.at), self.sides.each(along))
    }
}

impl Scene {
    /// The paint of a triangle at the point of a sample, with its images.
    pub(super) fn paint_at(&self, triangle: &Triangle, view: &Viewport, sample: [f64; 2], point: DVec3) -> Paint {
        let mut paint = self.paints[triangle.paint as usize];
        let Some(corners) = self.textures.corners.get(triangle.uvs as usize) else { return paint };
        let footprint = Footprint::of(triangle, view, sample, point);
        if let (Some(map), Some(corners)) = (paint.maps.color, &corners[0]) {
            paint.color *= footprint.sample(&self.textures.list[map.texture as usize], corners).truncate();
        }
        if let (Some((map, alpha)), Some(corners)) = (paint.maps.opacity, &corners[1]) {
            let opacity = paint.opacity * footprint.sample(&self.textures.list[map.texture as usize], corners).w;
            paint.opacity = match alpha {
                Alpha::Blend => opacity,
                Alpha::Mask(cutoff) if opacity < cutoff => 0.0,
                Alpha::Mask(_) => 1.0,
            };
        }
        paint
    }

    /// The mean opacity of a triangle.
    pub(super) fn mean_opacity(&self, triangle: &Triangle) -> f32 {
        let paint = &self.paints[triangle.paint as usize];
        match paint.maps.opacity {
            Some((map, _)) if triangle.uvs != PLAIN => {
                paint.opacity * self.textures.list[map.texture as usize].mean().w
            }
            _ => paint.opacity,
        }
    }
}
