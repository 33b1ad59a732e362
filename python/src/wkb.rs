//! Polygons from WKB, also from the extended form of PostGIS.

use geozero::error::{GeozeroError, Result};
use geozero::wkb::{process_ewkb_geom, process_wkb_geom};
use geozero::{CoordDimensions, GeomProcessor};

use crate::outline::{MOST_CORNERS, Outline, too_many_corners};

/// The polygons of a geometry in WKB.
///
/// # Errors
/// A sentence: the bytes are not WKB, or not polygons.
pub(crate) fn outlines(bytes: &[u8]) -> std::result::Result<Vec<Outline>, String> {
    // The extended form has its flags in the upper half of the type.
    let is_extended = match bytes {
        [0, flags, ..] | [1, _, _, _, flags, ..] => flags & 0xe0 != 0,
        _ => false,
    };
    let mut collector = Collector::default();
    let mut reader = bytes;
    let result = match is_extended {
        true => process_ewkb_geom(&mut reader, &mut collector),
        false => process_wkb_geom(&mut reader, &mut collector),
    };
    match (collector.refused, result) {
        (Some(why), _) => Err(why),
        (None, Err(why)) => Err(format!("the bytes are not WKB: {why}")),
        (None, Ok(())) => Ok(collector.outlines),
    }
}

/// Collects polygons from the events of the reader.
#[derive(Default)]
struct Collector {
    outlines: Vec<Outline>,
    corners: usize,
    refused: Option<String>,
}

impl Collector {
    fn refuse(&mut self, why: String) -> Result<()> {
        self.refused = Some(why);
        Err(GeozeroError::Geometry(String::new()))
    }

    fn is_not_a_polygon(&mut self, kind: &str) -> Result<()> {
        self.refuse(format!("a {kind} is not a polygon"))
    }

    fn corner(&mut self, x: f64, y: f64, z: Option<f64>) -> Result<()> {
        self.corners += 1;
        if MOST_CORNERS < self.corners {
            return self.refuse(too_many_corners());
        }
        self.outlines.last_mut().into_iter().for_each(|outline| outline.add(x, y, z));
        Ok(())
    }
}

macro_rules! refused {
    ($($method:ident ($($ty:ty),*) $kind:literal;)*) => {$(
        fn $method(&mut self, $(_: $ty),*) -> Result<()> {
            self.is_not_a_polygon($kind)
        }
    )*};
}

impl GeomProcessor for Collector {
    fn dimensions(&self) -> CoordDimensions {
        CoordDimensions::xyz()
    }

    fn xy(&mut self, x: f64, y: f64, _: usize) -> Result<()> {
        self.corner(x, y, None)
    }

    fn coordinate(
        &mut self,
        x: f64,
        y: f64,
        z: Option<f64>,
        _: Option<f64>,
        _: Option<f64>,
        _: Option<u64>,
        _: usize,
    ) -> Result<()> {
        self.corner(x, y, z)
    }

    fn polygon_begin(&mut self, _: bool, _: usize, _: usize) -> Result<()> {
        self.outlines.push(Outline::default());
        Ok(())
    }

    fn linestring_begin(&mut self, tagged: bool, _: usize, _: usize) -> Result<()> {
        if tagged {
            return self.is_not_a_polygon("LineString");
        }
        self.outlines.last_mut().into_iter().for_each(|outline| outline.rings.push(Vec::new()));
        Ok(())
    }

    refused! {
        point_begin(usize) "Point";
        multipoint_begin(usize, usize) "MultiPoint";
        multilinestring_begin(usize, usize) "MultiLineString";
        geometrycollection_begin(usize, usize) "GeometryCollection";
        circularstring_begin(usize, usize) "CircularString";
        compoundcurve_begin(usize, usize) "CompoundCurve";
        curvepolygon_begin(usize, usize) "CurvePolygon";
        multicurve_begin(usize, usize) "MultiCurve";
        multisurface_begin(usize, usize) "MultiSurface";
        triangle_begin(bool, usize, usize) "Triangle";
        polyhedralsurface_begin(usize, usize) "PolyhedralSurface";
        tin_begin(usize, usize) "TIN";
    }
}
