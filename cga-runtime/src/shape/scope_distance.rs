//! The distance between two scopes (*minimumDistance function*).

use glam::{DMat3, DVec2, DVec3};

use super::scope::Scope;

/// The distance between two scopes in metres: between the nearest points of the two boxes, and 0 if they meet. Sizes may be 0, as of
/// points, edges and faces. If the distance is not less than `least`, the result may be any number that is not less, either.
pub(crate) fn distance(a: &Scope, b: &Scope, least: f64) -> f64 {
    let (own, other) = (Centred::of(a), Centred::of(b));
    if own.axes == other.axes {
        return own.aligned_distance(&other);
    }
    let gap = own.gap(&other);
    if least + own.rounding(&other) <= gap {
        return gap;
    }
    match own.common_axis(&other) {
        Some(axes) => own.prism_distance(&other, axes),
        None => own.turned_distance(&other),
    }
}

/// The sine of the angle up to which two axes are the same. It moves no corner by more than rounding errors do.
const SAME_AXIS: f64 = 1e-12;

/// The cosine up to which an axis is taken as perpendicular.
const PERPENDICULAR: f64 = 1e-9;

/// The rounding errors of a distance, relative to the largest coordinate.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

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

    /// The distance along the axis that separates the boxes best, among the axes of both. The distance is not less.
    fn gap(&self, other: &Centred) -> f64 {
        let apart = other.centre - self.centre;
        let between = self.axes.transpose() * other.axes;
        let [x, y, z] = columns(&between).map(|axis| axis.abs());
        let reach = x * other.half.x + y * other.half.y + z * other.half.z;
        let own = (self.axes.transpose() * apart).abs() - self.half - reach;
        let its_reach = DVec3::new(x.dot(self.half), y.dot(self.half), z.dot(self.half));
        let its = (other.axes.transpose() * apart).abs() - other.half - its_reach;
        own.max(its).max_element().max(0.0)
    }

    fn rounding(&self, other: &Centred) -> f64 {
        let far = |solid: &Centred| solid.centre.abs().max_element() + solid.half.max_element();
        ROUNDING * far(self).max(far(other))
    }

    /// The numbers of an axis of each box that have the same direction: most buildings are upright.
    fn common_axis(&self, other: &Centred) -> Option<[usize; 2]> {
        let (own, its) = (columns(&self.axes), columns(&other.axes));
        let is_same = |[a, b]: &[usize; 2]| own[*a].cross(its[*b]).length_squared() <= SAME_AXIS * SAME_AXIS;
        [[1, 1], [1, 2], [2, 1], [1, 0], [0, 1], [0, 0], [2, 2], [0, 2], [2, 0]].into_iter().find(is_same)
    }

    /// The distance to a box with a common axis: along this axis, and between two rectangles across it.
    fn prism_distance(&self, other: &Centred, [along, along_other]: [usize; 2]) -> f64 {
        let axis = columns(&self.axes)[along];
        let apart = other.centre - self.centre;
        let gap = (apart.dot(axis).abs() - self.half[along] - other.half[along_other]).max(0.0);
        let own = Rectangle::across(self, along, DVec3::ZERO);
        let its = Rectangle::across(other, along_other, apart);
        let across = if own.meets(&its) { 0.0 } else { own.corner_distance(&its).min(its.corner_distance(&own)) };
        DVec2::new(gap, across).length()
    }

    /// The distance to a box in any other position.
    fn turned_distance(&self, other: &Centred) -> f64 {
        if self.meets(other) {
            return 0.0;
        }
        // The nearest points of two convex solids that do not meet are a corner and a point of the other, or points of two edges.
        let to_other = self.corners().map(|corner| other.distance_to(corner));
        let to_own = other.corners().map(|corner| self.distance_to(corner));
        let mut least = to_other.into_iter().chain(to_own).fold(f64::INFINITY, f64::min);
        let apart = other.centre - self.centre;
        let (own, its) = (columns(&self.axes), columns(&other.axes));
        for (first, own) in own.iter().enumerate() {
            for (second, its) in its.iter().enumerate() {
                // Points of two edges that are nearest are apart along the normal of both.
                let normal = own.cross(*its).normalize_or_zero();
                let normal = if normal.dot(apart) < 0.0 { -normal } else { normal };
                for a in self.edges(first, normal) {
                    for b in other.edges(second, -normal) {
                        least = least.min(segment_distance(a, b));
                    }
                }
            }
        }
        least
    }

    /// The edges along an axis that are farthest in a direction across it: one, or several where the direction is perpendicular to a face.
    fn edges(&self, along: usize, direction: DVec3) -> impl Iterator<Item = [DVec3; 2]> {
        let axes = columns(&self.axes);
        let [a, b] = [(along + 1) % 3, (along + 2) % 3].map(|side| {
            let cosine = axes[side].dot(direction);
            let signs: &[f64] = match cosine {
                _ if cosine.abs() <= PERPENDICULAR => &[1.0, -1.0],
                _ if cosine < 0.0 => &[-1.0],
                _ => &[1.0],
            };
            signs.iter().map(move |sign| axes[side] * (sign * self.half[side]))
        });
        let half = axes[along] * self.half[along];
        a.flat_map(move |a| {
            b.clone().map(move |b| {
                let middle = self.centre + a + b;
                [middle - half, middle + half]
            })
        })
    }

    /// Returns true if the boxes meet: no axis separates them.
    fn meets(&self, other: &Centred) -> bool {
        let (own, its) = (columns(&self.axes), columns(&other.axes));
        let crossed = own.iter().flat_map(|own| its.iter().map(move |its| own.cross(*its)));
        let apart = other.centre - self.centre;
        let reach = |solid: &Centred, axis: DVec3| (solid.axes.transpose() * axis).abs().dot(solid.half);
        let separates = |axis: DVec3| reach(self, axis) + reach(other, axis) < apart.dot(axis).abs();
        !own.into_iter().chain(its).chain(crossed).any(separates)
    }
}

