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
use std::collections::{BTreeSet, HashMap, HashSet};
use std::ops::Range;

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
                let off = slots.list.iter().filter(|slot| slot.value.known() == Some(0.0));
                let off: HashSet<Span> = off.map(|slot| slot.size.span).collect();
                let mut defaults = Defaults::new(slots, cx.tables.at(item.own));
                let is_told = |diag: &Diag| told.contains(&diag.code) && !off.contains(&diag.span);
                let told = found.finish().into_iter().filter(is_told).map(|diag| {
                    let basis = basis(defaults.of(diag.span, cx));
                    Diag { level: Level::Warning, basis, ..diag }
                });
                diags.append(told.collect());
            });
        });
    }
    common.finish()
}

/// The attributes whose defaults the diagnostics about the slots of a division depend on.
struct Defaults<'s, 'a> {
    slots: &'s Slots<'a>,
    names: Entries<'s>,
    /// By the size: the number of a slot that does not float.
    places: HashMap<Span, usize>,
    /// The attributes of the first slots, and the number of these slots.
    attrs: (BTreeSet<u32>, usize),
    /// The attributes of all slots, if a diagnostic needed them.
    all: Option<BTreeSet<u32>>,
}

impl<'s, 'a> Defaults<'s, 'a> {
    fn new(slots: &'s Slots<'a>, names: Entries<'s>) -> Self {
        let places = slots.list.iter().enumerate().filter(|(_, slot)| !slot.floats());
        let places = places.map(|(index, slot)| (slot.size.span, index)).collect();
        Defaults { slots, names, places, attrs: (BTreeSet::new(), 0), all: None }
    }

    /// Adds the attributes of some slots.
    fn add(&self, attrs: &mut BTreeSet<u32>, slots: Range<usize>) {
        for slot in &self.slots.list[slots] {
            self.names.uses(&slot.size.value, &mut |found| {
                attrs.extend(if let Some(Use::Attr(attr)) = found { Some(attr) } else { None });
            });
        }
    }

    /// The attributes of a diagnostic about a slot. A slot depends on the slots before it, a floating slot on all. The
    /// work is least for diagnostics in the order of the slots.
    fn of(&mut self, span: Span, cx: &Context) -> Vec<(String, Span)> {
        if let Some(&at) = self.places.get(&span) {
            let (mut attrs, mut count) = std::mem::take(&mut self.attrs);
            if at + 1 < count {
                (attrs, count) = (BTreeSet::new(), 0);
            }
            self.add(&mut attrs, count..at + 1);
            self.attrs = (attrs, at + 1);
        } else if self.all.is_none() {
            let mut attrs = BTreeSet::new();
            self.add(&mut attrs, 0..self.slots.list.len());
            self.all = Some(attrs);
        }
        let attrs = if self.places.contains_key(&span) { &self.attrs.0 } else { self.all.get_or_insert_default() };
        let names = attrs.iter().map(|&attr| &cx.globals.attrs[attr as usize].decl.name);
        names.map(|name| (name.text.clone(), name.span)).collect()
    }
}
