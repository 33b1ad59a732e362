//! Sections of a boundary: a pattern with sizes, a closure for the depths, and a `match` over sections and the rest.

use cga_lang::ir::{Block, RuleId, Sections};
use proc_macro2::{Literal, TokenStream};

use super::access::Access;
use super::split::items;
use super::{Generator, hygienic};

impl Generator<'_> {
    /// `number` counts the children that the rule makes.
    pub(super) fn sections(&self, block: &Block, parts: &Sections, rule: RuleId, number: u32) -> TokenStream {
        let (lets, names) = self.named_args(block);
        let name = hygienic(block.row.run);
        let number = Literal::u32_unsuffixed(number);
        let (items, sizes) = (items(&parts.slots.pattern), self.sizes(&parts.slots));
        let rest = self.arms(&parts.rest, &Access::rule());
        let depths = parts.depths.iter().enumerate().map(|(slot, depth)| {
            let (slot, depth) = (Literal::u32_unsuffixed(slot as u32), self.expr(depth, &Access::component()));
            code!(#slot => #depth,)
        });
        let targets = parts.slots.targets.iter().chain(parts.rest.iter().map(|arm| &arm.then));
        let targets = targets.enumerate().map(|(slot, target)| {
            let (slot, code) = (Literal::u32_unsuffixed(slot as u32), self.part(target, rule));
            code!(#slot => #code,)
        });
        code! {
            #lets
            let sizes = &mut [#(#sizes),*];
            let rest = #rest;
            cga_rt::sections(
                cx,
                shape,
                #number,
                (&[#(#items),*], sizes),
                &rest,
                &mut |env, slot, part| match slot {
                    #(#depths)*
                    _ => 0.0,
                },
                |env, sections| cga_rt::op::#name(env, sections, #(#names),*),
                &mut |cx, slot, part| match slot {
                    #(#targets)*
                    _ => cga_rt::Flow::Continue(()),
                },
            )?;
        }
    }
}
