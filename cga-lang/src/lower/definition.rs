//! Definitions that become one: their expressions and references, and the form that is compared.

use crate::ir::{Expr, ExprKind, FunctionId, GlobalId, Param, RenewalId, RuleId, Step, StepKind, Target, Type, walk};
use crate::span::Span;

/// The condition that holds in some cases: [`ExprKind::Style`] or [`ExprKind::Site`].
pub(super) type CaseCondition = fn(Vec<u32>) -> ExprKind;

/// A definition that holds in some cases.
pub(super) struct Variant<T> {
    pub(super) cases: Vec<u32>,
    pub(super) own: T,
}

/// An attribute, a constant, a function or a rule.
pub(super) trait Definition: Clone {
    /// The parameters, then the locals.
    fn params(&self) -> &[Param] {
        &[]
    }

    /// The values of the locals, then its own value.
    fn values(&mut self) -> Vec<&mut Expr>;

    /// The steps of a rule.
    fn steps(&mut self) -> &mut [Step] {
        &mut []
    }

    /// One definition for all variants.
    fn merged(variants: Vec<Variant<Self>>, when: CaseCondition) -> Self;

    /// Visits every expression without its parts.
    fn exprs(&mut self, visit: &mut dyn FnMut(&mut Expr)) {
        self.values().into_iter().for_each(&mut *visit);
        walk::exprs_mut(self.steps(), visit);
    }

    /// Visits all references, in the same order for equal definitions.
    fn references(&mut self, visit: &mut dyn FnMut(Reference<'_>)) {
        self.exprs(&mut |expr| {
            walk::parts_mut(expr, &mut |part| match &mut part.kind {
                ExprKind::Global(id) => visit(Reference::Read(*id, part)),
                ExprKind::Call(id, sites, _) => visit(Reference::Call(id, sites)),
                _ => {}
            });
        });
        walk::steps_mut(self.steps(), &mut |step| {
            match &mut step.kind {
                StepKind::SetAttr(id, _) => visit(Reference::Set(id)),
                StepKind::Renew(call) => {
                    call.given.iter_mut().for_each(|(id, _)| visit(Reference::Set(id)));
                    visit(Reference::Renewal(&mut call.renewal));
                }
                _ => {}
            }
            for target in walk::targets_mut(step) {
                if let Target::Rule { rule, sites, .. } = target {
                    visit(Reference::Rule(rule, sites));
                }
            }
        });
    }

    /// The form of the definition, with references that `refer` has changed.
    fn form(&self, refer: &mut dyn FnMut(Reference<'_>)) -> CanonicalForm {
        let mut own = self.clone();
        own.references(refer);
        own.exprs(&mut |expr| walk::parts_mut(expr, &mut |part| part.span = Span::default()));
        walk::steps_mut(own.steps(), &mut |step| {
            step.span = Span::default();
            for target in walk::targets_mut(step) {
                if let Target::Rule { span, .. } = target {
                    *span = Span::default();
                }
            }
        });
        let params = own.params().iter().map(|param| (param.name.clone(), param.ty)).collect();
        let values = own.values().into_iter().map(|value| value.clone()).collect();
        CanonicalForm { params, values, steps: own.steps().to_vec() }
    }
}

/// The parts of a definition that decide its result, without spans. Definitions with equal forms are one.
#[derive(PartialEq)]
pub(super) struct CanonicalForm {
    params: Vec<(String, Type)>,
    values: Vec<Expr>,
    steps: Vec<Step>,
}

/// A reference in a definition.
pub(super) enum Reference<'d> {
    /// An expression that reads an attribute or constant.
    Read(GlobalId, &'d mut Expr),
    /// The function of a call, with its sites.
    Call(&'d mut FunctionId, &'d mut Vec<u32>),
    /// The rule of a successor, with its sites.
    Rule(&'d mut RuleId, &'d mut Vec<u32>),
    /// An attribute that gets a value.
    Set(&'d mut GlobalId),
    /// The values that are computed again.
    Renewal(&'d mut RenewalId),
}

impl Reference<'_> {
    /// The index of the definition that is referred to.
    pub(super) fn index(&self) -> u32 {
        match self {
            Reference::Read(id, _) => id.0,
            Reference::Call(id, _) => id.0,
            Reference::Rule(id, _) => id.0,
            Reference::Set(id) => id.0,
            Reference::Renewal(id) => id.0,
        }
    }
}
