//! The order in which shapes are followed through rules: callers first, and only those that lead to a rule of interest.

use crate::graph::components;
use std::collections::BTreeMap;

/// Rules that no shape was followed through yet.
#[derive(Default)]
pub(super) struct Worklist {
    /// Components of the calls, callers first. `None`: done.
    components: Vec<Option<Vec<usize>>>,
    /// By rule: the number of its component.
    numbers: Vec<usize>,
    /// By rule: the rules that call it.
    callers: Vec<Vec<usize>>,
}

impl Worklist {
    pub(super) fn new(edges: &[Vec<usize>]) -> Worklist {
        let components: Vec<Vec<usize>> = components(edges).into_iter().rev().collect();
        let (mut numbers, mut callers) = (vec![0; edges.len()], vec![Vec::new(); edges.len()]);
        for (number, component) in components.iter().enumerate() {
            component.iter().for_each(|&rule| numbers[rule] = number);
        }
        for (caller, callees) in edges.iter().enumerate() {
            callees.iter().for_each(|&callee| callers[callee].push(caller));
        }
        Worklist { components: components.into_iter().map(Some).collect(), numbers, callers }
    }

    /// Takes the component of a rule, after those that lead to it.
    pub(super) fn take(&mut self, rule: usize) -> Vec<Vec<usize>> {
        let (mut found, mut open) = (BTreeMap::new(), vec![rule]);
        while let Some(rule) = open.pop() {
            let Some(&number) = self.numbers.get(rule) else { continue };
            if let Some(component) = self.components[number].take() {
                open.extend(component.iter().flat_map(|rule| &self.callers[*rule]));
                found.insert(number, component);
            }
        }
        found.into_values().collect()
    }
}
