//! Operations that make points, each with the same successor.

use std::ops::ControlFlow;

use glam::DVec3;

use crate::fault::FaultKind;
use crate::geometry::Frame;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::scope::Scope;
use crate::shape::seed::{self, Tag};
use crate::shape::{Geometry, Shape, ShapeRef};

/// Points in the world, with axes, that are made one by one.
#[expect(missing_debug_implementations, reason = "an iterator need not be printable")]
pub struct Points {
    frames: Box<dyn Iterator<Item = Frame>>,
    /// The number of points that are wanted.
    wanted: u64,
}

impl Points {
    /// No points.
    pub(crate) fn none() -> Self {
        Points::new(std::iter::empty(), 0)
    }

    /// Points of which `wanted` are wanted.
    pub(crate) fn new(frames: impl Iterator<Item = Frame> + 'static, wanted: u64) -> Self {
        Points { frames: Box::new(frames), wanted }
    }
}

impl Iterator for Points {
    type Item = Frame;

    fn next(&mut self) -> Option<Frame> {
        self.frames.next()
    }
}

/// Makes a shape of each point that `make` gives: one vertex, with a scope of size 0 at the point, along the axes of the
/// point. Calls `visit` with each, in order. `number` counts the children that the rule makes. A fault if there are fewer
/// points than wanted.
pub fn each<C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    number: u32,
    make: impl FnOnce(&mut Env, &Shape) -> ControlFlow<(), Points>,
    visit: &mut dyn FnMut(&mut Cx<'_, C>, &ShapeRef<'_>) -> Flow,
) -> Flow {
    cx.env.ask()?;
    let whole = cx.env.whole(&shape.child(seed::key(Tag::Comp, number)));
    let points = make(cx.env, &whole)?;
    let (wanted, mut made) = (points.wanted, 0);
    let mut point = Shape { geometry: Geometry::Vertex, ..whole };
    point.bake();
    let first = point.seed;
    for frame in points {
        point.scope = Scope { origin: frame.origin, axes: frame.axes, size: DVec3::ZERO };
        point.set_pivot(frame);
        point.seed = first.part(made as u32, 0);
        let base = cx.env.base(point.clone());
        visit(cx, &base.shape())?;
        made += 1;
    }
    if made < wanted {
        cx.env.fault(FaultKind::Geometry, format!("`scatter`: the geometry has room for {made} of {wanted} points"));
    }
    Flow::Continue(())
}
