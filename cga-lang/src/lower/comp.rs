//! Divisions into components.

use super::body::block_span;
use super::{LONGEST_SOURCE, Lower};
use crate::ast::{self, ArmMode};
use crate::fold::fold;
use crate::ir::{Align, Comp, CompArm, CompMode, Expr, ExprKind, Selector, Target, Type};
use crate::ops;
use crate::span::Span;

impl<'c> Lower<'c> {
    pub(super) fn comp(&mut self, comp: &'c ast::Block, arms: &'c [ast::Arm]) -> Option<Comp<Target>> {
        let arms = arms.iter().map(|arm| {
            let then = self.block(&arm.ops, block_span(&arm.ops, arm.selector.span));
            self.arm(&arm.selector, arm.mode, then)
        });
        let arms = arms.collect();
        let mut args = comp.args.iter().map(|arg| &arg.value);
        divided(args.next()?, args.next(), arms, comp.name.span)
    }

    /// `comp(f) { selector : value }`: an array of what its values are.
    pub(super) fn comp_value(&mut self, comp: &ast::CompValue) -> Option<(ExprKind, Type)> {
        let arms = comp.arms.iter().map(|(selector, mode, value)| {
            let then = self.expr(value);
            self.arm(selector, *mode, then)
        });
        let arms: Vec<CompArm<Expr>> = arms.collect();
        let ty = arms.first()?.then.ty.array();
        let comp = divided(comp.args.first()?, comp.args.get(1), arms, comp.name.span)?;
        Some((ExprKind::Comp(Box::new(comp)), ty))
    }

    fn arm<T>(&mut self, selector: &ast::Expr, mode: ArmMode, then: T) -> CompArm<T> {
        let mode = match mode {
            ArmMode::Each => CompMode::Each,
            ArmMode::Together => CompMode::Together,
            ArmMode::Connected => CompMode::Connected,
        };
        CompArm { selector: self.selector(selector), text: self.tokens.text(selector.span, LONGEST_SOURCE), mode, then }
    }

    fn selector(&mut self, selector: &ast::Expr) -> Selector {
        let mut expr = self.expr(selector);
        fold(&mut expr, &self.known);
        match (&expr.kind, expr.ty) {
            (ExprKind::Word(word), _) => Selector::Word(word),
            (_, Type::Bool) => Selector::When(expr),
            _ => Selector::Index(expr),
        }
    }
}

fn divided<T>(kind: &ast::Expr, align: Option<&ast::Expr>, arms: Vec<CompArm<T>>, span: Span) -> Option<Comp<T>> {
    let components = ops::component(kind.word()?)?;
    let align = if align.and_then(ast::Expr::word) == Some("noAlign") { Align::Keep } else { Align::ZUp };
    Some(Comp { components, align, arms, span })
}

/// The question that a selector's word is. Old words are said in new ones.
pub(super) fn word(word: &'static str, span: Span) -> ExprKind {
    let street = || Expr { kind: ExprKind::Word("street.front"), ty: Type::Bool, span };
    match word {
        "streetSide" => street().kind,
        "noStreetSide" => ExprKind::Not(Box::new(street())),
        _ => ExprKind::Word(word),
    }
}
