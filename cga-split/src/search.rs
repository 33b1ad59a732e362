//! How many repetitions fill an extent best.

use crate::choices::{as_near, smallest_piece};
use crate::{Prefix, Size};

/// No pattern is repeated more often; whoever lays pieces out has a lower limit of their own.
const MOST: f64 = (1u64 << 48) as f64;

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
///
/// Numbers are whole ones in `f64`, which holds all of them and need not be converted.
pub(crate) struct Search<F> {
    pub(crate) extent: f64,
    /// What stands outside all groups.
    pub(crate) outside: Sum,
    /// How many groups can repeat.
    pub(crate) groups: f64,
    /// How long one repetition of each is, nothing stretched.
    pub(crate) one_each: f64,
    pub(crate) total: F,
}

impl<F: FnMut(f64) -> Sum> Search<F> {
    /// The largest number whose nominal lengths fit into `extent`, but at least `least`. They grow with the number, evenly
    /// where no group is nested, so the search starts where that would put it.
    #[inline]
    fn last_that_fits(&mut self, least: f64, extent: f64) -> f64 {
        let guess = (extent - self.outside.nominal()) / self.one_each * self.groups;
        let mut fits = |turns: f64| turns <= MOST && (self.total)(turns).nominal() <= extent;
        // Whatever is no number becomes zero.
        let mut good = (guess.min(MOST) as i64 as f64).max(least);
        // Down to one that fits, in growing steps, then up again, in growing and in shrinking ones.
        let mut step = 1.0;
        while least < good && !fits(good) {
            good = (good - step).max(least);
            step *= 2.0;
        }
        let mut step = 1.0;
        while fits(good + step) {
            good += step;
            step *= 2.0;
        }
        while 1.0 < step {
            step *= 0.5;
            if fits(good + step) {
                good += step;
            }
        }
        good
    }

    /// With floats somewhere: the number whose common stretch is nearest to 1, and that stretch. It falls as they grow, so
    /// only the last number with a stretch of 1 or more and the next one can win.
    #[inline]
    pub(crate) fn least_stretch(&mut self, least: f64) -> (f64, f64) {
        let fewer = self.last_that_fits(least, self.extent);
        let (sum, one_more) = ((self.total)(fewer), (self.total)(fewer + 1.0));
        let (stretch, less) = (sum.stretch(self.extent), one_more.stretch(self.extent));
        if as_near(stretch, less) && one_more.fits(self.extent) { (fewer + 1.0, less) } else { (fewer, stretch) }
    }

    /// Without floats: repetitions until `room` is full. Whether the last one has to be cut.
    #[inline]
    pub(crate) fn fill(&mut self, room: f64) -> (f64, bool) {
        let rest = smallest_piece(self.extent);
        if room <= rest {
            return (0.0, false);
        }
        let full = self.last_that_fits(0.0, self.extent + rest);
        let used = (self.total)(full).absolute - self.outside.absolute;
        if room - used <= rest { (full, false) } else { (full + 1.0, true) }
    }
}
