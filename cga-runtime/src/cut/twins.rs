//! Loops that are there several times, as where a mesh has its faces twice.

use std::collections::HashMap;
use std::ops::Range;

use glam::DVec2;

use super::contour::Section;

/// Which loops go through the same places in the same order.
#[derive(Default)]
pub(super) struct Twins {
    /// Of loops that are not the first of their kind, which one is, and how many came before.
    first: HashMap<usize, (usize, usize)>,
    /// Of the first ones that are not alone, all of the kind.
    all: HashMap<usize, Vec<usize>>,
    order: Vec<(DVec2, DVec2, usize)>,
}

impl Twins {
    /// Finds them among loops, each given by its corners and its box.
    pub(super) fn find(
        &mut self,
        section: &Section<'_>,
        loops: impl Iterator<Item = (Range<usize>, DVec2, DVec2)> + Clone,
    ) {
        self.first.clear();
        self.all.clear();
        self.order.clear();
        self.order.extend(loops.clone().enumerate().map(|(number, (_, low, high))| (low, high, number)));
        let key = |&(low, high, number): &(DVec2, DVec2, usize)| (low.x, low.y, high.x, high.y, number);
        self.order.sort_unstable_by(|a, b| key(a).partial_cmp(&key(b)).unwrap_or(a.2.cmp(&b.2)));
        if self.order.windows(2).all(|pair| (pair[0].0, pair[0].1) != (pair[1].0, pair[1].1)) {
            return;
        }
        let ranges: Vec<Range<usize>> = loops.map(|(range, ..)| range).collect();
        for same_box in self.order.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).filter(|group| group.len() > 1) {
            let mut kinds: Vec<usize> = Vec::new();
            for &(_, _, number) in same_box {
                let own = section.ring(&ranges[number]);
                match kinds.iter().find(|&&kind| are_same(section, own, section.ring(&ranges[kind]))) {
                    None => kinds.push(number),
                    Some(&kind) => {
                        let all = self.all.entry(kind).or_insert_with(|| vec![kind]);
                        self.first.insert(number, (kind, all.len()));
                        all.push(number);
                    }
                }
            }
        }
    }

    /// The first loop of a loop's kind, and how many of the kind came before it.
    pub(super) fn first(&self, number: usize) -> (usize, usize) {
        self.first.get(&number).copied().unwrap_or((number, 0))
    }

    /// Loops that are not the first of their kind, each with which one is; in no useful order.
    pub(super) fn others(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.first.iter().map(|(&number, &(first, _))| (number, first))
    }

    /// Of a kind, given by its first loop, the one with a number, from the start again beyond the last.
    pub(super) fn nth(&self, first: usize, number: usize) -> usize {
        self.all.get(&first).map_or(first, |all| all[number % all.len()])
    }
}

/// Whether two loops go through the same places in the same order, wherever they start.
fn are_same(section: &Section<'_>, a: &[u32], b: &[u32]) -> bool {
    let at = |corner: &u32| section.flat[*corner as usize];
    let Some(turn) = b.iter().position(|corner| at(corner) == at(&a[0])).filter(|_| a.len() == b.len()) else {
        return false;
    };
    a.iter().zip(b[turn..].iter().chain(&b[..turn])).all(|(a, b)| at(a) == at(b))
}
