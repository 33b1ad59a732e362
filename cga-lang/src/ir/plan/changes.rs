//! The form of the current shape for the steps that change it and for expressions: slim or whole.
//!
//! A *slim* shape has the values that most steps change, and borrows the rest from a whole shape. Steps that follow each other take
//! one form: they work on the slim shape if all of them can, else on a whole one.

use super::RunPlan;
use crate::ir::facts::Reads;
use crate::ir::walk;
use crate::ir::{Expr, ExprKind, FunctionId, Step, StepKind};
use crate::ops::{Changes, Uses};

/// The form of steps that follow each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChangeForm {
    /// They work on the slim shape: one entry for each step.
    Slim(Vec<SlimChange>),
    /// They work on a whole shape.
    Whole,
}

/// The change of a slim shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlimChange {
    /// The step reads the shape alone.
    Nothing,
    /// The step changes the scope.
    Scope,
    /// The step changes the material in the same way in the whole run, or at a site. So the result depends on the material before
    /// it alone, and is made once for each.
    Material {
        /// The number of sites on which the change depends; 0 for none.
        sites: u32,
        /// True if the change may differ between runs.
        is_of_run: bool,
        /// True if it changes texture coordinates, which caps have too.
        reaches_caps: bool,
    },
}

impl RunPlan<'_> {
    /// The form of steps that follow each other and change the current shape.
    pub fn change_form(&self, steps: &[Step]) -> ChangeForm {
        let slim: Option<Vec<SlimChange>> = steps.iter().map(|step| self.slim_change(step)).collect();
        slim.map_or(ChangeForm::Whole, ChangeForm::Slim)
    }

    /// Returns true if an expression reads more than a slim shape has: it is evaluated on a whole one.
    pub fn needs_whole(&self, expr: &Expr) -> bool {
        self.facts.expr(expr).has(Uses::BODY)
    }

    /// Returns true if a function reads more than a slim shape has.
    pub fn function_needs_whole(&self, id: FunctionId) -> bool {
        self.facts.function(id).has(Uses::BODY)
    }

    /// The change of a slim shape, if the step has such a form.
    fn slim_change(&self, step: &Step) -> Option<SlimChange> {
        let (changes, reaches_caps) = match &step.kind {
            StepKind::Do(row, ..) => (row.changes, row.uvs.reaches_caps()),
            StepKind::SetShape(row, ..) if row.set_changes == Changes::Material => (Changes::Material, false),
            _ => return None,
        };
        match changes {
            Changes::Whole => None,
            Changes::Nothing => Some(SlimChange::Nothing),
            Changes::Scope => Some(SlimChange::Scope),
            Changes::Material => {
                let reads: Reads = walk::in_step(step).into_iter().map(|expr| self.facts.reads(expr)).collect();
                let is_of_run = reads != Reads::NONE;
                self.is_settled(step).then(|| SlimChange::Material { sites: sites(step), is_of_run, reaches_caps })
            }
        }
    }

    /// Returns true if the arguments of a step are the same in the whole run.
    fn is_settled(&self, step: &Step) -> bool {
        walk::in_step(step).into_iter().all(|expr| {
            let mut is_settled = self.facts.expr(expr) == Uses::NONE;
            walk::parts(expr, &mut |part| is_settled &= !matches!(part.kind, ExprKind::Param(_)));
            is_settled
        })
    }
}

impl Step {
    /// Returns true if the step changes the current shape and makes no children.
    pub fn changes_shape(&self) -> bool {
        matches!(self.kind, StepKind::Do(..) | StepKind::SetAttr(..) | StepKind::SetShape(..) | StepKind::Rust(..))
    }
}

/// Returns true if one of the steps reads the scope that the shape had before the first of them.
pub fn reads_first_scope(steps: &[Step]) -> bool {
    steps.iter().any(|step| match &step.kind {
        StepKind::Do(row, ..) => row.uses_base,
        StepKind::Case { arms, otherwise } => {
            arms.iter().any(|(_, steps)| reads_first_scope(steps)) || reads_first_scope(otherwise)
        }
        // A bracket has its own first scope.
        _ => false,
    })
}

/// The number of sites that a step depends on; 0 for none.
fn sites(step: &Step) -> u32 {
    let mut count = 0;
    for expr in walk::in_step(step) {
        walk::parts(expr, &mut |part| {
            if let ExprKind::Call(_, sites, _) = &part.kind
                && sites.iter().any(|site| *site != sites[0])
            {
                count = sites.len() as u32;
            }
        });
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    const SETTLED: SlimChange = SlimChange::Material { sites: 0, is_of_run: false, reaches_caps: false };

    /// The form of the first steps of the rule `A`.
    fn form(rules: &str) -> ChangeForm {
        let grammar = compile_text(rules).compiled.grammar.expect("good rules");
        let steps = &grammar.rules[0].body;
        let count = steps.iter().take_while(|step| step.changes_shape()).count();
        RunPlan::new(&grammar).change_form(&steps[..count])
    }

    #[test]
    fn steps_that_change_the_scope_are_slim() {
        let rules = "A --> t(1, 0, 0) s('1, scope.sy, 1) print(scope.sx) X.";
        assert_eq!(form(rules), ChangeForm::Slim(vec![SlimChange::Scope, SlimChange::Scope, SlimChange::Nothing]));
    }

    #[test]
    fn one_step_on_a_whole_shape_takes_the_others_with_it() {
        assert_eq!(form("A --> t(1, 0, 0) primitiveCube() color(\"#ff0000\") X."), ChangeForm::Whole);
        assert_eq!(form("attr a = 1  A --> t(1, 0, 0) set(a, 2) X."), ChangeForm::Whole);
        assert_eq!(form("A --> crate::arch(2) X."), ChangeForm::Whole);
    }

    #[test]
    fn a_material_that_is_the_same_in_the_run_is_slim() {
        let rules = "attr red = \"#ff0000\"  A --> color(red) set(material.opacity, 0.5) X.";
        assert_eq!(form(rules), ChangeForm::Slim(vec![SETTLED; 2]));
        let of_run = SlimChange::Material { sites: 0, is_of_run: true, reaches_caps: false };
        let rules = "attr tint = rand(1)  A --> color(tint, 0, 0) X.";
        assert_eq!(form(rules), ChangeForm::Slim(vec![of_run]));
        for rules in ["A --> set(material.opacity, scope.sx) X.", "A --> set(material.opacity, rand(1)) X."] {
            assert_eq!(form(rules), ChangeForm::Whole);
        }
        assert_eq!(form("A(n) --> set(material.opacity, n) X.  @StartRule B --> A(1)"), ChangeForm::Whole);
    }
}
