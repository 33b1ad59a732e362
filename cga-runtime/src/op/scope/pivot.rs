//! `setPivot` and `mirrorScope`: other corners and axes of the same box, without rounding.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use crate::fault::FaultKind;
use crate::geometry::Frame;
use crate::geometry::each::Each;
use crate::geometry::wire::Wire;
use crate::op::scope::new_axes::rectangle;
use crate::op::settle;
use crate::run::env::Env;
use crate::shape::PlacedWire;
use crate::shape::scope::Scope;
use crate::shape::{Geometry, Placed, Shape};

/// The old axes that become the new ones, at corner 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisMap {
    /// Unchanged.
    Xyz,
    /// x is the old z, y the old x, z the old y.
    Yzx,
    /// x is the old y, y the old z, z the old x.
    Zxy,
}

/// `setPivot(xyz | yzx | zxy, corner)`: moves the pivot to a corner of the scope, with its axes along the edges
/// there. Scope and geometry stay, with these axes (*setPivot operation*). Corners 0 to 3 go around the floor from
/// the origin over x, 4 to 7 are above them. The pictures show the rest: y (for `xyz`) stays upright, and the order
/// of the other two makes the axes right-handed. The sizes of a mirrored scope keep their signs.
pub fn set_pivot(env: &mut Env, shape: &mut Shape, map: AxisMap, corner: f64) {
    let wanted = env.finite(corner, "the corner of `setPivot`");
    if wanted != wanted.floor() || !(0.0..=7.0).contains(&wanted) {
        env.fault(FaultKind::Value, format!("`setPivot` has corners 0 to 7, not {wanted}; the pivot stays"));
        return;
    }
    let (far, from) = corner_axes(map, wanted as usize);
    let (before, old) = (shape.scope, shape.scope);
    let axis = |new: usize| if far[from[new]] { -old.axes.col(from[new]) } else { old.axes.col(from[new]) };
    let share = DVec3::from_array(far.each(|far| if far { 1.0 } else { 0.0 }));
    let scope = Scope {
        origin: old.origin + old.axes * (old.size * share),
        axes: DMat3::from_cols(axis(0), axis(1), axis(2)),
        size: DVec3::from_array(from.each(|axis| old.size[axis])),
    };
    if from != [0, 1, 2] || far != [false; 3] {
        match &shape.geometry {
            Geometry::Empty | Geometry::Vertex => {}
            Geometry::Edge | Geometry::Wire(_) => {
                let wire = shape.to_wire().unwrap_or_default();
                shape.geometry = seen_from(wire, &old, &scope);
            }
            Geometry::Rect(axis, unit) if 0.0 <= old.size.min_element() && old.size[axis.index()] == 0.0 => {
                match rectangle(&old, *axis, *unit, scope.axes) {
                    Some((_, geometry)) => shape.geometry = geometry,
                    None if !rearrange(env, shape, from, from.each(|axis| far[axis])) => return,
                    None => {}
                }
            }
            Geometry::Box(_) | Geometry::Rect(..) | Geometry::Mesh(_) => {
                if !rearrange(env, shape, from, from.each(|axis| far[axis])) {
                    return;
                }
            }
        }
    }
    shape.scope = scope;
    settle(env, shape, &before, "`setPivot`");
    shape.set_pivot(shape.scope.frame());
}

/// Edges and points of one scope in another.
fn seen_from(wire: Wire, old: &Scope, new: &Scope) -> Geometry {
    let turn = old.axes.transpose();
    let frame = Frame { origin: turn * (new.origin - old.origin), axes: turn * new.axes };
    let wire = wire.seen_from(&frame);
    Geometry::Wire(Arc::new(PlacedWire { wire, low: DVec3::ZERO, size: new.size }))
}

