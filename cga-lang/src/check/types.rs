//! Which values are floats, bools and strings.
//!
//! There are no type annotations: every declaration and parameter has one type, found from its uses and from the calls.
//! Bodies come first and calls last, so that a wrong argument is blamed at the call.

use super::unify::{State, Var, Vars};
use super::{Cx, Use};
use crate::ast::{Arg, Binary, Body, Decl, Expr, ExprKind, Name, Op, OpKind, SplitItem, Unary};
use crate::code::Code;
use crate::ir::Type;
use crate::ops::{Operation, ParamKind};
use crate::span::Span;
use std::collections::HashMap;

pub(super) fn infer(cx: &mut Cx) {
    let mut pass = Infer {
        cx,
        vars: Vars::default(),
        slots: HashMap::new(),
        pluses: Vec::new(),
        calls: Vec::new(),
        ordered: Vec::new(),
        params: &[],
    };
    for decl in pass.cx.globals.values().collect::<Vec<_>>() {
        let Some(value) = decl.value() else { continue };
        pass.params = &decl.params;
        let own = pass.slot(decl.name.id());
        let ty = pass.expr(value);
        // Fails only for a recursive function that was used as something else inside its own body.
        if let Err((own, other)) = pass.vars.join(own, ty) {
            pass.mismatch(value.span, &format!("`{}` is used as a {}, but this is", decl.name.text, own.word()), other);
        }
        if pass.vars.state(ty) == State::Poison {
            pass.poison_slot(decl.name.id());
        }
    }
    for decl in pass.cx.globals.rules.clone() {
        if let Body::Rule(ops) = &decl.body {
            pass.params = &decl.params;
            pass.ops(ops);
        }
    }
    pass.solve();
    pass.store();
}

struct Plus {
    left: Var,
    right: Var,
    result: Var,
    at: Span,
    left_span: Span,
    right_span: Span,
    done: bool,
}

struct Argument {
    arg: Var,
    span: Span,
    param: Var,
    callee: String,
    name: String,
}

struct Infer<'p, 'a, 'd> {
    cx: &'p mut Cx<'a, 'd>,
    vars: Vars,
    /// By the token a declaration, parameter, Rust value or Rust call begins with.
    slots: HashMap<u32, Var>,
    pluses: Vec<Plus>,
    calls: Vec<Argument>,
    /// Operands of `<` and its like, which bools have not.
    ordered: Vec<(Var, Span)>,
    params: &'a [Name],
}

impl<'a> Infer<'_, 'a, '_> {
    fn slot(&mut self, token: u32) -> Var {
        if let Some(&var) = self.slots.get(&token) {
            return var;
        }
        let var = self.vars.add(State::Free, None);
        self.slots.insert(token, var);
        var
    }

    fn poison_slot(&mut self, token: u32) {
        let var = self.vars.add(State::Poison, None);
        self.slots.insert(token, var);
    }

    fn known(&mut self, ty: Type, span: Span) -> Var {
        self.vars.add(State::Is(ty), Some(span))
    }

    fn mismatch(&mut self, span: Span, needs: &str, got: Type) -> &mut crate::diag::Diag {
        self.cx.diags.report(Code::TypeMismatch, span, format!("{needs} a {}", got.word()))
    }

    /// Demands a type of an expression.
    fn need(&mut self, expr: &'a Expr, ty: Type, who: &str) {
        let var = self.expr(expr);
        self.need_var(var, expr.span, ty, who);
    }

    fn need_var(&mut self, var: Var, span: Span, ty: Type, who: &str) {
        if self.vars.bind(var, ty, span) {
            return;
        }
        let Some(got) = self.vars.known(var) else { return };
        let why = self.vars.why(var).filter(|why| *why != span);
        let diag = self.cx.diags.report(
            Code::TypeMismatch,
            span,
            format!("{who} needs a {}, got a {}", ty.word(), got.word()),
        );
        if let Some(why) = why {
            diag.related(format!("found to be a {}", got.word()), why);
        }
        match (ty, got) {
            (Type::Text, _) => _ = diag.help("write `str(…)`"),
            (Type::Float, Type::Text) => _ = diag.help("write `float(…)`"),
            (Type::Bool, Type::Float) => _ = diag.help("write a comparison, as in `… != 0`"),
            _ => {}
        }
    }

