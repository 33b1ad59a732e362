//! Uses of rules, and which of them are rigid.

use super::closure::closure;
use super::{Facts, Reads, RuleFacts, Uses};
use crate::ir::{Arm, Block, BlockParts, Grammar, Renewal, Rule, Selector, Step, StepKind, Target, walk};
use crate::ops;

/// The facts of a rule without the rules that it reaches.
struct OwnFacts {
    uses: Uses,
    /// True if it is rigid, apart from the counters that it gets with its shape.
    rigid: bool,
    /// True if it reads or makes more than rectangles and boxes, if it is rigid.
    whole: bool,
    reads: Reads,
}

impl Facts {
    /// Finds the facts of rules from the facts of functions.
    pub(super) fn find_rules(&mut self, grammar: &Grammar) {
        let renewals: Vec<Uses> = grammar.renewals.iter().map(|renewal| self.renewal(grammar, renewal)).collect();
        let own: Vec<OwnFacts> = grammar.rules.iter().map(|rule| self.own(grammar, rule, &renewals)).collect();
        let uses: Vec<Uses> = own.iter().map(|own| own.uses).collect();
        let edges = walk::calls(grammar, |_| true);
        let handed = walk::calls(grammar, hands_counters_on);

        let all = closure(&edges, &uses);
        let counters = closure(&handed, &uses.iter().map(|uses| uses.counters()).collect::<Vec<_>>());
        let loose = closure(&edges, &own.iter().map(|own| !own.rigid).collect::<Vec<_>>());
        let facts = uses.into_iter().zip(all).zip(counters).zip(loose);
        self.rules = facts
            .zip(&own)
            .map(|((((uses, all), counters), loose), own)| RuleFacts {
                own: uses,
                below: all.but(Uses::COUNTERS) | counters,
                rigid: !loose && counters.is_none(),
                own_rigid: own.rigid && uses.counters().is_none(),
                own_whole: own.whole,
                own_reads: own.reads,
            })
            .collect();
    }

    fn own(&self, grammar: &Grammar, rule: &Rule, renewals: &[Uses]) -> OwnFacts {
        let locals = self.exprs(&rule.locals);
        let mut reads = Reads::NONE;
        walk::in_rule(rule, &mut |part| reads = reads | self.part_reads(part));
        walk::steps(&rule.body, &mut |step| {
            if let StepKind::Renew(call) = &step.kind {
                let renewed = &grammar.renewals[call.renewal.0 as usize].globals;
                reads = reads | renewed.iter().map(|id| self.reads(&grammar.global(*id).value)).collect();
            }
        });
        let rigid = locals.but(Uses::COUNTERS).is_rigid();
        let mut own = OwnFacts { uses: locals, rigid, whole: locals.has(Uses::BODY), reads };
        walk::steps(&rule.body, &mut |step| {
            let args = walk::targets(step).into_iter().map(|target| match target {
                Target::Rule { args, .. } => self.exprs(args),
                Target::Leaf(..) | Target::Nil => Uses::NONE,
            });
            let args: Uses = args.collect();
            let args = if hands_counters_on(step) { args } else { args.but(Uses::COUNTERS) };
            let (exprs, itself) = (self.exprs(walk::in_step(step)) | args, itself(step, renewals));
            own.uses = own.uses | exprs | itself;
            own.rigid &= exprs.but(Uses::COUNTERS).is_rigid();
            let (rigid, whole) = match &step.kind {
                StepKind::Block(block @ Block { parts: BlockParts::Arms(arms), .. }) => {
                    (is_rigid(block, arms), !block.gives_faces())
                }
                _ => (itself.but(Uses::COUNTERS).is_rigid(), itself.has(Uses::BODY)),
            };
            own.rigid &= rigid;
            own.whole |= whole || exprs.has(Uses::BODY);
        });
        own
    }

    /// Uses of a renewal: its attributes and constants are evaluated on the shape.
    fn renewal(&self, grammar: &Grammar, renewal: &Renewal) -> Uses {
        let uses = renewal.globals.iter().map(|id| {
            let global = grammar.global(*id);
            // Lazy ones are computed on a copy of the shape.
            let copied = if global.lazy { Uses::WHOLE | Uses::DRAWS } else { Uses::NONE };
            self.expr(&global.value) | copied
        });
        uses.collect()
    }
}

/// Uses of a step itself, without its expressions and the steps in it.
fn itself(step: &Step, renewals: &[Uses]) -> Uses {
    match &step.kind {
        StepKind::Do(row, ..) => row.uses,
        StepKind::SetShape(row, ..) => row.set_uses,
        StepKind::Rust(..) => Uses::ALL,
        StepKind::Block(block) => block.row.uses,
        StepKind::Renew(call) => renewals[call.renewal.0 as usize],
        StepKind::SetAttr(..) | StepKind::Later(..) | StepKind::Give(_) | StepKind::Push(_) | StepKind::Case { .. } => {
            Uses::NONE
        }
    }
}

/// Returns true if the shapes that a step makes keep `split.index` and `split.total`.
fn hands_counters_on(step: &Step) -> bool {
    !matches!(step.kind, StepKind::Block(Block { parts: BlockParts::Slots(_), .. }))
}

/// Returns true if an operation makes the same parts of a shape wherever the shape is. `noAlign` gives parts the axes of the pivot,
/// and a condition asks about a whole shape.
fn is_rigid(block: &Block, arms: &[Arm<Target>]) -> bool {
    let selects = |arm: &Arm<Target>| match &arm.selector {
        Selector::Word(word) => ops::selector(word).is_some_and(|row| row.rigid),
        Selector::Index(_) => true,
        Selector::When(_) => false,
    };
    block.is_plain() && !block.row.uses.has(Uses::PLACE) && arms.iter().all(selects)
}
