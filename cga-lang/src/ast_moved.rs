//! A declaration in other places: the same tree, with other spans.

use crate::ast::{
    Arg, Arm, BlockPart, Body, CompValue, Decl, Expr, ExprKind, Name, Op, OpKind, Override, Percent, SplitItem,
};
use crate::span::Span;

impl Decl {
    /// A copy whose tokens are so many further on, without annotations.
    pub(crate) fn behind(&self, tokens: u32) -> Decl {
        let mut copy = Decl { annotations: Vec::new(), ..self.clone() };
        let by = Behind(tokens);
        by.decl(&mut copy);
        copy
    }
}

/// By how many tokens.
#[derive(Clone, Copy)]
struct Behind(u32);

impl Behind {
    fn span(self, span: &mut Span) {
        *span = span.behind(self.0);
    }

    fn name(self, name: &mut Name) {
        self.span(&mut name.span);
    }

    fn decl(self, decl: &mut Decl) {
        self.name(&mut decl.name);
        self.span(&mut decl.span);
        decl.params.iter_mut().for_each(|param| self.name(param));
        for (name, value) in &mut decl.locals {
            self.name(name);
            self.expr(value);
        }
        match &mut decl.body {
            Body::Attr(value) | Body::Const(value) | Body::Function(value) => self.expr(value),
            Body::Rule(list) => self.ops(list),
        }
    }

    fn ops(self, list: &mut [Op]) {
        for op in list {
            self.span(&mut op.span);
            self.op(&mut op.kind);
        }
    }

    fn op(self, kind: &mut OpKind) {
        match kind {
            OpKind::Call(name, args) | OpKind::Path(name, args) => {
                self.name(name);
                self.args(args);
            }
            OpKind::Dynamic { import, overrides, rule, args } => {
                self.name(import);
                self.name(rule);
                self.args(args);
                for own in overrides {
                    match own {
                        Override::Keep(name) => self.name(name),
                        Override::Value(name, value) => {
                            self.name(name);
                            self.expr(value);
                        }
                        Override::Rule(decl) => self.decl(decl),
                    }
                }
            }
            OpKind::Block(block) => {
                self.name(&mut block.name);
                self.args(&mut block.args);
                block.parts.iter_mut().for_each(|part| self.part(part));
            }
            OpKind::Leaf(name) => self.name(name),
            OpKind::Push(list) => self.ops(list),
            OpKind::Case(arms, otherwise) => {
                for (condition, list) in arms {
                    self.expr(condition);
                    self.ops(list);
                }
                self.ops(otherwise);
            }
            OpKind::Chance(arms, otherwise) => {
                for (percent, list) in arms {
                    self.percent(percent);
                    self.ops(list);
                }
                self.ops(otherwise);
            }
            OpKind::Nil | OpKind::Error => {}
        }
    }

    fn part(self, part: &mut BlockPart) {
        match part {
            BlockPart::Slots(items, _) => self.items(items),
            BlockPart::Sections(list, _) => {
                for section in list {
                    self.arg(&mut section.length);
                    self.expr(&mut section.depth);
                    self.ops(&mut section.ops);
                }
            }
            BlockPart::Arms(arms) => self.arms(arms),
            BlockPart::Ops(lists) => lists.iter_mut().for_each(|list| self.ops(list)),
        }
    }

    fn items(self, items: &mut [SplitItem]) {
        for item in items {
            match item {
                SplitItem::Slot(size, list) => {
                    self.arg(size);
                    self.ops(list);
                }
                SplitItem::Group(items, _) => self.items(items),
            }
        }
    }

    fn arms(self, arms: &mut [Arm]) {
        for arm in arms {
            self.expr(&mut arm.selector);
            self.ops(&mut arm.ops);
        }
    }

    fn args(self, args: &mut [Arg]) {
        args.iter_mut().for_each(|arg| self.arg(arg));
    }

    fn arg(self, arg: &mut Arg) {
        if let Some((_, span)) = &mut arg.prefix {
            self.span(span);
        }
        self.expr(&mut arg.value);
        self.span(&mut arg.span);
    }

    fn percent(self, percent: &mut Percent) {
        self.span(&mut percent.span);
    }

    fn exprs(self, list: &mut [Expr]) {
        list.iter_mut().for_each(|expr| self.expr(expr));
    }

    fn expr(self, expr: &mut Expr) {
        self.span(&mut expr.span);
        match &mut expr.kind {
            ExprKind::Number(_) | ExprKind::Bool(_) | ExprKind::Text(_) | ExprKind::Host(_) | ExprKind::Error => {}
            ExprKind::Name(name) => self.name(name),
            ExprKind::Call(name, args) | ExprKind::Path(name, args) => {
                self.name(name);
                self.exprs(args);
            }
            ExprKind::Unary(_, a) | ExprKind::EachUnary(_, a) => self.expr(a),
            ExprKind::Binary(_, at, a, b) | ExprKind::Each(_, at, a, b) => {
                self.span(at);
                self.expr(a);
                self.expr(b);
            }
            ExprKind::Array(rows) => rows.iter_mut().for_each(|row| self.exprs(row)),
            ExprKind::Range(base, step, limit) => {
                [Some(base), step.as_mut(), Some(limit)].into_iter().flatten().for_each(|part| self.expr(part));
            }
            ExprKind::Index(array, indices) => {
                self.expr(array);
                self.exprs(indices);
            }
            ExprKind::Comp(comp) => self.comp_value(comp),
            ExprKind::Case(arms, otherwise) => {
                for (condition, value) in arms {
                    self.expr(condition);
                    self.expr(value);
                }
                self.expr(otherwise);
            }
            ExprKind::Chance(arms, otherwise) => {
                for (percent, value) in arms {
                    self.percent(percent);
                    self.expr(value);
                }
                self.expr(otherwise);
            }
        }
    }

    fn comp_value(self, comp: &mut CompValue) {
        self.name(&mut comp.name);
        self.exprs(&mut comp.args);
        for (selector, _, value) in &mut comp.arms {
            self.expr(selector);
            self.expr(value);
        }
    }
}
