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
    for (count, is_fault) in [(0.0, false), (0.9, false), (-3.0, true), (f64::NAN, true), (f64::INFINITY, true)] {
        let (points, faults) = uniform(&shape, ScatterDomain::Surface, count);
        assert!(points.is_empty() && is_fault == (0 < faults), "{count}");
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

/// Points in a scope of 10 by 2 by 4 metres, around a place.
fn around(mean: ScatterMean, deviation: Length) -> Vec<DVec3> {
    let mut env = Env::for_tests();
    let shape = Shape::cuboid(10.0, 2.0, 4.0);
    let points =
        scatter_around(&mut env, &shape, ScatterDomain::Scope, 4000.0, Distribution::Gaussian, mean, deviation);
    points.continue_value().expect("no limit").map(|point| point.origin).collect()
}

#[test]
fn a_relative_deviation_is_a_share_of_the_size_along_each_axis() {
    for (deviation, expected) in
        [(Length::Relative(0.1), DVec3::new(1.0, 0.2, 0.4)), (Length::Absolute(0.3), DVec3::splat(0.3))]
    {
        let points = around(ScatterMean::Center, deviation);
        let middle = points.iter().sum::<DVec3>() / 4000.0;
        assert!((middle - DVec3::new(5.0, 1.0, 2.0)).abs().cmplt(expected * 0.1).all(), "{middle}");
        let off = points.iter().map(|at| (*at - middle) * (*at - middle)).sum::<DVec3>() / 4000.0;
        let found = DVec3::new(off.x.sqrt(), off.y.sqrt(), off.z.sqrt());
        assert!((found / expected - 1.0).abs().max_element() < 0.05, "{found}, not {expected}");
    }
}

#[test]
fn a_mean_is_the_middle_of_the_scope_or_of_one_of_its_sides() {
    use ScatterMean::{Back, Bottom, Center, Front, Left, Right, Top};
    let size = DVec3::new(10.0, 2.0, 4.0);
    for (mean, to) in [
        (Center, DVec3::ZERO),
        (Front, DVec3::Z),
        (Back, DVec3::NEG_Z),
        (Left, DVec3::NEG_X),
        (Right, DVec3::X),
        (Top, DVec3::Y),
        (Bottom, DVec3::NEG_Y),
    ] {
        let points = around(mean, Length::Relative(0.05));
        assert!(points.iter().all(|at| at.cmpge(DVec3::ZERO).all() && at.cmple(size).all()), "{mean:?}");
        // Half of the bell is outside. The mean of the other half is 0.8 deviations away.
        let expected = size * (DVec3::splat(0.5) + to * (0.5 - 0.8 * 0.05));
        let middle = points.iter().sum::<DVec3>() / 4000.0;
        assert!(((middle - expected) / size).abs().max_element() < 0.005, "{mean:?}: {middle}, not {expected}");
    }
}

#[test]
fn a_polygon_that_crosses_itself_has_points_on_both_parts() {
    use crate::geometry::mesh::{FaceTag, MeshBuilder};
    let mut builder = MeshBuilder::new();
    let bow = [[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 3.0]].map(|[x, z]| builder.point([x, 0.0, -z]));
    builder.face(&bow, &[], FaceTag::PLAIN);
    let shape = Shape::mesh_axis_aligned(builder.build().expect("a face"));
    let (points, faults) = uniform(&shape, ScatterDomain::Surface, 400.0);
    assert_eq!((points.len(), faults), (400, 0));
    let crossing = 12.0 / 7.0;
    let left = points.iter().filter(|point| point.origin.x < crossing).count();
    assert!(0 < left && left < 400);
    assert!(points.iter().all(|point| point.origin.is_finite() && point.origin.y == 0.0));
}
