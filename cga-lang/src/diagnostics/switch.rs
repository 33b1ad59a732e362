//! Conditions that an author sets by hand.

use crate::resolve::tables::{Entries, Use};
use crate::syntax::ast::{Expr, ExprKind};

/// Returns true if an expression is a bare `true` or `false`, or has only constants: a switch that its author sets by
/// hand.
pub(crate) fn is_switch(expr: &Expr, names: Entries) -> bool {
    let (mut constants, mut others) = (0, 0);
    names.uses(expr, &mut |found| match found {
        Some(Use::Const(_) | Use::Function(_)) => constants += 1,
        _ => others += 1,
    });
    matches!(expr.kind, ExprKind::Bool(_)) || 0 < constants && others == 0
}
