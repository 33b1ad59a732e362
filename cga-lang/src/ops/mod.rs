//! The tables of the language's words: operations, functions, attributes of shapes, component selectors.
//!
//! Every word of the language has a row, whether it runs yet or not. To add an operation that only changes the current
//! shape: one row and one function in the runtime's `op` module. The parser, the checks and the code generator read
//! the row.

mod attributes;
mod bounds;
mod functions;
mod material;
mod operations;
mod queries;
mod selectors;
mod set_elements;
mod syntax;
mod uses;
mod values;

use crate::code::Code;
use crate::hash::FastMap;
use crate::types::Type;
use std::sync::LazyLock;

pub use attributes::SHAPE_ATTRS;
pub use bounds::{Bounds, Values};
pub use functions::FUNCTIONS;
pub use operations::OPERATIONS;
pub use selectors::{COMPONENTS, Component, Places, Selector, component, selector, selectors};
pub use syntax::{SYNTAX, Syntax, syntax};
pub use uses::Uses;

/// True if a row of a table can run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    /// By the function of that name in the runtime's module (`op`, `func`, `get`, `set`).
    Now(&'static str),
    /// Not yet: using it is a warning, and a fault in a run.
    Later,
}

/// An operation: it changes the current shape or makes shapes of it.
#[derive(Debug, PartialEq)]
pub struct Operation {
    /// As written in rules. Several rows may share a name; number and kinds of arguments tell them apart.
    pub name: &'static str,
    /// What does it.
    pub run: Run,
    /// Its parameters. Those with a default stand last.
    pub params: &'static [Param],
    /// The braces after its arguments.
    pub braces: Braces,
    /// What it does to the scope's size.
    pub scope: Effect,
    /// True if it looks at the state at the start of the rule, bracket or part (`center`).
    pub uses_base: bool,
    /// The parts of the shape that it reads or changes besides the scope and the material. Arguments count on their own.
    pub uses: Uses,
    /// The part of the shape that it changes.
    pub changes: Changes,
    /// True if a rule of its name with as many parameters of other types can be called (*CGA changelog 2019.1*).
    pub overloads: bool,
    /// It is accepted though nobody should write it any more: what to do instead, as a help line says it.
    pub old: Option<&'static str>,
    /// What it does, in a line.
    pub about: &'static str,
}

/// Sizes that a scope may have, in metres: what is larger leaves it as it is along that axis (*s operation* of the runtime).
pub(crate) const MOST_SIZE: f64 = 1e149;

/// What an operation does to the size of the scope, as far as it is known while compiling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Anything.
    Any,
    /// Nothing; the geometry stays in its place in the scope too.
    Keeps,
    /// Nothing, but the geometry in it changes.
    KeepsSize,
    /// Sets it: `s`.
    Sizes,
    /// Puts a box into a scope that has a size along all axes, and leaves that as it is.
    FillsWithBox,
    /// The same with something else.
    Fills,
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

/// The kinds of braces after an operation: what they hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Braces {
    /// No braces.
    None,
    /// `size : operations`, repeatable, as in a split.
    Slots(Measure),
    /// `length : depth : operations`, repeatable, then a second pair of braces with `remainder : operations`.
    Sections,
    /// `selector : operations`, as in a comp, with the selectors of those places.
    Arms(Places),
    /// `selector : operations`, with the selectors of the components that the first argument names.
    Components,
    /// The same, and what becomes of the components is joined up again.
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
    /// Lengths along the axis of the scope that the first argument names. The second one is `adjust` or `noAdjust`.
    Length,
    /// Areas of the geometry, with the same arguments.
    Area,
    /// Texture coordinates, or metres on the surface.
    Texture,
}

/// A parameter of an operation or function.
#[derive(Debug, PartialEq)]
pub struct Param {
    /// For messages.
    pub name: &'static str,
    /// What may stand there.
    pub kind: ParamKind,
    /// What counts when it is left out.
    pub default: Option<Default>,
    /// The values that the reference allows, where it does not allow all.
    pub bounds: Option<&'static Bounds>,
}

