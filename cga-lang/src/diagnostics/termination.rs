//! Cycles of rules that never end, or that only chance ends.

use super::instances::CommonDiags;
use crate::analysis::{Calls, body};
use crate::diag::code::Code;
use crate::diag::{Basis, Diag, Level, by_way_of};
use crate::graph::{components, is_cycle};
use crate::ops::{Braces, Effect};
use crate::resolve::context::Context;
use crate::resolve::globals::Declared;
use crate::resolve::tables::{Entries, Use};
use crate::span::Span;
use crate::syntax::ast::{Block, BlockPart, ExprKind, Op, OpKind, Prefix, SplitItem};
use crate::syntax::walk::ops;

/// The definition of an end of a cycle.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Ends {
    /// Everything that may stop a run: paths without a call, splits of shapes that are too small.
    All,
    /// All, except splits that pass on the whole shape, because the shape gets no smaller.
    ButWholeSplits,
    /// All, except the decisions of chance.
    ButChance,
}

pub(crate) fn check(cx: &Context, calls: &Calls) -> Vec<Diag> {
    let globals = &cx.globals;
    let mut cycle: Vec<Option<usize>> = vec![None; globals.rules.len()];
    let cycles: Vec<Vec<usize>> =
        components(&calls.edges).into_iter().filter(|component| is_cycle(component, &calls.edges)).collect();
    for (number, component) in cycles.iter().enumerate() {
        component.iter().for_each(|&rule| cycle[rule] = Some(number));
    }
    let sets = [Ends::All, Ends::ButWholeSplits, Ends::ButChance].map(|ends| (ends, going_on(cx, calls, &cycle, ends)));
    let mut common = CommonDiags::default();
    for component in &cycles {
        let found =
            sets.iter().find_map(|(ends, set)| Some((*ends, component.iter().copied().find(|rule| set[*rule])?)));
        let Some((ends, rule)) = found else { continue };
        if ends == Ends::ButWholeSplits && component.iter().any(|rule| sizes(&globals.rules[*rule], cx)) {
            continue;
        }
        let item = &globals.rules[rule];
        let name = &item.decl.name;
        let others = component.iter().filter(|other| **other != rule).map(|other| &globals.rules[*other].decl.name);
        let way = by_way_of(others.map(|name| &name.text));
        common.check(item, |diags| {
            let what = format!("`{}` calls itself{way}", name.text);
            let diag = match ends {
                Ends::All => {
                    let diag = diags.report(Code::EndlessRules, name.span, format!("{what} and never ends"));
                    diag.note("every path through it leads back to it, and nothing on the way ends the cycle")
                }
                Ends::ButWholeSplits => {
                    let message = format!("{what}, and the shape never gets smaller");
                    let diag = diags.report_as(Code::EndlessRules, Level::Warning, name.span, message);
                    diag.basis = Basis::Extent;
                    diag.note("its split passes on the whole shape, so only a shape without an extent ends the cycle")
                }
                Ends::ButChance => {
                    let diag = diags.report(Code::OnlyChanceEnds, name.span, format!("{what} until chance ends it"));
                    diag.note("only percentages end it")
                }
            };
            let itself = component.len() == 1;
            if let Some(call) = call_of(body(item), rule, cx.tables.at(item.own)).filter(|_| itself) {
                diag.related("it calls itself", call);
                diag.help(format!("write `{}.` for a leaf", name.text));
            }
            diag.help("write a `case` with a branch that does not call it, as in `case scope.sx < 0.1 : … else : …`");
        });
    }
    common.finish()
}

/// The first call of a rule in a list of operations.
fn call_of(list: &[Op], wanted: usize, names: Entries) -> Option<Span> {
    ops(list).find_map(|op| match &op.kind {
        OpKind::Call(name, args) if args.is_empty() && names.of(name) == Some(Use::Rule(wanted as u32)) => {
            Some(name.span)
        }
        _ => None,
    })
}

/// The rules of cycles in which every path leads back to such a rule.
fn going_on(cx: &Context, calls: &Calls, cycle: &[Option<usize>], ends: Ends) -> Vec<bool> {
    let rules = &cx.globals.rules;
    let mut callers = vec![Vec::new(); rules.len()];
    for (caller, callees) in calls.edges.iter().enumerate() {
        callees.iter().for_each(|&callee| callers[callee].push(caller));
    }
    let mut going: Vec<bool> = cycle.iter().map(Option::is_some).collect();
    // Rules that can end are removed until no more can be removed.
    let mut open: Vec<usize> = (0..rules.len()).filter(|rule| going[*rule]).collect();
    while let Some(rule) = open.pop() {
        let within = |other: u32| going[other as usize] && cycle[other as usize] == cycle[rule];
        if going[rule] && !goes_on(body(&rules[rule]), cx.tables.at(rules[rule].own), ends, &within) {
            going[rule] = false;
            open.extend(callers[rule].iter().filter(|caller| going[**caller]));
        }
    }
    going
}

