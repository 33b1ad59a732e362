//! Arms: `{ selector : operations | selector = operations }`, and `comp` with values instead of operations.

use super::report::AFTER_SELECTOR;
use super::{Parsed, Parser, Reported};
use crate::ops::{self, Braces};
use crate::syntax::ast::{Arm, ArmMode, CompValue, Expr, ExprKind, Name, Op, OpKind};
use crate::syntax::token::Sym;

/// The form of an arm in messages.
const ARM: &str = "selector : operations";

/// Returns true for the operation that may have values instead of operations in its arms.
pub(super) fn has_values(name: &str) -> bool {
    ops::operations(name).any(|row| row.braces == Braces::Components)
}

impl Parser<'_> {
    /// Parses the rest of a `comp` value, after its name at `start`.
    pub(super) fn comp_value(&mut self, name: Name, start: usize) -> Parsed<Expr> {
        const USAGE: &str = "write `comp(f) { selector : value | … }`";
        if !self.is(Sym::LParen) {
            return Err(self.expected("`(`").help(USAGE).into());
        }
        let args = self.call_args(&name.text)?;
        if !self.is(Sym::LBrace) {
            return Err(self.expected("`{`").help(USAGE).into());
        }
        let arms = self.between_bars(Some("selector : value"), |parser| {
            Ok((parser.expr()?, parser.arm_mode()?, parser.expr()?))
        })?;
        self.node(ExprKind::Comp(CompValue { name, args, arms }), start)
    }

    /// Reports and skips a `*` after braces whose parts cannot repeat.
    pub(super) fn not_repeated(&mut self, name: &str) {
        if self.is(Sym::Star) {
            self.syntax(self.at, format!("`{name}` is not repeated")).help("leave out the `*`");
            self.bump();
        }
    }

    /// Parses `{ selector : operations | … }`. An arm that cannot be read has an error as its selector.
    pub(super) fn arms_of_block(&mut self) -> Parsed<Vec<Arm>> {
        let close = self.closing()?;
        self.between_bars(Some(ARM), |parser| {
            let start = parser.at;
            Ok(parser.arm().unwrap_or_else(|Reported| {
                parser.skip_to_bar(close);
                let span = parser.span_from(start);
                let ops = vec![Op { kind: OpKind::Error, span }];
                Arm { selector: Expr::error(span), mode: ArmMode::Each, ops }
            }))
        })
    }

    /// Parses `selector : operations`.
    fn arm(&mut self) -> Parsed<Arm> {
        Ok(Arm { selector: self.expr()?, mode: self.arm_mode()?, ops: self.ops(false)? })
    }

    fn arm_mode(&mut self) -> Parsed<ArmMode> {
        let arrow = self.is(Sym::Arrow) || (self.nth_is(1, Sym::Greater) && !self.is(Sym::Colon));
        if arrow && self.slipped_colon("the selector") {
            return Ok(ArmMode::Each);
        }
        if self.eat(Sym::Assign) {
            return Ok(if self.eat(Sym::Colon) { ArmMode::Connected } else { ArmMode::Together });
        }
        if self.eat(Sym::Colon) {
            return Ok(ArmMode::Each);
        }
        let is_list = self.is(Sym::Comma);
        let diag = self.expected(AFTER_SELECTOR);
        Err(if is_list { diag.help("write `||` between selectors") } else { diag }.into())
    }
}
