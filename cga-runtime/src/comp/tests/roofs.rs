//! Trim planes and edges of the roofs that operations make.

use glam::DVec3;

use super::{arm, parts};
use crate::comp::select::Word;
use crate::comp::{Align, Components, Mode};
use crate::geometry::mesh::Mesh;
use crate::op::{self, RoofValue};
use crate::run::env::Env;
use crate::shape::Shape;

fn lot(corners: &[[f64; 2]]) -> Shape {
    let ring: Vec<DVec3> = corners.iter().map(|[x, y]| DVec3::new(*x, 0.0, -*y)).collect();
    Shape::mesh_axis_aligned(Mesh::from_polygon(&ring, &[]).expect("a polygon"))
}

fn rectangle() -> Shape {
    lot(&[[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]])
}

fn l_lot() -> Shape {
    lot(&[[0.0, 0.0], [4.0, 0.0], [4.0, 6.0], [10.0, 6.0], [10.0, 10.0], [0.0, 10.0]])
}

fn roof(lot: Shape, build: impl Fn(&mut Env, &mut Shape)) -> Shape {
    let (env, mut shape) = (&mut Env::for_tests(), lot);
    build(env, &mut shape);
    assert!(env.take_faults().0.is_empty());
    shape
}

/// For each face the numbers of vertical and of horizontal planes.
fn planes(roof: &Shape) -> Vec<[usize; 2]> {
    let faces = parts(roof, Components::Faces, Align::ZUp, &[arm(Word::All, Mode::Each)]);
    let count = |face: &Shape| {
        let planes = face.trims.planes(&face.pivot);
        let level = planes.iter().filter(|plane| plane.is_horizontal(&face.pivot)).count();
        [planes.len() - level, level]
    };
    faces.iter().map(|part| count(&part.2)).collect()
}

/// The numbers of eaves, hips, valleys and ridges.
fn edges(roof: &Shape) -> [usize; 4] {
    let words = [Word::Eave, Word::Hip, Word::Valley, Word::Ridge].map(|word| arm(word, Mode::Each));
    let found = parts(roof, Components::Edges, Align::ZUp, &words);
    [0, 1, 2, 3].map(|arm| found.iter().filter(|part| part.0 == arm).count())
}

/// Two upright planes at the hips of each face, and level ones at the ridge; none at the eaves. The hips of a roof of 45 degrees
/// rise by 35 degrees in the world, and by 55 in their faces (*trim attribute*, pictures).
#[test]
fn hips_have_upright_planes_and_ridges_level_ones() {
    let none = [0, 0];
    for overhang in [0.0, 1.0] {
        let hip = roof(rectangle(), |env, shape| op::roof_hip(env, shape, 45.0, overhang, false));
        assert_eq!(planes(&hip), [[2, 1], [2, 0], [2, 1], [2, 0], none]);
        assert_eq!(edges(&hip), [4, 4, 0, 1]);
        // In the order of edges from the upper edge at the concave corner: a hip and a valley; the ends have two hips.
        let hip = roof(l_lot(), |env, shape| op::roof_hip(env, shape, 30.0, overhang, false));
        assert_eq!(planes(&hip), [[2, 0], [2, 1], [2, 1], [2, 0], [2, 1], [2, 1], none]);
        assert_eq!(edges(&hip), [6, 5, 1, 2]);
    }
}

/// Ridges, hip and valley have planes, verges have none (*roofGable operation*, second picture).
#[test]
fn verges_have_no_planes() {
    let none = [0, 0];
    for [across, along] in [[0.0, 0.0], [2.0, 1.0], [0.0, 1.0]] {
        let gable = roof(rectangle(), |env, shape| op::roof_gable(env, shape, 30.0, across, along, false));
        assert_eq!(planes(&gable), [[0, 1], none, [0, 1], none, none]);
        assert_eq!(edges(&gable), [2, 0, 0, 1]);
        let gable = roof(l_lot(), |env, shape| op::roof_gable(env, shape, 30.0, across, along, false));
        assert_eq!(planes(&gable), [none, [1, 1], [1, 1], none, [1, 1], [1, 1], none]);
        assert_eq!(edges(&gable), [4, 1, 1, 2]);
    }
}

/// Planes at all edges to the apex (*roofPyramid operation*, second picture).
#[test]
fn pyramids_have_planes_to_the_apex() {
    let pentagon = lot(&[[0.0, 0.0], [20.0, -2.0], [24.0, 12.0], [12.0, 22.0], [-3.0, 14.0]]);
    let pyramid = roof(pentagon, |env, shape| op::roof_pyramid(env, shape, 30.0));
    assert_eq!(planes(&pyramid), [[2, 0], [2, 0], [2, 0], [2, 0], [2, 0], [0, 0]]);
    assert_eq!(edges(&pyramid), [5, 5, 0, 0]);
}

