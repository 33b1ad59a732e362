//! Coordinates on a map (*getGeoCoord function*).

use crate::fault::FaultKind;
use crate::run::env::Env;
use crate::shape::view::View;

/// A coordinate on a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GeoCoordinate {
    /// The coordinate to the east, in units of the coordinate system.
    X,
    /// The coordinate to the north, in units of the coordinate system.
    Y,
    /// The longitude in degrees (WGS84).
    Lon,
    /// The latitude in degrees (WGS84).
    Lat,
}

/// `getGeoCoord(X | Y | lon | lat)`: a coordinate of the scope's origin in the coordinate system of the settings. Without one, X and Y are
/// metres to the east and to the north, and longitude and latitude are 0, with a fault.
pub fn get_geo_coord(env: &mut Env, shape: &impl View, coordinate: GeoCoordinate) -> f64 {
    let origin = shape.origin();
    let Some(system) = &env.settings.coordinates else {
        return match coordinate {
            GeoCoordinate::X => origin.x,
            GeoCoordinate::Y => -origin.z,
            GeoCoordinate::Lon | GeoCoordinate::Lat => {
                let message = "`getGeoCoord` gives 0: the settings have no coordinate system";
                env.fault_once(FaultKind::Value, message);
                0.0
            }
        };
    };
    match coordinate {
        GeoCoordinate::X => system.projected(origin)[0],
        GeoCoordinate::Y => system.projected(origin)[1],
        GeoCoordinate::Lon => system.geographic(origin)[0],
        GeoCoordinate::Lat => system.geographic(origin)[1],
    }
}
