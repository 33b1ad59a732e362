//! Occlusion queries of attributes and constants about shapes of the same initial shape.
//!
//! Attributes and constants have their values for the initial shape, and all its shapes are descendants, which occlusion queries leave out.

use super::instances::CommonDiags;
use crate::diag::code::Code;
use crate::diag::{Diag, Diags};
use crate::ops::Uses;
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::syntax::ast::{Expr, ExprKind};

/// Checks the values of attributes and constants.
pub(crate) fn check(cx: &Context) -> Vec<Diag> {
    let mut common = CommonDiags::default();
    for item in cx.globals.attrs.iter().chain(&cx.globals.consts) {
        let Some((value, own)) = item.value() else { continue };
        common.check(item, |diags| queries(value, cx.tables.at(own), diags));
    }
    common.finish()
}

fn queries(expr: &Expr, names: Entries, diags: &mut Diags) {
    if let ExprKind::Call(name, args) = &expr.kind
        && let Some(Use::Builtin(row)) = names.of(name)
        && row.uses.has(Uses::OCCLUSION)
        && matches!(args.first().map(|arg| &arg.kind), Some(ExprKind::Name(target)) if target.text == "intra")
    {
        let message = format!("`{}(intra)` is always false in the value of an attribute or constant", name.text);
        let diag = diags.report(Code::IdleQuery, name.span, message);
        diag.note("it is the value for the initial shape, and occlusion queries leave out the descendants of a shape");
        diag.help("ask in a rule or in a function without `attr` and `const`, or ask about neighbours with `inter`");
    }
    expr.parts().into_iter().for_each(|part| queries(part, names, diags));
}
