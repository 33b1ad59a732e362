//! Steps without effect: without them the leaves are the same.

use crate::played::judge::Verdict;
use crate::played::run::{derive, prepare};
use crate::random::Random;
use cga::glam::DAffine3;
use cga::{Flow, Grammar, Leaf, Mesh, Sink};
use std::ops::ControlFlow;
use std::sync::Arc;

/// All there is to say of leaves.
#[derive(Default)]
struct Leaves(Vec<String>);

impl Sink for Leaves {
    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        // Both rules may be leaves themselves.
        let rule = if leaf.rule == "Bare" { "Tail" } else { leaf.rule };
        self.0.push(format!("{rule} {:?} {:?} {mesh:?} {placement:?}", leaf.scope(), leaf.material));
        ControlFlow::Continue(())
    }
}

/// Judges by a run of the rule `Tail`, and one of `Bare`, which is without such steps.
pub(crate) fn judge(make: fn() -> Box<dyn Grammar>, random: &mut Random, usual: bool) -> (String, Verdict) {
    let mut grammar = make();
    let (given, shape) = prepare(&mut *grammar, random, usual);
    let leaves = |start: &str| {
        let mut leaves = Leaves::default();
        derive(&*grammar, start, &shape, &mut leaves).expect("no limit");
        leaves.0
    };
    let verdict = match (leaves("Tail"), leaves("Bare")) {
        (tail, bare) if tail != bare => Verdict::Broken("leaves differ".into()),
        (tail, _) if tail.is_empty() => Verdict::Silent,
        _ => Verdict::So,
    };
    (given, verdict)
}
