//! The projection of a camera to the pixels of a picture.

use cga_geometry::mesh::Bounds;
use glam::DVec3;

use crate::camera::{Camera, Projection};

/// The pixels from the middle of the picture to the limits within which triangles are drawn; the picture is far smaller.
pub(crate) const FAR: f64 = 2e5;

/// The four limits of what is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Guard {
    Left,
    Right,
    Bottom,
    Top,
}

impl Guard {
    pub(crate) const ALL: [Guard; 4] = [Guard::Left, Guard::Right, Guard::Bottom, Guard::Top];
}

/// The unit vector in a direction, in degrees; see [`Camera::azimuth`] and [`Camera::elevation`].
pub fn direction(azimuth: f64, elevation: f64) -> DVec3 {
    let (a, e) = (azimuth.to_radians(), elevation.to_radians());
    DVec3::new(libm::sin(a) * libm::cos(e), libm::sin(e), libm::cos(a) * libm::cos(e))
}

/// A camera for a picture of a certain size: maps between the world and pixels. The third coordinate of a projected
/// point grows with nearness and is linear in the picture over any plane.
#[derive(Clone, Copy, Debug)]
pub struct Viewport {
    pub(crate) eye: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    perspective: bool,
    /// The nearest depth that is drawn, in metres.
    pub(crate) near: f64,
    /// Pixels per unit of tangent (perspective) or of length.
    scale: f64,
    centre: (f64, f64),
}

/// The nearest visible distance, as a fraction of the distance to the middle of the camera's bounds.
const NEAR: f64 = 1e-3;

/// The place from which points have the same largest tangent on both sides. Each point has a position across the view and
/// a distance along it. The place is at most `reach` away from `start`.
fn middle(points: impl Iterator<Item = (f64, f64)> + Clone, start: f64, reach: f64) -> f64 {
    let (mut low, mut high) = (start - reach, start + reach);
    // Halving 60 times leaves less than a rounding error.
    for _ in 0..60 {
        let at = 0.5 * (low + high);
        let tangents = points.clone().map(|(across, along)| (across - at) / along);
        let (least, most) = tangents.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), t| (l.min(t), m.max(t)));
        if 0.0 < least + most { low = at } else { high = at }
    }
    0.5 * (low + high)
}

impl Viewport {
    /// A view that shows all of the camera's bounds. The size is in pixels.
    pub fn new(camera: &Camera, width: usize, height: usize) -> Viewport {
        let Bounds { low, high } = camera.bounds;
        let corner = |i: usize| {
            let pick = |bit: usize, low: f64, high: f64| if i >> bit & 1 == 0 { low } else { high };
            DVec3::new(pick(0, low.x, high.x), pick(1, low.y, high.y), pick(2, low.z, high.z))
        };
        Viewport::around(camera, &mut (0..8).map(corner), width, height)
    }

    /// A view that shows all given points, which are within the camera's bounds. It is closer than the bounds require
    /// if possible.
    pub(crate) fn around(
        camera: &Camera,
        points: &mut dyn Iterator<Item = DVec3>,
        width: usize,
        height: usize,
    ) -> Viewport {
        let bounds = match camera.bounds.low.cmple(camera.bounds.high).all() && camera.bounds.size().is_finite() {
            true => camera.bounds,
            false => Bounds { low: DVec3::splat(-1.0), high: DVec3::ONE },
        };
        let elevation = camera.elevation.clamp(-90.0, 90.0);
        let forward = -direction(camera.azimuth, elevation);
        let right = direction(camera.azimuth + 90.0, 0.0);
        let up = right.cross(forward);
        let local = |p: DVec3| DVec3::new(p.dot(right), p.dot(up), p.dot(forward));
        let mut local: Vec<DVec3> = points.filter(|p| p.is_finite()).map(local).collect();
        if local.is_empty() {
            local = vec![DVec3::splat(-1.0), DVec3::ONE];
        }
        let (w, h) = (width as f64, height as f64);
        let room = 1.0 - 2.0 * camera.margin.clamp(0.0, 0.4);
        // Half the free extent in pixels. The margin is the same on all sides.
        let border = 0.5 * (1.0 - room) * w.min(h);
        let (half_w, half_h) = ((0.5 * w - border).max(1.0), (0.5 * h - border).max(1.0));
        let most = |of: &dyn Fn(&DVec3) -> f64| local.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
        let (at, scale) = match camera.projection {
            Projection::Perspective(degrees) => {
                let scale = 0.5 * h / libm::tan(degrees.clamp(1.0, 170.0).to_radians() * 0.5);
                let (tx, ty) = (half_w / scale, half_h / scale);
                // The camera is where the tightest pair of opposite sides of its pyramid touches the box.
                let (r, l) = (most(&|p| p.x - tx * p.z), most(&|p| -p.x - tx * p.z));
                let (t, b) = (most(&|p| p.y - ty * p.z), most(&|p| -p.y - ty * p.z));
                let depth = (-(r + l) / (2.0 * tx)).min(-(t + b) / (2.0 * ty));
                let (mut x, mut y) = (0.5 * (r - l), 0.5 * (t - b));
                if camera.centred {
                    x = middle(local.iter().map(|p| (p.x, p.z - depth)), x, 2.0 * bounds.size().length());
                    y = middle(local.iter().map(|p| (p.y, p.z - depth)), y, 2.0 * bounds.size().length());
                }
                (DVec3::new(x, y, depth), scale)
            }
            Projection::Orthographic => {
                let (r, l) = (most(&|p| p.x), most(&|p| -p.x));
                let (t, b) = (most(&|p| p.y), most(&|p| -p.y));
                let tiny = 1e-9;
                let scale = (2.0 * half_w / (r + l).max(tiny)).min(2.0 * half_h / (t + b).max(tiny));
                let back = bounds.size().length().max(tiny);
                (DVec3::new(0.5 * (r - l), 0.5 * (t - b), -most(&|p| -p.z) - back), scale)
            }
        };
        let eye = right * at.x + up * at.y + forward * at.z;
        let perspective = matches!(camera.projection, Projection::Perspective(_));
        let middle = bounds.low.midpoint(bounds.high);
        let near = if perspective { NEAR * (middle - eye).dot(forward).abs().max(1e-9) } else { f64::NEG_INFINITY };
        Viewport { eye, right, up, forward, perspective, near, scale, centre: (0.5 * w, 0.5 * h) }
    }

