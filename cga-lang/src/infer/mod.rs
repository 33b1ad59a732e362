//! Type inference: floats, bools, strings and arrays of these.
//!
//! Types are never written: every declaration and parameter has one type, inferred from its uses and from the
//! calls. Bodies come first and calls last, so that a wrong argument is blamed at the call. Unclear expressions (`+`,
//! overloaded calls, arrays) wait in `open` until more is known. If one type is not enough, `generic` requests
//! instances of declarations with other types.

mod comp;
mod expr;
mod generic;
mod open;
mod steps;
mod unify;

use crate::diag::code::Code;
use crate::diag::{Diag, Line};
use crate::dialect::Dialect;
use crate::hash::FastMap;
use crate::link::{InstanceId, Key, Wanted};
use crate::ops::ParamKind;
use crate::resolve::context::Context;
use crate::resolve::globals::{Declared, Initializer};
use crate::resolve::tables::Use;
use crate::span::Span;
use crate::syntax::ast::{Body, Decl, Expr, Name};
use crate::syntax::lex::without_unit;
use crate::syntax::token::Tok;
use crate::types::Type;
use generic::Stage;
use open::{Open, TypeUse};
use std::collections::HashSet;
use unify::{Var, VarState, Vars};

/// The result of `infer`.
pub(crate) struct Inferred {
    /// True if a value has another type than needed.
    pub(crate) misfit: bool,
    /// Requests for declarations with other types. With requests, the remaining types are not settled.
    pub(crate) wanted: Vec<Wanted>,
    /// Instances of declarations with their own types that have a mismatch of their own.
    pub(crate) unsuited: Vec<InstanceId>,
}

pub(crate) fn infer(cx: &mut Context) -> Inferred {
    let before = cx.diags.so_far().len();
    let mut pass = Infer {
        cx,
        vars: Vars::default(),
        slots: FastMap::default(),
        open: Vec::new(),
        calls: Vec::new(),
        ordered: Vec::new(),
        selectors: Vec::new(),
        components: Vec::new(),
        inner: Vec::new(),
        own: 0,
        stage: Stage::Bodies,
        moved: false,
        wanted: Vec::new(),
        misfits: Vec::new(),
    };
    let values: Vec<_> = pass.cx.globals.values().cloned().collect();
    for item in &values {
        let own = item.value().map_or(item.own, |(_, own)| own);
        pass.inside(own, |pass| pass.declared(item));
    }
    for item in pass.cx.globals.rules.clone() {
        if let Body::Rule(ops) = &item.decl.body {
            pass.inside(item.own, |pass| {
                pass.inner.clear();
                pass.enter(item.decl);
                pass.ops(ops);
            });
        }
    }
    pass.solve();
    pass.store();
    let unsuited = if pass.wanted.is_empty() { pass.unsuited() } else { Vec::new() };
    let wanted = pass.wanted;
    let misfit = |diag: &Diag| matches!(diag.code, Code::TypeMismatch | Code::UndefinedRule);
    Inferred { misfit: cx.diags.so_far()[before..].iter().any(misfit), wanted, unsuited }
}

/// A type mismatch: its instance, place and message.
type Misfit = (InstanceId, Span, Line);

/// An argument of a rule or function of the grammar. It is joined with the parameter once all bodies are read.
struct Argument {
    /// The instance that contains the call.
    own: InstanceId,
    arg: Var,
    span: Span,
    param: Var,
    callee: String,
    name: String,
    /// The name, if a rule is called.
    rule: Option<Span>,
}

struct Infer<'p, 'a, 'd> {
    cx: &'p mut Context<'a, 'd>,
    vars: Vars,
    /// Types of declarations, parameters and locals by name; of Rust values and Rust calls by their first token.
    slots: FastMap<Key, Var>,
    /// Open expressions; `None` once they are decided.
    open: Vec<Option<Open>>,
    calls: Vec<Argument>,
    /// Operands of `<`, `<=`, `>` and `>=`, which bools do not have.
    ordered: Vec<(InstanceId, Var, Span)>,
    /// Selectors, which are checked once their types are known.
    selectors: Vec<(InstanceId, Var, &'a Expr)>,
    /// Values of components, which cannot be arrays.
    components: Vec<(InstanceId, TypeUse)>,
    /// The parameters and locals of the current declaration.
    inner: Vec<&'a Name>,
    /// The instance that has the entries of its names.
    own: InstanceId,
    stage: Stage,
    /// True if a type became known without a decision.
    moved: bool,
    wanted: Vec<Wanted>,
    /// Mismatches, collected if declarations may have types of their own.
    misfits: Vec<Misfit>,
}

