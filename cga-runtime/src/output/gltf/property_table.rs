//! Property tables of `EXT_structural_metadata`: a row for each rule or each building, and a column for each property.

use std::collections::{HashMap, HashSet};
use std::fmt::Write as _;

use super::json::{self, joined, quoted};
use crate::geometry::small_sort::sort_owned_by;
use crate::output::number_text::Short;
use crate::run::building::Building;
use crate::value::Value;
use crate::value::array::{Array, Element};
use crate::value::text::Text;

/// A table.
pub(super) struct PropertyTable {
    /// The name of the class of its rows.
    class: &'static str,
    rows: usize,
    columns: Vec<Column>,
}

/// The values of one property in all rows.
struct Column {
    /// The name in the schema: letters, digits and underscores.
    id: String,
    /// The name in the program, if it differs.
    name: Option<String>,
    /// The type, as members of the property in the schema.
    ty: &'static str,
    /// The value that stands for none; without it every row has a value.
    no_data: Option<String>,
    values: Vec<u8>,
    /// The number of elements before each row and after the last one.
    array_offsets: Option<Vec<u32>>,
    /// The number of bytes before each text and after the last one.
    string_offsets: Option<Vec<u32>>,
}

/// The numbers of rows of the property tables, as far as the file has them. The table of the rules comes first.
#[derive(Debug, Default)]
pub(super) struct Tables {
    pub(super) rules: Option<usize>,
    pub(super) buildings: Option<usize>,
}

impl Tables {
    /// The number of the table of the buildings.
    pub(super) fn of_buildings(&self) -> usize {
        usize::from(self.rules.is_some())
    }
}

const STRING: &str = "\"type\":\"STRING\"";
const BOOLEAN: &str = "\"type\":\"BOOLEAN\"";
const FLOAT64: &str = "\"type\":\"SCALAR\",\"componentType\":\"FLOAT64\"";
const UINT64: &str = "\"type\":\"SCALAR\",\"componentType\":\"UINT64\"";
const STRINGS: &str = "\"type\":\"STRING\",\"array\":true";
const BOOLEANS: &str = "\"type\":\"BOOLEAN\",\"array\":true";
const FLOATS64: &str = "\"type\":\"SCALAR\",\"componentType\":\"FLOAT64\",\"array\":true";

impl PropertyTable {
    /// A table with the name of each rule.
    pub(super) fn of_rules(rules: &[Text]) -> Self {
        PropertyTable {
            class: "rule",
            rows: rules.len(),
            columns: vec![Column::texts("name", &rules.iter().map(Text::as_str).collect::<Vec<_>>(), None)],
        }
    }

    /// A table with the name, the grammar, the seed, the attributes and the reports of each building.
    pub(super) fn of_buildings(buildings: &[Building]) -> Self {
        let names: Vec<&str> = buildings.iter().map(|building| building.name.as_str()).collect();
        let grammars: Vec<&str> = buildings.iter().map(|building| building.grammar.as_str()).collect();
        let seeds = buildings.iter().flat_map(|building| building.seed.to_le_bytes()).collect();
        let mut columns = vec![
            Column::texts("name", &names, None),
            Column::texts("grammar", &grammars, None),
            Column { values: seeds, ..Column::new("seed", UINT64) },
        ];
        let [(attributes, more_attributes), (reports, more_reports)] = [attributes(buildings), reports(buildings)];
        for (name, values) in attributes.iter().chain(&reports) {
            columns.push(Column::of_values(name, values));
        }
        for (name, rows) in [("more attributes", more_attributes), ("more reports", more_reports)] {
            if rows.iter().any(|row| !row.is_empty()) {
                let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
                columns.push(Column::texts(name, &rows, Some(quoted(""))));
            }
        }
        let mut taken = HashSet::new();
        for column in &mut columns {
            let plain = identifier(&column.id);
            let more = (2..).map(|number: u32| format!("{plain}_{number}"));
            let free = std::iter::once(plain.clone()).chain(more).find(|id| !taken.contains(id)).unwrap_or_default();
            let name = std::mem::replace(&mut column.id, free);
            column.name = Some(name).filter(|name| *name != column.id && !name.is_empty());
            taken.insert(column.id.clone());
        }
        PropertyTable { class: "building", rows: buildings.len(), columns }
    }

