//! Two declarations of one name.

use super::arity;
use super::context::Context;
use super::globals::Declared;
use crate::diag::code::Code;
use crate::diag::{Diags, count};
use crate::link::InstanceId;
use crate::ops::{self, Operation, Param, ParamKind};
use crate::syntax::ast::{Body, Decl, Name, Role};
use crate::types::Type;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// Fills the tables of names. Attributes, constants and functions without parameters share one namespace; so do the
/// parameters and locals of a declaration.
pub(crate) fn values(cx: &mut Context) {
    let diags = &mut *cx.diags;
    cx.globals.name(|item, first| duplicate(diags, item.decl, first.decl));
    for item in cx.globals.items() {
        let mut inner: HashMap<&str, &Name> = HashMap::new();
        for (index, name) in item.decl.inner().enumerate() {
            let first = *inner.entry(&name.text).or_insert(name);
            if first.id() != name.id() {
                let what = if index < item.decl.params.len() { "parameter" } else { "local value" };
                let message = format!("{what} `{}` is declared twice", name.text);
                cx.diags.report(Code::DuplicateName, name.span, message).related("first declared", first.span);
            }
        }
    }
    // *start*, *extension*: both belong to the style `Default`, and an extension has one form (*changelog 2024.0*).
    let mut extensions: HashMap<(InstanceId, &str), &Decl> = HashMap::new();
    for item in &cx.globals.rules {
        let (decl, name) = (item.decl, &item.decl.name);
        let word = match decl.role {
            Role::Plain => continue,
            Role::Start => "start",
            Role::Extension => "extension",
        };
        if decl.style != 0 {
            let message = format!("`{word}` is not allowed in a style");
            cx.diags.report(Code::Syntax, name.span, message).help("move the rule before the first `style`");
        } else if decl.role == Role::Extension && item.home == item.instance {
            match extensions.entry((item.instance, &name.text)) {
                Entry::Vacant(entry) => _ = entry.insert(decl),
                Entry::Occupied(entry) => {
                    let message = format!("extension `{}` is declared twice, but an extension has one form", name.text);
                    let first = entry.get().name.span;
                    cx.diags.report(Code::DuplicateName, name.span, message).related("first declared", first);
                }
            }
        }
    }
}

/// Reports rules that an operation hides because it has their name and takes their parameters.
pub(crate) fn operations(cx: &mut Context) {
    for item in &cx.globals.rules {
        let types = item.types_of_params(&cx.tables);
        if let Some(row) = ops::operations(&item.decl.name.text).find(|row| hides(row, &types)) {
            let message =
                format!("{} is an operation, so this rule could never be called", arity::call(row.name, row.params));
            cx.diags.report(Code::DuplicateName, item.decl.name.span, message).help("give the rule another name");
        }
    }
}

/// Returns true if an operation is called in every case that fits a rule with parameters of these types.
fn hides(row: &Operation, types: &[Option<Type>]) -> bool {
    let takes = |(param, ty): (&Param, &Option<Type>)| match &param.kind {
        ParamKind::Any => true,
        kind => ty.is_none() || kind.ty() == *ty,
    };
    row.takes(types.len()) && (!row.overloads || row.params.iter().zip(types).all(takes))
}

/// The instance, style, name and parameter types of a declaration.
type DeclarationKey<'a> = (InstanceId, u32, &'a str, Vec<Option<Type>>);

/// Reports rules or functions of one name that do not differ in the number or types of parameters.
pub(crate) fn overloads(cx: &mut Context) {
    for items in [&cx.globals.rules, &cx.globals.functions] {
        let mut first: HashMap<DeclarationKey<'_>, &Decl> = HashMap::new();
        for item in items.iter().filter(|item| item.home == item.instance) {
            let types = item.types_of_params(&cx.tables);
            match first.entry((item.instance, item.decl.style, &item.decl.name.text, types)) {
                Entry::Vacant(entry) => _ = entry.insert(item.decl),
                Entry::Occupied(entry) => duplicate(cx.diags, item.decl, entry.get()),
            }
        }
    }
}

/// Checks that a name has the same kind in every style, and that a value has one type in all styles (*CGA changelog
/// 2018.0*).
pub(crate) fn styles(cx: &mut Context) {
    let roots = &cx.globals.program.roots;
    for group in cx.globals.by_style().iter().filter(|group| roots.contains(&group[0].instance)) {
        let (first, ty) = (group[0], |item: &Declared| item.ty(&cx.tables));
        for item in &group[1..] {
            let (name, kind, other) = (&item.decl.name, item.decl.body.word(), first.decl.body.word());
            let article = |kind: &str| if kind == "attribute" { "an" } else { "a" };
            let message = if kind != other {
                format!(
                    "`{}` is {} {kind} in this style and {} {other} in another",
                    name.text,
                    article(kind),
                    article(other)
                )
            } else if let (Some(own), Some(other)) = (ty(item), ty(first))
                && own != other
            {
                format!("`{}` is a {} in this style and a {} in another", name.text, own.word(), other.word())
            } else {
                continue;
            };
            cx.diags.report(Code::TypeMismatch, name.span, message).related("the other", first.decl.name.span);
        }
    }
}

fn duplicate(diags: &mut Diags, decl: &Decl, first: &Decl) {
    let params = match decl.params.len() {
        0 => String::new(),
        number => format!(" with {}", count(number, "parameter")),
    };
    let message = format!("{} `{}`{params} is declared twice", decl.body.word(), decl.name.text);
    let diag = diags.report(Code::DuplicateName, decl.name.span, message).related("first declared", first.name.span);
    if matches!((&first.body, &decl.body), (Body::Attr(_), Body::Function(_))) && decl.params.is_empty() {
        diag.help(format!("rules give an attribute another value with `set({}, …)`", decl.name.text));
    }
}
