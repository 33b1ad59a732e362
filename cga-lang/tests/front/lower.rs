//! `tests/data/lower`: the grammar that comes out, one line a step.

use crate::ir_print::print;
use cga_lang::compile::{Compiled, Dialect, compile};
use cga_lang::ir::{BlockParts, Item, Renew, RuleId, Step, StepKind, Target, Type};
use cga_lang::link::{NoFiles, Unit};
use cga_lang::syntax::lex::lex;
use cga_lang::syntax::token::{Tok, Tokens};

#[test]
fn trees_become_these_grammars() {
    crate::common::walk("lower", |text| {
        let (compiled, lexed) = crate::common::compiled(text);
        let shown = compiled.grammar.as_ref().map_or_else(|| "no grammar\n".into(), print);
        (compiled.diags, lexed, Some(shown))
    });
}

#[test]
fn a_target_passes_as_many_arguments_as_its_rule_has_parameters() {
    for folder in ["check", "lower"] {
        for path in crate::common::fixtures(folder) {
            let text = crate::common::strip(&std::fs::read_to_string(path).expect("readable fixture"));
            let Some(grammar) = crate::common::compiled(&text).0.grammar else { continue };
            let count = |rule: RuleId| {
                let rule = &grammar.rules[rule.0 as usize];
                rule.params.len() - rule.locals.len()
            };
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
        match &step.kind {
            StepKind::Give(target) | StepKind::Renew(Renew { target, .. }) => visit(target),
            StepKind::Block(block) => {
                assert_eq!(block.args.len(), block.row.params.len());
                match &block.parts {
                    BlockParts::Slots(own) => {
                        assert_eq!(own.sizes.len(), own.targets.len());
                        assert_eq!(slots(&own.pattern), own.targets.len());
                        own.targets.iter().for_each(&mut *visit);
                    }
                    BlockParts::Arms(arms) => arms.iter().for_each(|arm| visit(&arm.then)),
                    BlockParts::Sections(parts) => {
                        assert_eq!(parts.depths.len(), parts.slots.targets.len());
                        parts.slots.targets.iter().for_each(&mut *visit);
                        parts.rest.iter().for_each(|arm| visit(&arm.then));
                    }
                    BlockParts::Each(target) => visit(target),
                    BlockParts::Operands(targets) => targets.iter().for_each(&mut *visit),
                }
            }
            StepKind::Push(steps) => targets(steps, visit),
            StepKind::Case { arms, otherwise } => {
                arms.iter().for_each(|(_, steps)| targets(steps, visit));
                targets(otherwise, visit);
            }
            StepKind::Do(..) | StepKind::SetAttr(..) | StepKind::SetShape(..) | StepKind::Rust(..) => {}
        }
    }
}

/// The number of slots of a pattern. Groups end inside it, and inner groups inside outer ones.
fn slots(pattern: &[Item]) -> usize {
    let mut ends = vec![pattern.len()];
    for (at, item) in pattern.iter().enumerate() {
        ends.retain(|end| at < *end);
        if let Item::Repeat(len) = item {
            let end = at + 1 + *len as usize;
            assert!(ends.iter().all(|outer| end <= *outer));
            ends.push(end);
        }
    }
    pattern.iter().filter(|item| matches!(item, Item::Slot)).count()
}

/// Compiles rules among Rust.
fn inline(tokens: Tokens) -> Compiled {
    compile(Unit::new(tokens, Dialect::Inline), &mut NoFiles, &[])
}

/// Tokens of a text in which names that begin with `HOST` stand for Rust values.
fn with_hosts(text: &str) -> Tokens {
    let host = |name: &str| name.strip_prefix("HOST").and_then(|handle| handle.parse().ok()).map(Tok::Host);
    lex(text).tokens.as_slice().iter().map(|tok| tok.ident().and_then(host).unwrap_or_else(|| tok.clone())).collect()
}

#[test]
fn rust_values_get_their_types_from_their_uses() {
    let text = "B(name) --> color(name)\n attr a = HOST7 + 1\n Lot --> case HOST3 : B(HOST4) else : extrude(HOST9 * a)\n\
                c = HOST1 == \"x\"";
    let compiled = inline(with_hosts(text));
    assert_eq!(compiled.diags, []);
    let grammar = compiled.grammar.expect("no findings");
    let hosts: Vec<(u32, Type)> = grammar.hosts.iter().map(|host| (host.handle, host.ty)).collect();
    let wanted = [(7, Type::Float), (3, Type::Bool), (4, Type::Text), (9, Type::Float), (1, Type::Text)];
    assert_eq!(hosts, wanted);
    assert_eq!(grammar.globals[0].known, None);
}

#[test]
fn a_rust_value_cannot_be_an_operation() {
    let compiled = inline(with_hosts("Lot --> HOST1"));
    assert_eq!(compiled.diags[0].message.to_string(), "expected an operation or a rule, found a Rust value");
}

#[test]
fn public_names_are_known_despite_errors() {
    let text = "attr a = 3 attr b = nothing attr c = \"x\" attr d = a > 2 attr a = 4 attr e = 1 + Lot --> Nothing(";
    let compiled = inline(lex(text).tokens);
    assert!(compiled.grammar.is_none());
    let names: Vec<(&str, Option<Type>)> = compiled.names.iter().map(|attr| (attr.name.as_str(), attr.ty)).collect();
    let wanted = [("a", Some(Type::Float)), ("b", None), ("c", Some(Type::Text)), ("d", Some(Type::Bool)), ("e", None)];
    assert_eq!(names, wanted);
}

#[test]
fn a_declaration_with_a_rust_value_has_one_type() {
    // The value is computed once and is of one type, so nothing is read again.
    let with_value = |body: Tok| {
        let mut tokens: Vec<Tok> = lex("f(x) = x +").tokens.as_slice().to_vec();
        tokens.push(body);
        tokens.extend_from_slice(lex("Lot --> print(f(1)) print(f(\"a\"))").tokens.as_slice());
        inline(tokens.into_iter().collect()).diags
    };
    assert_eq!(with_value(Tok::Number(2.0)), []);
    let found = with_value(Tok::Host(0));
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].message.to_string(), "`x` of `f` is a float, got a string");
}
