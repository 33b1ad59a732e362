//! `tests/data/lower`: the grammar that comes out, one line a step.

mod common;

use cga_lang::ir::{Item, RuleId, Step, Target};
use cga_lang::ir_print::print;

#[test]
fn trees_become_these_grammars() {
    common::walk("lower", |text| {
        let (compiled, lexed) = common::compiled(text);
        let shown = compiled.grammar.as_ref().map_or_else(|| "no grammar\n".into(), print);
        (compiled.diags, lexed, Some(shown))
    });
}

#[test]
fn a_target_passes_as_many_arguments_as_its_rule_has_parameters() {
    for folder in ["check", "lower"] {
        for path in common::fixtures(folder) {
            let text = common::strip(&std::fs::read_to_string(path).expect("readable fixture"));
            let Some(grammar) = common::compiled(&text).0.grammar else { continue };
            let count = |rule: RuleId| grammar.rules[rule.0 as usize].params.len();
            for rule in &grammar.rules {
                targets(&rule.body, &mut |target| {
                    if let Target::Rule { rule, args, .. } = target {
                        assert_eq!(args.len(), count(*rule));
                    }
                });
            }
        }
    }
}

fn targets(steps: &[Step], visit: &mut dyn FnMut(&Target)) {
    for step in steps {
        match step {
            Step::Give(target) => visit(target),
            Step::Split(split) => {
                assert_eq!(split.sizes.len(), split.slots.len());
                assert_eq!(slots(&split.pattern), (0..split.slots.len() as u32).collect::<Vec<_>>());
                split.slots.iter().for_each(&mut *visit);
            }
            Step::Comp(comp) => comp.arms.iter().for_each(|arm| visit(&arm.target)),
            Step::Push(steps) => targets(steps, visit),
            Step::Case { arms, otherwise } => {
                arms.iter().for_each(|(_, steps)| targets(steps, visit));
                targets(otherwise, visit);
            }
            Step::Chance { arms, otherwise } => {
                arms.iter().for_each(|(_, steps)| targets(steps, visit));
                targets(otherwise, visit);
            }
            Step::Do(..) | Step::SetAttr(..) | Step::SetShape(..) | Step::Rust(..) | Step::Nil(_) => {}
        }
    }
}

fn slots(pattern: &[Item]) -> Vec<u32> {
    let one = |item: &Item| match item {
        Item::Slot(index) => vec![*index],
        Item::Repeat(items) => slots(items),
    };
    pattern.iter().flat_map(one).collect()
}
