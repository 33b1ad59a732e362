//! A split: its pattern as a constant, its sizes, and a function that calls the rule of a slot.

use cga_lang::ir::facts::TemplateNeeds;
use cga_lang::ir::plan::{PartNeeds, SplitForm, TemplateRoot};
use cga_lang::ir::{Axis, Block, Expr, ExprKind, Item, Piece, Prefix, RuleId, Slots, Solved, Target, Type};
use cga_lang::ops::{Braces, Measure};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::access::Access;
use super::{Generator, hygienic, local, site, types};

impl Generator<'_> {
    /// An expression that divides the shape and is true if there was a piece. `number` counts the children that the rule makes.
    pub(super) fn split(&self, block: &Block, slots: &Slots, rule: RuleId, number: u32) -> TokenStream {
        let Braces::Slots(measure) = block.row.braces else { return TokenStream::new() };
        // Parts in texture space do not come along an axis, and their scopes are found with them.
        let axis = match block.axis() {
            Some(Axis::X) | None => code!(cga_rt::Axis::X),
            Some(Axis::Y) => code!(cga_rt::Axis::Y),
            Some(Axis::Z) => code!(cga_rt::Axis::Z),
        };
        let adjusts = block.adjusts() && measure != Measure::Texture;
        let adjust = if adjusts { code!(Adjust) } else { code!(NoAdjust) };
        let number = Literal::u32_unsuffixed(number);
        let form = self.plan.split_form(block, rule);
        if form == SplitForm::InPlace {
            return self.in_place(slots, rule, [&axis, &adjust], &number);
        }
        let items = items(&slots.pattern);
        let successors = slots.targets.iter().map(|target| self.successor(target, rule));
        let has_total = self.plan.needs_total(slots);
        let (last, visit) = self.visit(slots, rule, &axis);
        let sizes = self.sizes(slots);
        let count = slots.sizes.len();
        let divided = match (form, measure) {
            (SplitForm::Solved(solved), _) => {
                let (extent, pieces) = (Literal::f64_unsuffixed(solved.extent), pieces(solved));
                code!(cga_rt::split_solved(cx, shape, SPLIT, #extent, &[#(#pieces),*], #visit)?)
            }
            (_, Measure::Texture) => {
                let args = self.args(block.row, &block.args, &Access::rule(), &TokenStream::new());
                code! {
                    let sizes = &mut [#(#sizes),*];
                    let axis = (#(#args),*);
                    cga_rt::split_texture(cx, shape, SPLIT, axis, sizes, &mut [0.0; #count], #visit)?
                }
            }
            _ => {
                let split = if measure == Measure::Area { "split_area" } else { "split" };
                let split = hygienic(split);
                code! {
                    let sizes = &mut [#(#sizes),*];
                    cga_rt::#split(cx, shape, SPLIT, sizes, &mut [0.0; #count], #visit)?
                }
            }
        };
        code! { {
            const SPLIT: &cga_rt::Split<'_> = &cga_rt::Split {
                axis: #axis,
                adjust: cga_rt::Adjust::#adjust,
                number: #number,
                pattern: &[#(#items),*],
                successors: &[#(#successors),*],
                has_total: #has_total,
            };
            #last
            #divided
        } }
    }

    /// The successor of a slot, as the runtime knows it.
    fn successor(&self, target: &Target, rule: RuleId) -> TokenStream {
        match target {
            Target::Nil if self.plan.vanishes(target, rule) => {
                code!(cga_rt::Successor::Rule { draws: false, counts: false })
            }
            Target::Nil => code!(cga_rt::Successor::Nil),
            Target::Leaf(name) => {
                let name = self.leaf(name);
                code!(cga_rt::Successor::Leaf(#name))
            }
            Target::Rule { .. } => {
                let PartNeeds { draws, counts } = self.plan.part_needs(target);
                code!(cga_rt::Successor::Rule { draws: #draws, counts: #counts })
            }
        }
    }

    /// The function that calls the rule of a slot, with the variables that it needs.
    fn visit(&self, slots: &Slots, rule: RuleId, axis: &TokenStream) -> (TokenStream, TokenStream) {
        let (mut last, mut calls) = (TokenStream::new(), TokenStream::new());
        for (slot, (target, template)) in slots.targets.iter().zip(self.plan.templates(slots, rule)).enumerate() {
            if !(self.plan.vanishes(target, rule) || matches!(target, Target::Rule { .. })) {
                continue;
            }
            let code = match template {
                Some(root) => {
                    let name = local("last", slot);
                    last.extend(code!(let mut #name = ::core::default::Default::default();));
                    self.repeat(&root, target, axis, &name)
                }
                None => self.part(target, rule),
            };
            let slot = Literal::usize_unsuffixed(slot);
            calls.extend(code!(#slot => #code,));
        }
        let visit = match calls.is_empty() {
            true => code!(&mut |_, _, _| cga_rt::Flow::Continue(())),
            false => code! {
                &mut |cx, slot, part| match slot {
                    #calls
                    _ => cga_rt::Flow::Continue(()),
                }
            },
        };
        (last, visit)
    }

    /// A split that is laid out in the rule.
    fn in_place(
        &self,
        slots: &Slots,
        rule: RuleId,
        [axis, adjust]: [&TokenStream; 2],
        number: &Literal,
    ) -> TokenStream {
        let count = slots.sizes.len();
        let (items, sizes) = (items(&slots.pattern), self.sizes(slots));
        let total = if self.plan.needs_total(slots) { code!(cga_rt::Row::total(&pieces)) } else { code!(0) };
        let statements = slots.targets.iter().enumerate().map(|(slot, target)| {
            let slot = Literal::usize_unsuffixed(slot);
            match target {
                Target::Nil if !self.plan.vanishes(target, rule) => code!(division.skip(row.slot(#slot));),
                Target::Leaf(name) => {
                    let name = self.leaf(name);
                    code!(division.leaf(cx, row.slot(#slot), #axis, #name)?;)
                }
                Target::Nil | Target::Rule { .. } => {
                    let (PartNeeds { draws, counts }, code) = (self.plan.part_needs(target), self.part(target, rule));
                    code! {
                        let slot = cga_rt::Slot { number: #slot, in_group: false, draws: #draws, counts: #counts };
                        if let ::core::option::Option::Some(part) = division.part(row.slot(#slot), #axis, slot) {
                            let flow: cga_rt::Flow = #code;
                            flow?;
                        }
                    }
                }
            }
        });
        code! { {
            const PATTERN: &[cga_rt::Item] = &[#(#items),*];
            const SIZES: [cga_rt::Size; #count] = [#(#sizes),*];
            let mut lengths = [0.0; #count];
            let extent = cga_rt::extent(cx.env, shape, #axis);
            let pieces = &cga_rt::solve(PATTERN, &SIZES, &mut lengths, extent);
            let at_most = cga_rt::Row::at_most(&pieces);
            let again = cga_rt::Pattern { items: PATTERN, sizes: &SIZES, extent };
            let made = cga_rt::Made::new(cx.env, shape, #axis, cga_rt::Adjust::#adjust, at_most, again)?;
            let mut division =
                cga_rt::Division::new(shape, &made, #axis, cga_rt::Adjust::#adjust, #number, #total);
            let mut row = pieces.cursor();
            #(#statements)*
            division.end(#axis);
            division.has_parts()
        } }
    }

    /// Runs a rule on a part that repeats; of type `Flow`.
    fn repeat(&self, root: &TemplateRoot, target: &Target, axis: &TokenStream, last: &Ident) -> TokenStream {
        let Target::Rule { sites, args, span, .. } = target else { return TokenStream::new() };
        self.at(*span, || {
            let name = self.rule(root.rule, self.source.token(span.first));
            let number = Literal::u32_unsuffixed(self.template_places(sites.len().max(1) as u32));
            let hand_on = self.hand_on(root.rule);
            // A template for each site of the caller.
            let number = if sites.len() <= 1 { code!(#number) } else { code!(#number + site) };
            let names: Vec<Ident> = (0..args.len()).map(|number| local("a", number)).collect();
            let values = args.iter().map(|arg| self.borrowed(arg, &Access::part()));
            let passed = names.iter().zip(args).map(|(name, arg)| match arg.ty {
                Type::Float | Type::Bool => quote!(#name),
                _ => code!(::core::clone::Clone::clone(#name)),
            });
            let passed: Vec<TokenStream> = site::passed(sites).into_iter().chain(passed).collect();
            let (reads, TemplateNeeds { whole, axes }) = (self.reads(root, args, &names), root.needs);
            code! { {
                #(let #names = #values;)*
                #hand_on
                cx.repeat(
                    cga_rt::RepeatedSlot { place: #number, is_whole: #whole, reads_axes: #axes, reads: &[#(#reads),*] },
                    &mut #last,
                    g,
                    (part, #axis),
                    &mut |cx, part| CgaRules::#name(g, cx, part, #(#passed),*),
                    CgaRules::cga_resume,
                )
            } }
        })
    }

    /// The values that a repeated part reads. Arguments that are constants are the same each time.
    fn reads(&self, root: &TemplateRoot, args: &[Expr], names: &[Ident]) -> Vec<TokenStream> {
        let read = |ty: Type, value: TokenStream| {
            let variant = types::variant(ty);
            code!(cga_rt::Read::#variant(#value))
        };
        let args = args.iter().zip(names).filter(|(arg, _)| !matches!(arg.kind, ExprKind::Value(_)));
        let args = args.map(|(arg, name)| read(arg.ty, quote!(#name)));
        let globals = root.reads.iter().map(|id| {
            let ty = self.grammar.global(*id).ty;
            let value = self.global(*id, &Access::part());
            read(ty, if matches!(ty, Type::Float | Type::Bool) { value } else { code!(&#value) })
        });
        let run = root.is_of_run.then(|| code!(cga_rt::Read::Run(cx.env.run)));
        args.chain(globals).chain(run).collect()
    }

    /// The first number of `count` more places with a template, in the order in which they are written.
    fn template_places(&self, count: u32) -> u32 {
        let place = self.places.get();
        self.places.set(place + count);
        place
    }

    /// The sizes.
    pub(super) fn sizes(&self, slots: &Slots) -> impl Iterator<Item = TokenStream> {
        let at = Access::rule();
        slots.sizes.iter().map(move |size| prefixed(size.prefix, &self.expr(&size.value, &at)))
    }
}

/// A size as the solver takes it.
pub(super) fn prefixed(prefix: Prefix, value: &TokenStream) -> TokenStream {
    match prefix {
        Prefix::Absolute => code!(cga_rt::Size::absolute(#value)),
        Prefix::Relative => code!(cga_rt::Size::relative(#value)),
        Prefix::Floating => code!(cga_rt::Size::floating(#value)),
    }
}

/// Slots and groups as the solver takes them.
pub(super) fn items(pattern: &[Item]) -> impl Iterator<Item = TokenStream> {
    pattern.iter().map(move |item| match item {
        Item::Slot => code!(cga_rt::Item::Slot),
        Item::Repeat(len) => {
            let len = Literal::u32_unsuffixed(*len);
            code!(cga_rt::Item::Repeat(#len))
        }
    })
}

/// The pieces of a split that is solved.
fn pieces(solved: &Solved) -> impl Iterator<Item = TokenStream> {
    solved.pieces.iter().map(|piece| {
        let Piece { slot, start, end, length } = *piece;
        let slot = Literal::u32_unsuffixed(slot);
        let [start, end, length] = [start, end, length].map(Literal::f64_unsuffixed);
        code!(cga_rt::Piece { slot: #slot, start: #start, end: #end, length: #length })
    })
}
