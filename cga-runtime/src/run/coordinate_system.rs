//! The place of a scene on Earth.

use std::fmt;

use glam::DVec3;

/// The coordinate system of a scene, for `getGeoCoord` and `scope.elevation`. The program knows the projection and the origin.
///
/// Points are in metres, x to the east, y up, z to the south, as everywhere. A method must give the same result for the same point, on every
/// thread.
///
/// ```
/// # use cga_runtime::facade as cga;
/// use cga::glam::DVec3;
/// use cga::CoordinateSystem;
///
/// /// A plan in feet whose origin is at (1000, 2000), 40 m above the sea.
/// #[derive(Debug)]
/// struct Plan;
///
/// impl CoordinateSystem for Plan {
///     fn projected(&self, point: DVec3) -> [f64; 2] {
///         [1000.0 + point.x / 0.3048, 2000.0 - point.z / 0.3048]
///     }
///     fn geographic(&self, _: DVec3) -> [f64; 2] {
///         [8.55, 47.37]
///     }
///     fn elevation(&self, point: DVec3) -> f64 {
///         40.0 + point.y
///     }
/// }
/// assert_eq!(Plan.projected(DVec3::new(3.048, 0.0, 0.0)), [1010.0, 2000.0]);
/// ```
pub trait CoordinateSystem: fmt::Debug + Send + Sync {
    /// The coordinates of a point to the east and to the north, in units of the system.
    fn projected(&self, point: DVec3) -> [f64; 2];

    /// The longitude and the latitude of a point, in degrees (WGS84).
    fn geographic(&self, point: DVec3) -> [f64; 2];

    /// The height of a point above sea level, in metres. By default its y coordinate.
    fn elevation(&self, point: DVec3) -> f64 {
        point.y
    }
}
