//! Edges on a sweep line, from left to right, in blocks: coming and going moves few of them.

/// A place in a row: a block, and a number within it.
pub(super) type Spot = (usize, usize);

/// Where blocks are divided.
const BLOCK: usize = 128;

/// No block is empty.
#[derive(Default)]
pub(super) struct Row {
    blocks: Vec<Vec<u32>>,
}

impl Row {
    pub(super) fn clear(&mut self) {
        self.blocks.clear();
    }

    /// The first place whose edge is not left of what is asked for.
    pub(super) fn spot(&self, is_left: impl Fn(u32) -> bool) -> Spot {
        let block = self.blocks.partition_point(|block| is_left(block[block.len() - 1]));
        match self.blocks.get(block) {
            Some(edges) => (block, edges.partition_point(|&edge| is_left(edge))),
            None => (block.saturating_sub(1), self.blocks.last().map_or(0, Vec::len)),
        }
    }

    pub(super) fn at(&self, (block, number): Spot) -> Option<u32> {
        let edges = self.blocks.get(block)?;
        edges.get(number).or_else(|| self.blocks.get(block + 1)?.first()).copied()
    }

    pub(super) fn after(&self, spot: Spot) -> Option<u32> {
        self.at(self.next(spot))
    }

    /// The place behind another.
    pub(super) fn next(&self, (block, number): Spot) -> Spot {
        let ends = self.blocks.get(block).is_some_and(|edges| edges.len() <= number + 1);
        if ends && block + 1 < self.blocks.len() { (block + 1, 0) } else { (block, number + 1) }
    }

    pub(super) fn before(&self, (block, number): Spot) -> Option<u32> {
        match number.checked_sub(1) {
            Some(number) => self.blocks.get(block)?.get(number),
            None => self.blocks.get(block.checked_sub(1)?)?.last(),
        }
        .copied()
    }

    pub(super) fn replace(&mut self, (block, number): Spot, edge: u32) {
        self.blocks[block][number] = edge;
    }

    pub(super) fn insert(&mut self, (block, number): Spot, edge: u32) {
        if self.blocks.is_empty() {
            self.blocks.push(Vec::with_capacity(BLOCK));
        }
        let edges = &mut self.blocks[block];
        edges.insert(number, edge);
        if edges.len() == BLOCK {
            let upper = edges.split_off(BLOCK / 2);
            self.blocks.insert(block + 1, upper);
        }
    }

    pub(super) fn remove(&mut self, (block, number): Spot) {
        self.blocks[block].remove(number);
        if self.blocks[block].is_empty() {
            self.blocks.remove(block);
        }
    }
}
