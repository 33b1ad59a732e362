//! Arms: `{ selector : operations | selector = operations }`, and `comp` with values instead of operations.

use super::expr::Part;
use super::{Parsed, Parser, Reported};
use crate::syntax::ast::{Arm, ArmMode, CompValue, Expr, ExprKind, Name};
use crate::syntax::token::Sym;

/// The form of an arm in messages.
pub(super) const ARM: &str = "selector : operations";

impl Parser<'_> {
    /// Parses the rest of a `comp` value, after the word `comp` at `start`.
    pub(super) fn comp_value(&mut self, name: Name, start: usize) -> Parsed<Part> {
        const USAGE: &str = "write `comp(f) { selector : value | … }`";
        if !self.is(Sym::LParen) {
            self.expected("`(`").help(USAGE);
            return Err(Reported);
        }
        let args = self.call_args("comp")?;
        if !self.is(Sym::LBrace) {
            self.expected("`{`").help(USAGE);
            return Err(Reported);
        }
        let mut deepest = args.iter().map(|(_, depth)| *depth).max().unwrap_or(0);
        let arms = self.between_bars(Some("selector : value"), |parser| {
            let (selector, one) = parser.deep_expr()?;
            let mode = parser.arm_mode()?;
            let (value, other) = parser.deep_expr()?;
            deepest = deepest.max(one).max(other);
            Ok((selector, mode, value))
        })?;
        let depth = self.deepen(deepest)?;
        let args = args.into_iter().map(|(arg, _)| arg).collect();
        let kind = ExprKind::Comp(CompValue { name, args, arms });
        Ok((Expr { kind, span: self.span_from(start) }, depth))
    }

    /// Reports and skips a `*` after braces whose parts cannot repeat.
    pub(super) fn not_repeated(&mut self, name: &str) {
        if self.is(Sym::Star) {
            self.syntax(self.at, format!("`{name}` is not repeated")).help("leave out the `*`");
            self.bump();
        }
    }

    /// Parses `selector : operations`.
    pub(super) fn arm(&mut self) -> Parsed<Arm> {
        let selector = self.expr()?;
        let mode = self.arm_mode()?;
        let ops = self.ops(false)?;
        Ok(Arm { selector, mode, ops })
    }

    fn arm_mode(&mut self) -> Parsed<ArmMode> {
        let arrow = self.is(Sym::Arrow) || (self.nth_is(1, Sym::Greater) && !self.is(Sym::Colon));
        if arrow && self.slipped_colon("the selector") {
            return Ok(ArmMode::Each);
        }
        if self.eat(Sym::Assign) {
            return Ok(if self.eat(Sym::Colon) { ArmMode::Connected } else { ArmMode::Together });
        }
        if self.eat(Sym::Colon) { Ok(ArmMode::Each) } else { self.fail("`:` or `=` after the selector") }
    }
}
