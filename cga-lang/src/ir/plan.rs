//! Decisions on how rules run, which all back ends share.
//!
//! They follow from the IR alone, so every back end takes the same ones:
//!
//! - the calls that request stack, and how much ([`RuleStack`], [`FunctionStack`], [`RunPlan::lazy_stack`]). A call that gets no
//!   stack runs later, so the order of leaves depends on this decision.
//!
//! ```
//! use cga_lang::compile::compile_text;
//! use cga_lang::ir::plan::RunPlan;
//! use cga_lang::ir::RuleId;
//!
//! let source = compile_text("Lot --> case scope.sx > 1 : s('0.5, '1, '1) Lot else : Tip  Tip --> X.");
//! let plan = RunPlan::new(&source.compiled.grammar.unwrap());
//! let (lot, tip) = (RuleId(0), RuleId(1));
//! assert!(plan.rule_stack.request(lot, lot).is_some() && plan.rule_stack.request(lot, tip).is_none());
//! ```

mod frame;
mod function_stack;
mod rule_stack;

use crate::ir::facts::Facts;
use crate::ir::{GlobalId, Grammar};

pub use function_stack::FunctionStack;
pub use rule_stack::{RuleStack, StackRequest};

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
}

impl<'g> RunPlan<'g> {
    /// Finds the facts of a grammar and decides how it runs, in time linear in its size.
    pub fn new(grammar: &'g Grammar) -> Self {
        RunPlan {
            grammar,
            facts: Facts::new(grammar),
            rule_stack: RuleStack::new(grammar),
            function_stack: FunctionStack::new(&grammar.functions),
        }
    }

    /// The bytes that the first read of a lazy attribute or constant requests.
    pub fn lazy_stack(&self, id: GlobalId) -> u32 {
        frame::lazy(&self.grammar.global(id).value)
    }
}
