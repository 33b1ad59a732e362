//! Attributes, constants and functions, with the order in which they are ready.

use super::Lower;
use crate::fold::{Known, fold};
use crate::ir::{Attr, AttrId, Const, ConstId, Expr, ExprKind, Function, FunctionId, Global, Type, Value};
use crate::resolve::globals::{Init, Item};

impl<'c> Lower<'c> {
    pub(super) fn globals(&mut self) {
        let globals = &self.checked.globals;
        // Values with locals become functions behind those of the grammar, so these come first.
        for (index, item) in globals.functions.iter().enumerate() {
            let function = self.function(item, self.checked.tables.recursive.contains(&(index as u32)));
            self.out.functions.push(function);
        }
        for (index, (item, info)) in globals.attrs.iter().zip(&self.checked.tables.attrs).enumerate() {
            let lazy = self.checked.tables.lazy.contains(&index);
            let default = self.value(item, lazy);
            let info = info.clone();
            let dynamic = 1 < globals.program.instances[item.instance].layers.len();
            self.out.attrs.push(Attr {
                name: item.name.clone(),
                ty: self.type_of(item),
                default,
                known: None,
                range: info.range,
                choices: info.choices,
                presentation: info.presentation,
                display_name: info.display_name,
                group: info.group.names,
                group_order: info.group.order,
                doc: info.doc,
                order: info.order,
                hidden: info.hidden,
                is_set: false,
                lazy,
                public: !dynamic,
                span: item.decl.name.span,
            });
        }
        for (index, item) in globals.consts.iter().enumerate() {
            let lazy = self.checked.tables.lazy.contains(&(globals.attrs.len() + index));
            let value = self.value(item, lazy);
            let (name, span) = (item.name.clone(), item.decl.name.span);
            self.out.consts.push(Const { name, ty: value.ty, value, known: None, is_set: false, lazy, span });
        }
        self.fold_values();
    }

    fn function(&mut self, item: &Item<'c>, recursive: bool) -> Function {
        self.enter(item);
        let locals = self.locals(item.decl);
        let body = self.value_itself(item);
        Function {
            name: item.name.clone(),
            params: self.declared_params(),
            locals,
            ty: body.ty,
            body,
            recursive,
            span: item.decl.name.span,
        }
    }

    /// The value of an attribute or constant. Locals make a function of it, which is part of the cycle of a lazy one.
    fn value(&mut self, item: &Item<'c>, lazy: bool) -> Expr {
        if let Init::Flows(outer) = item.init {
            let ty = self.type_of(item);
            return Expr { kind: ExprKind::Attr(AttrId(outer)), ty, span: item.decl.name.span };
        }
        if item.is_own() && !item.decl.locals.is_empty() {
            let function = self.function(item, lazy);
            let (id, ty) = (FunctionId(self.out.functions.len() as u32), function.ty);
            self.out.functions.push(function);
            return Expr { kind: ExprKind::Call(id, Vec::new()), ty, span: item.decl.name.span };
        }
        self.inner.clear();
        self.own = item.value().map_or(item.own, |(_, own)| own);
        self.value_itself(item)
    }

    fn value_itself(&mut self, item: &Item<'c>) -> Expr {
        match item.value() {
            Some((value, _)) => self.expr(value),
            None => Expr { kind: ExprKind::Value(Value::Float(0.0)), ty: Type::Float, span: item.decl.span },
        }
    }

    /// Whether somebody may ask for a constant. What an overridden attribute would have been matters only where somebody
    /// does.
    pub(super) fn is_needed(&self, index: usize) -> bool {
        !self.checked.globals.consts[index].origin || self.checked.tables.origins.contains(&(index as u32))
    }

    fn fold_values(&mut self) {
        let globals = &self.checked.globals;
        let (attrs, consts) = (self.out.attrs.len(), self.out.consts.len());
        let mut known = Known { consts: vec![None; consts], functions: vec![None; self.out.functions.len()] };
        self.out.init = vec![Vec::new(); globals.program.roots.len()];
        let style = |item: &Item| globals.program.instances[item.instance].root_style as usize;
        for &node in &self.checked.tables.order {
            if let Some(attr) = self.out.attrs.get_mut(node) {
                attr.known = fold(&mut attr.default, &known);
                self.out.init[style(&globals.attrs[node])].push(Global::Attr(AttrId(node as u32)));
            } else if let Some(own) = self.out.consts.get_mut(node - attrs) {
                let index = node - attrs;
                own.known = fold(&mut own.value, &known);
                own.lazy &= own.known.is_none();
                known.consts[index].clone_from(&own.known);
                if self.is_needed(index) {
                    self.out.init[style(&globals.consts[index])].push(Global::Const(ConstId(index as u32)));
                }
            } else if let Some(function) = self.out.functions.get_mut(node - attrs - consts) {
                known.functions[node - attrs - consts] =
                    fold(&mut function.body, &known).filter(|_| function.locals.is_empty());
            }
        }
        self.known = known;
    }
}
