//! Values.

use super::Printer;
use super::push_quoted;
use cga_lang::ops;
use cga_lang::syntax::ast::{Binary, Expr, ExprKind, Unary};

impl Printer<'_> {
    pub(super) fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Number(value) => self.word(&value.to_string()),
            ExprKind::Bool(value) => self.word(&value.to_string()),
            ExprKind::Text(text) => push_quoted(&mut self.out, text),
            // Parentheses tell a name from the selector of that name.
            ExprKind::Name(name) if expr.span != name.span && ops::selector(&name.text).is_some() => {
                self.word(&format!("({})", name.text));
            }
            ExprKind::Name(name) => self.word(&name.text),
            ExprKind::Host(handle) => self.word(&format!("#{handle}")),
            ExprKind::Call(name, args) | ExprKind::Path(name, args) => {
                self.word(&name.text);
                self.word("(");
                self.list(args, ", ", Self::expr);
                self.word(")");
            }
            ExprKind::Unary(op, operand) => self.unary("", *op, operand),
            ExprKind::EachUnary(op, operand) => self.unary(".", *op, operand),
            ExprKind::Binary(op, _, left, right) => self.binary("", *op, left, right),
            ExprKind::Each(op, _, left, right) => self.binary(".", *op, left, right),
            ExprKind::Chain(first, links) => {
                self.word("(");
                self.expr(first);
                for link in links {
                    self.word(&format!(" {} ", link.op.text()));
                    self.expr(&link.operand);
                }
                self.word(")");
            }
            ExprKind::Array(rows) => {
                self.word("[");
                self.list(rows, "; ", |own, row| own.list(row, ", ", Self::expr));
                self.word("]");
            }
            ExprKind::Range(base, step, limit) => {
                self.expr(base);
                self.word(" : ");
                if let Some(step) = step {
                    self.expr(step);
                    self.word(" : ");
                }
                self.expr(limit);
            }
            ExprKind::Index(array, indices) => {
                let bare = matches!(
                    array.kind,
                    ExprKind::Name(_)
                        | ExprKind::Call(..)
                        | ExprKind::Array(_)
                        | ExprKind::Index(..)
                        | ExprKind::Comp(_)
                );
                self.word(if bare { "" } else { "(" });
                self.expr(array);
                self.word(if bare { "[" } else { ")[" });
                self.list(indices, ", ", Self::expr);
                self.word("]");
            }
            ExprKind::Comp(comp) => {
                self.word("comp(");
                self.list(&comp.args, ", ", Self::expr);
                self.word(") { ");
                self.list(&comp.arms, " | ", |own, (selector, mode, value)| {
                    own.expr(selector);
                    own.mode(*mode);
                    own.word(" ");
                    own.expr(value);
                });
                self.word(" }");
            }
            ExprKind::Case(arms, otherwise) => {
                self.word("(");
                for (condition, value) in arms {
                    self.word("case ");
                    self.expr(condition);
                    self.word(" : ");
                    self.expr(value);
                    self.word(" ");
                }
                self.branch_end(otherwise);
            }
            ExprKind::Chance(arms, otherwise) => {
                self.word("(");
                for (percent, value) in arms {
                    self.percent(percent);
                    self.word(" ");
                    self.expr(value);
                    self.word(" ");
                }
                self.branch_end(otherwise);
            }
            ExprKind::Error => self.word("ERROR"),
        }
    }

    fn unary(&mut self, dot: &str, op: Unary, operand: &Expr) {
        self.word(dot);
        self.word(match op {
            Unary::Minus => "-",
            Unary::Plus => "+",
            Unary::Not => "!",
        });
        self.expr(operand);
    }

    fn binary(&mut self, dot: &str, op: Binary, left: &Expr, right: &Expr) {
        self.word("(");
        self.expr(left);
        self.word(" ");
        self.word(dot);
        self.word(op.text());
        self.word(" ");
        self.expr(right);
        self.word(")");
    }

    fn branch_end(&mut self, otherwise: &Expr) {
        self.word("else : ");
        self.expr(otherwise);
        self.word(")");
    }
}
