//! Attributes, constants and functions, with the order in which they are ready.

use super::{Lower, merge};
use crate::ir::{Attr, AttrId, Const, ConstId, Expr, ExprKind, Function, FunctionId, Global, Type, Value};
use crate::lower::fold::{Folded, fold};
use crate::resolve::globals::{Init, Item};
use std::collections::HashMap;

impl<'c> Lower<'c> {
    pub(super) fn globals(&mut self) {
        let globals = &self.checked.globals;
        // Values with locals become functions after those of the grammar.
        for (index, item) in globals.functions.iter().enumerate() {
            let function = self.function(item, self.checked.tables.recursive.contains(&(index as u32)));
            self.push_function(function, self.style(item));
        }
        for (index, (item, info)) in globals.attrs.iter().zip(&self.checked.tables.attrs).enumerate() {
            let lazy = self.checked.tables.lazy.contains(&index);
            let default = self.value(item, lazy);
            let dynamic = 1 < globals.program.instances[item.instance].layers.len();
            self.out.attrs.push(Attr {
                name: item.name.clone(),
                ty: self.type_of(item),
                default,
                known: None,
                info: info.clone(),
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

    fn push_function(&mut self, function: Function, style: u32) {
        self.out.functions.push(function);
        self.owners.functions.push(style);
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
            sites: 0,
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
            self.push_function(function, self.style(item));
            return Expr { kind: ExprKind::Call(id, Vec::new(), Vec::new()), ty, span: item.decl.name.span };
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
        self.owners.attrs = globals.attrs.iter().map(|item| self.style(item)).collect();
        self.owners.consts = globals.consts.iter().map(|item| self.style(item)).collect();
        let mut known = self.known_in_a_style();
        let consts = merge::numbers(&self.out.consts, &self.owners.consts, |it| (it.name.clone(), it.ty));
        agree(&mut known.consts, &consts);
        agree(&mut known.functions, &merge::functions(&self.out.functions, &self.owners.functions));
        for attr in &mut self.out.attrs {
            attr.known = fold(&mut attr.default, &known);
        }
        for (own, known_value) in self.out.consts.iter_mut().zip(&known.consts) {
            fold(&mut own.value, &known);
            own.known.clone_from(known_value);
            own.lazy &= own.known.is_none();
            if let Some(value) = known_value {
                own.value.kind = ExprKind::Value(value.clone());
            }
        }
        for function in &mut self.out.functions {
            fold(&mut function.body, &known);
        }
        self.known = known;
        self.init = vec![Vec::new(); globals.program.roots.len()];
        for &node in &self.checked.tables.order {
            if let Some(&style) = self.owners.attrs.get(node) {
                self.init[style as usize].push(Global::Attr(AttrId(node as u32)));
            } else if let Some(&style) = self.owners.consts.get(node - globals.attrs.len())
                && self.is_needed(node - globals.attrs.len())
            {
                self.init[style as usize].push(Global::Const(ConstId((node - globals.attrs.len()) as u32)));
            }
        }
    }

    /// Values of constants and functions in their style.
    fn known_in_a_style(&self) -> Folded {
        let (attrs, consts, functions) = (self.out.attrs.len(), &self.out.consts, &self.out.functions);
        let mut known = Folded { consts: vec![None; consts.len()], functions: vec![None; functions.len()] };
        for index in self.checked.tables.order.iter().filter_map(|node| node.checked_sub(attrs)) {
            if let Some(own) = consts.get(index) {
                known.consts[index] = fold(&mut own.value.clone(), &known);
            } else if let Some(function) = functions.get(index - consts.len()).filter(|it| it.locals.is_empty()) {
                known.functions[index - consts.len()] = fold(&mut function.body.clone(), &known);
            }
        }
        known
    }
}

/// Keeps the values that are equal in all styles.
fn agree(known: &mut [Option<Value>], numbers: &[usize]) {
    let mut first: HashMap<usize, Option<Value>> = HashMap::new();
    for (value, number) in known.iter().zip(numbers) {
        let first = first.entry(*number).or_insert_with(|| value.clone());
        if first != value {
            *first = None;
        }
    }
    for (value, number) in known.iter_mut().zip(numbers) {
        value.clone_from(&first[number]);
    }
}
