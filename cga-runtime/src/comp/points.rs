//! Operations that make points, each with the same successor.

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::Frame;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::scope::Scope;
use crate::shape::seed::{self, Seed, Tag};
use crate::shape::{Geometry, Shape, ShapeRef};

/// Makes a shape of each point that `make` gives, in the world: one vertex, with a scope of size 0 at the point, along
/// the axes of the point. Calls `visit` with each, in order. `number` counts the children that the rule makes.
pub fn each<C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    number: u32,
    make: impl FnOnce(&mut Env, &Shape) -> ControlFlow<(), Vec<Frame>>,
    visit: &mut dyn FnMut(&mut Cx<'_, C>, &ShapeRef<'_>) -> Flow,
) -> Flow {
    let whole = cx.env.whole(&shape.child(seed::key(Tag::Comp, number)));
    let points = make(cx.env, &whole)?;
    let mut point = Shape { geometry: Geometry::Vertex, ..whole };
    point.bake();
    let first = point.seed.value();
    for (number, frame) in points.into_iter().enumerate() {
        point.scope = Scope { origin: frame.origin, axes: frame.axes, size: DVec3::ZERO };
        point.pivot = frame;
        point.seed = Seed::new(seed::part(first, number as u32, 0));
        let base = cx.env.base(point.clone());
        visit(cx, &base.shape())?;
    }
    Flow::Continue(())
}
