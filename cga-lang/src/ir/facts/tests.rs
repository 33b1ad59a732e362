//! Small grammars and their facts.

use super::*;
use crate::compile::compile_text;
use crate::ir::{Block, BlockParts, Slots, StepKind};

fn grammar(text: &str) -> Grammar {
    let compiled = compile_text(text).compiled;
    compiled.grammar.unwrap_or_else(|| panic!("{text}: {:?}", compiled.diags))
}

/// A line for each rule: its name, its own uses, those below, `rigid`.
fn shown(text: &str) -> Vec<String> {
    let grammar = grammar(text);
    let facts = Facts::new(&grammar);
    let list = |uses: Uses| uses.names().collect::<Vec<_>>().join(" ");
    let line = |(number, rule): (usize, &crate::ir::Rule)| {
        let RuleFacts { own, below, rigid, .. } = *facts.rule(RuleId(number as u32));
        format!("{}: {} | {}{}", rule.name, list(own), list(below), if rigid { " | rigid" } else { "" })
    };
    grammar.rules.iter().enumerate().map(line).collect()
}

/// The slots that a rule begins with.
fn slots(grammar: &Grammar, rule: usize) -> &Slots {
    match &grammar.rules[rule].body[0].kind {
        StepKind::Block(Block { parts: BlockParts::Slots(slots), .. }) => slots,
        other => panic!("{other:?} has no slots"),
    }
}

/// The facts of a rule with these steps.
fn step(text: &str) -> String {
    let line = shown(&format!("A --> {text}")).swap_remove(0);
    line.strip_prefix("A: ").unwrap_or(&line).to_owned()
}

#[test]
fn a_chance_below_a_split_needs_seeds_above_it() {
    let rules = "A --> split(x) { ~1 : B }  B --> C D  C --> 30% : X. else : Y.  D --> Z.";
    assert_eq!(shown(rules), ["A:  | draws", "B:  | draws", "C: draws | draws", "D:  |  | rigid"]);
}

#[test]
fn counters_below_a_split_are_not_those_above_it() {
    let rules = "A --> split(x) { ~1 : B }  B --> [ C ] comp(f) { all : C }  C --> split(y) { split.index : D }
        D --> s(split.total, 1, 1) X.";
    assert_eq!(shown(rules), ["A:  | whole | rigid", "B: whole | index whole", "C: index | index", "D: total | total"]);
}

#[test]
fn arguments_of_parts_read_the_counters_of_the_part() {
    let rules = "A --> split(x) { { ~1 : B(split.index) }* }  B(i) --> s(i, 1, 1) X.";
    assert_eq!(shown(rules), ["A:  |  | rigid", "B:  |  | rigid"]);
    let rules = "A --> comp(f) { all : B(split.index) }  B(i) --> s(i, 1, 1) X.";
    assert_eq!(shown(rules)[0], "A: index whole | index whole");
    let rules = "A --> B(split.total)  B(i) --> s(i, 1, 1) X.";
    assert_eq!(shown(rules)[0], "A: total | total");
    let rules =
        "A --> split(x) { ~1 : B(rand(1)) | ~1 : X. }  B(i) --> split(x) { ~i : C }  C --> s(split.index, 1, 1)";
    let grammar = grammar(rules);
    let facts = Facts::new(&grammar);
    let split = slots(&grammar, 0);
    assert_eq!(facts.target(&split.targets[0]), Uses::DRAWS);
    assert_eq!(facts.target(&split.targets[1]), Uses::NONE);
    let split = slots(&grammar, 1);
    assert_eq!(facts.target(&split.targets[0]), Uses::INDEX);
}

