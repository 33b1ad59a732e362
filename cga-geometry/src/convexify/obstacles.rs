//! Trees of the half-edges of a face, to find the ones along a ray or near a point.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec2;

use crate::nesting::extent::Extent;
use crate::small_sort::SmallSort;

/// The largest number of half-edges in a leaf of a tree, and of half-edges outside of the trees.
const LEAF: usize = 8;
const LOOSE: usize = 32;

/// Half-edges with their boxes, in trees of decreasing size. Those that were added last are in no tree.
#[derive(Default)]
pub(super) struct Obstacles {
    trees: Vec<Tree>,
    loose: Vec<Item>,
}

type Item = (u32, Extent);

struct Tree {
    nodes: Vec<TreeNode>,
    items: Vec<Item>,
}

struct TreeNode {
    extent: Extent,
    /// The items of a leaf; of other nodes the node of the second half, where the first half follows the node.
    start: u32,
    /// The end of the items of a leaf; 0 for other nodes.
    end: u32,
}

impl Tree {
    fn of(mut items: Vec<Item>) -> Self {
        let mut nodes = Vec::new();
        build(&mut nodes, &mut items, 0);
        Tree { nodes, items }
    }

    fn children(&self, node: u32) -> [u32; 2] {
        [node + 1, self.nodes[node as usize].start]
    }

    /// The items of a leaf; `None` for other nodes.
    fn leaf(&self, node: u32) -> Option<&[Item]> {
        let TreeNode { start, end, .. } = self.nodes[node as usize];
        (end != 0).then(|| &self.items[start as usize..end as usize])
    }

    fn extent(&self, node: u32) -> &Extent {
        &self.nodes[node as usize].extent
    }
}

/// Builds the nodes of some items, of which the first one has the number `start`.
fn build(nodes: &mut Vec<TreeNode>, items: &mut [Item], start: usize) {
    let extent = Extent::union(items.iter().map(|item| item.1));
    let (number, end) = (nodes.len(), start + items.len());
    nodes.push(TreeNode { extent, start: start as u32, end: end as u32 });
    if items.len() <= LEAF {
        return;
    }
    let size = extent.high - extent.low;
    let axis = usize::from(size.x < size.y);
    let middle = items.len() / 2;
    let key = |item: &Item| item.1.low[axis] + item.1.high[axis];
    items.small_select_by(middle, |a, b| key(a).total_cmp(&key(b)).then(a.0.cmp(&b.0)));
    let (first, second) = items.split_at_mut(middle);
    build(nodes, first, start);
    nodes[number] = TreeNode { extent, start: nodes.len() as u32, end: 0 };
    build(nodes, second, start + middle);
}

impl Obstacles {
    /// Adds a half-edge between two points.
    pub(super) fn add(&mut self, half: u32, ends: [DVec2; 2]) {
        self.loose.push((half, Extent::of(ends.into_iter())));
        if self.loose.len() == LOOSE {
            let mut items = std::mem::take(&mut self.loose);
            while let Some(tree) = self.trees.pop_if(|tree| tree.items.len() <= 2 * items.len()) {
                items.extend(tree.items);
            }
            self.trees.push(Tree::of(items));
        }
    }

    /// Calls `test` with the half-edges whose boxes the ray from a point may meet before `reach` times its direction. `test`
    /// may reduce `reach`. Returns the number of boxes that were tested.
    pub(super) fn along(
        &self,
        from: DVec2,
        way: DVec2,
        slack: f64,
        reach: &mut f64,
        mut test: impl FnMut(u32, &mut f64),
    ) -> usize {
        // The place on the ray where it enters a box.
        let entry = |extent: &Extent, reach: f64| -> Option<f64> {
            let (mut first, mut last) = (0.0f64, reach);
            for axis in 0..2 {
                let (low, high) = (extent.low[axis] - slack - from[axis], extent.high[axis] + slack - from[axis]);
                if way[axis] == 0.0 {
                    if 0.0 < low || high < 0.0 {
                        return None;
                    }
                    continue;
                }
                let (a, b) = (low / way[axis], high / way[axis]);
                first = first.max(a.min(b));
                last = last.min(a.max(b));
            }
            // Rounding of the quotients.
            (first <= last + 1e-9 * (first.abs() + last.abs())).then_some(first)
        };
        for (half, extent) in &self.loose {
            if entry(extent, *reach).is_some() {
                test(*half, reach);
            }
        }
        let mut tested = self.loose.len();
        let mut open: Vec<(f64, &Tree, u32)> = Vec::new();
        for tree in &self.trees {
            open.push((0.0, tree, 0));
            while let Some((_, tree, node)) = open.pop() {
                tested += 2;
                if entry(tree.extent(node), *reach).is_none() {
                    continue;
                }
                let Some(leaf) = tree.leaf(node) else {
                    // The nearer one is visited first.
                    let start = open.len();
                    let at = |&child: &u32| Some((entry(tree.extent(child), *reach)?, tree, child));
                    open.extend(tree.children(node).iter().filter_map(at));
                    open[start..].small_sort_by(|a, b| b.0.total_cmp(&a.0));
                    continue;
                };
                tested += leaf.len();
                for (half, extent) in leaf {
                    if entry(extent, *reach).is_some() {
                        test(*half, reach);
                    }
                }
            }
        }
        tested
    }