impl<'a> Infer<'_, 'a, '_> {
    /// Runs a part of the work in an instance, and records the mismatches found there.
    fn inside<T>(&mut self, own: InstanceId, part: impl FnOnce(&mut Self) -> T) -> T {
        let outside = std::mem::replace(&mut self.own, own);
        let before = self.cx.diags.so_far().len();
        let result = part(self);
        self.own = outside;
        if self.cx.globals.program.typed.on {
            let found = self.cx.diags.so_far()[before..].iter().filter(|diag| diag.code == Code::TypeMismatch);
            self.misfits.extend(found.map(|diag| (own, diag.span, diag.message.clone())));
        }
        result
    }

    /// The instances with their own types that have mismatches which the declaration as written does not have.
    fn unsuited(&self) -> Vec<InstanceId> {
        let program = self.cx.globals.program;
        let (typed, written): (Vec<&Misfit>, Vec<&Misfit>) =
            self.misfits.iter().partition(|(own, ..)| program.is_typed(*own));
        let written: HashSet<(Span, &Line)> = written.into_iter().map(|(_, span, text)| (*span, text)).collect();
        let alone = typed.into_iter().filter(|(_, span, text)| !written.contains(&(*span, text)));
        alone.map(|(own, ..)| *own).collect()
    }

    /// Infers the value of an attribute, constant or function.
    fn declared(&mut self, item: &Declared<'a>) {
        let own = self.slot(item.key());
        if let Initializer::Flows(outer) = item.init {
            // The value comes from the importing file.
            let from = self.cx.globals.attrs[outer as usize].clone();
            let var = self.slot(from.key());
            self.argument(var, from.decl.name.span, own, (String::new(), item.decl.name.text.clone()), None);
        }
        let Some((value, _)) = item.value() else { return };
        self.inner.clear();
        if item.is_own() {
            self.enter(item.decl);
        }
        let ty = self.expr(value);
        if !item.is_own() {
            // The declaration defines the type, and a wrong override is blamed.
            return self.argument(ty, value.span, own, (String::new(), item.decl.name.text.clone()), None);
        }
        // This only fails for a recursive function that was used with another type inside its own body.
        if let Err((own, other)) = self.vars.join(own, ty) {
            let name = &item.decl.name.text;
            let needs = format!("`{name}` is used as a {}, but this is", own.word());
            self.mismatch(value.span, &needs, other);
        }
        if self.vars.state(ty) == VarState::Poison {
            let var = self.poison();
            self.slots.insert(item.key(), var);
        }
    }

    fn slot(&mut self, key: Key) -> Var {
        if let Some(&var) = self.slots.get(&key) {
            return var;
        }
        let given = self.cx.globals.program.typed.given(key);
        let var = self.vars.add(given.map_or(VarState::Free, VarState::Is), None);
        self.slots.insert(key, var);
        var
    }

    /// The type of a name or Rust value in the current declaration.
    fn inner_slot(&mut self, token: u32) -> Var {
        self.slot((self.own, token))
    }

    /// The types of the parameters of a declaration.
    fn params(&mut self, item: &Declared) -> Vec<Var> {
        item.decl.params.iter().map(|param| self.slot((item.own, param.id()))).collect()
    }

    fn free(&mut self) -> Var {
        self.vars.add(VarState::Free, None)
    }

    fn poison(&mut self) -> Var {
        self.vars.add(VarState::Poison, None)
    }

    fn known(&mut self, ty: Type, span: Span) -> Var {
        self.vars.add(VarState::Is(ty), Some(span))
    }

