//! Numbers of arguments in messages.

use super::context::Context;
use crate::diag::code::Code;
use crate::diag::count;
use crate::ops::Operation;
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

/// Reports a call with a wrong number of arguments.
pub(crate) fn wrong_count(cx: &mut Context, what: &str, name: &Name, takes: Vec<usize>, got: usize) {
    let message = format!("{what} `{}` takes {}, got {got}", name.text, counts(takes));
    cx.diags.report(Code::ArgumentCount, name.span, message);
}

/// The usage of an operation: `s(x, y, z)`.
pub(crate) fn usage(row: &Operation) -> String {
    let params: Vec<&str> = row.params.iter().map(|param| param.name).collect();
    format!("{}({})", row.name, params.join(", "))
}
