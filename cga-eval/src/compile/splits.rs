//! Splits.

use cga_lang::ir::plan::{PartNeeds, SplitForm, TemplateRoot};
use cga_lang::ir::{Arg, Block, Expr, ExprKind, Prefix, Slots, Target, Value};
use cga_lang::ops::{Braces, Measure};
use cga_runtime::rt::{self, Adjust, Successor};

use super::expr::{Compiler, Steps};
use super::rules::InRule;
use crate::dispatch::{self, SizeKind};
use crate::steps::{SlotsCode, SplitKind, SplitStep, TargetCode, TemplateCode};

impl Compiler<'_> {
    /// A split. `number` counts the children that the rule makes.
    pub(super) fn split(&self, block: &Block, slots: &Slots, at: InRule<'_>, number: u32) -> Option<SplitStep> {
        let Braces::Slots(measure) = block.row.braces else { return None };
        let word = |number: usize| match block.args.get(number) {
            Some(Arg::Word(word)) => Some(*word),
            _ => None,
        };
        // Parts in texture space do not come along an axis, and their scopes are found with them.
        let (axis, adjust) = match measure {
            Measure::Texture => (rt::Axis::X, Adjust::NoAdjust),
            Measure::Length | Measure::Area => (dispatch::rt_axis(word(0)?)?, dispatch::rt_adjust(word(1)?)?),
        };
        let form = match (self.plan.split_form(block, at.id), measure) {
            (SplitForm::Solved(solved), _) => SplitKind::Solved(solved.extent, solved.pieces.clone().into()),
            (_, Measure::Texture) => {
                let (axis, space) = (dispatch::rt_uv_axis(word(0)?)?, dispatch::rt_texture_space(word(1)?)?);
                SplitKind::Texture(axis, space, self.args(block.row.params, &block.args, at.locals))
            }
            (_, Measure::Area) => SplitKind::Area,
            (_, Measure::Length) => SplitKind::Length,
        };
        let templates: Vec<Option<TemplateCode>> = slots
            .targets
            .iter()
            .zip(self.plan.templates(slots, at.id))
            .map(|(target, root)| Some(self.template(&root?, target)))
            .collect();
        let has_templates = templates.iter().any(Option::is_some);
        Some(SplitStep {
            slots: self.slots(slots, at),
            axis,
            adjust,
            number,
            successors: slots.targets.iter().map(|target| self.successor(target, at)).collect(),
            has_total: self.plan.needs_total(slots),
            form,
            templates: if has_templates { templates.into() } else { Box::default() },
        })
    }

    /// Slots with their sizes.
    pub(super) fn slots(&self, slots: &Slots, at: InRule<'_>) -> SlotsCode {
        let prefixes: Box<[Prefix]> = slots.sizes.iter().map(|size| size.prefix).collect();
        let known: Option<Vec<rt::Size>> = slots
            .sizes
            .iter()
            .map(|size| match size.value.kind {
                ExprKind::Value(Value::Float(value)) => Some(SizeKind(size.prefix).of(value)),
                _ => None,
            })
            .collect();
        SlotsCode {
            pattern: slots.pattern.clone().into(),
            prefixes,
            values: self.code(slots.sizes.iter().map(|size| &size.value), at.locals),
            known: known.map(Into::into),
            targets: slots.targets.iter().map(|target| self.target(target, at)).collect(),
        }
    }

    /// The successor of a slot, as the runtime knows it.
    fn successor(&self, target: &Target, at: InRule<'_>) -> Successor {
        match self.target(target, at) {
            TargetCode::Vanish => Successor::Rule { draws: false, counts: false },
            TargetCode::Nil => Successor::Nil,
            TargetCode::Leaf(name) => Successor::Leaf(name),
            TargetCode::Rule(_) => {
                let PartNeeds { draws, counts } = self.plan.part_needs(target);
                Successor::Rule { draws, counts }
            }
        }
    }

    /// The template of a part that repeats.
    fn template(&self, root: &TemplateRoot, target: &Target) -> TemplateCode {
        let (sites, args): (usize, &[Expr]) = match target {
            Target::Rule { sites, args, .. } => (sites.len(), args),
            Target::Leaf(_) | Target::Nil => (0, &[]),
        };
        let place = self.places.get();
        // A template for each site of the caller.
        self.places.set(place + sites.max(1) as u32);
        let mut globals = Steps::default();
        root.reads.iter().for_each(|id| self.global(*id, &mut globals));
        TemplateCode {
            place,
            is_whole: root.needs.whole,
            reads_axes: root.needs.axes,
            args: args.iter().map(|arg| (arg.ty, !matches!(arg.kind, ExprKind::Value(_)))).collect(),
            globals: globals.finish(),
            global_types: root.reads.iter().map(|id| self.grammar.global(*id).ty).collect(),
            is_of_run: root.is_of_run,
        }
    }
}
