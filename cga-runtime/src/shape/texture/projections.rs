//! The projections that `setupProjection` stores.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::SETS;
use crate::geometry::uv_map::UvMap;

/// A projection for each set, if there is one. Shared; most shapes have none.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) enum Projections {
    #[default]
    None,
    Known(Arc<[Option<UvMap>; SETS]>),
    /// The shape was moved without them, so their values are unknown.
    Unknown(Unread),
}

/// A note whether somebody asked for an unknown value.
#[derive(Clone, Debug, Default)]
pub(crate) struct Unread(Arc<AtomicBool>);

impl PartialEq for Unread {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Projections {
    /// Returns true if no projection was stored.
    #[inline]
    pub(crate) fn is_empty(&self) -> bool {
        matches!(self, Projections::None)
    }

    /// The same projections, with unknown values.
    pub(crate) fn unknown(&self) -> Self {
        match self {
            Projections::None => Projections::None,
            Projections::Known(_) | Projections::Unknown(_) => Projections::Unknown(Unread::default()),
        }
    }

    /// Returns true if an unknown value was asked for. It was then as if no projection was stored.
    pub(crate) fn has_missed(&self) -> bool {
        matches!(self, Projections::Unknown(unread) if unread.0.load(Ordering::Relaxed))
    }

    /// The projection of a set.
    pub(crate) fn get(&self, set: u8) -> Option<&UvMap> {
        match self {
            Projections::None => None,
            Projections::Known(maps) => maps.get(usize::from(set))?.as_ref(),
            Projections::Unknown(unread) => {
                unread.0.store(true, Ordering::Relaxed);
                None
            }
        }
    }

    /// All projections whose values are known.
    pub(crate) fn maps(&self) -> impl Iterator<Item = &UvMap> {
        let maps = if let Projections::Known(maps) = self { maps.as_slice() } else { &[] };
        maps.iter().flatten()
    }

    /// Stores the projection of a set.
    pub(crate) fn set(&mut self, set: u8, map: UvMap) {
        match self {
            Projections::None => *self = Projections::Known(Arc::default()),
            Projections::Known(_) => {}
            Projections::Unknown(unread) => unread.0.store(true, Ordering::Relaxed),
        }
        if let Projections::Known(maps) = self
            && let Some(place) = Arc::make_mut(maps).get_mut(usize::from(set))
        {
            *place = Some(map);
        }
    }
}
