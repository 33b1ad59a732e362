//! The caller's settings of a run: start rule, limits, assets.

use std::sync::Arc;

use crate::asset::Assets;
use crate::run::coordinate_system::CoordinateSystem;
use crate::run::watch::Watch;

/// Limits of one run. A run that reaches a limit ends with [`Error::Limit`](crate::fault::Error::Limit), unless
/// the limit's description differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Limits {
    /// Derived shapes, leaves included.
    pub shapes: u64,
    /// The nesting of recursive rules.
    pub depth: u32,
    /// The vertices of meshes that operations make. A vertex counts once for each of its faces. Boxes and rectangles
    /// count when they become meshes. Primitives of at most 1,024 vertices are made once in a run and do not count.
    pub vertices: u64,
    /// Calls of rules that wait because recursion is too deep for the stack. Each holds a shape.
    pub waiting: u64,
    /// Calls of functions that are recursive or lead to very many other calls.
    pub calls: u64,
    /// Keys of reports, and different reported texts. Further ones are left out, with a fault.
    pub reports: u64,
    /// Printed lines. Further ones are left out, with a fault.
    pub prints: u64,
    /// Elements of an array (*CGA changelog 2019.1*: 100,000).
    pub array: u64,
    /// Bytes of a text, and of all texts that one function makes for an array.
    pub text: u64,
    /// Bytes of shapes and meshes, by a formula that is the same on every platform: [`BYTES_A_SHAPE`](Limits::BYTES_A_SHAPE) for
    /// each derived shape, [`BYTES_A_VERTEX`](Limits::BYTES_A_VERTEX) for each vertex that [`vertices`](Limits::vertices) counts,
    /// and [`BYTES_A_MESH`](Limits::BYTES_A_MESH) for each mesh that an operation makes and for each leaf that is a mesh. A leaf with
    /// texture coordinates of its own also counts its vertices, and [`BYTES_A_UV`](Limits::BYTES_A_UV) for each of them and each set
    /// beyond the first. An operation that sets a material with arguments that vary counts [`BYTES_A_LOOK`](Limits::BYTES_A_LOOK) and
    /// the texts of the material. A text of more than 256 bytes that a function makes counts its bytes, and an array of more than 16
    /// elements counts 16 bytes for each of them. Cells of tables and results of Rust functions are counted when they are made, all else before
    /// memory is taken, and what is dropped stays counted. So a run takes about as much memory, its model included; small solids take up to
    /// twice as much. Assets and waiting calls have limits of their own.
    ///
    /// Values of the program in rules (`#name`) do not count. A table file has at most 4 MB; while it is read, its cells take up to 70 bytes a
    /// byte. A GLB file takes up to 4 kB for each material while it is made: it is made after the run, and a model has as many materials
    /// as the run has looks.
    /// After the limit is reached, a step still evaluates its other arguments, in the time that they take without a limit.
    pub bytes: u64,
}

impl Limits {
    /// Bytes that a derived shape counts for in [`bytes`](Limits::bytes): a leaf in a model whose lists grow.
    pub const BYTES_A_SHAPE: u64 = 150;

    /// Bytes that a vertex counts for: its point, its place in a face, texture coordinates, and room for growth.
    pub const BYTES_A_VERTEX: u64 = 80;

    /// Bytes that a mesh counts for, besides its vertices.
    pub const BYTES_A_MESH: u64 = 800;

    /// Bytes that the texture coordinates of a vertex count for, in a set beyond the first.
    pub const BYTES_A_UV: u64 = 16;

    /// Bytes that a look counts for, besides its texts: the material of shapes, and its place in a model.
    pub const BYTES_A_LOOK: u64 = 400;

    /// The number of shapes that the limit of shapes and a number of bytes allow.
    pub(crate) fn shapes_in(&self, bytes: u64) -> u64 {
        self.shapes.min(bytes / Limits::BYTES_A_SHAPE)
    }
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            shapes: 10_000_000,
            depth: 1024,
            vertices: 20_000_000,
            waiting: 500_000,
            calls: 100_000_000,
            reports: 100_000,
            prints: 100_000,
            array: 100_000,
            text: 10_000_000,
            bytes: 1_500_000_000,
        }
    }
}

/// The settings of a run. With the feature `serde` they are data, except assets, the coordinate system and the watch, which belong to the program.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct Settings {
    /// The rule to start with; `None` for the grammar's own start rule.
    pub start: Option<String>,
    /// The limits of the run.
    pub limits: Limits,
    /// The assets that `i(…)` may insert.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub assets: Arc<Assets>,
    /// True to also write printed lines to standard output when the run ends, with or without an error. They have the
    /// order of [`Report::prints`](crate::run::report::Report::prints).
    pub echo: bool,
    /// What a lot leads to whose attribute, start rule or grammar is wrong.
    pub wrong_lots: WrongLots,
    /// True to keep the tree of shapes: each [`Building`](crate::run::building::Building) of a model has it. For it the rules run a second
    /// time, without output and without templates, which takes two to three times as long as the first run. So Rust functions in rules are
    /// called twice; a model has no tree if its leaves differ from the leaves of the second run. A watch does not count the second run as progress.
    /// A watch that is stopped, or a deadline that passes, ends it: then the model is complete, without a tree. The tree takes about
    /// 200 bytes for each derived shape, beyond [`Limits::bytes`].
    pub tree: bool,
    /// The place of the world on Earth, for `getGeoCoord` and `scope.elevation`.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub coordinates: Option<Arc<dyn CoordinateSystem>>,
    /// Follows the progress of runs and can end them early.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub watch: Option<Watch>,
    /// The derivation of parts that repeat; tests compare the variants.
    #[doc(hidden)]
    #[cfg_attr(feature = "serde", serde(skip))]
    pub repeats: Repeats,
}

/// What a wrong lot leads to: an attribute that the grammar does not have, a value of another type or outside of its range, a start rule
/// or a grammar that does not exist.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum WrongLots {
    /// [`Error::Lot`](crate::fault::Error::Lot), before any rule runs.
    #[default]
    Fail,
    /// A fault for each problem. A wrong value is left out, and so is a list of choices that the value of another attribute is not in. The
    /// run uses the value of the grammar, the start rule of the settings, the first grammar.
    Fault,
}

/// The derivation of parts that repeat.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Repeats {
    /// From templates that are kept.
    #[default]
    Kept,
    /// From templates that are made again for each repetition. The results equal the results of `Kept` to the byte.
    Again,
    /// Each part at its place in the world. Positions differ from the positions of `Kept` by rounding.
    Direct,
}
