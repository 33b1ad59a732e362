//! Splits whose extent and sizes are known are solved here, so that nothing is left to compute while rules run.
//!
//! The known bounds of the scope's size follow the shape through the steps of a rule and on to the rules it is handed to. A
//! rule that is reached in several ways knows what all of them agree on, and one that the host program may start with knows
//! nothing.

use crate::ir::{
    Arg, Axis, Block, BlockParts, Grammar, Prefix, Renew, RuleId, Size, Slots, Solved, Step, StepKind, Target, Value,
};
use crate::ops::{Braces, Effect, MOST_SIZE, Measure, THINNEST};
use cga_split::solve;

/// Splits with more pieces are solved while rules run: the pieces would take more room than the arithmetic takes time.
const MOST_PIECES: u64 = 64;

/// The known extents of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
struct KnownExtents {
    /// The scope's size along each axis.
    size: [Option<f64>; 3],
    /// The geometry is a box that fills the scope, so parts of it fill their slots.
    solid: bool,
    /// Trim planes may cut what is put into the scope.
    trimmed: bool,
}

const NOTHING: KnownExtents = KnownExtents { size: [None; 3], solid: false, trimmed: true };

/// Of an initial shape, which has no trim planes.
const INITIAL: KnownExtents = KnownExtents { trimmed: false, ..NOTHING };

impl KnownExtents {
    /// The join of two paths.
    fn and(self, other: KnownExtents) -> KnownExtents {
        let both = |axis: usize| self.size[axis].filter(|size| other.size[axis] == Some(*size));
        KnownExtents {
            size: [both(0), both(1), both(2)],
            solid: self.solid && other.solid,
            trimmed: self.trimmed || other.trimmed,
        }
    }

    /// With another scope.
    fn moved_on(self) -> KnownExtents {
        KnownExtents { trimmed: self.trimmed, ..NOTHING }
    }

    /// Returns true if it always extends along all axes.
    fn has_room(self) -> bool {
        let sizes = self.size.map(|size| size.map_or(0.0, f64::abs));
        sizes.iter().all(|size| THINNEST * sizes.iter().fold(0.0, |most: f64, size| most.max(*size)) < *size)
    }

    fn resize(self, args: &[Arg]) -> KnownExtents {
        let mut size = [None; 3];
        for ((size, arg), old) in size.iter_mut().zip(args).zip(self.size) {
            if let Arg::Length(length) = arg {
                *size = new_size(length, old);
            }
        }
        let sized = KnownExtents { size, ..self };
        // A box without an extent stays flat.
        KnownExtents { solid: self.solid && sized.has_room(), ..sized }
    }
}

/// The size after a length is applied, if it is known.
fn new_size(length: &Size, old: Option<f64>) -> Option<f64> {
    let number = constant(length)?;
    let number = if number.is_finite() { number } else { 0.0 };
    let new = if length.prefix == Prefix::Absolute { number } else { number * old? };
    if new.abs() <= MOST_SIZE { Some(new) } else { old }
}

fn constant(size: &Size) -> Option<f64> {
    match &size.value.kind {
        crate::ir::ExprKind::Value(Value::Float(value)) => Some(*value),
        _ => None,
    }
}

/// Solves what can be solved.
pub(super) fn solve_known(grammar: &mut Grammar) {
    let mut entries: Vec<Option<KnownExtents>> = vec![None; grammar.rules.len()];
    let mut changed: Vec<RuleId> = Vec::new();
    for start in &grammar.starts {
        entries[start.rule.0 as usize] = Some(INITIAL);
        changed.push(start.rule);
    }
    // The knowledge about a rule only shrinks, so the loop ends.
    while let Some(rule) = changed.pop() {
        let index = rule.0 as usize;
        let Some(known) = entries[index] else { continue };
        follow(&mut grammar.rules[index].body, known, &mut |target, known| {
            let Target::Rule { rule, .. } = target else { return };
            let entry = &mut entries[rule.0 as usize];
            let both = entry.map_or(known, |before| before.and(known));
            if *entry != Some(both) {
                *entry = Some(both);
                changed.push(*rule);
            }
        });
    }
}

