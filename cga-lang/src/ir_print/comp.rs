//! Divisions into components.

use super::Printer;
use crate::ir::{Align, Comp, CompArm, CompMode, Expr, Selector, Target};

impl Printer<'_> {
    /// A line for each arm.
    pub(super) fn comp(&mut self, comp: &Comp<Target>) {
        self.line(&head(comp));
        self.depth += 1;
        for arm in &comp.arms {
            let text = self.arm(arm, &self.target(&arm.then));
            self.line(&text);
        }
        self.depth -= 1;
    }

    /// On one line, as it stands in an expression.
    pub(super) fn comp_value(&self, comp: &Comp<Expr>) -> String {
        let arms: Vec<String> = comp.arms.iter().map(|arm| self.arm(arm, &self.expr(&arm.then))).collect();
        format!("{} {{ {} }}", head(comp), arms.join(" | "))
    }

    /// The selector, the operator and what becomes of the parts.
    fn arm<T>(&self, arm: &CompArm<T>, then: &str) -> String {
        let (selector, plain) = match &arm.selector {
            Selector::Word(word) => ((*word).to_owned(), *word == arm.text),
            Selector::Index(index) => (format!("index {}", self.expr(index)), false),
            Selector::When(condition) => (format!("when {}", self.expr(condition)), false),
        };
        let text = if plain { String::new() } else { format!(" as {:?}", arm.text) };
        let mode = match arm.mode {
            CompMode::Each => "->",
            CompMode::Together => "=>",
            CompMode::Connected => "=>>",
        };
        format!("{selector}{text} {mode} {then}")
    }
}

/// Into what.
fn head<T>(comp: &Comp<T>) -> String {
    let align = match comp.align {
        Align::ZUp => "",
        Align::Keep => " noAlign",
    };
    format!("comp {}{align}", comp.components.name)
}
