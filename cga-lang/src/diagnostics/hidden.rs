//! Selectors that find nothing left, as earlier ones take all that they could.

use super::agreed::Agreed;
use crate::analysis::body;
use crate::ast::{Arm, BlockPart, Expr, ExprKind, OpKind};
use crate::ast_walk::ops;
use crate::code::Code;
use crate::diag::{Diag, Diags};
use crate::ops::{Braces, Operation};
use crate::resolve::context::Cx;
use crate::resolve::tables::{Entries, Use};
use crate::span::Span;

pub(crate) fn check(cx: &Cx) -> Vec<Diag> {
    let mut agreed = Agreed::default();
    for item in &cx.globals.rules {
        let (names, mut diags) = (cx.tables.at(item.own), Diags::new());
        ops(body(item), &mut |op| {
            let OpKind::Block(block) = &op.kind else { return };
            // Setbacks leave remainders, which no other selector takes.
            let Some(Use::Operation(Operation { braces: Braces::Components, .. })) = names.of(&block.name) else {
                return;
            };
            for part in &block.parts {
                if let BlockPart::Arms(list) = part {
                    arms(list, names, &mut diags);
                }
            }
        });
        agreed.add(item, diags.finish());
    }
    agreed.finish()
}

/// What a selector takes, as far as it is known without the geometry.
#[derive(Clone, Copy, PartialEq)]
enum Takes {
    Word(&'static str),
    Index(f64),
}

fn takes(selector: &Expr, names: Entries) -> Option<Takes> {
    match &selector.kind {
        ExprKind::Name(name) => match names.of(name)? {
            Use::Selector(word) => Some(Takes::Word(word)),
            _ => None,
        },
        ExprKind::Number(number) => Some(Takes::Index(*number)),
        _ => None,
    }
}

fn arms(list: &[Arm], names: Entries, diags: &mut Diags) {
    let mut before: Vec<(Takes, Span)> = Vec::new();
    let mut taken = 0;
    for arm in list {
        let Some(own) = takes(&arm.selector, names) else { continue };
        let span = arm.selector.span;
        if let Takes::Index(index) = own
            && index.fract() != 0.0
        {
            let diag = never(diags, own, span);
            diag.note("components have whole numbers, from 0 on").help("write another index, or leave it out");
            continue;
        }
        let one = before.iter().find(|(other, _)| covers(*other, own));
        let directions = if let Takes::Word(word) = own { directions(word) } else { 0 };
        if let Some((other, place)) = one {
            let text = shown(*other);
            let diag = never(diags, own, span);
            diag.note(ONCE).related(format!("{text} takes all of them"), *place);
            diag.help(if *other == own { "leave it out" } else { "move it before the others, or leave it out" });
        } else if directions != 0 && directions & !taken == 0 && own != Takes::Word("all") {
            let diag =
                never(diags, own, span).note(ONCE).note("the selectors before it take every direction that it has");
            diag.help("move it before the others, or leave it out");
        }
        taken |= directions;
        before.push((own, span));
    }
}

const ONCE: &str = "what one selector takes, the next ones cannot have";

fn never(diags: &mut Diags, own: Takes, span: Span) -> &mut Diag {
    diags.report(Code::SelectorHidden, span, format!("{} never finds anything", shown(own)))
}

fn shown(of: Takes) -> String {
    match of {
        Takes::Word(word) => format!("`{word}`"),
        Takes::Index(index) => format!("index {index}"),
    }
}

/// Whether one selector takes all that another could.
fn covers(one: Takes, other: Takes) -> bool {
    one == other
        || one == Takes::Word("all")
        || match (one, other) {
            (Takes::Word(one), Takes::Word(other)) => {
                let (all, some) = (directions(one), directions(other));
                some != 0 && some & !all == 0 && other != "all"
            }
            _ => false,
        }
}

/// The directions that a word of the scope's axes takes, one a bit: for each quadrant the inclinations that it has. A
/// quadrant is that of the largest coordinate, so what is in the front is never steeper than 45 degrees.
fn directions(word: &str) -> u16 {
    const ASLANT: u16 = 0b0000_0000_0000_1111;
    const VERTICAL: u16 = 0b0000_0000_1111_0000;
    const NUTANT: u16 = 0b0000_1111_0000_0000;
    const TOP: u16 = 0b0011_0000_0000_0000;
    const TOP_ASLANT: u16 = 0b0001_0000_0000_0000;
    const BOTTOM: u16 = 0b1100_0000_0000_0000;
    const BOTTOM_NUTANT: u16 = 0b0100_0000_0000_0000;
    let around = |quadrant: u32| 0b0001_0001_0001 << quadrant;
    match word {
        "front" => around(0),
        "back" => around(1),
        "left" => around(2),
        "right" => around(3),
        "top" => TOP,
        "bottom" => BOTTOM,
        "aslant" => ASLANT | TOP_ASLANT,
        "vertical" => VERTICAL,
        "nutant" => NUTANT | BOTTOM_NUTANT,
        "horizontal" => (TOP & !TOP_ASLANT) | (BOTTOM & !BOTTOM_NUTANT),
        "side" => ASLANT | VERTICAL | NUTANT | TOP_ASLANT | BOTTOM_NUTANT,
        "all" => u16::MAX,
        _ => 0,
    }
}
