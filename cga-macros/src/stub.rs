//! The public names of a grammar with errors, so that one mistake does not become thirty in the user's code.

use cga_lang::compile::Compiled;
use cga_source::rust::{Header, Problem};
use proc_macro2::TokenStream;
use quote::quote;

use crate::codegen::{Public, PublicAttr, Taken, public, public_attrs};
use crate::output::Output;
use crate::report;
use crate::source::Source;

/// The fields of the struct, errors or not.
pub(crate) fn fields(compiled: &Compiled, source: &Source) -> Vec<PublicAttr> {
    if let Some(grammar) = &compiled.grammar {
        return public_attrs(grammar, source);
    }
    let mut taken = Taken::default();
    compiled.names.iter().map(|attr| PublicAttr::known_so_far(attr, source, &mut taken)).collect()
}

/// The struct with its fields and methods; nothing in it runs. The `#` values count as used.
pub(crate) fn grammar(attrs: Vec<PublicAttr>, header: &Header, source: &Source) -> Output {
    let captures = (0..source.hosts().len() as u32).map(|handle| (handle, None)).collect();
    Output { code: public(&Public { attrs, captures: Vec::new(), hidden: None }, header), captures }
}

/// The struct alone: not even its attributes are known.
pub(crate) fn behind(problem: &Problem, header: &Header) -> TokenStream {
    let error = report::problem(problem);
    if header.name.is_none() {
        return error;
    }
    let names = public(&Public { attrs: Vec::new(), captures: Vec::new(), hidden: None }, header);
    quote!(#error #names)
}
