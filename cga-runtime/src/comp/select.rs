//! The words that select components.

use crate::shape::direction::Direction;

/// A word that selects components (*comp operation*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names are those of the language")]
pub enum Word {
    Front,
    Back,
    Left,
    Right,
    Top,
    Bottom,
    Side,
    Horizontal,
    Aslant,
    Vertical,
    Nutant,
    All,
    ObjectFront,
    ObjectBack,
    ObjectLeft,
    ObjectRight,
    ObjectTop,
    ObjectBottom,
    ObjectSide,
    WorldSouth,
    WorldNorth,
    WorldEast,
    WorldWest,
    WorldUp,
    WorldDown,
    WorldSide,
    Border,
    Inside,
    Eave,
    Hip,
    Valley,
    Ridge,
    StreetFront,
    StreetBack,
    StreetLeft,
    StreetRight,
    StreetSide,
    Shape,
    Remainder,
    /// `noStreetSide`, a spelling of versions before 2012.1.
    NotStreetFront,
}

/// The parts of a component that `isTagged` tests instead of the component itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subcomponent {
    /// The edges.
    Edges,
    /// The vertices.
    Vertices,
}

/// The test of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sense {
    /// No test: all components.
    All,
    /// The direction of a component, in some axes.
    Looks(Axes, Direction),
    /// True for components at the border, false for all others.
    Border(bool),
    /// The class of an edge of a roof.
    Roof(RoofEdge),
    /// No component: a part that another operation makes.
    Part,
}

/// The axes of a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axes {
    /// The axes of the current shape's scope.
    Scope,
    /// The axes of the initial shape.
    Object,
    /// The world: y is up, z south, x east.
    World,
    /// The streets at the initial shape; without any, the axes of the object.
    Street,
}

/// The edges of roofs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RoofEdge {
    Eave,
    Hip,
    Valley,
    Ridge,
}

impl Word {
    #[inline(always)]
    pub(crate) fn sense(self) -> Sense {
        use Direction as D;
        let (axes, direction) = match self {
            Word::All => return Sense::All,
            Word::Shape | Word::Remainder => return Sense::Part,
            Word::Border => return Sense::Border(true),
            Word::Inside => return Sense::Border(false),
            Word::Eave => return Sense::Roof(RoofEdge::Eave),
            Word::Hip => return Sense::Roof(RoofEdge::Hip),
            Word::Valley => return Sense::Roof(RoofEdge::Valley),
            Word::Ridge => return Sense::Roof(RoofEdge::Ridge),
            Word::Front => (Axes::Scope, D::Front),
            Word::Back => (Axes::Scope, D::Back),
            Word::Left => (Axes::Scope, D::Left),
            Word::Right => (Axes::Scope, D::Right),
            Word::Top => (Axes::Scope, D::Top),
            Word::Bottom => (Axes::Scope, D::Bottom),
            Word::Side => (Axes::Scope, D::Side),
            Word::Horizontal => (Axes::Scope, D::Horizontal),
            Word::Aslant => (Axes::Scope, D::Aslant),
            Word::Vertical => (Axes::Scope, D::Vertical),
            Word::Nutant => (Axes::Scope, D::Nutant),
            Word::ObjectFront => (Axes::Object, D::Front),
            Word::ObjectBack => (Axes::Object, D::Back),
            Word::ObjectLeft => (Axes::Object, D::Left),
            Word::ObjectRight => (Axes::Object, D::Right),
            Word::ObjectTop => (Axes::Object, D::Top),
            Word::ObjectBottom => (Axes::Object, D::Bottom),
            Word::ObjectSide => (Axes::Object, D::Side),
            Word::WorldSouth => (Axes::World, D::Front),
            Word::WorldNorth => (Axes::World, D::Back),
            Word::WorldEast => (Axes::World, D::Right),
            Word::WorldWest => (Axes::World, D::Left),
            Word::WorldUp => (Axes::World, D::Top),
            Word::WorldDown => (Axes::World, D::Bottom),
            Word::WorldSide => (Axes::World, D::Side),
            Word::StreetFront => (Axes::Street, D::Front),
            Word::StreetBack => (Axes::Street, D::Back),
            Word::StreetLeft => (Axes::Street, D::Left),
            Word::StreetRight => (Axes::Street, D::Right),
            Word::StreetSide => (Axes::Street, D::Side),
            Word::NotStreetFront => (Axes::Street, D::NotFront),
        };
        Sense::Looks(axes, direction)
    }
}
