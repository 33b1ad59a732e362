//! Rust that the written grammars call.
#![allow(dead_code, reason = "the grammars at hand may call none of it")]

use cga::{Color, Shape};

/// A number that follows from another one.
pub(crate) fn wave(x: f64) -> f64 {
    0.3 + 0.2 * (7.0 * x).fract()
}

/// Paints a shape by its size.
pub(crate) fn tint(shape: &mut Shape, grey: f64) {
    let share = grey.abs().fract();
    shape.set_color(Color::new(share, 0.5, 1.0 - share));
}
