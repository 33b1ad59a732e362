//! Divisions into components, by operation and as values.

use super::Expr;
use crate::ops::Component;
use crate::span::Span;

/// `comp(f) { … }`. An arm makes a `T` of its components: a [`Target`](super::Target), or the value of an [`Expr`].
#[derive(Clone, Debug)]
pub struct Comp<T> {
    /// Into what.
    pub components: &'static Component,
    /// Whether the parts have frames of their own.
    pub align: Align,
    /// Tried from left to right; what one takes the next can't have.
    pub arms: Vec<CompArm<T>>,
    /// The operation's name.
    pub span: Span,
}

/// The scopes and pivots of parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// `zUp`: as the component lies.
    ZUp,
    /// `noAlign`: as the shape's own.
    Keep,
}

/// `selector : …`, `selector = …` or `selector =: …`.
#[derive(Clone, Debug)]
pub struct CompArm<T> {
    /// Which components it takes.
    pub selector: Selector,
    /// `comp.sel`, as written.
    pub text: String,
    /// What is one shape.
    pub mode: CompMode,
    /// What becomes of it. A value is computed with it as current shape.
    pub then: T,
}

/// The operator of an arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompMode {
    /// `:`, one shape a component.
    Each,
    /// `=`, one shape for all.
    Together,
    /// `=:`, one shape for those that touch each other.
    Connected,
}

/// Which components an arm takes.
#[derive(Clone, Debug)]
pub enum Selector {
    /// A lone word of [`crate::ops::selectors`], in its newest spelling.
    Word(&'static str),
    /// By index, evaluated once on the whole shape.
    Index(Expr),
    /// Those for which this is true, with the component as current shape. Words stand in it.
    When(Expr),
}
