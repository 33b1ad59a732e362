//! Repeats without progress, with too many pieces, with one repetition or with a sliver.

use super::numbers::{about, shown};
use super::size::{Terms, axis, terms};
use crate::analysis::{MARGIN, Once, Slots};
use crate::diag::Diags;
use crate::diag::code::Code;
use crate::ops::MOST_SECTIONS;

/// The maximum number of shapes of a run, unless the host program sets another limit.
pub(crate) const MOST_SHAPES: f64 = 1e7;

/// The share of its size below which a last piece is a sliver.
const SLIVER: f64 = 0.1;

pub(crate) fn check(slots: &Slots, diags: &mut Diags) {
    let Terms { slot, size, whole } = terms(slots);
    let most = if slots.axis.is_some() { MOST_SHAPES } else { MOST_SECTIONS };
    for (number, group) in slots.groups.iter().enumerate() {
        if group.slots.is_empty() {
            continue;
        }
        let first = slots.list[group.slots.start].size.span;
        if slots.makes_nothing(number) {
            if slots.is_within_nothing(number) {
                continue;
            }
            let message = format!("this repeat makes no progress: none of its {size}s is positive");
            let span = if group.slots.len() == 1 { first } else { group.span };
            diags
                .report(Code::RepeatNoProgress, span, message)
                .help(format!("give one of its {slot}s a positive {size}"));
        } else if let Some(count) = slots.at_least(number).filter(|count| most < *count) {
            let (message, note) = match slots.axis {
                Some(_) => (
                    format!("this repeat makes about {} million pieces", (count * 1e-6).round()),
                    format!("a run ends at {} million shapes, unless the host program sets another limit", most * 1e-6),
                ),
                None => (
                    format!("this repeat makes about {} sections", count.round()),
                    format!("a pattern of more than {most} sections makes none"),
                ),
            };
            diags.report(Code::TooManyPieces, first, message).note(note);
        } else if let Some(why) = slots.once(number) {
            let diag = diags.report(Code::RepeatOnce, first, "this always repeats only once");
            diag.note(reason(&why, slots)).help(format!("leave out the `*`, or make the {size}s smaller"));
        } else if let Some((share, own)) = sliver(slots) {
            let message = format!("the last piece is a sliver: {} of the {whole}", shown(share));
            let diag = diags.report(Code::RepeatSliver, first, message);
            diag.note(format!("its {size} is {}, but no more space is left along {}", shown(own), axis(slots)));
            diag.help(format!("put `~` before the {size}: then the repeats fill the {whole} evenly"));
        }
    }
}

/// The note about the reason why a group repeats once.
fn reason(once: &Once, slots: &Slots) -> String {
    let (axis, Terms { size, whole, .. }) = (axis(slots), terms(slots));
    match *once {
        Once::Shares(sum) => format!("its {size}s add up to {} of the {whole}", shown(sum)),
        Once::Metres { sum, most } => {
            format!("its sizes add up to {}, and the scope has {} at most along {axis}", shown(sum), about(most))
        }
        Once::Extent(extent) => format!("the scope has {} along {axis}", shown(extent)),
    }
}

/// The length of the last piece and the size of its slot, if a repeat of shares leaves a piece that is much smaller.
fn sliver(slots: &Slots) -> Option<(f64, f64)> {
    let [_] = slots.groups.as_slice() else { return None };
    let pieces = slots.shares().filter(|_| slots.groups[0].slots.len() == slots.list.len())?;
    let last = pieces.last()?;
    let own = slots.list[last.slot as usize].value.known()?;
    (MARGIN < last.length && last.length < SLIVER * own).then_some((last.length, own))
}
