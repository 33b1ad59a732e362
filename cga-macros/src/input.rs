//! The input of the macro, read and compiled.

use cga_lang::compile::{Compiled, compile};
use cga_source::rust::{Header, read_header};
use proc_macro2::TokenStream;

use crate::source::{self, Source};
use crate::stub;

/// The input of the macro.
pub(crate) struct Input {
    pub(crate) header: Header,
    pub(crate) source: Source,
    pub(crate) compiled: Compiled,
}

impl Input {
    /// Reads the tokens of a call and the files that they name. The error is an expansion that reports it.
    pub(crate) fn read(input: TokenStream) -> Result<Self, TokenStream> {
        let (header, body) = read_header(input);
        let mut source =
            body.and_then(|body| source::open(&header, body)).map_err(|problem| stub::behind(&problem, &header))?;
        let mut imports = source::Imports::new();
        let compiled = compile(source.unit(), &mut imports, &header.levels);
        source.import(&compiled, imports.opened());
        Ok(Input { header, source, compiled })
    }
}
