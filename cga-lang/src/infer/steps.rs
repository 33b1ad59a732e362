//! Types in the operations of rules.

use super::open::Open;
use super::{Infer, Type, Use, Var};
use crate::ops::{Operation, ParamKind};
use crate::span::Span;
use crate::syntax::ast::{Arg, BlockPart, Name, Op, OpKind, Override, SplitItem};

impl<'a> Infer<'_, 'a, '_> {
    pub(super) fn ops(&mut self, ops: &'a [Op]) {
        for op in ops {
            match &op.kind {
                OpKind::Leaf(_) | OpKind::Nil | OpKind::Error => {}
                OpKind::Call(name, args) => self.call(name, args),
                OpKind::Dynamic { import, overrides, rule, args } => {
                    self.dynamic(import, overrides);
                    self.call(rule, args);
                }
                OpKind::Path(_, args) => self.args(args),
                OpKind::Push(ops) => self.ops(ops),
                OpKind::Block(block) => {
                    self.call(&block.name, &block.args);
                    for part in &block.parts {
                        match part {
                            BlockPart::Slots(items, _) => self.items(items),
                            BlockPart::Sections(list, _) => {
                                for section in list {
                                    self.need(&section.length.value, Type::Float, "a length");
                                    self.need(&section.depth, Type::Float, "a depth");
                                    self.ops(&section.ops);
                                }
                            }
                            BlockPart::Arms(arms) => {
                                for arm in arms {
                                    self.selector(&arm.selector);
                                    self.ops(&arm.ops);
                                }
                            }
                            BlockPart::Ops(list) => list.iter().for_each(|ops| self.ops(ops)),
                        }
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

    fn args(&mut self, args: &'a [Arg]) {
        for arg in args {
            self.expr(&arg.value);
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
            Some(own @ Use::Rule(_)) if self.is_generic(own) => {
                let args = args.iter().map(|arg| (self.expr(&arg.value), arg.value.span)).collect();
                let candidates = vec![self.candidate(own)];
                self.wait_for(Open::Call { name: name.clone(), candidates, args, result: None });
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
            Some(Use::Open(open)) => {
                let args = args.iter().map(|arg| (self.expr(&arg.value), arg.value.span)).collect();
                let candidates = self.candidates(open);
                self.wait_for(Open::Call { name: name.clone(), candidates, args, result: None });
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
