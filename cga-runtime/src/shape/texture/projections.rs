//! The projections that `setupProjection` stores.

use std::sync::Arc;

use super::SETS;
use crate::geometry::uv_map::UvMap;

/// A projection for each set, if there is one. Shared; most shapes have none.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Projections(Option<Arc<[Option<UvMap>; SETS]>>);

impl Projections {
    /// The empty list of projections.
    pub(crate) const NONE: Projections = Projections(None);

    /// Returns true if no projection was stored.
    #[inline]
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// The projection of a set.
    pub(crate) fn get(&self, set: u8) -> Option<&UvMap> {
        self.0.as_ref()?.get(usize::from(set))?.as_ref()
    }

    /// All projections.
    pub(crate) fn maps(&self) -> impl Iterator<Item = &UvMap> {
        self.0.iter().flat_map(|maps| maps.iter().flatten())
    }

    /// Stores the projection of a set.
    pub(crate) fn set(&mut self, set: u8, map: UvMap) {
        if let Some(place) = Arc::make_mut(self.0.get_or_insert_default()).get_mut(usize::from(set)) {
            *place = Some(map);
        }
    }
}
