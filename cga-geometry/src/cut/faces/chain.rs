//! Loops that rise once and fall once: each slab has one piece of them.

use std::ops::Range;

use super::first_edge::first_node;
use crate::cut::class::{Class, ClassRange};
use crate::cut::points::PieceCorner;
use crate::each::Each;

/// The two ways of a loop: from the lowest corner up, and from the highest corner down.
#[derive(Default)]
pub(crate) struct Chain {
    /// The way up, with all nodes at the lowest and the highest level.
    up: Vec<PieceCorner>,
    /// The way down, from the top.
    down: Vec<PieceCorner>,
}

/// The borders of a slab that cut a loop.
#[derive(Clone, Copy)]
pub(crate) struct Borders {
    pub(crate) lower: bool,
    pub(crate) upper: bool,
}

impl Chain {
    /// Walks around a loop of `count` corners, which `node` returns, and makes its crossings.
    #[inline]
    pub(crate) fn walk(
        &mut self,
        count: usize,
        span: ClassRange,
        node: impl Fn(usize) -> PieceCorner,
        mut cross: impl FnMut(PieceCorner, PieceCorner, &mut Vec<PieceCorner>),
    ) {
        let Chain { up, down } = self;
        up.clear();
        down.clear();
        let after = |i: usize| if i + 1 == count { 0 } else { i + 1 };
        // The first corner at the lowest level.
        let is_low = |i: usize| node(i).class() == span.low;
        let start = (0..count).find(|&i| !is_low(i) && is_low(after(i))).map_or(0, after);
        let (mut here, mut way) = (start, up);
        loop {
            let next = after(here);
            let [from, to] = [here, next].each(&node);
            way.push(from);
            // The way down begins after the last corner at the highest level.
            if from.class() == span.high && to.class() != span.high {
                way = &mut *down;
            }
            cross(from, to, way);
            here = next;
            if here == start {
                return;
            }
        }
    }

    /// Calls `each` with the nodes in each slab: first the way up, then the way down.
    #[inline]
    pub(crate) fn pieces(&self, span: ClassRange, mut each: impl FnMut(u32, &[PieceCorner], &[PieceCorner], Borders)) {
        let (mut up, mut down) = (0, self.down.len());
        let mut lower = false;
        for slab in span.slabs() {
            let ceiling = Class::on(slab);
            let up_start = up;
            while up < self.up.len() && self.up[up].class() <= ceiling {
                up += 1;
            }
            let mut down_start = down;
            while down_start > 0 && self.down[down_start - 1].class() <= ceiling {
                down_start -= 1;
            }
            let upper = up < self.up.len();
            each(slab, &self.up[up_start..up], &self.down[down_start..down], Borders { lower, upper });
            down = down_start;
            lower = upper;
            if upper {
                // Both ways have a node on the upper plane, and the next slab begins with it.
                up -= 1;
                down += 1;
            }
        }
    }

    /// The corners on the way up.
    pub(crate) fn up(&self) -> &[PieceCorner] {
        &self.up
    }
}

/// The corners of a piece from its first edge on, in three runs, given by its way up and its way down. `None` for a
/// piece with fewer than three corners.
#[inline]
pub(crate) fn runs<'n>(
    ahead: &'n [PieceCorner],
    mut back: &'n [PieceCorner],
    outline: &Range<usize>,
) -> Option<[&'n [PieceCorner]; 3]> {
    let is_at = |node: Option<&PieceCorner>, other: &PieceCorner| node.is_some_and(|node| node.place == other.place);
    // If the loop meets itself on a plane, the same corner must not follow itself.
    if is_at(back.first(), &ahead[ahead.len() - 1]) {
        back = &back[1..];
    }
    if is_at(back.last(), &ahead[0]) {
        back = &back[..back.len() - 1];
    }
    if ahead.len() + back.len() < 3 {
        return None;
    }
    let first = first_node(ahead.iter().chain(back), outline);
    Some(match first.checked_sub(ahead.len()) {
        None => [&ahead[first..], back, &ahead[..first]],
        Some(first) => [&back[first..], ahead, &back[..first]],
    })
}

/// Returns true if the levels of a loop rise once and fall once. Only levels that `may_repeat` accepts may follow
/// themselves.
pub(crate) fn rises_once<T: PartialOrd + Copy>(
    levels: impl DoubleEndedIterator<Item = T> + Clone,
    may_repeat: impl Fn(T) -> bool,
) -> bool {
    let Some(mut last) = levels.clone().next_back() else { return false };
    let (mut turns, mut rising, mut first) = (0, None, None);
    for level in levels {
        if level == last {
            if !may_repeat(level) {
                return false;
            }
            continue;
        }
        let now = last < level;
        first = first.or(Some(now));
        turns += usize::from(rising.is_some_and(|rising| rising != now));
        (rising, last) = (Some(now), level);
    }
    turns + usize::from(rising != first) <= 2
}

#[cfg(test)]
mod tests {
    use super::rises_once;

    #[test]
    fn one_rise_and_one_fall() {
        let once = |values: &[f64]| {
            let (low, high) = (values.iter().copied().fold(1.0, f64::min), values.iter().copied().fold(0.0, f64::max));
            rises_once(values.iter().copied(), |value| value == low || value == high)
        };
        assert!(once(&[0.0, 1.0, 1.0, 0.0]) && once(&[0.0, 0.5, 1.0, 0.25]) && once(&[1.0, 0.0, 0.0, 0.5, 1.0]));
        assert!(!once(&[0.0, 1.0, 0.0, 1.0]) && !once(&[0.0, 0.5, 0.5, 1.0]));
        assert!(!once(&[0.0, 1.0, 0.5, 1.0, 0.0]) && !once(&[0.5, 0.0, 0.25, 0.0, 1.0]));
    }
}
