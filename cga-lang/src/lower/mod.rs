//! A checked tree to [`ir`](crate::ir): names become indices, blocks become rules, constants are folded.

mod body;
mod childless;
mod expr;
mod walk;

use crate::ast::{Body, Decl, Name};
use crate::check::{Checked, Use};
use crate::fold::{Known, fold};
use crate::graph::{components, is_cycle};
use crate::ir::{
    Attr, AttrId, Childless, Const, ConstId, Function, Global, Grammar, Host, HostId, Param, Rule, RuleId, Step, Type,
    Value,
};
use crate::ir_walk::called;
use crate::span::Span;
use crate::token::{Tok, Tokens};
use std::collections::HashMap;

/// Longest text of a rule kept for its doc line, in bytes.
const LONGEST_SOURCE: usize = 400;

/// Lowers a checked tree. `tokens` are those it was parsed from.
pub fn lower(checked: &Checked, tokens: &Tokens) -> Grammar {
    let mut lower = Lower {
        checked,
        tokens,
        params: &[],
        label: "",
        blocks: HashMap::new(),
        hosts: HashMap::new(),
        known: Known::default(),
        out: Grammar::default(),
    };
    lower.hosts();
    lower.globals();
    lower.rules();
    lower.cycles();
    lower.out
}

struct Lower<'c> {
    checked: &'c Checked<'c>,
    tokens: &'c Tokens,
    /// Parameters of the declaration at hand.
    params: &'c [Name],
    /// Name of the rule at hand.
    label: &'c str,
    /// Blocks so far, by the name of their rule.
    blocks: HashMap<&'c str, u32>,
    /// By token.
    hosts: HashMap<u32, HostId>,
    /// Constants and functions whose value is known.
    known: Known,
    out: Grammar,
}

impl<'c> Lower<'c> {
    fn ty(&self, token: u32) -> Type {
        self.checked.tables.types.get(&token).copied().unwrap_or(Type::Float)
    }

    fn used(&self, name: &Name) -> Option<Use> {
        self.checked.tables.of(name)
    }

    fn hosts(&mut self) {
        for (token, tok) in self.tokens.as_slice().iter().enumerate() {
            let token = token as u32;
            if let (Tok::Host(handle), Some(&ty)) = (tok, self.checked.tables.types.get(&token)) {
                self.hosts.insert(token, HostId(self.out.hosts.len() as u32));
                self.out.hosts.push(Host { handle: *handle, ty, span: Span::one(token) });
            }
        }
    }

    fn declared_params(&self, decl: &Decl) -> Vec<Param> {
        let param = |name: &Name| Param { name: name.text.clone(), ty: self.ty(name.id()), span: name.span };
        decl.params.iter().map(param).collect()
    }

    /// Attributes, constants and functions, with the order in which they are ready.
    fn globals(&mut self) {
        let checked = self.checked;
        let globals = &checked.globals;
        for (decl, info) in globals.attrs.iter().zip(&checked.tables.attrs) {
            let default = self.value(decl);
            let (name, span, info) = (decl.name.text.clone(), decl.name.span, info.clone());
            self.out.attrs.push(Attr {
                name,
                ty: default.ty,
                default,
                known: None,
                range: info.range,
                group: info.group,
                doc: info.doc,
                order: info.order,
                hidden: info.hidden,
                is_set: false,
                span,
            });
        }
        for decl in &globals.consts {
            let value = self.value(decl);
            let (name, span) = (decl.name.text.clone(), decl.name.span);
            self.out.consts.push(Const { name, ty: value.ty, value, known: None, span });
        }
        for (index, decl) in globals.functions.iter().enumerate() {
            let body = self.value(decl);
            self.out.functions.push(Function {
                name: decl.name.text.clone(),
                params: self.declared_params(decl),
                ty: body.ty,
                body,
                recursive: checked.tables.recursive.contains(&(index as u32)),
                span: decl.name.span,
            });
        }
        self.fold_values();
    }

    fn value(&mut self, decl: &'c Decl) -> crate::ir::Expr {
        self.params = &decl.params;
        match decl.value() {
            Some(value) => self.expr(value),
            None => crate::ir::Expr {
                kind: crate::ir::ExprKind::Value(Value::Float(0.0)),
                ty: Type::Float,
                span: decl.span,
            },
        }
    }

    fn fold_values(&mut self) {
        let (attrs, consts) = (self.out.attrs.len(), self.out.consts.len());
        let mut known = Known { consts: vec![None; consts], functions: vec![None; self.out.functions.len()] };
        for &node in &self.checked.tables.order {
            if let Some(attr) = self.out.attrs.get_mut(node) {
                attr.known = fold(&mut attr.default, &known);
                self.out.init.push(Global::Attr(AttrId(node as u32)));
            } else if let Some(own) = self.out.consts.get_mut(node - attrs) {
                own.known = fold(&mut own.value, &known);
                known.consts[node - attrs].clone_from(&own.known);
                self.out.init.push(Global::Const(ConstId((node - attrs) as u32)));
            } else if let Some(function) = self.out.functions.get_mut(node - attrs - consts) {
                known.functions[node - attrs - consts] = fold(&mut function.body, &known);
            }
        }
        self.known = known;
    }

    fn rules(&mut self) {
        let checked = self.checked;
        for decl in &checked.globals.rules {
            self.out.rules.push(Rule {
                name: decl.name.text.clone(),
                label: decl.name.text.clone(),
                params: self.declared_params(decl),
                body: Vec::new(),
                leaf: Childless::Always,
                startable: decl.params.is_empty(),
                cycle: None,
                source: self.tokens.text(decl.span, LONGEST_SOURCE),
                span: decl.name.span,
            });
        }
        for (index, decl) in checked.globals.rules.iter().enumerate() {
            if let Body::Rule(ops) = &decl.body {
                self.params = &decl.params;
                self.label = &decl.name.text;
                let body = self.steps(ops);
                self.finish(index, body);
            }
        }
        self.out.start = checked.tables.start.map(RuleId);
    }

    /// Puts a body into its rule.
    fn finish(&mut self, rule: usize, body: Vec<Step>) {
        self.out.rules[rule].leaf = childless::of(&body);
        self.out.rules[rule].body = body;
    }

    fn cycles(&mut self) {
        let edges: Vec<Vec<usize>> =
            self.out.rules.iter().map(|rule| called(&rule.body).iter().map(|id| id.0 as usize).collect()).collect();
        let mut count = 0;
        for component in components(&edges) {
            if is_cycle(&component, &edges) {
                for rule in component {
                    self.out.rules[rule].cycle = Some(count);
                }
                count += 1;
            }
        }
    }
}
