//! Initial shapes that a person chooses.

use cga::mesh::read_obj;
use cga::{Grammar, Shape};
use serde::Deserialize;

use crate::footprints::{self, Notes};

/// Initial shapes.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Lot {
    /// A rectangle on the ground: its width and its depth in metres.
    Rectangle(f64, f64),
    /// An outline on the ground, in metres: x to the right, z to the viewer.
    Outline(Vec<[f64; 2]>),
    /// The text of a GeoJSON file: each polygon is a lot.
    GeoJson(String),
    /// The text of an OBJ file: a mesh.
    Obj(String),
}

/// The most metres of a side.
const LONGEST: f64 = 10_000.0;

impl Lot {
    /// The initial shapes, with seeds from 0 on, and notes about parts of a file that are left out.
    ///
    /// # Errors
    /// A sentence for the person at the page.
    pub fn shapes(&self, grammar: &dyn Grammar) -> Result<(Vec<Shape>, Vec<String>), String> {
        let one = |shape: Shape| (vec![shape], Vec::new());
        match self {
            Lot::Rectangle(width, depth) => {
                let fits = |side: &f64| 0.0 < *side && *side <= LONGEST;
                if !(fits(width) && fits(depth)) {
                    return Err(format!("a lot of {width} x {depth} m: sides are from 0 to {LONGEST} m"));
                }
                Ok(one(Shape::rectangle(*width, *depth)))
            }
            Lot::Outline(points) => Shape::footprint(points, &[]).map(one).map_err(|error| error.to_string()),
            Lot::GeoJson(text) => {
                let mut notes = Notes::default();
                let lots = footprints::lots(text, grammar, 0, &mut notes)
                    .map_err(|why| format!("the GeoJSON file cannot be used: {why}"))?;
                Ok((lots, notes.list))
            }
            Lot::Obj(text) => {
                let file = read_obj(text.as_bytes(), &mut |_| None)
                    .map_err(|error| format!("the OBJ file cannot be used: {error}"))?;
                Ok(one(Shape::mesh(file.mesh)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use cga::RuleFile;

    use super::Lot;

    #[test]
    fn lots_have_shapes_or_a_sentence() {
        let rules = RuleFile::from_text("attr height = 3\nLot --> extrude(height) X.").expect("the rules are right");
        let count = |lot: Lot| lot.shapes(&rules).map(|(shapes, notes)| (shapes.len(), notes.len()));
        assert_eq!(count(Lot::Rectangle(20.0, 15.0)), Ok((1, 0)));
        assert!(count(Lot::Rectangle(f64::NAN, 15.0)).is_err() && count(Lot::Rectangle(-1.0, 1.0)).is_err());
        assert_eq!(count(Lot::Outline(vec![[0.0, 0.0], [5.0, 0.0], [5.0, 5.0]])), Ok((1, 0)));
        assert!(count(Lot::Outline(vec![[0.0, 0.0]])).is_err());
        let file = r#"{ "type": "FeatureCollection", "features": [
            { "type": "Feature", "properties": { "height": "9" }, "geometry": { "type": "Polygon", "coordinates": [
                [[10, 50], [10.0002, 50], [10.0002, 50.0002], [10, 50]] ] } },
            { "type": "Feature", "properties": {}, "geometry": { "type": "Point", "coordinates": [10, 50] } } ] }"#;
        assert_eq!(count(Lot::GeoJson(file.into())), Ok((1, 1)));
        assert!(count(Lot::GeoJson("[".into())).is_err_and(|why| why.contains("GeoJSON")));
        assert_eq!(count(Lot::Obj("v 0 0 0\nv 1 0 0\nv 1 0 -1\nf 1 2 3\n".into())), Ok((1, 0)));
        assert!(count(Lot::Obj("v 0 0".into())).is_err_and(|why| why.contains("OBJ")));
    }
}
