//! Labels below operations with operands, whose shapes no query finds.

use super::instances::CommonDiags;
use crate::analysis::body;
use crate::diag::code::Code;
use crate::diag::{Diag, Diags};
use crate::ops::{Braces, Uses};
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::syntax::ast::{Op, OpKind};

/// Checks the labels of all rules. A rule that an operand calls may have other callers, so only labels in the braces themselves count.
pub(crate) fn check(cx: &Context) -> Vec<Diag> {
    let mut common = CommonDiags::default();
    for item in &cx.globals.rules {
        let names = cx.tables.at(item.own);
        common.check(item, |diags| labels(body(item), names, None, diags));
    }
    common.finish()
}

/// Checks the labels of operations that are in the braces of an operation with operands, if there is one.
fn labels(list: &[Op], names: Entries, below: Option<&str>, diags: &mut Diags) {
    for op in list {
        let mut inner = below;
        match &op.kind {
            OpKind::Call(name, args) => {
                if let (Some(operation), Some(Use::Operation(row)), Some(arg)) = (below, names.of(name), args.first())
                    && row.uses.has(Uses::LABELS)
                {
                    let diag =
                        diags.report(Code::LostLabel, arg.span, format!("this label is lost below `{operation}`"));
                    diag.note("the shapes of operands are joined, so queries do not find their labelled copies");
                    diag.help(format!("write `label(…)` before or after `{operation} {{ … }}`"));
                }
            }
            OpKind::Block(block) => {
                if let Some(Use::Operation(row)) = names.of(&block.name)
                    && matches!(row.braces, Braces::Operands | Braces::Inline | Braces::Modified)
                {
                    inner = Some(&block.name.text);
                }
            }
            _ => {}
        }
        op.bodies().for_each(|ops| labels(ops, names, inner, diags));
    }
}