    /// The class of the rows, as a member of the schema.
    fn class(&self) -> String {
        let columns = self.columns.iter().map(|Column { id, name, ty, no_data, .. }| {
            let name = name.as_ref().map_or(String::new(), |name| format!("\"name\":{},", quoted(name)));
            let rest = no_data.as_ref().map_or("\"required\":true".to_owned(), |value| format!("\"noData\":{value}"));
            format!("\"{id}\":{{{name}{ty},{rest}}}")
        });
        format!("\"{}\":{{\"properties\":{{{}}}}}", self.class, joined(columns))
    }

    /// The table; `view` stores bytes in the file and returns the number of their view.
    fn table(self, view: &mut impl FnMut(Vec<u8>) -> usize) -> String {
        let columns: Vec<String> = self.columns.into_iter().map(|column| column.property(view)).collect();
        format!("{{\"class\":\"{}\",\"count\":{},\"properties\":{{{}}}}}", self.class, self.rows, columns.join(","))
    }
}

/// The extension with all tables, as a member of `extensions`.
pub(super) fn extension(tables: Vec<PropertyTable>, mut view: impl FnMut(Vec<u8>) -> usize) -> String {
    let classes = joined(tables.iter().map(PropertyTable::class));
    let tables: Vec<String> = tables.into_iter().map(|table| table.table(&mut view)).collect();
    let mut json = format!("\"EXT_structural_metadata\":{{\"schema\":{{\"id\":\"cga\",\"classes\":{{{classes}}}}},");
    let _ = write!(json, "\"propertyTables\":[{}]}}", tables.join(","));
    json
}

/// The values of a name in each row.
type Row = Vec<Option<Value>>;

/// The largest number of names with a column of their own, so that a file with other names in each row stays in proportion to its values.
const MOST_COLUMNS: usize = 256;

/// The first names, in the order of their first row, each with its values, and for each row a JSON object with the values of all other
/// names; empty without any.
type Columns<'a> = (Vec<(&'a str, Row)>, Vec<String>);

fn by_name<'a>(rows: usize, cells: impl Iterator<Item = (usize, &'a str, Value)>) -> Columns<'a> {
    let mut columns: Vec<(&str, Row)> = Vec::new();
    let mut more: Vec<Vec<String>> = vec![Vec::new(); rows];
    // Only for look-ups, never iterated.
    let mut known: HashMap<&str, usize> = HashMap::new();
    for (row, name, value) in cells {
        match known.get(name) {
            Some(&column) => columns[column].1[row] = Some(value),
            None if columns.len() < MOST_COLUMNS => {
                known.insert(name, columns.len());
                columns.push((name, vec![None; rows]));
                columns[known.len() - 1].1[row] = Some(value);
            }
            None => more[row].push(format!("{}:{}", quoted(name), json::value(&value))),
        }
    }
    let object = |members: Vec<String>| match members.len() {
        0 => String::new(),
        _ => format!("{{{}}}", members.join(",")),
    };
    (columns, more.into_iter().map(object).collect())
}

fn attributes(buildings: &[Building]) -> Columns<'_> {
    let cells = buildings.iter().enumerate().flat_map(|(row, building)| {
        building.attributes.iter().map(move |(name, value)| (row, name.as_str(), value.clone()))
    });
    by_name(buildings.len(), cells)
}

fn reports(buildings: &[Building]) -> Columns<'_> {
    let cells = buildings
        .iter()
        .enumerate()
        .flat_map(|(row, building)| building.report_values().into_iter().map(move |(key, value)| (row, key, value)));
    let (mut columns, more) = by_name(buildings.len(), cells);
    sort_owned_by(&mut columns, |a, b| a.0.cmp(b.0));
    (columns, more)
}

impl Column {
    fn new(id: &str, ty: &'static str) -> Self {
        let (name, no_data, values) = (None, None, Vec::new());
        Column { id: id.to_owned(), name, ty, no_data, values, array_offsets: None, string_offsets: None }
    }

    fn texts(id: &str, texts: &[&str], no_data: Option<String>) -> Self {
        let mut column = Column { no_data, ..Column::new(id, STRING) };
        column.string_offsets = Some(offsets(texts.iter().map(|text| text.len())));
        column.values = texts.concat().into_bytes();
        column
    }

    /// A column of the type that all values have; of texts if they differ, or if the type has no value that stands for none. For arrays
    /// that is the empty array.
    fn of_values(id: &str, values: &[Option<Value>]) -> Self {
        Column::of_type(id, values).unwrap_or_else(|| {
            let texts: Vec<Option<String>> = values.iter().map(|value| Some(value.as_ref()?.to_string())).collect();
            let is_free = |text: &&str| !texts.iter().flatten().any(|known| known == text);
            let numbered = (1..).map(|number: u32| format!("none {number}"));
            let mut marks = ["", "none"].map(str::to_owned).into_iter().chain(numbered);
            let none = &marks.find(|mark| is_free(&mark.as_str())).unwrap_or_default();
            let no_data = texts.contains(&None).then(|| quoted(none));
            let texts: Vec<&str> = texts.iter().map(|text| text.as_deref().unwrap_or(none)).collect();
            Column::texts(id, &texts, no_data)
        })
    }

