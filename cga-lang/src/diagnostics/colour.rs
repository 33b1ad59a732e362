//! Invalid colours. Invalid text is an error in inline rules; in text sources it is a warning, and a run continues
//! with a fault. Numbers are clamped to the valid range.

use super::numbers::shown;
use crate::analysis::{AbstractState, DataFlow};
use crate::diag::code::Code;
use crate::diag::{Diags, Level};
use crate::dialect::Dialect;
use crate::link::Program;
use crate::ops::{Param, ParamKind};
use crate::resolve::habits;
use crate::syntax::ast::{Expr, ExprKind};

/// Checks the arguments of an operation or function.
pub(crate) fn check(
    program: &Program,
    params: &[Param],
    args: &[&Expr],
    facts: &AbstractState,
    flow: &DataFlow,
    diags: &mut Diags,
) {
    let of = |kind| params.iter().zip(args).filter(move |(param, _)| param.kind == kind).map(|(_, arg)| *arg);
    of(ParamKind::Color).for_each(|arg| text(program, arg, diags));
    let stray = of(ParamKind::Channel).find(|part| {
        let number = flow.value(part, facts).number();
        number.hi < 0.0 || 1.0 < number.lo
    });
    let Some(stray) = stray else { return };
    let number = flow.value(stray, facts).number().known();
    let what = number.map_or_else(|| "this".to_owned(), shown);
    let message = format!("{what} is not a valid part of a colour");
    let diag = diags.report_as(Code::NotAColor, Level::Warning, stray.span, message);
    diag.note("red, green, blue and opacity go from 0 to 1");
    match hex(of(ParamKind::Channel).map(|part| flow.value(part, facts).number().known())) {
        Some(hex) => diag.help(format!("write \"{hex}\" for all of them")),
        None => diag.help("write a number from 0 to 1"),
    };
}

/// The colour meant by numbers from 0 to 255.
fn hex(parts: impl Iterator<Item = Option<f64>>) -> Option<String> {
    let parts: Vec<f64> = parts.collect::<Option<_>>()?;
    let is_byte = |part: &f64| (*part == 0.0 || (2.0..=255.0).contains(part)) && part.fract() == 0.0;
    let are_bytes = parts.iter().all(is_byte);
    let are_large = parts.iter().any(|part| 10.0 < *part);
    let digits = || parts.iter().map(|part| format!("{:02x}", *part as u8)).collect::<String>();
    (are_bytes && are_large).then(|| format!("#{}", digits()))
}

/// Checks a value that must be a colour.
pub(crate) fn text(program: &Program, value: &Expr, diags: &mut Diags) {
    let ExprKind::Text(text) = &value.kind else { return };
    if is_colour(text) {
        return;
    }
    let level = if program.dialect(value.span.first) == Dialect::Inline { Level::Error } else { Level::Warning };
    let diag = diags.report_as(Code::NotAColor, level, value.span, format!("\"{text}\" is not a colour"));
    diag.note("a colour is `#` and six hexadecimal digits, or eight with opacity");
    let digits = text.trim_start_matches('#');
    let hex = digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    match digits.len() {
        6 | 8 if hex => diag.help(format!("write \"#{digits}\"")),
        3 if hex => {
            diag.help(format!("write \"#{}\"", digits.chars().flat_map(|digit| [digit; 2]).collect::<String>()))
        }
        _ => match habits::colour(text) {
            Some(hex) => diag.help(format!("write \"{hex}\"")),
            None => diag.help("write something like \"#ff8000\""),
        },
    };
}

fn is_colour(text: &str) -> bool {
    let Some(digits) = text.strip_prefix('#') else { return false };
    matches!(digits.len(), 6 | 8) && digits.bytes().all(|byte| byte.is_ascii_hexdigit())
}
