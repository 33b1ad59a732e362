//! Reports as a table: a row for each collection, and one for each group after its members.

use std::collections::BTreeMap;
use std::fmt;

use super::{Collection, Reports, Summary};
use crate::geometry::small_sort::SmallSort;
use crate::value::number::Number;

/// The number of nested groups that are shown. Keys may have any number of dots.
const LEVELS: usize = 8;

/// The titles of the columns.
const HEAD: [&str; 9] = ["Report", "N", "%", "Sum", "%", "Avg", "Min", "Max", "NaNs"];

type TableRow = [String; HEAD.len()];

/// The groups that a key is in, from the outermost.
fn groups(key: &str) -> impl Iterator<Item = &str> {
    key.match_indices('.').take(LEVELS).map(move |(at, _)| &key[..at])
}

/// Writes the columns in the picture of the *report operation*: number, sum, both also as shares of the group,
/// average, extremes, and the number of NaN. Cells that have no meaning for text are blank.
impl fmt::Display for Reports {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows = self.rows();
        let mut widths = HEAD.map(|title| title.chars().count());
        for row in &rows {
            widths.iter_mut().zip(row).for_each(|(width, cell)| *width = cell.chars().count().max(*width));
        }
        let mut write = |cells: &[&str]| {
            let mut line = format!("{:<width$}", cells[0], width = widths[0]);
            for (cell, width) in cells.iter().zip(widths).skip(1) {
                line += &format!("  {cell:>width$}");
            }
            writeln!(f, "{}", line.trim_end())
        };
        write(&HEAD)?;
        rows.iter().try_for_each(|row| write(&row.each_ref().map(String::as_str)))
    }
}

impl Reports {
    fn rows(&self) -> Vec<TableRow> {
        let mut sums: BTreeMap<&str, Summary> = BTreeMap::new();
        for collection in self.iter() {
            groups(collection.key()).for_each(|group| sums.entry(group).or_default().merge(&collection.summary));
        }
        // A collection with the name of a group belongs to the group.
        for collection in self.iter() {
            if let Some(sum) = sums.get_mut(collection.key()) {
                sum.merge(&collection.summary);
            }
        }
        let mut collections: Vec<&Collection> = self.iter().collect();
        collections.small_sort_by(|a, b| a.key().split('.').cmp(b.key().split('.')));
        let mut rows = Vec::new();
        let mut open: Vec<&str> = Vec::new();
        let close = |rows: &mut Vec<TableRow>, group: &str| {
            let sum = sums.get(group).copied().unwrap_or_default();
            let outer = groups(group).last().and_then(|outer| sums.get(outer)).copied().unwrap_or(sum);
            let name = if self.get(group).is_some() { format!("{group}.*") } else { group.to_owned() };
            rows.push(row(name, &sum, Some(&outer)));
        };
        for collection in collections {
            let key = collection.key();
            let mut own: Vec<&str> = groups(key).collect();
            own.extend(sums.get_key_value(key).map(|(&group, _)| group));
            while let Some(&last) = open.last()
                && !own.contains(&last)
            {
                close(&mut rows, last);
                open.pop();
            }
            rows.push(row(key.to_owned(), &collection.summary, own.last().and_then(|group| sums.get(group))));
            let known = open.len();
            open.extend(&own[known..]);
        }
        open.iter().rev().for_each(|group| close(&mut rows, group));
        rows
    }
}

fn row(name: String, summary: &Summary, group: Option<&Summary>) -> TableRow {
    let number = |value: Option<f64>| value.map_or(String::new(), |value| Number(value).to_string());
    let numbers = summary.numbers != 0;
    let count = share(summary.count as f64, group.map(|group| group.count as f64));
    let sum = share(summary.sum, group.map(|group| group.sum));
    [
        // One line for each row, even if the key has control characters.
        name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect(),
        summary.count.to_string(),
        count,
        number(numbers.then_some(summary.sum)),
        if numbers { sum } else { String::new() },
        number(summary.average()),
        number(summary.min()),
        number(summary.max()),
        summary.nans.to_string(),
    ]
}

/// A percentage with one decimal digit, truncated as in the reference's picture; 0 outside of any group.
fn share(part: f64, whole: Option<f64>) -> String {
    let share = whole.map_or(0.0, |whole| 100.0 * part / whole);
    if share.is_finite() { format!("{:.1}", (share * 10.0).trunc() / 10.0 + 0.0) } else { "0.0".to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::value::Value;
    use crate::value::text::Text;

    fn table(values: impl IntoIterator<Item = (&'static str, Value)>) -> String {
        let mut reports = Reports::default();
        for (key, value) in values {
            assert!(reports.add(Text::fixed(key), value, 100));
        }
        reports.to_string()
    }

    #[test]
    fn the_table_has_shares_inside_of_groups() {
        // *report operation*: the rows of its picture.
        let one = |key, count| std::iter::repeat_n((key, Value::Float(1.0)), count);
        let area = |count| std::iter::repeat_n(("windowarea", Value::Float(21.875)), count);
        let values =
            one("windows.open", 83).chain(one("facades", 8)).chain(one("windows.closed", 142)).chain(area(225));
        assert_eq!(
            table(values),
            "\
Report            N      %       Sum      %     Avg     Min     Max  NaNs
facades           8    0.0         8    0.0       1       1       1     0
windowarea      225    0.0  4921.875    0.0  21.875  21.875  21.875     0
windows.closed  142   63.1       142   63.1       1       1       1     0
windows.open     83   36.8        83   36.8       1       1       1     0
windows         225  100.0       225  100.0       1       1       1     0
"
        );
    }

    #[test]
    fn groups_nest_and_may_have_values_of_their_own() {
        let values = ["a", "a.b.c", "a.b.d", "a-b", "a.b.c", ".", "", "x."].map(|key| (key, Value::Float(2.0)));
        let text = table(values);
        let names: Vec<&str> = text.lines().skip(1).map(|line| line.split("  ").next().unwrap_or("")).collect();
        assert_eq!(names, ["", ".", ".*", "a", "a.b.c", "a.b.d", "a.b", "a.*", "a-b", "x.", "x"]);
        let line = |name: &str| text.lines().find(|line| line.split_whitespace().next() == Some(name)).unwrap();
        assert!(line("a.b.c").contains("66.6") && line("a.b").contains("75.0") && line("a.*").contains("100.0"));
        assert!(line("a.*").split_whitespace().nth(1) == Some("4"));
    }

    #[test]
    fn odd_values_make_no_odd_table() {
        let inf = f64::INFINITY;
        let text = table([
            ("k.a", Value::Float(f64::NAN)),
            ("k.b", Value::Float(inf)),
            ("k.c", Value::Float(-inf)),
            ("k.d", Value::Bool(true)),
            ("k.e\n", Value::from("é")),
        ]);
        assert_eq!(text.lines().count(), 7);
        assert!(text.lines().all(|line| !line.ends_with(' ') && !line.contains("NaN%")), "{text}");
        assert!(table([]).starts_with("Report"));
        let deep = ".".repeat(10_000);
        let mut reports = Reports::default();
        assert!(reports.add(Text::from(deep), 1.0.into(), 10));
        assert_eq!(reports.rows().len(), 1 + LEVELS);
    }
}
