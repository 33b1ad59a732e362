//! Text that should be a colour and is none. Among Rust an error; old text keeps running, with a fault.

use crate::ast::{Expr, ExprKind};
use crate::code::Code;
use crate::compile::Door;
use crate::diag::{Diags, Level};
use crate::link::Program;
use crate::ops::Param;

/// Looks at the arguments of an operation or function.
pub(super) fn check<'e>(program: &Program, params: &[Param], args: impl Iterator<Item = &'e Expr>, diags: &mut Diags) {
    for (_, arg) in params.iter().zip(args).filter(|(param, _)| param.name == "hexValue") {
        text(program, arg, diags);
    }
}

/// Looks at a value that must be a colour.
pub(super) fn text(program: &Program, value: &Expr, diags: &mut Diags) {
    let ExprKind::Text(text) = &value.kind else { return };
    if is_colour(text) {
        return;
    }
    let level = if program.door(value.span.first) == Door::Inline { Level::Error } else { Level::Warning };
    let diag = diags.report_as(Code::NotAColor, level, value.span, format!("\"{text}\" is not a colour"));
    diag.note("a colour is `#` and six hexadecimal digits, or eight with opacity");
    let digits = text.trim_start_matches('#');
    let hex = digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    match digits.len() {
        6 | 8 if hex => diag.help(format!("write \"#{digits}\"")),
        3 if hex => {
            diag.help(format!("write \"#{}\"", digits.chars().flat_map(|digit| [digit; 2]).collect::<String>()))
        }
        _ => diag.help("write something like \"#ff8000\""),
    };
}

fn is_colour(text: &str) -> bool {
    let Some(digits) = text.strip_prefix('#') else { return false };
    matches!(digits.len(), 6 | 8) && digits.bytes().all(|byte| byte.is_ascii_hexdigit())
}
