//! Centre lines from the lines of `geo-types`.

use geo_types::LineString;

use super::Centerline;

/// The centre line with these points, in metres: x to the east, y to the north. The rules see y as -z.
impl From<&LineString<f64>> for Centerline {
    fn from(line: &LineString<f64>) -> Self {
        Centerline::new(&line.coords().map(|point| [point.x, -point.y]).collect::<Vec<_>>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_north_is_behind() {
        let line = LineString::from(vec![(0.0, 0.0), (3.0, 4.0)]);
        assert_eq!(Centerline::from(&line), Centerline::new(&[[0.0, 0.0], [3.0, -4.0]]));
    }
}
