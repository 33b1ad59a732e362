//! Operations with braces, and `comp` as a value.

use super::Printer;
use cga_lang::ir::{Arg, Arm, ArmMode, Block, BlockParts, Comp, Expr, ExprKind, Item, Selector, Slots, Value};
use cga_lang::ops::{Default, Operation};
use std::fmt::Write;

impl Printer<'_> {
    /// A line for the operation and one for each part.
    pub(super) fn block(&mut self, block: &Block) {
        let head = self.head(block.row, &block.args);
        match &block.parts {
            BlockParts::Slots(slots) => {
                self.line(&format!("{head} {}{}", pattern(&slots.pattern), self.split(block, slots)));
                self.slots(slots, &self.parts(slots));
            }
            BlockParts::Arms(arms) => {
                self.line(&head);
                self.depth += 1;
                for arm in arms {
                    let text = self.arm(arm, &self.target(&arm.then));
                    self.line(&text);
                }
                self.depth -= 1;
            }
            BlockParts::Sections(parts) => {
                self.line(&format!("{head} {}", pattern(&parts.slots.pattern)));
                let notes: Vec<String> = parts.slots.targets.iter().map(|target| self.call(target)).collect();
                self.slots(&parts.slots, &notes);
                self.depth += 1;
                for (index, depth) in parts.depths.iter().enumerate() {
                    let text = format!("depth {index}: {}", self.expr(depth));
                    self.line(&text);
                }
                for arm in &parts.rest {
                    let text = self.arm(arm, &self.target(&arm.then));
                    self.line(&text);
                }
                self.depth -= 1;
            }
            BlockParts::Each(target) => self.line(&format!("{head} -> {}", self.target(target))),
            BlockParts::Operands(targets) => {
                let targets: Vec<String> = targets.iter().map(|target| self.target(target)).collect();
                self.line(&format!("{head} of {}", targets.join(" | ")));
            }
        }
    }

    /// Slots, each with what is decided on its parts.
    fn slots(&mut self, slots: &Slots, notes: &[String]) {
        self.depth += 1;
        if let Some(solved) = &slots.solved {
            let pieces = solved.pieces.iter().map(|piece| format!("{}: {}..{}", piece.slot, piece.start, piece.end));
            let pieces = pieces.collect::<Vec<_>>().join(", ");
            let text = format!("in {}: {}", solved.extent, if pieces.is_empty() { "nothing" } else { &pieces });
            self.line(&text);
        }
        for (index, ((own, target), note)) in slots.sizes.iter().zip(&slots.targets).zip(notes).enumerate() {
            let text = format!("{index}: {} -> {}{note}", self.size(own), self.named(target));
            self.line(&text);
        }
        self.depth -= 1;
    }

    /// A comp as a value, on one line.
    pub(super) fn comp_value(&self, comp: &Comp) -> String {
        let arms: Vec<String> = comp.arms.iter().map(|arm| self.arm(arm, &self.expr(&arm.then))).collect();
        format!("{} {{ {} }}", self.head(comp.row, &comp.args), arms.join(" | "))
    }

    /// The operation and its arguments, without those that are the default.
    fn head(&self, row: &Operation, args: &[Arg]) -> String {
        let mut text = row.name.to_owned();
        for (arg, param) in args.iter().zip(row.params) {
            let is_default = match (arg, param.default) {
                (Arg::Word(word), Some(Default::Word(default))) => *word == default,
                (
                    Arg::Value(Expr { kind: ExprKind::Value(Value::Float(value)), .. }),
                    Some(Default::Float(default)),
                ) => *value == default,
                _ => false,
            };
            if !is_default {
                let _ = write!(text, " {}", self.arg(arg));
            }
        }
        text
    }

    /// The selector, the operator and what becomes of the parts.
    fn arm<T>(&self, arm: &Arm<T>, then: &str) -> String {
        let (selector, plain) = match &arm.selector {
            Selector::Word(word) => ((*word).to_owned(), *word == arm.text),
            Selector::Index(index) => (format!("index {}", self.expr(index)), false),
            Selector::When(condition) => (format!("when {}", self.expr(condition)), false),
        };
        let text = if plain { String::new() } else { format!(" as {:?}", arm.text) };
        let mode = match arm.mode {
            ArmMode::Each => "->",
            ArmMode::Together => "=>",
            ArmMode::Connected => "=>>",
        };
        format!("{selector}{text} {mode} {then}")
    }
}

/// Slots by number: `{0 {1 2}*}`.
fn pattern(items: &[Item]) -> String {
    let (mut text, mut ends, mut slot) = (String::from("{"), Vec::new(), 0);
    for (at, item) in items.iter().enumerate() {
        while ends.pop_if(|end| *end <= at).is_some() {
            text.push_str("}*");
        }
        if !text.ends_with('{') {
            text.push(' ');
        }
        match item {
            Item::Slot => {
                let _ = write!(text, "{slot}");
                slot += 1;
            }
            Item::Repeat(len) => {
                text.push('{');
                ends.push(at + 1 + *len as usize);
            }
        }
    }
    ends.iter().for_each(|_| text.push_str("}*"));
    text + "}"
}
