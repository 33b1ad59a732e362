//! The operations with braces of each rule, for the checks that need no facts about shapes.

use super::instances::CommonDiags;
use super::{edges, operands, shadowing};
use crate::analysis::body;
use crate::diag::Diag;
use crate::resolve::context::Context;
use crate::resolve::tables::Use;
use crate::syntax::ast::{BlockPart, OpKind};
use crate::syntax::walk;

pub(crate) fn check(cx: &Context) -> Vec<Diag> {
    let mut common = CommonDiags::default();
    let mut vanishing = vec![None; cx.globals.rules.len()];
    for item in &cx.globals.rules {
        let names = cx.tables.at(item.own);
        common.check(item, |diags| {
            for op in walk::ops(body(item)) {
                let OpKind::Block(block) = &op.kind else { continue };
                let Some(Use::Operation(row)) = names.of(&block.name) else { continue };
                let place = row.places(block.args.first().and_then(|arg| arg.value.word()));
                for part in &block.parts {
                    if let BlockPart::Arms(arms) = part {
                        shadowing::check(arms.iter().map(|arm| &arm.selector), place, item.own, cx, diags);
                    }
                }
                edges::check(row, block, names, diags);
                operands::check(row, block, names, cx, &mut vanishing, diags);
            }
        });
    }
    common.finish()
}
