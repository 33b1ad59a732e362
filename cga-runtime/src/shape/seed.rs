//! Random numbers of shapes. They do not depend on the order of work.
//!
//! The seed of a child is affine in the seed of its parent: `parent·K + key`. The key follows from the operation that
//! makes the child, from its place in the rule, from the slot and from the repetition. So an edit in one branch of
//! the rules does not change the others, and parallel, serial and foreign runs agree bit for bit. A seed is mixed
//! (splitmix64) only when a number is drawn: most shapes are leaves and never draw.

/// The operation that made a child. It is part of the seed, so these numbers must never change.
#[derive(Clone, Copy, Debug)]
#[repr(u64)]
pub(crate) enum Tag {
    Successor = 1,
    Split = 2,
    Comp = 3,
    Push = 4,
    Global = 6,
    Candidate = 7,
}

/// The seed of a shape, and the number of its draws so far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seed {
    value: u64,
    draws: u32,
    /// The number of steps since a seed that was given. It counts for templates: it is the power of [`FACTOR`] in [`Seed::factor`].
    steps: u32,
}

/// The factor from a seed to the seeds of its children. It is odd, so no bit is lost.
const FACTOR: u64 = 0x9fb2_1c65_1e98_df25;
/// The number of steps of a seed that a rule has set. No derivation has as many steps.
const SET: u32 = 1 << 31;
/// The step from one drawn number to the next.
const DRAW: u64 = 0x9e37_79b9_7f4a_7c15;
/// The step from one slot of a split, or component of a comp, to the next.
const SLOT: u64 = 0xd6e8_feb8_6659_fd93;
/// The step from one repetition of a group to the next.
const TURN: u64 = 0xe703_7ed1_a0b4_28db;

const fn mix(mut x: u64) -> u64 {
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// The key of the children of one step of a rule; `number` counts these steps. It is a constant in generated code.
pub(crate) const fn key(tag: Tag, number: u32) -> u64 {
    mix(((tag as u64) << 32 | number as u64).wrapping_add(DRAW))
}

impl Seed {
    pub(crate) const fn new(value: u64) -> Self {
        Seed { value, draws: 0, steps: 0 }
    }

    /// A seed that a rule sets: it does not depend on the seed before it.
    pub(crate) const fn set(value: u64) -> Self {
        Seed { value, draws: 0, steps: SET }
    }

    /// The factor of the seed that was given at first, in the sum that this seed is.
    pub(crate) fn factor(self) -> u64 {
        if SET <= self.steps { 0 } else { FACTOR.wrapping_pow(self.steps) }
    }

    /// The seed of the children of a step, before slot and repetition are known.
    #[inline(always)]
    pub(crate) fn step(self, key: u64) -> Seed {
        let value = self.value.wrapping_mul(FACTOR).wrapping_add(key);
        Seed { value, draws: 0, steps: self.steps.wrapping_add(1) }
    }

    /// The seed of a part: a slot in a repetition of its group, or a component. This is the seed of the step.
    #[inline(always)]
    pub(crate) fn part(self, slot: u32, turn: u64) -> Seed {
        let value = self.value.wrapping_add(u64::from(slot).wrapping_mul(SLOT)).wrapping_add(turn.wrapping_mul(TURN));
        Seed { value, draws: 0, steps: self.steps }
    }

    pub(crate) fn value(self) -> u64 {
        self.value
    }

    /// A random integer that a float can hold exactly.
    pub(crate) fn scattered(self) -> u64 {
        mix(self.value.wrapping_add(DRAW)) >> 11
    }

    /// The seed of the child with a number.
    pub(crate) fn child(self, tag: Tag, number: u32) -> Seed {
        self.step(key(tag, number))
    }

    /// The seed for the components that an expression makes. It counts as a draw.
    pub(crate) fn branch(&mut self) -> Seed {
        self.draws = self.draws.wrapping_add(1);
        self.child(Tag::Comp, self.draws | 1 << 31)
    }

    /// The next random number in 0..1.
    #[inline]
    pub(crate) fn draw(&mut self) -> f64 {
        self.draws = self.draws.wrapping_add(1);
        // Mixed twice: the seeds of parts differ by a constant, as the numbers of one seed do.
        let own = mix(self.value.wrapping_mul(FACTOR).wrapping_add(DRAW));
        let bits = mix(own.wrapping_add(u64::from(self.draws).wrapping_mul(DRAW)));
        (bits >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[cfg(test)]
mod tests;