/// Returns true if every path through a list of operations calls one of the rules.
fn goes_on(list: &[Op], names: Entries, ends: Ends, within: &dyn Fn(u32) -> bool) -> bool {
    let inner = |ops: &[Op]| goes_on(ops, names, ends, within);
    for op in list {
        let goes = match &op.kind {
            OpKind::Call(name, _) | OpKind::Dynamic { rule: name, .. } => {
                matches!(names.of(name), Some(Use::Rule(rule)) if within(rule))
            }
            OpKind::Error => return false,
            OpKind::Push(ops) => inner(ops),
            OpKind::Case(arms, otherwise) => inner(otherwise) && arms.iter().all(|(_, ops)| inner(ops)),
            OpKind::Chance(arms, otherwise) => {
                let sum: f64 = arms.iter().map(|(percent, _)| percent.value).sum();
                let taken = arms.iter().filter(|(percent, _)| 0.0 < percent.value).map(|(_, ops)| ops);
                let rest = 100.0 <= sum;
                if ends == Ends::ButChance {
                    // A branch that ends the cycle must not call the rules either; otherwise a condition may end the
                    // cycle.
                    let all = || taken.clone().chain((!rest).then_some(otherwise));
                    all().any(|ops| inner(ops)) && all().all(|ops| inner(ops) || !calls_one(ops, names, within))
                } else {
                    taken.clone().all(|ops| inner(ops)) && (rest || inner(otherwise))
                }
            }
            OpKind::Block(block) if ends == Ends::ButWholeSplits && whole(block).is_some_and(inner) => true,
            // Operands are always derived.
            OpKind::Block(block) if is_derived(block, names) => op.bodies().any(inner),
            // A shape may be too small to divide, or have no such components. That ends the cycle.
            OpKind::Block(_) | OpKind::Leaf(_) | OpKind::Nil | OpKind::Path(..) => false,
        };
        if goes {
            return true;
        }
    }
    false
}

/// Returns true if the operations in the braces act on the whole shape.
fn is_derived(block: &Block, names: Entries) -> bool {
    let is_operand = |braces: Braces| matches!(braces, Braces::Inline | Braces::Operands);
    matches!(names.of(&block.name), Some(Use::Operation(row)) if is_operand(row.braces))
}

/// The operations of the only slot, if it takes the whole shape.
fn whole(block: &Block) -> Option<&[Op]> {
    let [BlockPart::Slots(items, repeat)] = block.parts.as_slice() else { return None };
    let [SplitItem::Slot(size, ops)] = items.as_slice() else { return None };
    let takes_all = match (&size.prefix, &size.value.kind) {
        (Some((Prefix::Floating, _)), ExprKind::Number(weight)) => 0.0 < *weight && !repeat,
        (Some((Prefix::Relative, _)), ExprKind::Number(share)) => 1.0 <= *share,
        _ => false,
    };
    takes_all.then_some(ops)
}

/// Returns true if an operation calls one of the rules.
fn calls_one(list: &[Op], names: Entries, within: &dyn Fn(u32) -> bool) -> bool {
    ops(list).any(|op| match &op.kind {
        OpKind::Call(name, _) | OpKind::Dynamic { rule: name, .. } => {
            matches!(names.of(name), Some(Use::Rule(rule)) if within(rule))
        }
        _ => false,
    })
}

/// Returns true if an operation of a rule may change the size of the shape.
fn sizes(item: &Declared, cx: &Context) -> bool {
    let names = cx.tables.at(item.own);
    ops(body(item)).any(|op| match &op.kind {
        OpKind::Call(name, _) => match names.of(name) {
            Some(Use::Operation(row)) => !matches!(row.scope, Effect::Keeps | Effect::KeepsSize),
            Some(Use::Rule(_) | Use::Leaf | Use::SetAttr(_)) => false,
            _ => true,
        },
        // Slots pass on the sizes that they leave of the shape.
        OpKind::Block(block) => !matches!(block.parts.as_slice(), [BlockPart::Slots(..)]),
        OpKind::Path(..) | OpKind::Error => true,
        _ => false,
    })
}
