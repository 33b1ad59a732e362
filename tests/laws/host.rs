//! Rust that the written grammars call, and the type of their list.
#![allow(dead_code, reason = "the grammars at hand may call none of it")]

use cga::{Color, Grammar, Shape};

/// Makes a grammar.
pub(crate) type Make = fn() -> Box<dyn Grammar + Sync>;

/// A number that follows from another one.
pub(crate) fn wave(x: f64) -> f64 {
    0.3 + 0.2 * (7.0 * x).fract()
}

/// Paints a shape by its size. A small change of the size is a small change of the colour.
pub(crate) fn tint(shape: &mut Shape, grey: f64) {
    let share = (2.0 * grey.abs().fract() - 1.0).abs();
    shape.set_color(Color::new(share, 0.5, 1.0 - share));
}
