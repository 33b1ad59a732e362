//! The search for the number of repetitions that fills an extent best.

use crate::choices::{as_near, smallest_piece};
use crate::{Prefix, Size};

/// The largest number of repetitions. The code that lays out pieces has a lower limit of its own.
const MOST: f64 = (1u64 << 48) as f64;

/// The sums of absolute and of floating lengths.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LengthSum {
    pub(crate) absolute: f64,
    pub(crate) floating: f64,
}

impl LengthSum {
    /// Adds a slot of length `length`.
    #[inline]
    pub(crate) fn add(&mut self, size: &Size, length: f64) {
        match size.prefix {
            Prefix::Floating => self.floating += length,
            Prefix::Absolute | Prefix::Relative => self.absolute += length,
        }
    }

    #[inline]
    pub(crate) fn plus(self, other: LengthSum, times: f64) -> LengthSum {
        LengthSum { absolute: self.absolute + times * other.absolute, floating: self.floating + times * other.floating }
    }

    /// The length before floats are stretched.
    #[inline]
    pub(crate) fn nominal(self) -> f64 {
        self.absolute + self.floating
    }

    /// The common factor of all floats that fills the extent. Zero without room or without floats.
    #[inline]
    pub(crate) fn stretch(self, extent: f64) -> f64 {
        let room = extent - self.absolute;
        if 0.0 < self.floating && smallest_piece(extent) < room { room / self.floating } else { 0.0 }
    }

    /// Returns true if there is room for all absolute sizes.
    #[inline]
    fn fits(self, extent: f64) -> bool {
        self.absolute <= extent + smallest_piece(extent)
    }
}

/// A search for a number of repetitions. `total` returns the sums for a number of repetitions.
///
/// Numbers are whole numbers in `f64`, which represents all of them exactly and avoids conversions.
pub(crate) struct CountSearch<F> {
    pub(crate) extent: f64,
    /// The sums outside all groups.
    pub(crate) outside: LengthSum,
    /// The number of repetitions per metre without stretching. The search starts there and does not rely on it.
    pub(crate) density: f64,
    pub(crate) total: F,
}

impl<F: FnMut(f64) -> LengthSum> CountSearch<F> {
    #[inline(always)]
    fn with(&mut self, turns: f64) -> CountedLengths {
        CountedLengths { turns, sum: (self.total)(turns) }
    }

    /// The largest number whose nominal lengths fit into `extent`, but at least `least`, and the number after it. The
    /// lengths grow with the number, linearly without nested groups, so the search starts at the number that linear
    /// growth would give.
    #[inline(always)]
    fn last_that_fits(&mut self, least: f64, extent: f64) -> (CountedLengths, CountedLengths) {
        let guess = (extent - self.outside.nominal()) * self.density;
        let mut fits = self.with(whole(guess.max(least).min(MOST)).max(least));
        // First down to a number that fits, in growing steps. Then up, in growing steps. Then bisection between the
        // last two.
        let mut step = 1.0;
        while least < fits.turns && !fits.is_within(extent) {
            fits = self.with((fits.turns - step).max(least));
            step *= 2.0;
        }
        let mut step = 1.0;
        let mut over = self.with(fits.turns + step);
        while over.is_within(extent) {
            fits = over;
            step *= 2.0;
            over = self.with(fits.turns + step);
        }
        while 1.0 < step {
            step *= 0.5;
            let half = self.with(fits.turns + step);
            *(if half.is_within(extent) { &mut fits } else { &mut over }) = half;
        }
        (fits, over)
    }

    /// With floats: the number whose common stretch is nearest to 1, and that stretch. The stretch falls as the number
    /// grows, so only two candidates remain: the last number with a stretch of 1 or more, and the next one.
    #[inline(always)]
    pub(crate) fn least_stretch(&mut self, least: f64) -> (f64, f64) {
        let (fewer, more) = self.last_that_fits(least, self.extent);
        let (stretch, less) = (fewer.sum.stretch(self.extent), more.sum.stretch(self.extent));
        if as_near(stretch, less) && more.sum.fits(self.extent) { (more.turns, less) } else { (fewer.turns, stretch) }
    }

    /// Without floats: the number of repetitions that fill `room`, and whether the last one is cut.
    #[inline(always)]
    pub(crate) fn fill(&mut self, room: f64) -> (f64, bool) {
        let rest = smallest_piece(self.extent);
        if room <= rest {
            return (0.0, false);
        }
        let (full, _) = self.last_that_fits(0.0, self.extent + rest);
        let used = full.sum.absolute - self.outside.absolute;
        if room - used <= rest { (full.turns, false) } else { (full.turns + 1.0, true) }
    }
}

/// The whole number below `number`, or sometimes the next one. This avoids a slow conversion, and the search need not
/// start at the exact number.
#[inline(always)]
fn whole(number: f64) -> f64 {
    /// Numbers of this size have no fractions: adding it rounds.
    const NO_FRACTIONS: f64 = (3u64 << 51) as f64;
    number - 0.499_999 + NO_FRACTIONS - NO_FRACTIONS
}

/// A number of repetitions with its sums.
#[derive(Clone, Copy)]
struct CountedLengths {
    turns: f64,
    sum: LengthSum,
}

impl CountedLengths {
    #[inline(always)]
    fn is_within(&self, extent: f64) -> bool {
        self.turns <= MOST && self.sum.nominal() <= extent
    }
}