/// Follows a shape through steps and solves the splits on the way; calls `hand_on` with what is known of the shapes that
/// leave them. A rule is followed again when less is known of it, so the last solution stands.
fn follow(steps: &mut [Step], mut known: KnownExtents, hand_on: &mut dyn FnMut(&Target, KnownExtents)) -> KnownExtents {
    for step in steps {
        match &mut step.kind {
            StepKind::Give(target) | StepKind::Renew(Renew { target, .. }) => hand_on(target, known),
            StepKind::Block(block) => known = divide(block, known, hand_on),
            StepKind::Push(inner) => {
                follow(inner, known, hand_on);
            }
            StepKind::Case { arms, otherwise } => {
                let branches = arms.iter_mut().map(|(_, inner)| inner).chain([otherwise]);
                let after = branches.map(|inner| follow(inner, known, hand_on)).reduce(KnownExtents::and);
                known = after.unwrap_or(known);
            }
            kind => known = after(kind, known),
        }
    }
    known
}

/// The extents after a step without successors.
fn after(kind: &StepKind, known: KnownExtents) -> KnownExtents {
    match kind {
        StepKind::Do(row, args) => match row.scope {
            Effect::Keeps => known,
            Effect::KeepsSize => KnownExtents { solid: false, ..known },
            Effect::Sizes => known.resize(args),
            Effect::FillsWithBox if known.has_room() => KnownExtents { solid: !known.trimmed, ..known },
            Effect::Fills if known.has_room() => KnownExtents { solid: false, ..known },
            Effect::Any
            | Effect::MovesScope
            | Effect::Extrudes
            | Effect::Flattens
            | Effect::FillsWithBox
            | Effect::Fills => known.moved_on(),
        },
        StepKind::SetShape(row, ..) if row.set_scope != Effect::Keeps => known.moved_on(),
        StepKind::Rust(..) => NOTHING,
        _ => known,
    }
}

/// Solves the slots of an operation if it can, and hands its parts on. Returns the extents after the operation.
fn divide(block: &mut Block, known: KnownExtents, hand_on: &mut dyn FnMut(&Target, KnownExtents)) -> KnownExtents {
    let (axis, adjusts) = (block.axis(), block.adjusts());
    match (&mut block.parts, block.row.braces, axis) {
        (BlockParts::Slots(slots), Braces::Slots(measure @ (Measure::Length | Measure::Area)), Some(axis)) => {
            slots.solved = if measure == Measure::Length { solved(slots, axis, known) } else { None };
            for (slot, target) in slots.targets.iter().enumerate() {
                let stays = known.solid || !adjusts;
                hand_on(target, if stays { part(slots, axis, slot, known) } else { known.moved_on() });
            }
        }
        (BlockParts::Slots(slots), ..) => slots.targets.iter().for_each(|target| hand_on(target, known.moved_on())),
        (BlockParts::Arms(arms), ..) => arms.iter().for_each(|arm| hand_on(&arm.then, NOTHING)),
        (BlockParts::Sections(parts), ..) => {
            let rest = parts.rest.iter().map(|arm| &arm.then);
            parts.slots.targets.iter().chain(rest).for_each(|target| hand_on(target, NOTHING));
        }
        (BlockParts::Each(target), ..) => hand_on(target, NOTHING),
        (BlockParts::Operands(targets), ..) => {
            targets.iter().for_each(|target| hand_on(target, known));
            return NOTHING;
        }
    }
    known
}

/// The parts in a slot, where they fill their pieces.
fn part(slots: &Slots, axis: Axis, slot: usize, known: KnownExtents) -> KnownExtents {
    let mut part = known;
    let axis = axis as usize;
    let pieces = slots.solved.as_ref().map_or(&[][..], |solved| &solved.pieces);
    let mut lengths = pieces.iter().filter(|piece| piece.slot as usize == slot).map(|piece| piece.length);
    let first = lengths.next().filter(|first| lengths.all(|length| length == *first));
    part.size[axis] = first.zip(known.size[axis]).map(|(length, size)| length.copysign(size));
    part
}

/// The solution of a split, where it can be known.
fn solved(slots: &Slots, axis: Axis, known: KnownExtents) -> Option<Solved> {
    let extent = known.size[axis as usize]?.abs();
    let sizes = slots.sizes.iter().map(|size| {
        let value = constant(size)?;
        Some(cga_split::Size { prefix: size.prefix, value })
    });
    let sizes: Vec<cga_split::Size> = sizes.collect::<Option<_>>()?;
    // NaN and infinite sizes are left to the run, which reports a fault.
    if sizes.iter().any(|size| !size.value.is_finite()) {
        return None;
    }
    let mut lengths = vec![0.0; sizes.len()];
    let solution = solve(&slots.pattern, &sizes, &mut lengths, extent);
    (solution.at_most() <= MOST_PIECES).then(|| Solved { extent, pieces: solution.pieces() })
}