    fn of_type(id: &str, values: &[Option<Value>]) -> Option<Self> {
        match values.iter().flatten().next()? {
            Value::Float(_) => {
                let numbers = values.iter().map(|value| match value {
                    Some(Value::Float(number)) => Some(Some(*number).filter(|number| number.is_finite())),
                    Some(_) => None,
                    None => Some(None),
                });
                let numbers = numbers.collect::<Option<Vec<Option<f64>>>>()?;
                let is_free = |none: &f64| !numbers.contains(&Some(*none));
                let none = [-9999.0, -99_999_999.0, f64::MIN].into_iter().find(is_free)?;
                let no_data = numbers.contains(&None).then(|| Short(none).to_string());
                let values = numbers.into_iter().flat_map(|number| number.unwrap_or(none).to_le_bytes()).collect();
                Some(Column { no_data, values, ..Column::new(id, FLOAT64) })
            }
            Value::Bool(_) => {
                let truths = all(values, |value| if let Value::Bool(truth) = value { Some(*truth) } else { None })?;
                Some(Column { values: bits(&truths), ..Column::new(id, BOOLEAN) })
            }
            Value::Floats(_) => {
                let (numbers, array_offsets) = arrays(values, as_floats)?;
                numbers.iter().all(|number| number.is_finite()).then(|| {
                    let values = numbers.into_iter().flat_map(f64::to_le_bytes).collect();
                    Column { values, array_offsets, ..Column::new(id, FLOATS64) }
                })
            }
            Value::Bools(_) => {
                let (truths, array_offsets) = arrays(values, as_bools)?;
                Some(Column { values: bits(&truths), array_offsets, ..Column::new(id, BOOLEANS) })
            }
            Value::Texts(_) => {
                let (texts, array_offsets) = arrays(values, as_texts)?;
                let texts: Vec<&str> = texts.iter().map(Text::as_str).collect();
                Some(Column { ty: STRINGS, array_offsets, ..Column::texts(id, &texts, None) })
            }
            Value::Text(_) => None,
        }
    }

    /// The property of the table; `view` stores bytes in the file and returns the number of their view.
    fn property(self, view: &mut impl FnMut(Vec<u8>) -> usize) -> String {
        // A view has at least one byte.
        let mut store = |mut bytes: Vec<u8>| {
            if bytes.is_empty() {
                bytes.push(0);
            }
            view(bytes)
        };
        let mut json = format!("\"{}\":{{\"values\":{}", self.id, store(self.values));
        for (name, offsets) in [("arrayOffsets", self.array_offsets), ("stringOffsets", self.string_offsets)] {
            if let Some(offsets) = offsets {
                let bytes = offsets.into_iter().flat_map(u32::to_le_bytes).collect();
                let _ = write!(json, ",\"{name}\":{}", store(bytes));
            }
        }
        json.push('}');
        json
    }
}

fn as_floats(value: &Value) -> Option<&Array<f64>> {
    if let Value::Floats(array) = value { Some(array) } else { None }
}

fn as_bools(value: &Value) -> Option<&Array<bool>> {
    if let Value::Bools(array) = value { Some(array) } else { None }
}

fn as_texts(value: &Value) -> Option<&Array<Text>> {
    if let Value::Texts(array) = value { Some(array) } else { None }
}

/// The elements of all arrays, if these have the type, and the offsets of the rows. A row without an array has no elements.
type Elements<T> = (Vec<T>, Option<Vec<u32>>);

fn arrays<'a, T: Element>(
    values: &'a [Option<Value>],
    of_type: impl Fn(&'a Value) -> Option<&'a Array<T>>,
) -> Option<Elements<T>> {
    let rows =
        values.iter().map(|value| value.as_ref().map_or(Some(&[][..]), |value| Some(of_type(value)?.as_slice())));
    let rows = rows.collect::<Option<Vec<&[T]>>>()?;
    Some((rows.concat(), Some(offsets(rows.iter().map(|row| row.len())))))
}

/// The values, if all are there and have the type.
fn all<'a, T>(values: &'a [Option<Value>], of_type: impl Fn(&'a Value) -> Option<T>) -> Option<Vec<T>> {
    values.iter().map(|value| of_type(value.as_ref()?)).collect()
}

