//! From rows to footprints: checks, coordinates, attributes, heights. Each row and each value that cannot be used is reported.

mod check;
mod crossing;

use std::sync::Arc;

use cga::{Attribute, ChoiceValues, Grammar, Value};
use serde::{Deserialize, Serialize};

use self::check::{Checked, check};
use crate::column::ColumnValue;
use crate::crs::Crs;
use crate::footprint::Footprint;
use crate::frame::Frame;
use crate::outline::{Corner, HEIGHTS, Outline};
use crate::plain::plain;
use crate::row::Row;
use crate::terrain::Terrain;

/// The columns that have a meaning.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Columns {
    /// The column of ids. Without it, the id that the format has beside its columns, then the column `id`.
    pub id: Option<String>,
    /// The column with the names of grammars.
    pub grammar: Option<String>,
    /// The column with the names of start rules.
    pub start: Option<String>,
    /// Columns and the attributes that they set. Other attributes are set by the columns of their names.
    pub attributes: Vec<(String, String)>,
    /// The attribute that gets the difference of the highest and the lowest ground below the corners, in metres.
    pub footing: Option<String>,
}

impl Columns {
    /// The columns that options name, each after its option of the command `cga-city`.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let own = [("--id", &self.id), ("--grammar-column", &self.grammar), ("--start-column", &self.start)];
        let own = own.into_iter().filter_map(|(option, column)| Some((option, column.as_deref()?)));
        own.chain(self.attributes.iter().map(|(column, _)| ("--attribute", column.as_str())))
    }

    /// The names of all columns that a survey reads with some grammars.
    pub fn names(&self, grammars: &[&dyn Grammar]) -> Vec<String> {
        let attributes = grammars.iter().flat_map(|grammar| grammar.attributes());
        let by_name = attributes.map(|attribute| attribute.name.as_str().to_owned());
        let named = self.named().map(|(_, column)| column.to_owned());
        let mut names: Vec<String> = by_name.chain(named).chain(["id".to_owned()]).collect();
        names.sort_unstable();
        names.dedup();
        names
    }
}

/// The most characters of a value of a file in a reason.
const MOST_SHOWN: usize = 60;

/// A row, a polygon or a value that cannot be used as it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The number of the row in its file, from 1.
    pub row: u64,
    /// The id of the row; empty if it has none.
    pub id: String,
    /// True if the row or one of its polygons has no building because of it.
    pub is_lost: bool,
    /// The reason, as a sentence without its end.
    pub reason: String,
}

/// The footprints and the problems of a row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Survey {
    /// A footprint for each polygon.
    pub footprints: Vec<Footprint>,
    /// The problems.
    pub problems: Vec<Problem>,
}

/// Makes footprints of rows.
pub struct Surveyor<'g> {
    grammars: Vec<&'g dyn Grammar>,
    columns: Columns,
    crs: Crs,
    terrain: Option<Arc<dyn Terrain>>,
}

impl<'g> Surveyor<'g> {
    /// A surveyor for rows in degrees, on flat ground. A row without a grammar of its own has the first one.
    ///
    /// # Panics
    /// Without a grammar.
    pub fn new(grammars: Vec<&'g dyn Grammar>, columns: Columns) -> Self {
        assert!(!grammars.is_empty(), "a surveyor needs a grammar");
        Surveyor {
            grammars,
            columns,
            crs: Crs::from_epsg(crate::crs::WGS_84).expect("degrees are known"),
            terrain: None,
        }
    }

    /// Sets the coordinate system of the rows.
    #[must_use]
    pub fn crs(mut self, crs: Crs) -> Self {
        self.crs = crs;
        self
    }

    /// Sets the heights of the ground. They win over heights of the rows.
    #[must_use]
    pub fn terrain(mut self, terrain: Arc<dyn Terrain>) -> Self {
        self.terrain = Some(terrain);
        self
    }

