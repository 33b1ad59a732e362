//! Abstract interpretation: the values and shapes that are possible at each point of the rules.
//!
//! A state follows each shape through the steps of a rule and into the rules that are called with it. The state at the start of a
//! rule is the join of its calls; it is unknown for a rule that a run may begin with. States in cycles are widened, so the
//! analysis ends. If the program has an error, calls are unknown and each rule is analysed alone.

mod evaluator;
mod facts;
pub(crate) mod interval;
mod refine;
mod shape;
mod slots;
mod texts;
mod uvs;
mod value;
mod walk;
mod worklist;

use crate::resolve::globals::{Declared, Globals};
use crate::resolve::tables::{Tables, Use};
use crate::syntax::ast::{Body, Op, OpKind};
use crate::syntax::walk::ops;

pub(crate) use evaluator::{Attrs, Evaluator};
pub(crate) use facts::AbstractState;
pub(crate) use shape::{Face, Filling};
pub(crate) use slots::{MARGIN, Once, SizeSum, Slot, Slots};
pub(crate) use uvs::UvSets;
pub(crate) use value::Value;
pub(crate) use walk::{CaseBranch, Site, called};

use std::cell::RefCell;
use walk::{Visit, Walk};
use worklist::Worklist;

/// The number of joins at a rule of a cycle before its state is widened.
const PATIENCE: u32 = 3;

/// The number of joins after which the state is unknown.
const MOST_VISITS: u32 = 12;

/// The states at the starts of the rules.
pub(crate) struct DataFlow<'f> {
    pub(crate) known: &'f Evaluator<'f>,
    /// By rule: the state at its start; `None` without calls so far.
    entries: RefCell<Vec<Option<AbstractState>>>,
    /// By rule: true if another rule calls it.
    called: Vec<bool>,
    /// The components that are not analysed yet.
    worklist: RefCell<Worklist>,
    forgets: bool,
}

/// The calls of a grammar.
pub(crate) struct Calls {
    /// By rule: the rules that it calls, each once, in order.
    pub(crate) edges: Vec<Vec<usize>>,
    /// The rules that a run may begin with.
    pub(crate) starts: Vec<usize>,
}

impl Calls {
    pub(crate) fn new(globals: &Globals, tables: &Tables) -> Calls {
        let edges = globals.rules.iter().map(|item| {
            let names = tables.at(item.own);
            let called = ops(body(item)).filter_map(|op| match &op.kind {
                OpKind::Call(name, _) | OpKind::Dynamic { rule: name, .. } => names.of(name),
                _ => None,
            });
            let rules = called.filter_map(|found| if let Use::Rule(rule) = found { Some(rule as usize) } else { None });
            let mut list: Vec<usize> = rules.collect();
            list.sort_unstable();
            list.dedup();
            list
        });
        let edges = edges.collect();
        let marked = globals.rules.iter().enumerate().filter(|(_, item)| {
            let root = globals.program.roots.contains(&item.instance) && item.home == item.instance;
            root && tables.rules.get(&item.key()).is_some_and(|info| info.marked)
        });
        let mut starts: Vec<usize> = marked.map(|(index, _)| index).collect();
        starts.extend(tables.starts.iter().flatten().map(|rule| *rule as usize));
        starts.sort_unstable();
        starts.dedup();
        Calls { edges, starts }
    }

    /// By rule: the rules that call it, in order.
    pub(crate) fn callers(&self) -> Vec<Vec<usize>> {
        let mut callers = vec![Vec::new(); self.edges.len()];
        for (caller, callees) in self.edges.iter().enumerate() {
            callees.iter().for_each(|&callee| callers[callee].push(caller));
        }
        callers
    }
}

/// By rule: true if one of some rules leads to it along edges, or is it.
pub(crate) fn reach(edges: &[Vec<usize>], mut open: Vec<usize>) -> Vec<bool> {
    let mut reached = vec![false; edges.len()];
    while let Some(rule) = open.pop() {
        if !std::mem::replace(&mut reached[rule], true) {
            open.extend(&edges[rule]);
        }
    }
    reached
}

/// The steps of a rule.
pub(crate) fn body<'a>(item: &Declared<'a>) -> &'a [Op] {
    match &item.decl.body {
        Body::Rule(ops) => ops,
        _ => &[],
    }
}

