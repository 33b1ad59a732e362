//! `translate` and `rotate`: the scope moves in a named coordinate system, and the geometry with it.

use crate::geometry::rotation::turn;
use crate::op::{finite, settle};
use crate::run::env::Env;
use crate::shape::Shape;

/// A coordinate system.
pub use crate::query::System;

/// The meaning of the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TransformMode {
    /// A position.
    Abs,
    /// A difference from the current position.
    Rel,
}

/// `translate(abs | rel, system, x, y, z)`: moves the scope's origin to a position in the system, or by a vector
/// along the system's axes (*translate operation*). In the scope's own system both mean the same.
pub fn translate_in(env: &mut Env, shape: &mut Shape, mode: TransformMode, system: System, x: f64, y: f64, z: f64) {
    let by = finite(env, "`translate` along", [x, y, z]);
    let frame = system.frame(env, shape);
    let before = shape.scope;
    shape.scope.origin = match mode {
        TransformMode::Abs => frame.to_world(by),
        TransformMode::Rel => shape.scope.origin + frame.axes * by,
    };
    settle(env, shape, &before, "`translate`");
    shape.carry(&before);
}

/// `rotate(abs | rel, system, x, y, z)`: turns the scope about its origin, to angles in the system or by angles about
/// the system's axes, x then y then z, in degrees (*rotate operation*; *r operation*: `r` is `rotate(rel, pivot,
/// …)`). In the scope's own system both mean the same.
pub fn rotate_in(env: &mut Env, shape: &mut Shape, mode: TransformMode, system: System, x: f64, y: f64, z: f64) {
    let angles = finite(env, "`rotate` along", [x, y, z]);
    let frame = system.frame(env, shape).axes;
    let (before, turned) = (shape.scope, frame * turn(angles.x, angles.y, angles.z));
    shape.scope.axes = match mode {
        TransformMode::Abs => turned,
        TransformMode::Rel => turned * (frame.transpose() * shape.scope.axes),
    };
    shape.carry(&before);
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::*;
    use crate::geometry::rotation::angles;
    use crate::op::{Length, rotate, size, translate};
    use crate::shape::Shape;

    const ALL: [System; 4] = [System::Scope, System::Pivot, System::Object, System::World];

    /// A shape whose scope, pivot, object and world are four different systems.
    fn setting() -> (Env, Shape) {
        let mut start = Shape::rectangle(4.0, 3.0).at([10.0, 20.0, 30.0]);
        start.pivot.axes = turn(10.0, 20.0, 30.0);
        let mut env = Env::with_names(&crate::run::settings::Settings::default(), &["Lot"], &start, "Lot");
        let mut shape = start.clone();
        shape.pivot.axes = turn(0.0, 45.0, 5.0);
        shape.pivot.origin = DVec3::new(-1.0, 2.0, 3.0);
        rotate(&mut env, &mut shape, 12.0, -34.0, 56.0);
        (env, shape)
    }

    #[test]
    fn moving_in_the_world() {
        let (env, shape) = (&mut Env::for_tests(), &mut Shape::cuboid(1.0, 1.0, 1.0));
        rotate(env, shape, 0.0, 90.0, 0.0);
        translate_in(env, shape, TransformMode::Rel, System::World, 2.0, 0.0, 0.0);
        assert_eq!(shape.scope.origin, DVec3::new(2.0, 0.0, 0.0));
        translate_in(env, shape, TransformMode::Rel, System::Scope, 2.0, 0.0, 0.0);
        assert_eq!(shape.scope.origin, DVec3::new(2.0, 0.0, -2.0));
        translate_in(env, shape, TransformMode::Abs, System::World, 7.0, 8.0, 9.0);
        assert_eq!(shape.scope.origin, DVec3::new(7.0, 8.0, 9.0));
    }

    #[test]
    fn positions_are_those_of_their_system() {
        for system in ALL {
            let (mut env, mut shape) = setting();
            let (frame, before) = (system.frame(&env, &shape), shape.scope);
            translate_in(&mut env, &mut shape, TransformMode::Rel, system, 1.0, 2.0, 3.0);
            let by = frame.axes * DVec3::new(1.0, 2.0, 3.0);
            assert!((shape.scope.origin - before.origin - by).length() < 1e-12);
            translate_in(&mut env, &mut shape, TransformMode::Abs, system, 1.0, 2.0, 3.0);
            let at = if system == System::Scope { before.origin + by } else { frame.origin };
            assert!((shape.scope.origin - at - by).length() < 1e-12, "{system:?}");
            assert_eq!((shape.scope.axes, shape.scope.size), (before.axes, before.size));
        }
        // *t operation*: the same as `translate(rel, scope, …)`.
        let ((mut env, mut a), (_, mut b)) = (setting(), setting());
        translate(&mut env, &mut a, Length::Absolute(1.0), Length::Absolute(2.0), Length::Absolute(3.0));
        translate_in(&mut env, &mut b, TransformMode::Rel, System::Scope, 1.0, 2.0, 3.0);
        assert_eq!(a.scope, b.scope);
    }

    #[test]
    fn angles_are_those_of_their_system() {
        for system in ALL {
            let (mut env, mut shape) = setting();
            let (frame, before) = (system.frame(&env, &shape).axes, shape.scope);
            rotate_in(&mut env, &mut shape, TransformMode::Rel, system, 15.0, 25.0, 35.0);
            let turned = frame * turn(15.0, 25.0, 35.0) * frame.transpose() * before.axes;
            assert!(shape.scope.axes.abs_diff_eq(turned, 1e-12));
            let frame = system.frame(&env, &shape).axes;
            rotate_in(&mut env, &mut shape, TransformMode::Abs, system, 15.0, 25.0, 35.0);
            let found = angles(&(frame.transpose() * shape.scope.axes));
            assert!((found - DVec3::new(15.0, 25.0, 35.0)).length() < 1e-9, "{system:?}: {found}");
            assert_eq!((shape.scope.origin, shape.scope.size), (before.origin, before.size));
            let square = shape.scope.axes.transpose() * shape.scope.axes;
            assert!(square.abs_diff_eq(DMat3::IDENTITY, 1e-12) && 0.0 < shape.scope.axes.determinant());
        }
        // *rotate operation*, its example; *r operation*: the same as `rotate(rel, pivot, …)`.
        let (mut env, mut a) = setting();
        rotate_in(&mut env, &mut a, TransformMode::Abs, System::World, 0.0, 90.0, 0.0);
        assert_eq!(a.scope.axes, DMat3::from_cols(DVec3::NEG_Z, DVec3::Y, DVec3::X));
        let ((mut env, mut a), (_, mut b)) = (setting(), setting());
        rotate(&mut env, &mut a, 15.0, 25.0, 35.0);
        rotate_in(&mut env, &mut b, TransformMode::Rel, System::Pivot, 15.0, 25.0, 35.0);
        assert!(a.scope.axes.abs_diff_eq(b.scope.axes, 1e-12));
    }

    #[test]
    fn numbers_that_are_none_leave_a_fault() {
        let (mut env, mut shape) = setting();
        let before = shape.scope;
        translate_in(&mut env, &mut shape, TransformMode::Rel, System::World, f64::NAN, f64::INFINITY, 0.0);
        rotate_in(&mut env, &mut shape, TransformMode::Rel, System::Scope, f64::NAN, 0.0, 0.0);
        assert!(shape.scope.axes.abs_diff_eq(before.axes, 1e-12) && shape.scope.origin == before.origin);
        size(&mut env, &mut shape, Length::Absolute(1.0), Length::Absolute(1.0), Length::Absolute(1.0));
        for _ in 0..3 {
            translate_in(&mut env, &mut shape, TransformMode::Rel, System::World, 1e308, 0.0, 0.0);
        }
        assert!(shape.scope.origin.is_finite());
        assert!(4 <= env.take_faults().0.len());
    }
}