    /// Calls `found` with the half-edges near a point by the distances of their boxes, which are at most `radius`, until it
    /// returns false or `most` nodes were visited.
    pub(super) fn near(&self, at: DVec2, radius: f64, most: usize, mut found: impl FnMut(u32) -> bool) {
        // The bits of positive numbers have their order.
        let far = |extent: &Extent| (at - at.clamp(extent.low, extent.high)).length();
        let key = |extent: &Extent| Some(far(extent)).filter(|far| *far <= radius).map(f64::to_bits);
        // Nodes with their tree, or items.
        let mut open: BinaryHeap<Reverse<(u64, Option<usize>, u32)>> = BinaryHeap::new();
        let add = |open: &mut BinaryHeap<_>, extent: &Extent, tree: Option<usize>, number: u32| {
            open.extend(key(extent).map(|key| Reverse((key, tree, number))));
        };
        for (number, tree) in self.trees.iter().enumerate() {
            add(&mut open, tree.extent(0), Some(number), 0);
        }
        self.loose.iter().for_each(|(half, extent)| add(&mut open, extent, None, *half));
        let mut left = most;
        while let Some(Reverse((_, tree, number))) = open.pop() {
            let Some(of) = tree else {
                if !found(number) {
                    return;
                }
                continue;
            };
            let Some(fewer) = left.checked_sub(1) else { return };
            left = fewer;
            let tree = &self.trees[of];
            match tree.leaf(number) {
                Some(leaf) => leaf.iter().for_each(|(half, extent)| add(&mut open, extent, None, *half)),
                None => tree
                    .children(number)
                    .into_iter()
                    .for_each(|child| add(&mut open, tree.extent(child), Some(of), child)),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Rng;

    #[test]
    fn rays_and_circles_find_what_a_loop_finds() {
        let mut random = Rng(5);
        let mut noise = || random.unit();
        let mut tree = Obstacles::default();
        let mut all: Vec<[DVec2; 2]> = Vec::new();
        for number in 0..700 {
            let from = DVec2::new(noise(), noise());
            let ends = [from, from + DVec2::new(noise() - 0.5, noise() - 0.5) * 0.1];
            tree.add(number, ends);
            all.push(ends);
        }
        for _ in 0..200 {
            let (from, way) = (DVec2::new(noise(), noise()), DVec2::new(noise() - 0.5, noise() - 0.5));
            let hit = |[a, b]: [DVec2; 2]| {
                let edge = b - a;
                let [along, share] =
                    [(a - from).perp_dot(edge), (a - from).perp_dot(way)].map(|n| n / way.perp_dot(edge));
                (0.0 < along && (0.0..=1.0).contains(&share)).then_some(along)
            };
            let nearest = all.iter().filter_map(|ends| hit(*ends)).fold(f64::INFINITY, f64::min);
            let mut reach = f64::INFINITY;
            let mut asked = 0;
            tree.along(from, way, 0.0, &mut reach, |half, reach| {
                asked += 1;
                *reach = reach.min(hit(all[half as usize]).unwrap_or(*reach));
            });
            assert!(reach == nearest && asked < 250, "{asked}");
            let far = |number: u32| {
                let extent = Extent::of(all[number as usize].into_iter());
                (from - from.clamp(extent.low, extent.high)).length()
            };
            let mut near = Vec::new();
            tree.near(from, 0.2, usize::MAX, |half| {
                near.push(half);
                true
            });
            assert!(near.windows(2).all(|pair| far(pair[0]) <= far(pair[1])));
            near.sort_unstable();
            assert!((0..700).filter(|&number| far(number) <= 0.2).eq(near));
        }
    }
}