/// What counts when an argument is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Default {
    /// A number.
    Float(f64),
    /// A truth value.
    Bool(bool),
    /// Text.
    Text(&'static str),
    /// One of the parameter's words.
    Word(&'static str),
}

/// Words, each with another name.
type Pairs = &'static [(&'static str, &'static str)];

/// What may stand in an argument.
#[derive(Debug, PartialEq)]
pub enum ParamKind {
    /// A value of that type.
    Value(Type),
    /// A value of any type. The runtime's function is generic in it.
    Any,
    /// A length in metres, or relative with `'`.
    Length,
    /// A length in metres, relative with `'` or floating with `~`.
    Size,
    /// Text: the name of a file, which is looked for from the folder of the rule file that it is written in.
    File,
    /// The same for an image, which is not opened: materials keep its name.
    Image,
    /// One of the selectors of components, or an index, or a condition. Rows that run have no such parameter yet.
    Selector,
    /// A float that is computed for each edge of each face, with that edge as current shape. Rows that run have no such
    /// parameter yet.
    PerEdge,
    /// A word. The runtime has an enum of that name with a variant for each second entry.
    Word {
        /// The runtime's enum.
        rust: &'static str,
        /// As written, and the enum's variant.
        words: &'static [(&'static str, &'static str)],
        /// Old words, and what to write instead. They are among `words` too.
        old: &'static [(&'static str, &'static str)],
        /// The code of a diagnostic about any other word.
        unknown: Code,
    },
}

/// A function of the language.
#[derive(Debug, PartialEq)]
pub struct Function {
    /// As written. Rows of one name and as many parameters differ in their kinds.
    pub name: &'static str,
    /// What computes it. When it runs later, its value is 0, false, empty or without elements.
    pub run: Run,
    /// Its parameters. Those with a default stand last.
    pub params: &'static [Param],
    /// Type of its result.
    pub ty: Type,
    /// What it gets before its arguments.
    pub needs: Needs,
    /// The parts of the current shape that it reads. Arguments count on their own.
    pub uses: Uses,
    /// True if equal arguments always give equal results, so that it may be folded.
    pub pure: bool,
    /// For an old spelling: what to write instead, as a help line.
    pub old: Option<&'static str>,
    /// What it gives, in a line.
    pub about: &'static str,
}

/// What a function of the runtime gets before its arguments, mutably.
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
    /// The component that a selector asks about: it stands in selectors only.
    Component,
}

/// An attribute of the current shape.
#[derive(Debug, PartialEq)]
pub struct ShapeAttr {
    /// As written: `scope.sx`.
    pub name: &'static str,
    /// What reads it.
    pub get: Run,
    /// Its type.
    pub ty: Type,
    /// What it is read from.
    pub needs: Needs,
    /// The parts of the shape that reading it uses.
    pub uses: Uses,
    /// The function in the runtime's `set` module, if it can be set.
    pub set: Option<Run>,
    /// The parts of the shape that setting it uses, besides the scope and the material.
    pub set_uses: Uses,
    /// The part of the shape that setting it changes.
    pub set_changes: Changes,
    /// Why it is accepted though nobody should write it any more, and what to write instead.
    pub old: Option<&'static str>,
}

impl Run {
    /// The runtime's function.
    pub const fn now(self) -> Option<&'static str> {
        match self {
            Run::Now(name) => Some(name),
            Run::Later => None,
        }
    }
}

impl ParamKind {
    /// Returns true if a bare word can stand there as that word: not as the name of a value.
    pub fn has_word(&self, word: &str) -> bool {
        matches!(self, ParamKind::Word { words, .. } if words.iter().any(|(own, _)| *own == word))
    }

