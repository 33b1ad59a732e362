//! East, north and up at a place on the ellipsoid WGS 84.

use crate::outline::Corner;

/// The half axis of the ellipsoid at the equator, in metres.
const EQUATOR: f64 = 6_378_137.0;
const FLATTENING: f64 = 1.0 / 298.257_223_563;
const ECCENTRICITY_SQUARED: f64 = FLATTENING * (2.0 - FLATTENING);

/// A point or a vector in metres.
pub type Vector = [f64; 3];

/// A plane that touches the ellipsoid, with metres as rules have them: x to the east, y up, z to the south. Everything is computed with
/// `libm`, so that all platforms have the same lots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    origin: Vector,
    east: Vector,
    north: Vector,
    up: Vector,
}

impl Frame {
    /// The frame at a longitude and latitude in degrees.
    pub fn at([longitude, latitude]: Corner) -> Self {
        let (sin_lon, cos_lon) = sin_cos(longitude);
        let (sin_lat, cos_lat) = sin_cos(latitude);
        Frame {
            origin: geocentric([longitude, latitude], 0.0),
            east: [-sin_lon, cos_lon, 0.0],
            north: [-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat],
            up: [cos_lat * cos_lon, cos_lat * sin_lon, sin_lat],
        }
    }

    /// A place in metres of the frame; `height` is in metres above the ellipsoid.
    pub fn local(&self, place: Corner, height: f64) -> Vector {
        let point = geocentric(place, height);
        let offset = [0, 1, 2].map(|axis| point[axis] - self.origin[axis]);
        [dot(offset, self.east), dot(offset, self.up), -dot(offset, self.north)]
    }

    /// The matrix from east, north and up to geocentric metres, by columns, as 3D Tiles have it.
    pub fn matrix(&self) -> [f64; 16] {
        let Frame { east: e, north: n, up: u, origin: o } = self;
        [e[0], e[1], e[2], 0.0, n[0], n[1], n[2], 0.0, u[0], u[1], u[2], 0.0, o[0], o[1], o[2], 1.0]
    }

    /// A point with east, north and up in metres, in geocentric metres.
    pub fn to_geocentric(&self, [e, n, u]: Vector) -> Vector {
        [0, 1, 2].map(|axis| self.origin[axis] + e * self.east[axis] + n * self.north[axis] + u * self.up[axis])
    }

    /// A point in geocentric metres as east, north and up.
    pub fn from_geocentric(&self, point: Vector) -> Vector {
        let offset = [0, 1, 2].map(|axis| point[axis] - self.origin[axis]);
        [dot(offset, self.east), dot(offset, self.north), dot(offset, self.up)]
    }

    /// The matrix from this frame to another one, by columns; both have east, north and up.
    pub fn matrix_in(&self, outer: &Frame) -> [f64; 16] {
        let turned = |vector: Vector| [dot(vector, outer.east), dot(vector, outer.north), dot(vector, outer.up)];
        let ([e, n, u], o) = ([self.east, self.north, self.up].map(turned), outer.from_geocentric(self.origin));
        [e[0], e[1], e[2], 0.0, n[0], n[1], n[2], 0.0, u[0], u[1], u[2], 0.0, o[0], o[1], o[2], 1.0]
    }
}

fn sin_cos(degrees: f64) -> (f64, f64) {
    libm::sincos(degrees.to_radians())
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A place on Earth in metres from its centre: x through longitude 0, z through the north pole.
fn geocentric([longitude, latitude]: Corner, height: f64) -> Vector {
    let (sin_lon, cos_lon) = sin_cos(longitude);
    let (sin_lat, cos_lat) = sin_cos(latitude);
    let normal = EQUATOR / (1.0 - ECCENTRICITY_SQUARED * sin_lat * sin_lat).sqrt();
    let radius = (normal + height) * cos_lat;
    [radius * cos_lon, radius * sin_lon, (normal * (1.0 - ECCENTRICITY_SQUARED) + height) * sin_lat]
}

/// The metres to the east in a degree of longitude and to the north in a degree of latitude.
pub fn metres_a_degree(latitude: f64) -> Corner {
    let (sin, cos) = sin_cos(latitude);
    let squared = 1.0 - ECCENTRICITY_SQUARED * sin * sin;
    let east = EQUATOR / squared.sqrt() * cos;
    let north = EQUATOR * (1.0 - ECCENTRICITY_SQUARED) / (squared * squared.sqrt());
    [east.to_radians(), north.to_radians()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_nearby_are_metres_away() {
        let place = [9.1, 48.7];
        let frame = Frame::at(place);
        let [east, north] = metres_a_degree(48.7);
        let [x, y, z] = frame.local([9.1 + 100.0 / east, 48.7 + 50.0 / north], 7.0);
        assert!((x - 100.0).abs() < 0.01 && (y - 7.0).abs() < 0.01 && (z + 50.0).abs() < 0.01, "{x} {y} {z}");
        assert_eq!(frame.local(place, 0.0), [0.0; 3]);
    }

    #[test]
    fn the_poles_and_the_equator_are_on_the_ellipsoid() {
        assert_eq!(geocentric([0.0, 0.0], 0.0), [EQUATOR, 0.0, 0.0]);
        let [_, _, z] = geocentric([0.0, 90.0], 0.0);
        assert!((z - 6_356_752.314_245).abs() < 1e-5);
    }

    #[test]
    fn matrices_agree_with_points() {
        let (inner, outer) = (Frame::at([9.2, 48.75]), Frame::at([9.1, 48.7]));
        let point = [12.0, -5.0, 30.0];
        let direct = outer.from_geocentric(inner.to_geocentric(point));
        let m = inner.matrix_in(&outer);
        for axis in 0..3 {
            let by_matrix = m[axis] * point[0] + m[4 + axis] * point[1] + m[8 + axis] * point[2] + m[12 + axis];
            assert!((by_matrix - direct[axis]).abs() < 1e-6);
        }
    }
}
