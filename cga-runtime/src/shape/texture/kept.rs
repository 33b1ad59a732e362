//! The texture maps of leaves below a base, found once for each look.

use std::cell::OnceCell;

use crate::geometry::uv_map::SetMap;
use crate::shape::look_id::LookId;

/// Lists of maps by the number of the look, as a tree over the bits of the number. Most bases have one or two looks
/// below them.
#[derive(Debug, Default)]
pub(crate) struct KeptMaps(OnceCell<Box<KeptMap>>);

#[derive(Debug)]
struct KeptMap {
    look: LookId,
    maps: Box<[SetMap]>,
    next: [KeptMaps; 2],
}

impl KeptMaps {
    /// The list for a look, made by `find` on the first use.
    pub(crate) fn of(&self, look: LookId, find: impl FnOnce() -> Box<[SetMap]>) -> &[SetMap] {
        let (mut place, mut bits) = (self, look.0);
        while let Some(kept) = place.0.get() {
            if kept.look == look {
                return &kept.maps;
            }
            place = &kept.next[bits as usize & 1];
            bits >>= 1;
        }
        &place.0.get_or_init(|| Box::new(KeptMap { look, maps: find(), next: Default::default() })).maps
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_found_once_for_each_of_many_looks() {
        let (kept, mut found) = (KeptMaps::default(), 0);
        for _ in 0..2 {
            for number in (0..60_000).chain([u32::MAX]) {
                kept.of(LookId(number), || {
                    found += 1;
                    Box::default()
                });
            }
        }
        assert_eq!(found, 60_001);
    }
}
