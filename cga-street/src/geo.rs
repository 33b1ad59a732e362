//! Centre lines from the lines of `geo-types`.

use geo_types::LineString;

use super::Centerline;

/// The centre line with these points, in metres: x to the east, y to the north. The rules see y as -z.
impl From<&LineString<f64>> for Centerline {
    fn from(line: &LineString<f64>) -> Self {
        Centerline::new(&line.coords().map(|point| [point.x, -point.y]).collect::<Vec<_>>())
    }
}
