//! Short lists that grow in any order, in one allocation.

use std::ops::Range;

/// Lists in blocks whose sizes are powers of two. A list that fills its block moves to one of twice the size, and another list gets
/// the block that it leaves.
#[derive(Debug)]
pub(super) struct GrowingLists<T> {
    items: Vec<T>,
    blocks: Vec<Block>,
    /// The starts of free blocks, by the logarithm of their size.
    free: [Vec<u32>; 32],
}

/// The place of a list.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    start: u32,
    len: u32,
    size: u32,
}

impl Block {
    fn range(self) -> Range<usize> {
        self.start as usize..(self.start + self.len) as usize
    }
}

impl<T> Default for GrowingLists<T> {
    fn default() -> Self {
        GrowingLists { items: Vec::new(), blocks: Vec::new(), free: Default::default() }
    }
}

impl<T: Copy> GrowingLists<T> {
    pub(super) fn of(&self, list: u32) -> &[T] {
        self.blocks.get(list as usize).map_or(&[], |block| &self.items[block.range()])
    }

    pub(super) fn of_mut(&mut self, list: u32) -> &mut [T] {
        self.blocks.get(list as usize).map_or(&mut [], |block| &mut self.items[block.range()])
    }

    pub(super) fn push(&mut self, list: u32, item: T) {
        self.insert(list, self.of(list).len(), item);
    }

    /// Inserts an element at a place in a list.
    pub(super) fn insert(&mut self, list: u32, at: usize, item: T) {
        if self.blocks.len() <= list as usize {
            self.blocks.resize(list as usize + 1, Block::default());
        }
        let mut block = self.blocks[list as usize];
        if block.len == block.size {
            let old = block;
            block = self.take_block((2 * old.size).max(1), item);
            self.items.copy_within(old.range(), block.start as usize);
            block.len = old.len;
            self.give_block(old);
        }
        let Range { start, end } = block.range();
        self.items.copy_within(start + at..end, start + at + 1);
        self.items[start + at] = item;
        self.blocks[list as usize] = Block { len: block.len + 1, ..block };
    }

    /// Keeps the elements of a list that `stays` accepts.
    pub(super) fn retain(&mut self, list: u32, stays: impl Fn(&T) -> bool) {
        let Some(block) = self.blocks.get_mut(list as usize) else { return };
        let Range { start, end } = block.range();
        block.len = 0;
        for at in start..end {
            if stays(&self.items[at]) {
                self.items[start + block.len as usize] = self.items[at];
                block.len += 1;
            }
        }
    }

    /// Drops all elements of a list.
    pub(super) fn clear(&mut self, list: u32) {
        if let Some(block) = self.blocks.get_mut(list as usize) {
            let old = std::mem::take(block);
            self.give_block(old);
        }
    }

    /// An empty block.
    fn take_block(&mut self, size: u32, filler: T) -> Block {
        let free = self.free[size.ilog2() as usize].pop();
        let start = free.unwrap_or_else(|| {
            let end = self.items.len();
            self.items.resize(end + size as usize, filler);
            end as u32
        });
        Block { start, len: 0, size }
    }

    fn give_block(&mut self, block: Block) {
        if block.size != 0 {
            self.free[block.size.ilog2() as usize].push(block.start);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Rng;

    #[test]
    fn lists_are_those_of_the_standard_library() {
        let rng = &mut Rng(3);
        let (mut lists, mut expected, mut longest) = (GrowingLists::default(), vec![Vec::new(); 9], 0);
        for step in 0..5_000_u64 {
            let list = rng.next() as usize % expected.len();
            if step % 50 == 0 {
                lists.clear(list as u32);
                expected[list].clear();
            } else if step % 7 == 0 {
                let least = rng.next() % 400;
                lists.retain(list as u32, |item| least < *item % 500);
                expected[list].retain(|item| least < *item % 500);
            } else {
                let at = rng.next() as usize % (expected[list].len() + 1);
                lists.insert(list as u32, at, step);
                expected[list].insert(at, step);
            }
            longest = longest.max(expected[list].len());
            assert!((0..).zip(&expected).all(|(list, own)| lists.of(list) == own));
        }
        // Blocks are used again: at most one of each size for each list.
        assert!(lists.items.len() <= 9 * 2 * longest.next_power_of_two(), "{} {longest}", lists.items.len());
    }
}