    /// Enters parameters and locals as names; locals get the types of their values.
    fn enter(&mut self, decl: &'a Decl) {
        self.inner.extend(&decl.params);
        for (name, value) in &decl.locals {
            let ty = self.expr(value);
            let slot = self.inner_slot(name.id());
            _ = self.vars.join(slot, ty);
            self.inner.push(name);
        }
    }

    fn mismatch(&mut self, span: Span, needs: &str, got: Type) -> &mut Diag {
        self.cx.diags.report(Code::TypeMismatch, span, format!("{needs} a {}", got.word()))
    }

    /// Requires a type of an expression.
    fn need(&mut self, expr: &'a Expr, ty: Type, who: &str) {
        let var = self.expr(expr);
        self.need_var(var, expr.span, ty, who);
    }

    fn need_var(&mut self, var: Var, span: Span, ty: Type, who: &str) {
        self.need_kind(var, span, ParamKind::Value(ty), who);
    }

    /// Requires the type of a kind of value.
    fn need_kind(&mut self, var: Var, span: Span, kind: ParamKind, who: &str) {
        let Some(ty) = kind.ty() else { return };
        if self.vars.bind(var, ty, span) {
            return;
        }
        let Some(got) = self.vars.known(var) else { return };
        let why = self.vars.why(var).filter(|why| *why != span);
        let message = format!("{who} needs a {}, got a {}", ty.word(), got.word());
        let literal = self.cx.globals.program.tokens.as_slice().get(span.first as usize);
        let help = conversion(kind, got, literal.filter(|_| span.first == span.last), |name| {
            self.cx.globals.value(self.cx.at, name).is_some()
        });
        let diag = self.cx.diags.report(Code::TypeMismatch, span, message);
        if let Some(why) = why {
            diag.related(format!("found to be a {}", got.word()), why);
        }
        if let Some(help) = help {
            diag.help(help);
        }
    }

    fn argument(&mut self, arg: Var, span: Span, param: Var, (callee, name): (String, String), rule: Option<Span>) {
        self.calls.push(Argument { own: self.own, arg, span, param, callee, name, rule });
    }

    /// Adds the arguments of a call of a declaration.
    fn arguments(&mut self, item: &Declared, args: Vec<TypeUse>, rule: Option<Span>) {
        let params = self.params(item);
        for (((arg, span), var), param) in args.into_iter().zip(params).zip(&item.decl.params) {
            self.argument(arg, span, var, (item.decl.name.text.clone(), param.text.clone()), rule);
        }
    }

    /// Reports a call whose argument types no rule of that name takes. The call matches no rule, so in text it is a
    /// leaf, like a call with a wrong number of arguments.
    fn no_rule(&mut self, name: Span, callee: &str, span: Span, message: String) -> Option<&mut Diag> {
        let dialect = self.cx.globals.program.dialect(name.first);
        if dialect == Dialect::Inline {
            return Some(self.cx.diags.report(Code::TypeMismatch, span, message));
        }
        // One diagnostic per call.
        if self.cx.tables.uses.insert((self.own, name.first), Use::Leaf) == Some(Use::Leaf) {
            return None;
        }
        let diag = self.cx.diags.report(Code::UndefinedRule, span, message);
        Some(diag.note(format!("no rule takes these types, so it becomes a leaf named `{callee}`")))
    }

    fn solve(&mut self) {
        self.propagate();
        self.stage = Stage::Calls;
        if self.cx.globals.program.typed.on {
            self.propagate();
        }
        for index in 0..self.calls.len() {
            self.join_argument(index);
        }
        self.join_styles();
        self.propagate();
        if self.cx.globals.program.typed.on {
            self.stage = Stage::Wanting;
            self.propagate();
            if !self.wanted.is_empty() {
                return;
            }
        }
        self.settle();
        for (own, var, span) in std::mem::take(&mut self.ordered) {
            if let Some(ty @ (Type::Bool | Type::Bools)) = self.vars.known(var) {
                let message = format!("{} have no order", if ty == Type::Bool { "bools" } else { "arrays of bools" });
                self.inside(own, |pass| {
                    pass.cx.diags.report(Code::TypeMismatch, span, message).help("write `==` or `!=`");
                });
            }
        }
        self.comps();
    }