#[test]
fn rules_of_a_cycle_share_what_they_reach() {
    let rules = "A --> B  B --> case scope.sx > 1 : split(x) { 1 : C | ~1 : A } else : X.
        C --> report(\"n\", 1) s(split.index, 1, 1) B";
    assert_eq!(
        shown(rules),
        ["A:  | scope reports | rigid", "B: scope | scope reports | rigid", "C: index reports | index scope reports"]
    );
}

#[test]
fn functions_use_what_the_functions_they_call_use() {
    let rules = "f(n) = case n > 0 : g(n - 1) else : 0
        g(n) = f(n) + rand(1)
        h with ( k := split.index ) = k
        A --> s(f(2), 1, 1) X.  B --> s(h, 1, 1) X.  C --> split(x) { h : X. }";
    assert_eq!(shown(rules), ["A: draws says | draws says", "B: index | index", "C: index | index"]);
}

#[test]
fn values_of_the_run_are_not_of_the_shape() {
    let rules = "attr a = rand(1)  attr b = scope.sx  const c = geometry.area()  attr d = 1
        A --> s(a, b, c) set(d, split.index) B  B --> s(d, 1, 1) X.";
    assert_eq!(shown(rules), ["A: index | index state", "B: state | state | rigid"]);
}

#[test]
fn a_lazy_value_is_computed_before_the_first_rule() {
    let rules = "attr a = case b > 1 : b else : rand(1)  attr b = case c > 1 : a else : f  const c = 1
        f = print(scope.sx)
        A --> s(a, 1, 1) X.";
    assert_eq!(shown(rules), ["A:  |  | rigid"]);
}

#[test]
fn steps_use_what_their_rows_say() {
    for (text, expected) in [
        ("s(1, 2, 3)", " |  | rigid"),
        ("s('1, scope.sy, 3)", "scope | scope | rigid"),
        ("t(1, 0, '0.5)", " |  | rigid"),
        ("extrude(3) color(\"#ff0000\")", " |  | rigid"),
        ("center(xy)", " |  | rigid"),
        ("extrude(world.up, 3)", "axes body | axes body"),
        ("r(0, 90, 0)", "body | body | rigid"),
        ("primitiveCube()", "body | body | rigid"),
        ("i(\"a.obj\")", "body | body | rigid"),
        ("report(\"a\", 1)", "reports | reports | rigid"),
        ("print(scope.sx)", "scope says | scope says"),
        ("t(print(1), 0, 0)", "says | says"),
        ("t(case fileExists(\"a\") : 1 else : 2, 0, 0)", "says | says"),
        ("texture(fileRandom(\"*.jpg\"))", "draws says | draws says"),
        ("t(scope.elevation, 0, 0)", "scope place | scope place"),
        ("t(scope.tx, 0, 0)", "whole | whole"),
        ("t(pivot.px, 0, 0)", "whole | whole"),
        ("t(comp.index, 0, 0)", "whole | whole"),
        ("t(geometry.area(), 0, 0)", "body | body | rigid"),
        ("t(geometry.area(front), 0, 0)", "body | body | rigid"),
        ("t(geometry.area(world.up), 0, 0)", "axes body | axes body"),
        ("t(geometry.area(street.front), 0, 0)", "whole | whole"),
        ("t(geometry.angle(azimuth), 0, 0)", "axes body | axes body"),
        ("alignScopeToAxes(y)", "axes body | axes body"),
        ("t(initialShape.origin.px, 0, 0)", "says | says"),
        ("t(seedian, 0, 0)", "draws | draws"),
        ("set(seedian, 3)", "draws | draws"),
        ("set(scope.sx, 3)", " |  | rigid"),
        ("set(scope.tx, 3)", "whole | whole"),
        ("set(material.opacity, 0.5)", " |  | rigid"),
        ("set(material.color.rgb, \"#ff0000\")", " |  | rigid"),
        ("set(material.color.r, 1)", "body | body | rigid"),
        ("set(trim.vertical, false)", "body | body | rigid"),
        ("set(material.opacity, material.opacity * 0.5)", "body | body | rigid"),
        ("t(30% : 1 else : 2, 0, 0)", "draws | draws"),
        ("color(listRandom(\"#ff0000;#00ff00\"))", "draws | draws"),
        ("splitArea(x) { 1 : X. }", "whole | whole"),
        ("t(sum(comp(f) { all : rand(1) }), 0, 0)", "draws whole | draws whole"),
        ("t(size(comp(f) { all : split.index }), 0, 0)", "index whole | index whole"),
    ] {
        assert_eq!(step(text), expected, "{text}");
    }
}

#[test]
fn a_comp_is_rigid_where_its_selectors_are() {
    for (text, expected) in [
        ("comp(f) { front : X. | side = Y. | all : NIL }", "whole | whole | rigid"),
        ("comp(f) { 2 : X. }", "whole | whole | rigid"),
        ("comp(e) { border : X. }", "whole | whole | rigid"),
        ("comp(f) { world.up : X. | side : Y. }", "whole | whole"),
        ("comp(f) { street.front : X. }", "whole | whole"),
        ("comp(f, noAlign) { all : X. }", "whole | whole"),
        ("comp(f) { scope.sx > 1 : X. }", "scope whole | scope whole"),
        ("comp(f) { p(0.5) : X. }", "draws whole | draws whole"),
    ] {
        assert_eq!(step(text), expected, "{text}");
    }
}

#[test]
fn rust_code_may_do_anything() {
    let rules = "A --> crate::arch(2) B  B --> s(crate::noise(scope.sx), 1, 1) C  C --> X.";
    let found = shown(rules);
    assert_eq!(
        found[0],
        "A: draws index total scope place whole state says tags reports | draws index total scope place whole state says tags reports"
    );
    assert_eq!(found[1..], ["B: scope says | scope says", "C:  |  | rigid"]);
}

#[test]
fn uses_of_tags_are_found_everywhere() {
    let has_tags = |rules: &str| {
        let grammar = grammar(rules);
        Facts::new(&grammar).all(&grammar).has(Uses::TAGS)
    };
    assert!(!has_tags("A --> setback(1) { front : X. | remainder : extrude(3) comp(f) { side : Y. } }"));
    for rules in [
        r#"A --> comp(e) { isTagged("a") : X. }"#,
        r#"A --> comp(f) { front && isTagged("a") : X. }"#,
        r#"A --> setback(1) { isTagged("a") : X. }"#,
        r#"A --> B(geometry.hasTags("a")) B(b) --> case b : X. else : Y."#,
        "f = size(geometry.tags) A --> extrude(f) X.",
        "attr many = size(geometry.tags) A --> extrude(many) X.",
        r#"A --> tag("a") X."#,
        "A --> deleteTags() X.",
        "A --> setTagsFromEdgeAttrs X.",
        r#"A --> extrude(sum(comp(fe) { isTagged("a") : 1 })) X."#,
    ] {
        assert!(has_tags(rules), "{rules}");
    }
}

#[test]
fn a_long_chain_is_quick() {
    let count = 10_000;
    let rules: String = (0..count).map(|at| format!("R{at} --> split(x) {{ ~1 : R{} }} ", (at + 1) % count)).collect();
    let rules = rules.replace("~1 : R0 ", "~1 : [ R0 ] s(rand(1), split.index, 1) ");
    let grammar = grammar(&rules);
    let facts = Facts::new(&grammar);
    assert_eq!(facts.rule(RuleId(0)).below, Uses::DRAWS);
}
