//! The tables of the language's words: operations, functions, attributes of shapes, component selectors.
//!
//! Every word of the language has a row, implemented or not. A new operation, with or without braces, is one row and one
//! function in the runtime's `op` module; CONTRIBUTING.md has the steps. The parser, the checks and the code generator read
//! the row.

mod attributes;
mod base;
mod bounds;
mod choice;
mod directions;
mod effects;
mod functions;
mod key;
mod material;
mod meaning;
mod operations;
mod params;
mod queries;
mod selectors;
mod set_elements;
mod syntax;
mod uses;
mod values;

use crate::hash::FastMap;
use crate::types::Type;
use std::sync::LazyLock;

pub use attributes::SHAPE_ATTRS;
pub use bounds::{Allowed, ParamBounds};
pub use directions::Directions;
pub use effects::{Changes, Effect, UvEffect};
pub(crate) use effects::{MOST_SECTIONS, MOST_SIZE, THINNEST};
pub use functions::FUNCTIONS;
pub use meaning::{AttrValues, Meaning};
pub use operations::{OPERATIONS, SET_BY_NAME};
pub use params::{Default, FileUse, Param, ParamKind, Words, required, variant};
pub use selectors::{COMPONENTS, Component, SameAs, Selector, SelectorPlaces, component, selector, selectors};
pub use syntax::{SYNTAX, Syntax, syntax};
pub use uses::Uses;

use params::{
    FILE, HEX, TAG_QUERY, boolean, bounds, channel, file, files, float, length, of, or, outdated, param, renamed, size,
    takes, text, unknown, uv_set, within, word,
};

/// An operation. It changes the current shape or makes shapes of it.
#[derive(Debug, PartialEq)]
pub struct Operation {
    /// The name in rules. Several rows may share a name; they differ in the number and kinds of parameters.
    pub name: &'static str,
    /// The function in the runtime's module `op`.
    pub run: &'static str,
    /// The parameters. Parameters with a default come last.
    pub params: &'static [Param],
    /// The braces after its arguments.
    pub braces: Braces,
    /// The effect on the scope and on the geometry in it.
    pub scope: Effect,
    /// The effect on the sets of texture coordinates.
    pub uvs: UvEffect,
    /// True if it reads the state at the start of the rule, bracket or part (`center`).
    pub uses_base: bool,
    /// The parts of the shape that it reads or changes, besides the scope and the material. Arguments have uses of
    /// their own.
    pub uses: Uses,
    /// The part of the shape that it changes.
    pub changes: Changes,
    /// True if the shapes of its operands are reconnected (*Shape recomposition*).
    pub recomposes: bool,
    /// The tags that it gives to the components that it makes (*Geometry tagging*, auto-tags).
    pub tags: &'static [&'static str],
    /// True if a rule with its name and the same number of parameters of other types can be called (*CGA changelog
    /// 2019.1*).
    pub overloads: bool,
    /// The help for a deprecated operation: its replacement.
    pub old: Option<&'static str>,
    /// The description of its effect, in one line.
    pub about: &'static str,
}

/// The kinds of braces after an operation, by their contents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Braces {
    /// No braces.
    None,
    /// `size : operations`, repeatable, as in a split.
    Slots(Measure),
    /// `length : depth : operations`, repeatable, then a second pair of braces with `remainder : operations`.
    Sections,
    /// `selector : operations`, as in a comp, with the selectors of these places.
    Arms(SelectorPlaces),
    /// `selector : operations`, with the selectors of the components named by the first argument.
    Components,
    /// `selector : operations`, where the results of the components are joined again.
    Modified,
    /// Operations.
    Ops,
    /// Operations on both sides of `|`.
    Operands,
    /// A rule, an operation that divides, or operations in braces.
    Inline,
}

/// The meaning of the sizes of slots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Lengths along the axis of the scope named by the first argument. The second argument is `adjust` or
    /// `noAdjust`.
    Length,
    /// Areas of the geometry, with the same arguments.
    Area,
    /// Texture coordinates, or metres on the surface.
    Texture,
}

