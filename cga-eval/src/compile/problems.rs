//! Errors of rules that pass the checks and cannot be loaded.

use cga_lang::diag::code::Code;
use cga_lang::diag::{Diag, Diags};
use cga_lang::span::Span;
use std::cell::RefCell;

/// The errors so far.
#[derive(Debug, Default)]
pub(crate) struct Problems(RefCell<Vec<Diag>>);

impl Problems {
    /// A Rust function that the host program has not registered.
    pub(super) fn unregistered(&self, path: &str, kind: &str, span: Span) {
        let mut diags = Diags::new();
        let message = format!("the Rust {kind} `{path}` is not registered, so rules that are loaded cannot call it");
        let help = format!("register it with `with_{kind}(\"{path}\", …)` before the rules are loaded");
        diags.report(Code::UnknownFunction, span, message).help(help);
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

    /// A value of Rust code, which only rules in Rust code can name.
    pub(super) fn captured(&self, span: Span) {
        let mut diags = Diags::new();
        diags
            .report(Code::UnknownName, span, "a value of Rust code is only known where rules are compiled")
            .help("make it an attribute, and set the attribute");
        self.0.borrow_mut().extend(diags.finish());
    }

    /// The errors.
    pub(crate) fn finish(self) -> Vec<Diag> {
        self.0.into_inner()
    }
}
