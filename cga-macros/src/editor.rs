//! Items by which editors find names: declarations and uses at the user's own tokens, behind `cfg(rust_analyzer)`, which only
//! rust-analyzer sets. Compilers see nothing of it.
//!
//! Rules and functions are there anyway, as long as there are no errors. Values are not: parameters have numbers in the
//! generated code, constants may be folded, and an attribute is read where it is kept for a run.

use cga_lang::compile::Compiled;
use cga_lang::editor::index::{NameKind, Named};
use cga_lang::ir::Type;
use proc_macro2::{Ident, Span, TokenStream};

use crate::codegen::is_plain;
use crate::header::Header;
use crate::source::Source;

/// The names in inline rules.
pub(crate) fn names(compiled: &Compiled, header: &Header, source: &Source, has_errors: bool) -> TokenStream {
    if !source.is_inline() {
        return TokenStream::new();
    }
    let own: Vec<&Named> = compiled.index.iter().filter(|named| is_plain(&named.name)).collect();
    let items = own.iter().filter(|named| match named.kind {
        NameKind::Const => true,
        NameKind::Rule | NameKind::Function => has_errors,
        NameKind::Attr => header.name.is_none(),
        NameKind::Param(_) => false,
    });
    let items = items.map(|named| {
        let (name, ty) = (at(named, named.token, source), ty(named.ty));
        let uses = uses(named, source);
        code!(const #name: #ty = ::core::unreachable!(); const _: () = { #(_ = #uses;)* };)
    });
    let fields = header.name.clone().map(|mut grammar| {
        grammar.set_span(Span::call_site());
        let uses = own.iter().filter(|named| named.kind == NameKind::Attr).flat_map(|named| uses(named, source));
        code!(fn attributes(grammar: &#grammar) { #(_ = &grammar.#uses;)* })
    });
    let params = owners(&own).into_iter().map(|params| {
        let names = params.iter().map(|named| at(named, named.token, source));
        let types = params.iter().map(|named| ty(named.ty));
        let uses = params.iter().flat_map(|named| uses(named, source));
        code!(const _: () = { fn parameters(#(#names: #types,)*) { #(_ = #uses;)* } };)
    });
    code! {
        #[allow(unexpected_cfgs, non_upper_case_globals, non_snake_case)]
        const _: () = {
            #[cfg(rust_analyzer)]
            const _: () = { #(#items)* #fields #(#params)* };
        };
    }
}

/// The parameters of each declaration.
fn owners<'n>(list: &[&'n Named]) -> Vec<Vec<&'n Named>> {
    let mut owners: Vec<Vec<&Named>> = Vec::new();
    for named in list.iter().filter(|named| matches!(named.kind, NameKind::Param(_))) {
        match owners.last_mut().filter(|last| last[0].kind == named.kind) {
            Some(last) => last.push(named),
            None => owners.push(vec![named]),
        }
    }
    owners
}

/// A name at one of its tokens.
fn at(named: &Named, token: u32, source: &Source) -> Ident {
    Ident::new(&named.name, source.token(token))
}

fn uses(named: &Named, source: &Source) -> Vec<Ident> {
    named.uses.iter().map(|token| at(named, *token, source)).collect()
}

/// The type that an editor shows.
fn ty(ty: Option<Type>) -> TokenStream {
    match ty {
        Some(Type::Float) => code!(f64),
        Some(Type::Bool) => code!(bool),
        Some(Type::Text) => code!(&'static str),
        Some(Type::Floats) => code!(&'static [f64]),
        Some(Type::Bools) => code!(&'static [bool]),
        Some(Type::Texts) => code!(&'static [&'static str]),
        None => code!(()),
    }
}
