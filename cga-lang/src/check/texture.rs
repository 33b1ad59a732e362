//! Splits in texture space where there are no texture coordinates.
//!
//! Initial shapes may bring some, and a projection may be set up for what comes later: then nothing is said.

use super::flow::{Facts, Flow, body};
use super::{Cx, Use};
use crate::ast::{OpKind, Split};
use crate::ast_walk::ops;
use crate::code::Code;
use crate::diag::Diags;

/// The uv sets that some rule projects, a bit each.
#[derive(Clone, Copy)]
pub(super) struct Projected(u16);

impl Projected {
    pub(super) fn new(cx: &Cx, flow: &Flow) -> Projected {
        let mut bits = 0;
        for (index, item) in cx.globals.rules.iter().enumerate() {
            ops(body(item), &mut |op| match &op.kind {
                OpKind::Call(name, args) if matches!(cx.tables.of(name), Some(Use::Operation(row)) if row.name == "projectUV") =>
                {
                    let facts = Facts::any(cx.globals.rules[index].decl.params.len());
                    let set = args.first().and_then(|arg| flow.value(&arg.value, &facts).number().known());
                    bits |= set.map_or(u16::MAX, |set| 1u16.checked_shl(set as u32).unwrap_or(0));
                }
                OpKind::Path(..) => bits = u16::MAX,
                _ => {}
            });
        }
        Projected(bits)
    }

    fn has(self, set: u32) -> bool {
        self.0 & 1u16.checked_shl(set).unwrap_or(0) != 0
    }
}

/// Looks at a split along `u` or `v` of a uv set.
pub(super) fn check(split: &Split, set: u32, projected: Projected, facts: &Facts, diags: &mut Diags) {
    let span = split.args.first().map_or(split.name.span, |axis| axis.span);
    if facts.uvs.lacks(set) {
        let message = format!("the shape has no uv set {set}: it is never split");
        let diag = diags.report(Code::SplitWithoutUv, span, message);
        diag.note(format!("nothing makes texture coordinates of set {set} before it"));
        diag.help(format!("write `setupProjection({set}, …) projectUV({set})` before it"));
    } else if facts.uvs.awaits(set) && !projected.has(set) {
        let message = format!("the projection of uv set {set} is set up, but never made");
        let diag = diags.report(Code::SplitWithoutUv, span, message);
        diag.note("a split goes by the texture coordinates that are there");
        diag.help(format!("write `projectUV({set})` before it"));
    }
}
