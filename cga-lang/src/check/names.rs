//! Declarations, and what each name in an expression stands for. Steps of rules are in `shapes`.

use super::arity::wrong_count;
use super::{Cx, Door, Use};
use crate::ast::{Decl, Expr, ExprKind, Name};
use crate::code::Code;
use crate::ir::Type;
use crate::ops;
use crate::span::Span;
use crate::suggest::nearest;
use crate::words;
use std::collections::HashMap;

/// Enters every declaration under its name; the second of a name is reported.
pub(super) fn declarations(cx: &mut Cx) {
    let mut values: HashMap<&str, (Use, Span)> = HashMap::new();
    let globals = &mut cx.globals;
    let kinds = [(&globals.attrs, "attribute"), (&globals.consts, "constant"), (&globals.functions, "function")];
    let mut found: Vec<(&Decl, &str, Use)> = Vec::new();
    for (kind, (list, what)) in kinds.into_iter().enumerate() {
        for (index, decl) in list.iter().enumerate() {
            let index = index as u32;
            found.push((*decl, what, [Use::Attr(index), Use::Const(index), Use::Function(index)][kind]));
        }
    }
    found.sort_by_key(|(decl, ..)| decl.name.span);
    for (decl, what, own) in found {
        let name = decl.name.text.as_str();
        if let Use::Function(index) = own {
            let list = globals.functions_named.entry(name).or_default();
            let same = list.iter().find(|(count, _)| *count == decl.params.len());
            let first = same.map(|(_, first)| globals.functions[*first as usize].name.span);
            if let Some(first) = first {
                duplicate(cx.diags, decl, what, first);
                continue;
            }
            list.push((decl.params.len(), index));
            if !decl.params.is_empty() {
                continue;
            }
        }
        match values.get(name) {
            Some((_, first)) => duplicate(cx.diags, decl, what, *first),
            None => _ = values.insert(name, (own, decl.name.span)),
        }
    }
    globals.values = values.into_iter().map(|(name, (own, _))| (name, own)).collect();
    for (index, decl) in globals.rules.iter().enumerate() {
        let list = globals.rules_named.entry(decl.name.text.as_str()).or_default();
        match list.iter().find(|(count, _)| *count == decl.params.len()) {
            Some((_, first)) => duplicate(cx.diags, decl, "rule", globals.rules[*first as usize].name.span),
            None => list.push((decl.params.len(), index as u32)),
        }
        if let Some(row) = ops::operations(&decl.name.text).find(|row| row.takes(decl.params.len())) {
            let message = format!("`{}` is an operation, so this rule could never be called", super::arity::usage(row));
            cx.diags.report(Code::DuplicateName, decl.name.span, message).help("give the rule another name");
        }
    }
    let all = globals.rules.iter().chain(&globals.attrs).chain(&globals.consts).chain(&globals.functions);
    for decl in all {
        for (index, param) in decl.params.iter().enumerate() {
            if let Some(first) = decl.params[..index].iter().find(|first| first.text == param.text) {
                let message = format!("parameter `{}` is declared twice", param.text);
                cx.diags.report(Code::DuplicateName, param.span, message).related("first declared", first.span);
            }
        }
    }
}

fn duplicate(diags: &mut crate::diag::Diags, decl: &Decl, what: &str, first: Span) {
    let params = match decl.params.len() {
        0 => String::new(),
        count => format!(" with {count} parameter{}", if count == 1 { "" } else { "s" }),
    };
    let message = format!("{what} `{}`{params} is declared twice", decl.name.text);
    diags.report(Code::DuplicateName, decl.name.span, message).related("first declared", first);
}

/// Resolves every use.
pub(super) fn uses(cx: &mut Cx) {
    for decl in cx.globals.values().collect::<Vec<_>>() {
        if let Some(value) = decl.value() {
            Scope { cx, params: &decl.params }.expr(value);
        }
    }
    for decl in cx.globals.rules.clone() {
        if let crate::ast::Body::Rule(ops) = &decl.body {
            Scope { cx, params: &decl.params }.ops(ops);
        }
    }
}

