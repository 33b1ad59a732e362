//! Lists attributes and start rules.

use std::fmt::Write as _;

use cga::{Attribute, Grammar, RuleFile};

use crate::Status;
use crate::options::AttributeOptions;
use crate::run::load;
use crate::stream::{print, say};

pub(crate) fn command(options: &AttributeOptions) -> Status {
    match load(&options.rules, &mut |_| Ok(false)) {
        Ok(rules) => {
            let text = if options.json { rules.attributes_json() + "\n" } else { table(&rules) };
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
    let _ = writeln!(out, "start rules: {}", starts.join(", "));
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
        Some(value) => value.to_string(),
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

#[cfg(test)]
mod tests {
    use super::*;

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
    }
}
