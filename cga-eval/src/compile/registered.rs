//! Rust values, functions and operations that rules name.

use std::collections::BTreeMap;
use std::sync::Arc;

use cga_lang::ir::{Expr, Type};
use cga_runtime::rt::{RustCall, RustCode};

use crate::code::{HostFunction, HostOperation};
use crate::object::nothing;

/// The functions and operations that the host program has registered, by their paths in rules, and the Rust code that was compiled with
/// the rules.
#[derive(Clone, Default)]
pub(crate) struct Registered {
    pub(crate) functions: BTreeMap<String, HostFunction>,
    pub(crate) operations: BTreeMap<String, HostOperation>,
    pub(crate) compiled: &'static [RustCall],
    /// True for rules that the program was built with.
    pub(crate) is_live: bool,
    /// The Rust values of the rules by handle, as `#` and the expression.
    pub(crate) values: Vec<String>,
}

impl std::fmt::Debug for Registered {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.functions.keys()).entries(self.operations.keys()).finish()
    }
}

impl Registered {
    /// A function that gives a value of a type. One that is registered has every type.
    pub(super) fn function(&self, name: &str, args: &[Expr], ty: Type) -> Option<HostFunction> {
        let ty = nothing(ty).ty();
        let compiled = || {
            self.compiled(name, args).find_map(|code| match code {
                RustCode::Value(own, function) if own == ty => Some(Arc::new(function) as HostFunction),
                _ => None,
            })
        };
        self.functions.get(name).cloned().or_else(compiled)
    }

    /// The text of a value that the rules join with text.
    pub(super) fn shown(&self, name: &str) -> Option<HostFunction> {
        self.compiled(name, &[]).find_map(|code| match code {
            RustCode::Shown(function) => Some(Arc::new(function) as HostFunction),
            _ => None,
        })
    }

    /// An operation.
    pub(super) fn operation(&self, name: &str, args: &[Expr]) -> Option<HostOperation> {
        let compiled = || {
            self.compiled(name, args).find_map(|code| match code {
                RustCode::Operation(operation) => Some(HostOperation::Compiled(operation)),
                _ => None,
            })
        };
        self.operations.get(name).cloned().or_else(compiled)
    }

    /// The compiled code of a name for arguments of these types.
    fn compiled<'c>(&'c self, name: &'c str, args: &'c [Expr]) -> impl Iterator<Item = RustCode> + 'c {
        let is_meant = move |call: &&RustCall| {
            call.name == name && call.params.iter().copied().eq(args.iter().map(|arg| nothing(arg.ty).ty()))
        };
        self.compiled.iter().filter(is_meant).map(|call| call.code)
    }
}
