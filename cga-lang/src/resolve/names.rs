//! Resolves the names in expressions. `steps` resolves the operations of rules.

use super::arguments::bare;
use super::arity::wrong_count;
use super::context::Context;
use super::globals::{Initializer, Namespace, builtins};
use super::habits;
use super::resolver::Resolver;
use super::tables::Use;
use crate::diag::code::Code;
use crate::diag::quoted;
use crate::dialect::Dialect;
use crate::ops::{self, Function, Needs, ParamKind, SelectorPlaces, Words};
use crate::span::Span;
use crate::syntax::ast::{Expr, ExprKind, Name};
use crate::syntax::token::Tok;
use crate::types::Type;

/// Resolves all uses.
pub(crate) fn uses(cx: &mut Context) {
    let values: Vec<_> = cx.globals.values().cloned().collect();
    for (index, item) in values.iter().enumerate() {
        let Some((value, own)) = item.value() else { continue };
        let owner = (!item.origin && index < cx.globals.attrs.len()).then_some(index as u32);
        let at = cx.globals.program.home(own);
        let mut resolver = Resolver { cx, at, own, inner: Vec::new(), owner, place: None };
        if item.is_own() {
            resolver.enter(item.decl);
        }
        resolver.expr(value);
    }
    for item in cx.globals.rules.clone() {
        if let crate::syntax::ast::Body::Rule(ops) = &item.decl.body {
            let mut resolver =
                Resolver { cx, at: item.home, own: item.own, inner: Vec::new(), owner: None, place: None };
            resolver.enter(item.decl);
            resolver.ops(ops);
        }
    }
}

impl<'a> Resolver<'_, 'a, '_> {
    /// Enters parameters, then locals. Each local can use the names before it.
    fn enter(&mut self, decl: &'a crate::syntax::ast::Decl) {
        self.inner.extend(&decl.params);
        for (name, value) in &decl.locals {
            self.expr(value);
            self.inner.push(name);
        }
    }

    pub(crate) fn note(&mut self, name: &Name, found: Use) {
        self.cx.tables.uses.insert((self.own, name.id()), found);
    }

    /// Records the candidates of a call. If there are several, the types decide.
    pub(crate) fn note_open(&mut self, name: &Name, mut candidates: Vec<Use>) {
        match candidates.as_slice() {
            [] => {}
            [one] => self.note(name, *one),
            _ => {
                candidates.dedup();
                let open = Use::Open(self.cx.tables.open.len() as u32);
                self.cx.tables.open.push(candidates);
                self.note(name, open);
            }
        }
    }

    pub(crate) fn dialect(&self) -> Dialect {
        self.cx.globals.program.instances[self.at].file.dialect
    }

    pub(crate) fn expr(&mut self, expr: &'a Expr) {
        match &expr.kind {
            ExprKind::Name(name) => return self.expr_name(name),
            ExprKind::Call(..) if self.has_unread(expr.span) => {}
            ExprKind::Call(name, args) => return self.call(name, args),
            ExprKind::Comp(comp) => return self.comp_value(comp),
            ExprKind::Chance(arms, _) => self.percentages(arms.iter().map(|(percent, _)| percent)),
            _ => {}
        }
        for part in expr.parts() {
            self.expr(part);
        }
    }

    /// Returns true if a span has unreadable tokens, which were reported.
    pub(crate) fn has_unread(&self, span: Span) -> bool {
        let tokens = self.cx.globals.program.tokens.as_slice();
        let list = tokens.get(span.first as usize..=span.last as usize).unwrap_or_default();
        list.iter().any(|token| matches!(token, Tok::Bad))
    }

    /// Looks up a bare name.
    pub(crate) fn lookup(&mut self, name: &str) -> Option<Use> {
        if let Some(index) = self.inner.iter().position(|inner| inner.text == name) {
            return Some(Use::Param(index as u32));
        }
        let global = self.cx.globals.value(self.at, name).map(|found| self.unless_own(found, name));
        global
            .or_else(|| ops::functions(name).find(|row| row.takes(0)).map(Use::Builtin))
            .or_else(|| ops::shape_attr(name).map(Use::Shape))
    }

    /// The value of an override may use the value that the attribute would have without it.
    fn unless_own(&mut self, found: Use, name: &str) -> Use {
        let (Use::Attr(index), Some(owner)) = (found, self.owner) else { return found };
        let flows = matches!(self.cx.globals.attrs[index as usize].init, Initializer::Flows(outer) if outer == owner);
        let overrides = index == owner && !self.cx.globals.attrs[index as usize].is_own();
        match self.cx.globals.origin(self.at, name).filter(|_| flows || overrides) {
            Some(origin) => {
                self.cx.tables.origins.insert(origin);
                Use::Const(origin)
            }
            None => found,
        }
    }