/// A function of the language.
#[derive(Debug, PartialEq)]
pub struct Function {
    /// The name in rules. Rows with the same name and number of parameters differ in their kinds.
    pub name: &'static str,
    /// The function in the runtime's module `func`.
    pub run: &'static str,
    /// The parameters. Parameters with a default come last.
    pub params: &'static [Param],
    /// The type of its result.
    pub ty: Type,
    /// The arguments of the runtime function before the arguments of the call.
    pub needs: Needs,
    /// The parts of the current shape that it reads. Arguments have uses of their own.
    pub uses: Uses,
    /// True if equal arguments always give equal results, so that it may be folded.
    pub pure: bool,
    /// The meaning to constant folding and to the analysis of values.
    pub meaning: Meaning,
    /// True if it is 0 without the uv set named by the first argument.
    pub needs_uv_set: bool,
    /// The list of names of an asset that it returns, if any.
    pub names: Option<AssetNames>,
    /// The help for a deprecated function: its replacement.
    pub old: Option<&'static str>,
    /// The description of its result, in one line.
    pub about: &'static str,
}

/// The mutable arguments of a runtime function before the arguments of the call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needs {
    /// Nothing.
    Nothing,
    /// The current shape.
    Shape,
    /// The run: faults, limits, assets, the initial shape.
    Env,
    /// The run, then the current shape.
    Both,
    /// The component of a selector. Such a function is only allowed in selectors.
    Component,
}

/// The names in an asset, kept in the geometry of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AssetNames {
    /// The names of its groups.
    Groups,
    /// The names of its materials.
    Materials,
}

/// An attribute of the current shape.
#[derive(Debug, PartialEq)]
pub struct ShapeAttr {
    /// The name in rules: `scope.sx`.
    pub name: &'static str,
    /// The function that reads it, in the runtime's module `get`.
    pub get: &'static str,
    /// The kind of its value.
    pub kind: ParamKind,
    /// The values that it may have.
    pub values: AttrValues,
    /// The arguments of the runtime function that reads it.
    pub needs: Needs,
    /// The parts of the shape that reading uses.
    pub uses: Uses,
    /// The function that sets it, in the runtime's module `set`. `None` if it cannot be set.
    pub set: Option<&'static str>,
    /// The parts of the shape that setting uses, besides the scope and the material.
    pub set_uses: Uses,
    /// The part of the shape that setting changes.
    pub set_changes: Changes,
    /// The effect of setting on the scope.
    pub set_scope: Effect,
    /// The help for a deprecated attribute: its replacement.
    pub old: Option<&'static str>,
}

impl ShapeAttr {
    /// The type of its value.
    pub fn ty(&self) -> Type {
        self.kind.ty().expect("attributes have values")
    }
}

impl Braces {
    /// Returns true if the braces have parts of the shape, each with operations: a subdivision (*Rule inlining*).
    pub fn divides(self) -> bool {
        match self {
            Braces::Slots(_) | Braces::Sections | Braces::Arms(_) | Braces::Components | Braces::Ops => true,
            Braces::None | Braces::Modified | Braces::Operands | Braces::Inline => false,
        }
    }
}

impl Operation {
    /// The selectors of its arms. `first` is its first argument if that is a word.
    pub fn places(&self, first: Option<&str>) -> SelectorPlaces {
        match self.braces {
            Braces::Arms(places) => places,
            Braces::Sections => SelectorPlaces::PERIMETER,
            Braces::Components | Braces::Modified => {
                first.and_then(component).map_or(SelectorPlaces::NONE, |row| row.place)
            }
            Braces::None | Braces::Slots(_) | Braces::Ops | Braces::Operands | Braces::Inline => SelectorPlaces::NONE,
        }
    }

    /// Returns true if it changes the geometry in its scope. Texture coordinates that depend on the place are written
    /// before it. Operations with a slim form carry them along.
    pub fn reshapes(&self) -> bool {
        !matches!(self.scope, Effect::Keeps | Effect::Sizes) && self.changes != Changes::Scope
    }

    /// Returns true if its result is for the run and the shape stays unchanged: `report`, `print`, `label`.
    pub fn is_for_run(&self) -> bool {
        self.changes == Changes::Nothing
    }

    /// Returns true if it takes `count` arguments.
    pub fn takes(&self, count: usize) -> bool {
        takes(self.params, count)
    }

