//! Overrides in parentheses after an import: checks that they name attributes and extensions of the imported file.

use super::context::Context;
use super::globals::Namespace;
use super::tables::Use;
use crate::diag::code::Code;
use crate::diag::{Level, count};
use crate::link::InstanceId;
use crate::suggest::nearest;
use crate::syntax::ast::{Decl, Name, Override, Role};
use std::collections::HashSet;

pub(crate) fn check(cx: &mut Context) {
    let program = cx.globals.program;
    for (id, instance) in program.instances.iter().enumerate() {
        for (index, layer) in instance.layers.iter().enumerate() {
            // The earlier layers belong to the static import, which is an instance of its own.
            if index + 1 == instance.layers.len() {
                list_of(cx, id, program.overrides(layer).unwrap_or_default());
            }
        }
    }
}

/// Checks the overrides of an instance.
pub(crate) fn list_of(cx: &mut Context, id: InstanceId, list: &[Override]) {
    let mut seen = HashSet::new();
    for own in list {
        let name = match own {
            Override::Keep(name) | Override::Value(name, _) => name,
            Override::Rule(decl) => &decl.name,
        };
        if !seen.insert(name.text.as_str()) {
            let message = format!("`{}` is overridden twice", name.text);
            cx.diags.report(Code::DuplicateName, name.span, message);
            continue;
        }
        if cx.globals.is_lost(id, &name.text) {
            continue;
        }
        match own {
            Override::Keep(_) | Override::Value(..) => attribute(cx, id, name),
            // A name with a dot was reported by the parser.
            Override::Rule(decl) if decl.name.text.contains('.') => {}
            Override::Rule(decl) => extension(cx, id, decl),
        }
    }
}

fn attribute(cx: &mut Context, id: InstanceId, name: &Name) {
    match cx.globals.value(id, &name.text) {
        // *CGA changelog 2023.0*: no longer allowed. Older files keep their meaning.
        Some(Use::Attr(_)) if name.text.contains('.') => {
            let message = format!("`{}` belongs to an import of the imported file", name.text);
            cx.diags
                .report(Code::OldSpelling, name.span, message)
                .help("since CGA 2023.0 only that file gives it a value");
        }
        Some(Use::Attr(_)) => {}
        found => {
            let near = nearest(&name.text, cx.globals.near(id, Namespace::Attrs)).map(str::to_owned);
            let message = match found {
                Some(_) => format!("`{}` is a constant, and only attributes can be overridden", name.text),
                None => format!("the imported file has no attribute `{}`", name.text),
            };
            cx.diags.report(Code::UnknownName, name.span, message).suggest(near);
        }
    }
}

fn extension(cx: &mut Context, id: InstanceId, own: &Decl) {
    let (name, program) = (&own.name, cx.globals.program);
    // The search includes an extension that the style in force replaces by a rule of its own, which stays.
    let decls = || program.instances[id].file.ast.decls.iter().filter(|decl| decl.name.text == name.text);
    if let Some(extension) = decls().find(|decl| decl.role == Role::Extension) {
        if extension.params.len() != own.params.len() {
            let message = format!(
                "extension `{}` has {}, but this has {}",
                name.text,
                count(extension.params.len(), "parameter"),
                own.params.len()
            );
            cx.diags.report(Code::ArgumentCount, name.span, message).related("declared", extension.name.span);
        }
        return;
    }
    let rule = |index: &u32| &cx.globals.rules[*index as usize];
    let named: Vec<_> =
        cx.globals.plain_rules(id, &name.text).iter().map(rule).filter(|item| item.home == id).collect();
    let near = nearest(&name.text, cx.globals.near(id, Namespace::Extensions)).map(str::to_owned);
    if let Some(rule) = named.first() {
        let message = format!("rule `{}` is not an extension and cannot be overridden", name.text);
        cx.diags
            .report_as(Code::UndefinedRule, Level::Error, name.span, message)
            .help(format!("write `extension {}` in the imported file", rule.decl.name.text));
    } else {
        let message = format!("the imported file has no rule `{}`", name.text);
        cx.diags.report_as(Code::UndefinedRule, Level::Error, name.span, message).suggest(near);
    }
}
