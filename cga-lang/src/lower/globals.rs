//! Attributes, constants and functions, with the order in which they are ready.

use super::{Lower, merge};
use crate::ir::{Expr, ExprKind, Function, FunctionId, Global, GlobalId, Type, Value};
use crate::lower::fold::{Folded, fold};
use crate::resolve::globals::{Declared, Initializer};
use std::collections::HashMap;

impl<'c> Lower<'c> {
    pub(super) fn globals(&mut self) {
        let globals = &self.checked.globals;
        // Values with locals become functions after the functions of the grammar.
        for (index, item) in globals.functions.iter().enumerate() {
            let function = self.function(item, self.checked.tables.recursive.contains(&(index as u32)));
            self.push_function(function, self.style(item));
        }
        for (index, item) in globals.attrs.iter().chain(&globals.consts).enumerate() {
            let lazy = self.checked.tables.lazy.contains(&index);
            let value = self.value(item, lazy);
            let attr = self.checked.tables.attrs.get(index).cloned();
            self.owners.globals.push(self.style(item));
            self.out.globals.push(Global {
                name: item.name.clone(),
                ty: self.type_of(item),
                value,
                known: None,
                is_set: false,
                lazy,
                // The attributes of an import that is computed again are values of shapes.
                public: attr.is_some() && globals.program.instances[item.instance].layers.len() <= 1,
                attr,
                span: item.decl.name.span,
            });
        }
        self.fold_values();
    }

    fn push_function(&mut self, function: Function, style: u32) {
        self.out.functions.push(function);
        self.owners.functions.push(style);
    }

    fn function(&mut self, item: &Declared<'c>, recursive: bool) -> Function {
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
    fn value(&mut self, item: &Declared<'c>, lazy: bool) -> Expr {
        if let Initializer::Flows(outer) = item.init {
            let ty = self.type_of(item);
            return Expr { kind: ExprKind::Global(GlobalId(outer)), ty, span: item.decl.name.span };
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

    fn value_itself(&mut self, item: &Declared<'c>) -> Expr {
        match item.value() {
            Some((value, _)) => self.expr(value),
            None => Expr { kind: ExprKind::Value(Value::Float(0.0)), ty: Type::Float, span: item.decl.span },
        }
    }

    /// Returns true if a run needs the value of an attribute or constant. The value that an overridden attribute would have
    /// without the override is only needed if something reads it.
    pub(super) fn is_needed(&self, id: GlobalId) -> bool {
        let globals = &self.checked.globals;
        (id.0 as usize)
            .checked_sub(globals.attrs.len())
            .is_none_or(|index| !globals.consts[index].origin || self.checked.tables.origins.contains(&(index as u32)))
    }

    fn fold_values(&mut self) {
        let mut known = self.known_in_a_style();
        agree(&mut known.globals, &merge::globals(&self.out.globals, &self.owners.globals));
        agree(&mut known.functions, &merge::functions(&self.out.functions, &self.owners.functions));
        for (own, agreed) in self.out.globals.iter_mut().zip(&known.globals) {
            let folded = fold(&mut own.value, &known);
            own.known = if own.attr.is_some() { folded } else { agreed.clone() };
            own.lazy &= own.attr.is_some() || agreed.is_none();
            if let Some(value) = agreed {
                own.value.kind = ExprKind::Value(value.clone());
            }
        }
        for function in &mut self.out.functions {
            fold(&mut function.body, &known);
        }
        self.known = known;
        self.init = vec![Vec::new(); self.checked.globals.program.roots.len()];
        for &node in &self.checked.tables.order {
            let id = GlobalId(node as u32);
            if let Some(&style) = self.owners.globals.get(node)
                && self.is_needed(id)
            {
                self.init[style as usize].push(id);
            }
        }
    }

    /// Values of constants and functions in their style.
    fn known_in_a_style(&self) -> Folded {
        let (globals, functions) = (&self.out.globals, &self.out.functions);
        let mut known = Folded { globals: vec![None; globals.len()], functions: vec![None; functions.len()] };
        for &node in &self.checked.tables.order {
            if let Some(own) = globals.get(node) {
                known.globals[node] = if own.attr.is_none() { fold(&mut own.value.clone(), &known) } else { None };
            } else if let Some(function) = functions.get(node - globals.len()).filter(|it| it.locals.is_empty()) {
                known.functions[node - globals.len()] = fold(&mut function.body.clone(), &known);
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
