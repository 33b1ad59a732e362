//! Mistakes of a first program: distances, roundings, rings, roofs and faces.

use std::sync::Arc;

use cga_geometry::boolean::{BooleanError, BooleanOp, combine};
use cga_geometry::cut::slabs;
use cga_geometry::glam::{DAffine3, DVec2, DVec3};
use cga_geometry::nesting::NestedRings;
use cga_geometry::roof::{Rise, RoofForm, roof_over};
use cga_geometry::skeleton::{self, SkeletonError};
use cga_geometry::unbent::planar_faces;
use cga_geometry::{Axis, obj, primitive};

#[test]
fn sweeps_refuse_negative_and_nan_distances() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
    for distance in [-1.0, f64::NAN, f64::NEG_INFINITY] {
        let swept = skeleton::sweep(&square, &[vec![0, 1, 2, 3]], distance);
        assert_eq!(swept.map(|swept| swept.strips.len()), Err(SkeletonError::Tangled), "{distance}");
    }
}

#[test]
fn rings_without_corners_are_left_out() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
    let nested = NestedRings::of(&square, [vec![], vec![0, 1, 2, 3], vec![]].into_iter());
    assert_eq!(nested.polygons().map(|rings| rings.len()).collect::<Vec<_>>(), [1]);
    assert_eq!(NestedRings::of(&square, [Vec::<u32>::new()].into_iter()).polygons().len(), 0);
}

#[test]
fn roundings_beyond_the_size_are_refused() {
    let cube = primitive::cube();
    let other = cube.map(&DAffine3::from_translation(DVec3::splat(0.5)));
    for rounding in [0.1, 0.3, 1.0, 1e9] {
        let made = combine(BooleanOp::Union, [std::slice::from_ref(&cube), std::slice::from_ref(&other)], rounding);
        assert_eq!(made.map(|made| made.face_count()), Err(BooleanError::Tangled), "{rounding}");
    }
}

#[test]
fn roofs_without_numbers_are_refused() {
    let square = primitive::quad();
    let forms =
        [RoofForm::Pyramid, RoofForm::Shed { edge: 0 }, RoofForm::Ridge, RoofForm::Hip { overhang: 0.0, even: false }];
    for (form, number) in forms.into_iter().flat_map(|form| [f64::NAN, f64::INFINITY].map(|number| (form, number))) {
        for rise in [Rise::Slope(number), Rise::Height(number)] {
            assert_eq!(roof_over(&square, form, rise).refused.len(), 1, "{form:?} {rise:?}");
        }
    }
    let overhang = RoofForm::Hip { overhang: f64::NAN, even: false };
    assert_eq!(roof_over(&square, overhang, Rise::Slope(1.0)).refused.len(), 1);
}

/// A cube with one raised corner: its top is not planar.
#[test]
fn volumes_add_up_once_faces_are_planar() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv 0 1 0\nv 1 1 0\nv 1 1.5 1\nv 0 1 1\n\
                f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";
    let mesh = obj::read(text.as_bytes()).expect("a mesh").mesh;
    let planar = Arc::new(planar_faces(&mesh).into_owned());
    assert_eq!((planar.face_count(), planar.check(), planar.is_closed()), (7, vec![], true));
    let mut parts = vec![planar.clone()];
    for axis in [Axis::X, Axis::Y, Axis::Z] {
        parts = parts.iter().flat_map(|part| slabs(part, axis, &[0.3, 0.6]).parts).flatten().collect();
    }
    let sum: f64 = parts.iter().map(|part| part.volume()).sum();
    assert!((sum - planar.volume()).abs() < 1e-12 && parts.iter().all(|part| part.is_closed()), "{sum}");
}
