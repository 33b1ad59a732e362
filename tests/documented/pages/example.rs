//! A worked example of a page: its title, the shape it starts from, its rules word for word, and how to run it.

use cga::{Error, Model, Settings, Shape};

/// One example. Programs that draw the examples use the same text as the tests.
#[derive(Clone, Copy)]
pub(crate) struct Example {
    /// The page, and the heading or sentence on it.
    pub(crate) title: &'static str,
    /// Verbatim CGA. What follows the first empty line are rules that the page gives once for all its examples.
    pub(crate) rules: &'static str,
    /// The shape that the first rule starts with.
    pub(crate) start: fn() -> Shape,
    /// Runs the rules.
    pub(crate) run: fn(&Shape, &Settings) -> Result<Model, Error>,
    /// The marks of the page's picture.
    pub(crate) marks: &'static [Mark],
}

/// A mark that a page's picture draws besides the pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Mark {
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
    /// The picture shows the model from above.
    FromAbove,
}

impl Mark {
    /// The rule whose pieces are marked.
    #[allow(dead_code, reason = "tests ask for it, the program that draws does not")]
    pub(crate) fn rule(self) -> Option<&'static str> {
        match self {
            Mark::Scopes(rule) | Mark::Scope(rule, _) | Mark::Boxes(rule) | Mark::Pivots(rule) => Some(rule),
            _ => None,
        }
    }
}

impl Example {
    /// The rules of this example, without those that the page gives once for all its examples.
    pub(crate) fn shown(&self) -> &'static str {
        self.rules.split("\n\n").next().unwrap_or_default().trim_matches('\n').trim_end()
    }

    /// The model it gives.
    ///
    /// # Panics
    /// When it gives none.
    pub(crate) fn model(&self, settings: &Settings) -> Model {
        (self.run)(&(self.start)(), settings).unwrap_or_else(|error| panic!("{}: {error}", self.title))
    }
}

/// A module with the grammar `Page` and its `EXAMPLE`. With `; marks […]`, the marks of the picture. With a list of `(rule, length, height)`, where `NIL` is a gap, also
/// a test that compares the pieces along x with it.
macro_rules! example {
    ($(#[$doc:meta])* $name:ident, $title:literal, $start:expr, $rules:tt $(; marks $marks:expr)? $(, $pieces:expr)?) => {
        $(#[$doc])*
        pub(crate) mod $name {
            #[allow(unused_imports, reason = "each example needs some of it")]
            use super::*;

            // The checks report mistakes that pages show on purpose: see cga-lang/tests/data/lower/seed_*.cga.
            cga::cga! {
                @Allow(undefined_rule, size_not_positive, slot_never_made, float_without_space, sizes_beyond_extent, missing_asset, old_spelling)
                pub(crate) grammar Page = $rules;
            }

            pub(crate) const EXAMPLE: crate::pages::example::Example = crate::pages::example::Example {
                title: $title,
                rules: $rules,
                start: || $start,
                run: |shape, settings| Page::default().generate_with(shape, settings),
                marks: {
                    use crate::pages::example::Mark;
                    const MARKS: &[&[Mark]] = &[$($marks,)? &[]];
                    MARKS[0]
                },
            };

            $(
                #[test]
                fn pieces() {
                    crate::pieces::check(&EXAMPLE, &$pieces);
                }
            )?
        }
    };
}
pub(crate) use example;