fn columns(axes: &DMat3) -> [DVec3; 3] {
    [axes.x_axis, axes.y_axis, axes.z_axis]
}

/// The section of a box across an axis. Only directions across the axis count.
struct Rectangle {
    centre: DVec3,
    axes: [DVec3; 2],
    half: [f64; 2],
}

impl Rectangle {
    /// The section of a box with that centre.
    fn across(solid: &Centred, along: usize, centre: DVec3) -> Self {
        let (axes, sides) = (columns(&solid.axes), [(along + 1) % 3, (along + 2) % 3]);
        Rectangle { centre, axes: sides.map(|side| axes[side]), half: sides.map(|side| solid.half[side]) }
    }

    /// Returns true if no side separates the rectangles.
    fn meets(&self, other: &Rectangle) -> bool {
        let apart = other.centre - self.centre;
        let reach = |rectangle: &Rectangle, axis: DVec3| -> f64 {
            (0..2).map(|side| (rectangle.axes[side].dot(axis) * rectangle.half[side]).abs()).sum()
        };
        let separates = |axis: &DVec3| reach(self, *axis) + reach(other, *axis) < apart.dot(*axis).abs();
        !self.axes.iter().chain(&other.axes).any(separates)
    }

    /// The distance to the nearest corner of another rectangle.
    fn corner_distance(&self, other: &Rectangle) -> f64 {
        let to = |axis: usize, corner: DVec3| (corner.dot(self.axes[axis]).abs() - self.half[axis]).max(0.0);
        let [a, b] = [0, 1].map(|side| other.axes[side] * other.half[side]);
        let apart = other.centre - self.centre;
        let corners = [apart + a + b, apart + a - b, apart - a + b, apart - a - b];
        corners
            .into_iter()
            .map(|corner| DVec2::new(to(0, corner), to(1, corner)).length())
            .fold(f64::INFINITY, f64::min)
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

    const FAR: f64 = f64::INFINITY;

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
            assert_eq!(distance(&own, &scope(origin, [1.0; 3], 0.0), FAR), expected, "{origin:?}");
        }
    }

    #[test]
    fn points_edges_and_faces_have_distances() {
        let point = scope([3.0, 4.0, 0.0], [0.0; 3], 30.0);
        assert!((distance(&point, &scope([0.0; 3], [0.0; 3], 0.0), FAR) - 5.0).abs() < 1e-12);
        // Two edges that cross, one 2 m above the other.
        let (first, second) =
            (scope([-1.0, 0.0, 0.0], [2.0, 0.0, 0.0], 0.0), scope([0.0, 2.0, 1.0], [2.0, 0.0, 0.0], 90.0));
        assert!((distance(&first, &second, FAR) - 2.0).abs() < 1e-12);
        // A face and a point above it.
        let face = scope([-1.0, 0.0, -1.0], [2.0, 0.0, 2.0], 0.0);
        assert!((distance(&face, &scope([0.2, 1.5, 0.3], [0.0; 3], 17.0), FAR) - 1.5).abs() < 1e-12);
    }

    #[test]
    fn turned_boxes_are_as_far_as_samples_of_them() {
        // A corner of the turned box points at the flat side.
        let own = scope([-1.0, 0.0, -1.0], [2.0, 1.0, 2.0], 0.0);
        let turned = scope([3.0, 0.0, 0.0], [1.0, 1.0, 1.0], 45.0);
        let nearest = 3.0 - 1.0;
        assert!((distance(&own, &turned, FAR) - nearest).abs() < 1e-12);
        assert_eq!(distance(&turned, &own, FAR), distance(&own, &turned, FAR));
        assert_eq!(distance(&own, &scope([0.0; 3], [1.0; 3], 45.0), FAR), 0.0);
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
            let found = distance(&own, &other, FAR);
            let least = samples(&own)
                .map(|a| samples(&other).map(|b| a.distance(b)).fold(f64::INFINITY, f64::min))
                .fold(f64::INFINITY, f64::min);
            assert!(found <= least + 1e-12 && least - found < 0.2, "{angle}: {found} {least}");
        }
    }

    /// The distance by all corners and all pairs of edges.
    fn by_all_pairs(a: &Scope, b: &Scope) -> f64 {
        let (own, other) = (Centred::of(a), Centred::of(b));
        if own.meets(&other) {
            return 0.0;
        }
        let pairs = (0..8).flat_map(|from| [1, 2, 4].map(|axis| [from, from | axis])).filter(|[from, to]| from != to);
        let edges: Vec<[usize; 2]> = pairs.collect();
        let corners = [own.corners(), other.corners()];
        let to_other = corners[0].map(|corner| other.distance_to(corner));
        let to_own = corners[1].map(|corner| own.distance_to(corner));
        let segment = |solid: usize, edge: &[usize; 2]| edge.map(|corner| corners[solid][corner]);
        let between = edges
            .iter()
            .flat_map(|first| edges.iter().map(|second| segment_distance(segment(0, first), segment(1, second))));
        between.chain(to_other).chain(to_own).fold(FAR, f64::min)
    }

    #[test]
    fn the_nearest_edges_are_found_in_every_position() {
        let mut state = 1_u64;
        let mut draw = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f64 / (1_u64 << 24) as f64
        };
        let mut apart = 0;
        for round in 0..4_000 {
            let mut one = || {
                // Upright, upright after a quarter turn, or in any position; sizes and places are often the same.
                let (turn, tilt) = ((draw() * 24.0).floor() * 15.0, (draw() * 4.0).floor() * 30.0);
                let upright = DMat3::from_rotation_y(f64::to_radians(turn + draw() * f64::from(round % 2)));
                let axes = match round % 3 {
                    0 => upright,
                    1 => upright * DMat3::from_rotation_x(f64::to_radians(tilt)),
                    _ => upright * DMat3::from_rotation_z(f64::to_radians(tilt + draw())),
                };
                let mut number = |most: f64| (draw() * most).floor();
                let origin = [number(9.0) - 4.0, number(9.0) - 4.0, number(9.0) - 4.0];
                Scope { origin: origin.into(), axes, size: [number(3.0), number(3.0), number(3.0)].into() }
            };
            let (a, b) = (one(), one());
            let (found, expected) = (distance(&a, &b, FAR), by_all_pairs(&a, &b));
            assert!((found - expected).abs() < 1e-9, "{a:?} {b:?}: {found} {expected}");
            apart += usize::from(0.0 < found);
            // With less than the distance, the result is not less either.
            for least in [0.0, 0.5 * found, found, found + 1.0, 100.0] {
                let bounded = distance(&a, &b, least);
                assert!(if found < least { bounded == found } else { least <= bounded + 1e-12 }, "{least} {bounded}");
            }
        }
        assert!(2_000 < apart, "{apart}");
    }
}