    /// The unit vector along the view, away from the camera.
    #[inline]
    pub fn forward(&self) -> DVec3 {
        self.forward
    }

    /// The distance along the view.
    pub(crate) fn depth(&self, point: DVec3) -> f64 {
        (point - self.eye).dot(self.forward)
    }

    /// A number that is positive on the inner side of a limit, for points in front of the eye. Pixel coordinates beyond the limits are
    /// too large for exact rasterization.
    pub(crate) fn guard(&self, point: DVec3, guard: Guard) -> f64 {
        let d = point - self.eye;
        let reach = if self.perspective { FAR * d.dot(self.forward) } else { FAR };
        let along = |axis: DVec3| self.scale * d.dot(axis);
        match guard {
            Guard::Left => reach + along(self.right),
            Guard::Right => reach - along(self.right),
            Guard::Bottom => reach + along(self.up),
            Guard::Top => reach - along(self.up),
        }
    }

    /// The pixel coordinates of a point, from the upper left corner, and its nearness.
    #[inline]
    pub fn project(&self, point: DVec3) -> [f64; 3] {
        let d = point - self.eye;
        let z = d.dot(self.forward);
        let (k, q) = if self.perspective { (self.scale / z, 1.0 / z) } else { (self.scale, -z) };
        [self.centre.0 + k * d.dot(self.right), self.centre.1 - k * d.dot(self.up), q]
    }

    /// The point in the world with these pixel coordinates and nearness.
    #[inline]
    pub(crate) fn unproject(&self, x: f64, y: f64, q: f64) -> DVec3 {
        let (x, y) = ((x - self.centre.0) / self.scale, (self.centre.1 - y) / self.scale);
        match self.perspective {
            true => self.eye + (self.forward + self.right * x + self.up * y) / q,
            false => self.eye + self.right * x + self.up * y - self.forward * q,
        }
    }

    /// The nearness of the plane through a point at a pixel; not finite for a plane that is seen edge on.
    pub(crate) fn plane_nearness(&self, point: DVec3, normal: DVec3, [x, y]: [f64; 2]) -> f64 {
        let (x, y) = ((x - self.centre.0) / self.scale, (self.centre.1 - y) / self.scale);
        let across = self.right * x + self.up * y;
        match self.perspective {
            true => normal.dot(self.forward + across) / normal.dot(point - self.eye),
            false => normal.dot(self.eye + across - point) / normal.dot(self.forward),
        }
    }

    /// Returns true if a surface with that normal shows its front.
    #[inline]
    pub fn faces(&self, point: DVec3, normal: DVec3) -> bool {
        let look = if self.perspective { point - self.eye } else { self.forward };
        look.dot(normal) <= 0.0
    }

    /// The start and the unnormalised direction of the ray through a pixel.
    pub(crate) fn ray(&self, x: f64, y: f64) -> (DVec3, DVec3) {
        let (x, y) = ((x - self.centre.0) / self.scale, (self.centre.1 - y) / self.scale);
        let aside = self.right * x + self.up * y;
        match self.perspective {
            true => (self.eye, self.forward + aside),
            false => (self.eye + aside, self.forward),
        }
    }
}
