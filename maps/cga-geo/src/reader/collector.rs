//! Polygons from the events of `geozero`.

use geozero::error::{GeozeroError, Result};
use geozero::{ColumnValue as Given, CoordDimensions, GeomProcessor, PropertyProcessor};

use super::left_out;
use crate::column::ColumnValue;
use crate::outline::Outline;
use crate::row::{MOST_CORNERS, too_many_corners};

/// Collects the polygons and the columns of a feature.
#[derive(Debug, Default)]
pub(super) struct Collector {
    outlines: Vec<Outline>,
    pub(super) columns: Vec<(String, ColumnValue)>,
    /// Parts of a collection that were left out.
    pub(super) notes: Vec<String>,
    corners: usize,
    /// The type of a geometry that is not a polygon.
    other: Option<&'static str>,
    /// The number of collections around the next geometry.
    collections: usize,
    /// The number of geometries around the next corner that are not polygons.
    left_out: usize,
}

/// The most collections around a geometry. Libraries read them with recursion.
const MOST_COLLECTIONS: usize = 16;

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

    /// Begins a geometry that is not a polygon. Beside polygons of a collection it is left out.
    fn begin_other(&mut self, kind: &'static str) -> Result<()> {
        if self.collections == 0 {
            return self.refuse(kind);
        }
        let note = left_out(kind);
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
        self.left_out += 1;
        Ok(())
    }

    fn end_other(&mut self) -> Result<()> {
        self.left_out = self.left_out.saturating_sub(1);
        Ok(())
    }

    fn corner(&mut self, x: f64, y: f64, z: Option<f64>) -> Result<()> {
        self.corners += 1;
        if MOST_CORNERS < self.corners {
            return Err(GeozeroError::Geometry(too_many_corners(self.corners)));
        }
        if 0 < self.left_out {
            return Ok(());
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
            return self.begin_other("LineString");
        }
        if self.left_out == 0 {
            self.outlines.last_mut().into_iter().for_each(|outline| outline.rings.push(Vec::new()));
        }
        Ok(())
    }

    fn linestring_end(&mut self, tagged: bool, _: usize) -> Result<()> {
        if tagged { self.end_other() } else { Ok(()) }
    }

    fn point_begin(&mut self, _: usize) -> Result<()> {
        self.begin_other("Point")
    }

    fn point_end(&mut self, _: usize) -> Result<()> {
        self.end_other()
    }

    fn multipoint_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.begin_other("MultiPoint")
    }

    fn multipoint_end(&mut self, _: usize) -> Result<()> {
        self.end_other()
    }

    fn multilinestring_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.begin_other("MultiLineString")
    }

    fn multilinestring_end(&mut self, _: usize) -> Result<()> {
        self.end_other()
    }

    fn geometrycollection_begin(&mut self, _: usize, _: usize) -> Result<()> {
        self.collections += 1;
        if MOST_COLLECTIONS < self.collections {
            let why = format!("more than {MOST_COLLECTIONS} collections are inside of each other");
            return Err(GeozeroError::Geometry(why));
        }
        Ok(())
    }

    fn geometrycollection_end(&mut self, _: usize) -> Result<()> {
        self.collections = self.collections.saturating_sub(1);
        Ok(())
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

#[cfg(all(test, feature = "wkb"))]
mod tests {
    use geozero::wkb::process_wkb_geom;

    use super::*;

    /// The head of a geometry as WKB.
    fn head(kind: u32, count: Option<u32>) -> Vec<u8> {
        let mut bytes = vec![1];
        bytes.extend(kind.to_le_bytes());
        bytes.extend(count.into_iter().flat_map(u32::to_le_bytes));
        bytes
    }

    fn numbers(numbers: &[f64]) -> Vec<u8> {
        numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
    }

    fn square() -> Vec<u8> {
        let ring = [0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0];
        [head(3, Some(1)), 5u32.to_le_bytes().to_vec(), numbers(&ring)].concat()
    }

    fn read(bytes: &[u8]) -> (std::result::Result<Vec<Outline>, String>, Vec<String>) {
        let mut collector = Collector::default();
        let result = process_wkb_geom(&mut &*bytes, &mut collector);
        (collector.outlines(result), collector.notes)
    }

    #[test]
    fn the_polygons_of_a_collection_are_used_and_others_are_noted() {
        let point = [head(1, None), numbers(&[9.0, 9.0])].concat();
        let line = [head(2, Some(2)), numbers(&[7.0, 7.0, 8.0, 8.0])].concat();
        let lines = [head(5, Some(1)), line.clone()].concat();
        let many = [head(6, Some(2)), square(), square()].concat();
        let inner = [head(7, Some(2)), square(), point.clone()].concat();
        let all = [head(7, Some(6)), square(), point.clone(), line, lines, many, inner].concat();
        let (outlines, notes) = read(&all);
        let outlines = outlines.expect("polygons");
        assert_eq!(outlines.len(), 4);
        assert!(outlines.iter().all(|outline| outline.rings.len() == 1 && outline.rings[0].len() == 5));
        assert_eq!(notes, ["Point", "LineString", "MultiLineString"].map(left_out));
        assert_eq!(read(&point).0, Err("a Point is not a polygon".to_owned()));
    }

    #[test]
    fn collections_inside_of_each_other_end() {
        let bytes = head(7, Some(1)).repeat(200_000);
        assert!(read(&bytes).0.expect_err("too deep").contains("more than 16 collections"));
    }
}
