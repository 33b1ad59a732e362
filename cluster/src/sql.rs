//! Texts and names in SQL.

use datafusion::arrow::datatypes::{DataType, Field};

/// A text.
pub(crate) fn literal(text: &str) -> String {
    format!("'{}'", text.replace('\'', "''"))
}

/// The name of a column.
pub(crate) fn name(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

/// The columns of a field in SQL, each with its name in rules: members of a group have names with dots.
pub(crate) fn columns_of(field: &Field) -> Vec<(String, String)> {
    fn add(found: &mut Vec<(String, String)>, name: String, column: String, field: &Field) {
        let DataType::Struct(members) = field.data_type() else { return found.push((name, column)) };
        for member in members {
            let own = member.name();
            add(found, format!("{name}.{own}"), format!("{column}[{}]", literal(own)), member);
        }
    }
    let (mut found, name) = (Vec::new(), field.name());
    add(&mut found, name.clone(), self::name(name), field);
    found
}
