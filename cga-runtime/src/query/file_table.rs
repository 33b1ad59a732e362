//! `readStringTable` and `readFloatTable`.

use super::file::read_text;
use crate::asset::File;
use crate::func::floats_from_texts;
use crate::run::env::Env;
use crate::value::array::Array;
use crate::value::text::Text;

/// `readStringTable(file)`: the cells of a table, with a line for each row (*readTable functions*). The delimiter is
/// the most frequent of comma, semicolon and tab in the first line, otherwise space. Cells may be in double quotes; a
/// quote inside is doubled. Shorter rows are filled with empty text, and empty lines are left out. If the file is
/// missing, an empty array with a fault.
pub fn read_string_table(env: &mut Env, file: File) -> Array<Text> {
    if let Some(known) = env.kept.tables.get(&file) {
        return known.clone();
    }
    let rows = match read_text(env, &file, "csv") {
        Ok(text) => rows(&text),
        Err(why) => {
            env.asset_fault(format!("`{file}` cannot be read: {why}; it gives no table"));
            Vec::new()
        }
    };
    let columns = rows.iter().map(Vec::len).max().unwrap_or_default();
    let bytes = rows.iter().flatten().map(|cell| cell.len()).sum();
    if !(env.may_hold(rows.len().saturating_mul(columns)) && env.may_write(bytes)) {
        return Array::default();
    }
    let table = Array::from(rows);
    env.keep_table(file, &table);
    table
}

/// `readFloatTable(file)`: the cells of a table as numbers (*readTable functions*). Text that is not a number becomes
/// NaN.
pub fn read_float_table(env: &mut Env, file: File) -> Array<f64> {
    let table = read_string_table(env, file);
    floats_from_texts(env, table)
}

/// The cells of a table.
pub(super) fn rows(text: &str) -> Vec<Vec<Text>> {
    let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
    let mut delimiter = (' ', 0);
    for sign in [',', ';', '\t'] {
        let count = outside_of_quotes(first).filter(|c| *c == sign).count();
        if delimiter.1 < count {
            delimiter = (sign, count);
        }
    }
    let delimiter = delimiter.0;
    let (mut rows, mut row, mut cell) = (Vec::new(), Vec::new(), String::new());
    let (mut quoted, mut signs) = (false, text.chars().peekable());
    while let Some(c) = signs.next() {
        match c {
            '"' if quoted && signs.peek() == Some(&'"') => {
                signs.next();
                cell.push('"');
            }
            '"' if quoted || cell.is_empty() => quoted = !quoted,
            '\n' if !quoted => {
                row.push(Text::from(std::mem::take(&mut cell)));
                rows.push(std::mem::take(&mut row));
            }
            c if c == delimiter && !quoted => row.push(Text::from(std::mem::take(&mut cell))),
            c => cell.push(c),
        }
    }
    row.push(Text::from(cell));
    rows.push(row);
    rows.retain(|row| row.iter().any(|cell| !cell.is_empty()));
    rows
}

fn outside_of_quotes(line: &str) -> impl Iterator<Item = char> {
    let mut quoted = false;
    line.chars().filter(move |c| {
        quoted ^= *c == '"';
        !quoted
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::settings::{Limits, Settings};

    fn shown(text: &str) -> Vec<Vec<String>> {
        rows(text).iter().map(|row| row.iter().map(ToString::to_string).collect()).collect()
    }

    #[test]
    fn tables_are_taken_apart() {
        assert_eq!(shown("color.r,1\ncolor.g,0.5\n"), [["color.r", "1"], ["color.g", "0.5"]]);
        assert_eq!(shown("a;b,c\td;e\n1;2;3"), [["a", "b,c\td", "e"], ["1", "2", "3"]]);
        assert_eq!(shown("a b\nc d"), [["a", "b"], ["c", "d"]]);
        assert_eq!(shown("\"a,\"\"b\"\"\";2\n\n\"c\nd\";5\" high\n"), [["a,\"b\"", "2"], ["c\nd", "5\" high"]]);
        assert_eq!(shown("a,b\n,\nc"), [vec!["a", "b"], vec!["c"]]);
        assert_eq!(shown("\n \n"), [[""; 0]; 0]);
        assert_eq!(shown("\"open,\nto the end"), [["open,\nto the end"]]);
    }

    #[test]
    fn a_table_is_rows_and_columns() {
        let folder = std::env::temp_dir().join(format!("cga-table-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        // *readTable functions*, the beginning of its example.
        std::fs::write(folder.join("floors.csv"), "Floor,Height\n0,10,Pomp\r\n1,7\n").expect("a file");
        let assets = std::sync::Arc::new(crate::asset::Assets::below(&folder));
        let settings = crate::run::settings::Settings { assets, ..crate::run::settings::Settings::default() };
        let env = &mut Env::with_names(&settings, &[], &crate::shape::Shape::rectangle(1.0, 1.0), "");
        let table = read_string_table(env, "floors.csv".into());
        assert_eq!((table.rows(), table.columns()), (3, 3));
        assert_eq!(table.at(1, 2).map(Text::as_str), Some("Pomp"));
        let _ = std::fs::remove_dir_all(&folder);
        // Read once a run.
        let numbers = read_float_table(env, "floors.csv".into());
        assert!(numbers.at(0, 0).is_some_and(|number| number.is_nan()) && numbers.at(2, 1) == Some(&7.0));
        assert_eq!(env.take_faults().0.len(), 0);
        assert!(read_string_table(env, "other.csv".into()).is_empty());
        assert_eq!(env.take_faults().0.len(), 1);
    }

    #[test]
    fn the_texts_of_cells_count() {
        let folder = std::env::temp_dir().join(format!("cga-long-cells-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        std::fs::write(folder.join("cells.csv"), format!("a;{}\n", "x".repeat(100_000))).expect("a file");
        let assets = std::sync::Arc::new(crate::asset::Assets::below(&folder));
        let table = |limits| {
            let settings = Settings { assets: assets.clone(), limits, ..Settings::default() };
            let env = &mut Env::with_names(&settings, &[], &crate::shape::Shape::rectangle(1.0, 1.0), "");
            let table = read_string_table(env, "cells.csv".into());
            assert_eq!(table.is_empty(), env.ended());
            env.ended() || !env.is_within_limit(1)
        };
        assert!(!table(Limits::default()));
        assert!(table(Limits { text: 100_000, ..Limits::default() }));
        assert!(table(Limits { bytes: 100_000, ..Limits::default() }));
        let _ = std::fs::remove_dir_all(&folder);
    }
}
