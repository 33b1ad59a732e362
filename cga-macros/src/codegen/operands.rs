//! Operations with operations in their braces: for each part that they make, or as operands.

use cga_lang::ir::{Block, RuleId, Target};
use proc_macro2::{Ident, Literal, TokenStream};

use super::access::Access;
use super::rule::successor;
use super::{Generator, hygienic, local};

impl Generator<'_> {
    /// An operation that makes parts, each with the same successor. `number` counts the children that the rule makes.
    pub(super) fn each(&self, block: &Block, target: &Target, rule: RuleId, number: u32) -> TokenStream {
        let (lets, names) = self.named_args(block);
        let name = hygienic(block.row.run);
        let (number, part) = (Literal::u32_unsuffixed(number), self.part(target, rule));
        code! {
            #lets
            cga_rt::each(cx, shape, #number, |env, shape| cga_rt::op::#name(env, shape, #(#names),*), &mut |cx, part| #part)?;
        }
    }

    /// An operation that makes a new current shape from the leaves of its operands. The first operand is child number `number`.
    pub(super) fn derived(&self, block: &Block, operands: &[Target], rule: RuleId, number: u32) -> TokenStream {
        let (lets, names) = self.named_args(block);
        let name = hygienic(block.row.run);
        let recomposes = block.recomposes();
        let operands = operands.iter().zip(number..).map(|(target, number)| {
            let code = self.give(target, rule, &TokenStream::new(), &successor(number));
            code! {
                cga_rt::operand(
                    cx,
                    g,
                    &mut |cx| {
                        #code
                        cga_rt::Flow::Continue(())
                    },
                    CgaRules::cga_resume,
                )?
            }
        });
        let operands = code!([#(#operands),*]);
        let operands = match recomposes {
            true => code!({
                let begun = cx.env.begin_recomposition(shape);
                let shape = &begun.shape();
                #operands
            }),
            false => operands,
        };
        code! {
            let changed = {
                #lets
                let operands = #operands;
                cx.env.ask()?;
                let mut whole = cx.env.whole(shape);
                cga_rt::op::#name(cx.env, &mut whole, operands, #(#names),*);
                cx.env.base(whole)
            };
            let shape = &changed.shape();
        }
    }

    /// The arguments of an operation as statements, and their names.
    pub(super) fn named_args(&self, block: &Block) -> (TokenStream, Vec<Ident>) {
        let names: Vec<Ident> = (0..block.args.len()).map(|number| local("a", number)).collect();
        let values = self.args(block.row, &block.args, &Access::rule(), &code!(op::));
        (code!(#(let #names = #values;)*), names)
    }
}
