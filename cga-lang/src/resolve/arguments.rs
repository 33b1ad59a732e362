//! Arguments as written: bare words, axes, errors.

use crate::ir::Axis;
use crate::ops::Operation;
use crate::syntax::ast::{Arg, Block, Expr, ExprKind};

impl Block {
    /// The axis named by the first argument; `None` for an unknown axis or one of the texture space.
    pub(crate) fn axis(&self) -> Option<Axis> {
        Axis::named(self.args.first()?.value.word()?)
    }

    /// Returns true if all words that may be left out are the default ones of its row.
    pub(crate) fn is_plain(&self, row: &Operation) -> bool {
        let words: Vec<Option<&str>> = self.args.iter().map(|arg| arg.value.word()).collect();
        row.has_default_words(&words)
    }
}

/// The bare word that an expression consists of.
pub(crate) fn bare(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Name(name) => Some(&name.text),
        _ => None,
    }
}

/// The bare word that an argument consists of.
pub(crate) fn word(arg: &Arg) -> Option<&str> {
    plain(arg).and_then(bare)
}

/// The value of an argument without a prefix.
pub(crate) fn plain(arg: &Arg) -> Option<&Expr> {
    Some(&arg.value).filter(|_| arg.prefix.is_none())
}

impl Expr {
    /// The word that the expression is: bare, in `sel("…")` (*sel*), or as text.
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
