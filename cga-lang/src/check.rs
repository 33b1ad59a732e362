//! Runs the stages from names to diagnostics.
//!
//! Passes read the trees and write side tables and findings; all of them run. What could not be resolved has no entry
//! in a table, and nothing more is said about it. [`Checked`] is made only when there was no error.

use crate::diag::code::Code;
use crate::diag::{Diags, Level};
use crate::diagnostics::levels;
use crate::editor::index::{Named, index};
use crate::infer::{self, Inferred};
use crate::ir::Type;
use crate::link::Program;
use crate::resolve::context::Context;
use crate::resolve::globals::{Declared, Globals};
use crate::resolve::tables::Tables;
use crate::resolve::{cycles, duplicates, names, overrides};
use crate::{annotations, diagnostics};

/// A program without errors. Only this can be lowered.
pub struct Checked<'a> {
    pub(crate) globals: Globals<'a>,
    pub(crate) tables: Tables,
}

/// The result of a check.
pub(crate) struct CheckOutcome<'a> {
    /// The program, if it had no error.
    pub(crate) checked: Option<Checked<'a>>,
    /// The attributes with their types, where these are known.
    pub(crate) attrs: Vec<(Declared<'a>, Option<Type>)>,
    /// The places where names are declared and used.
    pub(crate) index: Vec<Named>,
    /// The result of type inference. With requests for other types, only this is known.
    pub(crate) types: Inferred,
}

/// Runs every pass. `levels` hold for the grammar as a whole; annotations in the tree come on top.
/// Diagnostics of sizes and calls need the final program: with `last`, or without a type mismatch, no more declarations are
/// instantiated.
pub(crate) fn check<'a>(
    program: &'a Program,
    levels: &[(Code, Level)],
    last: bool,
    diags: &mut Diags,
) -> CheckOutcome<'a> {
    let mut cx = Context { globals: Globals::new(program), tables: Tables::default(), at: 0, diags };
    let levels = levels::collect(&mut cx, levels);
    duplicates::values(&mut cx);
    overrides::check(&mut cx);
    names::uses(&mut cx);
    let types = infer::infer(&mut cx);
    if !types.wanted.is_empty() {
        return CheckOutcome { checked: None, attrs: Vec::new(), index: Vec::new(), types };
    }
    let is_final = last || !types.misfit;
    annotations::read(&mut cx);
    duplicates::operations(&mut cx);
    duplicates::overloads(&mut cx);
    duplicates::styles(&mut cx);
    cycles::find(&mut cx);
    if is_final {
        diagnostics::check(&mut cx);
    }
    let Context { globals, tables, diags, .. } = cx;
    levels::apply(&levels, diags);
    let attrs = globals.attrs.iter().map(|item| (item.clone(), item.ty(&tables))).collect();
    let index = if is_final { index(&globals, &tables) } else { Vec::new() };
    let checked = (!diags.has_errors()).then_some(Checked { globals, tables });
    CheckOutcome { checked, attrs, index, types }
}
