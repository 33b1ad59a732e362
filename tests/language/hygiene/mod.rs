//! Generated code survives odd surroundings. Each file below must compile; most of the test is that.

mod inside;

mod names;

mod no_prelude;

mod shadow;

mod strict;

/// For the rules of `strict`.
fn operate(_: &mut cga::Shape, _: f64, _: &str, _: bool) {}

/// For the rules of `strict`.
fn function(number: f64, text: &str) -> bool {
    0.0 < number && text.is_empty()
}
