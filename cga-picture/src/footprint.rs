//! The paint of a triangle at a sample, with its images.
//!
//! A visible point is known in space. So its texture coordinates follow from its place in the triangle, without
//! correction for the perspective. The points of neighbouring samples on the same plane give the part of the image
//! that a sample shows.

use cga_geometry::each::Each;
use glam::{DVec2, DVec3};

use crate::paint::{Alpha, Paint};
use crate::scene::{CornerUvs, PLAIN, Scene, Triangle};
use crate::texture::{Texel, Texture};
use crate::viewport::Viewport;

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

/// The directions on a triangle in which u and v grow; `None` if its corners have places in one line.
fn slopes(triangle: &Triangle, corners: &CornerUvs) -> Option<[DVec3; 2]> {
    let [a, b, c] = triangle.corners();
    let [ua, ub, uc] = corners.each(|[u, v]| DVec2::new(u.into(), v.into()));
    let ((e, f), (p, q)) = ((b - a, c - a), (ub - ua, uc - ua));
    let area = p.perp_dot(q);
    (area != 0.0).then(|| [(e * q.y - f * p.y) / area, (f * p.x - e * q.x) / area])
}

/// The normal of a texel of a normal map.
fn relief(triangle: &Triangle, corners: &CornerUvs, texel: Texel, normal: DVec3) -> DVec3 {
    let Some([along_u, along_v]) = slopes(triangle, corners) else { return normal };
    let slope = texel.truncate().as_dvec3() * 2.0 - 1.0;
    // Neither 127 nor 128 is exactly 0.
    let flat = |slope: f64| if slope.abs() < 1.5 / 255.0 { 0.0 } else { slope };
    let tangent = |axis: DVec3| (axis - normal * axis.dot(normal)).normalize_or_zero();
    // At the back the relief goes in.
    let side = if triangle.normal().dot(normal) < 0.0 { -1.0 } else { 1.0 };
    let aside = tangent(along_u) * flat(slope.x) + tangent(along_v) * flat(slope.y);
    (aside * side + normal * slope.z.max(0.1)).normalize_or(normal)
}

impl Scene {
    /// The paint of a triangle at the point of a sample, with its images.
    pub(crate) fn paint_at(&self, triangle: &Triangle, view: &Viewport, sample: [f64; 2], point: DVec3) -> Paint {
        match self.uvs.get(triangle.uvs as usize) {
            Some(uvs) => self.painted(triangle, uvs, &Footprint::of(triangle, view, sample, point)),
            None => self.paints[triangle.paint as usize],
        }
    }

    /// The paint of a triangle at the point of a sample, and the normal there with its normal map. `normal` is the normal of the
    /// visible side without it.
    pub(crate) fn look_at(
        &self,
        triangle: &Triangle,
        view: &Viewport,
        sample: [f64; 2],
        (point, normal): (DVec3, DVec3),
    ) -> (Paint, DVec3) {
        let Some(uvs) = self.uvs.get(triangle.uvs as usize) else {
            return (self.paints[triangle.paint as usize], normal);
        };
        let footprint = Footprint::of(triangle, view, sample, point);
        let paint = self.painted(triangle, uvs, &footprint);
        let relief = paint.normal_image.zip(uvs[2].as_ref()).map(|(image, corners)| {
            let texel = footprint.sample(self.texture(image), corners);
            relief(triangle, corners, texel, normal)
        });
        (paint, relief.unwrap_or(normal))
    }

    fn painted(&self, triangle: &Triangle, uvs: &[Option<CornerUvs>; 3], footprint: &Footprint) -> Paint {
        let mut paint = self.paints[triangle.paint as usize];
        if let (Some(image), Some(corners)) = (paint.color_image, &uvs[0]) {
            paint.color *= footprint.sample(self.texture(image), corners).truncate();
        }
        if let (Some((image, alpha)), Some(corners)) = (paint.opacity_image, &uvs[1]) {
            let opacity = paint.opacity * footprint.sample(self.texture(image), corners).w;
            paint.opacity = match alpha {
                Alpha::Blend => opacity,
                Alpha::Mask(cutoff) if opacity < cutoff => 0.0,
                Alpha::Mask(_) => 1.0,
            };
        }
        paint
    }

    /// The mean opacity of a triangle.
    pub(crate) fn mean_opacity(&self, triangle: &Triangle) -> f32 {
        let paint = &self.paints[triangle.paint as usize];
        match paint.opacity_image {
            Some((image, _)) if triangle.uvs != PLAIN => paint.opacity * self.texture(image).mean().w,
            _ => paint.opacity,
        }
    }
}