    pub(crate) fn expr_name(&mut self, name: &'a Name) {
        let found = self.lookup(&name.text);
        let own = matches!(found, Some(Use::Param(_) | Use::Attr(_) | Use::Const(_) | Use::Function(_) | Use::Open(_)));
        if let (Some(place), Some(row), false) = (self.place, ops::selector(&name.text), own) {
            return self.known_selector(name, row, place);
        }
        match found {
            Some(found) => {
                self.about_old(name, found);
                self.note(name, found);
            }
            None => self.unknown_name(name, None),
        }
    }

    /// Reports uses that are not allowed here or are deprecated.
    pub(crate) fn about_old(&mut self, name: &Name, found: Use) {
        let old = match found {
            Use::Builtin(Function { needs: Needs::Component, .. }) if self.place.is_none() => {
                let message = format!("`{}` is only allowed in a selector", name.text);
                self.cx.diags.report(Code::UnknownFunction, name.span, message).note("it reads a component");
                return;
            }
            // *setback operation*: what is selected there are edges.
            Use::Builtin(Function { needs: Needs::Component, params: [_, _, ..], .. })
                if self.place == Some(SelectorPlaces::SETBACK) =>
            {
                let message = format!("`{}` takes 1 argument in a setback", name.text);
                let diag = self.cx.diags.report(Code::ArgumentCount, name.span, message);
                diag.note("a setback selects edges, and faces pass their tags on to them")
                    .help("leave out the second argument");
                return;
            }
            Use::Builtin(row) => row.old,
            Use::Shape(row) | Use::SetShape(row) => row.old,
            Use::Operation(row) => row.old,
            _ => return,
        };
        self.deprecated(name, old);
    }

    pub(crate) fn deprecated(&mut self, name: &Name, old: Option<&str>) {
        if let Some(instead) = old {
            let message = format!("`{}` is an old spelling", name.text);
            self.cx.diags.report(Code::OldSpelling, name.span, message).help(instead.to_owned());
        }
    }

    /// Reports an unknown name. `help` is the text to type where text is needed.
    pub(crate) fn unknown_name(&mut self, name: &'a Name, help: Option<String>) {
        let (text, globals, at) = (name.text.as_str(), &self.cx.globals, self.at);
        if globals.is_lost(at, text) {
            return;
        }
        let takes = self.takes(text);
        if !takes.is_empty() {
            return wrong_count(self.cx, "function", name, takes, 0);
        }
        let is_rule = !globals.rules(at, text).is_empty();
        let inner = self.inner.iter().map(|inner| inner.text.as_str());
        let near = globals.meant(at, text, Namespace::Values, inner.chain(ops::all_shape_attrs().map(|row| row.name)));
        let truth = ["true", "false"].into_iter().find(|word| text.eq_ignore_ascii_case(word)).map(str::to_owned);
        let is_text = help.is_some();
        let help = help.or_else(|| habits::value(text).map(|value| format!("write `{value}`"))).or_else(|| {
            let full = format!("scope.{text}");
            ops::shape_attr(&full).map(|_| format!("did you mean `{full}`?"))
        });
        let help = help.or_else(|| {
            let [size, place] = habits::size_or_place(text)?;
            Some(format!("write `{size}` for the size, or `{place}` for the position"))
        });
        // A text without quotes may also be a name with a mistake.
        let near = truth.or(near).filter(|_| help.is_none() || is_text);
        let (inline, dotted) = (self.dialect() == Dialect::Inline, text.contains('.'));
        let diag = self.cx.diags.report(Code::UnknownName, name.span, format!("unknown name `{text}`"));
        if is_rule {
            diag.note(format!("`{text}` is a rule: it makes shapes and has no value"));
        }
        let suggested = near.is_some();
        diag.suggest(near);
        if ops::selector(text).is_some() {
            diag.note(format!("`{text}` selects components: it is only allowed in the selectors of a `comp`"));
        }
        if let Some(help) = help {
            diag.help(help);
        } else if let Some(("self" | "Self" | "this", rest)) = text.split_once('.') {
            diag.help(format!("write `{rest}`"));
        } else if !dotted && !suggested && !is_rule && !is_known_elsewhere(text) {
            diag.help(format!("declare it: `attr {text} = …`"));
            if inline {
                diag.help(format!("write `#{text}` for a Rust value, `\"{text}\"` for text"));
            }
        } else if let Some((first, _)) = text.split_once('.')
            && !ops::all_shape_attrs().any(|row| row.name.starts_with(first))
            && !self.cx.globals.program.instances[at].imports.contains_key(first)
        {
            let all = ops::all_functions().map(|row| row.name).filter(|name| name.split('.').next() == Some(first));
            let mut all: Vec<&str> = all.collect();
            all.dedup();
            match all.is_empty() {
                true => diag.note(format!("there is no import `{first}`")),
                false => diag.note(format!("there are {}", quoted(all))),
            };
        }
    }

