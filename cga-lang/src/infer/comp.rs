//! Types of selectors, and of values for components.

use super::open::OpenKind;
use super::{Infer, Type, Use, Var};
use crate::diag::code::Code;
use crate::ops::{Function, Needs};
use crate::span::Span;
use crate::syntax::ast::{CompValue, Expr, ExprKind, Name};

impl<'a> Infer<'_, 'a, '_> {
    /// Infers a selector. Its type distinguishes a condition from an index.
    pub(super) fn selector(&mut self, selector: &'a Expr) {
        let var = self.expr(selector);
        self.selectors.push((self.own, var, selector));
    }

    /// Infers an array with a value for each component.
    pub(super) fn comp_value(&mut self, comp: &'a CompValue, span: Span) -> Var {
        let mut entries = Vec::new();
        for (selector, _, value) in &comp.arms {
            self.selector(selector);
            entries.push((self.expr(value), value.span));
        }
        self.components.extend(entries.iter().map(|entry| (self.own, *entry)));
        self.wait(OpenKind::Array(entries), span)
    }

    /// Checks all selectors and values.
    pub(super) fn comps(&mut self) {
        for (own, var, selector) in std::mem::take(&mut self.selectors) {
            self.inside(own, |pass| pass.settled_selector(var, selector));
        }
        for (own, (var, span)) in std::mem::take(&mut self.components) {
            if let Some(ty) = self.vars.known(var).filter(|ty| ty.is_array()) {
                let needs = "a component has one value, a float, bool or string; this is";
                self.inside(own, |pass| _ = pass.mismatch(span, needs, ty));
            }
        }
    }

    fn settled_selector(&mut self, var: Var, selector: &Expr) {
        match self.vars.known(var) {
            Some(Type::Float) => self.asked_in_index(selector),
            Some(Type::Bool) | None => {}
            Some(ty) => {
                let why = self.vars.why(var).filter(|why| *why != selector.span);
                let tag = match &selector.kind {
                    ExprKind::Text(tag) => Some(format!("write `isTagged(\"{tag}\")` for the parts with this tag")),
                    _ => None,
                };
                let diag = self.mismatch(selector.span, "a selector is a word, a bool or a float, this is", ty);
                if let Some(help) = tag {
                    diag.help(help);
                }
                if let Some(why) = why {
                    diag.related(format!("found to be a {}", ty.word()), why);
                }
            }
        }
    }

    /// Reports a function of components in an index, which is computed before there are components.
    fn asked_in_index(&mut self, part: &Expr) {
        if let ExprKind::Name(name) | ExprKind::Call(name, _) = &part.kind
            && self.is_asked(name)
        {
            let message = format!("`{}` is not allowed in an index", name.text);
            let diag = self.cx.diags.report(Code::UnknownSelector, name.span, message);
            diag.note("a selector that is a float is an index, computed once for the whole shape");
        }
        // The parts of another `comp` read the components of that `comp`.
        if !matches!(part.kind, ExprKind::Comp(_)) {
            part.parts().into_iter().for_each(|part| self.asked_in_index(part));
        }
    }

    fn is_asked(&self, name: &Name) -> bool {
        matches!(
            self.cx.tables.at(self.own).of(name),
            Some(Use::Selector(_) | Use::Builtin(Function { needs: Needs::Component, .. }))
        )
    }
}
