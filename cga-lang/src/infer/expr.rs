//! Types of expressions.

use super::open::{Constraint, OpenKind, Overload};
use super::{Infer, Type, Use, Var, VarState};
use crate::diag::code::Code;
use crate::ops::Param;
use crate::span::Span;
use crate::syntax::ast::{Binary, Expr, ExprKind, Link, Name, Unary};

impl<'a> Infer<'_, 'a, '_> {
    pub(super) fn expr(&mut self, expr: &'a Expr) -> Var {
        let span = expr.span;
        match &expr.kind {
            ExprKind::Number(_) => self.known(Type::Float, span),
            ExprKind::Bool(_) => self.known(Type::Bool, span),
            ExprKind::Text(_) => self.known(Type::Text, span),
            ExprKind::Host(_) => self.inner_slot(span.first),
            ExprKind::Name(name) => self.used(name, &[]),
            ExprKind::Call(name, args) => self.used(name, args),
            ExprKind::Path(name, args) => {
                for arg in args {
                    self.expr(arg);
                }
                self.inner_slot(name.id())
            }
            ExprKind::Unary(Unary::Not, operand) => {
                self.need(operand, Type::Bool, "`!`");
                self.known(Type::Bool, span)
            }
            ExprKind::Unary(op, operand) => {
                self.need(operand, Type::Float, if *op == Unary::Minus { "`-`" } else { "`+` with one operand" });
                self.known(Type::Float, span)
            }
            ExprKind::EachUnary(op, operand) => {
                let (ty, who) = match op {
                    Unary::Not => (Type::Bools, "`.!`"),
                    Unary::Minus => (Type::Floats, "`.-`"),
                    Unary::Plus => (Type::Floats, "`.+` with one operand"),
                };
                self.need(operand, ty, who);
                self.known(ty, span)
            }
            ExprKind::Binary(op, at, left, right) => self.binary(*op, *at, left, right, span),
            ExprKind::Each(op, at, left, right) => {
                let (left, right) = ((self.expr(left), left.span), (self.expr(right), right.span));
                self.wait(OpenKind::Each(*op, left, right), *at)
            }
            ExprKind::Chain(first, links) => self.chain(first, links),
            ExprKind::Array(rows) => {
                let entries = rows.iter().flatten().map(|entry| (self.expr(entry), entry.span)).collect();
                self.wait(OpenKind::Array(entries), span)
            }
            ExprKind::Range(..) => {
                for part in expr.parts() {
                    self.need(part, Type::Float, "a range");
                }
                self.known(Type::Floats, span)
            }
            ExprKind::Index(array, indices) => {
                let array = (self.expr(array), array.span);
                let indices = indices.iter().map(|index| (self.expr(index), index.span)).collect();
                self.wait(OpenKind::Index(array, indices), span)
            }
            ExprKind::Comp(comp) => self.comp_value(comp, span),
            ExprKind::Case(arms, otherwise) => {
                for (condition, _) in arms {
                    self.need(condition, Type::Bool, "`case`");
                }
                self.branches(arms.iter().map(|(_, value)| value), otherwise)
            }
            ExprKind::Chance(arms, otherwise) => self.branches(arms.iter().map(|(_, value)| value), otherwise),
            ExprKind::Error => self.poison(),
        }
    }

    fn branches(&mut self, arms: impl Iterator<Item = &'a Expr>, otherwise: &'a Expr) -> Var {
        let result = self.free();
        for value in arms.chain([otherwise]) {
            let ty = self.expr(value);
            if let Err((first, second)) = self.vars.join(result, ty) {
                let why = self.vars.why(result);
                let needs = format!("the branches before are a {}, this is", first.word());
                let diag = self.mismatch(value.span, &needs, second);
                if let Some(why) = why {
                    diag.related(format!("a {}", first.word()), why);
                }
                return self.poison();
            }
        }
        result
    }

    /// Infers a name or call in an expression.
    fn used(&mut self, name: &'a Name, args: &'a [Expr]) -> Var {
        let found = self.cx.tables.at(self.own).of(name);
        // Words among the arguments have no entry in the tables; their type is poison, which silences later
        // diagnostics.
        let args: Vec<(Var, Span)> = args.iter().map(|arg| (self.expr(arg), arg.span)).collect();
        match found {
            Some(Use::Param(index)) => {
                let token = self.inner[index as usize].id();
                self.inner_slot(token)
            }
            Some(own) if self.waits(own) => {
                let candidates = self.candidates(own);
                self.wait(OpenKind::Call(name.clone(), candidates, args), name.span)
            }
            Some(Use::Attr(index)) => {
                let own = self.cx.globals.attrs[index as usize].key();
                self.slot(own)
            }
            Some(Use::Const(index)) => {
                let own = self.cx.globals.consts[index as usize].key();
                self.slot(own)
            }
            Some(Use::Function(index)) => {
                let item = self.cx.globals.functions[index as usize].clone();
                self.arguments(&item, args, None);
                self.slot(item.key())
            }
            Some(Use::Builtin(row)) => {
                for ((var, span), param) in args.into_iter().zip(row.params) {
                    self.builtin_argument(param, row.name, var, span);
                }
                self.known(row.ty, name.span)
            }
            Some(Use::Convert(ty)) => self.known(ty, name.span),
            Some(Use::Shape(row)) => self.known(row.ty(), name.span),
            Some(Use::Selector(_)) => self.known(Type::Bool, name.span),
            _ => self.poison(),
        }
    }

