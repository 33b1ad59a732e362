//! Diagnostics that only hold for the defaults of attributes, or for initial shapes without height. A host program may
//! set other values and run other shapes.

use super::instances::CommonDiags;
use super::{repeat, size};
use crate::analysis::{Attrs, Calls, DataFlow, Evaluator, Site, Slots};
use crate::diag::code::Code;
use crate::diag::{Basis, Diag, Diags, Level};
use crate::resolve::context::Context;
use crate::resolve::tables::{Entries, Use};
use crate::span::Span;
use std::collections::HashSet;

/// The diagnostics that are reported for defaults. A size of zero is not, because it turns a part off.
const TOLD: &[Code] = &[
    Code::SizeNotPositive,
    Code::SlotNeverMade,
    Code::FloatWithoutSpace,
    Code::SlotAlwaysCut,
    Code::SharesBeyondWhole,
    Code::SizesBeyondExtent,
    Code::TooManyPieces,
];

/// The diagnostics that are reported for a shape without height. Splits of the shape itself are not, because rules may be
/// written for boxes.
const TOLD_OF_LOTS: &[Code] =
    &[Code::SlotNeverMade, Code::FloatWithoutSpace, Code::SlotAlwaysCut, Code::SizesBeyondExtent];

/// Runs the checks with defaults and without height; `certain` are the diagnostics that hold in any case.
pub(crate) fn check(cx: &Context, calls: &Calls, certain: &[Diag]) -> Vec<Diag> {
    let known = |attrs| Evaluator::new(&cx.globals, &cx.tables, attrs);
    let (accepted, defaults) = (known(Attrs::Accepted), known(Attrs::Defaults));
    let mut list = Vec::new();
    for (flow, told, basis) in [
        (DataFlow::new(&cx.globals, &defaults, Some(calls)), TOLD, Basis::Defaults as fn(_) -> _),
        (DataFlow::of_lots(&cx.globals, &accepted, calls), TOLD_OF_LOTS, |_| Basis::Lot(None)),
        (DataFlow::of_lots(&cx.globals, &defaults, calls), TOLD_OF_LOTS, |names| Basis::Lot(Some(names))),
    ] {
        let found = divisions(&flow, told, basis, cx);
        let known: HashSet<Span> = certain.iter().chain(&list).map(|diag| diag.span).collect();
        list.extend(found.into_iter().filter(|diag| !known.contains(&diag.span)));
    }
    list
}

/// The diagnostics about splits with one of the codes.
fn divisions(flow: &DataFlow, told: &[Code], basis: fn(Vec<(String, Span)>) -> Basis, cx: &Context) -> Vec<Diag> {
    let program = cx.globals.program;
    let mut common = CommonDiags::default();
    for (rule, item) in cx.globals.rules.iter().enumerate() {
        if !program.roots.contains(&item.instance) {
            continue;
        }
        common.check(item, |diags| {
            flow.visit(&cx.globals, rule, &mut |site, facts| {
                let (Site::Split(slots) | Site::Sections(slots)) = site else { return };
                let mut found = Diags::new();
                size::check(slots, facts, &cx.tables, &mut found);
                repeat::check(slots, &mut found);
                let told = found.finish().into_iter().filter(|diag| is_told(told, diag, slots)).map(|diag| {
                    let basis = basis(defaults(diag.span, slots, cx.tables.at(item.own), cx));
                    Diag { level: Level::Warning, basis, ..diag }
                });
                diags.append(told.collect());
            });
        });
    }
    common.finish()
}

fn is_told(told: &[Code], diag: &Diag, slots: &Slots) -> bool {
    let off = slots.list.iter().any(|slot| slot.size.span == diag.span && slot.value.known() == Some(0.0));
    told.contains(&diag.code) && !off
}

/// The attributes whose defaults a diagnostic about a slot depends on.
fn defaults(span: Span, slots: &Slots, names: Entries, cx: &Context) -> Vec<(String, Span)> {
    let mut attrs = Vec::new();
    // A slot depends on the slots before it, a floating slot on all.
    let at = slots.list.iter().position(|slot| slot.size.span == span && !slot.floats());
    let count = at.map_or(slots.list.len(), |at| at + 1);
    for slot in &slots.list[..count] {
        names.uses(&slot.size.value, &mut |found| {
            attrs.extend(if let Some(Use::Attr(attr)) = found { Some(attr) } else { None });
        });
    }
    attrs.sort_unstable();
    attrs.dedup();
    let names = attrs.into_iter().map(|attr| &cx.globals.attrs[attr as usize].decl.name);
    names.map(|name| (name.text.clone(), name.span)).collect()
}