    /// Reports an unknown name where text is needed: quotation marks are missing.
    pub(crate) fn unquoted(&mut self, kind: ParamKind, arg: &'a Expr) -> bool {
        let ExprKind::Name(name) = &arg.kind else { return false };
        if self.lookup(&name.text).is_some() {
            return false;
        }
        let help = match (kind, habits::colour(&name.text)) {
            (ParamKind::Color, Some(colour)) => format!("write `\"{colour}\"`, in quotes"),
            (ParamKind::Color, None) => "write a colour, as in `\"#ff8000\"`".into(),
            _ => format!("write `\"{}\"`, in quotes", name.text),
        };
        self.unknown_name(name, Some(help));
        true
    }

    /// The numbers of arguments that functions with a name take.
    fn takes(&self, name: &str) -> Vec<usize> {
        let globals = &self.cx.globals;
        let own = globals.functions(self.at, name).iter().map(|index| &globals.functions[*index as usize]);
        let rows = ops::functions(name).flat_map(|row| ops::required(row.params)..=row.params.len());
        own.map(|item| item.decl.params.len()).chain(rows).chain(conversion(name).map(|_| 1)).collect()
    }

    fn call(&mut self, name: &'a Name, args: &'a [Expr]) {
        let text = name.text.as_str();
        let own = self.cx.globals.functions(self.at, text).iter().copied();
        let own = own.filter(|index| self.cx.globals.functions[*index as usize].decl.params.len() == args.len());
        let mut candidates: Vec<Use> = own.map(Use::Function).collect();
        let rows = builtins(text, args.len());
        if candidates.is_empty() && rows.is_empty() && !(args.len() == 1 && conversion(text).is_some()) {
            // A word of the function is not an unknown name.
            let is_word = |arg: &&Expr| {
                let words = || ops::functions(text).flat_map(|row| row.params);
                bare(arg).is_some_and(|word| words().any(|param| param.kind.has_word(word)))
            };
            args.iter().filter(|arg| !is_word(arg)).for_each(|arg| self.expr(arg));
            return self.unknown_call(name, args);
        }
        // Words are not names. They select rows and are not looked up.
        let mut fitting: Vec<_> = rows.iter().copied().filter(|row| words_fit(row, args, bare)).collect();
        if fitting.is_empty() {
            let said = if self.dialect() == Dialect::Text { Expr::word } else { not_text };
            fitting = rows.iter().copied().filter(|row| words_fit(row, args, said)).collect();
        }
        if candidates.is_empty() && fitting.is_empty() && !rows.is_empty() && conversion(text).is_none() {
            return self.other_words(rows[0], args);
        }
        for (index, arg) in args.iter().enumerate() {
            let is_word = |row: &&Function| matches!(row.params[index].kind, ParamKind::Word(_) | ParamKind::Selector);
            if candidates.is_empty() && !fitting.is_empty() && fitting.iter().all(is_word) {
                let words: Vec<Words> = fitting.iter().filter_map(|row| row.params[index].kind.words()).collect();
                if let Some((old, new)) = words.iter().filter_map(|words| words.old(arg.word()?)).next() {
                    self.old_word(old, new, arg.span);
                    continue;
                }
                if fitting.iter().any(|row| row.params[index].kind == ParamKind::Selector) {
                    self.selector(arg, SelectorPlaces::FACES);
                } else {
                    self.word_expr(text, &words, arg);
                }
                continue;
            }
            let takes_text = |row: &&Function| row.params[index].kind.ty() == Some(Type::Text);
            if candidates.is_empty()
                && let Some(row) = fitting.first()
                && fitting.iter().all(takes_text)
                && self.unquoted(row.params[index].kind, arg)
            {
                continue;
            }
            self.expr(arg);
        }
        if args.len() == 1
            && let Some(ty) = conversion(text)
        {
            candidates.push(Use::Convert(ty));
        }
        candidates.extend(fitting.into_iter().map(Use::Builtin));
        if let Some(first @ Use::Builtin(_)) = candidates.first().copied() {
            self.about_old(name, first);
        }
        self.note_open(name, candidates);
    }