    /// The words that can stand there, without old ones.
    pub fn new_words(&self) -> impl Iterator<Item = &'static str> + Clone + use<> {
        let (words, old): (Pairs, Pairs) = match self {
            ParamKind::Word { words, old, .. } => (words, old),
            _ => (&[], &[]),
        };
        words.iter().map(|(word, _)| *word).filter(move |word| old.iter().all(|(old, _)| old != word))
    }

    /// An old word, and what to write instead.
    pub fn old_word(&self, word: &str) -> Option<(&'static str, &'static str)> {
        match self {
            ParamKind::Word { old, .. } => old.iter().copied().find(|(old, _)| *old == word),
            _ => None,
        }
    }

    /// Returns true if one argument can be meant for both.
    pub fn overlaps(&self, other: &ParamKind) -> bool {
        match (self, other) {
            (ParamKind::Word { words, .. }, ParamKind::Word { .. }) => {
                words.iter().any(|(word, _)| other.has_word(word))
            }
            (ParamKind::Selector, _) | (_, ParamKind::Selector) => true,
            (ParamKind::Word { .. }, _) | (_, ParamKind::Word { .. }) => false,
            (ParamKind::Any, _) | (_, ParamKind::Any) => true,
            _ => self.ty() == other.ty(),
        }
    }

    /// The type of the value that stands there; none for words and where any type does.
    pub fn ty(&self) -> Option<Type> {
        match self {
            ParamKind::Value(ty) => Some(*ty),
            ParamKind::Length | ParamKind::Size | ParamKind::PerEdge => Some(Type::Float),
            ParamKind::File | ParamKind::Image => Some(Type::Text),
            ParamKind::Any | ParamKind::Selector | ParamKind::Word { .. } => None,
        }
    }
}

impl ShapeAttr {
    /// Returns true if it is the name of an image. An old name sets the same map as the new one.
    pub fn is_image(&self) -> bool {
        self.ty == Type::Text && matches!(self.set, Some(Run::Now(call)) if call.ends_with("map"))
    }
}

impl Braces {
    /// Returns true if the braces hold parts of the shape, each with operations: a subdivision (*Rule inlining*).
    pub fn divides(self) -> bool {
        match self {
            Braces::Slots(_) | Braces::Sections | Braces::Arms(_) | Braces::Components | Braces::Ops => true,
            Braces::None | Braces::Modified | Braces::Operands | Braces::Inline => false,
        }
    }
}

impl Operation {
    /// The selectors of its arms; `first` is its first argument where that is a word.
    pub fn places(&self, first: Option<&str>) -> Places {
        match self.braces {
            Braces::Arms(places) => places,
            Braces::Sections => Places::PERIMETER,
            Braces::Components | Braces::Modified => first.and_then(component).map_or(Places::NONE, |row| row.place),
            Braces::None | Braces::Slots(_) | Braces::Ops | Braces::Operands | Braces::Inline => Places::NONE,
        }
    }

    /// Returns true if it changes geometry in its scope: texture coordinates that follow from the place are written before.
    /// Operations with a slim form take them along.
    pub fn reshapes(&self) -> bool {
        !matches!(self.scope, Effect::Keeps | Effect::Sizes) && self.changes != Changes::Scope
    }

    /// Returns true if it takes that number of arguments.
    pub fn takes(&self, count: usize) -> bool {
        takes(self.params, count)
    }

    /// How many arguments are words of it; `None` when one that must be is none. `args` has what stands in each
    /// argument: a bare word or something else.
    pub fn words(&self, args: &[Option<&str>]) -> Option<usize> {
        let mut found = 0;
        for (param, arg) in self.params.iter().zip(args) {
            match (&param.kind, arg) {
                (ParamKind::Word { .. }, Some(word)) if param.kind.has_word(word) => found += 1,
                (ParamKind::Word { .. }, _) => return None,
                _ => {}
            }
        }
        Some(found)
    }
}

impl Function {
    /// Returns true if it takes that number of arguments.
    pub fn takes(&self, count: usize) -> bool {
        takes(self.params, count)
    }
}

fn takes(params: &[Param], count: usize) -> bool {
    required(params) <= count && count <= params.len()
}

/// How many arguments cannot be left out.
pub fn required(params: &[Param]) -> usize {
    params.iter().take_while(|param| param.default.is_none()).count()
}

type Rows<T> = FastMap<&'static str, Vec<&'static T>>;

fn by_name<T>(rows: impl Iterator<Item = &'static T>, name: fn(&T) -> &'static str) -> Rows<T> {
    let mut map = Rows::default();
    for row in rows {
        map.entry(name(row)).or_default().push(row);
    }
    map
}

