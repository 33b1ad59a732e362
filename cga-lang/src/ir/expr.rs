//! Expressions. Each knows its type.

use super::{Comp, FunctionId, GlobalId, HostId, Type, Value};
use crate::ops::{self, ShapeAttr};
use crate::span::Span;
use crate::syntax::ast::Binary;

/// An expression with its type.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// The kind of expression.
    pub kind: ExprKind,
    /// The type of its value.
    pub ty: Type,
    /// Where it stands.
    pub span: Span,
}

/// The kinds of expressions.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A constant.
    Value(Value),
    /// A parameter of the rule or function.
    Param(u32),
    /// An attribute, as the current shape sees it, or a constant.
    Global(GlobalId),
    /// `#name` or `#(…)`.
    Host(HostId),
    /// A function of the grammar. A shared one has a site: one number for each site of the caller.
    Call(FunctionId, Vec<u32>, Vec<Expr>),
    /// A function of the language.
    Builtin(&'static ops::Function, Vec<Expr>),
    /// A Rust function: `path::to(args)`.
    Rust(String, Vec<Expr>),
    /// An attribute of the current shape: `scope.sx`.
    Shape(&'static ShapeAttr),
    /// `comp(f) { … }`: an array with a value for each component.
    Comp(Box<Comp>),
    /// True if a selector's word, in its newest spelling, selects the candidate component.
    Word(&'static str),
    /// Returns true if the style of the run is one of these numbers.
    Style(Vec<u32>),
    /// Returns true if the site of the shared rule or function is one of these numbers.
    Site(Vec<u32>),
    /// `[a, b; c, d]`: entries are elements or arrays.
    Array(Vec<Vec<Expr>>),
    /// `base : step : limit`.
    Range(Box<Expr>, Box<Expr>, Box<Expr>),
    /// `a[i]` or `a[row, column]`.
    Index(Box<Expr>, Vec<Expr>),
    /// `.-a` or `.!a`.
    EachUnary(EachUnary, Box<Expr>),
    /// `a .+ b`: element by element. One side may be a single value. `+` joins text if the result is text.
    Each(Binary, Box<Expr>, Box<Expr>),
    /// `-a`.
    Neg(Box<Expr>),
    /// `!a`.
    Not(Box<Expr>),
    /// Both operands are always evaluated, the left one first. `+` joins text if the result is text.
    Binary(Binary, Box<Expr>, Box<Expr>),
    /// Many operators on values of one type, from left to right, as [`ExprKind::Binary`].
    Chain(Box<Expr>, Vec<(Binary, Expr)>),
    /// A float or bool as text, for `+` beside a string.
    ToText(Box<Expr>),
    /// The name of a file, and the folder of the rule file that names it: relative paths are looked for from there.
    File(Box<Expr>, String),
    /// `case … else`, or `p% : … else` with conditions that are drawn.
    Case(Vec<(Expr, Expr)>, Box<Expr>),
    /// The condition `p%`, after branches that have `before` percent together: it is drawn with the probability that is left.
    Chance {
        /// The percentage of the branch.
        percent: f64,
        /// The sum of the percentages of the branches before it.
        before: f64,
    },
}

/// Operators over the elements of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EachUnary {
    /// `.-`.
    Neg,
    /// `.!`.
    Not,
}
