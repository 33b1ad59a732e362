//! Arms: a table, a closure for the conditions on parts, and a `match` over the arms.

use cga_lang::ir::{Arm, ArmMode, Block, Comp, RuleId, Selector, Target};
use cga_lang::ops::{Braces, variant};
use proc_macro2::{Ident, Literal, TokenStream};

use super::access::Access;
use super::{Generator, hygienic, local};

impl Generator<'_> {
    /// `number` counts the children that the rule makes.
    pub(super) fn divided(&self, block: &Block, arms: &[Arm<Target>], rule: RuleId, number: u32) -> TokenStream {
        let child = Literal::u32_unsuffixed(number);
        let (table, when) = (self.arms(arms, &Access::rule()), self.when(arms));
        let parts = arms.iter().enumerate().map(|(number, arm)| {
            let (number, code) = (Literal::u32_unsuffixed(number as u32), self.part(&arm.then, rule));
            code!(#number => #code,)
        });
        let visit = code! {
            &mut |cx, arm, part| match arm {
                #(#parts)*
                _ => cga_rt::Flow::Continue(()),
            }
        };
        let name = match block.row.braces {
            Braces::Modified => hygienic("comp_and_rest"),
            _ => hygienic(block.row.run),
        };
        if matches!(block.row.braces, Braces::Components | Braces::Modified) {
            let args = self.args(block.row, &block.args, &Access::rule(), &TokenStream::new());
            return code! {
                let arms = #table;
                cga_rt::#name(cx, shape, #child, #(#args,)* &arms, &mut #when, #visit)?;
            };
        }
        let args = self.args(block.row, &block.args, &Access::rule(), &code!(op::));
        let names: Vec<Ident> = (0..args.len()).map(|number| local("a", number)).collect();
        code! {
            #(let #names = #args;)*
            let arms = #table;
            cga_rt::divide(
                cx,
                shape,
                #child,
                &arms,
                &mut #when,
                |env, arms| cga_rt::op::#name(env, arms, #(#names),*),
                #visit,
            )?;
        }
    }

    /// An array with a value for each component.
    pub(super) fn comp_value(&self, comp: &Comp, at: &Access) -> TokenStream {
        let (arms, when) = (self.arms(&comp.arms, at), self.when(&comp.arms));
        let args = self.args(comp.row, &comp.args, at, &TokenStream::new());
        let values = comp.arms.iter().enumerate().map(|(number, arm)| {
            let (number, value) = (Literal::u32_unsuffixed(number as u32), self.expr(&arm.then, &Access::component()));
            code!(#number => #value,)
        });
        let (env, shape) = (&at.env, &at.shape);
        code! { {
            let arms = #arms;
            cga_rt::comp_values(#env, #shape, #(#args,)* &arms, #when, |env, arm, part| match arm {
                #(#values)*
                _ => ::core::default::Default::default(),
            })
        } }
    }

    /// The table.
    pub(super) fn arms<T>(&self, arms: &[Arm<T>], at: &Access) -> TokenStream {
        let table = arms.iter().map(|arm| {
            let select = match &arm.selector {
                Selector::Word(word) => {
                    let word = hygienic(&variant(word));
                    code!(Word(cga_rt::Word::#word))
                }
                Selector::Index(asked) => {
                    let value = self.expr(asked, at);
                    code!(Index(#value))
                }
                Selector::When(_) => code!(When),
            };
            let mode = match arm.mode {
                ArmMode::Each => code!(Each),
                ArmMode::Together => code!(Together),
                ArmMode::Connected => code!(Connected),
            };
            let text = &arm.text;
            code!(cga_rt::Arm { select: cga_rt::Select::#select, mode: cga_rt::Mode::#mode, text: cga_rt::Text::fixed(#text) })
        });
        code!([#(#table),*])
    }

    /// The closure that evaluates the conditions.
    fn when<T>(&self, arms: &[Arm<T>]) -> TokenStream {
        let conditions = arms.iter().enumerate().filter_map(|(number, arm)| match &arm.selector {
            Selector::When(condition) => {
                let number = Literal::u32_unsuffixed(number as u32);
                let condition = self.expr(condition, &Access::candidate());
                Some(code!(#number => #condition,))
            }
            Selector::Word(_) | Selector::Index(_) => None,
        });
        let conditions: Vec<TokenStream> = conditions.collect();
        if conditions.is_empty() {
            return code!(cga_rt::never);
        }
        code!(|env, arm, candidate| match arm { #(#conditions)* _ => false })
    }
}
