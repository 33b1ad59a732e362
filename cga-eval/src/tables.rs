//! The data of a grammar that all its runs share: names, start rules, and the table of attributes.

use std::collections::HashSet;

use cga_lang::ir::plan::RunPlan;
use cga_lang::ir::{AttrInfo, ChoiceValues, Choices, Grammar, Presentation, Start};
use cga_runtime::grammar::attribute::{self, Attribute, AttributeKind};
use cga_runtime::rt::{RuleTables, Text, Value};
use cga_runtime::rt_eval::StartEntry;
use cga_runtime::run::start_rule::StartRule;

use crate::object::nothing;

/// The attributes that the host program may set: one for each name, whatever the style. `defaults` has the constant default of each.
pub(crate) fn attributes(grammar: &Grammar, defaults: &[Option<Value>]) -> Vec<Attribute> {
    let mut attributes: Vec<Attribute> = Vec::new();
    let mut names = HashSet::new();
    for global in grammar.globals.iter().filter(|global| global.public) {
        let Some(info) = &global.attr else { continue };
        if !names.insert(&global.name) {
            continue;
        }
        let row = match defaults.get(attributes.len()).cloned().flatten() {
            Some(default) => Attribute::new(global.name.as_str(), default),
            None => Attribute::computed(global.name.as_str(), nothing(global.ty).ty()),
        };
        attributes.push(annotated(row, info, grammar));
    }
    attributes
}

/// The tables of a grammar with a name.
pub(crate) fn tables(grammar: &Grammar, plan: &RunPlan<'_>, name: &str, attributes: &[Attribute]) -> RuleTables {
    let texts = |names: &[String]| names.iter().map(|name| Text::from(name.as_str())).collect();
    let queries = plan.start_queries();
    let entry = |(start, queries): (&Start, &cga_lang::ir::facts::Queries)| StartEntry {
        rule: start.rule.0,
        style: start.style,
        queries: queries.bits(),
    };
    RuleTables {
        name: Text::from(name),
        rules: texts(plan.trails.names()),
        leaves: texts(plan.leaves.names()),
        tags: plan.has_tags(),
        starts: grammar.starts.iter().map(start_rule).collect(),
        entries: grammar.starts.iter().zip(&queries).map(entry).collect(),
        attributes: attributes.iter().map(|attribute| attribute.name.clone()).collect(),
    }
}

fn start_rule(start: &Start) -> StartRule {
    let mut row = StartRule::new(start.name.as_str());
    row.about = Text::from(start.doc.as_str());
    (row.marked, row.hidden) = (start.marked, start.hidden);
    row
}

/// A row with the annotations of the attribute.
fn annotated(mut row: Attribute, info: &AttrInfo, grammar: &Grammar) -> Attribute {
    if let Some(name) = &info.display_name {
        row.display_name = Text::from(name.as_str());
    }
    row.range = info.range.map(|range| attribute::Range::new(range.min, range.max, range.step, range.restricted));
    row.choices = info.choices.as_ref().map(|choices| self::choices(choices, grammar));
    row.kind = kind(&info.presentation);
    row.group = info.group.names.iter().map(|name| Text::from(name.as_str())).collect();
    row.group_order = info.group.order;
    row.about = Text::from(info.doc.as_str());
    row.order = info.order;
    row.hidden = info.hidden;
    row
}

fn choices(choices: &Choices, grammar: &Grammar) -> attribute::Choices {
    let texts = |list: &[String]| list.iter().map(|text| Text::from(text.as_str())).collect();
    let values = match &choices.values {
        ChoiceValues::Floats(list) => attribute::ChoiceValues::Floats(list.clone()),
        ChoiceValues::Texts(list) => attribute::ChoiceValues::Texts(texts(list)),
        ChoiceValues::Attr(id) => attribute::ChoiceValues::Attribute(Text::from(grammar.global(*id).name.as_str())),
    };
    attribute::Choices::new(values, choices.restricted).labels(choices.labels.iter().map(String::as_str))
}

fn kind(presentation: &Presentation) -> AttributeKind {
    match presentation {
        Presentation::Plain => AttributeKind::Plain,
        Presentation::Angle => AttributeKind::Angle,
        Presentation::Percent => AttributeKind::Percent,
        Presentation::Distance => AttributeKind::Distance,
        Presentation::Color => AttributeKind::Color,
        Presentation::File(endings) => {
            AttributeKind::File(endings.iter().map(|ending| Text::from(ending.as_str())).collect())
        }
        Presentation::Directory => AttributeKind::Directory,
        Presentation::MaterialFile => AttributeKind::MaterialFile,
    }
}
