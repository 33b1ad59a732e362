//! Slots and sections that are never made, always cut or leave a gap.

use super::numbers::{about, range, shown};
use super::switch::is_switch;
use crate::analysis::{AbstractState, Face, SizeSum, Slot, Slots, called};
use crate::diag::code::Code;
use crate::diag::{Diag, Diags};
use crate::resolve::tables::{Entries, Tables};
use crate::syntax::ast::{Arg, Op, OpKind};

/// A rest is reported if it is less than this share of the thinnest slot. A larger rest is probably meant.
const HARDLY: f64 = 0.5;

/// A rest is reported if it is more than this share of the extent. A smaller rest is rounding, as of three times
/// 0.33.
const VISIBLE: f64 = 0.02 + 1e-9;

pub(crate) fn check(slots: &Slots, facts: &AbstractState, tables: &Tables, diags: &mut Diags) {
    if let Some(axis) = slots.axis.filter(|&axis| facts.shape.is_flat(axis)) {
        return flat(slots, axis, facts, diags);
    }
    let cut = (0..slots.list.len()).find(|&index| !slots.is_never(index) && slots.is_cut(index));
    for (index, slot) in slots.list.iter().enumerate() {
        // A group without any pieces has its own diagnostic.
        if slot.is_nothing() && !slot.group.is_some_and(|group| slots.makes_nothing(group)) {
            nothing(slots, slot, tables.at(facts.own), diags);
        } else if !slot.is_nothing() && slots.is_never(index) {
            starved(slots, index, cut, facts, diags);
        }
    }
    if (0..slots.list.len()).all(|index| slots.list[index].is_nothing() || !slots.is_never(index)) {
        crossing(slots, facts, diags);
    }
    gap(slots, facts, diags);
}

/// Reports the depths of sections that are never positive. A section without steps leaves a gap.
pub(crate) fn depths(slots: &Slots, facts: &AbstractState, tables: &Tables, diags: &mut Diags) {
    for slot in slots.list.iter().filter(|slot| slot.has_no_depth()) {
        let Some((expr, depth)) = slot.depth else { continue };
        let is_gap = matches!(slot.ops, [] | [Op { kind: OpKind::Nil, .. }]);
        if is_gap || depth.known() == Some(0.0) && is_switch(expr, tables.at(facts.own)) {
            continue;
        }
        let label = label(slots, slot);
        let message = match depth.known() {
            Some(depth) => format!("this depth is {}: {label} is never made", shown(depth)),
            None => format!("this depth is never positive: {label} is never made"),
        };
        let diag = diags.report(Code::SizeNotPositive, expr.span, message);
        if depth.known().is_none() {
            diag.note(format!("it is {}", range(depth)));
        }
        diag.note("sections without a positive depth make no shape").help("write `NIL` to leave a gap");
    }
}

/// The words for a division in messages.
pub(crate) struct Terms {
    pub(crate) slot: &'static str,
    pub(crate) size: &'static str,
    pub(crate) whole: &'static str,
}

pub(crate) fn terms(slots: &Slots) -> Terms {
    match slots.axis {
        Some(_) => Terms { slot: "slot", size: "size", whole: "scope" },
        None => Terms { slot: "section", size: "length", whole: "outline" },
    }
}

/// The name of the successor of a slot in messages.
fn label(slots: &Slots, slot: &Slot) -> String {
    called(slot.ops).map_or_else(|| format!("this {}", terms(slots).slot), |name| format!("`{}`", name.text))
}

/// Adds the place that defines the extent.
fn since(slots: &Slots, facts: &AbstractState, diag: &mut Diag) {
    if let Some(place) = slots.axis.and_then(|axis| facts.shape.since[axis]) {
        diag.related(format!("the shape gets this extent along {}", axis(slots)), place);
    }
}

/// The direction of a division in messages.
pub(crate) fn axis(slots: &Slots) -> &'static str {
    slots.axis.map_or("the outline", |axis| ["x", "y", "z"][axis])
}

fn flat(slots: &Slots, along: usize, facts: &AbstractState, diags: &mut Diags) {
    let name = axis(slots);
    let span = slots.split.args.first().map_or(slots.split.name.span, |arg: &Arg| arg.span);
    let face = facts.shape.is_face().filter(|_| along == 2);
    let message = match face {
        Some(Face::Any) => format!("a planar face has no extent along {name}: it is never split"),
        _ => format!("the shape has no extent along {name}: it is never split"),
    };
    let diag = diags.report(Code::FlatSplit, span, message);
    if let Some(place) = facts.shape.since[along] {
        diag.related(format!("it is flat along {name}"), place);
    }
    if face.is_some() {
        diag.help("a face extends along x and y: write `split(x)` or `split(y)`");
    }
}

fn nothing(slots: &Slots, slot: &Slot, names: Entries, diags: &mut Diags) {
    if slot.value.known() == Some(0.0) && is_switch(&slot.size.value, names) {
        // The author has turned the part off.
        return;
    }
    let (Terms { slot: part, size, .. }, label) = (terms(slots), label(slots, slot));
    let message = match slot.value.known() {
        Some(value) => format!("this {size} is {}: {label} is never made", shown(value)),
        None => format!("this {size} is never positive: {label} is never made"),
    };
    let diag = diags.report(Code::SizeNotPositive, slot.size.span, message);
    if slot.value.known().is_none() {
        diag.note(format!("it is {}", range(slot.value)));
    }
    diag.note(format!("{part}s without a positive {size} are left out and use no space"));
}