/// The rows of an operation's name.
pub fn operations(name: &str) -> impl Iterator<Item = &'static Operation> + Clone + use<> {
    static ROWS: LazyLock<Rows<Operation>> = LazyLock::new(|| by_name(all_operations(), |row| row.name));
    ROWS.get(name).map(Vec::as_slice).unwrap_or_default().iter().copied()
}

/// The row that a call means by the number of its arguments and the words among them; types may leave a choice between
/// later ones. The first that takes that number of arguments if none has the words, so that a message can name those it has.
pub fn operation(name: &str, args: &[Option<&str>]) -> Option<&'static Operation> {
    let rows = || operations(name).filter(|row| row.takes(args.len()));
    // Of equals the first: `max_by_key` would take the last.
    let best = rows().filter_map(|row| Some((row.words(args)?, row))).reduce(|a, b| if a.0 < b.0 { b } else { a });
    best.map(|(_, row)| row).or_else(|| rows().next())
}

/// Every operation.
pub fn all_operations() -> impl Iterator<Item = &'static Operation> + Clone {
    OPERATIONS.iter().copied().flatten()
}

/// The rows of a function's name.
pub fn functions(name: &str) -> impl Iterator<Item = &'static Function> + Clone + use<> {
    static ROWS: LazyLock<Rows<Function>> = LazyLock::new(|| by_name(all_functions(), |row| row.name));
    ROWS.get(name).map(Vec::as_slice).unwrap_or_default().iter().copied()
}

/// Every function.
pub fn all_functions() -> impl Iterator<Item = &'static Function> + Clone {
    FUNCTIONS.iter().copied().flatten()
}

/// The attribute of that name.
pub fn shape_attr(name: &str) -> Option<&'static ShapeAttr> {
    static ROWS: LazyLock<Rows<ShapeAttr>> = LazyLock::new(|| by_name(all_shape_attrs(), |row| row.name));
    ROWS.get(name)?.first().copied()
}

/// Every attribute of shapes.
pub fn all_shape_attrs() -> impl Iterator<Item = &'static ShapeAttr> + Clone {
    SHAPE_ATTRS.iter().copied().flatten()
}

// Short forms for the tables.

const F: Type = Type::Float;
const B: Type = Type::Bool;
const T: Type = Type::Text;
const FS: Type = Type::Floats;
const BS: Type = Type::Bools;
const TS: Type = Type::Texts;

const fn param(name: &'static str, kind: ParamKind) -> Param {
    Param { name, kind, default: None, bounds: None }
}

const fn float(name: &'static str) -> Param {
    param(name, ParamKind::Value(F))
}

const fn boolean(name: &'static str) -> Param {
    param(name, ParamKind::Value(B))
}

const fn text(name: &'static str) -> Param {
    param(name, ParamKind::Value(T))
}

const FILE: Param = param("filePath", ParamKind::File);

const fn length(name: &'static str) -> Param {
    param(name, ParamKind::Length)
}

const fn size(name: &'static str) -> Param {
    param(name, ParamKind::Size)
}

const fn of(name: &'static str, ty: Type) -> Param {
    param(name, ParamKind::Value(ty))
}

/// A parameter that may be left out.
const fn or(param: Param, default: Default) -> Param {
    Param { default: Some(default), ..param }
}

/// A parameter with documented bounds.
const fn within(param: Param, bounds: &'static Bounds) -> Param {
    Param { bounds: Some(bounds), ..param }
}

/// Bounds without a documented result of other values.
const fn bounds(values: Values, about: &'static str) -> Bounds {
    Bounds { values, about, code: Code::OutOfRange, result: None }
}

/// The numbers of uv sets (*texturing*).
static UV_SETS: Bounds =
    Bounds { code: Code::UnknownUvSet, ..bounds(Values::Between(0.0, 9.0), "uv sets are numbered from 0 to 9") };

/// The number of a uv set.
const fn uv_set(name: &'static str) -> Param {
    within(float(name), &UV_SETS)
}

/// A parameter for words.
const fn word(name: &'static str, rust: &'static str, words: &'static [(&'static str, &'static str)]) -> Param {
    param(name, ParamKind::Word { rust, words, old: &[], unknown: Code::UnknownWord })
}
