//! The expansion of the macro for editors: every name of inline rules, at the user's own token, as something that
//! rust-analyzer understands.
//!
//! The crate `cga` exports this expansion as `cga!` under `cfg(rust_analyzer)`, which only rust-analyzer sets. Compilers see
//! nothing of it. It has the public struct, an item for each declaration, and the names of all bodies in modules, one for each
//! context. The functions that run are left out: for each token of the user, rust-analyzer passes over the whole expansion.
//!
//! A name that the parser did not reach has its meaning by the tokens alone, so that a broken rule does not hide the others.

mod contexts;
mod names;
mod scopes;
mod words;

use cga_lang::compile::Compiled;
use cga_source::rust::Header;
use proc_macro2::TokenStream;

use crate::codegen::PublicAttr;
use crate::input::Input;
use crate::source::Source;
use crate::{output, report, stub};

pub(crate) use words::words;

/// The expansion for editors.
pub(crate) fn expand(input: TokenStream) -> TokenStream {
    let Input { header, source, compiled } = match Input::read(input) {
        Ok(input) => input,
        Err(problem) => return problem,
    };
    let fields = stub::fields(&compiled, &source);
    let names = inline(&compiled, &header, &source, &fields);
    let aside: TokenStream = [names, report::errors(&compiled.diags, &source)].into_iter().collect();
    output::wrap(&header, &source, &aside, &stub::grammar(fields, &header, &source))
}

/// The names in inline rules.
fn inline(compiled: &Compiled, header: &Header, source: &Source, fields: &[PublicAttr]) -> TokenStream {
    if !source.is_inline() {
        return TokenStream::new();
    }
    let scope = scopes::Scope::new(compiled, header, source, fields);
    let (modules, outside) = (contexts::modules(&scope), names::outside(&scope));
    code! {
        const _: () = {
            #[allow(non_upper_case_globals, non_snake_case, dead_code)]
            mod names {
                macro_rules! computed { () => { ::core::unreachable!() } }
                #modules
            }
            #outside
        };
    }
}