impl<'f> DataFlow<'f> {
    /// Analyses a rule on its first visit. Without `calls` each rule is analysed alone.
    pub(crate) fn new(globals: &Globals, known: &'f Evaluator<'f>, calls: Option<&Calls>) -> DataFlow<'f> {
        let mut called = vec![false; globals.rules.len()];
        let mut entries = vec![None; globals.rules.len()];
        if let Some(calls) = calls {
            for (caller, callees) in calls.edges.iter().enumerate() {
                callees.iter().filter(|callee| **callee != caller).for_each(|&callee| called[callee] = true);
            }
            // A rule without callers may be called with any shape.
            let uncalled = (0..called.len()).filter(|rule| !called[*rule]);
            for rule in calls.starts.iter().copied().chain(uncalled) {
                entries[rule] = Some(AbstractState::initial(&globals.rules[rule]));
            }
        }
        let worklist = RefCell::new(calls.map(|calls| Worklist::new(&calls.edges)).unwrap_or_default());
        DataFlow { known, entries: RefCell::new(entries), called, worklist, forgets: false }
    }

    /// Considers runs that begin with a shape without height.
    pub(crate) fn of_lots(globals: &Globals, known: &'f Evaluator<'f>, calls: &Calls) -> DataFlow<'f> {
        let flow = DataFlow::new(globals, known, Some(calls));
        for &rule in &calls.starts {
            flow.entries.borrow_mut()[rule] = Some(AbstractState::lot(&globals.rules[rule]));
        }
        flow
    }

    /// Considers values and conditions alone: sizes set by steps count as unknown.
    pub(crate) fn of_values(globals: &Globals, known: &'f Evaluator<'f>) -> DataFlow<'f> {
        DataFlow { forgets: true, ..DataFlow::new(globals, known, None) }
    }

    /// Follows shapes through the rules of a cycle until the states are stable.
    fn settle(&self, globals: &Globals, component: Vec<usize>) {
        let mut visits = vec![0u32; component.len()];
        let mut waits: Vec<bool> = component.iter().map(|rule| self.entries.borrow()[*rule].is_some()).collect();
        let mut work: Vec<usize> = (0..component.len()).rev().filter(|at| waits[*at]).collect();
        while let Some(at) = work.pop() {
            waits[at] = false;
            let rule = component[at];
            let mut handed = Handed { list: Vec::new() };
            self.follow(globals, rule, &mut handed);
            for (callee, facts) in handed.list {
                let before = self.entries.borrow()[callee].clone();
                let mut after = before.as_ref().map_or_else(|| facts.clone(), |before| before.or(&facts));
                if before.as_ref() == Some(&after) {
                    continue;
                }
                if let Ok(at) = component.binary_search(&callee) {
                    if let Some(before) = &before {
                        visits[at] += 1;
                        if PATIENCE < visits[at] {
                            after = after.widen(before);
                        }
                        if MOST_VISITS < visits[at] {
                            after = AbstractState::any(after.own, after.params.len());
                        }
                    }
                    if !std::mem::replace(&mut waits[at], true) {
                        work.push(at);
                    }
                }
                self.entries.borrow_mut()[callee] = Some(after);
            }
        }
    }

    /// Follows a shape once through a rule, from the state at its start.
    fn follow<'a>(&self, globals: &Globals<'a>, rule: usize, visit: &mut dyn Visit<'a>) {
        let item = &globals.rules[rule];
        let entry = self.entries.borrow()[rule].clone();
        let mut facts = entry.unwrap_or_else(|| AbstractState::any(item.own, item.decl.params.len()));
        for (_, local) in &item.decl.locals {
            visit.meet(&Site::Value(local), &facts);
            let value = self.known.value(local, &facts);
            facts.params.push(value);
        }
        let walk = Walk { known: self.known, forgets: self.forgets };
        walk.steps(body(item), facts, visit);
    }

    /// Returns true if another rule calls it.
    pub(crate) fn is_called(&self, rule: usize) -> bool {
        self.called[rule]
    }

    /// Calls `meet` for each site on the way through a rule.
    pub(crate) fn visit<'a>(
        &self,
        globals: &Globals<'a>,
        rule: usize,
        meet: &mut dyn FnMut(&Site<'_, 'a>, &AbstractState),
    ) {
        let waiting = self.worklist.borrow_mut().take(rule);
        waiting.into_iter().for_each(|component| self.settle(globals, component));
        self.follow(globals, rule, &mut Met(meet));
    }

    /// The abstract value of an expression.
    pub(crate) fn value(&self, expr: &crate::syntax::ast::Expr, facts: &AbstractState) -> Value {
        self.known.value(expr, facts)
    }
}

/// Collects the calls of a rule, with their states.
struct Handed {
    list: Vec<(usize, AbstractState)>,
}

impl Visit<'_> for Handed {
    fn hand_on(&mut self, rule: u32, facts: AbstractState) {
        self.list.push((rule as usize, facts));
    }

    fn meet(&mut self, _: &Site<'_, '_>, _: &AbstractState) {}
}

/// Passes sites on to a closure.
struct Met<'m, 'a>(&'m mut dyn FnMut(&Site<'_, 'a>, &AbstractState));

impl<'a> Visit<'a> for Met<'_, 'a> {
    fn hand_on(&mut self, _: u32, _: AbstractState) {}

    fn meet(&mut self, site: &Site<'_, 'a>, facts: &AbstractState) {
        (self.0)(site, facts);
    }
}
