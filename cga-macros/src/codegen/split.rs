//! A split: its pattern as a constant, its sizes, and a `match` over its slots.

use cga_lang::ir::{Axis, Item, Prefix, RuleId, Split};
use proc_macro2::{Literal, Span, TokenStream};
use quote::quote_spanned;

use super::Cx;
use super::expr::Place;

impl Cx<'_> {
    /// Whether the shape was divided.
    pub(super) fn split(&self, split: &Split, rule: RuleId) -> TokenStream {
        let place = Span::mixed_site();
        let axis = match split.axis {
            Axis::X => quote_spanned!(place=> X),
            Axis::Y => quote_spanned!(place=> Y),
            Axis::Z => quote_spanned!(place=> Z),
        };
        let adjust = if split.adjust { quote_spanned!(place=> Adjust) } else { quote_spanned!(place=> NoAdjust) };
        let sizes = split.sizes.iter().map(|size| {
            let value = self.expr(&size.value, &Place::rule());
            match size.prefix {
                Prefix::Absolute => quote_spanned!(place=> cga_rt::Size::absolute(#value)),
                Prefix::Relative => quote_spanned!(place=> cga_rt::Size::relative(#value)),
                Prefix::Floating => quote_spanned!(place=> cga_rt::Size::floating(#value)),
            }
        });
        let count = split.sizes.len();
        let mut pattern = Vec::new();
        flatten(&split.pattern, &mut pattern);
        let arms = split.slots.iter().enumerate().map(|(number, target)| {
            let (number, code) = (Literal::u32_unsuffixed(number as u32), self.part(target, rule));
            quote_spanned!(place=> #number => #code,)
        });
        quote_spanned! { place=>
            const PATTERN: &[cga_rt::Item] = &[#(#pattern),*];
            let mut sizes: [cga_rt::Size; #count] = [#(#sizes),*];
            let how = (cga_rt::Axis::#axis, cga_rt::Adjust::#adjust);
            cga_rt::split(cx, shape, how, PATTERN, &mut sizes, |cx, slot, part| match slot {
                #(#arms)*
                _ => cga_rt::Flow::Continue(()),
            })?
        }
    }
}

/// The pattern as the runtime wants it: a repeat group says how many items follow that belong to it.
fn flatten(items: &[Item], out: &mut Vec<TokenStream>) {
    let place = Span::mixed_site();
    for item in items {
        match item {
            Item::Slot(_) => out.push(quote_spanned!(place=> cga_rt::Item::Slot)),
            Item::Repeat(items) => {
                let mut inner = Vec::new();
                flatten(items, &mut inner);
                let count = Literal::u32_unsuffixed(inner.len() as u32);
                out.push(quote_spanned!(place=> cga_rt::Item::Repeat(#count)));
                out.extend(inner);
            }
        }
    }
}
