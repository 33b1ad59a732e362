//! Footprints: checked polygons in degrees, with the values of their row.

use cga::{Grammar, Shape, Value};
use serde::{Deserialize, Serialize};

use crate::column::ColumnValue;
use crate::frame::Frame;
use crate::outline::{Corner, centroid};

/// A checked polygon of a row. Equal rows of two formats have equal footprints.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Footprint {
    /// The id of the row; empty if it has none.
    pub id: String,
    /// The seed of its random numbers. It follows from the id, or without an id from the polygon, so other rows do not matter.
    pub seed: u64,
    /// The name of its grammar, if a column has it.
    pub grammar: Option<String>,
    /// Its start rule, if a column has it.
    pub start: Option<String>,
    /// The values of attributes, in the order of the grammar.
    pub values: Vec<(String, ColumnValue)>,
    /// The outer ring counter-clockwise, then holes clockwise, in degrees on WGS 84, each corner once. A footprint that crosses the meridian
    /// of 180 degrees goes on beyond it.
    pub rings: Vec<Vec<Corner>>,
    /// The height of its ground in metres.
    pub base: f64,
}

/// The order of footprints: by id, then by digest.
pub type Key = (String, [u8; 32]);

impl Footprint {
    /// The centroid of the outer ring in degrees, with a longitude from −180 to 180.
    pub fn middle(&self) -> Corner {
        let [longitude, latitude] = centroid(&self.rings[0]);
        let turned = match longitude {
            east if 180.0 < east => east - 360.0,
            west if west < -180.0 => west + 360.0,
            inside => inside,
        };
        [turned, latitude]
    }

    /// The footprint as bytes, for files and digests.
    pub fn to_bytes(&self) -> Vec<u8> {
        postcard::to_allocvec(self).unwrap_or_default()
    }

    /// Reads the bytes of [`to_bytes`](Footprint::to_bytes).
    ///
    /// # Errors
    /// The bytes are not a footprint.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        let footprint: Footprint = postcard::from_bytes(bytes).map_err(|why| format!("not a footprint: {why}"))?;
        let is_whole = !footprint.rings.is_empty() && footprint.rings.iter().all(|ring| 3 <= ring.len());
        is_whole.then_some(footprint).ok_or_else(|| "not a footprint: a ring has no area".to_owned())
    }

    /// The place of the footprint among others.
    pub fn key(&self) -> Key {
        (self.id.clone(), *blake3::hash(&self.to_bytes()).as_bytes())
    }

    /// The lot in metres of a frame. `grammar` is the grammar of the lot, which knows the types of its attributes.
    ///
    /// # Errors
    /// The polygon is not a shape, for example because it has no area in metres.
    pub fn lot(&self, grammar: &dyn Grammar, frame: &Frame) -> Result<Shape, cga::Error> {
        let ring = |ring: &Vec<Corner>| -> Vec<[f64; 2]> {
            let local = |corner: &Corner| frame.local(*corner, self.base);
            ring.iter().map(local).map(|[x, _, z]| [x, z]).collect()
        };
        let holes: Vec<_> = self.rings[1..].iter().map(ring).collect();
        let [_, height, _] = frame.local(self.middle(), self.base);
        let mut shape = Shape::footprint(&ring(&self.rings[0]), &holes)?.at([0.0, height, 0.0]).seed(self.seed);
        if !self.id.is_empty() {
            shape = shape.named(self.id.as_str());
        }
        if let Some(name) = &self.grammar {
            shape = shape.grammar(name.as_str());
        }
        if let Some(rule) = &self.start {
            shape = shape.start(rule.as_str());
        }
        let value = |name: &str, value: &ColumnValue| -> Option<Value> {
            let attribute = grammar.attributes().iter().find(|attribute| attribute.name.as_str() == name)?;
            value.to_value(attribute.ty)
        };
        Ok(self.values.iter().fold(shape, |shape, (name, column)| match value(name, column) {
            Some(value) => shape.attribute(name.as_str(), value),
            None => shape,
        }))
    }
}
