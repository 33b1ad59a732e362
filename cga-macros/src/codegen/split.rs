//! A split: its pattern and the known sizes as constants, then a statement a slot and a loop a group.

use cga_lang::ir::{self, Axis, Block, ExprKind, Item, Piece, Prefix, RuleId, Size, Solved, Target, Value};
use cga_lang::ops::{Braces, Measure};
use proc_macro2::{Ident, Literal, TokenStream};

use super::access::Access;
use super::{Generator, hygienic, local, site, templates};

/// A split with what its slots have in common.
struct SplitContext<'s> {
    slots: &'s ir::Slots,
    rule: RuleId,
    axis: TokenStream,
    /// True if the pieces are a list, false if they are laid out one by one.
    is_list: bool,
    /// True if the split is laid out in the rule.
    in_place: bool,
}

impl SplitContext<'_> {
    /// The runtime's function of that name: one that becomes part of the rule, else the one that is compiled once.
    fn function(&self, name: &str) -> Ident {
        if self.in_place { hygienic(name) } else { hygienic(&format!("any_{name}")) }
    }
}

/// The position of the next item of a pattern: the numbers of slots and groups before it.
#[derive(Clone, Copy, Default)]
struct At {
    slot: usize,
    group: usize,
}

impl Generator<'_> {
    /// Statements that divide the shape; whether they have done so is `division.has_parts()`. `number` counts the children that
    /// the rule makes.
    pub(super) fn split(&self, block: &Block, slots: &ir::Slots, rule: RuleId, number: u32) -> TokenStream {
        let Braces::Slots(measure) = block.row.braces else { return TokenStream::new() };
        // Parts in texture space do not come along an axis, and their scopes are found with them.
        let axis = match block.axis() {
            Some(Axis::X) | None => code!(cga_rt::Axis::X),
            Some(Axis::Y) => code!(cga_rt::Axis::Y),
            Some(Axis::Z) => code!(cga_rt::Axis::Z),
        };
        let adjusts = block.adjusts() && measure != Measure::Texture;
        let adjust = if adjusts { code!(Adjust) } else { code!(NoAdjust) };
        // A list cannot tell the repetitions of a group from those of a group around it.
        let solved = slots.solved.as_ref().filter(|_| !has_nested_groups(&slots.pattern));
        let in_place = self.is_in_place(slots, rule);
        let is_list = solved.is_some() || measure != Measure::Length;
        let row = if is_list { code!(cga_rt::List::new(pieces)) } else { code!(pieces.cursor()) };
        let pieces = match (solved, measure) {
            (Some(solved), _) => known(solved, &axis),
            (None, Measure::Area) => self.areas(slots, &axis),
            (None, Measure::Length) => self.lengths(slots, &axis, in_place),
            (None, Measure::Texture) => self.textures(block, slots),
        };
        let is_counted = slots.targets.iter().any(|target| self.facts.target(target).total);
        let total = if is_counted { code!(cga_rt::Row::total(&pieces)) } else { code!(0) };
        let slots = SplitContext { slots, rule, axis, is_list, in_place };
        let statements = self.items(&slots, &slots.slots.pattern, At::default(), false);
        let (axis, number) = (&slots.axis, Literal::u32_unsuffixed(number));
        let (new, end) = (hygienic(if in_place { "new" } else { "any" }), slots.function("end"));
        let made = match measure {
            Measure::Texture => TokenStream::new(),
            _ if in_place => {
                let again = match is_list {
                    true => code!(pieces),
                    false => code!(cga_rt::Pattern { items: PATTERN, sizes: &SIZES, extent }),
                };
                code! {
                    let at_most = cga_rt::Row::at_most(&pieces);
                    let made = cga_rt::Made::new(cx.env, shape, #axis, cga_rt::Adjust::#adjust, at_most, #again)?;
                }
            }
            _ => code! {
                let made = cga_rt::Made::any(cx.env, shape, #axis, cga_rt::Adjust::#adjust, pieces)?;
            },
        };
        code! {
            #pieces
            #made
            let mut division =
                cga_rt::Division::#new(shape, &made, #axis, cga_rt::Adjust::#adjust, #number, #total);
            let mut row = #row;
            #statements
            division.#end(#axis);
        }
    }

    /// The statements of a part of the pattern.
    fn items(&self, slots: &SplitContext<'_>, pattern: &[Item], mut at: At, in_group: bool) -> TokenStream {
        let mut code = TokenStream::new();
        let mut rest = pattern;
        while let Some((item, behind)) = rest.split_first() {
            rest = behind;
            match item {
                Item::Slot => {
                    code.extend(self.slot(slots, at.slot, in_group));
                    at.slot += 1;
                }
                Item::Repeat(len) => {
                    let (inside, behind) = rest.split_at((*len as usize).min(rest.len()));
                    rest = behind;
                    let count = inside.iter().filter(|item| matches!(item, Item::Slot)).count();
                    let group = local("group", at.group);
                    let [open, turn] = ["open", "turn"].map(|name| slots.function(name));
                    let opened = if slots.is_list {
                        let [from, to] = [at.slot, at.slot + count].map(|slot| Literal::u32_unsuffixed(slot as u32));
                        code!(row.#open(#from..#to))
                    } else {
                        let number = Literal::usize_unsuffixed(at.group);
                        code!(row.#open(pieces, #number))
                    };
                    let items = self.items(slots, inside, At { group: at.group + 1, ..at }, true);
                    // An inner group declares those of its own slots.
                    let repeated =
                        own_slots(inside).map(|slot| at.slot + slot).filter(|slot| self.root(slots, *slot).is_some());
                    let last = repeated.map(|slot| local("last", slot));
                    code.extend(code! {
                        #(let mut #last = ::core::default::Default::default();)*
                        let mut #group = #opened;
                        while row.#turn(&mut #group) {
                            division.turn(cx.env)?;
                            #items
                        }
                    });
                    at = At { slot: at.slot + count, group: at.group + 1 + inside.len() - count };
                }
            }
        }
        code
    }

    /// The statement of a slot.
    fn slot(&self, slots: &SplitContext<'_>, slot: usize, in_group: bool) -> TokenStream {
        let (axis, [part, leaf, skip]) = (&slots.axis, ["part", "leaf", "skip"].map(|name| slots.function(name)));
        let number = Literal::usize_unsuffixed(slot);
        match &slots.slots.targets[slot] {
            Target::Nil => code!(division.#skip(&mut row, #number);),
            Target::Leaf(name) => {
                let name = self.leaves.number(name);
                code!(division.#leaf(cx, &mut row, #axis, #number, #name)?;)
            }
            target @ Target::Rule { .. } => {
                let code = match self.root(slots, slot).filter(|_| in_group) {
                    Some(rule) => self.repeat(rule, target, slots, slot),
                    None => self.part(target, slots.rule),
                };
                let uses = self.facts.target(target);
                let (draws, counts) = (uses.draws, uses.index || uses.total);
                code! {
                    let slot = cga_rt::Slot { number: #number, in_group: #in_group, draws: #draws, counts: #counts };
                    if let ::core::option::Option::Some(part) = division.#part(&mut row, #axis, slot) {
                        let flow: cga_rt::Flow = #code;
                        flow?;
                    }
                }
            }
        }
    }

    /// Returns true for few slots of constant sizes in a rule that can reach itself: the split is laid out in the rule, and the
    /// compiler folds what it knows. Such rules run most often; of rules that repeat there are templates, and the code of others
    /// would be large for what it gains.
    fn is_in_place(&self, slots: &ir::Slots, rule: RuleId) -> bool {
        let is_constant =
            |size: &Size| matches!(size.value.kind, ExprKind::Value(Value::Float(value)) if value.is_finite());
        self.grammar.rules[rule.0 as usize].cycle.is_some()
            && slots.targets.len() <= 3
            && slots.sizes.iter().all(is_constant)
    }

    /// The rule that is repeated from a template if the slot is in a group.
    fn root(&self, slots: &SplitContext<'_>, slot: usize) -> Option<RuleId> {
        templates::root(&slots.slots.targets[slot], slots.rule, &self.facts, &self.plan)
    }

    /// Runs a rule on a part that repeats; of type `Flow`.
    fn repeat(&self, rule: RuleId, target: &Target, slots: &SplitContext<'_>, slot: usize) -> TokenStream {
        let Target::Rule { sites, span, .. } = target else { return TokenStream::new() };
        let name = self.rule(rule, self.source.token(span.first));
        let number = Literal::u32_unsuffixed(self.templates.places(sites.len().max(1) as u32));
        let (hand_on, axis, last) = (self.hand_on(rule), &slots.axis, local("last", slot));
        if let Some(passed) = site::passed(sites) {
            // A template for each site of the caller.
            let number = if sites.len() == 1 { code!(#number) } else { code!(#number + site) };
            return code! { {
                #hand_on
                cx.repeat(
                    #number,
                    &mut #last,
                    &(g, #passed),
                    (part, #axis),
                    |(g, site), cx, part| CgaRules::#name(g, cx, part, *site),
                    |(g, _), cx, part, call| CgaRules::cga_resume(g, cx, part, call),
                )
            } };
        }
        code! { {
            #hand_on
            cx.repeat(#number, &mut #last, g, (part, #axis), CgaRules::#name, CgaRules::cga_resume)
        } }
    }

    /// The solution of a split along lengths.
    fn lengths(&self, slots: &ir::Slots, axis: &TokenStream, in_place: bool) -> TokenStream {
        let count = slots.sizes.len();
        let (sizes, name) = self.sizes(slots, true);
        let solve = hygienic(if in_place { "solve" } else { "solve_any" });
        code! {
            #sizes
            let mut lengths = [0.0; #count];
            let extent = cga_rt::extent(cx.env, shape, #axis);
            let pieces = &cga_rt::#solve(PATTERN, &#name, &mut lengths, extent);
        }
    }

    /// The pieces of a split along areas.
    fn areas(&self, slots: &ir::Slots, axis: &TokenStream) -> TokenStream {
        let (sizes, name) = self.sizes(slots, false);
        code! {
            #sizes
            let pieces = cga_rt::areas(cx.env, shape, #axis, PATTERN, #name);
            let pieces = pieces.as_slice();
        }
    }

    /// The pieces of a split in texture space, with their shapes.
    fn textures(&self, block: &Block, slots: &ir::Slots) -> TokenStream {
        let (sizes, name) = self.sizes(slots, false);
        let args = self.args(block.row, &block.args, &Access::rule(), &TokenStream::new());
        code! {
            #sizes
            let axis = (#(#args),*);
            let (pieces, made) = cga_rt::texture(cx.env, shape, axis, PATTERN, #name)?;
            let pieces = pieces.as_slice();
        }
    }

    /// The pattern and the sizes, with the name of these.
    fn sizes(&self, slots: &ir::Slots, are_lengths: bool) -> (TokenStream, Ident) {
        let count = slots.sizes.len();
        let items = slots.pattern.iter().map(|item| match item {
            Item::Slot => code!(cga_rt::Item::Slot),
            Item::Repeat(len) => {
                let len = Literal::u32_unsuffixed(*len);
                code!(cga_rt::Item::Repeat(#len))
            }
        });
        let place_of = Access::rule();
        let values = slots.sizes.iter().map(|size| prefixed(size.prefix, &self.expr(&size.value, &place_of)));
        let constant =
            |size: &Size| matches!(size.value.kind, ExprKind::Value(Value::Float(value)) if value.is_finite());
        let is_constant = are_lengths && slots.sizes.iter().all(constant);
        let name = hygienic(if is_constant { "SIZES" } else { "sizes" });
        let sizes = if is_constant {
            code!(const SIZES: [cga_rt::Size; #count] = [#(#values),*];)
        } else if are_lengths {
            code! {
                let sizes: [cga_rt::Size; #count] = [#(#values),*];
                let sizes = cga_rt::sizes(cx.env, sizes);
            }
        } else {
            code!(let sizes: [cga_rt::Size; #count] = [#(#values),*];)
        };
        (code!(const PATTERN: &[cga_rt::Item] = &[#(#items),*]; #sizes), name)
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

/// The pieces of a split that is solved.
fn known(solved: &Solved, axis: &TokenStream) -> TokenStream {
    let extent = Literal::f64_unsuffixed(solved.extent);
    let pieces = solved.pieces.iter().map(|piece| {
        let Piece { slot, start, end, length } = *piece;
        let slot = Literal::u32_unsuffixed(slot);
        let [start, end, length] = [start, end, length].map(Literal::f64_unsuffixed);
        code!(cga_rt::Piece { slot: #slot, start: #start, end: #end, length: #length })
    });
    code! {
        const PIECES: &[cga_rt::Piece] = &[#(#pieces),*];
        let pieces = cga_rt::solved(cx.env, shape, #axis, #extent, PIECES);
    }
}

/// The slots of a pattern that are in none of its groups.
fn own_slots(pattern: &[Item]) -> impl Iterator<Item = usize> {
    let (mut slot, mut group_end) = (0, 0);
    pattern.iter().enumerate().filter_map(move |(at, item)| match item {
        Item::Slot => {
            slot += 1;
            (group_end <= at).then_some(slot - 1)
        }
        Item::Repeat(len) => {
            group_end = group_end.max(at + 1 + *len as usize);
            None
        }
    })
}

/// Returns true if a group is in another one.
fn has_nested_groups(pattern: &[Item]) -> bool {
    pattern.iter().enumerate().any(|(at, item)| match item {
        Item::Repeat(len) => pattern[at + 1..].iter().take(*len as usize).any(|item| matches!(item, Item::Repeat(_))),
        Item::Slot => false,
    })
}
