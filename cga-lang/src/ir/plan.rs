//! Decisions on how rules run, which all back ends share.
//!
//! They follow from the IR alone:
//!
//! - the calls that request stack, and how much ([`RuleStack`], [`FunctionStack`], [`RunPlan::lazy_stack`]),
//! - the repeated parts that are templates ([`RunPlan::templates`]), and the calls that are holes in them ([`TemplateHoles`]),
//! - the splits whose pieces are known, that are laid out in their rule, or that the runtime goes through ([`SplitForm`]),
//! - the parts that need a seed or counters ([`PartNeeds`], [`RunPlan::reseeds`]),
//! - the steps and expressions that work on the slim shape, and the material changes that are made once ([`ChangeForm`],
//!   [`RunPlan::needs_whole`]),
//! - the numbers of leaves and of rules ([`LeafNames`], [`TrailNumbers`]),
//! - the rules in which `NIL` moves its neighbours, because their leaves are recomposed ([`RunPlan::vanishes`]).
//!
//! A call that gets no stack runs later, so the order of leaves depends on the requests. A template gives positions with other
//! rounding than a call. So two back ends give the same bytes only if they take the same decisions.
//!
//! ```
//! use cga_lang::compile::compile_text;
//! use cga_lang::ir::plan::RunPlan;
//! use cga_lang::ir::RuleId;
//!
//! let source = compile_text("Lot --> case scope.sx > 1 : s('0.5, '1, '1) Lot else : Tip  Tip --> X.");
//! let grammar = source.compiled.grammar.unwrap();
//! let plan = RunPlan::new(&grammar);
//! let (lot, tip) = (RuleId(0), RuleId(1));
//! assert!(plan.rule_stack.request(lot, lot).is_some() && plan.rule_stack.request(lot, tip).is_none());
//! ```

mod changes;
mod children;
mod frame;
mod function_stack;
mod leaves;
mod recomposition;
mod rule_stack;
mod splits;
mod templates;
mod trails;

use crate::ir::facts::{Facts, LeftShapes, Queries};
use crate::ir::{GlobalId, Grammar, RuleId, Slots, Target};
use crate::ops::Uses;
use std::collections::HashSet;

pub use changes::{ChangeForm, MaterialChange, SlimChange, reads_first_scope};
pub use function_stack::FunctionStack;
pub use leaves::LeafNames;
pub use rule_stack::{RuleStack, StackRequest};
pub use splits::{PartNeeds, SplitForm};
pub use templates::{TemplateHoles, TemplateRoot};
pub use trails::TrailNumbers;

/// The decisions for a grammar.
#[derive(Clone, Debug)]
pub struct RunPlan<'g> {
    grammar: &'g Grammar,
    /// The facts on which decisions depend.
    pub facts: Facts,
    /// The calls of rules that request stack.
    pub rule_stack: RuleStack,
    /// The functions that request stack.
    pub function_stack: FunctionStack,
    /// The calls that templates leave out.
    pub holes: TemplateHoles,
    /// The names of leaves by number.
    pub leaves: LeafNames,
    /// The numbers of rules in trails.
    pub trails: TrailNumbers,
    recomposed: HashSet<RuleId>,
}

impl<'g> RunPlan<'g> {
    /// Finds the facts of a grammar and decides how it runs, in time linear in its size.
    pub fn new(grammar: &'g Grammar) -> Self {
        let (facts, rule_stack) = (Facts::new(grammar), RuleStack::new(grammar));
        let holes = TemplateHoles::new(grammar, &facts, &rule_stack);
        RunPlan {
            grammar,
            facts,
            rule_stack,
            function_stack: FunctionStack::new(&grammar.functions),
            holes,
            leaves: LeafNames::new(grammar),
            trails: TrailNumbers::new(grammar),
            recomposed: recomposition::recomposed(grammar),
        }
    }

    /// The bytes that the first read of a lazy attribute or constant requests.
    pub fn lazy_stack(&self, id: GlobalId) -> u32 {
        frame::lazy(&self.grammar.global(id).value)
    }

    /// By slot of a split of the rule `from`, the template that is made.
    pub fn templates(&self, slots: &Slots, from: RuleId) -> Vec<Option<TemplateRoot>> {
        self.holes.roots(slots, from, &self.facts, &self.rule_stack).collect()
    }

    /// Returns true if a call of the rule may run later: it waits for stack, or a template leaves it out.
    pub fn may_run_later(&self, rule: RuleId) -> bool {
        self.rule_stack.may_wait(rule) || self.holes.may_be_left_out(rule)
    }

    /// Returns true if a rule, an attribute or a constant reads or sets tags. Otherwise operations do not tag the edges that they make.
    pub fn has_tags(&self) -> bool {
        self.facts.all(self.grammar).has(Uses::TAGS)
    }

    /// By start rule, the queries of other shapes that a run from it can reach.
    pub fn start_queries(&self) -> Vec<Queries> {
        Queries::by_start(self.grammar)
    }

    /// By rule, the shapes that it can leave for queries. Empty for a grammar without labels and queries.
    pub fn left_shapes(&self) -> Vec<LeftShapes> {
        let has_any = self.start_queries().iter().any(|queries| *queries != Queries::NONE);
        if has_any { LeftShapes::by_rule(self.grammar) } else { Vec::new() }
    }

    /// Returns true if runs tell when they enter and leave a block: queries of closed shapes of the same initial shape leave out the
    /// shapes above and below a place, and the parts of a split are places of their own.
    pub fn tells_parts(&self) -> bool {
        self.start_queries().iter().any(|queries| queries.has(Queries::INTRA_OCCLUSION))
    }

    /// Returns true for a `NIL` of the rule `from` that moves its neighbours: the shape vanishes from a recomposition.
    pub fn vanishes(&self, target: &Target, from: RuleId) -> bool {
        matches!(target, Target::Nil) && self.recomposed.contains(&from)
    }
}
