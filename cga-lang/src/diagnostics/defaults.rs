//! Diagnostics that only hold for the defaults of attributes. A host program may set other values.

use super::agreed::Agreed;
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

/// Runs the checks with defaults; `certain` are the diagnostics that hold in any case.
pub(crate) fn check(cx: &Context, calls: &Calls, certain: &[Diag]) -> Vec<Diag> {
    let program = cx.globals.program;
    let known = Evaluator::new(&cx.globals, &cx.tables, Attrs::Defaults);
    let flow = DataFlow::new(&cx.globals, &known, Some(calls));
    let mut agreed = Agreed::default();
    for (rule, item) in cx.globals.rules.iter().enumerate() {
        if !program.roots.contains(&item.instance) {
            continue;
        }
        agreed.check(item, |diags| {
            flow.visit(&cx.globals, rule, &mut |site, facts| {
                let (Site::Split(slots) | Site::Sections(slots)) = site else { return };
                let mut found = Diags::new();
                size::check(slots, facts, &cx.tables, &mut found);
                repeat::check(slots, &mut found);
                let told = found.finish().into_iter().filter(|diag| is_told(diag, slots)).map(|diag| {
                    let basis = Basis::Defaults(defaults(diag.span, slots, cx.tables.at(item.own), cx));
                    Diag { level: Level::Warning, basis, ..diag }
                });
                diags.append(told.collect());
            });
        });
    }
    let mut list = agreed.finish();
    let known: HashSet<Span> = certain.iter().map(|diag| diag.span).collect();
    list.retain(|diag| !known.contains(&diag.span));
    list
}

fn is_told(diag: &Diag, slots: &Slots) -> bool {
    let off = slots.list.iter().any(|slot| slot.size.span == diag.span && slot.value.known() == Some(0.0));
    TOLD.contains(&diag.code) && !off
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
