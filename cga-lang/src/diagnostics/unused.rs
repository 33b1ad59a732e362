//! Declarations that are never used, and names that hide other declarations.

use super::instances::CommonDiags;
use crate::diag::code::Code;
use crate::diag::{Diag, Diags};
use crate::ir::{ChoiceValues, Type};
use crate::ops;
use crate::resolve::context::Context;
use crate::resolve::globals::{Declared, Initializer};
use crate::resolve::tables::Use;
use crate::span::Span;
use crate::syntax::ast::{Body, Name, Role};
use crate::syntax::token::{Sym, Tok};
use std::collections::{HashMap, HashSet};

/// Checks the compiled file. An imported file may have more than is used here.
pub(crate) fn check(cx: &Context) -> Vec<Diag> {
    let (globals, program) = (&cx.globals, cx.globals.program);
    // A file without a start rule is a library.
    if cx.tables.starts.iter().all(Option::is_none) {
        return Vec::new();
    }
    let (attrs, consts) = used(cx);
    let is_root =
        |item: &&Declared| program.roots.contains(&item.instance) && item.home == item.instance && !item.origin;
    let mut common = CommonDiags::default();
    // Other files may read the values of a file.
    let styled = styled(cx);
    // A style may redefine a value for rules that only another style has.
    let is_styled = |item: &Declared| styled.contains(&item.decl.form());
    let values = |item: &&Declared| is_root(item) && !program.may_be_imported() && !is_styled(item);
    for (index, item) in globals.attrs.iter().enumerate().filter(|(_, item)| values(item)) {
        let is_used = attrs.contains(&(index as u32));
        common.check(item, |diags| value(item, Code::UnusedAttribute, is_used, diags));
    }
    for (index, item) in globals.consts.iter().enumerate().filter(|(_, item)| values(item)) {
        let is_used = consts.contains(&(index as u32));
        common.check(item, |diags| value(item, Code::UnusedConstant, is_used, diags));
    }
    for item in globals.rules.iter().chain(&globals.functions).filter(is_root) {
        common.check(item, |diags| inner(cx, item, &styled, diags));
    }
    let mut list = common.finish();
    list.extend(imports(cx));
    list
}

/// The attributes and constants that a grammar uses.
fn used(cx: &Context) -> (HashSet<u32>, HashSet<u32>) {
    let (mut attrs, mut consts) = (HashSet::new(), HashSet::new());
    for found in cx.tables.uses.values() {
        match found {
            Use::Attr(index) | Use::SetAttr(index) => _ = attrs.insert(*index),
            Use::Const(index) => _ = consts.insert(*index),
            _ => {}
        }
    }
    for (item, info) in cx.globals.attrs.iter().zip(&cx.tables.attrs) {
        if let Initializer::Flows(outer) = item.init {
            attrs.insert(outer);
        }
        if let Some(ChoiceValues::Attr(attr)) = info.choices.as_ref().map(|choices| &choices.values) {
            attrs.insert(attr.0);
        }
    }
    (attrs, consts)
}

/// Returns true if a leading `_` marks the name as unused on purpose.
fn is_meant(name: &str) -> bool {
    name.starts_with('_')
}

fn value(item: &Declared, code: Code, used: bool, diags: &mut Diags) {
    let name = &item.decl.name;
    if used || is_meant(&name.text) {
        return;
    }
    let diag = diags.report(code, name.span, format!("{} `{}` is never used", item.decl.body.word(), name.text));
    diag.help(match code {
        // Host programs may use the name.
        Code::UnusedAttribute => "leave it out, or write `@Allow(unused_attribute)` before it".to_owned(),
        _ => format!("leave it out, or call it `_{}`", name.text),
    });
}

/// The names and parameter counts of declarations in several styles.
fn styled<'a>(cx: &Context<'a, '_>) -> HashSet<(&'a str, usize)> {
    let program = cx.globals.program;
    let mut styles: HashMap<(&str, usize), u32> = HashMap::new();
    let mut found = HashSet::new();
    for decl in program.roots.first().map_or(&[][..], |&root| &program.instances[root].file.ast.decls) {
        if *styles.entry(decl.form()).or_insert(decl.style) != decl.style {
            found.insert(decl.form());
        }
    }
    found
}

