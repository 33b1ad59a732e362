//! Polygons from the events of `geozero`.

use geozero::error::{GeozeroError, Result};
use geozero::{ColumnValue as Given, CoordDimensions, GeomProcessor, PropertyProcessor};

use crate::column::ColumnValue;
use crate::outline::Outline;
use crate::row::{MOST_CORNERS, too_many_corners};

/// Collects the polygons and the columns of a feature.
#[derive(Debug, Default)]
pub(super) struct Collector {
    outlines: Vec<Outline>,
    pub(super) columns: Vec<(String, ColumnValue)>,
    corners: usize,
    /// The type of a part that is not a polygon.
    other: Option<&'static str>,
}

impl Collector {
    /// The polygons after all events, or the reason why they are missing. `result` is the result of the reader.
    pub(super) fn outlines(&mut self, result: Result<()>) -> std::result::Result<Vec<Outline>, String> {
        let outlines = std::mem::take(&mut self.outlines);
        match (self.other, result) {
            (Some(kind), _) => Err(format!("a {kind} is not a polygon")),
            (None, _) if MOST_CORNERS < self.corners => Err(too_many_corners(self.corners)),
            (None, Err(why)) => Err(format!("its geometry cannot be read: {why}")),
            (None, Ok(())) => Ok(outlines),
        }
    }

    fn refuse(&mut self, kind: &'static str) -> Result<()> {
        self.other = Some(kind);
        Err(GeozeroError::Geometry(format!("a {kind} is not a polygon")))
    }

    fn corner(&mut self, x: f64, y: f64, z: Option<f64>) -> Result<()> {
        self.corners += 1;
        if MOST_CORNERS < self.corners {
            return Err(GeozeroError::Geometry(too_many_corners(self.corners)));
        }
        let Some(outline) = self.outlines.last_mut() else { return Ok(()) };
        if let Some(ring) = outline.rings.last_mut() {
            ring.push([x, y]);
        }
        if outline.rings.len() == 1 {
            z.into_iter().for_each(|z| outline.lower_to(z));
        }
        Ok(())
    }
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
            return self.refuse("LineString");
        }
        self.outlines.last_mut().into_iter().for_each(|outline| outline.rings.push(Vec::new()));
        Ok(())
    }

    fn point_begin(&mut self, _: usize) -> Result<()> {
        self.refuse("Point")
    }

    fn multipoint_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("MultiPoint")
    }

    fn multilinestring_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("MultiLineString")
    }

    fn geometrycollection_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("GeometryCollection")
    }

    fn circularstring_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("CircularString")
    }

    fn compoundcurve_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("CompoundCurve")
    }

    fn curvepolygon_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("CurvePolygon")
    }

    fn multicurve_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("MultiCurve")
    }

    fn multisurface_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("MultiSurface")
    }

    fn triangle_begin(&mut self, _: bool, _: usize, _: usize) -> Result<()> {
        self.refuse("Triangle")
    }

    fn polyhedralsurface_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("PolyhedralSurface")
    }

    fn tin_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.refuse("TIN")
    }
}

impl PropertyProcessor for Collector {
    fn property(&mut self, _: usize, name: &str, value: &Given) -> Result<bool> {
        let value = match value {
            Given::Byte(number) => ColumnValue::Number(f64::from(*number)),
            Given::UByte(number) => ColumnValue::Number(f64::from(*number)),
            Given::Short(number) => ColumnValue::Number(f64::from(*number)),
            Given::UShort(number) => ColumnValue::Number(f64::from(*number)),
            Given::Int(number) => ColumnValue::Number(f64::from(*number)),
            Given::UInt(number) => ColumnValue::Number(f64::from(*number)),
            Given::Long(number) => ColumnValue::Number(*number as f64),
            Given::ULong(number) => ColumnValue::Number(*number as f64),
            Given::Float(number) => ColumnValue::Number(f64::from(*number)),
            Given::Double(number) => ColumnValue::Number(*number),
            Given::Bool(truth) => ColumnValue::Truth(*truth),
            Given::String(text) | Given::Json(text) | Given::DateTime(text) => ColumnValue::Text((*text).to_owned()),
            Given::Binary(_) => return Ok(false),
        };
        self.columns.push((name.to_owned(), value));
        Ok(false)
    }
}
