//! `alignScopeToGeometryBBox`: the smallest rectangle around the geometry as seen along an axis.

use glam::{DVec2, DVec3};

use crate::geometry::hull::hull;
use crate::geometry::tol::{ANGLE_EPSILON, AREA_EPSILON};
use crate::op::scope::align::axes_of;
use crate::op::scope::new_axes::{corners, refit};
use crate::run::env::Env;
use crate::shape::Shape;

/// The two axes that are aligned; the first takes the longer side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BoxAxes {
    /// The first axis, the second, and the one that stays.
    order: [usize; 3],
}

#[allow(missing_docs, non_upper_case_globals, reason = "the language defines the names")]
impl BoxAxes {
    pub const Xy: BoxAxes = BoxAxes { order: [0, 1, 2] };
    pub const Yx: BoxAxes = BoxAxes { order: [1, 0, 2] };
    pub const Xz: BoxAxes = BoxAxes { order: [0, 2, 1] };
    pub const Zx: BoxAxes = BoxAxes { order: [2, 0, 1] };
    pub const Yz: BoxAxes = BoxAxes { order: [1, 2, 0] };
    pub const Zy: BoxAxes = BoxAxes { order: [2, 1, 0] };
}

/// `alignScopeToGeometryBBox(axes)`: turns the scope about the third axis until the first two span the smallest
/// rectangle around the geometry as seen along the third. The pivot moves to its corner (*alignScopeToGeometryBBox
/// operation*). Of the two directions along the longer side the one nearer to the old axis is taken, and of equal
/// rectangles the first with the smallest turn.
pub fn align_to_box(env: &mut Env, shape: &mut Shape, axes: BoxAxes) {
    let [first, second, third] = axes.order;
    let along = longer_side(&mut seen(shape, first, second));
    let old = shape.scope.axes;
    let direction = old.col(first) * along.x + old.col(second) * along.y;
    // The direction and the axis that stays follow each other in the order x y z x.
    let new = match along {
        DVec2::X => old,
        _ if (first + 1) % 3 == second => axes_of(third, old.col(third), direction),
        _ => axes_of(first, direction, old.col(third)),
    };
    if refit(env, shape, new, "`alignScopeToGeometryBBox`") {
        shape.set_pivot(shape.scope.frame());
    }
}

/// The points of the geometry in the plane of two axes.
fn seen(shape: &Shape, first: usize, second: usize) -> Vec<DVec2> {
    let flat = |p: DVec3| DVec2::new(p[first], p[second]);
    let size = shape.scope.size;
    match (shape.geometry.placed(), shape.to_wire()) {
        (Some(placed), _) => {
            let to_scope = placed.to_scope(size);
            placed.mesh.points().iter().map(|&p| flat(to_scope.transform_point3(p))).collect()
        }
        (None, Some(wire)) => wire.points.into_iter().map(flat).collect(),
        (None, None) => corners(size).map(flat).collect(),
    }
}

/// The direction of the longer side of the smallest rectangle around points.
fn longer_side(points: &mut Vec<DVec2>) -> DVec2 {
    hull(points, |point| *point);
    let mut best = (DVec2::X, extent(points, DVec2::X), extent(points, DVec2::Y));
    let count = points.len();
    let [mut far, mut deep, mut near] = [0; 3];
    for at in 0..count {
        let Some(along) = (points[(at + 1) % count] - points[at]).try_normalize() else { continue };
        // The extreme points along the edge, away from it and back. Each only moves forward.
        let walk = |from: &mut usize, direction: DVec2| {
            for _ in 0..count {
                let next = (*from + 1) % count;
                if (points[next] - points[*from]).dot(direction) <= 0.0 {
                    break;
                }
                *from = next;
            }
            points[*from].dot(direction)
        };
        if at == 0 {
            let furthest = |direction: DVec2| {
                (1..count)
                    .fold(0, |best, i| if points[best].dot(direction) < points[i].dot(direction) { i } else { best })
            };
            [far, deep, near] = [furthest(along), furthest(along.perp()), furthest(-along)];
        }
        let length = walk(&mut far, along) + walk(&mut near, -along);
        let width = walk(&mut deep, along.perp()) - points[at].dot(along.perp());
        if length * width < best.1 * best.2 * (1.0 - AREA_EPSILON) {
            best = (along, length, width);
        }
    }
    let (along, length, width) = best;
    let longer = if length < width { along.perp() } else { along };
    let towards = if longer.x < 0.0 || longer.x == 0.0 && longer.y < 0.0 { -longer } else { longer };
    // A direction that is nearly the old one is replaced by the old one.
    if towards.abs_diff_eq(DVec2::X, ANGLE_EPSILON) { DVec2::X } else { towards }
}

fn extent(points: &[DVec2], direction: DVec2) -> f64 {
    let ends = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| {
        (low.min(p.dot(direction)), high.max(p.dot(direction)))
    });
    (ends.1 - ends.0).max(0.0)
}
