//! Selectors that never find a component, because earlier selectors take all candidates.

use super::agreed::Agreed;
use crate::analysis::body;
use crate::diag::code::Code;
use crate::diag::{Diag, Diags};
use crate::ops::{self, Braces, Directions, Operation, Selector};
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::span::Span;
use crate::syntax::ast::{Arm, BlockPart, Expr, ExprKind, OpKind};
use crate::syntax::walk;

pub(crate) fn check(cx: &Context) -> Vec<Diag> {
    let mut agreed = Agreed::default();
    for item in &cx.globals.rules {
        let names = cx.tables.at(item.own);
        agreed.check(item, |diags| {
            for op in walk::ops(body(item)) {
                let OpKind::Block(block) = &op.kind else { continue };
                let Some(Use::Operation(Operation {
                    braces: Braces::Components | Braces::Arms(_) | Braces::Sections,
                    ..
                })) = names.of(&block.name)
                else {
                    continue;
                };
                for part in &block.parts {
                    if let BlockPart::Arms(list) = part {
                        arms(list, names, diags);
                    }
                }
            }
        });
    }
    agreed.finish()
}

/// The components that a selector takes, if the text determines them.
#[derive(Clone, Copy, PartialEq)]
enum Selection {
    Word(&'static Selector),
    Index(f64),
}

fn takes(selector: &Expr, names: Entries) -> Option<Selection> {
    match &selector.kind {
        ExprKind::Name(name) => match names.of(name)? {
            Use::Selector(word) => ops::selector(word).map(Selection::Word),
            _ => None,
        },
        ExprKind::Number(number) => Some(Selection::Index(*number)),
        _ => None,
    }
}

fn arms(list: &[Arm], names: Entries, diags: &mut Diags) {
    let mut before: Vec<(Selection, Span)> = Vec::new();
    let mut taken = Directions::NONE;
    for arm in list {
        let Some(own) = takes(&arm.selector, names) else { continue };
        let span = arm.selector.span;
        if let Selection::Index(index) = own
            && index.fract() != 0.0
        {
            let diag = never(diags, own, span);
            diag.note("indices of components are whole numbers from 0").help("write another index, or leave it out");
            continue;
        }
        let one = before.iter().find(|(other, _)| covers(*other, own));
        let directions = if let Selection::Word(word) = own { word.directions } else { Directions::NONE };
        if let Some((other, place)) = one {
            let text = shown(*other);
            let diag = never(diags, own, span);
            diag.note(ONCE).related(format!("{text} takes all of them"), *place);
            diag.help(if *other == own { "leave it out" } else { "move it before the others, or leave it out" });
        } else if directions.within(taken) && directions != Directions::ALL {
            let diag = never(diags, own, span).note(ONCE).note("the selectors before it take all its directions");
            diag.help("move it before the others, or leave it out");
        }
        taken = taken.and(directions);
        before.push((own, span));
    }
}

const ONCE: &str = "a component goes to the first selector that matches";

fn never(diags: &mut Diags, own: Selection, span: Span) -> &mut Diag {
    diags.report(Code::SelectorHidden, span, format!("{} never finds a component", shown(own)))
}

fn shown(of: Selection) -> String {
    match of {
        Selection::Word(word) => format!("`{}`", word.name),
        Selection::Index(index) => format!("index {index}"),
    }
}

/// Returns true if one selector takes all components that the other one could.
fn covers(one: Selection, other: Selection) -> bool {
    one == other
        || match (one, other) {
            (_, Selection::Word(Selector { is_rest: true, .. })) => false,
            (Selection::Word(one), _) if one.directions == Directions::ALL => true,
            (Selection::Word(one), Selection::Word(other)) => other.directions.within(one.directions),
            _ => false,
        }
}
