//! Loops on which the coordinate rises once and falls once: each band has one piece of them.

use super::super::class::{Class, Span};
use super::super::points::{Location, PieceCorner};

/// The two ways of a loop: from the lowest corner up, and from the highest corner down.
#[derive(Default)]
pub(super) struct Chain {
    /// The way up, with all nodes at the lowest and the highest level.
    up: Vec<PieceCorner>,
    /// The way down, from the top.
    down: Vec<PieceCorner>,
}

/// The borders of a band that cut a loop.
#[derive(Clone, Copy)]
pub(super) struct Borders {
    pub(super) lower: bool,
    pub(super) upper: bool,
}

impl Chain {
    /// Walks around a loop, given as corners with their places, and makes its crossings.
    pub(super) fn walk(
        &mut self,
        ring: impl ExactSizeIterator<Item = (usize, Location)> + Clone,
        span: Span,
        mut cross: impl FnMut((usize, Class), (usize, Class), &mut Vec<PieceCorner>),
    ) {
        self.up.clear();
        self.down.clear();
        // The first corner at the lowest level.
        let mut before = ring.clone().last().map(|(_, place)| place.class);
        let start = ring
            .clone()
            .position(|(_, place)| before.replace(place.class) != Some(span.low) && place.class == span.low);
        let start = start.unwrap_or(0);
        let count = ring.len();
        let cycle = ring.cycle().skip(start).take(count + 1);
        let mut cycle = cycle.peekable();
        let mut rising = true;
        while let Some((corner, place)) = cycle.next() {
            let Some(&(next, next_place)) = cycle.peek() else { break };
            let way = if rising { &mut self.up } else { &mut self.down };
            way.push(PieceCorner::corner(corner, place));
            // The way down begins after the last corner at the highest level.
            rising &= place.class != span.high || next_place.class == span.high;
            let way = if rising { &mut self.up } else { &mut self.down };
            cross((corner, place.class), (next, next_place.class), way);
        }
    }

    /// Calls `each` with the nodes in each band: first the way up, then the way down.
    pub(super) fn bands(&self, span: Span, mut each: impl FnMut(u32, &[PieceCorner], &[PieceCorner], Borders)) {
        let (mut up, mut down) = (0, self.down.len());
        let mut lower = false;
        for band in span.slabs() {
            let ceiling = Class::on(band);
            let up_start = up;
            while up < self.up.len() && self.up[up].class() <= ceiling {
                up += 1;
            }
            let mut down_start = down;
            while down_start > 0 && self.down[down_start - 1].class() <= ceiling {
                down_start -= 1;
            }
            let upper = up < self.up.len();
            each(band, &self.up[up_start..up], &self.down[down_start..down], Borders { lower, upper });
            down = down_start;
            lower = upper;
            if upper {
                // Both ways have a node on the upper line, and the next band begins with it.
                up -= 1;
                down += 1;
            }
        }
    }
}

/// Returns true if the values around a loop rise once and fall once, with repeated values only at the lowest or highest
/// level.
pub(super) fn rises_once(values: impl ExactSizeIterator<Item = f64> + Clone) -> bool {
    let low = values.clone().fold(f64::INFINITY, f64::min);
    let high = values.clone().fold(f64::NEG_INFINITY, f64::max);
    let Some(mut last) = values.clone().last() else { return false };
    let (mut turns, mut rising, mut first) = (0, None, None);
    for value in values {
        if value == last {
            if value != low && value != high {
                return false;
            }
            continue;
        }
        let now = last < value;
        first = first.or(Some(now));
        turns += usize::from(rising.is_some_and(|rising| rising != now));
        (rising, last) = (Some(now), value);
    }
    turns + usize::from(rising != first) <= 2
}

#[cfg(test)]
mod tests {
    use super::rises_once;

    #[test]
    fn one_rise_and_one_fall() {
        let once = |values: &[f64]| rises_once(values.iter().copied());
        assert!(once(&[0.0, 1.0, 1.0, 0.0]) && once(&[0.0, 0.5, 1.0, 0.25]) && once(&[1.0, 0.0, 0.0, 0.5, 1.0]));
        assert!(!once(&[0.0, 1.0, 0.0, 1.0]) && !once(&[0.0, 0.5, 0.5, 1.0]));
        assert!(!once(&[0.0, 1.0, 0.5, 1.0, 0.0]) && !once(&[0.5, 0.0, 0.25, 0.0, 1.0]));
    }
}
