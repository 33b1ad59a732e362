//! The texture maps of a list of leaves, where few leaves have maps and few lists of maps differ.

use crate::geometry::uv_map::SetMap;

/// The maps of leaves by number. Leaves without maps take no memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct LeafUvs {
    /// The lists of maps. Equal lists of neighbouring leaves are stored once.
    lists: Vec<Box<[SetMap]>>,
    /// The numbers of leaves, in order, with the indices of their lists.
    leaves: Vec<(usize, usize)>,
}

/// The number of recent lists that a new one is compared with: leaves of a façade alternate between a few.
const RECENT: usize = 8;

impl LeafUvs {
    /// Adds the maps of a leaf, whose number is larger than all before.
    #[inline]
    pub(crate) fn add(&mut self, leaf: usize, maps: &[SetMap]) {
        if !maps.is_empty() {
            self.put(leaf, maps);
        }
    }

    #[cold]
    #[inline(never)]
    fn put(&mut self, leaf: usize, maps: &[SetMap]) {
        let recent = self.lists.iter().enumerate().rev().take(RECENT);
        let known = recent.into_iter().find(|(_, list)| ***list == *maps).map(|(number, _)| number);
        let list = known.unwrap_or_else(|| {
            self.lists.push(maps.into());
            self.lists.len() - 1
        });
        self.leaves.push((leaf, list));
    }

    /// The maps of a leaf.
    pub(crate) fn of(&self, leaf: usize) -> &[SetMap] {
        match self.leaves.binary_search_by_key(&leaf, |known| known.0) {
            Ok(at) => &self.lists[self.leaves[at].1],
            Err(_) => &[],
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec4;

    use super::*;
    use crate::geometry::uv_map::UvMap;

    #[test]
    fn leaves_have_their_maps_and_equal_lists_are_kept_once() {
        let list = |u| [SetMap { set: 0, maps: UvMap { u: DVec4::splat(u), v: DVec4::X }.into() }];
        let mut uvs = LeafUvs::default();
        for (leaf, u) in [(1, Some(1.0)), (2, None), (3, Some(2.0)), (4, Some(1.0)), (5, Some(2.0))] {
            uvs.add(leaf, u.map(list).as_ref().map_or(&[], |list| &list[..]));
        }
        assert_eq!(
            [0, 1, 2, 3, 4, 5].map(|leaf| uvs.of(leaf).first().map_or(0.0, |own| own.maps.of_face(0).u.x)),
            [0.0, 1.0, 0.0, 2.0, 1.0, 2.0]
        );
        assert_eq!(uvs.lists.len(), 2);
    }
}
