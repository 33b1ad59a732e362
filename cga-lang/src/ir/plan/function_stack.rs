//! The functions that request stack before they run, and how much.
//!
//! Functions call each other directly while an expression is evaluated, so none of these calls can wait. If a function requests
//! stack and the stack is used up, the run ends with an error. These functions request stack:
//!
//! - a recursive function, for its own share;
//! - a function on a chain that may have grown by [`UNREQUESTED`] since the last request, for the whole growth;
//! - a function that makes very many calls without any recursion (`f(n) = g(n) + g(n)`, and `g` the same, and so on): they are
//!   counted.
//!
//! Invariant: when a function runs, functions use at most the requested stack plus its *reach*, the
//! longest way to it from the last request.

use super::frame;
use crate::graph::components;
use crate::ir::walk;
use crate::ir::{ExprKind, Function, FunctionId};

/// Bytes that a chain of functions may take without a request.
const UNREQUESTED: u32 = 64 * 1024;

/// Calls that a function may make without being counted.
const UNCOUNTED: u64 = 10_000;

/// The number of components for which `comp` is assumed to compute its values.
const COMPONENTS: u64 = 100;

/// The functions that request stack.
#[derive(Clone, Debug, Default)]
pub struct FunctionStack {
    /// By function: the bytes that it requests, if it does.
    requests: Vec<Option<u32>>,
}

impl FunctionStack {
    /// Finds the functions, in time linear in their size.
    pub(super) fn new(functions: &[Function]) -> Self {
        let own: Vec<u32> = functions.iter().map(frame::function).collect();
        let calls: Vec<Vec<usize>> = functions.iter().map(walk::called_functions).collect();
        let groups = components(&calls);
        let mut requests = vec![None; functions.len()];
        // By function: the calls that follow from one call. A counted function is one call. Groups come before their callers.
        let mut made: Vec<u64> = vec![1; functions.len()];
        for group in &groups {
            for &at in group.iter().filter(|&&at| !functions[at].recursive) {
                let sum = calls[at].iter().fold(1, |sum: u64, &to| sum.saturating_add(made[to]));
                made[at] = if divides(&functions[at]) { sum.saturating_mul(COMPONENTS) } else { sum };
                if UNCOUNTED < made[at] {
                    (requests[at], made[at]) = (Some(own[at]), 1);
                }
            }
        }
        // The longest way to a function, without the function itself. Every group after all that call it.
        let mut before: Vec<u32> = vec![0; functions.len()];
        for group in groups.into_iter().rev() {
            let most = group.iter().map(|&at| before[at]).max().unwrap_or(0);
            for &at in &group {
                let with = most.saturating_add(own[at]);
                let reach = if functions[at].recursive {
                    requests[at] = Some(own[at]);
                    most
                } else if requests[at].is_some() || UNREQUESTED < with {
                    requests[at] = Some(with);
                    0
                } else {
                    with
                };
                // Inside a cycle this comes too late for some functions, which have the same reach anyway.
                for &to in &calls[at] {
                    before[to] = before[to].max(reach);
                }
            }
        }
        FunctionStack { requests }
    }

    /// The bytes that a function requests before it runs, if it does.
    pub fn request(&self, function: FunctionId) -> Option<u32> {
        self.requests[function.0 as usize]
    }
}

/// Returns true if it has values for components.
fn divides(function: &Function) -> bool {
    let mut found = false;
    for value in function.locals.iter().chain([&function.body]) {
        walk::parts(value, &mut |expr| found |= matches!(expr.kind, ExprKind::Comp(_)));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    fn requests(rules: &str) -> Vec<Option<u32>> {
        FunctionStack::new(&compile_text(rules).compiled.grammar.expect("good rules").functions).requests
    }

    #[test]
    fn functions_without_recursion_request_nothing() {
        assert_eq!(requests("f(n) = g(n) + g(2 * n)  g(n) = n * scope.sx  A --> t(f(1), 0, 0)"), [None, None]);
    }

    #[test]
    fn recursive_functions_request_their_own_share() {
        let list = requests("f(n) = case n > 0 : g(n - 1) else : 0  g(n) = f(n)  h(n) = f(n)  A --> t(h(1), 0, 0)");
        assert!(matches!(list[..], [Some(..300), Some(..300), None]), "{list:?}");
    }

    #[test]
    fn a_long_chain_requests_stack_now_and_then() {
        let chain: String = (0..3000).map(|at| format!("f{at}(n) = f{}(n) + 1\n", at + 1)).collect();
        let list = requests(&(chain + "f3000(n) = n * scope.sx  A --> t(f0(1), 0, 0)"));
        let own = 144 + 8 + 4 * 8;
        let expected = 3000 * own / UNREQUESTED as usize;
        let count = list.iter().flatten().count();
        assert!((expected - 1..=expected + 1).contains(&count), "{count}");
        assert!(list.iter().flatten().all(|stack| UNREQUESTED < *stack), "{list:?}");
    }

    #[test]
    fn doubling_without_recursion_is_counted() {
        let chain: String = (0..60).map(|at| format!("f{at}(n) = f{0}(n) + f{0}(n)\n", at + 1)).collect();
        let list = requests(&(chain + "f60(n) = n * scope.sx  A --> t(f0(1), 0, 0)"));
        assert_eq!(list.iter().flatten().count(), 60 / 13);
    }

    #[test]
    fn values_for_components_count_as_many_calls() {
        let chain: String = (0..3).map(|at| format!("f{at}(n) = sum(comp(v) {{ all : f{}(n) }})\n", at + 1)).collect();
        let list = requests(&(chain + "f3(n) = n * scope.sx  A --> t(f0(1), 0, 0)"));
        assert_eq!(list.iter().map(Option::is_some).collect::<Vec<_>>(), [false, true, false, false]);
    }

    #[test]
    fn big_functions_request_more() {
        let stack = |text: &str| requests(text)[0].expect("a recursion");
        let small = stack("f(n) = case n > 0 : f(n - 1) else : 0  A --> t(f(1), 0, 0)");
        let locals: String = (0..40).map(|at| format!("v{at} := [n, {at}] ")).collect();
        let big =
            stack(&format!("f(n) with ( {locals}) = case n > 0 : f(n - 1) + v0[0] else : 0  A --> t(f(1), 0, 0)"));
        assert!(40 * 176 < big - small && big - small < 40 * 400, "{small} {big}");
    }
}
