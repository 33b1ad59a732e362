//! Judges findings about splits.

use super::Verdict::{self, Broken, Silent, So};
use crate::played::places::{Divided, Places};
use crate::played::run::{Run, Seen};
use cga_lang::diag::Diag;
use cga_lang::diag::code::Code;
use cga_lang::syntax::ast::Prefix;

/// Pieces that a repeat is warned of beyond that.
const MANY: f64 = 1e7;

/// More than the rounding error of printed numbers.
const ROUNDED: f64 = 1e-10;

/// Shapes that extend further are divided for certain, however large the initial shape is.
const DIVIDED: f64 = 1e-2;

/// Judges what is said of a split by each time that a run came there.
pub(super) fn judge(diag: &Diag, places: &Places, run: &Run) -> Verdict {
    let inside = |divided: &&Divided| match diag.code {
        Code::FlatSplit => divided.axis == diag.span,
        _ => divided.slots.iter().any(|slot| slot.size.first == diag.span.first),
    };
    let Some(divided) = places.splits.iter().find(inside) else { return Silent };
    let at_limit = run.limit.as_ref().is_some_and(|trail| trail.last().is_some_and(|rule| rule.is(&divided.rule)));
    let mut verdict = if at_limit && diag.code == Code::TooManyPieces { So } else { Silent };
    for seen in run.splits.iter().filter(|seen| seen.number == divided.number) {
        match once(diag, divided, seen, run) {
            Silent => {}
            So => verdict = So,
            Broken(why) => return Broken(format!("{why}; the extent is {}, the sizes {:?}", seen.extent, seen.sizes)),
        }
    }
    verdict
}

fn once(diag: &Diag, divided: &Divided, seen: &Seen, run: &Run) -> Verdict {
    let slot = divided.slots.iter().position(|slot| slot.size.first == diag.span.first).unwrap_or(0);
    let own = |index: usize| seen.pieces.iter().filter(move |piece| piece.number == divided.slots[index].number);
    let metres = |index: usize| match divided.slots[index].prefix {
        Some(Prefix::Floating) => None,
        Some(Prefix::Relative) => seen.sizes[index].map(|size| size * seen.extent),
        None => seen.sizes[index],
    };
    let divisible = DIVIDED < seen.extent;
    let never = |made: Option<f64>| match made {
        Some(length) => Broken(format!("a piece of {length} is made")),
        None if divisible => So,
        None => Silent,
    };
    match diag.code {
        Code::SizeNotPositive if seen.sizes[slot].is_some_and(|size| 0.0 < size && size.is_finite()) => {
            Broken("it is positive".into())
        }
        Code::SizeNotPositive | Code::SlotNeverMade | Code::FloatWithoutSpace => {
            never(own(slot).next().map(|piece| piece.length))
        }
        Code::FlatSplit => match seen.pieces.first() {
            Some(piece) => Broken(format!("a piece of {} is made", piece.length)),
            None => So,
        },
        Code::RepeatNoProgress => {
            let within = (0..divided.slots.len()).filter(|slot| divided.slots[*slot].size.first <= diag.span.last);
            never(within.filter(|index| slot <= *index).find_map(|slot| own(slot).next()).map(|piece| piece.length))
        }
        Code::SlotAlwaysCut | Code::SharesBeyondWhole | Code::SizesBeyondExtent => {
            let Some(whole) = metres(slot) else { return Silent };
            match own(slot).map(|piece| piece.length).find(|length| whole * (1.0 - ROUNDED) <= *length) {
                Some(length) => Broken(format!("a piece of {length} is not cut")),
                None if own(slot).next().is_some() => So,
                None => Silent,
            }
        }
        Code::GapLeft => {
            let filled: f64 = seen.pieces.iter().map(|piece| piece.length).sum();
            match seen.extent * (1.0 - ROUNDED) <= filled {
                true if !seen.pieces.is_empty() => Broken(format!("the pieces are {filled} together")),
                _ if divisible && !seen.pieces.is_empty() => So,
                _ => Silent,
            }
        }
        Code::RepeatOnce => {
            let group = divided.groups.first().cloned().unwrap_or_default();
            let counts: Vec<usize> = group.map(|slot| own(slot).count()).collect();
            match counts.iter().find(|count| 1 < **count || divisible && run.whole && **count < 1) {
                Some(count) => Broken(format!("it is there {count} times")),
                None if counts.contains(&1) => So,
                None => Silent,
            }
        }
        Code::RepeatSliver => {
            let Some(last) = seen.pieces.iter().find(|piece| piece.index + 1.0 == piece.total) else { return Silent };
            let own = divided.slots.iter().position(|slot| slot.number == last.number);
            let Some(whole) = own.and_then(metres) else { return Silent };
            if 0.1 * whole * (1.0 + ROUNDED) < last.length { Broken(format!("it gets {}", last.length)) } else { So }
        }
        Code::TooManyPieces => match seen.pieces.first() {
            Some(piece) if piece.total <= MANY => Broken(format!("there are {}", piece.total)),
            Some(_) => So,
            None => Silent,
        },
        _ => Silent,
    }
}
