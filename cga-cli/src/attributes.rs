//! Lists attributes and start rules.

use std::fmt::Write as _;

use cga::{Attribute, Grammar, RuleFile, Text, Value};

use crate::Status;
use crate::options::AttributeOptions;
use crate::run::load;
use crate::stream::{print, say, visible};

pub(crate) fn command(options: &AttributeOptions) -> Status {
    match load(&options.rules, &mut |_| Ok(false)) {
        Ok(rules) => {
            let text = if options.json { rules.attributes_json() + "\n" } else { visible(&table(&rules)).into_owned() };
            print(&text).map_or_else(
                |why| {
                    say(why);
                    Status::Unusable
                },
                |()| Status::Success,
            )
        }
        Err(problem) => {
            say(problem.message);
            problem.status
        }
    }
}

/// The start rules and the attributes, a line each, by groups.
fn table(rules: &RuleFile) -> String {
    let mut out = String::new();
    let starts: Vec<&str> =
        rules.start_rules().iter().filter(|rule| !rule.hidden).map(|rule| rule.name.as_str()).collect();
    let starts = match (starts.is_empty(), rules.start_rules().is_empty()) {
        (false, _) => starts.join(", "),
        (true, true) => "none; write a rule without parameters".to_owned(),
        (true, false) => "all are hidden".to_owned(),
    };
    let _ = writeln!(out, "start rules: {starts}");
    let shown: Vec<&Attribute> = rules.attributes().iter().filter(|attribute| !attribute.hidden).collect();
    let width = shown.iter().map(|attribute| attribute.name.chars().count()).max().unwrap_or_default();
    let mut group = "".to_owned();
    for attribute in shown {
        let own = attribute.group.join(" / ");
        if own != group {
            let _ = writeln!(out, "\n{own}");
            group = own;
        }
        let _ = writeln!(out, "  {:width$}  {}", attribute.name.as_str(), described(rules, attribute));
    }
    out
}

/// The default, the allowed values and the meaning of an attribute.
fn described(rules: &RuleFile, attribute: &Attribute) -> String {
    let mut parts = vec![match &attribute.default {
        Some(value) => written(value),
        None => format!("({}, computed for each lot)", attribute.ty),
    }];
    if let Some(range) = attribute.range {
        parts.push(format!("{} to {}", range.min, range.max));
    }
    if let Some(values) = attribute.choices.as_ref().and_then(|choices| choices.of(rules)) {
        let values: Vec<String> = values.iter().map(ToString::to_string).collect();
        parts.push(format!("one of {}", values.join(", ")));
    }
    if !attribute.about.is_empty() {
        parts.push(attribute.about.replace('\n', " "));
    }
    parts.join("; ")
}

/// A value as `--set` takes it.
fn written(value: &Value) -> String {
    fn rows<T>(entries: &[T], columns: usize, entry: impl Fn(&T) -> String) -> String {
        let rows = entries.chunks(columns.max(1));
        let rows: Vec<String> = rows.map(|row| row.iter().map(&entry).collect::<Vec<_>>().join(", ")).collect();
        format!("[{}]", rows.join("; "))
    }
    let quoted = |text: &Text| format!("\"{}\"", text.as_str().replace('\\', "\\\\").replace('"', "\\\""));
    match value {
        Value::Floats(array) => rows(array.as_slice(), array.columns(), |number| Value::Float(*number).to_string()),
        Value::Bools(array) => rows(array.as_slice(), array.columns(), ToString::to_string),
        Value::Texts(array) => rows(array.as_slice(), array.columns(), quoted),
        value => value.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_written_as_they_are_set() {
        let rules = "
            attr sizes = [1, 2.5; 3, 4]  attr lit = [true, false]  attr names = [\"a \\\"b\\\"\", \"c,;d\\\\\"]
            attr name = \"it's\"  Lot --> print(size(sizes) + size(lit) + size(names) + name) X.
        ";
        let rules = RuleFile::from_text(rules).expect("good rules");
        for attribute in rules.attributes() {
            let value = attribute.default.clone().expect("a value");
            let text = written(&value);
            assert_eq!(Value::parse(&text, attribute.ty), Some(value), "{}: {text}", attribute.name);
        }
        assert_eq!(written(&Value::Floats(cga::Array::default())), "[]");
        assert_eq!(written(rules.attributes()[0].default.as_ref().expect("a value")), "[1, 2.5; 3, 4]");
    }

    #[test]
    fn attributes_have_their_default_range_choices_and_meaning() {
        let rules = "
            /// In metres.
            @Group(\"Size\") @Range(3, 60) attr height = 12
            @Enum(\"brick\", \"stone\") attr wall = \"brick\"
            attr storeys = rint(scope.sx / 3)
            @Hidden attr secret = 1
            @StartRule Lot --> extrude(height * storeys) color(case wall == \"brick\" : \"#aa5544\" else : \"#cccccc\") X.
        ";
        let rules = RuleFile::from_text(rules).expect("good rules");
        let expected = "start rules: Lot\n\nSize\n  height   12; 3 to 60; In metres.\n  wall     brick; one of brick, stone\n  \
                        storeys  (a number, computed for each lot)\n";
        assert_eq!(table(&rules), expected);
        let line =
            |rules: &str| table(&RuleFile::from_text(rules).expect("good rules")).lines().next().map(str::to_owned);
        assert_eq!(line("@Hidden Lot --> X.").as_deref(), Some("start rules: all are hidden"));
        assert_eq!(line("@Hidden Lot --> X.  Other --> X.").as_deref(), Some("start rules: Other"));
        assert_eq!(line("Lot(n) --> X.").as_deref(), Some("start rules: none; write a rule without parameters"));
    }
}
