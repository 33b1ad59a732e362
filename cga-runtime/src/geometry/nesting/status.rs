//! The edges on a sweep line, from left to right, in blocks: insertion and removal move few edges, and each edge knows
//! its block.

/// A position in a row: a block, counted from the left, and an index in it.
pub(crate) type Spot = (usize, usize);

/// The size at which a block is divided.
const BLOCK: usize = 128;

/// The block number of an edge that is in no block.
const NONE: u32 = u32::MAX;

/// A row of edges. No block of it is empty.
#[derive(Default)]
pub(crate) struct Status {
    blocks: Vec<Block>,
    /// The blocks from left to right.
    order: Vec<u32>,
    /// The block of each edge.
    block_of: Vec<u32>,
}

#[derive(Default)]
struct Block {
    edges: Vec<u32>,
    /// The position of the block in the order.
    place: usize,
}

impl Status {
    /// Clears the row for `edges` edges.
    pub(crate) fn reset(&mut self, edges: usize) {
        self.blocks.clear();
        self.order.clear();
        self.block_of.clear();
        self.block_of.resize(edges, NONE);
    }

    /// The edges of the block at a position in the order.
    fn block(&self, place: usize) -> Option<&Vec<u32>> {
        self.order.get(place).map(|&block| &self.blocks[block as usize].edges)
    }

    /// The first position whose edge is not left of the searched place.
    pub(crate) fn spot(&self, is_left: impl Fn(u32) -> bool) -> Spot {
        let last = |block: u32| self.blocks[block as usize].edges.last();
        let place = self.order.partition_point(|&block| last(block).is_some_and(|&edge| is_left(edge)));
        match self.block(place) {
            Some(edges) => (place, edges.partition_point(|&edge| is_left(edge))),
            None => (place.saturating_sub(1), self.block(place.wrapping_sub(1)).map_or(0, Vec::len)),
        }
    }

    /// The position of an edge.
    pub(crate) fn spot_of(&self, edge: u32) -> Option<Spot> {
        let block = self.blocks.get(self.block_of[edge as usize] as usize)?;
        block.edges.iter().position(|&other| other == edge).map(|number| (block.place, number))
    }

    pub(crate) fn at(&self, (place, number): Spot) -> Option<u32> {
        self.block(place)?.get(number).or_else(|| self.block(place + 1)?.first()).copied()
    }

    pub(crate) fn after(&self, (place, number): Spot) -> Option<u32> {
        self.at((place, number + 1))
    }

    pub(crate) fn before(&self, (place, number): Spot) -> Option<u32> {
        match number.checked_sub(1) {
            Some(number) => self.block(place)?.get(number),
            None => self.block(place.checked_sub(1)?)?.last(),
        }
        .copied()
    }

    pub(crate) fn replace(&mut self, (place, number): Spot, edge: u32) {
        let block = self.order[place];
        let old = std::mem::replace(&mut self.blocks[block as usize].edges[number], edge);
        self.block_of[old as usize] = NONE;
        self.block_of[edge as usize] = block;
    }

    pub(crate) fn insert(&mut self, (place, number): Spot, edge: u32) {
        if self.order.is_empty() {
            self.add_block(0, Vec::with_capacity(BLOCK));
        }
        let block = self.order[place];
        let edges = &mut self.blocks[block as usize].edges;
        edges.insert(number, edge);
        self.block_of[edge as usize] = block;
        if edges.len() == BLOCK {
            let upper = edges.split_off(BLOCK / 2);
            self.add_block(place + 1, upper);
        }
    }

    fn add_block(&mut self, place: usize, edges: Vec<u32>) {
        let block = self.blocks.len() as u32;
        edges.iter().for_each(|&edge| self.block_of[edge as usize] = block);
        self.blocks.push(Block { edges, place });
        self.order.insert(place, block);
        self.number_from(place);
    }

    pub(crate) fn remove(&mut self, (place, number): Spot) {
        let edges = &mut self.blocks[self.order[place] as usize].edges;
        let edge = edges.remove(number);
        self.block_of[edge as usize] = NONE;
        if edges.is_empty() {
            self.order.remove(place);
            self.number_from(place);
        }
    }

    /// Updates the positions of blocks from a position on.
    fn number_from(&mut self, place: usize) {
        for (place, &block) in self.order.iter().enumerate().skip(place) {
            self.blocks[block as usize].place = place;
        }
    }
}
