//! What a shape inherits besides its geometry: material, attributes changed with `set`, trim switches, its name.

use std::sync::{Arc, LazyLock};

use crate::material::Material;
use crate::shape::look::Look;
use crate::shape::texture::{Coordinates, Projections};
use crate::value::Value;
use crate::value::text::Text;

/// Rarely changed and often inherited, therefore shared.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) look: Arc<Look>,
    /// What `setupProjection` stored.
    pub(crate) projections: Projections,
    /// Those that `set` changed, sorted by number: an import that starts anew has many.
    pub(crate) attributes: Vec<(u32, Value)>,
    pub(crate) trim: Trim,
    /// `initialShape.name`.
    pub(crate) name: Text,
    /// Whether the geometry was inserted and so does not come from the initial shape. Unused where that has no name.
    pub(crate) foreign: bool,
    /// Of the initial shape: the width of the street at each edge.
    pub(crate) street_widths: Arc<[f64]>,
    /// True if a run from this shape holds boxes and rectangles as meshes. No result depends on it.
    pub(crate) as_meshes: bool,
}

/// Which trim planes cut what is inserted (*trim attribute*).
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
            as_meshes: false,
        }
    }
}

pub(crate) static UNSET: LazyLock<Arc<Look>> = LazyLock::new(Arc::default);

/// A share in a state; none as long as nothing was ever set.
#[derive(Clone, Debug, Default)]
pub(crate) struct StateRef(Option<Arc<State>>);

impl StateRef {
    /// Nothing was ever set.
    pub(crate) const UNSET: StateRef = StateRef(None);

    #[inline]
    pub(crate) fn get(&self) -> Option<&State> {
        self.0.as_deref()
    }

    /// The state to change it, for this shape and its descendants alone.
    pub(crate) fn change(&mut self) -> &mut State {
        Arc::make_mut(self.0.get_or_insert_default())
    }

    /// Which trim planes cut.
    pub(crate) fn trim(&self) -> Trim {
        self.get().map_or(Trim::DEFAULT, |state| state.trim)
    }

    /// The material and the texture coordinates that rules gave.
    #[inline]
    pub(crate) fn look(&self) -> &Arc<Look> {
        match self.get() {
            Some(state) => &state.look,
            None => &UNSET,
        }
    }

    /// The same to change it.
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
        static NONE: Projections = Projections::NONE;
        self.get().map_or(&NONE, |state| &state.projections)
    }
}
