//! A comp: its arms as a table, and a `match` over them.

use cga_lang::ir::{Comp, CompMode, RuleId, Selector};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote_spanned;

use super::Cx;
use super::expr::Place;

impl Cx<'_> {
    pub(super) fn comp(&self, comp: &Comp, rule: RuleId) -> TokenStream {
        let place = Span::mixed_site();
        let table = comp.arms.iter().map(|arm| {
            let select = match &arm.selector {
                Selector::Word(word) => {
                    let variant = Ident::new(&variant(word), place);
                    quote_spanned!(place=> Word(cga_rt::Word::#variant))
                }
                Selector::Index(expr) => {
                    let value = self.expr(expr, &Place::rule());
                    quote_spanned!(place=> Index(#value))
                }
            };
            let mode = match arm.mode {
                CompMode::Each => quote_spanned!(place=> Each),
                CompMode::Together => quote_spanned!(place=> Together),
            };
            let text = &arm.text;
            quote_spanned!(place=> cga_rt::Arm { select: cga_rt::Select::#select, mode: cga_rt::Mode::#mode, text: #text })
        });
        let arms = comp.arms.iter().enumerate().map(|(number, arm)| {
            let (number, code) = (Literal::u32_unsuffixed(number as u32), self.part(&arm.target, rule));
            quote_spanned!(place=> #number => #code,)
        });
        quote_spanned! { place=>
            let arms = [#(#table),*];
            let (components, align) = (cga_rt::Components::Faces, cga_rt::Align::ZUp);
            cga_rt::comp(cx, shape, components, align, &arms, cga_rt::never, |cx, arm, part| match arm {
                #(#arms)*
                _ => cga_rt::Flow::Continue(()),
            })?;
        }
    }
}

/// The runtime's name of a selector word: the same with a capital letter.
fn variant(word: &str) -> String {
    let mut chars = word.chars();
    chars.next().map(|first| first.to_uppercase().chain(chars).collect()).unwrap_or_default()
}
