//! The components of shapes, and the words that select them.

use super::{Directions, Uses};
use std::collections::HashMap;
use std::sync::LazyLock;

/// A kind of component, as in `comp(…)` and `modify(…)`.
#[derive(Debug, PartialEq)]
pub struct Component {
    /// The name in rules.
    pub name: &'static str,
    /// Its place of selectors.
    pub place: SelectorPlaces,
    /// The description, in one line.
    pub about: &'static str,
}

/// All kinds of components.
pub static COMPONENTS: &[Component] = &[
    Component { name: "f", place: SelectorPlaces::FACES, about: "faces" },
    Component { name: "e", place: SelectorPlaces::EDGES, about: "edges, shared ones once" },
    Component { name: "fe", place: SelectorPlaces::FACE_EDGES, about: "edges of each face" },
    Component { name: "v", place: SelectorPlaces::VERTICES, about: "vertices, shared ones once" },
    Component { name: "fv", place: SelectorPlaces::FACE_VERTICES, about: "vertices of each face" },
    Component { name: "g", place: SelectorPlaces::GROUPS, about: "groups of an asset" },
    Component { name: "m", place: SelectorPlaces::MATERIALS, about: "parts of one material" },
    Component { name: "h", place: SelectorPlaces::HOLES, about: "holes of faces" },
];

/// The kind of component with a name.
pub fn component(name: &str) -> Option<&'static Component> {
    COMPONENTS.iter().find(|row| row.name == name)
}

/// A set of places where a selector is allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SelectorPlaces(u16);

impl SelectorPlaces {
    /// No place.
    pub const NONE: SelectorPlaces = SelectorPlaces(0);
    /// `comp(f)`.
    pub const FACES: SelectorPlaces = SelectorPlaces(1);
    /// `comp(e)`.
    pub const EDGES: SelectorPlaces = SelectorPlaces(1 << 1);
    /// `comp(fe)`.
    pub const FACE_EDGES: SelectorPlaces = SelectorPlaces(1 << 2);
    /// `comp(v)`.
    pub const VERTICES: SelectorPlaces = SelectorPlaces(1 << 3);
    /// `comp(fv)`.
    pub const FACE_VERTICES: SelectorPlaces = SelectorPlaces(1 << 4);
    /// `comp(g)`.
    pub const GROUPS: SelectorPlaces = SelectorPlaces(1 << 5);
    /// `comp(m)`.
    pub const MATERIALS: SelectorPlaces = SelectorPlaces(1 << 6);
    /// `comp(h)`.
    pub const HOLES: SelectorPlaces = SelectorPlaces(1 << 7);
    /// `setback`, `setbackPerEdge` and `setbackToArea`.
    pub const SETBACK: SelectorPlaces = SelectorPlaces(1 << 8);
    /// `shapeL`, `shapeU`, `shapeO` and `innerRectangle`, which only have two words.
    pub const SHAPE: SelectorPlaces = SelectorPlaces(1 << 9);
    /// The second braces of `splitAndSetbackPerimeter`.
    pub const PERIMETER: SelectorPlaces = SelectorPlaces(1 << 10);
    /// All kinds of `comp`.
    pub const COMP: SelectorPlaces = SelectorPlaces((1 << 8) - 1);

    /// The union.
    pub const fn and(self, other: SelectorPlaces) -> SelectorPlaces {
        SelectorPlaces(self.0 | other.0)
    }

    /// The places that are not in `other`.
    pub const fn but(self, other: SelectorPlaces) -> SelectorPlaces {
        SelectorPlaces(self.0 & !other.0)
    }

    /// Returns true if only words are allowed there, no indices and no conditions (*innerRectangle*, *shapeL, shapeU,
    /// shapeO operations*; *CGA changelog 2019.0*).
    pub const fn has_words_only(self) -> bool {
        self.0 != 0 && SelectorPlaces::SHAPE.and(SelectorPlaces::PERIMETER).has(self)
    }

    /// Returns true if a selector takes `=:`. Only components are connected (*comp* and *modify operation*).
    pub const fn connects(self) -> bool {
        self.meets(SelectorPlaces::COMP)
    }

    /// Returns true if there are common places.
    pub const fn meets(self, other: SelectorPlaces) -> bool {
        self.0 & other.0 != 0
    }

    /// Returns true if all places of `other` are in this set.
    pub const fn has(self, other: SelectorPlaces) -> bool {
        self.0 & other.0 == other.0
    }
}

/// A word that selects components. `isTagged` is a function, and a number is an index.
#[derive(Debug, PartialEq)]
pub struct Selector {
    /// The name in rules.
    pub name: &'static str,
    /// The places where it is allowed.
    pub on: SelectorPlaces,
    /// The directions, in the axes of the scope, of the components that it takes. Words of other axes have none.
    pub directions: Directions,
    /// Its uses besides the geometry and the axes of the scope: none if it takes the same components of a shape in every place.
    pub uses: Uses,
    /// True for the rest of a face, which no other selector takes.
    pub is_rest: bool,
    /// The help for a deprecated selector: its replacement.
    pub old: Option<&'static str>,
    /// The meaning of a deprecated selector.
    pub same_as: Option<SameAs>,
    /// The description of the components that it takes, in one line.
    pub about: &'static str,
}

