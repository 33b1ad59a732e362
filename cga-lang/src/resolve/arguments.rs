//! Arguments as written: bare words, axes, errors.

use crate::ast::{Arg, Expr, ExprKind, Split};
use crate::ir::Axis;

/// The axis of a split; `None` when it has none, an unknown one or one of the texture space.
pub(crate) fn split_axis(split: &Split) -> Option<Axis> {
    match word(split.args.first()?)? {
        "x" => Some(Axis::X),
        "y" => Some(Axis::Y),
        "z" => Some(Axis::Z),
        _ => None,
    }
}

/// Whether the parts of a split shrink to their geometry: yes, if nothing else is said.
pub(crate) fn split_adjust(split: &Split) -> bool {
    split.args.get(1).and_then(word) != Some("noAdjust")
}

/// An expression that is a bare word.
pub(crate) fn bare(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Name(name) => Some(&name.text),
        _ => None,
    }
}

/// An argument that is a bare word.
pub(crate) fn word(arg: &Arg) -> Option<&str> {
    plain(arg).and_then(bare)
}

impl Split {
    /// Whether it divides texture space, `split(u, …)` or `split(v, …)`.
    pub(crate) fn is_in_texture_space(&self) -> bool {
        !self.is_by_area() && matches!(self.args.first().and_then(word), Some("u" | "v"))
    }
}

/// An argument without a prefix.
pub(crate) fn plain(arg: &Arg) -> Option<&Expr> {
    Some(&arg.value).filter(|_| arg.prefix.is_none())
}

impl Expr {
    /// The word it says: bare, in `sel("…")` (*sel*), or as text.
    pub(crate) fn word(&self) -> Option<&str> {
        match &self.kind {
            ExprKind::Name(name) => Some(&name.text),
            ExprKind::Text(text) => Some(text),
            ExprKind::Call(name, args) if name.text == "sel" => match args.as_slice() {
                [Expr { kind: ExprKind::Text(text), .. }] => Some(text),
                _ => None,
            },
            _ => None,
        }
    }
}

pub(crate) fn has_error(args: &[Arg]) -> bool {
    args.iter().any(|arg| matches!(arg.value.kind, ExprKind::Error))
}
