//! Operations with braces, and `comp` as a value.

use super::{Arg, Axis, Expr, Piece, Size, Target};
use crate::ops::{Braces, Operation};
use crate::syntax::ast::ArmMode;

/// `name(args) { … }`: makes parts of the current shape, each with a successor, and the shape itself goes on unchanged. With
/// [`BlockParts::Operands`], it makes a new current shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// The operation.
    pub row: &'static Operation,
    /// One argument for each parameter of the row.
    pub args: Vec<Arg>,
    /// The parts.
    pub parts: BlockParts,
}

/// The parts that an operation with braces makes.
#[derive(Clone, Debug, PartialEq)]
pub enum BlockParts {
    /// `size : … | size : …`
    Slots(Slots),
    /// `selector : … | selector = …`, from left to right: a part goes to the first arm that selects it.
    Arms(Vec<Arm<Target>>),
    /// `length : depth : … | …`, then `{ remainder : … }`.
    Sections(Sections),
    /// Operations for every part.
    Each(Target),
    /// Operands. Each is derived at once from a copy of the current shape, and the operation takes the leaves.
    Operands(Vec<Target>),
}

/// Slots with their sizes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Slots {
    /// One size for each written slot, evaluated once, in order, on the whole shape.
    pub sizes: Vec<Size>,
    /// The repetition of slots. Groups without `*` are gone.
    pub pattern: Vec<cga_split::Item>,
    /// One successor for each written slot.
    pub targets: Vec<Target>,
    /// The solution, where the extent and the sizes are known.
    pub solved: Option<Solved>,
}

/// Sections of a boundary, each with a depth.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// Their lengths and successors.
    pub slots: Slots,
    /// One depth for each written section, evaluated for each section that is made, with its counters.
    pub depths: Vec<Expr>,
    /// The rest.
    pub rest: Vec<Arm<Target>>,
}

/// A split that was solved at compile time.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// The extent along the axis, never negative.
    pub extent: f64,
    /// All pieces, from the low end to the high end.
    pub pieces: Vec<Piece>,
}

/// `selector : …`, `selector = …` or `selector =: …`. It makes a `T` of its parts: a [`Target`], or the value of an [`Expr`].
#[derive(Clone, Debug, PartialEq)]
pub struct Arm<T> {
    /// Selects parts.
    pub selector: Selector,
    /// `comp.sel`, as written.
    pub text: String,
    /// The operator.
    pub mode: ArmMode,
    /// The successor of a part, or a value with the part as current shape.
    pub then: T,
}

/// The parts that an arm takes.
#[derive(Clone, Debug, PartialEq)]
pub enum Selector {
    /// A lone word of [`crate::ops::selectors`], in its newest spelling.
    Word(&'static str),
    /// By index, evaluated once on the whole shape.
    Index(Expr),
    /// A condition with the part as current shape. It may contain words.
    When(Expr),
}

/// `comp(f) { selector : value }`: an array with a value for each component.
#[derive(Clone, Debug, PartialEq)]
pub struct Comp {
    /// The operation of that name, for its parameters.
    pub row: &'static Operation,
    /// Its arguments.
    pub args: Vec<Arg>,
    /// Tried from left to right.
    pub arms: Vec<Arm<Expr>>,
}

impl Block {
    /// The axis that the first argument names.
    pub fn axis(&self) -> Option<Axis> {
        Axis::named(self.word(0)?)
    }

    /// Returns true if parts in slots shrink to their geometry, which a word can turn off (*split operation*).
    pub fn adjusts(&self) -> bool {
        self.is_plain()
    }

    /// Returns true if all words that may be left out are the default ones.
    pub fn is_plain(&self) -> bool {
        let words: Vec<Option<&str>> = (0..self.args.len()).map(|index| self.word(index)).collect();
        self.row.has_default_words(&words)
    }

    /// Returns true for `comp(f)`: the components are the faces. Faces of boxes are rectangles.
    pub fn gives_faces(&self) -> bool {
        self.row.braces == Braces::Components && self.word(0) == Some("f")
    }

    /// Returns true if the shapes of its operands are reconnected (*Shape recomposition*).
    pub fn recomposes(&self) -> bool {
        self.row.recomposes && matches!(self.parts, BlockParts::Operands(_))
    }

    fn word(&self, index: usize) -> Option<&'static str> {
        match self.args.get(index)? {
            Arg::Word(word) => Some(word),
            Arg::Value(_) | Arg::Length(_) => None,
        }
    }
}