/// The components of a deprecated selector by another word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SameAs {
    /// The components of the word.
    Word(&'static str),
    /// The components that the word does not take.
    Not(&'static str),
}

/// A word for all kinds of `comp` and for setbacks.
const fn facing(name: &'static str, about: &'static str) -> Selector {
    only(name, SelectorPlaces::COMP.and(SelectorPlaces::SETBACK), about)
}

const fn only(name: &'static str, on: SelectorPlaces, about: &'static str) -> Selector {
    Selector {
        name,
        on,
        directions: Directions::NONE,
        uses: Uses::WHOLE,
        is_rest: false,
        old: None,
        same_as: None,
        about,
    }
}

/// The row of a word for directions in the axes of the scope.
const fn towards(directions: Directions, row: Selector) -> Selector {
    Selector { directions, uses: Uses::NONE, ..row }
}

/// The row of a word that only depends on the shape itself.
const fn rigid(row: Selector) -> Selector {
    Selector { uses: Uses::NONE, ..row }
}

/// The row of a word for directions in the axes of the world.
const fn of_world(row: Selector) -> Selector {
    Selector { uses: Uses::AXES, ..row }
}

/// The row of a word for the rest of a face.
const fn rest(row: Selector) -> Selector {
    Selector { is_rest: true, ..row }
}

const fn old(row: Selector, same_as: SameAs, instead: &'static str) -> Selector {
    Selector { old: Some(instead), same_as: Some(same_as), ..row }
}

/// All selectors, in their order in messages.
static ROWS: &[Selector] = &[
    towards(Directions::FRONT, facing("front", "what faces the scope's front, its z axis")),
    towards(Directions::BACK, facing("back", "what faces the scope's back")),
    towards(Directions::LEFT, facing("left", "what faces the scope's left")),
    towards(Directions::RIGHT, facing("right", "what faces the scope's right, its x axis")),
    towards(Directions::TOP, facing("top", "what faces the scope's top, its y axis")),
    towards(Directions::BOTTOM, facing("bottom", "what faces the scope's bottom")),
    towards(Directions::SIDE, facing("side", "what is not horizontal")),
    towards(Directions::VERTICAL, only("vertical", SelectorPlaces::COMP, "what is upright")),
    towards(Directions::HORIZONTAL, only("horizontal", SelectorPlaces::COMP, "what is flat")),
    towards(Directions::ASLANT, only("aslant", SelectorPlaces::COMP, "what leans back, as a roof does")),
    towards(Directions::NUTANT, only("nutant", SelectorPlaces::COMP, "what leans forward")),
    towards(Directions::ALL, facing("all", "everything that is left")),
    facing("object.front", "what faces the object's front"),
    facing("object.back", "what faces the object's back"),
    facing("object.left", "what faces the object's left"),
    facing("object.right", "what faces the object's right"),
    facing("object.top", "what faces the object's top"),
    facing("object.bottom", "what faces the object's bottom"),
    facing("object.side", "what faces neither the object's top nor its bottom"),
    of_world(facing("world.south", "what faces south")),
    of_world(facing("world.north", "what faces north")),
    of_world(facing("world.west", "what faces west")),
    of_world(facing("world.east", "what faces east")),
    of_world(facing("world.up", "what faces upwards")),
    of_world(facing("world.down", "what faces downwards")),
    of_world(facing("world.side", "what faces neither upwards nor downwards")),
    facing("street.front", "what borders a street"),
    facing("street.back", "what is opposite a street"),
    facing("street.left", "what is left between front and back"),
    facing("street.right", "what is right between front and back"),
    facing("street.side", "what is between front and back"),
    rigid(only("border", SelectorPlaces::COMP.but(SelectorPlaces::HOLES), "what has an edge that only one face has")),
    rigid(only("inside", SelectorPlaces::COMP.but(SelectorPlaces::HOLES), "what is not at the border")),
    only("eave", SelectorPlaces::EDGES, "edges at the foot of a roof"),
    only("hip", SelectorPlaces::EDGES, "edges that rise from an eave"),
    only("valley", SelectorPlaces::EDGES, "edges between roofs that slope towards each other"),
    only("ridge", SelectorPlaces::EDGES, "edges at the top of a roof"),
    only("uv.left", SelectorPlaces::SETBACK, "edges towards smaller u"),
    only("uv.right", SelectorPlaces::SETBACK, "edges towards larger u"),
    only("uv.bottom", SelectorPlaces::SETBACK, "edges towards smaller v"),
    only("uv.top", SelectorPlaces::SETBACK, "edges towards larger v"),
    only("uv.uMin", SelectorPlaces::SETBACK, "edges at the smallest u"),
    only("uv.uMax", SelectorPlaces::SETBACK, "edges at the largest u"),
    only("uv.vMin", SelectorPlaces::SETBACK, "edges at the smallest v"),
    only("uv.vMax", SelectorPlaces::SETBACK, "edges at the largest v"),
    rigid(only("shape", SelectorPlaces::SHAPE, "the rectangle or the strip")),
    rigid(rest(only(
        "remainder",
        SelectorPlaces::SETBACK.and(SelectorPlaces::SHAPE).and(SelectorPlaces::PERIMETER),
        "what is left of the face",
    ))),
    old(facing("streetSide", "what borders a street"), SameAs::Word("street.front"), "write `street.front`"),
    old(facing("noStreetSide", "what borders no street"), SameAs::Not("street.front"), "write `!street.front`"),
];

/// All selectors.
pub fn selectors() -> std::slice::Iter<'static, Selector> {
    ROWS.iter()
}

/// The selector with a name.
pub fn selector(name: &str) -> Option<&'static Selector> {
    static BY_NAME: LazyLock<HashMap<&str, &Selector>> =
        LazyLock::new(|| ROWS.iter().map(|row| (row.name, row)).collect());
    BY_NAME.get(name).copied()
}
