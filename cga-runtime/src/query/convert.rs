//! `convert`: positions and orientations in another coordinate system.

use glam::DVec3;

use crate::fault::FaultKind;
use crate::geometry::each::Each;
use crate::geometry::rotation::{angles, turn};
use crate::geometry::{Axis, Frame};
use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::array::Array;

/// A coordinate system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum System {
    /// The scope's origin and axes, in metres.
    Scope,
    /// The pivot's coordinates.
    Pivot,
    /// The object coordinates of the initial shape.
    Object,
    /// The world's coordinates.
    World,
}

impl System {
    /// The frame of the coordinate system in the world.
    pub(crate) fn frame(self, env: &Env, shape: &Shape) -> Frame {
        match self {
            System::Scope => shape.scope.frame(),
            System::Pivot => shape.pivot,
            System::Object => env.initial.object,
            System::World => Frame::WORLD,
        }
    }
}

/// The meaning of three numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConvertWhat {
    /// A position, in metres.
    Pos,
    /// Rotations about x, then y, then z, in degrees.
    Orient,
}

/// `convert(x | y | z, from, to, pos | orient, x, y, z)`: one coordinate of the result (*convert function*).
#[allow(clippy::too_many_arguments, reason = "the language defines them")]
pub fn convert(
    env: &mut Env,
    shape: &Shape,
    axis: Axis,
    from: System,
    to: System,
    what: ConvertWhat,
    x: f64,
    y: f64,
    z: f64,
) -> f64 {
    convert_all(env, shape, from, to, what, [x, y, z])[axis.index()]
}

/// `convert(from, to, pos | orient, coordinates)`: all three coordinates (*convert function*). Missing coordinates
/// count as 0 and further ones are ignored, both with a fault.
pub fn convert_array(
    env: &mut Env,
    shape: &Shape,
    from: System,
    to: System,
    what: ConvertWhat,
    coordinates: Array<f64>,
) -> Array<f64> {
    if coordinates.len() != 3 {
        env.fault(FaultKind::Value, format!("`convert` needs 3 coordinates, but has {}", coordinates.len()));
    }
    let given = [0, 1, 2].each(|at| coordinates.get(at).copied().unwrap_or_default());
    Array::from(convert_all(env, shape, from, to, what, given))
}

pub(super) fn convert_all(
    env: &mut Env,
    shape: &Shape,
    from: System,
    to: System,
    what: ConvertWhat,
    given: [f64; 3],
) -> [f64; 3] {
    let given = DVec3::from_array(given.each(|number| env.finite(number, "a coordinate of `convert`")));
    if from == to {
        return given.to_array();
    }
    let (from, to) = (from.frame(env, shape), to.frame(env, shape));
    let found = match what {
        ConvertWhat::Pos => to.to_local(from.to_world(given)),
        ConvertWhat::Orient => angles(&(to.axes.transpose() * from.axes * turn(given.x, given.y, given.z))),
    };
    if found.is_finite() {
        return found.to_array();
    }
    env.fault(FaultKind::Value, "`convert` overflows; 0 is used instead");
    [0.0; 3]
}
