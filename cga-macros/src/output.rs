//! The output of the macro: generated code, diagnostics, rebuild tracking, and the Rust values that rules capture.

use cga_lang::ir::Type;
use cga_source::rust::{Header, Host};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};

use crate::source::Source;

/// Puts diagnostics, rebuild tracking and generated code together: items, or an expression without a header.
pub(crate) fn wrap(header: &Header, source: &Source, aside: &TokenStream, output: &Output) -> TokenStream {
    let (tracking, code) = (source.tracking(), &output.code);
    if header.name.is_some() {
        return quote!(#aside #tracking #code);
    }
    // They are evaluated outside of the block: Rust code in the rules must not see the names inside.
    let hosts = output.captures.iter().map(|(handle, ty)| (&source.hosts()[*handle as usize], *ty));
    let values = hosts.map(|(host, ty)| match ty {
        Some(ty) => convert(&header.runtime, ty, host),
        None => reference(host),
    });
    let names = (0..output.captures.len()).map(capture);
    let place = Span::mixed_site();
    quote_spanned!(place=> match (#(#values,)*) { (#(#names,)*) => { #aside #tracking #code } })
}

/// Generated code, and the `#` values it captures in the expression form: by handle, with the type the rules need. It
/// is not known when there are errors.
pub(crate) struct Output {
    pub(crate) code: TokenStream,
    pub(crate) captures: Vec<(u32, Option<HostType>)>,
}

/// The required type of a Rust value in the rules.
#[derive(Clone, Copy)]
pub(crate) enum HostType {
    /// Of that type.
    Is(Type),
    /// Any type with a text form: the value is concatenated with text.
    Shown,
}

impl HostType {
    /// The type of the value inside the rules.
    pub(crate) fn inside(self) -> Type {
        match self {
            HostType::Is(ty) => ty,
            HostType::Shown => Type::Text,
        }
    }
}

/// The local that holds a captured value.
pub(crate) fn capture(index: usize) -> Ident {
    Ident::new(&format!("_capture_{index}"), Span::mixed_site())
}

/// A Rust value, converted for the rules. The call has the span of the user's token, so that rustc shows a wrong type there.
pub(crate) fn convert(runtime: &TokenStream, ty: HostType, host: &Host) -> TokenStream {
    let place = Span::mixed_site().located_at(host.span);
    let (runtime, code) = (relocated(runtime, place), reference(host));
    let function = conversion(ty, place);
    quote_spanned!(place=> #runtime::host::#function(#code))
}

/// The function of the runtime's `host` module that takes a Rust value of that type.
pub(crate) fn conversion(ty: HostType, place: Span) -> TokenStream {
    match ty {
        HostType::Is(Type::Float) => quote_spanned!(place=> ToFloat::to_float),
        HostType::Is(Type::Bool) => quote_spanned!(place=> ToBool::to_bool),
        HostType::Is(Type::Text) => quote_spanned!(place=> ToText::to_text),
        HostType::Is(Type::Floats) => quote_spanned!(place=> ToFloats::to_floats),
        HostType::Is(Type::Bools) => quote_spanned!(place=> ToBools::to_bools),
        HostType::Is(Type::Texts) => quote_spanned!(place=> ToTexts::to_texts),
        HostType::Shown => quote_spanned!(place=> Show::show),
    }
}

/// A path in another place. It means what it meant before.
fn relocated(path: &TokenStream, place: Span) -> TokenStream {
    let moved = path.clone().into_iter().map(|mut token| {
        token.set_span(place.resolved_at(token.span()));
        token
    });
    moved.collect()
}

/// A Rust value, borrowed.
fn reference(host: &Host) -> TokenStream {
    let (place, code) = (Span::mixed_site().located_at(host.span), &host.expr);
    quote_spanned!(place=> &#code)
}
