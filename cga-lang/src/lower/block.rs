//! Operations with braces, and `comp` as a value.

use super::{LONGEST_SOURCE, Lower};
use crate::ir::{
    Arg as IrArg, Arm, Block, BlockParts, Comp, Expr, ExprKind, Item, Sections, Selector, Slots, Step, StepKind,
    Target, Type,
};
use crate::lower::fold::fold;
use crate::ops::{self, Braces, Directions, Operation, SameAs, SelectorPlaces};
use crate::resolve::tables::Use;
use crate::span::Span;
use crate::syntax::ast::{self, ArmMode, BlockPart, Section, SplitItem};

impl<'c> Lower<'c> {
    pub(super) fn block(&mut self, block: &'c ast::Block) -> Option<StepKind> {
        let Use::Operation(row) = self.used(&block.name)? else { return None };
        let args = self.args(row, &block.args, block.name.span);
        let parts = match (row.braces, block.parts.as_slice()) {
            (_, [BlockPart::Slots(items, repeat)]) => {
                let mut slots = Slots::default();
                self.slots(items, *repeat, &mut slots, block.name.span);
                BlockParts::Slots(slots)
            }
            (Braces::Modified, [BlockPart::Arms(arms)]) => {
                BlockParts::Operands(vec![self.modified(row, &args, arms, block.name.span)])
            }
            (_, [BlockPart::Arms(arms)]) => BlockParts::Arms(arms.iter().map(|arm| self.arm_of(arm)).collect()),
            (Braces::Sections, [BlockPart::Sections(sections, repeat), BlockPart::Arms(rest)]) => {
                BlockParts::Sections(self.sections(sections, *repeat, rest, block.name.span))
            }
            (Braces::Ops, [BlockPart::Ops(sides)]) => BlockParts::Each(self.part(sides.first()?, block.name.span)),
            (_, [BlockPart::Ops(sides)]) => {
                BlockParts::Operands(sides.iter().map(|ops| self.part(ops, block.name.span)).collect())
            }
            // Braces that could not be read.
            _ => return None,
        };
        Some(StepKind::Block(Block { row, args, parts }))
    }

    /// The operand of `modify`: a rule that divides the shape into its components.
    fn modified(&mut self, row: &'static Operation, args: &[IrArg], arms: &'c [ast::Arm], span: Span) -> Target {
        let arms = |lower: &mut Self| BlockParts::Arms(arms.iter().map(|arm| lower.arm_of(arm)).collect());
        self.block_rule(span, |lower| {
            let kind = StepKind::Block(Block { row, args: args.to_vec(), parts: arms(lower) });
            vec![Step { kind, span }]
        })
    }

    fn slots(&mut self, items: &'c [SplitItem], repeat: bool, out: &mut Slots, owner: Span) {
        let start = out.pattern.len();
        if repeat {
            out.pattern.push(Item::Repeat(0));
        }
        for item in items {
            match item {
                SplitItem::Slot(size, ops) => {
                    out.pattern.push(Item::Slot);
                    let size = self.size(size);
                    out.sizes.push(size);
                    let target = self.part(ops, owner);
                    out.targets.push(target);
                }
                SplitItem::Group(items, repeat) => self.slots(items, *repeat, out, owner),
            }
        }
        if repeat {
            out.pattern[start] = Item::Repeat((out.pattern.len() - start - 1) as u32);
        }
    }

    fn sections(&mut self, sections: &'c [Section], repeat: bool, rest: &'c [ast::Arm], owner: Span) -> Sections {
        let mut slots = Slots { pattern: vec![Item::Slot; sections.len()], ..Slots::default() };
        if repeat {
            slots.pattern.insert(0, Item::Repeat(sections.len() as u32));
        }
        let mut depths = Vec::with_capacity(sections.len());
        for section in sections {
            let size = self.size(&section.length);
            slots.sizes.push(size);
            depths.push(self.folded(&section.depth));
            let target = self.part(&section.ops, owner);
            slots.targets.push(target);
        }
        Sections { slots, depths, rest: rest.iter().map(|arm| self.arm_of(arm)).collect() }
    }

    fn arm_of(&mut self, arm: &'c ast::Arm) -> Arm<Target> {
        let then = self.part(&arm.ops, arm.selector.span);
        self.arm(&arm.selector, arm.mode, then)
    }

    /// `comp(f) { selector : value }`: an array of the values.
    pub(super) fn comp_value(&mut self, comp: &ast::CompValue) -> Option<(ExprKind, Type)> {
        let row = ops::operations(&comp.name.text).next()?;
        let arms = comp.arms.iter().map(|(selector, mode, value)| {
            let then = self.expr(value);
            self.arm(selector, *mode, then)
        });
        let arms: Vec<Arm<Expr>> = arms.collect();
        let ty = arms.first()?.then.ty.array();
        let args: Vec<ast::Arg> =
            comp.args.iter().map(|value| ast::Arg { prefix: None, value: value.clone(), span: value.span }).collect();
        let args = self.args(row, &args, comp.name.span);
        Some((ExprKind::Comp(Box::new(Comp { row, args, arms })), ty))
    }

    /// The array of a value that is computed on each edge of each face (*setbackPerEdge operation*).
    pub(super) fn per_edge(&mut self, value: &ast::Expr) -> Expr {
        let then = self.folded(value);
        let row = ops::all_operations().find(|row| row.braces == Braces::Components);
        let edges = ops::COMPONENTS.iter().find(|row| row.place == SelectorPlaces::FACE_EDGES);
        let all = ops::selectors().find(|row| row.directions == Directions::ALL);
        let (Some(row), Some(edges), Some(all)) = (row, edges, all) else { return then };
        let mut args = vec![IrArg::Word(edges.name)];
        // The other parameters have defaults.
        args.extend(self.args(row, &[], value.span));
        let arm = Arm { selector: Selector::Word(all.name), text: all.name.to_owned(), mode: ArmMode::Each, then };
        let kind = ExprKind::Comp(Box::new(Comp { row, args, arms: vec![arm] }));
        Expr { kind, ty: Type::Floats, span: value.span }
    }

    fn arm<T>(&mut self, selector: &ast::Expr, mode: ArmMode, then: T) -> Arm<T> {
        let text = self.tokens.text(selector.span, LONGEST_SOURCE, '\'');
        Arm { selector: self.selector(selector), text, mode, then }
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

/// The condition of a selector's word. Deprecated words are replaced.
pub(super) fn word(word: &'static str, span: Span) -> ExprKind {
    match ops::selector(word).and_then(|row| row.same_as) {
        None => ExprKind::Word(word),
        Some(SameAs::Word(word)) => ExprKind::Word(word),
        Some(SameAs::Not(word)) => ExprKind::Not(Box::new(Expr { kind: ExprKind::Word(word), ty: Type::Bool, span })),
    }
}
