//! Errors of rules that pass the checks and cannot be loaded.

use cga_lang::diag::code::Code;
use cga_lang::diag::{Diag, Diags};
use cga_lang::ir::Type;
use cga_lang::span::Span;
use std::cell::RefCell;

use crate::object::nothing;

/// The errors so far.
#[derive(Debug, Default)]
pub(crate) struct Problems(RefCell<Vec<Diag>>);

impl Problems {
    /// A Rust function that the host program has not registered. `is_compiled` is true for rules that a program was built with.
    pub(super) fn unregistered(&self, path: &str, kind: &str, is_compiled: bool, span: Span) {
        let mut diags = Diags::new();
        let message = format!("the Rust {kind} `{path}` is not registered, so rules that are loaded cannot call it");
        let help = format!("register it with `with_{kind}(\"{path}\", …)` before the rules are loaded");
        let diag = diags.report(Code::UnknownFunction, span, message).help(help);
        if is_compiled {
            diag.help(
                "or build the program again: it calls the functions of its rules with the types that they had then",
            );
        }
        self.0.borrow_mut().extend(diags.finish());
    }

    /// An operation that loaded rules cannot call.
    pub(super) fn missing(&self, name: &str, span: Span) {
        let mut diags = Diags::new();
        diags
            .report(Code::UnknownFunction, span, format!("`{name}` does not run in rules that are loaded"))
            .help("compile the rules with `cga!`");
        self.0.borrow_mut().extend(diags.finish());
    }

    /// A value of Rust code that was not compiled with the rules, or as another type.
    pub(super) fn captured(&self, name: &str, ty: Type, span: Span) {
        let mut diags = Diags::new();
        let ty = nothing(ty).ty();
        let message = format!("the program was built without the Rust value `{name}` as {ty}");
        diags.report(Code::UnknownName, span, message).help("build the program again, or make it an attribute");
        self.0.borrow_mut().extend(diags.finish());
    }

    /// The errors.
    pub(crate) fn finish(self) -> Vec<Diag> {
        self.0.into_inner()
    }
}