    fn expr(&mut self, expr: &'a Expr) -> Var {
        let span = expr.span;
        match &expr.kind {
            ExprKind::Number(_) => self.known(Type::Float, span),
            ExprKind::Bool(_) => self.known(Type::Bool, span),
            ExprKind::Text(_) => self.known(Type::Text, span),
            ExprKind::Host(_) => self.slot(span.first),
            ExprKind::Name(name) => self.used(name, &[]),
            ExprKind::Call(name, args) => self.used(name, args),
            ExprKind::Path(name, args) => {
                for arg in args {
                    self.expr(arg);
                }
                self.slot(name.id())
            }
            ExprKind::Unary(Unary::Not, operand) => {
                self.need(operand, Type::Bool, "`!`");
                self.known(Type::Bool, span)
            }
            ExprKind::Unary(op, operand) => {
                self.need(operand, Type::Float, if *op == Unary::Minus { "`-`" } else { "`+` with one operand" });
                self.known(Type::Float, span)
            }
            ExprKind::Binary(op, at, left, right) => self.binary(*op, *at, left, right, span),
            ExprKind::Case(arms, otherwise) => {
                for (condition, _) in arms {
                    self.need(condition, Type::Bool, "`case`");
                }
                self.branches(arms.iter().map(|(_, value)| value), otherwise)
            }
            ExprKind::Chance(arms, otherwise) => self.branches(arms.iter().map(|(_, value)| value), otherwise),
            ExprKind::Error
            | ExprKind::EachUnary(..)
            | ExprKind::Each(..)
            | ExprKind::Array(_)
            | ExprKind::Range(..)
            | ExprKind::Index(..)
            | ExprKind::Comp(_) => self.vars.add(State::Poison, None),
        }
    }

    fn branches(&mut self, arms: impl Iterator<Item = &'a Expr>, otherwise: &'a Expr) -> Var {
        let result = self.vars.add(State::Free, None);
        for value in arms.chain([otherwise]) {
            let ty = self.expr(value);
            if let Err((first, second)) = self.vars.join(result, ty) {
                let why = self.vars.why(result);
                let diag =
                    self.mismatch(value.span, &format!("the branches before are a {}, this is", first.word()), second);
                if let Some(why) = why {
                    diag.related(format!("a {}", first.word()), why);
                }
                return self.vars.add(State::Poison, None);
            }
        }
        result
    }

    /// A name or call in an expression.
    fn used(&mut self, name: &'a Name, args: &'a [Expr]) -> Var {
        let found = self.cx.tables.of(name);
        let types: Vec<Var> = args.iter().map(|arg| self.expr(arg)).collect();
        match found {
            Some(Use::Param(index)) => {
                let token = self.params[index as usize].id();
                self.slot(token)
            }
            Some(Use::Attr(index)) => self.slot(self.cx.globals.attrs[index as usize].name.id()),
            Some(Use::Const(index)) => self.slot(self.cx.globals.consts[index as usize].name.id()),
            Some(Use::Function(index)) => {
                let decl = self.cx.globals.functions[index as usize];
                self.arguments(decl, types.into_iter().zip(args.iter().map(|arg| arg.span)));
                self.slot(decl.name.id())
            }
            Some(Use::Builtin(row)) => {
                for ((var, arg), param) in types.into_iter().zip(args).zip(row.params) {
                    if let ParamKind::Value(ty) = param.kind {
                        self.need_var(var, arg.span, ty, &format!("`{}`", row.name));
                    }
                }
                self.known(row.ty, name.span)
            }
            Some(Use::Convert(ty)) => self.known(ty, name.span),
            Some(Use::Shape(row)) => self.known(row.ty, name.span),
            _ => self.vars.add(State::Poison, None),
        }
    }

    fn arguments(&mut self, decl: &'a Decl, args: impl Iterator<Item = (Var, Span)>) {
        for ((arg, span), param) in args.zip(&decl.params) {
            let var = self.slot(param.id());
            let (callee, name) = (decl.name.text.clone(), param.text.clone());
            self.calls.push(Argument { arg, span, param: var, callee, name });
        }
    }

