//! `case … else` and `30% : … else`, for operations of a rule and for values.

use super::{Parsed, Parser, Reported};
use crate::diag::code::Code;
use crate::syntax::ast::{Expr, ExprKind, Op, OpKind, Percent};
use crate::syntax::token::{Sym, Tok};

/// Branches of a branch block. Only one of the lists is filled, unless the kinds were mixed, which is reported.
struct Branches<T> {
    cases: Vec<(Expr, T)>,
    chances: Vec<(Percent, T)>,
    otherwise: Option<T>,
}

impl Parser<'_> {
    pub(super) fn at_branch(&self) -> bool {
        self.at_case() || self.at_percent()
    }

    fn at_case(&self) -> bool {
        self.is_word("case") || self.at_if()
    }

    pub(super) fn at_percent(&self) -> bool {
        matches!(self.peek(), Some(Tok::Number(_))) && self.nth_is(1, Sym::Percent) && self.nth_is(2, Sym::Colon)
    }

    /// Parses a branch block of operations; `in_arm` as for [`Parser::ops`].
    pub(super) fn branch_ops(&mut self, in_arm: bool) -> Parsed<Op> {
        let start = self.at;
        let arms = self.arms(
            |parser| parser.ops(true),
            |parser| parser.ops(in_arm),
            "end it with `else : …`; `else : NIL` makes nothing",
        )?;
        let otherwise = arms.otherwise.unwrap_or_default();
        let kind = if arms.cases.is_empty() {
            OpKind::Chance(arms.chances, otherwise)
        } else {
            OpKind::Case(arms.cases, otherwise)
        };
        Ok(Op { kind, span: self.span_from(start) })
    }

    /// Parses a branch block of values.
    pub(super) fn branch_value(&mut self) -> Parsed<Expr> {
        let start = self.at;
        let arms = self.arms(Self::expr, Self::expr, "end it with `else : …` and a value")?;
        let otherwise = Box::new(arms.otherwise.unwrap_or_else(|| Expr::error(self.span_from(start))));
        let kind = if arms.cases.is_empty() {
            ExprKind::Chance(arms.chances, otherwise)
        } else {
            ExprKind::Case(arms.cases, otherwise)
        };
        self.node(kind, start)
    }

    /// Passes over `case` or the word written in its place.
    fn case_word(&mut self) -> Parsed<()> {
        if self.is_word("case") {
            self.bump();
            Ok(())
        } else if self.is_word("else") {
            self.no_case(2, "further conditions begin with `case` too, `else` is what remains".into())
        } else {
            self.no_case(1, self.about_if())
        }
    }

    /// Parses the `:` after a condition.
    fn colon_of_case(&mut self) -> Parsed<()> {
        if self.is(Sym::LBrace) && !self.at_border() {
            let help = "a branch has no braces: write `case condition : … else : …`";
            return Err(self.expected("`:`").help(help).into());
        }
        // A lone `=` was meant as `==`.
        let is_equal = self.is(Sym::Assign) && !self.nth_is(1, Sym::Greater);
        if !is_equal && self.slipped_colon("the condition") { Ok(()) } else { self.expect(Sym::Colon) }
    }

    fn arms<T>(
        &mut self,
        mut arm: impl FnMut(&mut Self) -> Parsed<T>,
        otherwise: impl FnOnce(&mut Self) -> Parsed<T>,
        help: &str,
    ) -> Parsed<Branches<T>> {
        let start = self.at;
        let first_is_case = self.at_case();
        let mut arms = Branches { cases: Vec::new(), chances: Vec::new(), otherwise: None };
        let mut mixed = false;
        while (self.at_branch() || (first_is_case && self.at_else_if())) && self.tick() {
            let case = !self.at_percent();
            if case != first_is_case && !mixed {
                mixed = true;
                let span = self.span().to(self.span_at(if case { self.at } else { self.at + 1 }));
                self.diags
                    .report(Code::MixedBranches, span, "conditions and percentages in one block")
                    .help("put one of them inside the other: `case a : 30% : X else : Y else : Z`");
            }
            if case {
                self.case_word()?;
                let condition = self.nested(Self::expr)?;
                self.colon_of_case()?;
                let body = self.nested(&mut arm)?;
                arms.cases.push((condition, body));
            } else if let Some(&Tok::Number(value)) = self.peek() {
                let percent = Percent { value, span: self.span().to(self.span_at(self.at + 1)) };
                self.at += 3;
                let body = self.nested(&mut arm)?;
                arms.chances.push((percent, body));
            }
        }
        if self.is_word("else") {
            self.bump();
            if !self.eat(Sym::Colon) && !self.slipped_colon("`else`") {
                return Err(self.expected_only("`:` after `else`").help("write `else :`").into());
            }
            arms.otherwise = Some(self.nested(otherwise)?);
            return Ok(arms);
        }
        if !matches!(
            self.peek(),
            None | Some(Tok::Sym(Sym::Bar | Sym::RBrace | Sym::RBracket | Sym::RParen | Sym::Comma))
        ) && !self.at_border()
        {
            return self.fail("`else`");
        }
        let (last, message) = if first_is_case {
            (start, "this `case` has no `else`")
        } else {
            (start + 1, "these percentages have no `else`")
        };
        let span = self.span_at(start).to(self.span_at(last));
        self.diags.report(Code::MissingElse, span, message).help(help);
        if mixed { Err(Reported) } else { Ok(arms) }
    }
}
