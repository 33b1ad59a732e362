//! A worked example of a page: its title, the shape it starts from, its rules word for word, and how to run it.

use cga::{Error, Model, Settings, Shape};

/// A piece along x: its rule, its length, its height. `NIL` is a gap.
pub type Piece = (&'static str, f64, f64);

/// Repeats a pattern of pieces.
pub fn times(count: usize, pattern: &[Piece]) -> Vec<Piece> {
    pattern.repeat(count)
}

/// Joins lists of pieces.
pub fn joined(lists: &[&[Piece]]) -> Vec<Piece> {
    lists.concat()
}

/// One example. Programs that draw the examples use the same text as the tests.
#[derive(Clone, Copy)]
pub struct Example {
    /// The page, and the heading or sentence on it.
    pub title: &'static str,
    /// Verbatim CGA. What follows the first empty line are rules that the page gives once for all its examples.
    pub rules: &'static str,
    /// The shape that the first rule starts with.
    pub start: fn() -> Shape,
    /// Runs the rules.
    pub run: fn(&Shape, &Settings) -> Result<Model, Error>,
    /// The marks of the page's picture.
    pub marks: &'static [Mark],
    /// The row of pieces that the page describes, if the example is a row.
    pub pieces: Option<fn() -> Vec<Piece>>,
}

/// A mark that a page's picture draws besides the pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// The initial shape.
    Initial,
    /// The edges of the initial scope.
    InitialBox,
    /// The axes of the initial scope.
    InitialScope,
    /// A short arrow along the x axis of the initial scope, in front of it.
    AlongX,
    /// The pivot of the initial shape.
    InitialPivot,
    /// The axes of the scope of each piece of a rule.
    Scopes(&'static str),
    /// The axes of the scope of one piece of a rule, by number.
    Scope(&'static str, usize),
    /// The edges of the scope of each piece of a rule.
    Boxes(&'static str),
    /// The pivot of each piece of a rule that consists of faces which `comp` made: the start of the first edge.
    Pivots(&'static str),
    /// The pivot of each piece of a rule whose last operation has put it at the origin of the scope.
    ScopePivots(&'static str),
    /// The edges and the axes of the scope of each shape of a rule that has successors.
    Inner(&'static str),
    /// The picture shows the pieces of a rule a little lower, so that the rim of a bottom is visible.
    Lowered(&'static str),
    /// The picture shows the backs of all faces in black, and their borders.
    Backs,
    /// The picture shows the model from this azimuth and elevation in degrees: (0, 0) is from the front, (90, 0) from the right.
    From(f64, f64),
    /// The picture shows the model from above.
    FromAbove,
}

impl Mark {
    /// The rule whose pieces are marked.
    pub fn rule(self) -> Option<&'static str> {
        match self {
            Mark::Scopes(rule)
            | Mark::Scope(rule, _)
            | Mark::Boxes(rule)
            | Mark::Pivots(rule)
            | Mark::ScopePivots(rule)
            | Mark::Lowered(rule) => Some(rule),
            _ => None,
        }
    }
}

impl Example {
    /// The rules of this example, without those that the page gives once for all its examples.
    pub fn shown(&self) -> &'static str {
        self.shown_and_further().0
    }

    /// The rules of this example, and the rules that the page gives once for all its examples.
    pub fn shown_and_further(&self) -> (&'static str, &'static str) {
        let rules = self.rules.trim_matches('\n').trim_end();
        rules.split_once("\n\n").unwrap_or((rules, ""))
    }

    /// The model it gives.
    ///
    /// # Panics
    /// When it gives none.
    pub fn model(&self, settings: &Settings) -> Model {
        (self.run)(&(self.start)(), settings).unwrap_or_else(|error| panic!("{}: {error}", self.title))
    }
}

/// A module with the grammar `Page` and its `EXAMPLE`. After `; marks`, the marks of the picture; then, for a row, the pieces
/// that the page describes.
macro_rules! example {
    ($(#[$doc:meta])* $name:ident, $title:literal, $start:expr, $rules:tt $(; marks $marks:expr)? $(, $pieces:expr)?) => {
        $(#[$doc])*
        pub mod $name {
            #[allow(unused_imports, reason = "each example needs some of it")]
            use super::*;

            // The checks report mistakes that pages show on purpose: see cga-lang/tests/data/lower/seed_*.cga.
            cga::cga! {
                @Allow(undefined_rule, size_not_positive, slot_never_made, float_without_space, sizes_beyond_extent, missing_asset, old_spelling)
                pub grammar Page = $rules;
            }

            pub const EXAMPLE: crate::pages::example::Example = crate::pages::example::Example {
                title: $title,
                rules: $rules,
                start: || $start,
                run: |shape, settings| Page::default().generate_with(shape, settings),
                marks: {
                    use crate::pages::example::Mark;
                    const MARKS: &[&[Mark]] = &[$($marks,)? &[]];
                    MARKS[0]
                },
                pieces: {
                    const PIECES: &[fn() -> Vec<crate::pages::example::Piece>] = &[$(|| $pieces.to_vec())?];
                    if PIECES.is_empty() { None } else { Some(PIECES[0]) }
                },
            };
        }
    };
}
pub(crate) use example;
