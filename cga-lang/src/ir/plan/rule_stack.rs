//! The calls of rules that request stack, and how much.
//!
//! Rules call each other directly. A call that could nest too deep requests stack from the runtime first, and waits on a list if the
//! stack is used up:
//!
//! - a call inside a cycle of rules always requests the callee's own share;
//! - a chain of rules without a cycle requests stack once it may have grown by [`UNREQUESTED`] since the last request.
//!
//! Short chains, and so nearly all rules, are plain calls. Invariant: when a rule runs, the stack in
//! use is at most the requested stack plus the rule's *reach*, the longest way to it from the last request.

use super::frame;
use crate::graph::components;
use crate::ir::walk::calls;
use crate::ir::{Grammar, RuleId};
use std::collections::HashMap;

/// Kilobytes that a chain of calls may take without a request.
const UNREQUESTED: u32 = 256;

/// The request before a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StackRequest {
    /// 1 for a call inside a cycle: it counts for the limit of depth.
    pub levels: u32,
    /// The share of the stack of the run that the call takes, in kilobytes.
    pub stack: u32,
}

/// The calls that request stack.
#[derive(Clone, Debug, Default)]
pub struct RuleStack {
    requests: HashMap<(RuleId, RuleId), StackRequest>,
    may_wait: Vec<bool>,
}

impl RuleStack {
    /// Finds the calls, in time linear in the size of the grammar.
    pub(super) fn new(grammar: &Grammar) -> Self {
        let rules = &grammar.rules;
        let calls = calls(grammar, |_| true);
        let own: Vec<u32> = rules.iter().map(frame::rule).collect();
        let mut plan = RuleStack { requests: HashMap::new(), may_wait: vec![false; rules.len()] };
        // The rules of a cycle have one reach.
        let mut reach: Vec<u32> = own.clone();
        // Every group after all that call it.
        for group in components(&calls).into_iter().rev() {
            let most = group.iter().map(|&rule| reach[rule]).max().unwrap_or(0);
            group.iter().for_each(|&rule| reach[rule] = most);
            for from in group {
                for &to in &calls[from] {
                    let share = own[to];
                    let cycle = rules[from].cycle;
                    if cycle.is_some() && cycle == rules[to].cycle {
                        let levels = u32::from(!rules[to].block);
                        plan.add(from, to, StackRequest { levels, stack: share });
                    } else if UNREQUESTED < most + share {
                        plan.add(from, to, StackRequest { levels: 0, stack: most });
                    } else {
                        let other = &mut reach[to];
                        *other = (*other).max(most + share);
                    }
                }
            }
        }
        plan
    }

    fn add(&mut self, from: usize, to: usize, request: StackRequest) {
        self.requests.insert((RuleId(from as u32), RuleId(to as u32)), request);
        self.may_wait[to] = true;
    }

    /// The request before a call; `None` for a direct one.
    pub fn request(&self, from: RuleId, to: RuleId) -> Option<StackRequest> {
        self.requests.get(&(from, to)).copied()
    }

    /// Returns true if a call of the rule may have to wait.
    pub(super) fn may_wait(&self, rule: RuleId) -> bool {
        self.may_wait[rule.0 as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    /// The calls with a request, as `caller → callee: levels, stack`.
    fn requests(rules: &str) -> Vec<String> {
        let grammar = compile_text(rules).compiled.grammar.expect("good rules");
        let plan = RuleStack::new(&grammar);
        let name = |rule: &RuleId| grammar.rules[rule.0 as usize].name.clone();
        let line = |((from, to), request): (&(RuleId, RuleId), &StackRequest)| {
            format!("{} → {}: {}, {}", name(from), name(to), request.levels, request.stack)
        };
        let mut list: Vec<String> = plan.requests.iter().map(line).collect();
        list.sort();
        list
    }

    #[test]
    fn short_chains_are_direct() {
        assert!(requests("A --> split(x) { 1 : B } B --> C C --> s(1, 1, 1)").is_empty());
    }

    #[test]
    fn calls_inside_a_cycle_request_stack() {
        assert_eq!(
            requests("A --> case scope.sx > 1 : B else : D B --> s('0.5, '1, '1) A D --> X"),
            ["A → B: 1, 3", "B → A: 1, 3"]
        );
    }

    #[test]
    fn a_long_chain_requests_stack_now_and_then() {
        let chain: String = (0..2000).map(|at| format!("A{at} --> A{}\n", at + 1)).collect();
        let list = requests(&(chain + "A2000 --> s(1, 1, 1)"));
        let expected = 2000 * 2 / UNREQUESTED as usize;
        assert!((expected - 1..=expected + 1).contains(&list.len()), "{}", list.len());
    }

    #[test]
    fn a_chain_of_cycles_requests_stack_outside_of_cycles_too() {
        let rule = |at: usize| format!("A{at} --> case scope.sx > {at} : A{at} else : A{}\n", at + 1);
        let chain: String = (0..1000).map(rule).collect();
        let list = requests(&(chain + "A1000 --> s(1, 1, 1)"));
        assert!(1000 + 3 * 1000 / UNREQUESTED as usize <= list.len() + 1, "{}", list.len());
    }
}