    /// Resolves a call whose words do not fit any row.
    fn other_words(&mut self, row: &'static Function, args: &'a [Expr]) {
        for (param, arg) in row.params.iter().zip(args) {
            match &param.kind {
                ParamKind::Word(words) => self.word_expr(row.name, &[*words], arg),
                ParamKind::Selector => self.selector(arg, SelectorPlaces::FACES),
                _ => self.expr(arg),
            }
        }
    }

    fn unknown_call(&mut self, name: &'a Name, args: &'a [Expr]) {
        let text = name.text.as_str();
        if self.cx.globals.is_lost(self.at, text) || args.iter().any(|arg| matches!(arg.kind, ExprKind::Error)) {
            return;
        }
        let takes = self.takes(text);
        if !takes.is_empty() {
            return wrong_count(self.cx, "function", name, takes, args.len());
        }
        if let Some(found) = self.lookup(text) {
            let what = match found {
                Use::Param(_) => "a parameter",
                Use::Attr(_) => "an attribute",
                Use::Const(_) => "a constant",
                _ => "an attribute of the shape",
            };
            let message = format!("`{text}` is {what} and takes no arguments");
            self.cx.diags.report(Code::ArgumentCount, name.span, message).help(match found {
                Use::Shape(_) => format!("write `{text}`"),
                _ => format!("write `{text}`, or `{text}[…]` for an element of an array"),
            });
            return;
        }
        let others = ops::all_functions().map(|row| row.name).chain(["str"]);
        let method = self.method(text, args);
        let near = match method {
            Some(_) => None,
            None => self.cx.globals.meant(self.at, text, Namespace::Functions, others),
        };
        let shape = ops::operations(text).next().is_some() || !self.cx.globals.rules(self.at, text).is_empty();
        let diag = self.cx.diags.report(Code::UnknownFunction, name.span, format!("unknown function `{text}`"));
        if let Some(call) = method {
            diag.note("values have no methods").help(format!("write `{call}`"));
        } else if shape {
            diag.note(format!("`{text}` works on shapes and has no value"));
        } else {
            diag.suggest(near);
        }
    }

    /// The CGA form of `scope.sx.sqrt()`, if it names a value and a function.
    fn method(&mut self, text: &str, args: &[Expr]) -> Option<String> {
        let (value, function) = text.rsplit_once('.')?;
        if function == "equals" && args.len() == 1 {
            return self.lookup(value).map(|_| format!("{value} == …"));
        }
        let takes = self.takes(function).contains(&(args.len() + 1));
        self.lookup(value).filter(|_| takes)?;
        let rest = if args.is_empty() { "" } else { ", …" };
        Some(format!("{function}({value}{rest})"))
    }

    /// Reports percentages of a block that add up to more than 100.
    pub(crate) fn percentages(&mut self, list: impl Iterator<Item = &'a crate::syntax::ast::Percent>) {
        let mut sum = 0.0;
        for percent in list {
            sum += percent.value;
            // Fractions such as 33.3 add up with a rounding error.
            if 100.0 + 1e-9 < sum {
                let message = format!("the percentages up to here add up to {}", (sum * 1e6).round() / 1e6);
                let diag = self.cx.diags.report(Code::PercentOver100, percent.span, message);
                diag.help("make them smaller: `else` gets what is left of 100");
                return;
            }
        }
    }
}

/// Returns true if the row knows every word of a call. `word` returns the word of an argument.
fn words_fit(row: &Function, args: &[Expr], word: fn(&Expr) -> Option<&str>) -> bool {
    row.params.iter().zip(args).all(|(param, arg)| match &param.kind {
        ParamKind::Word(_) if matches!(arg.kind, ExprKind::Error) => true,
        ParamKind::Word(words) => word(arg).is_some_and(|word| words.has(word)),
        _ => true,
    })
}

/// Returns true if a name is a word of an operation, or a selector.
fn is_known_elsewhere(name: &str) -> bool {
    ops::selector(name).is_some()
        || ops::all_operations().any(|row| row.params.iter().any(|param| param.kind.has_word(name)))
}

fn not_text(arg: &Expr) -> Option<&str> {
    arg.word().filter(|_| !matches!(arg.kind, ExprKind::Text(_)))
}

/// The result type of a conversion function.
fn conversion(name: &str) -> Option<Type> {
    match name {
        "float" => Some(Type::Float),
        "bool" => Some(Type::Bool),
        "str" => Some(Type::Text),
        "floatArray" => Some(Type::Floats),
        "boolArray" => Some(Type::Bools),
        "stringArray" => Some(Type::Texts),
        _ => None,
    }
}
