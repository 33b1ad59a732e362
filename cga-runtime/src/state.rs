//! What a shape inherits besides its geometry: material, attributes changed with `set`, trim switches, its name.

use std::sync::{Arc, LazyLock};

use crate::material::Material;
use crate::text::Text;
use crate::value::Value;

/// Rarely changed and often inherited, therefore shared.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) material: Arc<Material>,
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
            material: UNSET.clone(),
            attributes: Vec::new(),
            trim: Trim::DEFAULT,
            name: Text::default(),
            foreign: false,
            street_widths: Arc::default(),
            as_meshes: false,
        }
    }
}

static UNSET: LazyLock<Arc<Material>> = LazyLock::new(|| Arc::new(Material::UNSET));

/// A share in a state: a child borrows its parent's for as long as the parent's rule runs.
#[derive(Clone, Debug, Default)]
pub(crate) enum StateRef<'a> {
    /// Nothing was ever set.
    #[default]
    Unset,
    Borrowed(&'a Arc<State>),
    Owned(Arc<State>),
}

impl StateRef<'_> {
    #[inline]
    pub(crate) fn get(&self) -> Option<&State> {
        match self {
            StateRef::Unset => None,
            StateRef::Borrowed(state) => Some(state),
            StateRef::Owned(state) => Some(state),
        }
    }

    /// A share for a child.
    #[inline]
    pub(crate) fn lend(&self) -> StateRef<'_> {
        match self {
            StateRef::Unset => StateRef::Unset,
            StateRef::Borrowed(state) => StateRef::Borrowed(state),
            StateRef::Owned(state) => StateRef::Borrowed(state),
        }
    }

    /// A share that outlives the parent.
    pub(crate) fn keep(&self) -> StateRef<'static> {
        match self {
            StateRef::Unset => StateRef::Unset,
            StateRef::Borrowed(state) => StateRef::Owned(Arc::clone(state)),
            StateRef::Owned(state) => StateRef::Owned(state.clone()),
        }
    }

    /// The state to change it, for this shape and its descendants alone.
    pub(crate) fn change(&mut self) -> &mut State {
        let owned = match std::mem::take(self) {
            StateRef::Unset => Arc::default(),
            StateRef::Borrowed(state) => Arc::clone(state),
            StateRef::Owned(state) => state,
        };
        *self = StateRef::Owned(owned);
        match self {
            StateRef::Owned(state) => Arc::make_mut(state),
            _ => unreachable!("it was just made owned"),
        }
    }

    /// Which trim planes cut.
    pub(crate) fn trim(&self) -> Trim {
        self.get().map_or(Trim::DEFAULT, |state| state.trim)
    }

    /// The material, for a sink.
    #[inline]
    pub(crate) fn material(&self) -> &Arc<Material> {
        match self.get() {
            Some(state) => &state.material,
            None => &UNSET,
        }
    }
}