/// Checks parameters and locals.
fn inner(cx: &Context, item: &Declared, styled: &HashSet<(&str, usize)>, diags: &mut Diags) {
    let decl = item.decl;
    let names: Vec<_> = decl.inner().collect();
    let in_styles = styled.contains(&decl.form());
    let mut used = vec![false; names.len()];
    for token in decl.span.first..=decl.span.last {
        if let Some(Use::Param(index)) = cx.tables.uses.get(&(item.own, token)) {
            used.get_mut(*index as usize).into_iter().for_each(|used| *used = true);
        }
    }
    for (index, (name, used)) in names.into_iter().zip(used).enumerate() {
        let what = if index < decl.params.len() { "parameter" } else { "local value" };
        if let Some(word) = doubtful_selector(cx, item, name, used) {
            let message = format!("`{}` is the selector here, not the {what} of that name", name.text);
            let diag = diags.report(Code::Shadowing, Span::one(word), message);
            diag.related(format!("the {what} is declared"), name.span);
            let help = format!("write `({0})` for the {what}, or give the {what} another name", name.text);
            diag.help(help);
            continue;
        }
        // Parameters of an extension, or of one of several styles, may be used by the other versions.
        if !used && !is_meant(&name.text) && decl.role != Role::Extension && !in_styles {
            let message = format!("{what} `{}` is never used", name.text);
            diags
                .report(Code::UnusedParameter, name.span, message)
                .help(format!("leave it out, or call it `_{}`", name.text));
        }
        if let Some(other) = cx.globals.value(item.home, &name.text).and_then(|hidden| cx.globals.item(hidden)) {
            let kind = other.decl.body.word();
            let message = format!("{what} `{}` hides the {kind} of that name", name.text);
            let diag = diags.report(Code::Shadowing, name.span, message);
            diag.related(format!("the {kind} is declared"), other.decl.name.span);
            diag.help(match decl.body {
                Body::Rule(_) => "give it another name; in this rule, the name means the inner one",
                _ => "give it another name; in this function, the name means the inner one",
            });
        }
    }
}

/// The first selector in a declaration that may have been meant as the parameter or local value of the same name. A
/// text is never meant. A value that is read elsewhere is not meant either, except a bool next to an operator of a
/// condition.
fn doubtful_selector(cx: &Context, item: &Declared, name: &Name, is_used: bool) -> Option<u32> {
    let word = ops::selector(&name.text)?.name;
    let tokens = cx.globals.program.tokens.as_slice();
    let ty = cx.tables.at(item.own).ty(name);
    let is_operator = |at: Option<u32>| {
        let token = at.and_then(|at| tokens.get(at as usize));
        matches!(token, Some(Tok::Sym(Sym::Bang | Sym::AndAnd | Sym::OrOr)))
    };
    let mut words = (item.decl.span.first..=item.decl.span.last)
        .filter(|token| cx.tables.uses.get(&(item.own, *token)) == Some(&Use::Selector(word)));
    match ty {
        Some(Type::Bool) if is_used => {
            words.find(|&word| is_operator(word.checked_sub(1)) || is_operator(word.checked_add(1)))
        }
        None | Some(Type::Bool | Type::Float) if !is_used => words.next(),
        _ => None,
    }
}

/// Reports imports whose prefix is never used and that get no attribute.
fn imports(cx: &Context) -> Vec<Diag> {
    let (globals, program) = (&cx.globals, cx.globals.program);
    let Some(&root) = program.roots.first() else { return Vec::new() };
    let instance = &program.instances[root];
    let tokens = program.tokens.as_slice();
    let own = &instance.file.tokens;
    let named: HashSet<&str> = (own.start as usize..own.end as usize)
        .filter_map(|at| match (tokens.get(at)?, tokens.get(at + 1)?) {
            (Tok::Ident(name), Tok::Sym(Sym::Dot | Sym::LParen) | Tok::Joint) => Some(name.as_str()),
            _ => None,
        })
        .collect();
    let mut diags = Diags::new();
    for import in &instance.file.ast.imports {
        let name = import.id.text.as_str();
        let target = instance.imports.get(name).copied().flatten();
        let flows = globals.attrs.iter().any(|item| Some(item.instance) == target && !item.is_own());
        if target.is_some() && !named.contains(name) && !flows && !is_meant(name) {
            let message = format!("import `{name}` is never used");
            diags.report(Code::UnusedImport, import.id.span, message).help("leave it out");
        }
    }
    diags.finish()
}
