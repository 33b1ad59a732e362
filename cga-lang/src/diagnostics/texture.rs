//! Splits in texture space, and textures, on shapes without texture coordinates.
//!
//! Initial shapes may have texture coordinates, and a projection may be set up for later. In these cases nothing is
//! reported.

use crate::analysis::{AbstractState, DataFlow, UvSets, body};
use crate::diag::Diags;
use crate::diag::code::Code;
use crate::ops::{Function, Operation, ParamKind, UvEffect};
use crate::resolve::context::Context;
use crate::resolve::tables::Use;
use crate::span::Span;
use crate::syntax::ast::{Arg, Block, Expr, ExprKind, Name, OpKind};
use crate::syntax::walk::ops;

/// The uv sets that any rule makes, one bit per set: by projection, by any operation, and sets with a projection that
/// is set up.
#[derive(Clone, Copy)]
pub(crate) struct Projected {
    projected: u16,
    made: u16,
    set_up: u16,
}

impl Projected {
    pub(crate) fn new(cx: &Context, flow: &DataFlow) -> Projected {
        let (mut bits, mut made, mut set_up) = (0, 0, 0);
        // Rules of a file that imports this one may also make sets.
        if cx.globals.program.may_be_imported() {
            (made, set_up) = (u16::MAX, u16::MAX);
        }
        for item in &cx.globals.rules {
            let names = cx.tables.at(item.own);
            ops(body(item)).for_each(|op| match &op.kind {
                OpKind::Call(name, args) | OpKind::Block(Block { name, args, .. }) => {
                    let Some(Use::Operation(row)) = names.of(name) else { return };
                    made |= UvSets::made_by(row);
                    let list = match row.uvs {
                        UvEffect::Projects => &mut bits,
                        UvEffect::SetsUp => &mut set_up,
                        _ => return,
                    };
                    let facts = AbstractState::any(item.own, item.decl.params.len());
                    let set = args.first().and_then(|arg| flow.value(&arg.value, &facts).number().known());
                    *list |= set.map_or(u16::MAX, |set| 1u16.checked_shl(set as u32).unwrap_or(0));
                }
                OpKind::Path(..) => (bits, made, set_up) = (u16::MAX, u16::MAX, u16::MAX),
                _ => {}
            });
        }
        Projected { projected: bits, made, set_up }
    }

    fn has(self, set: u32) -> bool {
        self.projected & 1u16.checked_shl(set).unwrap_or(0) != 0
    }
}

/// Checks a split along `u` or `v` of a uv set.
pub(crate) fn check(split: &Block, set: u32, projected: Projected, facts: &AbstractState, diags: &mut Diags) {
    let span = split.args.first().map_or(split.name.span, |axis| axis.span);
    if facts.uvs.lacks(set) {
        lacks(Code::SplitWithoutUv, span, set, "it is never split", diags);
    } else if facts.uvs.awaits(set) && !projected.has(set) {
        let message = format!("the projection of uv set {set} is set up, but never made");
        let diag = diags.report(Code::SplitWithoutUv, span, message);
        diag.note("a split uses the existing texture coordinates");
        diag.help(format!("write `projectUV({set})` before it"));
    }
}

/// Checks an operation that changes an existing set or uses a projection.
pub(crate) fn changed(
    row: &Operation,
    args: &[Arg],
    projected: Projected,
    (facts, flow): (&AbstractState, &DataFlow),
    diags: &mut Diags,
) {
    let Some(arg) = args.first() else { return };
    let set = || known_set(&arg.value, facts, flow);
    match row.uvs {
        UvEffect::Projects => {
            let Some(set) = set().filter(|set| projected.set_up & (1 << set) == 0) else { return };
            let message = format!("no rule sets up a projection of uv set {set}: the shape has none after this");
            let diag = diags.report(Code::MissingUvSet, arg.value.span, message);
            diag.help(format!("write `setupProjection({set}, …)` before it"));
        }
        effect if effect.needs_set() => {
            let Some(set) = set().filter(|set| facts.uvs.lacks(*set)) else { return };
            lacks(Code::MissingUvSet, arg.value.span, set, &format!("`{}` has no effect", row.name), diags);
        }
        _ => {}
    }
}

/// Checks a function of texture coordinates. `geometry.hasUVs` may test sets that are missing.
pub(crate) fn asked(
    row: &Function,
    name: &Name,
    args: &[Expr],
    (facts, flow): (&AbstractState, &DataFlow),
    diags: &mut Diags,
) {
    let set = args.first().map_or(Some(0), |set| known_set(set, facts, flow));
    let Some(set) = set.filter(|set| row.needs_uv_set && facts.uvs.lacks(*set)) else { return };
    lacks(Code::MissingUvSet, name.span, set, &format!("`{}` is 0", name.text), diags);
}

/// Reports a shape without a uv set.
fn lacks(code: Code, span: Span, set: u32, effect: &str, diags: &mut Diags) {
    let diag = diags.report(code, span, format!("the shape has no uv set {set}: {effect}"));
    diag.note(format!("no operation before it makes texture coordinates of set {set}"));
    diag.help(format!("write `setupProjection({set}, …) projectUV({set})` before it"));
}

/// The number of a uv set, if it is known and such a set exists.
fn known_set(number: &Expr, facts: &AbstractState, flow: &DataFlow) -> Option<u32> {
    let number = flow.value(number, facts).number().known()?;
    (0.0..10.0).contains(&number).then_some(number as u32)
}

/// Checks a value that may be a texture. A layer without its uv set uses the first one (*texturing*).
pub(crate) fn carried(image: &Expr, kind: ParamKind, projected: Projected, facts: &AbstractState, diags: &mut Diags) {
    let ParamKind::Image(set) = kind else { return };
    let is_off = matches!(&image.kind, ExprKind::Text(text) if text.is_empty());
    let none = |set: u32| facts.uvs.lacks(set) && projected.made & (1 << set) == 0;
    if is_off || !none(0) || !none(set) {
        return;
    }
    let message = "the shape has no texture coordinates: this texture is not visible";
    let diag = diags.report(Code::TextureWithoutUv, image.span, message);
    diag.note("no rule makes texture coordinates, and those that an initial shape may bring are deleted before it");
    diag.help("write `setupProjection(0, …) projectUV(0)` before it");
}
