//! Effects of operations and of attributes that are set, as far as they are known at compile time.

/// Sizes that a scope may have, in metres: an operation does not set a larger one (*s operation* of the runtime).
pub(crate) const MOST_SIZE: f64 = 1e149;

/// The effect on the scope and on the geometry in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Any effect.
    Any,
    /// None: the geometry keeps its place in the scope too.
    Keeps,
    /// The scope keeps its size, the geometry in it changes.
    KeepsSize,
    /// The scope is another one, the geometry stays: `setPivot`, `alignScopeToAxes`.
    MovesScope,
    /// The arguments set the size of the scope: `s`.
    Sizes,
    /// A rectangle becomes a box of that height: `extrude`.
    Extrudes,
    /// A box replaces the geometry and fills the scope, if the scope has a size along all axes.
    FillsWithBox,
    /// The same with another geometry.
    Fills,
}

impl Effect {
    /// Returns true if the shape keeps its geometry, or parts of it.
    pub const fn keeps_geometry(self) -> bool {
        matches!(self, Effect::Keeps | Effect::KeepsSize | Effect::MovesScope | Effect::Sizes)
    }
}

/// The part of the current shape that an operation changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Changes {
    /// Any part.
    Whole,
    /// The scope or the geometry of rectangles and boxes. The runtime has a second function in its `slim` module, which makes
    /// the shape whole where that does not suffice.
    Scope,
    /// The material alone.
    Material,
    /// Nothing: the run is told something.
    Nothing,
}

/// The effect on the sets of texture coordinates. The first argument is the number of a set, where an effect has one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UvEffect {
    /// Any effect.
    Any,
    /// None.
    Keeps,
    /// The new geometry has the first set alone.
    First,
    /// Sets up a projection of the set.
    SetsUp,
    /// Makes the set from its projection.
    Projects,
    /// Changes the set, which must exist.
    Changes,
    /// Copies the set, which must exist, to the set of the second argument.
    Copies,
    /// Removes the set.
    Deletes,
    /// The new geometry goes by the set, which must exist; it may have any sets.
    Follows,
}

impl UvEffect {
    /// Returns true if the set must exist.
    pub fn needs_set(self) -> bool {
        matches!(self, UvEffect::Changes | UvEffect::Copies | UvEffect::Follows)
    }
}
