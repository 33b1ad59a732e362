//! The maps of leaves below a base, found once for each look.

use std::cell::OnceCell;

use super::map::SetMap;
use crate::material::ids::MaterialId;

/// Lists of maps by the number of the look. Leaves below one base have few looks.
#[derive(Debug, Default)]
pub(crate) struct KeptMaps(OnceCell<Box<Kept>>);

#[derive(Debug)]
struct Kept {
    look: MaterialId,
    maps: Box<[SetMap]>,
    next: KeptMaps,
}

impl KeptMaps {
    /// The list for a look, which `find` makes if it is not known.
    pub(crate) fn of(&self, look: MaterialId, find: impl FnOnce() -> Box<[SetMap]>) -> &[SetMap] {
        let mut place = self;
        while let Some(kept) = place.0.get() {
            if kept.look == look {
                return &kept.maps;
            }
            place = &kept.next;
        }
        &place.0.get_or_init(|| Box::new(Kept { look, maps: find(), next: KeptMaps::default() })).maps
    }
}
