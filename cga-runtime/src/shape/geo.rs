//! Initial shapes from the polygons of `geo-types`.

use geo_types::{LineString, Polygon, Rect};

use crate::fault::Error;
use crate::shape::Shape;

/// The corners of a ring as (x, z): x to the east, z to the south. The last point of a ring repeats the first.
fn corners(ring: &LineString<f64>) -> Vec<[f64; 2]> {
    let mut list: Vec<[f64; 2]> = ring.coords().map(|point| [point.x, -point.y]).collect();
    if 1 < list.len() && list.first() == list.last() {
        list.pop();
    }
    list
}

/// The footprint with these outlines, in metres: x to the east, y to the north. The rules see y as -z.
///
/// Coordinates in degrees must be projected first.
impl TryFrom<&Polygon<f64>> for Shape {
    type Error = Error;

    fn try_from(polygon: &Polygon<f64>) -> Result<Self, Error> {
        let holes: Vec<Vec<[f64; 2]>> = polygon.interiors().iter().map(corners).collect();
        Shape::footprint(&corners(polygon.exterior()), &holes)
    }
}

/// The rectangle, in metres: x to the east, y to the north. Its front is the southern edge.
impl TryFrom<&Rect<f64>> for Shape {
    type Error = Error;

    fn try_from(rect: &Rect<f64>) -> Result<Self, Error> {
        let (low, high) = (rect.min(), rect.max());
        let corners = [[low.x, -low.y], [high.x, -low.y], [high.x, -high.y], [low.x, -high.y]];
        Shape::footprint(&corners, &[])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geo_types::{coord, polygon};

    #[test]
    fn polygons_keep_their_holes_and_face_up() {
        let square = |low: f64, high: f64| {
            LineString::from(vec![(low, low), (high, low), (high, high), (low, high), (low, low)])
        };
        for outer in
            [square(0.0, 10.0), LineString::from(square(0.0, 10.0).into_inner().into_iter().rev().collect::<Vec<_>>())]
        {
            let shape = Shape::try_from(&Polygon::new(outer, vec![square(2.0, 4.0)])).expect("a footprint");
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
        assert_eq!(shape.pivot().origin, glam::DVec3::new(1.0, 0.0, -2.0));
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
}
