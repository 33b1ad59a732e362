//! `scatter`: points on the surface of a shape, in it or in its scope (*scatter operation*).

use std::ops::ControlFlow;

use glam::{DMat3, DVec3};

use crate::comp::Points;
use crate::fault::FaultKind;
use crate::geometry::Frame;
use crate::geometry::each::Each;
use crate::geometry::scatter::{Bell, Domain, ScatteredPoint};
use crate::op::Length;
use crate::run::env::Env;
use crate::shape::Shape;
use crate::shape::seed::Tag;

/// Where points are strewn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScatterDomain {
    /// The faces.
    Surface,
    /// The inside of closed geometry; the faces of open geometry.
    Volume,
    /// The scope.
    Scope,
}

/// The distribution of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distribution {
    /// With the same density everywhere.
    Uniform,
    /// Normally, around a mean.
    Gaussian,
}

/// The place in the scope around which points gather.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScatterMean {
    /// The centre.
    Center,
    /// The centre of the front side, the highest z.
    Front,
    /// The centre of the back side.
    Back,
    /// The centre of the left side, the lowest x.
    Left,
    /// The centre of the right side.
    Right,
    /// The centre of the top side, the highest y.
    Top,
    /// The centre of the bottom side.
    Bottom,
}

impl ScatterMean {
    /// The place in shares of the scope.
    fn share(self) -> DVec3 {
        let half = DVec3::splat(0.5);
        match self {
            ScatterMean::Center => half,
            ScatterMean::Front => DVec3 { z: 1.0, ..half },
            ScatterMean::Back => DVec3 { z: 0.0, ..half },
            ScatterMean::Left => DVec3 { x: 0.0, ..half },
            ScatterMean::Right => DVec3 { x: 1.0, ..half },
            ScatterMean::Top => DVec3 { y: 1.0, ..half },
            ScatterMean::Bottom => DVec3 { y: 0.0, ..half },
        }
    }
}

/// The smallest deviation, relative to the largest extent of the scope.
const LEAST_DEVIATION: f64 = 1e-6;

/// Strews points; a normal distribution is around the centre with a deviation of `'0.16` (*scatter operation*).
///
/// The number of points is rounded down; a negative number is a fault. On a surface, the density is by area over all faces, and
/// a normal distribution is the distribution of the space around, on the faces. The y axis of a point on a surface is the normal of its
/// face, and its x axis is the scope's x axis, projected into the face; other points keep the axes of the scope.
pub fn scatter(
    env: &mut Env,
    shape: &Shape,
    domain: ScatterDomain,
    count: f64,
    distribution: Distribution,
) -> ControlFlow<(), Points> {
    match distribution {
        Distribution::Uniform => strew(env, shape, domain, count, |_| Bell::EVEN),
        Distribution::Gaussian => {
            scatter_around(env, shape, domain, count, distribution, ScatterMean::Center, Length::Relative(0.16))
        }
    }
}

/// Strews points around a place in the scope (*scatter operation*). The deviation is in metres, or a share of the scope's
/// size along each axis.
pub fn scatter_around(
    env: &mut Env,
    shape: &Shape,
    domain: ScatterDomain,
    count: f64,
    _: Distribution,
    mean: ScatterMean,
    deviation: Length,
) -> ControlFlow<(), Points> {
    let size = shape.scope.size;
    let deviation = size.abs().to_array().each(|extent| deviation.of(extent, env, "the deviation of `scatter`").abs());
    strew(env, shape, domain, count, |scale| {
        let (extent, least) = (size.abs() * scale, LEAST_DEVIATION * size.abs().max_element() * scale);
        let deviation = (DVec3::from(deviation) * scale).max(DVec3::splat(least));
        // Nothing varies along an axis without extent.
        let deviation = DVec3::select(extent.cmpgt(DVec3::ZERO), deviation, DVec3::INFINITY);
        Bell { mean: size * scale * mean.share(), deviation }
    })
}

/// Strews points by the density that `bell` makes, in scope coordinates that are scaled to an extent of about 1.
fn strew(
    env: &mut Env,
    shape: &Shape,
    domain: ScatterDomain,
    count: f64,
    bell: impl FnOnce(f64) -> Bell,
) -> ControlFlow<(), Points> {
    let count = env.finite(count, "the number of points of `scatter`").floor();
    if count == 0.0 {
        return ControlFlow::Continue(Points::none());
    }
    if count < 0.0 {
        env.fault(FaultKind::Value, format!("`scatter`: {count} points are asked for; none is made"));
        return ControlFlow::Continue(Points::none());
    }
    let count = count as u64;
    if !env.has_room(count) {
        env.make_room(count)?;
    }
    let size = shape.scope.size;
    let scale = if size == DVec3::ZERO { 1.0 } else { size.abs().max_element().recip() };
    let bell = bell(scale);
    let found = match domain {
        ScatterDomain::Scope => {
            Domain::cuboid(size.min(DVec3::ZERO) * scale, size.max(DVec3::ZERO) * scale, bell, count)
        }
        ScatterDomain::Surface | ScatterDomain::Volume => {
            let mesh = shape.to_mesh();
            let points = mesh.points().iter().map(|point| *point * scale).collect();
            let mesh = mesh.with_points(points);
            match domain == ScatterDomain::Volume && mesh.is_closed() {
                true => Domain::volume(&mesh, bell, count),
                false => Domain::surface(&mesh, bell, count),
            }
        }
    };
    let (scope, inwards) = (shape.scope, if shape.looks_inwards() { -1.0 } else { 1.0 });
    let frame = move |point: ScatteredPoint| Frame {
        origin: scope.frame().to_world(point.position / scale),
        axes: scope.axes * axes_on(point.normal * inwards),
    };
    let mut seed = shape.seed.child(Tag::Candidate, 0);
    let points = found.draw(move || seed.draw());
    ControlFlow::Continue(Points::new(points.map(frame), count))
}

/// Axes with y along a normal; x stays as near as it can. The axes of the scope without a normal.
fn axes_on(normal: DVec3) -> DMat3 {
    if normal == DVec3::ZERO {
        return DMat3::IDENTITY;
    }
    // A wall across x has its x axis along z.
    let near = if normal.x.abs() < 0.999_999 { DVec3::X } else { DVec3::Z * -normal.x.signum() };
    let x = (near - normal * near.dot(normal)).normalize();
    DMat3::from_cols(x, normal, x.cross(normal))
}

#[cfg(test)]
mod tests;
