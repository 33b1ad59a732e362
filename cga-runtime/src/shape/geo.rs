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
