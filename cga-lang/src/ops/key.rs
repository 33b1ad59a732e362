//! Keys of rows, by which a back end that evaluates rules finds their functions.

use super::{Function, Operation, Param, ParamKind};
use crate::types::Type;

impl ParamKind {
    /// The kind of argument that the runtime's function gets: a type, a kind of length, or the enum of a word.
    pub fn argument(&self) -> &'static str {
        match self {
            ParamKind::Value(Type::Float) | ParamKind::Channel => "float",
            ParamKind::Value(Type::Bool) => "bool",
            ParamKind::Value(Type::Text) | ParamKind::Color | ParamKind::Image(_) => "text",
            ParamKind::Value(Type::Floats) | ParamKind::PerEdge => "floats",
            ParamKind::Value(Type::Bools) => "bools",
            ParamKind::Value(Type::Texts) => "texts",
            ParamKind::Any | ParamKind::Selector => "any",
            ParamKind::Length => "length",
            ParamKind::Size => "size",
            ParamKind::Files(Type::Texts) => "files",
            ParamKind::File(_) | ParamKind::Files(_) => "file",
            ParamKind::Word(words) => words.rust,
        }
    }
}

impl Operation {
    /// The runtime's function with the kinds of its arguments, as in `scatter(ScatterDomain, float, Distribution)`. Rows with
    /// equal keys run equal code.
    pub fn key(&self) -> String {
        key(self.run, self.params)
    }
}

impl Function {
    /// The runtime's function with the kinds of its arguments, as in `find_near(floats, float, float)`. Rows with equal
    /// keys run equal code.
    pub fn key(&self) -> String {
        key(self.run, self.params)
    }
}

fn key(name: &str, params: &[Param]) -> String {
    let arguments: Vec<&str> = params.iter().map(|param| param.kind.argument()).collect();
    format!("{name}({})", arguments.join(", "))
}

#[cfg(test)]
mod tests {
    use crate::ops::{all_functions, all_operations};
    use std::collections::HashMap;

    #[test]
    fn functions_with_equal_keys_run_equal_code() {
        let mut known = HashMap::new();
        for row in all_functions() {
            let code = (row.ty, row.needs);
            assert_eq!(*known.entry(row.key()).or_insert(code), code, "{row:?}");
        }
    }

    #[test]
    fn operations_with_equal_keys_run_equal_code() {
        let mut known = HashMap::new();
        for row in all_operations() {
            let code = (row.braces, row.uses_base, row.changes);
            assert_eq!(*known.entry(row.key()).or_insert(code), code, "{row:?}");
        }
    }
}