/// The sums of the lengths before each item, and of all.
fn offsets(lengths: impl Iterator<Item = usize>) -> Vec<u32> {
    let sums = lengths.scan(0, |sum: &mut usize, length| {
        *sum += length;
        Some(*sum as u32)
    });
    std::iter::once(0).chain(sums).collect()
}

/// Truth values as bits, the lowest first.
fn bits(truths: &[bool]) -> Vec<u8> {
    let byte = |truths: &[bool]| truths.iter().rev().fold(0, |byte, truth| byte << 1 | u8::from(*truth));
    truths.chunks(8).map(byte).collect()
}

/// A name as an identifier of the schema.
fn identifier(name: &str) -> String {
    let mut id: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if !id.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        id.insert(0, '_');
    }
    id
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(values: &[Option<Value>]) -> (String, Vec<u8>) {
        let column = Column::of_values("x", values);
        let none = column.no_data.map_or(String::new(), |none| format!(" none {none}"));
        (format!("{}{none}", column.ty), column.values)
    }

    #[test]
    fn columns_have_the_type_of_their_values() {
        let numbers = [Some(Value::Float(1.5)), Some(Value::Float(-2.0))];
        assert_eq!(column(&numbers), (FLOAT64.to_owned(), [1.5_f64, -2.0].map(f64::to_le_bytes).concat()));
        let truths: Vec<Option<Value>> = (0..10).map(|i| Some(Value::Bool(i % 3 == 0))).collect();
        assert_eq!(column(&truths), (BOOLEAN.to_owned(), vec![0b0100_1001, 0b10]));
        let texts = [Some(Value::from("ä")), Some(Value::from(""))];
        assert_eq!(column(&texts), (STRING.to_owned(), "ä".as_bytes().to_vec()));
    }

    #[test]
    fn missing_values_have_a_mark_that_is_no_value() {
        let numbers = [Some(Value::Float(-9999.0)), None, Some(Value::Float(f64::NAN))];
        let bytes = [-9999.0_f64, -99_999_999.0, -99_999_999.0].map(f64::to_le_bytes).concat();
        assert_eq!(column(&numbers), (format!("{FLOAT64} none -99999999"), bytes));
        let truths = [Some(Value::Bool(true)), None];
        assert_eq!(column(&truths), (format!("{STRING} none \"\""), b"true".to_vec()));
        let texts = [Some(Value::from("")), None];
        assert_eq!(column(&texts), (format!("{STRING} none \"none\""), b"none".to_vec()));
        // Types that differ are texts.
        assert_eq!(column(&[Some(Value::Float(1.0)), Some(Value::from("a"))]), (STRING.to_owned(), b"1a".to_vec()));
    }

    #[test]
    fn arrays_have_the_offsets_of_their_rows() {
        let floats =
            [Array::from([1.0, 2.0]), Array::from([]), Array::from([3.0])].map(|array| Some(Value::Floats(array)));
        let made = Column::of_values("x", &floats);
        assert_eq!((made.ty, made.array_offsets), (FLOATS64, Some(vec![0, 2, 2, 3])));
        let texts = [Array::from(["a", "bc"].map(Text::from)), Array::from([Text::from("")])]
            .map(|array| Some(Value::Texts(array)));
        let made = Column::of_values("x", &texts);
        assert_eq!(
            (made.ty, made.array_offsets, made.string_offsets),
            (STRINGS, Some(vec![0, 2, 3]), Some(vec![0, 1, 3, 3]))
        );
        let endless = [Some(Value::Floats(Array::from([f64::INFINITY])))];
        assert_eq!(Column::of_values("x", &endless).ty, STRING);
    }

    #[test]
    fn names_are_identifiers_and_differ() {
        let building = Building {
            attributes: vec![
                ("name".into(), Value::from("a")),
                ("imp.height".into(), Value::Float(1.0)),
                ("imp_height".into(), Value::Float(2.0)),
                ("9".into(), Value::Bool(true)),
            ],
            ..Building::new("b", 1)
        };
        let table = PropertyTable::of_buildings(&[building, Building::default()]);
        let ids: Vec<(&str, Option<&str>)> =
            table.columns.iter().map(|column| (column.id.as_str(), column.name.as_deref())).collect();
        let expected = [
            ("name", None),
            ("grammar", None),
            ("seed", None),
            ("name_2", Some("name")),
            ("imp_height", Some("imp.height")),
            ("imp_height_2", Some("imp_height")),
            ("_9", Some("9")),
        ];
        assert_eq!(ids, expected);
    }
}
