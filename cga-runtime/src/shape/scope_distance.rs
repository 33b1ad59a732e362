//! The distance between two scopes (*minimumDistance function*).

use glam::{DMat3, DVec3};

use super::scope::Scope;

/// The distance between two scopes in metres: between the nearest points of the two boxes, and 0 if they meet. Sizes may be 0, as of
/// points, edges and faces.
pub(crate) fn distance(a: &Scope, b: &Scope) -> f64 {
    let (own, other) = (Centred::of(a), Centred::of(b));
    if own.axes == other.axes {
        return own.aligned_distance(&other);
    }
    if own.meets(&other) {
        return 0.0;
    }
    // The nearest points of two convex solids that do not meet are a corner and a point of the other, or points of two edges.
    let corners = [own.corners(), other.corners()];
    let to_other = corners[0].iter().map(|corner| other.distance_to(*corner));
    let to_own = corners[1].iter().map(|corner| own.distance_to(*corner));
    let edges = EDGES.iter().flat_map(|first| EDGES.iter().map(move |second| (first, second)));
    let between = edges.map(|(first, second)| {
        let segment = |corners: &[DVec3; 8], [from, to]: [usize; 2]| [corners[from], corners[to]];
        segment_distance(segment(&corners[0], *first), segment(&corners[1], *second))
    });
    to_other.chain(to_own).chain(between).fold(f64::INFINITY, f64::min)
}

/// The edges of a box, as pairs of corners (x, y, z) with the index x + 2y + 4z.
const EDGES: [[usize; 2]; 12] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/// A box by its centre and half of its sizes.
struct Centred {
    centre: DVec3,
    axes: DMat3,
    half: DVec3,
}

impl Centred {
    fn of(scope: &Scope) -> Self {
        Centred { centre: scope.centre(), axes: scope.axes, half: scope.size.abs() * 0.5 }
    }

    fn corners(&self) -> [DVec3; 8] {
        let sign = |at: usize, axis: usize| if at & (1 << axis) == 0 { -1.0 } else { 1.0 };
        std::array::from_fn(|at| {
            self.centre + self.axes * (self.half * DVec3::new(sign(at, 0), sign(at, 1), sign(at, 2)))
        })
    }

    /// The distance to a box with the same axes.
    fn aligned_distance(&self, other: &Centred) -> f64 {
        let apart = self.axes.transpose() * (other.centre - self.centre);
        (apart.abs() - self.half - other.half).max(DVec3::ZERO).length()
    }

    /// The distance to a point.
    fn distance_to(&self, point: DVec3) -> f64 {
        let local = self.axes.transpose() * (point - self.centre);
        (local.abs() - self.half).max(DVec3::ZERO).length()
    }

    /// Returns true if the boxes meet: no axis separates them.
    fn meets(&self, other: &Centred) -> bool {
        let columns = |axes: &DMat3| [axes.x_axis, axes.y_axis, axes.z_axis];
        let (own, its) = (columns(&self.axes), columns(&other.axes));
        let crossed = own.iter().flat_map(|own| its.iter().map(move |its| own.cross(*its)));
        let apart = other.centre - self.centre;
        let reach = |solid: &Centred, axis: DVec3| (solid.axes.transpose() * axis).abs().dot(solid.half);
        let separates = |axis: DVec3| reach(self, axis) + reach(other, axis) < apart.dot(axis).abs();
        !own.into_iter().chain(its).chain(crossed).any(separates)
    }
}

