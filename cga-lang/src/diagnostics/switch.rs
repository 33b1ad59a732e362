//! Conditions that an author sets by hand.

use crate::resolve::tables::{Entries, Use};
use crate::syntax::ast::{Expr, ExprKind};

/// Returns true if an expression is a bare `true` or `false`, or has only constants: a switch that its author sets by
/// hand.
pub(crate) fn is_switch(expr: &Expr, names: Entries) -> bool {
    fn count(expr: &Expr, names: Entries, constants: &mut usize, others: &mut usize) {
        if let ExprKind::Name(name) | ExprKind::Call(name, _) = &expr.kind {
            match names.of(name) {
                Some(Use::Const(_) | Use::Function(_)) => *constants += 1,
                _ => *others += 1,
            }
        }
        expr.parts().into_iter().for_each(|part| count(part, names, constants, others));
    }
    let (mut constants, mut others) = (0, 0);
    count(expr, names, &mut constants, &mut others);
    matches!(expr.kind, ExprKind::Bool(_)) || 0 < constants && others == 0
}
