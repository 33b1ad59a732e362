//! The rules that a grammar was compiled from.

use crate::run::env::Env;
use crate::shape::Shape;
use crate::value::{Value, ValueType};

/// The rules of a compiled grammar, for programs that load them again. Generated code has it with the feature `live`.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct RuleSource {
    /// The folder of the package.
    pub folder: &'static str,
    /// The path of the file with the rules from there.
    pub path: &'static str,
    /// True if it is a Rust file, false if it is a rule file.
    pub is_rust: bool,
    /// The paths of all files from there: this one, and the rule files that were imported.
    pub files: &'static [&'static str],
    /// The name of the grammar.
    pub name: &'static str,
    /// The levels of diagnostics in the header, by name: `allow`, `warn` or `deny`.
    pub levels: &'static [(&'static str, &'static str)],
    /// The Rust values and functions in the rules.
    pub calls: &'static [RustCall],
}

/// A Rust value or function in rules, with types.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct RustCall {
    /// `#` and the expression of a value, or the path of a function.
    pub name: &'static str,
    /// The types of the arguments.
    pub params: &'static [ValueType],
    /// The compiled code.
    pub code: RustCode,
}

/// The compiled code of a Rust value or function.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub enum RustCode {
    /// Gives a value of a type.
    Value(ValueType, fn(&[Value]) -> Value),
    /// Gives the text of a value that the rules join with text.
    Shown(fn(&[Value]) -> Value),
    /// Changes a shape.
    Operation(fn(&mut Env, &mut Shape, &[Value])),
}
