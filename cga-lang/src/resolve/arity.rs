//! Numbers of arguments in messages.

use super::context::Context;
use crate::diag::code::Code;
use crate::diag::count;
use crate::ops::{self, Braces, Operation, Param};
use crate::syntax::ast::Name;

/// Returns "2 arguments", "0 or 3 arguments" or "1, 3 or 4 arguments".
pub(crate) fn counts(counts: impl IntoIterator<Item = usize>) -> String {
    let mut list: Vec<usize> = counts.into_iter().collect();
    list.sort_unstable();
    list.dedup();
    let Some((last, rest)) = list.split_last() else { return "no arguments".into() };
    match rest {
        [] => count(*last, "argument"),
        rest => {
            let rest: Vec<String> = rest.iter().map(usize::to_string).collect();
            format!("{} or {last} arguments", rest.join(", "))
        }
    }
}

/// Reports a call with a wrong number of arguments. The help shows the calls of a word of the language.
pub(crate) fn wrong_count(cx: &mut Context, what: &str, name: &Name, takes: Vec<usize>, got: usize) {
    let message = format!("{what} `{}` takes {}, got {got}", name.text, counts(takes));
    let rows = match what {
        "function" => {
            let rows = ops::functions(&name.text).filter(|row| row.old.is_none());
            usages(rows.map(|row| (row.name, row.params, "")))
        }
        "operation" => {
            let rows = ops::operations(&name.text).filter(|row| row.old.is_none());
            let tail = |row: &Operation| if row.braces == Braces::None { "" } else { " { … }" };
            usages(rows.map(|row| (row.name, &row.params[..ops::required(row.params)], tail(row))))
        }
        _ => String::new(),
    };
    let diag = cx.diags.report(Code::ArgumentCount, name.span, message);
    if !rows.is_empty() {
        diag.help(format!("write {rows}"));
    }
}

/// The calls of rows of a table, each with the text after it: "`s(x, y, z)` or `s(xyz)`".
pub(crate) fn usages(rows: impl Iterator<Item = (&'static str, &'static [Param], &'static str)>) -> String {
    let call = |(name, params, tail): (&str, &[Param], &str)| {
        let params: Vec<&str> = params.iter().map(|param| param.name).collect();
        format!("`{name}({}){tail}`", params.join(", "))
    };
    let mut calls: Vec<String> = rows.map(call).collect();
    calls.dedup();
    calls.join(" or ")
}
