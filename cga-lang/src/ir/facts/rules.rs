//! Uses of rules, and which of them are rigid.

use super::closure::closure;
use super::{Facts, Reads, RuleFacts, TemplateNeeds, Uses};
use crate::ir::{Arg, Arm, Block, BlockParts, Grammar, Renewal, Rule, Selector, Step, StepKind, Target, walk};
use crate::ops;

/// The facts of a rule without the rules that it reaches.
struct OwnFacts {
    uses: Uses,
    /// True if it is rigid, apart from the counters that it gets with its shape.
    rigid: bool,
    /// The same for a template.
    template: Option<TemplateNeeds>,
    reads: Reads,
    is_even: bool,
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
                own_template: own.template.filter(|_| uses.counters().is_none()),
                own_reads: own.reads,
                is_even: own.is_even,
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
        let (rigid, template) = (locals.but(Uses::COUNTERS).is_rigid(), needs(locals));
        let mut own = OwnFacts { uses: locals, rigid, template, reads, is_even: is_fixed(locals) };
        walk::steps(&rule.body, &mut |step| {
            let args = walk::targets(step).into_iter().map(|target| match target {
                Target::Rule { args, .. } => self.exprs(args),
                Target::Leaf(..) | Target::Nil => Uses::NONE,
            });
            let args: Uses = args.collect();
            let args = if hands_counters_on(step) { args } else { args.but(Uses::COUNTERS) };
            let (exprs, itself) = (self.exprs(walk::in_step(step)) | args, itself(step, renewals));
            own.uses = own.uses | exprs | itself;
            let seen = match &step.kind {
                StepKind::Block(block @ Block { parts: BlockParts::Arms(arms), .. }) => selected(block, arms),
                _ => itself,
            };
            own.is_even &=
                matches!(step.kind, StepKind::Case { .. }) || is_fixed(self.exprs(walk::in_step(step)) | seen);
            let seen = exprs | seen;
            own.rigid &= seen.but(Uses::COUNTERS).is_rigid();
            own.template = own.template.zip(needs(seen)).map(|(own, more)| own | more);
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
        // The object is another one in each run.
        StepKind::Do(row, args) if row.uses.has(Uses::AXES) && args.iter().any(is_of_object) => Uses::ALL,
        StepKind::Do(row, ..) => row.uses,
        StepKind::SetShape(row, ..) => row.set_uses,
        StepKind::Rust(..) => Uses::ALL,
        StepKind::Block(block) => block.row.uses,
        StepKind::Renew(call) => renewals[call.renewal.0 as usize],
        StepKind::SetAttr(..) | StepKind::Give(_) | StepKind::Push(_) | StepKind::Case { .. } => Uses::NONE,
    }
}

/// Returns true for a word of the axes of the object.
fn is_of_object(arg: &Arg) -> bool {
    matches!(arg, Arg::Word(word) if word.starts_with("object"))
}

/// Returns true if the shapes that a step makes keep `split.index` and `split.total`.
fn hands_counters_on(step: &Step) -> bool {
    !matches!(step.kind, StepKind::Block(Block { parts: BlockParts::Slots(_), .. }))
}

/// Uses of an operation with arms, besides the geometry and the axes of the scope. `noAlign` gives parts the axes of the pivot, and a
/// condition asks about a whole shape.
fn selected(block: &Block, arms: &[Arm<Target>]) -> Uses {
    if !block.is_plain() || block.row.uses.has(Uses::PLACE) {
        return Uses::ALL;
    }
    let arms = arms.iter().map(|arm| match &arm.selector {
        Selector::Word(word) => ops::selector(word).map_or(Uses::ALL, |row| row.uses),
        Selector::Index(_) => Uses::NONE,
        Selector::When(_) => Uses::ALL,
    });
    let itself = if block.gives_faces() { Uses::NONE } else { Uses::BODY };
    itself | arms.collect()
}

/// The needs of a template whose steps have those uses. `None` if there can be no template.
fn needs(uses: Uses) -> Option<TemplateNeeds> {
    let is_template = is_fixed(uses.but(Uses::COUNTERS));
    is_template.then(|| TemplateNeeds { whole: uses.has(Uses::BODY), axes: uses.has(Uses::AXES) })
}

/// Returns true for uses with the same result at all places with the same axes.
fn is_fixed(uses: Uses) -> bool {
    uses.but(Uses::AXES).is_rigid()
}