/// Where names are looked up: the parameters of one declaration, then everything global.
pub(super) struct Scope<'s, 'a, 'd> {
    pub(super) cx: &'s mut Cx<'a, 'd>,
    pub(super) params: &'a [Name],
}

impl<'a> Scope<'_, 'a, '_> {
    pub(super) fn note(&mut self, name: &Name, found: Use) {
        self.cx.tables.uses.insert(name.id(), found);
    }

    pub(super) fn expr(&mut self, expr: &'a Expr) {
        match &expr.kind {
            ExprKind::Number(_) | ExprKind::Bool(_) | ExprKind::Text(_) | ExprKind::Host(_) | ExprKind::Error => {}
            ExprKind::Name(name) => self.name(name),
            ExprKind::Call(name, args) => self.call(name, args),
            ExprKind::Path(_, args) => self.exprs(args),
            ExprKind::Unary(_, operand) => self.expr(operand),
            ExprKind::Binary(_, _, left, right) => {
                self.expr(left);
                self.expr(right);
            }
            ExprKind::Case(arms, otherwise) => {
                for (condition, value) in arms {
                    self.expr(condition);
                    self.expr(value);
                }
                self.expr(otherwise);
            }
            ExprKind::EachUnary(..)
            | ExprKind::Each(..)
            | ExprKind::Array(_)
            | ExprKind::Range(..)
            | ExprKind::Index(..)
            | ExprKind::Comp(_) => {
                self.cx.diags.report(Code::Unsupported, expr.span, "arrays are not supported yet");
            }
            ExprKind::Chance(arms, otherwise) => {
                self.percentages(arms.iter().map(|(percent, _)| percent));
                for (_, value) in arms {
                    self.expr(value);
                }
                self.expr(otherwise);
            }
        }
    }

    fn exprs(&mut self, list: &'a [Expr]) {
        for expr in list {
            self.expr(expr);
        }
    }

    /// What a bare name stands for, if anything.
    pub(super) fn lookup(&self, name: &str) -> Option<Use> {
        if let Some(index) = self.params.iter().position(|param| param.text == name) {
            return Some(Use::Param(index as u32));
        }
        let global = self.cx.globals.values.get(name).copied();
        global
            .or_else(|| ops::functions(name).find(|row| row.takes(0)).map(Use::Builtin))
            .or_else(|| ops::shape_attr(name).map(Use::Shape))
    }

    fn name(&mut self, name: &'a Name) {
        match self.lookup(&name.text) {
            Some(found) => self.note(name, found),
            None => self.unknown_name(name),
        }
    }

    fn unknown_name(&mut self, name: &'a Name) {
        let (text, globals) = (name.text.as_str(), &self.cx.globals);
        if globals.lost.contains(text) {
            return;
        }
        if words::is_later_attribute(text) || words::is_later_function(text) {
            self.cx.diags.report(Code::Unsupported, name.span, format!("`{text}` is not supported yet"));
            return;
        }
        if let Some(list) = globals.functions_named.get(text) {
            let takes = list.iter().map(|(count, _)| *count).collect();
            return wrong_count(self.cx, "function", name, takes, 0);
        }
        if ops::functions(text).next().is_some() || text == "str" {
            let takes = counts_of(text);
            return wrong_count(self.cx, "function", name, if takes.is_empty() { vec![1] } else { takes }, 0);
        }
        let is_rule = globals.rules_named.contains_key(text);
        let params = self.params.iter().map(|param| param.text.as_str());
        let names = params.chain(globals.values.keys_sorted()).chain(ops::all_shape_attrs().map(|row| row.name));
        let near = nearest(text, names).map(str::to_owned);
        let (inline, dotted) = (self.cx.door == Door::Inline, text.contains('.'));
        let diag = self.cx.diags.report(Code::UnknownName, name.span, format!("unknown name `{text}`"));
        if is_rule {
            diag.note(format!("`{text}` is a rule: it makes shapes, it has no value"));
        }
        let suggested = near.is_some();
        diag.suggest(near);
        if inline && !dotted && !suggested {
            diag.help(format!("write `#{text}` for a Rust value"));
        } else if text
            .split_once('.')
            .is_some_and(|(first, _)| !ops::all_shape_attrs().any(|row| row.name.starts_with(first)))
        {
            diag.note("names with a dot belong to imports, which are not supported yet");
        }
    }

