//! Decisions on grammars whose rules are shared by several sites of an import.

use crate::common::parts::Parts;
use cga_lang::ir::plan::{ChangeForm, MaterialChange, RunPlan, SlimChange};
use cga_lang::ir::{Grammar, RuleId};

fn grammar(text: &str) -> Grammar {
    let compiled = Parts::new(text).compile();
    compiled.grammar.unwrap_or_else(|| panic!("{:?}", compiled.diags))
}

fn rule(grammar: &Grammar, name: &str) -> RuleId {
    let number = grammar.rules.iter().position(|rule| rule.name == name);
    RuleId(number.unwrap_or_else(|| panic!("a rule `{name}`")) as u32)
}

#[test]
fn a_shared_rule_has_numbers_for_each_site() {
    let grammar = grammar(
        "import a : \"lib.cga\" (width = 2)\nimport b : \"lib.cga\" (width = 3)\nLot --> a.Wall b.Wall
// file: lib.cga\nattr width = 1\nWall --> case width > 2 : s(width, 1, 1) else : s(1, width, 1)\n",
    );
    let (plan, wall) = (RunPlan::new(&grammar), rule(&grammar, "a.Wall"));
    let names = plan.trails.of(wall).map(|number| plan.trails.names()[number as usize].as_str());
    assert_eq!(names.collect::<Vec<_>>(), ["a.Wall", "b.Wall"]);
    let leaves = plan.leaves.implicit(&grammar.rules[wall.0 as usize]);
    let names = leaves.into_iter().map(|number| plan.leaves.names()[number as usize].as_str());
    assert_eq!(names.collect::<Vec<_>>(), ["a.Wall", "b.Wall"]);
}

#[test]
fn a_material_change_can_depend_on_the_site() {
    let grammar = grammar(
        "import a : \"lib.cga\" (tint = \"#ff0000\")\nimport b : \"lib.cga\" (tint = \"#00ff00\")\nLot --> a.Wall b.Wall
// file: lib.cga\nattr tint = \"#0000ff\"\nWall --> color(tint) X.\n",
    );
    let (plan, wall) = (RunPlan::new(&grammar), rule(&grammar, "a.Wall"));
    let form = plan.change_form(&grammar.rules[wall.0 as usize].body[..1]);
    let change = MaterialChange { steps: 1, sites: 2, ..MaterialChange::default() };
    assert_eq!(form, ChangeForm::Slim(vec![SlimChange::Material(change)]));
}
