//! Attributes and constants that shapes hold: those that some rule sets, and those of imports that start anew.

use cga_lang::ir::{Anew, Global, Type};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote_spanned;

use super::expr::Place;
use super::types::{self, cloned};
use super::{Cx, local};

impl Cx<'_> {
    /// The value of an attribute or constant that the run holds as `name`. Where it may be set the shape is asked first.
    pub(super) fn global(&self, global: Global, ty: Type, is_set: bool, name: &Ident, at: &Place) -> TokenStream {
        let place = Span::mixed_site();
        if !is_set {
            return cloned(ty, quote_spanned!(place=> g.#name));
        }
        let (shape, number, get) = (&at.shape, self.number(global), types::function(ty, "attribute"));
        match ty {
            Type::Float | Type::Bool => quote_spanned!(place=> cga_rt::get::#get(#shape, #number, g.#name)),
            _ => quote_spanned!(place=> cga_rt::get::#get(#shape, #number, &g.#name)),
        }
    }

    /// Gives the current shape a value of its own, which stands in `value`.
    pub(super) fn set(&self, global: Global, ty: Type, value: &Ident) -> TokenStream {
        let (number, kind) = (self.number(global), types::variant(ty));
        quote_spanned!(Span::mixed_site()=> cga_rt::set::attribute(shape, #number, cga_rt::Value::#kind(#value));)
    }

    /// Under which number a shape holds it: constants come behind the attributes.
    fn number(&self, global: Global) -> Literal {
        Literal::u32_suffixed(match global {
            Global::Attr(id) => id.0,
            Global::Const(id) => self.grammar.attrs.len() as u32 + id.0,
        })
    }

    /// The given values, and the copy on which everything starts anew.
    pub(super) fn anew(&self, anew: &Anew) -> (TokenStream, TokenStream) {
        let (place, at) = (Span::mixed_site(), Place::rule());
        let names: Vec<Ident> = (0..anew.given.len()).map(|number| local("given_", number)).collect();
        let values = anew.given.iter().map(|(_, value)| self.expr(value, &at));
        let given = quote_spanned!(place=> #(let #names = #values;)*);
        let set = anew.given.iter().zip(&names).map(|((id, value), name)| self.set(Global::Attr(*id), value.ty, name));
        let value = &local("value_", 0);
        let computed = anew.computed.iter().map(|(global, computed)| {
            let (code, set) = (self.expr(computed, &at), self.set(*global, computed.ty, value));
            quote_spanned!(place=> let #value = #code; #set)
        });
        (given, quote_spanned!(place=> let shape = &mut cga_rt::push(shape); #(#set)* #(#computed)*))
    }
}
