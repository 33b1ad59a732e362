//! A split: its pattern and what is known of its sizes as constants, and a `match` over its slots.

use cga_lang::ir::{Axis, ExprKind, Item, Measure, Piece, Prefix, RuleId, Size, Solved, Split};
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
        let how = quote_spanned!(place=> (cga_rt::Axis::#axis, cga_rt::Adjust::#adjust));
        let arms = split.slots.iter().enumerate().map(|(number, target)| {
            let (number, code) = (Literal::u32_unsuffixed(number as u32), self.part(target, rule));
            quote_spanned!(place=> #number => #code,)
        });
        let visit = quote_spanned! { place=>
            |cx, slot, part| match slot {
                #(#arms)*
                _ => cga_rt::Flow::Continue(()),
            }
        };
        match (&split.solved, split.measure) {
            (Some(solved), _) => self.solved(solved, &how, &visit),
            (None, Measure::Length) => self.unsolved(split, &quote_spanned!(place=> split), &how, &visit),
            (None, Measure::Area) => self.unsolved(split, &quote_spanned!(place=> split_area), &how, &visit),
        }
    }

    fn unsolved(&self, split: &Split, call: &TokenStream, how: &TokenStream, visit: &TokenStream) -> TokenStream {
        let place = Span::mixed_site();
        let count = split.sizes.len();
        let items = split.pattern.iter().map(|item| match item {
            Item::Slot => quote_spanned!(place=> cga_rt::Item::Slot),
            Item::Repeat(len) => {
                let len = Literal::u32_unsuffixed(*len);
                quote_spanned!(place=> cga_rt::Item::Repeat(#len))
            }
        });
        let sizes = split.sizes.iter().map(|size| {
            let value = self.expr(&size.value, &Place::rule());
            match size.prefix {
                Prefix::Absolute => quote_spanned!(place=> cga_rt::Size::absolute(#value)),
                Prefix::Relative => quote_spanned!(place=> cga_rt::Size::relative(#value)),
                Prefix::Floating => quote_spanned!(place=> cga_rt::Size::floating(#value)),
            }
        });
        let constant = |size: &Size| matches!(size.value.kind, ExprKind::Value(_));
        let (keyword, name) = if split.sizes.iter().all(constant) {
            (quote_spanned!(place=> const), quote_spanned!(place=> SIZES))
        } else {
            (quote_spanned!(place=> let), quote_spanned!(place=> sizes))
        };
        quote_spanned! { place=>
            const PATTERN: &[cga_rt::Item] = &[#(#items),*];
            #keyword #name: [cga_rt::Size; #count] = [#(#sizes),*];
            cga_rt::#call(cx, shape, #how, PATTERN, #name, #visit)?
        }
    }

    fn solved(&self, solved: &Solved, how: &TokenStream, visit: &TokenStream) -> TokenStream {
        let place = Span::mixed_site();
        let extent = Literal::f64_unsuffixed(solved.extent);
        let pieces = solved.pieces.iter().map(|piece| {
            let Piece { slot, start, end, length } = *piece;
            let slot = Literal::u32_unsuffixed(slot);
            let [start, end, length] = [start, end, length].map(Literal::f64_unsuffixed);
            quote_spanned!(place=> cga_rt::Piece { slot: #slot, start: #start, end: #end, length: #length })
        });
        quote_spanned! { place=>
            const PIECES: &[cga_rt::Piece] = &[#(#pieces),*];
            cga_rt::split_solved(cx, shape, #how, #extent, PIECES, #visit)?
        }
    }
}