/// The distance between two segments.
fn segment_distance([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> f64 {
    let (u, v, w) = (b - a, d - c, a - c);
    let (uu, uv, vv, uw, vw) = (u.dot(u), u.dot(v), v.dot(v), u.dot(w), v.dot(w));
    let share = |part: f64, whole: f64| if 0.0 < whole { (part / whole).clamp(0.0, 1.0) } else { 0.0 };
    // Of parallel segments, the ends of each are compared with the other one.
    let inner = share(uv * vw - vv * uw, uu * vv - uv * uv);
    let along_second = |s: f64| share(uv * s + vw, vv);
    let along_first = |t: f64| share(uv * t - uw, uu);
    let starts = [along_second(inner), 0.0, 1.0];
    let apart = starts.map(|t| {
        let s = along_first(t);
        let t = along_second(s);
        (w + u * s - v * t).length()
    });
    apart.into_iter().fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scope(origin: [f64; 3], size: [f64; 3], turned: f64) -> Scope {
        let axes = DMat3::from_rotation_y(turned.to_radians());
        Scope { origin: origin.into(), axes, size: size.into() }
    }

    #[test]
    fn boxes_with_the_same_axes_are_apart_by_their_gaps() {
        let own = scope([0.0; 3], [1.0, 2.0, 1.0], 0.0);
        for (origin, expected) in [
            ([1.0, 0.0, 0.0], 0.0),
            ([0.5, 0.5, 0.5], 0.0),
            ([4.0, 0.0, 0.0], 3.0),
            ([4.0, 0.0, 5.0], 5.0),
            ([0.0, -3.0, 0.0], 2.0),
            ([-5.0, 0.0, -4.0], 5.0),
        ] {
            assert_eq!(distance(&own, &scope(origin, [1.0; 3], 0.0)), expected, "{origin:?}");
        }
    }

    #[test]
    fn points_edges_and_faces_have_distances() {
        let point = scope([3.0, 4.0, 0.0], [0.0; 3], 30.0);
        assert!((distance(&point, &scope([0.0; 3], [0.0; 3], 0.0)) - 5.0).abs() < 1e-12);
        // Two edges that cross, one 2 m above the other.
        let (first, second) =
            (scope([-1.0, 0.0, 0.0], [2.0, 0.0, 0.0], 0.0), scope([0.0, 2.0, 1.0], [2.0, 0.0, 0.0], 90.0));
        assert!((distance(&first, &second) - 2.0).abs() < 1e-12);
        // A face and a point above it.
        let face = scope([-1.0, 0.0, -1.0], [2.0, 0.0, 2.0], 0.0);
        assert!((distance(&face, &scope([0.2, 1.5, 0.3], [0.0; 3], 17.0)) - 1.5).abs() < 1e-12);
    }

    #[test]
    fn turned_boxes_are_as_far_as_samples_of_them() {
        // A corner of the turned box points at the flat side.
        let own = scope([-1.0, 0.0, -1.0], [2.0, 1.0, 2.0], 0.0);
        let turned = scope([3.0, 0.0, 0.0], [1.0, 1.0, 1.0], 45.0);
        let nearest = 3.0 - 1.0;
        assert!((distance(&own, &turned) - nearest).abs() < 1e-12);
        assert_eq!(distance(&turned, &own), distance(&own, &turned));
        assert_eq!(distance(&own, &scope([0.0; 3], [1.0; 3], 45.0)), 0.0);
        // Nothing between the boxes is nearer than the distance.
        let samples = |scope: &Scope| {
            let steps = move |at: usize, axis: u32| at / 9_usize.pow(axis) % 9;
            let (origin, axes, size) = (scope.origin, scope.axes, scope.size);
            (0..729).map(move |at| {
                let share = DVec3::new(steps(at, 0) as f64, steps(at, 1) as f64, steps(at, 2) as f64) / 8.0;
                origin + axes * (size * share)
            })
        };
        for (angle, origin) in [(10.0, [2.0, 1.0, 0.5]), (33.0, [1.5, 2.5, -3.0]), (77.0, [-4.0, -1.5, 2.0])] {
            let other = scope(origin, [1.0, 0.5, 2.0], angle);
            let found = distance(&own, &other);
            let least = samples(&own)
                .map(|a| samples(&other).map(|b| a.distance(b)).fold(f64::INFINITY, f64::min))
                .fold(f64::INFINITY, f64::min);
            assert!(found <= least + 1e-12 && least - found < 0.2, "{angle}: {found} {least}");
        }
    }
}
