//! `@Allow(code)`, `@Warn(code)` and `@Deny(code)`, before a declaration or before `version`.

use crate::diag::code::Code;
use crate::diag::{Diags, Level};
use crate::resolve::context::Context;
use crate::span::Span;
use crate::suggest::nearest;
use crate::syntax::ast::{Annotation, ExprKind};

/// A level for the diagnostics of a code, within a span or everywhere.
pub(crate) struct Setting {
    code: Code,
    level: Level,
    place: Option<Span>,
}

pub(crate) fn collect(cx: &mut Context, levels: &[(Code, Level)]) -> Vec<Setting> {
    let mut settings: Vec<Setting> = levels.iter().map(|&(code, level)| Setting { code, level, place: None }).collect();
    let program = cx.globals.program;
    for (number, file) in program.files.iter().enumerate() {
        // Annotations before `version` apply to the whole file.
        let whole = Span { first: file.tokens.start, last: file.tokens.end.saturating_sub(1) };
        for annotation in &file.ast.head {
            read(cx, annotation, Some(whole).filter(|_| number != 0), &mut settings);
        }
        for decl in &file.ast.decls {
            for annotation in &decl.annotations {
                read(cx, annotation, Some(decl.span), &mut settings);
            }
        }
    }
    settings
}

fn read(cx: &mut Context, annotation: &Annotation, place: Option<Span>, settings: &mut Vec<Setting>) {
    let level = match annotation.name.text.as_str() {
        "Allow" => Level::Allow,
        "Warn" => Level::Warning,
        "Deny" => Level::Error,
        _ => return,
    };
    for arg in annotation.args.iter().flatten() {
        let word = match &arg.value.kind {
            ExprKind::Name(name) => name.text.as_str(),
            ExprKind::Text(text) => text.as_str(),
            _ => "",
        };
        match Code::from_name(word) {
            Some(code) if code.is_lint() => settings.push(Setting { code, level, place }),
            Some(_) => {
                let message = format!("the level of `{word}` cannot be changed");
                cx.diags.report(Code::UnknownCode, arg.value.span, message);
            }
            None => {
                let lints = Code::ALL.iter().filter(|code| code.is_lint()).map(|code| code.name());
                cx.diags
                    .report(Code::UnknownCode, arg.value.span, format!("unknown diagnostic `{word}`"))
                    .suggest(nearest(word, lints));
            }
        }
    }
}

/// Sets the levels of the diagnostics so far. The last of several settings for a place counts.
pub(crate) fn apply(settings: &[Setting], diags: &mut Diags) {
    if settings.is_empty() {
        return;
    }
    diags.so_far().retain_mut(|diag| {
        let here = settings.iter().rev().find(|setting| {
            setting.code == diag.code
                && diag.code.is_lint()
                && setting.place.is_none_or(|place| place.first <= diag.span.first && diag.span.last <= place.last)
        });
        if let Some(setting) = here {
            diag.level = setting.level;
        }
        diag.level != Level::Allow
    });
}
