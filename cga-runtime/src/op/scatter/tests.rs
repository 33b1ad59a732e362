use glam::DVec3;

use super::{Distribution, ScatterDomain, ScatterMean, scatter, scatter_around};
use crate::geometry::Frame;
use crate::op::Length;
use crate::run::env::Env;
use crate::shape::Shape;

fn uniform(shape: &Shape, domain: ScatterDomain, count: f64) -> (Vec<Frame>, u64) {
    let mut env = Env::for_tests();
    let points = scatter(&mut env, shape, domain, count, Distribution::Uniform);
    (points.continue_value().expect("no limit").collect(), env.fault_count())
}

#[test]
fn the_axes_of_points_on_faces_follow_the_faces() {
    let shape = Shape::cuboid(2.0, 3.0, 4.0).at([10.0, 20.0, 30.0]);
    let (points, faults) = uniform(&shape, ScatterDomain::Surface, 500.0);
    assert_eq!((points.len(), faults), (500, 0));
    for Frame { origin, axes } in points {
        assert!((axes.determinant() - 1.0).abs() < 1e-12 && axes.y_axis.abs().max_element() == 1.0);
        let local = origin - DVec3::new(10.0, 20.0, 30.0);
        let inwards = local - axes.y_axis * 1e-6;
        assert!(inwards.cmpgt(DVec3::ZERO).all() && inwards.cmplt(DVec3::new(2.0, 3.0, 4.0)).all(), "{local}");
        assert!((local + axes.y_axis * 1e-6 - local.clamp(DVec3::ZERO, DVec3::new(2.0, 3.0, 4.0))).length() < 2e-6);
    }
}

#[test]
fn the_volume_of_open_geometry_is_its_surface() {
    let shape = Shape::rectangle(2.0, 3.0);
    let (points, faults) = uniform(&shape, ScatterDomain::Volume, 10.0);
    assert_eq!((points.len(), faults), (10, 0));
    assert!(points.iter().all(|point| point.axes.y_axis == DVec3::Y && point.origin.y == 0.0));
    let (points, _) = uniform(&Shape::cuboid(2.0, 3.0, 4.0), ScatterDomain::Volume, 50.0);
    assert!(points.iter().any(|point| point.origin.cmpgt(DVec3::splat(0.2)).all() && point.axes.y_axis == DVec3::Y));
}

#[test]
fn a_mirrored_scope_holds_its_points() {
    let mut shape = Shape::cuboid(2.0, 3.0, 4.0);
    let mut scope = *shape.scope();
    scope.size.x = -2.0;
    shape.set_scope(scope);
    for domain in [ScatterDomain::Scope, ScatterDomain::Surface, ScatterDomain::Volume] {
        let (points, _) = uniform(&shape, domain, 100.0);
        assert!(points.iter().all(|point| (-2.0..=0.0).contains(&point.origin.x)), "{domain:?}");
    }
    let (points, _) = uniform(&shape, ScatterDomain::Surface, 100.0);
    // Normals point out of the mirrored box.
    let out = |point: &Frame| (point.origin - DVec3::new(-1.0, 1.5, 2.0)).dot(point.axes.y_axis);
    assert!(points.iter().all(|point| 0.0 < out(point)));
}

#[test]
fn counts_and_deviations_that_make_no_sense_are_faults() {
    let shape = Shape::rectangle(2.0, 3.0);
    for count in [0.0, 0.9, -3.0, f64::NAN, f64::INFINITY] {
        let (points, faults) = uniform(&shape, ScatterDomain::Surface, count);
        assert!(points.is_empty() && 0 < faults, "{count}");
    }
    let mut env = Env::for_tests();
    assert!(scatter(&mut env, &shape, ScatterDomain::Surface, 1e300, Distribution::Uniform).is_break());
    for deviation in [f64::NAN, 0.0, -1.0, 1e-300, 1e300] {
        let mut env = Env::for_tests();
        let (gaussian, left) = (Distribution::Gaussian, ScatterMean::Left);
        let length = Length::Absolute(deviation);
        let points = scatter_around(&mut env, &shape, ScatterDomain::Surface, 20.0, gaussian, left, length);
        assert_eq!(points.continue_value().map(Iterator::count), Some(20), "{deviation}");
    }
}

#[test]
fn sizes_near_the_limits_of_numbers_are_handled() {
    for size in [1e-140, 1e-9, 1e9, 1e140] {
        let shape = Shape::rectangle(size, size * 0.5);
        for domain in [ScatterDomain::Surface, ScatterDomain::Volume, ScatterDomain::Scope] {
            let (points, faults) = uniform(&shape, domain, 10.0);
            assert_eq!((points.len(), faults), (10, 0), "{size} {domain:?}");
            assert!(points.iter().all(|point| (0.0..=size).contains(&point.origin.x)));
        }
    }
}
