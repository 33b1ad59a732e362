//! The feature `geo-types`: shapes from polygons and rectangles, centre lines from lines.

use cga::glam::DVec3;
use cga::street::Centerline;
use cga::{Error, Shape};
use geo_types::{LineString, Polygon, Rect, coord, polygon};

#[test]
fn polygons_keep_their_holes_and_face_up() {
    let square = |low: f64, high: f64| vec![(low, low), (high, low), (high, high), (low, high), (low, low)];
    let [one, mut other] = [square(0.0, 10.0), square(0.0, 10.0)];
    other.reverse();
    for outer in [one, other] {
        let polygon = Polygon::new(LineString::from(outer), vec![LineString::from(square(2.0, 4.0))]);
        let shape = Shape::try_from(&polygon).expect("a footprint");
        let mesh = shape.to_mesh();
        assert_eq!((mesh.area(), mesh.face_count()), (96.0, 1));
        // The south is at z = 0 and the north at z = -10.
        let world = shape.scope().placement();
        let bounds = mesh
            .points()
            .iter()
            .map(|&at| world.transform_point3(at).z)
            .fold((0.0, 0.0), |(low, high), z| (f64::min(low, z), f64::max(high, z)));
        assert_eq!(bounds, (-10.0, 0.0));
    }
}

#[test]
fn rectangles_have_their_front_in_the_south() {
    let rect = Rect::new(coord! { x: 3.0, y: 5.0 }, coord! { x: 1.0, y: 2.0 });
    let shape = Shape::try_from(&rect).expect("a footprint");
    assert_eq!((shape.scope().size.x, shape.scope().size.z), (2.0, 3.0));
    assert_eq!(shape.pivot().origin, DVec3::new(1.0, 0.0, -2.0));
}

#[test]
fn polygons_without_area_are_refused() {
    let line = polygon![(x: 0.0, y: 0.0), (x: 1.0, y: 1.0), (x: 2.0, y: 2.0)];
    assert!(matches!(Shape::try_from(&line), Err(Error::Shape(_))));
    let nowhere = polygon![(x: 0.0, y: 0.0), (x: f64::NAN, y: 1.0), (x: 2.0, y: 0.0)];
    assert!(matches!(Shape::try_from(&nowhere), Err(Error::Shape(_))));
    let empty = Polygon::new(LineString::new(Vec::new()), Vec::new());
    assert!(matches!(Shape::try_from(&empty), Err(Error::Shape(_))));
}

#[test]
fn the_north_is_behind() {
    let line = LineString::from(vec![(0.0, 0.0), (3.0, 4.0)]);
    assert_eq!(Centerline::from(&line), Centerline::new(&[[0.0, 0.0], [3.0, -4.0]]));
}