    /// Joins the types of each value and its parameters over all styles. `duplicates` reports differences.
    fn join_styles(&mut self) {
        let mut pairs = Vec::new();
        for group in self.cx.globals.by_style() {
            let names = |item: &Declared<'a>| [&item.decl.name].into_iter().chain(&item.decl.params);
            for other in &group[1..] {
                let keys = names(group[0]).zip(names(other));
                pairs.extend(keys.map(|(first, own)| ((group[0].own, first.id()), (other.own, own.id()))));
            }
        }
        pairs.sort_unstable();
        for (first, other) in pairs {
            let (first, other) = (self.slot(first), self.slot(other));
            _ = self.vars.join(first, other);
        }
    }

    fn join_argument(&mut self, index: usize) {
        let Argument { own, arg, param, .. } = self.calls[index];
        if let Err((got, needs)) = self.vars.join(arg, param) {
            self.inside(own, |pass| pass.wrong_argument(index, got, needs));
        }
    }

    fn wrong_argument(&mut self, index: usize, got: Type, needs: Type) {
        let Argument { span, param, rule, ref callee, ref name, .. } = self.calls[index];
        let message = match callee.as_str() {
            "" => format!("`{name}` of the imported file is a {}, this is a {}", needs.word(), got.word()),
            "set" => format!("`{name}` is a {}, got a {}", needs.word(), got.word()),
            _ => format!("`{name}` of `{callee}` is a {}, got a {}", needs.word(), got.word()),
        };
        let why = self.vars.why(param).filter(|why| *why != span);
        let callee = callee.clone();
        let diag = match rule {
            Some(call) => self.no_rule(call, &callee, span, message),
            None => Some(self.cx.diags.report(Code::TypeMismatch, span, message)),
        };
        if let (Some(diag), Some(why)) = (diag, why) {
            diag.related(format!("found to be a {}", needs.word()), why);
        }
    }

    fn store(&mut self) {
        let slots: Vec<(Key, Var)> = self.slots.iter().map(|(key, var)| (*key, *var)).collect();
        for (key, var) in slots {
            let ty = match self.vars.state(var) {
                VarState::Is(ty) => ty,
                VarState::Free => Type::Float,
                VarState::Poison => continue,
            };
            self.cx.tables.types.insert(key, ty);
        }
        for item in self.cx.globals.items() {
            for param in &item.decl.params {
                self.cx.tables.types.entry((item.own, param.id())).or_insert(Type::Float);
            }
        }
    }
}

/// The help for a value of the wrong type. `literal` is the value if it is one token, and `declared` returns true for
/// the name of a value.
fn conversion(kind: ParamKind, got: Type, literal: Option<&Tok>, declared: impl Fn(&str) -> bool) -> Option<String> {
    Some(match (kind.ty()?, got, literal) {
        (Type::Text, ..) if kind == ParamKind::Color => "write a colour, as in `\"#ff8000\"`".into(),
        (Type::Text, _, Some(Tok::Number(number))) => format!("write `\"{number}\"`, in quotes"),
        (Type::Text, ..) => "write `str(…)`".into(),
        (Type::Float, Type::Text, Some(Tok::Str(text))) => match number(text) {
            Some(number) => format!("write `{number}`, without quotes"),
            None if declared(text) => format!("write `{text}`, without quotes"),
            // `float` of other text is NaN.
            None => "write a number, without quotes".into(),
        },
        (Type::Float, Type::Text, _) => "write `float(…)`".into(),
        (Type::Bool, Type::Float, _) => "write a comparison, as in `… != 0`".into(),
        (Type::Float, Type::Floats, _) => "write `…[0]` for one element; `.+`, `.*` and so on go over all".into(),
        _ => return None,
    })
}

/// The number in a text, which may have a unit.
fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let unit = text.trim_start_matches(|c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+')).trim();
    let digits = text.strip_suffix(unit)?.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    let number = digits.and_then(|digits| if unit.is_empty() { Some(digits) } else { without_unit(digits, unit) });
    number.or_else(|| text.parse::<f64>().ok().filter(|number| number.is_finite()))
}
