//! Generated code survives odd surroundings. Each file below must compile; most of the test is that.

#[path = "hygiene/inside.rs"]
mod inside;
#[path = "hygiene/names.rs"]
mod names;
#[path = "hygiene/no_prelude.rs"]
mod no_prelude;
#[path = "hygiene/shadow.rs"]
mod shadow;
#[path = "hygiene/strict.rs"]
mod strict;

/// For the rules of `strict`.
fn operate(_: &mut cga::Shape, _: f64, _: &str, _: bool) {}

/// For the rules of `strict`.
fn function(number: f64, text: &str) -> bool {
    0.0 < number && text.is_empty()
}
