//! Coordinate systems, by their codes of EPSG.

use std::fmt;
use std::str::FromStr;

use proj4rs::Proj;
use proj4rs::transform::transform;

use crate::outline::Corner;

/// The code of longitude and latitude in degrees on WGS 84.
pub const WGS_84: u32 = 4326;

/// A coordinate system, from which corners are converted to degrees on WGS 84.
///
/// ```
/// use cga_geo::crs::Crs;
///
/// let utm: Crs = "EPSG:25832".parse()?;
/// let [longitude, latitude] = utm.degrees([500_000.0, 5_400_000.0])?;
/// assert!((longitude - 9.0).abs() < 1e-9 && (latitude - 48.75).abs() < 0.01);
/// # Ok::<(), String>(())
/// ```
#[derive(Debug)]
pub struct Crs {
    code: u32,
    /// The system and WGS 84; `None` for degrees on WGS 84.
    projection: Option<Box<[Proj; 2]>>,
}

impl Crs {
    /// The coordinate system of a code. Degrees are longitude, then latitude, as map files have them.
    ///
    /// # Errors
    /// A sentence for an unknown code.
    pub fn from_epsg(code: u32) -> Result<Self, String> {
        // 4979 has heights on the ellipsoid, too.
        if code == WGS_84 || code == 4979 {
            return Ok(Crs { code, projection: None });
        }
        let unknown = || {
            format!(
                "EPSG:{code} is not a known coordinate system; look up the code of the map, such as EPSG:25832 for UTM zone 32 in Europe \
                 and EPSG:4326 for degrees"
            )
        };
        let short = u16::try_from(code).map_err(|_| unknown())?;
        let own = Proj::from_epsg_code(short).map_err(|why| match why {
            proj4rs::errors::Error::ProjectionNotFound => unknown(),
            why => {
                format!("EPSG:{code} cannot be used ({why}); convert the file to degrees with a GIS, for example QGIS or ogr2ogr")
            }
        })?;
        let degrees = Proj::from_epsg_code(WGS_84 as u16).map_err(|why| format!("EPSG:4326 cannot be used: {why}"))?;
        Ok(Crs { code, projection: Some(Box::new([own, degrees])) })
    }

    /// The code.
    pub fn code(&self) -> u32 {
        self.code
    }

    /// The longitude in the middle of its zone, for the UTM zones of WGS 84, ETRS89, ED50, NAD83 and NAD27.
    pub fn zone_middle(&self) -> Option<f64> {
        let zone = match self.code {
            32601..=32660 => self.code - 32600,
            32701..=32760 => self.code - 32700,
            25828..=25838 => self.code - 25800,
            23028..=23038 => self.code - 23000,
            26901..=26923 => self.code - 26900,
            26701..=26722 => self.code - 26700,
            _ => return None,
        };
        Some(6.0 * f64::from(zone) - 183.0)
    }

    /// The longitude and latitude of a point in degrees.
    ///
    /// # Errors
    /// A sentence for a point that the coordinate system does not cover.
    pub fn degrees(&self, point: Corner) -> Result<Corner, String> {
        let Some(projection) = &self.projection else {
            let [longitude, latitude] = point;
            let are_degrees = longitude.abs() <= 360.0 && latitude.abs() <= 90.0;
            return are_degrees.then_some(point).ok_or_else(|| {
                format!("({longitude}, {latitude}) is not a longitude and a latitude in degrees; name the coordinate system, as in `--crs EPSG:25832`")
            });
        };
        let [own, wgs_84] = &**projection;
        let place = |[x, y]: Corner| format!("({x}, {y}) is outside of EPSG:{}", self.code);
        let converted = convert(own, wgs_84, point).ok_or_else(|| place(point))?;
        // Far from its area, a projection has results that lead elsewhere.
        let back = convert(wgs_84, own, converted).ok_or_else(|| place(point))?;
        let tolerance = if own.is_latlong() { 1e-5 } else { 1.0 };
        let is_near = (back[0] - point[0]).abs().max((back[1] - point[1]).abs()) <= tolerance;
        if is_near && converted[1].abs() <= 90.0 { Ok(converted) } else { Err(place(point)) }
    }
}

/// Converts a point; degrees are converted to radians and back.
fn convert(from: &Proj, to: &Proj, [x, y]: Corner) -> Option<Corner> {
    let mut point = if from.is_latlong() { (x.to_radians(), y.to_radians(), 0.0) } else { (x, y, 0.0) };
    transform(from, to, &mut point).ok()?;
    let (x, y, _) = if to.is_latlong() { (point.0.to_degrees(), point.1.to_degrees(), 0.0) } else { point };
    (x.is_finite() && y.is_finite()).then_some([x, y])
}

impl FromStr for Crs {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let code = text.trim();
        let code =
            code.split_once(':').filter(|(name, _)| name.eq_ignore_ascii_case("EPSG")).map_or(code, |(_, code)| code);
        let code = code.parse().map_err(|_| format!("`{text}` is not a code of EPSG; write `EPSG:25832`"))?;
        Crs::from_epsg(code)
    }
}

impl fmt::Display for Crs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "EPSG:{}", self.code)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn projected_points_become_degrees() {
        // The zero of UTM zone 32 is at 9 degrees east on the equator, 500 km to the east of its origin.
        let utm = Crs::from_epsg(32632).expect("known");
        let [longitude, latitude] = utm.degrees([500_000.0, 0.0]).expect("inside");
        assert!((longitude - 9.0).abs() < 1e-9 && latitude.abs() < 1e-9);
        assert_eq!(utm.zone_middle(), Some(9.0));
        // 1 km to the north near the equator: the meridian has 110,574 m a degree there, and the zone a scale of 0.9996.
        let [_, latitude] = utm.degrees([500_000.0, 1000.0]).expect("inside");
        assert!((latitude - 1.0 / 110.574 / 0.9996).abs() < 1e-6, "{latitude}");
        let mercator = Crs::from_epsg(3857).expect("known");
        let [longitude, latitude] = mercator.degrees([1_113_194.907_932_735_6, 0.0]).expect("inside");
        assert!((longitude - 10.0).abs() < 1e-9 && latitude.abs() < 1e-9);
    }

    #[test]
    fn points_outside_are_refused() {
        let utm = Crs::from_epsg(25832).expect("known");
        assert!(utm.degrees([1e9, 5e6]).unwrap_err().contains("outside of EPSG:25832"));
        let degrees = Crs::from_epsg(4326).expect("known");
        assert!(degrees.degrees([3_500_000.0, 5_400_000.0]).unwrap_err().contains("--crs"));
        assert!(degrees.degrees([180.5, 10.0]).is_ok());
    }

    #[test]
    fn codes_are_read_with_and_without_their_name() {
        assert_eq!("epsg:3857".parse::<Crs>().map(|crs| crs.code()), Ok(3857));
        assert_eq!("4326".parse::<Crs>().map(|crs| crs.code()), Ok(4326));
        assert!("EPSG:99999".parse::<Crs>().is_err());
        assert!("Gauss".parse::<Crs>().unwrap_err().contains("write `EPSG:25832`"));
    }
}
