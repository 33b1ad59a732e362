//! The inherited state of a shape besides its geometry: material, attributes changed with `set`, trim switches, name.

use std::sync::{Arc, LazyLock};

use crate::material::Material;
use crate::shape::edge_attributes::EdgeAttributes;
use crate::shape::look::Look;
use crate::shape::lot::Lot;
use crate::shape::texture::{Coordinates, Projections};
use crate::value::Value;
use crate::value::text::Text;

/// The rarely changed and often inherited state, therefore shared.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) look: Arc<Look>,
    /// The projections of `setupProjection`.
    pub(crate) projections: Projections,
    /// The values of `set`, sorted by attribute number. After an import starts again there are many.
    pub(crate) attributes: Vec<(u32, Value)>,
    pub(crate) trim: Trim,
    /// `initialShape.name`.
    pub(crate) name: Text,
    /// True if the geometry was inserted, so that it does not come from the initial shape. Unused if the initial
    /// shape has no name.
    pub(crate) foreign: bool,
    /// The width of the street at each edge of the initial shape.
    pub(crate) street_widths: Arc<[f64]>,
    /// The attributes of the edges of the initial shape.
    pub(crate) edge_attributes: EdgeAttributes,
    /// The data of the initial shape, if it has any.
    pub(crate) lot: Option<Arc<Lot>>,
    /// True if a run from this shape holds boxes and rectangles as meshes. No result depends on it.
    pub(crate) as_meshes: bool,
}

/// The trim planes that cut inserted geometry (*trim attribute*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Trim {
    pub(crate) vertical: bool,
    pub(crate) horizontal: bool,
}

impl Trim {
    pub(crate) const DEFAULT: Trim = Trim { vertical: true, horizontal: false };
}

impl Default for State {
    fn default() -> Self {
        State {
            look: UNSET.clone(),
            projections: Projections::default(),
            attributes: Vec::new(),
            trim: Trim::DEFAULT,
            name: Text::default(),
            foreign: false,
            street_widths: Arc::default(),
            edge_attributes: EdgeAttributes::default(),
            lot: None,
            as_meshes: false,
        }
    }
}

pub(crate) static UNSET: LazyLock<Arc<Look>> = LazyLock::new(Arc::default);

/// A shared state; empty until something is set.
#[derive(Clone, Debug, Default)]
pub(crate) struct StateRef(Option<Arc<State>>);

impl StateRef {
    /// A state in which nothing was set.
    pub(crate) const UNSET: StateRef = StateRef(None);

    #[inline]
    pub(crate) fn get(&self) -> Option<&State> {
        self.0.as_deref()
    }

    /// The state for changes, which affect this shape and its descendants only.
    pub(crate) fn change(&mut self) -> &mut State {
        Arc::make_mut(self.0.get_or_insert_default())
    }

    /// The trim planes that cut.
    pub(crate) fn trim(&self) -> Trim {
        self.get().map_or(Trim::DEFAULT, |state| state.trim)
    }

    /// The material and the texture coordinates set by rules.
    #[inline]
    pub(crate) fn look(&self) -> &Arc<Look> {
        match self.get() {
            Some(state) => &state.look,
            None => &UNSET,
        }
    }

    /// The look for changes.
    pub(crate) fn change_look(&mut self) -> &mut Look {
        Arc::make_mut(&mut self.change().look)
    }

    /// The material, for a sink.
    #[inline]
    pub(crate) fn material(&self) -> &Arc<Material> {
        &self.look().material
    }

    /// Returns true if there are implicit texture coordinates or projections.
    #[inline]
    pub(crate) fn has_texture_space(&self) -> bool {
        self.get().is_some_and(|state| !state.look.coordinates.is_empty() || !state.projections.is_empty())
    }

    /// The implicit texture coordinates.
    pub(crate) fn coordinates(&self) -> &Coordinates {
        &self.look().coordinates
    }

    /// The stored projections.
    pub(crate) fn projections(&self) -> &Projections {
        static NONE: Projections = Projections::None;
        self.get().map_or(&NONE, |state| &state.projections)
    }

    /// Returns true if everything else is equal.
    pub(crate) fn differs_in_look(&self, other: &StateRef) -> bool {
        let (Some(own), Some(its)) = (self.get(), other.get()) else {
            let set = self.get().or(other.get());
            return set.is_none_or(|set| State { look: UNSET.clone(), ..set.clone() } == State::default());
        };
        State { look: its.look.clone(), ..own.clone() } == *its
    }
}
