//! The words that select components.

use crate::shape::direction::Direction;

/// A word that selects components (*comp operation*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word(pub(crate) Sense);

#[allow(missing_docs, non_upper_case_globals, reason = "the language defines the names")]
impl Word {
    pub const Front: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Front));
    pub const Back: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Back));
    pub const Left: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Left));
    pub const Right: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Right));
    pub const Top: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Top));
    pub const Bottom: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Bottom));
    pub const Side: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Side));
    pub const Horizontal: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Horizontal));
    pub const Aslant: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Aslant));
    pub const Vertical: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Vertical));
    pub const Nutant: Word = Word(Sense::Looks(AxesOf::Scope, Direction::Nutant));
    pub const All: Word = Word(Sense::All);
    pub const ObjectFront: Word = Word(Sense::Looks(AxesOf::Object, Direction::Front));
    pub const ObjectBack: Word = Word(Sense::Looks(AxesOf::Object, Direction::Back));
    pub const ObjectLeft: Word = Word(Sense::Looks(AxesOf::Object, Direction::Left));
    pub const ObjectRight: Word = Word(Sense::Looks(AxesOf::Object, Direction::Right));
    pub const ObjectTop: Word = Word(Sense::Looks(AxesOf::Object, Direction::Top));
    pub const ObjectBottom: Word = Word(Sense::Looks(AxesOf::Object, Direction::Bottom));
    pub const ObjectSide: Word = Word(Sense::Looks(AxesOf::Object, Direction::Side));
    pub const WorldSouth: Word = Word(Sense::Looks(AxesOf::World, Direction::Front));
    pub const WorldNorth: Word = Word(Sense::Looks(AxesOf::World, Direction::Back));
    pub const WorldEast: Word = Word(Sense::Looks(AxesOf::World, Direction::Right));
    pub const WorldWest: Word = Word(Sense::Looks(AxesOf::World, Direction::Left));
    pub const WorldUp: Word = Word(Sense::Looks(AxesOf::World, Direction::Top));
    pub const WorldDown: Word = Word(Sense::Looks(AxesOf::World, Direction::Bottom));
    pub const WorldSide: Word = Word(Sense::Looks(AxesOf::World, Direction::Side));
    pub const Border: Word = Word(Sense::Border(true));
    pub const Inside: Word = Word(Sense::Border(false));
    pub const Eave: Word = Word(Sense::Roof(RoofEdge::Eave));
    pub const Hip: Word = Word(Sense::Roof(RoofEdge::Hip));
    pub const Valley: Word = Word(Sense::Roof(RoofEdge::Valley));
    pub const Ridge: Word = Word(Sense::Roof(RoofEdge::Ridge));
    pub const StreetFront: Word = Word(Sense::Looks(AxesOf::Street, Direction::Front));
    pub const StreetBack: Word = Word(Sense::Looks(AxesOf::Street, Direction::Back));
    pub const StreetLeft: Word = Word(Sense::Looks(AxesOf::Street, Direction::Left));
    pub const StreetRight: Word = Word(Sense::Looks(AxesOf::Street, Direction::Right));
    pub const StreetSide: Word = Word(Sense::Looks(AxesOf::Street, Direction::Side));
    pub const UvLeft: Word = Word(Sense::Uv(UvSide::Left));
    pub const UvRight: Word = Word(Sense::Uv(UvSide::Right));
    pub const UvBottom: Word = Word(Sense::Uv(UvSide::Bottom));
    pub const UvTop: Word = Word(Sense::Uv(UvSide::Top));
    pub const UvUMin: Word = Word(Sense::Uv(UvSide::UMin));
    pub const UvUMax: Word = Word(Sense::Uv(UvSide::UMax));
    pub const UvVMin: Word = Word(Sense::Uv(UvSide::VMin));
    pub const UvVMax: Word = Word(Sense::Uv(UvSide::VMax));
    pub const Shape: Word = Word(Sense::Shape);
    pub const Remainder: Word = Word(Sense::Remainder);
    /// `noStreetSide`, a spelling of versions before 2012.1.
    pub const NotStreetFront: Word = Word(Sense::Looks(AxesOf::Street, Direction::NotFront));
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
    Looks(AxesOf, Direction),
    /// True for components at the border, false for all others.
    Border(bool),
    /// The class of an edge of a roof.
    Roof(RoofEdge),
    /// The edges of faces with a direction or a place in texture space.
    Uv(UvSide),
    /// No component: a part that `shapeL` makes.
    Shape,
    /// No component: the rest that `shapeL` leaves.
    Remainder,
}

/// The axes of a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AxesOf {
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

/// A direction or a place in texture space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum UvSide {
    Left,
    Right,
    Bottom,
    Top,
    UMin,
    UMax,
    VMin,
    VMax,
}
