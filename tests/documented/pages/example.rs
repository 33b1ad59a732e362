//! A worked example of a page: its title, the shape it starts from, its rules word for word, and how to run it.

use cga::{Error, Model, Settings, Shape};

/// One example. Programs that draw the examples use the same text as the tests.
#[derive(Clone, Copy)]
pub(crate) struct Example {
    /// The page, and the heading or sentence on it.
    pub(crate) title: &'static str,
    /// Verbatim CGA. What follows the first empty line are rules that the page gives once for all its examples.
    pub(crate) rules: &'static str,
    /// What the first rule starts with.
    pub(crate) start: fn() -> Shape,
    /// Runs the rules.
    pub(crate) run: fn(&Shape, &Settings) -> Result<Model, Error>,
}

impl Example {
    /// The model it gives.
    ///
    /// # Panics
    /// When it gives none.
    pub(crate) fn model(&self, settings: &Settings) -> Model {
        (self.run)(&(self.start)(), settings).unwrap_or_else(|error| panic!("{}: {error}", self.title))
    }
}

/// A module with the grammar `Page` and its `EXAMPLE`. With a list of `(rule, length, height)`, where `NIL` is a gap, also
/// a test that compares the pieces along x with it.
macro_rules! example {
    ($(#[$doc:meta])* $name:ident, $title:literal, $start:expr, $rules:tt $(, $pieces:expr)?) => {
        $(#[$doc])*
        pub(crate) mod $name {
            #[allow(unused_imports, reason = "each example needs some of it")]
            use super::*;

            // What pages show on purpose is found by the checks: see cga-lang/tests/data/lower/seed_*.cga.
            cga::cga! {
                @Allow(undefined_rule, size_not_positive, slot_never_made, float_without_space, sizes_beyond_extent)
                pub(crate) grammar Page = $rules;
            }

            pub(crate) const EXAMPLE: crate::pages::example::Example = crate::pages::example::Example {
                title: $title,
                rules: $rules,
                start: || $start,
                run: |shape, settings| Page::default().generate_with(shape, settings),
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
