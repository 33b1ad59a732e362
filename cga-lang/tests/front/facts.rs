//! Facts of grammars with imports: a call that gives an import values computes its attributes again, on the current shape.

use crate::common::parts::Parts;
use cga_lang::ir::RuleId;
use cga_lang::ir::facts::{Facts, RuleFacts, TemplateNeeds, Uses};

/// The facts of the rule `Lot`.
fn lot(text: &str) -> RuleFacts {
    let compiled = Parts::new(text).compile();
    let Some(grammar) = compiled.grammar else { panic!("{:?}", compiled.diags) };
    let number = grammar.rules.iter().position(|rule| rule.name == "Lot").expect("a rule `Lot`");
    *Facts::new(&grammar).rule(RuleId(number as u32))
}

#[test]
fn a_value_that_is_computed_again_uses_the_shape() {
    let import = |import: &str| {
        let facts = lot(&format!(
            "import lib : \"lib.cga\"\nLot --> lib(height = 2).Wall\n// file: lib.cga\nattr height = 3\n{import}\n"
        ));
        (facts.own, facts.below)
    };
    let wall = "Wall --> extrude(height) X.";
    assert_eq!(import(wall), (Uses::NONE, Uses::STATE));
    assert_eq!(import(&format!("attr a = rand(3)\n{wall}")), (Uses::DRAWS, Uses::DRAWS | Uses::STATE));
    // `height` counts as the copy has it.
    let own = Uses::INDEX | Uses::STATE | Uses::BODY;
    assert_eq!(import(&format!("attr a = split.index + height + geometry.area()\n{wall}")), (own, own));
    let drawn = "const a = rand(3)\nWall --> extrude(a) X.";
    assert_eq!(import(drawn), (Uses::DRAWS, Uses::DRAWS | Uses::STATE));
}

#[test]
fn given_values_are_of_the_current_shape() {
    let facts = lot("import lib : \"lib.cga\"\nLot --> split(x) { ~1 : lib(height = split.index).Wall }
// file: lib.cga\nattr height = 3\nWall --> extrude(height) split(x) { ~split.total : X. }\n");
    assert_eq!((facts.own, facts.below), (Uses::NONE, Uses::STATE));
    let facts = lot("import lib : \"lib.cga\"\nLot --> lib(height = split.index).Wall
// file: lib.cga\nattr height = 3\nWall --> extrude(height) split(x) { ~split.total : X. }\n");
    assert_eq!((facts.own, facts.below), (Uses::INDEX, Uses::INDEX | Uses::TOTAL | Uses::STATE));
}

#[test]
fn a_value_that_is_computed_late_keeps_the_shape() {
    let facts = lot("import lib : \"lib.cga\"\nLot --> lib(height = 2).Wall
// file: lib.cga\nattr height = 3\nattr a = case height > 2 : b else : 1\nattr b = case height > 2 : 1 else : a
Wall --> extrude(a) X.\n");
    assert_eq!(facts.own, Uses::DRAWS | Uses::WHOLE | Uses::STATE);
}

#[test]
fn an_import_without_values_is_as_if_its_rules_were_here() {
    let facts = lot(
        "import lib : \"lib.cga\"\nLot --> lib.Wall\n// file: lib.cga\nattr height = rand(1)\nWall --> extrude(height) X.\n",
    );
    let own_template = Some(TemplateNeeds::default());
    assert_eq!(facts, RuleFacts { rigid: true, is_even: true, own_template, ..RuleFacts::default() });
}
