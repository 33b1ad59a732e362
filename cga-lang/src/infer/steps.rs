//! Types in the operations of rules.

use super::open::OpenKind;
use super::{Infer, Type, Use, Var};
use crate::ops::{Operation, ParamKind};
use crate::span::Span;
use crate::syntax::ast::{Arg, Name, Op, OpKind, Override};
use crate::syntax::walk::OpPart;

impl<'a> Infer<'_, 'a, '_> {
    pub(super) fn ops(&mut self, ops: &'a [Op]) {
        for op in ops {
            match &op.kind {
                OpKind::Call(name, args) => self.call(name, args),
                OpKind::Dynamic { import, overrides, rule, args } => {
                    self.dynamic(import, overrides);
                    self.call(rule, args);
                }
                OpKind::Path(_, args) => self.args(args),
                OpKind::Block(block) => self.call(&block.name, &block.args),
                OpKind::Leaf(_)
                | OpKind::Nil
                | OpKind::Push(_)
                | OpKind::Case(..)
                | OpKind::Chance(..)
                | OpKind::Error => {}
            }
            for part in op.parts() {
                match part {
                    OpPart::Size(size) => self.need(&size.value, Type::Float, "a size"),
                    OpPart::Length(length) => self.need(&length.value, Type::Float, "a length"),
                    OpPart::Depth(depth) => self.need(depth, Type::Float, "a depth"),
                    OpPart::Condition(condition) => self.need(condition, Type::Bool, "`case`"),
                    OpPart::Arm(arm) => self.selector(&arm.selector),
                    OpPart::Ops(ops) => self.ops(ops),
                }
            }
        }
    }

    fn args(&mut self, args: &'a [Arg]) {
        for arg in args {
            self.expr(&arg.value);
        }
    }

    /// Infers the values for attributes of an import.
    fn dynamic(&mut self, import: &'a Name, overrides: &'a [Override]) {
        for own in overrides {
            let Override::Value(name, value) = own else { continue };
            let arg = self.expr(value);
            if let Some(attr) = self.cx.tables.targets.get(&(self.own, name.id())).copied() {
                let attr = self.cx.globals.attrs[attr as usize].key();
                let slot = self.slot(attr);
                self.argument(arg, value.span, slot, (import.text.clone(), name.text.clone()), None);
            }
        }
    }

    fn call(&mut self, name: &'a Name, args: &'a [Arg]) {
        match self.cx.tables.at(self.own).of(name) {
            Some(Use::Operation(row)) => self.operation(row, args),
            Some(own) if self.waits(own) => {
                let args = args.iter().map(|arg| (self.expr(&arg.value), arg.value.span)).collect();
                let candidates = self.candidates(own);
                self.wait(OpenKind::Call(name.clone(), candidates, args), name.span);
            }
            Some(Use::Rule(index)) => {
                let item = self.cx.globals.rules[index as usize].clone();
                let types: Vec<(Var, Span)> = args.iter().map(|arg| (self.expr(&arg.value), arg.value.span)).collect();
                self.arguments(&item, types, Some(name.span));
            }
            Some(Use::SetAttr(index)) => {
                let item = self.cx.globals.attrs[index as usize].clone();
                let (own, Some(value)) = (self.slot(item.key()), args.get(1)) else { return };
                let arg = self.expr(&value.value);
                self.argument(arg, value.value.span, own, ("set".into(), item.decl.name.text.clone()), None);
            }
            Some(Use::SetShape(row)) => {
                if let Some(value) = args.get(1) {
                    let var = self.expr(&value.value);
                    self.need_kind(var, value.value.span, row.kind, &format!("`{}`", row.name));
                }
            }
            _ => self.args(args),
        }
    }

    fn operation(&mut self, row: &'static Operation, args: &'a [Arg]) {
        for (param, arg) in row.params.iter().zip(args) {
            match param.kind {
                // A word that is computed. Other words have no entry in the tables.
                ParamKind::Word(_) => _ = self.expr(&arg.value),
                ParamKind::Selector => self.selector(&arg.value),
                _ => {
                    let var = self.expr(&arg.value);
                    self.builtin_argument(param, row.name, var, arg.value.span);
                }
            }
        }
    }
}
