//! Effects of operations and of set attributes, as known at compile time.

/// The maximum size of a scope in metres. Operations do not set a larger one (*s operation* of the runtime).
pub(crate) const MOST_SIZE: f64 = 1e149;

/// A scope has no size along an axis whose size is at most this share of its largest one (`PLANAR_EPSILON` of the runtime): what fills it
/// gives it a size.
pub(crate) const THINNEST: f64 = 1e-9;

/// The limit on sections (*splitAndSetbackPerimeter operation* of the runtime). A pattern with more makes none.
pub(crate) const MOST_SECTIONS: f64 = 500.0;

/// The effect on the scope and on the geometry in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Any effect.
    Any,
    /// No effect: the geometry also keeps its place in the scope.
    Keeps,
    /// The scope keeps its size, but the geometry in it changes.
    KeepsSize,
    /// The scope changes, but the geometry stays: `setPivot`, `alignScopeToAxes`.
    MovesScope,
    /// The arguments set the size of the scope: `s`.
    Sizes,
    /// A rectangle becomes a box with the given height: `extrude`.
    Extrudes,
    /// Faces that look along the scope's y axis replace the geometry, if it has a footprint.
    Flattens,
    /// A box replaces the geometry and fills the scope, if the scope has a size along all axes.
    FillsWithBox,
    /// Another geometry replaces the geometry and fills the scope, under the same condition.
    Fills,
}

impl Effect {
    /// Returns true if the shape keeps its geometry, or parts of it.
    pub const fn keeps_geometry(self) -> bool {
        matches!(self, Effect::Keeps | Effect::KeepsSize | Effect::MovesScope | Effect::Sizes)
    }

    /// Returns true if a flat face stays a flat face.
    pub const fn keeps_flat_faces(self) -> bool {
        matches!(self, Effect::Keeps | Effect::MovesScope | Effect::Sizes)
    }
}

/// The part of the current shape that an operation changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Changes {
    /// Any part.
    Whole,
    /// The scope, or the geometry of rectangles and boxes. The runtime has a second function in its `slim` module,
    /// which makes the shape whole where necessary.
    Scope,
    /// The material only.
    Material,
    /// Nothing. The operation gives information to the run.
    Nothing,
}

/// The effect on the sets of texture coordinates. If an effect has a set, the first argument is its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UvEffect {
    /// Any effect.
    Any,
    /// No effect.
    Keeps,
    /// The new geometry has the first set only.
    First,
    /// Sets up a projection of the set.
    SetsUp,
    /// The new geometry has no sets. A shape that the operation refuses keeps its sets.
    Drops,
    /// Makes the set from its projection.
    Projects,
    /// Changes the set, which must exist.
    Changes,
    /// Copies the set, which must exist, to the set of the second argument.
    Copies,
    /// Removes the set.
    Deletes,
    /// The new geometry uses the set, which must exist. The result may have any sets.
    Follows,
}

impl UvEffect {
    /// Returns true if the set must exist.
    pub fn needs_set(self) -> bool {
        matches!(self, UvEffect::Changes | UvEffect::Copies | UvEffect::Follows)
    }

    /// Returns true if the effect makes caps faces like others (`shape/texture` of the runtime).
    pub fn reaches_caps(self) -> bool {
        matches!(self, UvEffect::Projects | UvEffect::Changes | UvEffect::Copies)
    }
}