    /// The footprints of a row.
    pub fn survey(&self, row: Row) -> Survey {
        let id = self.id(&row);
        let mut survey = Survey::default();
        let mut problem = |is_lost: bool, reason: String| {
            survey.problems.push(Problem { row: row.number, id: id.clone(), is_lost, reason });
        };
        let outlines = match &row.outlines {
            Ok(outlines) if outlines.is_empty() => Err("it has no polygon".to_owned()),
            Ok(outlines) => Ok(outlines),
            Err(why) => Err(why.clone()),
        };
        let outlines = match outlines {
            Ok(outlines) => outlines,
            Err(why) => {
                problem(true, why);
                return survey;
            }
        };
        row.notes.iter().for_each(|note| problem(false, note.clone()));
        let text =
            |name: &Option<String>| Some(row.column(name.as_ref()?)?.to_string()).filter(|text| !text.is_empty());
        let grammar_name = text(&self.columns.grammar);
        let grammar = match &grammar_name {
            None => Some(self.grammars[0]),
            Some(name) => self.grammars.iter().find(|grammar| grammar.name() == name).copied(),
        };
        let Some(own_grammar) = grammar else {
            let known: Vec<&str> = self.grammars.iter().map(|grammar| grammar.name()).collect();
            let name = plain(&grammar_name.unwrap_or_default(), MOST_SHOWN);
            problem(true, format!("`{name}` is not one of the grammars {}", known.join(", ")));
            return survey;
        };
        let start = text(&self.columns.start);
        if let Some(rule) =
            start.as_ref().filter(|rule| !own_grammar.start_rules().iter().any(|known| known.name.is(rule)))
        {
            problem(true, format!("`{}` is not a start rule of `{}`", plain(rule, MOST_SHOWN), own_grammar.name()));
            return survey;
        }
        let values = self.values(&row, own_grammar, &mut |why| problem(false, why));
        let count = outlines.len();
        let mut footprints = Vec::new();
        for (part, outline) in outlines.iter().enumerate() {
            let label = |why: String| if count == 1 { why } else { format!("polygon {} of {count}: {why}", part + 1) };
            let Checked { rings, place, holes_lost, holes_misplaced, note } = match check(outline, &self.crs) {
                Ok(checked) => checked,
                Err(why) => {
                    problem(true, label(why));
                    continue;
                }
            };
            if 0 < holes_lost {
                problem(false, label(format!("{holes_lost} holes without an area were left out")));
            }
            if 0 < holes_misplaced {
                let why =
                    format!("{holes_misplaced} holes outside of the outline or inside of other holes were left out");
                problem(false, label(why));
            }
            note.into_iter().for_each(|note| problem(false, label(note)));
            if let Some(height) = outline.wrong_height.filter(|_| self.terrain.is_none()) {
                let (low, high) = (HEIGHTS.start(), HEIGHTS.end());
                let why = format!("a height of {height:e} m is left out: heights are from {low} m to {high} m");
                problem(false, label(why));
            }
            let (base, rise) = self.ground(outline, &place, &mut |why| problem(false, label(why)));
            let mut values = values.clone();
            let footing = |name: &&String| !values.iter().any(|(known, _)| known == *name);
            if let Some(name) = self.columns.footing.as_ref().filter(footing) {
                values.push((name.clone(), ColumnValue::Number(rise)));
            }
            let (grammar, start, id) = (grammar_name.clone(), start.clone(), id.clone());
            let footprint = Footprint { seed: seed(&id, part, &rings), id, grammar, start, values, rings, base };
            // A tile would report the polygon, too, but without its row.
            if 1 < footprint.rings.len()
                && let Err(why) = footprint.lot(own_grammar, &Frame::at(footprint.middle()))
            {
                problem(true, label(why.to_string()));
                continue;
            }
            footprints.push(footprint);
        }
        survey.footprints = footprints;
        survey
    }

    fn id(&self, row: &Row) -> String {
        let id = match &self.columns.id {
            Some(name) => row.column(name).map(ColumnValue::to_string),
            None => row.id.clone().or_else(|| row.column("id").map(ColumnValue::to_string)),
        };
        id.unwrap_or_default()
    }

    /// The values of attributes, in the order of the grammar.
    fn values(&self, row: &Row, grammar: &dyn Grammar, problem: &mut dyn FnMut(String)) -> Vec<(String, ColumnValue)> {
        let mut values = Vec::new();
        for attribute in grammar.attributes() {
            let name = attribute.name.as_str();
            let given = self.columns.attributes.iter().find(|(_, attribute)| attribute == name);
            let column = given.map_or(name, |(column, _)| column);
            let Some(value) = row.column(column) else { continue };
            match value.to_value(attribute.ty) {
                Some(value) => match refusal(attribute, &value) {
                    Some(why) => problem(format!("its column `{column}` is left out: {why}")),
                    None => values.push((name.to_owned(), ColumnValue::of_value(&value))),
                },
                None => {
                    let value = plain(&value.to_string(), MOST_SHOWN);
                    problem(format!("its column `{column}` is left out: `{value}` is not {}", attribute.ty));
                }
            }
        }
        values
    }

    /// The lowest height of the ground below the corners, and its rise to the highest one.
    fn ground(&self, outline: &Outline, place: &[Corner], problem: &mut dyn FnMut(String)) -> (f64, f64) {
        let Some(terrain) = &self.terrain else { return (outline.height.unwrap_or_default(), 0.0) };
        let heights: Vec<f64> = place.iter().filter_map(|corner| terrain.height(*corner)).collect();
        if heights.len() < place.len() {
            problem("the terrain has no height below all of its corners".to_owned());
        }
        let low = heights.iter().copied().reduce(f64::min);
        let high = heights.iter().copied().reduce(f64::max);
        match (low, high) {
            (Some(low), Some(high)) => (low, high - low),
            _ => (outline.height.unwrap_or_default(), 0.0),
        }
    }
}

/// The reason why an attribute refuses a number or a text. Runs check lists, and choices that are the value of another attribute.
fn refusal(attribute: &Attribute, value: &Value) -> Option<String> {
    let shown = || plain(&value.to_string(), MOST_SHOWN);
    if let (Value::Float(number), Some(range)) = (value, &attribute.range)
        && range.restricted
        && !range.contains(*number)
    {
        return Some(format!("`{}` is not from {} to {}", shown(), range.min, range.max));
    }
    let choices = attribute.choices.as_ref().filter(|choices| choices.restricted)?;
    let known: Vec<Value> = match (&choices.values, value) {
        (ChoiceValues::Floats(list), Value::Float(_)) => list.iter().map(|number| Value::Float(*number)).collect(),
        (ChoiceValues::Texts(list), Value::Text(_)) => list.iter().map(|text| Value::Text(text.clone())).collect(),
        _ => return None,
    };
    let names = || known.iter().map(Value::to_string).collect::<Vec<_>>().join(", ");
    (!known.contains(value)).then(|| format!("`{}` is not one of {}", shown(), names()))
}

/// The seed of a polygon of a row.
fn seed(id: &str, part: usize, rings: &[Vec<Corner>]) -> u64 {
    let mut hasher = blake3::Hasher::new();
    if id.is_empty() {
        for number in rings.iter().flatten().flatten() {
            hasher.update(&number.to_le_bytes());
        }
    } else {
        hasher.update(id.as_bytes()).update(&(part as u64).to_le_bytes());
    }
    let [a, b, c, d, e, f, g, h, ..] = *hasher.finalize().as_bytes();
    u64::from_le_bytes([a, b, c, d, e, f, g, h])
}

#[cfg(test)]
mod tests;