    /// Returns true if no argument is a word other than the default of its parameter. `args` has the bare word of each
    /// argument, or `None`.
    pub fn has_default_words(&self, args: &[Option<&str>]) -> bool {
        self.params.iter().zip(args).all(|(param, arg)| match (param.default, arg) {
            (Some(Default::Word(default)), Some(word)) => *word == default || !param.kind.has_word(word),
            _ => true,
        })
    }

    /// The number of arguments that are words of its parameters; `None` if an argument must be a word and is not.
    /// `args` has the bare word of each argument, or `None`.
    pub fn words(&self, args: &[Option<&str>]) -> Option<usize> {
        let mut found = 0;
        for (param, arg) in self.params.iter().zip(args) {
            match (param.kind, arg) {
                (ParamKind::Word(words), Some(word)) if words.has(word) => found += 1,
                (ParamKind::Word(_), _) => return None,
                _ => {}
            }
        }
        Some(found)
    }
}

impl Function {
    /// Returns true if equal arguments on one shape always give the same result.
    pub fn is_settled(&self) -> bool {
        self.pure || (!self.uses.is_none() && !self.uses.has(Uses::DRAWS) && !self.uses.has(Uses::SAYS))
    }

    /// Returns true if it takes `count` arguments.
    pub fn takes(&self, count: usize) -> bool {
        takes(self.params, count)
    }
}

type Rows<T> = FastMap<&'static str, Vec<&'static T>>;

fn by_name<T>(rows: impl Iterator<Item = &'static T>, name: fn(&T) -> &'static str) -> Rows<T> {
    let mut map = Rows::default();
    for row in rows {
        map.entry(name(row)).or_default().push(row);
    }
    map
}

/// The rows of an operation with a name.
pub fn operations(name: &str) -> impl Iterator<Item = &'static Operation> + Clone + use<> {
    static ROWS: LazyLock<Rows<Operation>> = LazyLock::new(|| by_name(all_operations(), |row| row.name));
    ROWS.get(name).map(Vec::as_slice).unwrap_or_default().iter().copied()
}

/// The row of a call, selected by the number of its arguments and their words; the types may choose among later rows.
/// If no row has the words, it is the first row with this number of arguments, so that a message can list its words.
pub fn operation(name: &str, args: &[Option<&str>]) -> Option<&'static Operation> {
    let rows = || operations(name).filter(|row| row.takes(args.len()));
    // The first of several equal rows counts; `max_by_key` would take the last.
    let best = rows().filter_map(|row| Some((row.words(args)?, row))).reduce(|a, b| if a.0 < b.0 { b } else { a });
    best.map(|(_, row)| row).or_else(|| rows().next())
}

/// All operations.
pub fn all_operations() -> impl Iterator<Item = &'static Operation> + Clone {
    OPERATIONS.iter().copied().flatten()
}

/// The tags that operations give to the components that they make.
pub fn tags() -> impl Iterator<Item = &'static str> {
    all_operations().flat_map(|row| row.tags.iter().copied())
}

/// The rows of a function with a name.
pub fn functions(name: &str) -> impl Iterator<Item = &'static Function> + Clone + use<> {
    static ROWS: LazyLock<Rows<Function>> = LazyLock::new(|| by_name(all_functions(), |row| row.name));
    ROWS.get(name).map(Vec::as_slice).unwrap_or_default().iter().copied()
}

/// All functions.
pub fn all_functions() -> impl Iterator<Item = &'static Function> + Clone {
    FUNCTIONS.iter().copied().flatten()
}

/// The attribute with a name.
pub fn shape_attr(name: &str) -> Option<&'static ShapeAttr> {
    static ROWS: LazyLock<Rows<ShapeAttr>> = LazyLock::new(|| by_name(all_shape_attrs(), |row| row.name));
    ROWS.get(name)?.first().copied()
}

/// All attributes of shapes.
pub fn all_shape_attrs() -> impl Iterator<Item = &'static ShapeAttr> + Clone {
    SHAPE_ATTRS.iter().copied().flatten()
}

// Short forms for the tables.

type Str = &'static str;
type Params = &'static [Param];

const F: Type = Type::Float;
const B: Type = Type::Bool;
const T: Type = Type::Text;
const FS: Type = Type::Floats;
const BS: Type = Type::Bools;
const TS: Type = Type::Texts;
