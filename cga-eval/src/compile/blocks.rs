//! Operations with braces, without splits.

use cga_lang::ir::{Arm, Block, Sections, Target};
use cga_lang::ops::Braces;

use super::expr::{Compiler, Steps, components};
use super::rules::InRule;
use crate::dispatch;
use crate::steps::{ArmsKind, ArmsStep, EachStep, OperandsStep, SectionsStep};

impl Compiler<'_> {
    /// A comp, or another operation with arms.
    pub(super) fn divided(&self, block: &Block, arms: &[Arm<Target>], at: InRule<'_>, number: u32) -> Option<ArmsStep> {
        let kind = match block.row.braces {
            Braces::Components => {
                components(&block.args).map(|(components, align)| ArmsKind::Comp(components, align))?
            }
            Braces::Modified => {
                components(&block.args).map(|(components, align)| ArmsKind::CompAndRest(components, align))?
            }
            _ => ArmsKind::Divide(dispatch::arms::call(&block.row.key(), &block.args)?),
        };
        Some(ArmsStep {
            kind,
            args: self.args(block.row.params, &block.args, at.locals),
            arms: self.arms(arms, at.locals),
            targets: arms.iter().map(|arm| self.target(&arm.then, at)).collect(),
            number,
        })
    }

    /// An operation with sections.
    pub(super) fn sections(
        &self,
        block: &Block,
        parts: &Sections,
        at: InRule<'_>,
        number: u32,
    ) -> Option<SectionsStep> {
        let depths = parts.depths.iter().map(|depth| {
            let mut steps = Steps::default();
            self.expr(depth, at.locals, &mut steps);
            steps.finish()
        });
        let depths = depths.collect();
        let mut slots = self.slots(&parts.slots, at);
        let rest = parts.rest.iter().map(|arm| self.target(&arm.then, at));
        slots.targets = slots.targets.into_iter().chain(rest).collect();
        Some(SectionsStep {
            call: dispatch::sections::call(&block.row.key(), &block.args)?,
            args: self.args(block.row.params, &block.args, at.locals),
            slots,
            depths,
            rest: self.arms(&parts.rest, at.locals),
            number,
        })
    }

    /// An operation with the same successor for each part.
    pub(super) fn each(&self, block: &Block, target: &Target, at: InRule<'_>, number: u32) -> Option<EachStep> {
        Some(EachStep {
            call: dispatch::each::call(&block.row.key(), &block.args)?,
            args: self.args(block.row.params, &block.args, at.locals),
            target: self.target(target, at),
            number,
        })
    }

    /// An operation with operands.
    pub(super) fn derived(
        &self,
        block: &Block,
        operands: &[Target],
        at: InRule<'_>,
        number: u32,
    ) -> Option<OperandsStep> {
        Some(OperandsStep {
            call: dispatch::operands::call(&block.row.key(), &block.args)?,
            args: self.args(block.row.params, &block.args, at.locals),
            operands: operands.iter().map(|target| self.target(target, at)).collect(),
            recomposes: block.recomposes(),
            number,
        })
    }
}
