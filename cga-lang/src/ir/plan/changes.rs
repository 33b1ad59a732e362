//! The form of the current shape for the steps that change it and for expressions: slim or whole.
//!
//! A *slim* shape has the values that most steps change, and borrows the rest from a whole shape. Steps that follow each other take
//! one form: they work on the slim shape if all of them can, else on a whole one.

use std::collections::BTreeMap;

use super::RunPlan;
use crate::ir::facts::Reads;
use crate::ir::walk;
use crate::ir::{Expr, ExprKind, FunctionId, Step, StepKind, Type};
use crate::ops::{Changes, Uses};

/// The form of steps that follow each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChangeForm {
    /// They work on the slim shape: one entry for each step, or for several.
    Slim(Vec<SlimChange>),
    /// They work on a whole shape.
    Whole,
}

/// The change of a slim shape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SlimChange {
    /// The step reads the shape alone.
    Nothing,
    /// The step changes the scope.
    Scope,
    /// Steps that change the material in a way that depends on the material before them alone, on their site, and on parameters. So their
    /// result is made once for each.
    Material(MaterialChange),
}

/// Steps that follow each other and change the material.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MaterialChange {
    /// The number of steps.
    pub steps: usize,
    /// The number of sites on which the change depends; 0 for none.
    pub sites: u32,
    /// True if the change may differ between runs.
    pub is_of_run: bool,
    /// True if it changes texture coordinates, which caps have too.
    pub reaches_caps: bool,
    /// The parameters and locals on which it depends, in the order of their numbers.
    pub params: BTreeMap<u32, Type>,
}

impl SlimChange {
    /// The number of its steps.
    pub fn steps(&self) -> usize {
        if let SlimChange::Material(change) = self { change.steps } else { 1 }
    }
}

impl MaterialChange {
    /// Adds the steps of a change that follows.
    fn add(&mut self, next: MaterialChange) {
        self.steps += next.steps;
        self.sites = self.sites.max(next.sites);
        self.is_of_run |= next.is_of_run;
        self.reaches_caps |= next.reaches_caps;
        self.params.extend(next.params);
    }
}

impl RunPlan<'_> {
    /// The form of steps that follow each other and change the current shape.
    pub fn change_form(&self, steps: &[Step]) -> ChangeForm {
        let mut slim: Vec<SlimChange> = Vec::new();
        for step in steps {
            match (self.slim_change(step), slim.last_mut()) {
                (None, _) => return ChangeForm::Whole,
                (Some(SlimChange::Material(next)), Some(SlimChange::Material(change))) => change.add(next),
                (Some(next), _) => slim.push(next),
            }
        }
        ChangeForm::Slim(slim)
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
                let (sites, params) = (sites(step), params(step));
                let change = MaterialChange { steps: 1, sites, is_of_run, reaches_caps, params };
                self.is_settled(step).then_some(SlimChange::Material(change))
            }
        }
    }

    /// Returns true if the arguments of a step are the same in the whole run, parameters aside.
    fn is_settled(&self, step: &Step) -> bool {
        walk::in_step(step).into_iter().all(|expr| self.facts.expr(expr) == Uses::NONE)
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

/// The parameters and locals in the arguments of a step.
fn params(step: &Step) -> BTreeMap<u32, Type> {
    let mut params = BTreeMap::new();
    for expr in walk::in_step(step) {
        walk::parts(expr, &mut |part| {
            if let ExprKind::Param(number) = part.kind {
                params.insert(number, part.ty);
            }
        });
    }
    params
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compile::compile_text;

    fn change(steps: usize, is_of_run: bool, params: &[(u32, Type)]) -> SlimChange {
        let params = params.iter().copied().collect();
        SlimChange::Material(MaterialChange { steps, is_of_run, params, ..MaterialChange::default() })
    }

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
        assert_eq!(form(rules), ChangeForm::Slim(vec![change(2, false, &[])]));
        let rules = "attr tint = rand(1)  A --> color(tint, 0, 0) X.";
        assert_eq!(form(rules), ChangeForm::Slim(vec![change(1, true, &[])]));
        for rules in ["A --> set(material.opacity, scope.sx) X.", "A --> set(material.opacity, rand(1)) X."] {
            assert_eq!(form(rules), ChangeForm::Whole);
        }
    }

    #[test]
    fn a_material_that_depends_on_parameters_is_slim() {
        let by_number = change(1, false, &[(0, Type::Float)]);
        let alone = "A(n) --> set(material.opacity, n) X.  @StartRule B --> A(1)";
        assert_eq!(form(alone), ChangeForm::Slim(vec![by_number.clone()]));
        assert_eq!(form("A with ( a := scope.sx ) --> color(a, 0, a) X."), ChangeForm::Slim(vec![by_number]));
        let rules = "attr tint = rand(1)  A(n) --> color(tint, n, 0) X.  @StartRule B --> A(1)";
        assert_eq!(form(rules), ChangeForm::Slim(vec![change(1, true, &[(0, Type::Float)])]));
        assert_eq!(form("A(n) --> color(n, scope.sx, 0) X.  @StartRule B --> A(1)"), ChangeForm::Whole);
        let rules =
            "A(n, b, t) --> color(t + n) set(material.opacity, n * n) t(1, 0, 0) projectUV(0) color(\"#ff0000\") X.
            @StartRule B --> A(1, true, \"#ff0000\")";
        let mut last = MaterialChange { steps: 2, reaches_caps: true, ..MaterialChange::default() };
        let both = change(2, false, &[(0, Type::Float), (2, Type::Text)]);
        assert_eq!(form(rules), ChangeForm::Slim(vec![both, SlimChange::Scope, SlimChange::Material(last.clone())]));
        last.steps = 1;
        assert_eq!(form("A --> projectUV(0) X."), ChangeForm::Slim(vec![SlimChange::Material(last)]));
    }
}