/// The axes along which a corner is at the far end, and for each new axis the old axis that it runs along.
fn corner_axes(map: AxisMap, corner: usize) -> ([bool; 3], [usize; 3]) {
    let far = [matches!(corner % 4, 1 | 2), 4 <= corner, matches!(corner % 4, 2 | 3)];
    // All axes point inwards, so only their order can make them right-handed.
    let mirrored = far.iter().filter(|far| **far).count() % 2 == 1;
    let [x, y, z] = if mirrored { [2, 1, 0] } else { [0, 1, 2] };
    let from = match map {
        AxisMap::Xyz => [x, y, z],
        AxisMap::Yzx => [z, x, y],
        AxisMap::Zxy => [y, z, x],
    };
    (far, from)
}

/// Moves the geometry into a scope whose axes are old ones, some of them reversed.
fn rearrange(env: &mut Env, shape: &mut Shape, from: [usize; 3], turned: [bool; 3]) -> bool {
    let Some(placed) = shape.geometry.placed() else { return true };
    if env.count_vertices(&placed.mesh).is_break() {
        return false;
    }
    shape.geometry = Geometry::Mesh(Arc::new(rearranged(&placed, shape.scope.size, from, turned)));
    true
}

/// The geometry with its coordinates in another order, and some of them reversed.
pub(in crate::op) fn rearranged(placed: &Placed, scope: DVec3, from: [usize; 3], turned: [bool; 3]) -> Placed {
    let mut rows = DMat3::ZERO;
    let (mut low, mut size) = (DVec3::ZERO, DVec3::ZERO);
    for new in 0..3 {
        let old = from[new];
        rows.col_mut(new)[old] = if turned[new] { -1.0 } else { 1.0 };
        // A flat axis is not stretched: the geometry is at the low end, in metres.
        let extent = if placed.size[old] == 0.0 { scope[old] } else { placed.size[old] };
        low[new] = if turned[new] { -(placed.low[old] + extent) } else { placed.low[old] };
        size[new] = placed.size[old];
    }
    let map = DAffine3 { matrix3: rows.transpose(), translation: DVec3::ZERO };
    Placed { mesh: Arc::new(placed.mesh.map(&map)), low, size, ..placed.clone() }
}

/// `mirrorScope(x, y, z)`: the scope begins at its other end along the named axes and runs back, so that its size
/// changes sign. Geometry and pivot stay (*mirrorScope operation*).
pub fn mirror_scope(env: &mut Env, shape: &mut Shape, x: bool, y: bool, z: bool) {
    let (before, size) = (shape.scope, shape.scope.size);
    let flips = |axis: usize| [x, y, z][axis] && size[axis] != 0.0;
    if !(flips(0) || flips(1) || flips(2)) {
        return;
    }
    let share = DVec3::new(f64::from(flips(0)), f64::from(flips(1)), f64::from(flips(2)));
    if let Some(placed) = shape.geometry.placed() {
        if env.count_vertices(&placed.mesh).is_break() {
            return;
        }
        // A negative size mirrors, so geometry is mirrored first to stay. Flat geometry is only moved to the other
        // end.
        let mirrored = |axis: usize| flips(axis) && placed.size[axis] != 0.0;
        let mut new = rearranged(&placed, size, [0, 1, 2], [mirrored(0), mirrored(1), mirrored(2)]);
        for axis in (0..3).filter(|&axis| flips(axis) && !mirrored(axis)) {
            new.low[axis] += size[axis];
        }
        new.mirrored ^= (0..3).filter(|&axis| mirrored(axis)).count() % 2 == 1;
        shape.geometry = Geometry::Mesh(Arc::new(new));
    }
    if let Geometry::Wire(placed) = &shape.geometry {
        let wire = placed.in_scope(size).stretched(DVec3::ONE, -size * share);
        let size = size - size * share * 2.0;
        shape.geometry = Geometry::Wire(Arc::new(PlacedWire { wire, low: DVec3::ZERO, size }));
    }
    shape.scope.origin += shape.scope.axes * (size * share);
    shape.scope.size = size - size * share * 2.0;
    settle(env, shape, &before, "`mirrorScope`");
}
