//! The columns of all files of lots. Files may have other columns than each other, and other types.

use std::collections::HashMap;
use std::sync::Arc;

use cga_geo::reader::arrow::is_binary;
use datafusion::arrow::datatypes::{DataType, Field, Fields, Schema, SchemaRef};

/// A column of the files so far.
struct Column {
    /// Its type, `None` if it has different ones.
    kind: Option<DataType>,
    /// The first file that has it, and its type there.
    first: (String, DataType),
    /// The first file with another type, and that type.
    other: Option<(String, DataType)>,
}

/// The columns of all files, in the order of the files.
#[derive(Default)]
pub(crate) struct FileColumns {
    names: Vec<String>,
    columns: HashMap<String, Column>,
}

impl FileColumns {
    /// Adds the columns of a file.
    pub(crate) fn add(&mut self, file: &str, schema: &Schema) {
        for field in schema.fields() {
            let (name, kind) = (field.name(), field.data_type());
            let Some(column) = self.columns.get_mut(name) else {
                let first = (file.to_owned(), kind.clone());
                self.names.push(name.clone());
                self.columns.insert(name.clone(), Column { kind: common(kind, kind), first, other: None });
                continue;
            };
            let Some(own) = &column.kind else { continue };
            let both = common(own, kind);
            if both.is_none() {
                column.other = Some((file.to_owned(), kind.clone()));
            } else if column.first.1 == DataType::Null {
                column.first = (file.to_owned(), kind.clone());
            }
            column.kind = both;
        }
    }

    /// The columns with a type for all files.
    pub(crate) fn schema(&self) -> SchemaRef {
        let kind = |name: &String| self.columns.get(name)?.kind.clone();
        let fields = self.names.iter().filter_map(|name| Some(Field::new(name, kind(name)?, true)));
        Arc::new(Schema::new(fields.collect::<Fields>()))
    }

    /// Checks that a column has a type for all files. The members of a group have names with dots.
    ///
    /// # Errors
    /// A sentence with the two files that differ.
    pub(crate) fn check(&self, name: &str) -> Result<(), String> {
        let outer = name.split_once('.').map_or(name, |(outer, _)| outer);
        let found = self.columns.get(name).map(|column| (name, column));
        let found = found.or_else(|| Some((outer, self.columns.get(outer)?)));
        let Some((name, Column { first, other: Some(other), .. })) = found else { return Ok(()) };
        Err(format!(
            "the column `{name}` of `{}` is {}, and the one of `{}` is {}; write one type",
            first.0, first.1, other.0, other.1
        ))
    }
}

/// A type that has the values of two types as rules read them; `None` if there are texts in one file and numbers in another one, for example.
fn common(one: &DataType, other: &DataType) -> Option<DataType> {
    let is_number = |kind: &DataType| kind.is_integer() || matches!(kind, DataType::Float32 | DataType::Float64);
    let is_text = |kind: &DataType| match kind {
        DataType::Dictionary(_, values) => matches!(**values, DataType::Utf8 | DataType::LargeUtf8),
        kind => matches!(kind, DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View),
    };
    match (one, other) {
        (DataType::Struct(own), DataType::Struct(others)) => {
            let names = |fields: &Fields| fields.iter().map(|field| field.name().clone()).collect::<Vec<_>>();
            // Other members in the same group are rare, and DataFusion reads groups by the order of their members.
            let member = |(own, other): (&Arc<Field>, &Arc<Field>)| {
                Some(Field::new(own.name(), common(own.data_type(), other.data_type())?, true))
            };
            let members = (names(own) == names(others)).then(|| own.iter().zip(others).map(member));
            Some(DataType::Struct(members?.collect::<Option<Fields>>()?))
        }
        _ if one == other => Some(one.clone()),
        (DataType::Null, kind) | (kind, DataType::Null) => Some(kind.clone()),
        // Rules read all numbers as 64-bit floats.
        _ if is_number(one) && is_number(other) => Some(DataType::Float64),
        _ if is_text(one) && is_text(other) => Some(DataType::Utf8),
        _ if is_binary(one) && is_binary(other) => Some(DataType::LargeBinary),
        _ => None,
    }
}