    fn call(&mut self, name: &'a Name, args: &'a [Expr]) {
        self.exprs(args);
        let text = name.text.as_str();
        if let Some(index) = self.cx.globals.function(text, args.len()) {
            return self.note(name, Use::Function(index));
        }
        if args.len() == 1
            && let Some(ty) = conversion(text)
        {
            return self.note(name, Use::Convert(ty));
        }
        if let Some(row) = ops::functions(text).find(|row| row.takes(args.len())) {
            return self.note(name, Use::Builtin(row));
        }
        if self.cx.globals.lost.contains(text) || args.iter().any(|arg| matches!(arg.kind, ExprKind::Error)) {
            return;
        }
        let mut takes = counts_of(text);
        takes.extend(self.cx.globals.functions_named.get(text).into_iter().flatten().map(|(count, _)| *count));
        takes.extend(conversion(text).map(|_| 1));
        if !takes.is_empty() {
            return wrong_count(self.cx, "function", name, takes, args.len());
        }
        if words::is_later_function(text) {
            self.cx.diags.report(Code::Unsupported, name.span, format!("function `{text}` is not supported yet"));
            return;
        }
        if let Some(found) = self.lookup(text) {
            let what = match found {
                Use::Param(_) => "a parameter",
                Use::Attr(_) => "an attribute",
                Use::Const(_) => "a constant",
                _ => "an attribute of the shape",
            };
            let message = format!("`{text}` is {what}, it takes no arguments");
            self.cx.diags.report(Code::ArgumentCount, name.span, message).help(format!("write `{text}`"));
            return;
        }
        let functions = self.cx.globals.functions_named.keys_sorted();
        let names = functions.chain(ops::all_functions().map(|row| row.name)).chain(["str"]);
        let near = nearest(text, names).map(str::to_owned);
        let shape = ops::operations(text).next().is_some() || self.cx.globals.rules_named.contains_key(text);
        let diag = self.cx.diags.report(Code::UnknownFunction, name.span, format!("unknown function `{text}`"));
        if shape {
            diag.note(format!("`{text}` works on shapes, it has no value"));
        } else {
            diag.suggest(near);
        }
    }

    /// Percentages of one block may not add up to more than 100.
    pub(super) fn percentages(&mut self, list: impl Iterator<Item = &'a crate::ast::Percent>) {
        let mut sum = 0.0;
        for percent in list {
            sum += percent.value;
            // Written fractions like 33.3 add up with an error in the last digits.
            if 100.0 + 1e-9 < sum {
                let message = format!("the percentages up to here add up to {}", (sum * 1e6).round() / 1e6);
                self.cx.diags.report(Code::PercentOver100, percent.span, message);
                return;
            }
        }
    }
}

/// Numbers of arguments a function of the language can take.
fn counts_of(name: &str) -> Vec<usize> {
    ops::functions(name).flat_map(|row| ops::required(row.params)..=row.params.len()).collect()
}

/// The type a conversion function gives.
fn conversion(name: &str) -> Option<Type> {
    match name {
        "float" => Some(Type::Float),
        "bool" => Some(Type::Bool),
        "str" => Some(Type::Text),
        _ => None,
    }
}

/// Keys in alphabetical order, so that messages do not depend on hashing.
pub(super) trait KeysSorted<'k> {
    /// The keys.
    fn keys_sorted(&self) -> std::vec::IntoIter<&'k str>;
}

impl<'k, V> KeysSorted<'k> for HashMap<&'k str, V> {
    fn keys_sorted(&self) -> std::vec::IntoIter<&'k str> {
        let mut keys: Vec<&str> = self.keys().copied().collect();
        keys.sort_unstable();
        keys.into_iter()
    }
}