    fn binary(&mut self, op: Binary, at: Span, left: &'a Expr, right: &'a Expr, span: Span) -> Var {
        let who = format!("`{}`", op.text());
        match op {
            Binary::Add => {
                let (a, b) = (self.expr(left), self.expr(right));
                let result = self.vars.add(State::Free, None);
                let (left_span, right_span) = (left.span, right.span);
                self.pluses.push(Plus { left: a, right: b, result, at, left_span, right_span, done: false });
                // Most are clear at once, and what follows sees their type.
                let last = self.pluses.len() - 1;
                self.plus(last);
                result
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
                    if first == Type::Text || second == Type::Text {
                        diag.help("write `str(…)` or `float(…)` around one of them");
                    }
                } else if !matches!(op, Binary::Eq | Binary::Ne) {
                    self.ordered.push((a, at));
                }
                self.known(Type::Bool, span)
            }
        }
    }

    fn ops(&mut self, ops: &'a [Op]) {
        for op in ops {
            match &op.kind {
                OpKind::Leaf(_) | OpKind::Nil | OpKind::Error | OpKind::Dynamic { .. } | OpKind::Block(_) => {}
                OpKind::Call(name, args) => self.call(name, args),
                OpKind::Path(_, args) => {
                    for arg in args {
                        self.expr(&arg.value);
                    }
                }
                OpKind::Push(ops) => self.ops(ops),
                OpKind::Split(split) => self.items(&split.items),
                OpKind::Comp(comp) => {
                    for arm in &comp.arms {
                        self.selector(&arm.selector);
                        self.ops(&arm.ops);
                    }
                }
                OpKind::Case(arms, otherwise) => {
                    for (condition, ops) in arms {
                        self.need(condition, Type::Bool, "`case`");
                        self.ops(ops);
                    }
                    self.ops(otherwise);
                }
                OpKind::Chance(arms, otherwise) => {
                    for (_, ops) in arms {
                        self.ops(ops);
                    }
                    self.ops(otherwise);
                }
            }
        }
    }

    fn items(&mut self, items: &'a [SplitItem]) {
        for item in items {
            match item {
                SplitItem::Slot(size, ops) => {
                    self.need(&size.value, Type::Float, "a size");
                    self.ops(ops);
                }
                SplitItem::Group(items, _) => self.items(items),
            }
        }
    }

    fn selector(&mut self, selector: &'a Expr) {
        let found = match &selector.kind {
            ExprKind::Name(name) => self.cx.tables.of(name),
            _ => None,
        };
        if !matches!(found, Some(Use::Selector(_))) && !super::shapes::is_condition(selector) {
            self.need(selector, Type::Float, "a selector that is no word");
        }
    }

    fn call(&mut self, name: &'a Name, args: &'a [Arg]) {
        match self.cx.tables.of(name) {
            Some(Use::Operation(row)) => self.operation(row, args),
            Some(Use::Rule(index)) => {
                let decl = self.cx.globals.rules[index as usize];
                let types: Vec<(Var, Span)> = args.iter().map(|arg| (self.expr(&arg.value), arg.value.span)).collect();
                self.arguments(decl, types.into_iter());
            }
            Some(Use::SetAttr(index)) => {
                let decl = self.cx.globals.attrs[index as usize];
                let (own, Some(value)) = (self.slot(decl.name.id()), args.get(1)) else { return };
                let arg = self.expr(&value.value);
                let (callee, name) = ("set".into(), decl.name.text.clone());
                self.calls.push(Argument { arg, span: value.value.span, param: own, callee, name });
            }
            Some(Use::SetShape(row)) => {
                if let Some(value) = args.get(1) {
                    self.need(&value.value, row.ty, &format!("`{}`", row.name));
                }
            }
            _ => {
                for arg in args {
                    self.expr(&arg.value);
                }
            }
        }
    }

    fn operation(&mut self, row: &'static Operation, args: &'a [Arg]) {
        for (param, arg) in row.params.iter().zip(args) {
            let ty = match param.kind {
                ParamKind::Value(ty) => ty,
                ParamKind::Length | ParamKind::Size => Type::Float,
                ParamKind::Any | ParamKind::Selector | ParamKind::Word { .. } => continue,
            };
            self.need(&arg.value, ty, &format!("`{}` of `{}`", param.name, row.name));
        }
    }

    fn solve(&mut self) {
        self.propagate();
        for index in 0..self.calls.len() {
            let Argument { arg, span, param, ref callee, ref name } = self.calls[index];
            let Err((got, needs)) = self.vars.join(arg, param) else { continue };
            let message = if callee == "set" {
                format!("`{name}` is a {}, got a {}", needs.word(), got.word())
            } else {
                format!("`{name}` of `{callee}` is a {}, got a {}", needs.word(), got.word())
            };
            let why = self.vars.why(param);
            let diag = self.cx.diags.report(Code::TypeMismatch, span, message);
            if let Some(why) = why.filter(|why| *why != span) {
                diag.related(format!("found to be a {}", needs.word()), why);
            }
        }
        self.propagate();
        // What is still open is a sum of floats, unless text is needed.
        for index in 0..self.pluses.len() {
            if !self.plus(index) {
                let Plus { left, right, result, at, .. } = self.pluses[index];
                let ty = self.vars.known(result).unwrap_or(Type::Float);
                for var in [left, right, result] {
                    self.vars.bind(var, ty, at);
                }
                self.pluses[index].done = true;
            }
        }
        for (var, span) in std::mem::take(&mut self.ordered) {
            if self.vars.known(var) == Some(Type::Bool) {
                let message = "bools have no order";
                self.cx.diags.report(Code::TypeMismatch, span, message).help("write `==` or `!=`");
            }
        }
    }

    /// Decides every `+` that can be decided. The number of rounds is bounded: what is still open then is a sum.
    fn propagate(&mut self) {
        for _ in 0..32 {
            let mut changed = false;
            for index in 0..self.pluses.len() {
                changed |= !self.pluses[index].done && self.plus(index);
            }
            if !changed {
                break;
            }
        }
    }

    /// Decides what a `+` is, if that is clear.
    fn plus(&mut self, index: usize) -> bool {
        let Plus { left, right, result, at, left_span, right_span, done } = self.pluses[index];
        if done {
            return true;
        }
        let (l, r) = (self.vars.state(left), self.vars.state(right));
        let text = State::Is(Type::Text);
        if l == text || r == text {
            self.result(result, Type::Text, at);
        } else if self.vars.known(result) == Some(Type::Float) || (l == State::Is(Type::Float) && r == l) {
            self.need_var(left, left_span, Type::Float, "`+`");
            self.need_var(right, right_span, Type::Float, "`+`");
            self.result(result, Type::Float, at);
        } else if l == State::Poison || r == State::Poison {
            // Nothing more is said about it.
        } else if l == State::Is(Type::Bool) && r != State::Free || r == State::Is(Type::Bool) && l != State::Free {
            self.need_var(left, left_span, Type::Float, "`+`");
            self.need_var(right, right_span, Type::Float, "`+`");
            self.result(result, Type::Float, at);
        } else {
            return false;
        }
        self.pluses[index].done = true;
        true
    }

    fn result(&mut self, result: Var, ty: Type, at: Span) {
        if !self.vars.bind(result, ty, at)
            && let Some(needs) = self.vars.known(result)
        {
            let message = format!("this `+` gives a {}, but a {} is needed", ty.word(), needs.word());
            self.cx.diags.report(Code::TypeMismatch, at, message);
        }
    }

    fn store(&mut self) {
        let slots: Vec<(u32, Var)> = self.slots.iter().map(|(token, var)| (*token, *var)).collect();
        for (token, var) in slots {
            let ty = match self.vars.state(var) {
                State::Is(ty) => ty,
                State::Free => Type::Float,
                State::Poison => continue,
            };
            self.cx.tables.types.insert(token, ty);
        }
        let declared: Vec<&Name> = self.cx.globals.rules.iter().flat_map(|decl| &decl.params).collect();
        let functions: Vec<&Name> = self.cx.globals.functions.iter().flat_map(|decl| &decl.params).collect();
        for param in declared.into_iter().chain(functions) {
            self.cx.tables.types.entry(param.id()).or_insert(Type::Float);
        }
    }
}