/// A sum in a message: "1.1 of the scope", or the metres and the extent of the scope.
fn quantity(slots: &Slots, sum: SizeSum) -> String {
    let (extent, axis, whole) = (slots.extent, axis(slots), terms(slots).whole);
    let room = match extent.known() {
        Some(extent) => format!("and the scope has {} along {axis}", shown(extent)),
        None => format!("and the scope has {} at most along {axis}", about(extent.hi)),
    };
    match sum {
        SizeSum { metres: 0.0, share } => format!("{} of the {whole}", shown(share)),
        SizeSum { share: 0.0, metres } => format!("{}, {room}", shown(metres)),
        SizeSum { share, metres } => format!("{} and {} of the {whole}, {room}", shown(metres), shown(share)),
    }
}

/// Reports a slot that gets no space. `cut` is the first slot that is always cut.
fn starved(slots: &Slots, index: usize, cut: Option<usize>, facts: &AbstractState, diags: &mut Diags) {
    let (slot, size) = (&slots.list[index], terms(slots).size);
    let (code, sum, which) = if slot.floats() {
        (Code::FloatWithoutSpace, slots.fixed(), format!("the {size}s that do not float"))
    } else {
        (Code::SlotNeverMade, slots.before(index, false), format!("the {size}s before it"))
    };
    let message = format!("{} is never made: no space is left for it", label(slots, slot));
    let diag = diags.report(code, slot.size.span, message);
    let fills = slots.fills(sum);
    if fills {
        diag.note(format!("{which} add up to {}", quantity(slots, sum)));
    } else if let Some(extent) = slots.extent.known() {
        let is_tiny = !slot.floats() && slots.before(index, true) == sum;
        diag.note(match is_tiny {
            true => format!("it is too small for a scope with {} along {}", shown(extent), axis(slots)),
            false => format!("the other slots take all of the {} along {}", shown(extent), axis(slots)),
        });
    }
    if let Some(cut) = cut.filter(|&cut| cut < index && !slot.floats()) {
        let (cut, whole) = (&slots.list[cut], terms(slots).whole);
        diag.related(format!("{} is cut where the {whole} ends", label(slots, cut)), cut.size.span);
    }
    if !fills || 0.0 < sum.metres {
        since(slots, facts, diag);
    }
    match slot.floats() {
        true => diag.help("make one of the others smaller, or put `~` before it"),
        false => diag.help(format!("put `~` before one of the {size}s to share the available space")),
    };
}

/// Reports the slot that reaches beyond the end of the scope.
fn crossing(slots: &Slots, facts: &AbstractState, diags: &mut Diags) {
    let Some(index) = (0..slots.list.len()).find(|&index| slots.is_cut(index)) else { return };
    let slot = &slots.list[index];
    let sum = slots.before(index, true);
    let code = match sum {
        SizeSum { metres: 0.0, .. } => Code::SharesBeyondWhole,
        SizeSum { share: 0.0, .. } => Code::SizesBeyondExtent,
        _ => Code::SlotAlwaysCut,
    };
    let Terms { size, whole, .. } = terms(slots);
    let message = format!("{} is always cut: it reaches beyond the end of the {whole}", label(slots, slot));
    let diag = diags.report(code, slot.size.span, message);
    let which = match index {
        0 => format!("this {size} alone is"),
        _ => format!("the {size}s up to here add up to"),
    };
    diag.note(format!("{which} {}", quantity(slots, sum)));
    if 0.0 < sum.metres {
        since(slots, facts, diag);
    }
    diag.help(format!("put `~` before one of the {size}s to share the available space"));
}

/// Reports a rest at the end of a split that is too thin to be meant. The rest of an outline belongs to the remainder.
fn gap(slots: &Slots, facts: &AbstractState, diags: &mut Diags) {
    let Some(rest) = slots.rest().filter(|_| slots.axis.is_some()) else { return };
    let made = || slots.list.iter().filter(|slot| !slot.is_nothing());
    let thinnest = made().map(|slot| slot.value.lo).fold(f64::INFINITY, f64::min);
    // A single slot cuts a part out.
    let several = 1 < made().count();
    let Some(last) = made().next_back().filter(|_| several && rest < thinnest * HARDLY) else { return };
    let (whole, unit) = if last.is_relative() { (1.0, " of the scope") } else { (slots.extent.hi, "") };
    if rest <= whole * VISIBLE {
        return;
    }
    let message = format!("a gap of {}{unit} is left after the last slot", shown(rest));
    let diag = diags.report(Code::GapLeft, last.size.span, message);
    diag.note(format!("the sizes add up to {}{unit}, and nothing floats", shown(whole - rest)));
    if !last.is_relative() {
        since(slots, facts, diag);
    }
    diag.help("put `~` before one of the sizes to share the available space");
}
