//! How many repetitions fill an extent best.

use crate::choices::{as_near, smallest_piece};
use crate::{Prefix, Size};

/// No pattern is repeated more often; whoever lays pieces out has a lower limit of their own.
const MOST: u64 = 1 << 48;

/// Absolute and floating sums of lengths.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sum {
    pub(crate) absolute: f64,
    pub(crate) floating: f64,
}

impl Sum {
    /// Counts a slot of that length in.
    #[inline]
    pub(crate) fn add(&mut self, size: &Size, length: f64) {
        match size.prefix {
            Prefix::Floating => self.floating += length,
            Prefix::Absolute | Prefix::Relative => self.absolute += length,
        }
    }

    #[inline]
    pub(crate) fn plus(self, other: Sum, times: f64) -> Sum {
        Sum { absolute: self.absolute + times * other.absolute, floating: self.floating + times * other.floating }
    }

    /// The same, or the largest number where it is too large for one: so that none of it is nothing.
    #[inline]
    pub(crate) fn finite(self) -> Sum {
        Sum { absolute: self.absolute.min(f64::MAX), floating: self.floating.min(f64::MAX) }
    }

    /// The length before anything is stretched.
    #[inline]
    pub(crate) fn nominal(self) -> f64 {
        self.absolute + self.floating
    }

    /// The common factor of all floats that fills the extent; zero when there is no room for them, or when there are none.
    #[inline]
    pub(crate) fn stretch(self, extent: f64) -> f64 {
        let room = extent - self.absolute;
        if 0.0 < self.floating && smallest_piece(extent) < room { room / self.floating } else { 0.0 }
    }

    /// Whether there is room for all absolute sizes.
    #[inline]
    fn fits(self, extent: f64) -> bool {
        self.absolute <= extent + smallest_piece(extent)
    }
}

/// A number of repetitions is looked for; `total` knows the sums with so many of them.
pub(crate) struct Search<F> {
    pub(crate) extent: f64,
    /// What stands outside all groups.
    pub(crate) outside: Sum,
    /// How many groups can repeat.
    pub(crate) groups: u64,
    /// How long one repetition of each is, nothing stretched.
    pub(crate) one_each: f64,
    pub(crate) total: F,
}

impl<F: FnMut(u64) -> Sum> Search<F> {
    /// The largest number whose nominal lengths fit into `extent`, but at least `least`. They grow with the number, evenly
    /// where no group is nested, so the search starts where that would put it.
    #[inline]
    fn last_that_fits(&mut self, least: u64, extent: f64) -> u64 {
        let guess = (extent - self.outside.nominal()) / self.one_each * self.groups as f64;
        let mut fits = |turns: u64| turns <= MOST && (self.total)(turns).nominal() <= extent;
        let mut good = (guess.clamp(0.0, MOST as f64) as i64 as u64).max(least);
        // Down to one that fits, in growing steps, then up again, in growing and in shrinking ones.
        let mut step = 1;
        while least < good && !fits(good) {
            good = good.saturating_sub(step).max(least);
            step *= 2;
        }
        let mut step = 1;
        while fits(good + step) {
            good += step;
            step *= 2;
        }
        while 1 < step {
            step /= 2;
            if fits(good + step) {
                good += step;
            }
        }
        good
    }

    /// With floats somewhere: the number whose common stretch is nearest to 1, and that stretch. It falls as they grow, so
    /// only the last number with a stretch of 1 or more and the next one can win.
    #[inline]
    pub(crate) fn least_stretch(&mut self, least: u64) -> (u64, f64) {
        let fewer = self.last_that_fits(least, self.extent);
        let (sum, one_more) = ((self.total)(fewer), (self.total)(fewer + 1));
        let (stretch, less) = (sum.stretch(self.extent), one_more.stretch(self.extent));
        if as_near(stretch, less) && one_more.fits(self.extent) { (fewer + 1, less) } else { (fewer, stretch) }
    }

    /// Without floats: repetitions until `room` is full. Whether the last one has to be cut.
    #[inline]
    pub(crate) fn fill(&mut self, room: f64) -> (u64, bool) {
        let rest = smallest_piece(self.extent);
        if room <= rest {
            return (0, false);
        }
        let full = self.last_that_fits(0, self.extent + rest);
        let used = (self.total)(full).absolute - self.outside.absolute;
        if room - used <= rest { (full, false) } else { (full + 1, true) }
    }
}