    pub(super) fn builtin_argument(&mut self, param: &Param, name: &str, var: Var, span: Span) {
        let who = if param.name.is_empty() { format!("`{name}`") } else { format!("`{}` of `{name}`", param.name) };
        self.need_kind(var, span, param.kind, &who);
    }

    /// Returns true if a call waits for the types of its arguments.
    pub(super) fn waits(&self, found: Use) -> bool {
        matches!(found, Use::Open(_)) || self.is_generic(found)
    }

    /// The candidates of a call, with the types of their parameters.
    pub(super) fn candidates(&mut self, found: Use) -> Vec<Overload> {
        let list = if let Use::Open(open) = found { self.cx.tables.open[open as usize].clone() } else { vec![found] };
        list.into_iter().map(|found| self.candidate(found)).collect()
    }

    fn candidate(&mut self, found: Use) -> Overload {
        let builtin = |params: &[Param]| -> Vec<Constraint> {
            params.iter().map(|param| param.kind.ty().map_or(Constraint::Any, Constraint::Type)).collect()
        };
        let (takes, gives) = match found {
            Use::Function(index) => {
                let item = self.cx.globals.functions[index as usize].clone();
                (self.params(&item).into_iter().map(Constraint::Var).collect(), Constraint::Var(self.slot(item.key())))
            }
            Use::Rule(index) => {
                let item = self.cx.globals.rules[index as usize].clone();
                (self.params(&item).into_iter().map(Constraint::Var).collect(), Constraint::Any)
            }
            Use::Builtin(row) => (builtin(row.params), Constraint::Type(row.ty)),
            Use::Operation(row) => (builtin(row.params), Constraint::Any),
            Use::Convert(Type::Text) => (vec![Constraint::Any], Constraint::Type(Type::Text)),
            Use::Convert(ty) => (vec![Constraint::Type(ty)], Constraint::Type(ty)),
            _ => (Vec::new(), Constraint::Any),
        };
        Overload { found, takes, gives }
    }

    fn chain(&mut self, first: &'a Expr, links: &'a [Link]) -> Var {
        let mut left = (self.expr(first), first.span);
        for Link { op, at, operand } in links {
            let right = (self.expr(operand), operand.span);
            let span = first.span.to(operand.span);
            let ty = if matches!(op, Binary::And | Binary::Or) { Type::Bool } else { Type::Float };
            let result = if *op == Binary::Add {
                self.wait(OpenKind::Plus(left, right), *at)
            } else {
                for (var, span) in [left, right] {
                    self.need_var(var, span, ty, &format!("`{}`", op.text()));
                }
                self.known(ty, span)
            };
            left = (result, span);
        }
        left.0
    }

    fn binary(&mut self, op: Binary, at: Span, left: &'a Expr, right: &'a Expr, span: Span) -> Var {
        let who = format!("`{}`", op.text());
        match op {
            Binary::Add => {
                let (left, right) = ((self.expr(left), left.span), (self.expr(right), right.span));
                self.wait(OpenKind::Plus(left, right), at)
            }
            Binary::Sub | Binary::Mul | Binary::Div | Binary::Rem => {
                self.need(left, Type::Float, &who);
                self.need(right, Type::Float, &who);
                self.known(Type::Float, span)
            }
            Binary::And | Binary::Or => {
                self.need(left, Type::Bool, &who);
                self.need(right, Type::Bool, &who);
                self.known(Type::Bool, span)
            }
            _ => {
                let (a, b) = (self.expr(left), self.expr(right));
                if let Err((first, second)) = self.vars.join(a, b) {
                    let message =
                        format!("{who} compares values of one type, got a {} and a {}", first.word(), second.word());
                    let diag = self.cx.diags.report(Code::TypeMismatch, at, message);
                    if first.element() == second.element() {
                        diag.help(format!("write `.{}` to compare each element", op.text()));
                    } else if first == Type::Text || second == Type::Text {
                        diag.help("write `str(…)` or `float(…)` around one of them");
                    }
                } else if !matches!(op, Binary::Eq | Binary::Ne) {
                    self.ordered.push((self.own, a, at));
                }
                self.known(Type::Bool, span)
            }
        }
    }

    /// Returns true if the type is unknown.
    pub(super) fn is_free(&mut self, var: Var) -> bool {
        self.vars.state(var) == VarState::Free
    }
}
