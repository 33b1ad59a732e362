//! A comp: its arms as a table, a closure for what is asked about components, and a `match` over the arms.

use cga_lang::ir::{Align, Comp, CompMode, Expr, RuleId, Selector, Target};
use cga_lang::ops::variant;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote_spanned;

use super::Cx;
use super::expr::Place;

impl Cx<'_> {
    /// `number` counts the children that the rule makes.
    pub(super) fn comp(&self, comp: &Comp<Target>, rule: RuleId, number: u32) -> TokenStream {
        let place = Span::mixed_site();
        let (arms, how, when) = (self.arms(comp, &Place::rule(), Cx::asked), how(comp), self.when(comp));
        let child = Literal::u32_unsuffixed(number);
        let parts = comp.arms.iter().enumerate().map(|(number, arm)| {
            let (number, code) = (Literal::u32_unsuffixed(number as u32), self.part(&arm.then, rule));
            quote_spanned!(place=> #number => #code,)
        });
        quote_spanned! { place=>
            let arms = #arms;
            cga_rt::comp(cx, shape, #child, #how, &arms, &mut #when, &mut |cx, arm, part| match arm {
                #(#parts)*
                _ => cga_rt::Flow::Continue(()),
            })?;
        }
    }

    /// An array with a value for each component.
    pub(super) fn comp_value(&self, comp: &Comp<Expr>, at: &Place) -> TokenStream {
        let place = Span::mixed_site();
        let (arms, how, when) = (self.arms(comp, at, Cx::expr), how(comp), self.when(comp));
        let values = comp.arms.iter().enumerate().map(|(number, arm)| {
            let (number, value) = (Literal::u32_unsuffixed(number as u32), self.expr(&arm.then, &Place::component()));
            quote_spanned!(place=> #number => #value,)
        });
        let (env, shape) = (&at.env, &at.shape);
        quote_spanned! { place=> {
            let arms = #arms;
            cga_rt::comp_values(#env, #shape, #how, &arms, #when, |env, arm, part| match arm {
                #(#values)*
                _ => ::core::default::Default::default(),
            })
        } }
    }

    /// The table.
    fn arms<T>(&self, comp: &Comp<T>, at: &Place, expr: fn(&Self, &Expr, &Place) -> TokenStream) -> TokenStream {
        let place = Span::mixed_site();
        let table = comp.arms.iter().map(|arm| {
            let select = match &arm.selector {
                Selector::Word(word) => {
                    let word = Ident::new(&variant(word), place);
                    quote_spanned!(place=> Word(cga_rt::Word::#word))
                }
                Selector::Index(asked) => {
                    let value = expr(self, asked, at);
                    quote_spanned!(place=> Index(#value))
                }
                Selector::When(_) => quote_spanned!(place=> When),
            };
            let mode = match arm.mode {
                CompMode::Each => quote_spanned!(place=> Each),
                CompMode::Together => quote_spanned!(place=> Together),
                CompMode::Connected => quote_spanned!(place=> Connected),
            };
            let text = &arm.text;
            quote_spanned!(place=> cga_rt::Arm { select: cga_rt::Select::#select, mode: cga_rt::Mode::#mode, text: #text })
        });
        quote_spanned!(place=> [#(#table),*])
    }

    /// What answers the conditions.
    fn when<T>(&self, comp: &Comp<T>) -> TokenStream {
        let place = Span::mixed_site();
        let conditions = comp.arms.iter().enumerate().filter_map(|(number, arm)| match &arm.selector {
            Selector::When(condition) => {
                let number = Literal::u32_unsuffixed(number as u32);
                let condition = self.expr(condition, &Place::candidate());
                Some(quote_spanned!(place=> #number => #condition,))
            }
            Selector::Word(_) | Selector::Index(_) => None,
        });
        let conditions: Vec<TokenStream> = conditions.collect();
        if conditions.is_empty() {
            return quote_spanned!(place=> cga_rt::never);
        }
        quote_spanned!(place=> |env, arm, candidate| match arm { #(#conditions)* _ => false })
    }
}

/// A selector's word, inside a condition.
pub(super) fn asked(word: &str) -> TokenStream {
    let place = Span::mixed_site();
    let word = Ident::new(&variant(word), place);
    quote_spanned!(place=> candidate.is(cga_rt::Word::#word))
}

/// Into what a comp divides, and what frames its parts have.
fn how<T>(comp: &Comp<T>) -> TokenStream {
    let place = Span::mixed_site();
    let components = Ident::new(comp.components.rust, place);
    let align = match comp.align {
        Align::ZUp => quote_spanned!(place=> ZUp),
        Align::Keep => quote_spanned!(place=> Keep),
    };
    quote_spanned!(place=> cga_rt::Components::#components, cga_rt::Align::#align)
}