/// Trim planes at the upright edges between sides (*roofShed operation*, second picture). The roof plane has one eave, the
/// edge that it rises from: "horizontal border edges on the bottom of the roof" (*comp operation*, roof edges).
#[test]
fn a_shed_has_planes_between_its_sides() {
    let shed = roof(rectangle(), |env, shape| op::roof_shed(env, shape, 30.0, 0.0));
    assert_eq!(planes(&shed), [[0, 0], [1, 0], [2, 0], [1, 0], [0, 0]]);
    assert_eq!(edges(&shed), [1, 0, 0, 0]);
    let shed = roof(l_lot(), |env, shape| op::roof_shed(env, shape, 10.0, 3.0));
    let sides = planes(&shed);
    // The sides beside the edge of the plane have one plane. At the concave corner a plane would cut the faces.
    assert_eq!((sides[3], sides[2], sides[4]), ([0, 0], [1, 0], [1, 0]));
    assert!(sides.iter().all(|[_, level]| *level == 0));
}

/// Planes at the ridge, and at the upright edges between sides (*roofRidge operation*, second picture).
#[test]
fn a_ridge_has_level_planes() {
    let ridge = roof(rectangle(), |env, shape| op::roof_ridge_by(env, shape, RoofValue::ByAngle, 30.0));
    assert_eq!(planes(&ridge), [[0, 1], [0, 1], [0, 0], [0, 0], [0, 0]]);
    assert_eq!(edges(&ridge), [2, 0, 0, 1]);
    let ridge = roof(l_lot(), |env, shape| op::roof_ridge_by(env, shape, RoofValue::ByAngle, 30.0));
    let all = planes(&ridge);
    let tops = all.iter().filter(|[upright, level]| *upright == 0 && *level == 1).count();
    assert_eq!((tops, all.iter().map(|planes| planes[1]).sum::<usize>()), (2, 2));
    assert!(4 <= all.iter().map(|planes| planes[0]).sum::<usize>());
}

/// A bar of the roof's edges runs upwards, and eaves run around the roof (*comp operation*, roof edges).
#[test]
fn edges_run_upwards_and_eaves_around() {
    let u =
        lot(&[[0.0, 0.0], [6.0, 0.0], [6.0, 10.0], [16.0, 10.0], [16.0, 0.0], [22.0, 0.0], [22.0, 18.0], [0.0, 18.0]]);
    let hip = roof(u.clone(), |env, shape| op::roof_hip(env, shape, 45.0, 0.0, false));
    // As in the picture: two hips at the back and two at each end, and short ridges between the ridges of wings and back.
    assert_eq!(edges(&hip), [8, 6, 2, 5]);
    let gable = roof(u, |env, shape| op::roof_gable(env, shape, 45.0, 0.0, 0.0, false));
    assert_eq!(edges(&gable), [6, 2, 2, 5]);
    let words = [Word::Hip, Word::Valley, Word::Ridge].map(|word| arm(word, Mode::Each));
    for (.., edge) in parts(&gable, Components::Edges, Align::ZUp, &words) {
        assert!(-1e-9 < edge.scope.axes.x_axis.y);
    }
    let mut around = DVec3::ZERO;
    for (.., eave) in parts(&hip, Components::Edges, Align::ZUp, &[arm(Word::Eave, Mode::Each)]) {
        around += eave.scope.axes.x_axis * eave.scope.size.x;
    }
    // The eaves of a hip roof are a closed loop.
    assert!(around.length() < 1e-9);
}

/// A negative overhang leaves level eaves, also of the faces that `even` bends, so hips touch eaves.
#[test]
fn even_roofs_that_are_taken_back_have_all_eaves() {
    let quadrilateral = || lot(&[[0.0, 0.0], [12.0, 0.0], [12.0, 5.0], [0.0, 9.0]]);
    for (overhang, even) in [(0.0, true), (0.5, true), (-0.5, false), (-0.5, true), (-0.01, true)] {
        let hip = roof(quadrilateral(), |env, shape| op::roof_hip(env, shape, 45.0, overhang, even));
        assert_eq!(edges(&hip), [4, 4, 0, 1], "{overhang} {even}");
    }
    let gable = roof(quadrilateral(), |env, shape| op::roof_gable(env, shape, 45.0, -0.5, -0.2, true));
    assert_eq!(edges(&gable), [2, 0, 0, 1]);
}

/// A face of a roof has its eave along x, its slope along y, and its pivot at the left end of the eave (*trim attribute*,
/// pictures).
#[test]
fn faces_stand_on_their_eaves() {
    let hip = roof(rectangle(), |env, shape| op::roof_hip(env, shape, 45.0, 0.0, false));
    let faces = parts(&hip, Components::Faces, Align::ZUp, &[arm(Word::All, Mode::Each)]);
    let first = &faces[0].2;
    assert!((first.pivot.origin - DVec3::ZERO).length() < 1e-9);
    assert!((first.pivot.axes.x_axis - DVec3::X).length() < 1e-9);
    assert!((first.pivot.axes.y_axis - DVec3::new(0.0, 1.0, -1.0).normalize()).length() < 1e-9);
    assert!((first.scope.size - DVec3::new(10.0, 32f64.sqrt(), 0.0)).length() < 1e-9);
}
