//! The public names of a grammar with errors, so that one mistake does not become thirty in the user's code.

use cga_lang::compile::Compiled;
use proc_macro2::TokenStream;

use crate::codegen::{Public, PublicAttr, public};
use crate::door::Source;
use crate::header::Header;

/// The struct with its fields and methods; nothing in it runs.
pub(crate) fn grammar(compiled: &Compiled, header: &Header, source: &Source) -> TokenStream {
    let attrs = compiled.names.attrs.iter().map(|attr| PublicAttr::known_so_far(attr, source)).collect();
    public(&Public { attrs, captures: Vec::new(), hidden: None }, header)
}

/// The struct alone: not even its attributes are known.
pub(crate) fn empty(header: &Header) -> TokenStream {
    public(&Public { attrs: Vec::new(), captures: Vec::new(), hidden: None }, header)
}
