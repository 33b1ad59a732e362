//! Disjoint sets of numbers (union-find).

use crate::each::Each;

/// Disjoint sets of the numbers below a count, each named by its smallest member. Methods panic if a number is not below the
/// count.
#[derive(Debug, Default)]
pub struct DisjointSets {
    /// A smaller member of the same set, or the number itself if it is the smallest.
    parent: Vec<u32>,
}

impl DisjointSets {
    /// Sets with one number each.
    pub fn new(count: usize) -> Self {
        DisjointSets { parent: (0..count as u32).collect() }
    }

    /// The smallest member of a number's set. Many searches take long before [`flatten`](Self::flatten).
    #[inline]
    pub fn find(&self, mut number: u32) -> u32 {
        while self.parent[number as usize] != number {
            number = self.parent[number as usize];
        }
        number
    }

    /// Unites the sets of two numbers.
    pub fn unite(&mut self, a: u32, b: u32) {
        // Mostly both sets are flat and one already.
        if self.parent[a as usize] == self.parent[b as usize] {
            return;
        }
        let [a, b] = [a, b].each(|number| self.find_and_shorten(number));
        self.parent[a.max(b) as usize] = a.min(b);
    }

    /// The sets, in the order of their smallest members.
    pub fn sets(mut self) -> Vec<Vec<u32>> {
        self.flatten();
        let (mut sets, mut places): (Vec<Vec<u32>>, _) = (Vec::new(), vec![0; self.parent.len()]);
        for number in 0..self.parent.len() as u32 {
            let first = self.find(number);
            if first == number {
                places[number as usize] = sets.len();
                sets.push(Vec::new());
            }
            sets[places[first as usize]].push(number);
        }
        sets
    }

    /// Makes every later [`find`](Self::find) a single step.
    pub fn flatten(&mut self) {
        for number in 0..self.parent.len() {
            // Smaller numbers are flat already.
            self.parent[number] = self.parent[self.parent[number] as usize];
        }
    }

    /// Makes every later [`find`](Self::find) of some numbers a single step. They are sorted, and for each of them all
    /// members of its set are among them.
    pub(crate) fn flatten_some(&mut self, numbers: &[u32]) {
        for &number in numbers {
            self.parent[number as usize] = self.parent[self.parent[number as usize] as usize];
        }
    }

    /// Changes the count. New numbers are sets of their own.
    pub(crate) fn resize(&mut self, count: usize) {
        self.parent.truncate(count);
        self.parent.extend(self.parent.len() as u32..count as u32);
    }

    /// Makes a number a set of its own. The other members of its set must follow before the next search.
    pub(crate) fn isolate(&mut self, number: u32) {
        self.parent[number as usize] = number;
    }

    /// The same as [`find`](Self::find), and shortens later searches.
    pub(crate) fn find_and_shorten(&mut self, mut number: u32) -> u32 {
        while self.parent[number as usize] != number {
            let above = self.parent[self.parent[number as usize] as usize];
            self.parent[number as usize] = above;
            number = above;
        }
        number
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_named_by_their_smallest_member() {
        let mut sets = DisjointSets::new(7);
        for [a, b] in [[5, 6], [4, 5], [1, 3], [6, 3]] {
            sets.unite(a, b);
        }
        let names = |sets: &DisjointSets| (0..7).map(|number| sets.find(number)).collect::<Vec<_>>();
        assert_eq!(names(&sets), [0, 1, 2, 1, 1, 1, 1]);
        sets.flatten();
        assert_eq!(names(&sets), sets.parent);
        assert_eq!(sets.sets(), [vec![0], vec![1, 3, 4, 5, 6], vec![2]]);
    }

    #[test]
    fn the_sets_of_a_long_chain_are_found_in_a_moment() {
        let count = 200_000;
        let mut sets = DisjointSets::new(count as usize);
        // Without `flatten` every search goes along half the chain: minutes.
        (1..count).rev().for_each(|number| sets.unite(number, number - 1));
        assert_eq!(sets.sets().len(), 1);
    }
}
