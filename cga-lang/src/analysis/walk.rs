//! Follows a shape through the steps of a rule.

use super::evaluator::Evaluator;
use super::facts::AbstractState;
use super::shape::{Filling, Shape};
use super::slots::Slots;
use super::uvs::UvSets;
use super::value::Value;
use crate::ops::{self, Braces, Effect, FileUse, MOST_SIZE, Measure, Operation, ParamKind, SelectorPlaces, ShapeAttr};
use crate::resolve::tables::Use;
use crate::span::Span;
use crate::syntax::ast::{Arg, Arm, ArmMode, Block, BlockPart, Expr, ExprKind, Name, Op, OpKind, SplitItem};
use crate::syntax::written::Written;

/// A site: a place in a rule that checks look at.
pub(crate) enum Site<'s, 'a> {
    /// A split along an axis of the scope.
    Split(&'s Slots<'a>),
    /// The sections of a boundary.
    Sections(&'s Slots<'a>),
    /// An operation that divides the faces, edges or other components of the shape.
    Components(&'static Operation, &'a Block),
    /// A split along an axis of a uv set, with the number of the set if it is known and valid.
    TextureSplit(&'a Block, Option<u32>),
    /// A condition of a `case`, after the earlier conditions have failed.
    Condition(&'s CaseBranch<'s, 'a>),
    /// An evaluated expression.
    Value(&'a Expr),
    /// A `set` of an attribute of the shape.
    Set(&'static ShapeAttr, &'a Expr),
    /// An operation with its arguments.
    Operation(&'static Operation, &'a [Arg]),
}

/// A condition of a `case`, with its neighbours.
pub(crate) struct CaseBranch<'t, 'e> {
    pub(crate) condition: &'e Expr,
    /// The earlier conditions, which have failed: also the conditions of an enclosing `case` whose `else` contains this one.
    pub(crate) before: &'t Written<'t, &'e Expr>,
    pub(crate) is_last: bool,
    /// The state at the first of them.
    pub(crate) first: &'t AbstractState,
}

/// Receives the sites and the calls of a rule.
pub(super) trait Visit<'a> {
    /// A rule is called with a shape.
    fn hand_on(&mut self, rule: u32, facts: AbstractState);
    /// A site is reached.
    fn meet(&mut self, site: &Site<'_, 'a>, facts: &AbstractState);
}

/// A walk through one rule.
pub(super) struct Walk<'w> {
    pub(super) known: &'w Evaluator<'w>,
    /// True if sizes set by steps count as unknown.
    pub(super) forgets: bool,
}

impl<'w> Walk<'w> {
    /// Follows a shape; returns the state at the end, `None` if no path reaches it.
    pub(super) fn steps<'a>(
        &self,
        ops: &'a [Op],
        facts: AbstractState,
        visit: &mut dyn Visit<'a>,
    ) -> Option<AbstractState> {
        let mut facts = facts;
        for op in ops {
            facts = self.step(op, facts, visit)?;
        }
        Some(facts)
    }

    fn step<'a>(&self, op: &'a Op, mut facts: AbstractState, visit: &mut dyn Visit<'a>) -> Option<AbstractState> {
        match &op.kind {
            OpKind::Call(name, args) => {
                self.meet_args(args, &facts, visit);
                match self.known.of(name, &facts) {
                    Some(Use::Rule(rule)) => self.hand_on(rule, args, &facts, visit),
                    Some(Use::Operation(row)) => {
                        visit.meet(&Site::Operation(row, args), &facts);
                        let sets = [args.first(), args.get(1)].map(|arg| self.uv_set(arg, &facts));
                        facts.uvs = facts.uvs.after(row, sets);
                        facts.asset = asset_after(row, args, facts.asset);
                        facts.shape = self.after(row, args, &facts, op.span);
                    }
                    Some(Use::SetShape(row)) => {
                        args.get(1).into_iter().for_each(|arg| visit.meet(&Site::Set(row, &arg.value), &facts));
                        if row.set_scope != Effect::Keeps {
                            facts.shape = facts.shape.moved_on();
                        }
                    }
                    Some(Use::Leaf | Use::SetAttr(_)) => {}
                    _ => facts.shape = Shape::ANY,
                }
            }
            OpKind::Dynamic { rule, args, overrides, .. } => {
                self.meet_args(args, &facts, visit);
                for own in overrides {
                    if let crate::syntax::ast::Override::Value(_, value) = own {
                        visit.meet(&Site::Value(value), &facts);
                    }
                }
                if let Some(Use::Rule(rule)) = self.known.of(rule, &facts) {
                    // Attributes and constants of the import are computed again.
                    let facts = AbstractState { globals: Vec::new(), ..facts.clone() };
                    self.hand_on(rule, args, &facts, visit);
                }
            }
            OpKind::Block(block) => return Some(self.block(block, facts, visit)),
            OpKind::Leaf(_) | OpKind::Nil => {}
            OpKind::Path(_, args) => {
                self.meet_args(args, &facts, visit);
                facts = AbstractState { uvs: UvSets::ANY, asset: None, ..facts.on_any_shape() };
            }
            OpKind::Push(ops) => _ = self.steps(ops, facts.clone(), visit),
            OpKind::Case(arms, otherwise) => {
                let first = facts.clone();
                let mut before = Written::new(self.known.tokens);
                return self.case(arms, otherwise, facts, &first, &mut before, visit);
            }
            OpKind::Chance(arms, otherwise) => {
                let arms = arms.iter().map(|(_, ops)| ops).chain([otherwise]);
                let ends: Vec<AbstractState> = arms.filter_map(|ops| self.steps(ops, facts.clone(), visit)).collect();
                return joined(ends);
            }
            OpKind::Error => facts.shape = Shape::ANY,
        }
        Some(facts)
    }

    fn meet_args<'a>(&self, args: &'a [Arg], facts: &AbstractState, visit: &mut dyn Visit<'a>) {
        args.iter().for_each(|arg| visit.meet(&Site::Value(&arg.value), facts));
    }

    fn value(&self, expr: &Expr, facts: &AbstractState) -> Value {
        self.known.value(expr, facts)
    }

    /// The number of a uv set, if it is known.
    fn uv_set(&self, arg: Option<&Arg>, facts: &AbstractState) -> Option<u32> {
        let number = self.value(&arg?.value, facts).number().known()?;
        (0.0..10.0).contains(&number).then_some(number as u32)
    }

    fn hand_on<'a>(&self, rule: u32, args: &[Arg], facts: &AbstractState, visit: &mut dyn Visit<'a>) {
        let params = args.iter().map(|arg| self.value(&arg.value, facts)).collect();
        visit.hand_on(rule, facts.with(self.known.rules[rule as usize], params));
    }

    fn case<'a>(
        &self,
        arms: &'a [(Expr, Vec<Op>)],
        otherwise: &'a [Op],
        facts: AbstractState,
        first: &AbstractState,
        before: &mut Written<'_, &'a Expr>,
        visit: &mut dyn Visit<'a>,
    ) -> Option<AbstractState> {
        // A condition is evaluated after all earlier ones have failed.
        let (mut ends, mut left) = (Vec::new(), Some(facts));
        for (at, (condition, ops)) in arms.iter().enumerate() {
            let Some(here) = left else { break };
            visit.meet(&Site::Value(condition), &here);
            let turn = CaseBranch { condition, before, is_last: at + 1 == arms.len(), first };
            visit.meet(&Site::Condition(&turn), &here);
            before.add(condition.span, condition);
            if let Some(inside) = self.known.past(condition, true, here.clone()) {
                ends.extend(self.steps(ops, inside, visit));
            }
            left = self.known.past(condition, false, here);
        }
        if let Some(here) = left {
            ends.extend(match otherwise {
                // The list of conditions continues in the `else`.
                [Op { kind: OpKind::Case(arms, otherwise), .. }] => {
                    self.case(arms, otherwise, here, first, before, visit)
                }
                _ => self.steps(otherwise, here, visit),
            });
        }
        joined(ends)
    }

    /// An operation with braces. Only one that goes on with the results of its operands changes the shape itself.
    fn block<'a>(&self, block: &'a Block, facts: AbstractState, visit: &mut dyn Visit<'a>) -> AbstractState {
        let changes = match self.known.of(&block.name, &facts) {
            Some(Use::Operation(row)) => !row.braces.divides(),
            _ => false,
        };
        self.parts(block, &facts, visit);
        match changes {
            true => AbstractState { globals: Vec::new(), uvs: UvSets::ANY, asset: None, ..facts.on_any_shape() },
            false => facts,
        }
    }

    /// The parts that an operation with braces makes.
    fn parts<'a>(&self, block: &'a Block, facts: &AbstractState, visit: &mut dyn Visit<'a>) {
        let any = || AbstractState { asset: None, ..facts.on_any_shape() };
        let row = match self.known.of(&block.name, facts) {
            Some(Use::Operation(row)) => Some(row),
            _ => None,
        };
        // Some arguments are evaluated on each edge.
        let on_edges = row.is_some_and(|row| row.params.iter().any(|param| param.kind == ParamKind::PerEdge));
        let here = if on_edges { any() } else { facts.clone() };
        self.meet_args(&block.args, &here, visit);
        if let Some(row) = row {
            visit.meet(&Site::Operation(row, &block.args), &here);
            if matches!(row.braces, Braces::Arms(_) | Braces::Sections | Braces::Components | Braces::Modified) {
                visit.meet(&Site::Components(row, block), facts);
            }
        }
        for part in &block.parts {
            match part {
                BlockPart::Slots(items, repeat) => self.slots(block, row, (items, *repeat), facts, visit),
                BlockPart::Arms(arms) => {
                    arms.iter().for_each(|arm| self.arm(arm, block, row, facts, visit));
                }
                BlockPart::Sections(list, repeat) => {
                    for section in list {
                        visit.meet(&Site::Value(&section.length.value), facts);
                        visit.meet(&Site::Value(&section.depth), &any());
                    }
                    let length = |length: &Arg| self.value(&length.value, facts).number();
                    let depth = |depth: &Expr| self.value(depth, &any()).number();
                    let slots = Slots::of_sections(block, (list, *repeat), length, depth);
                    visit.meet(&Site::Sections(&slots), facts);
                    for (index, slot) in slots.list.iter().enumerate() {
                        if !slots.is_never(index) && !slot.has_no_depth() {
                            self.steps(slot.ops, any(), visit);
                        }
                    }
                }
                BlockPart::Ops(list) => {
                    let part = || match row {
                        None => any(),
                        Some(row) if row.braces == Braces::Ops => {
                            let point = facts.shape.point(block.name.span);
                            AbstractState { asset: None, ..facts.on(point) }
                        }
                        Some(_) => facts.clone(),
                    };
                    list.iter().for_each(|ops| _ = self.steps(ops, part(), visit));
                }
            }
        }
    }

    fn slots<'a>(
        &self,
        block: &'a Block,
        row: Option<&'static Operation>,
        (items, repeat): (&'a [SplitItem], bool),
        facts: &AbstractState,
        visit: &mut dyn Visit<'a>,
    ) {
        let any = |_: usize| Some(Shape::ANY);
        match row.map(|row| row.braces) {
            Some(Braces::Slots(Measure::Length)) => {
                let Some(axis) = block.axis() else { return self.items(items, &mut 0, facts, visit, &any) };
                let value = |size: &Arg| self.value(&size.value, facts).number();
                let slots = Slots::new(block, (items, repeat), axis as usize, facts, value);
                visit.meet(&Site::Split(&slots), facts);
                // Parts shrink to their geometry, which a word can turn off (*split operation*).
                let adjusts = row.is_none_or(|row| block.is_plain(row));
                self.items(items, &mut 0, facts, visit, &|index| {
                    if facts.shape.is_flat(axis as usize) || slots.is_never(index) {
                        return None;
                    }
                    Some(facts.shape.part(axis as usize, slots.length(index), adjusts, block.name.span))
                });
            }
            Some(Braces::Slots(Measure::Texture)) => {
                let set = self.uv_set(block.args.get(2), facts);
                visit.meet(&Site::TextureSplit(block, set), facts);
                self.items(items, &mut 0, facts, visit, &any);
            }
            _ => self.items(items, &mut 0, facts, visit, &any),
        }
    }

    /// The slots of a split. `shape` returns the abstract shape of a part, `None` for a slot that never makes one.
    fn items<'a>(
        &self,
        items: &'a [SplitItem],
        index: &mut usize,
        facts: &AbstractState,
        visit: &mut dyn Visit<'a>,
        shape: &dyn Fn(usize) -> Option<Shape>,
    ) {
        for item in items {
            match item {
                SplitItem::Slot(size, ops) => {
                    visit.meet(&Site::Value(&size.value), facts);
                    let part = shape(*index);
                    *index += 1;
                    if let Some(shape) = part {
                        self.steps(ops, facts.on(shape), visit);
                    }
                }
                SplitItem::Group(items, _) => self.items(items, index, facts, visit, shape),
            }
        }
    }

    fn arm<'a>(
        &self,
        arm: &'a Arm,
        block: &'a Block,
        row: Option<&'static Operation>,
        facts: &AbstractState,
        visit: &mut dyn Visit<'a>,
    ) {
        // With the part as current shape.
        visit.meet(&Site::Value(&arm.selector), &facts.on_any_shape());
        let selector = match &arm.selector.kind {
            ExprKind::Name(name) => match self.known.of(name, facts) {
                Some(Use::Selector(word)) => ops::selector(word),
                _ => None,
            },
            _ => None,
        };
        let comp = row.filter(|row| row.braces == Braces::Components);
        let is_comp = comp.is_some();
        let kind = block.args.first().and_then(|arg| arg.value.word()).and_then(ops::component);
        let is_face = kind.is_some_and(|kind| kind.place == SelectorPlaces::FACES) && arm.mode == ArmMode::Each;
        // Faces have their own axes, unless a word keeps the axes of the shape.
        let faces = is_face && comp.is_some_and(|row| block.is_plain(row));
        let shape = match (faces, facts.shape.filling) {
            (true, Filling::Box) => facts.shape.face_of_box(selector, block.name.span),
            (true, Filling::Prism) => facts.shape.face_of_prism(selector, block.name.span),
            (true, _) => Shape::face(block.name.span),
            (false, _) => Shape::ANY,
        };
        let part = facts.on(shape);
        self.steps(&arm.ops, if is_comp { part } else { AbstractState { asset: None, ..part } }, visit);
    }

    /// The transfer function of an operation.
    fn after(&self, row: &'static Operation, args: &[Arg], facts: &AbstractState, span: Span) -> Shape {
        let shape = facts.shape;
        match row.scope {
            Effect::Keeps => shape,
            Effect::KeepsSize => Shape { filling: Filling::Unknown, ..shape },
            _ if self.forgets => shape.moved_on(),
            Effect::Sizes => match args {
                [x, y, z] => self.sized(shape, [x, y, z], facts, span),
                _ => shape.moved_on(),
            },
            Effect::FillsWithBox if shape.has_room() && !shape.trimmed => shape.filled(Filling::Box),
            Effect::FillsWithBox | Effect::Fills if shape.has_room() => shape.filled(Filling::Unknown),
            Effect::Extrudes => match args {
                [Arg { prefix: None, value, .. }] => shape.extruded(self.value(value, facts).number(), span),
                _ => shape.moved_on(),
            },
            Effect::Flattens => shape.moved_on().filled(Filling::Footprint),
            Effect::Any | Effect::MovesScope | Effect::FillsWithBox | Effect::Fills => shape.moved_on(),
        }
    }

    fn sized(&self, shape: Shape, args: [&Arg; 3], facts: &AbstractState, span: Span) -> Shape {
        let (mut size, mut kept) = (shape.size, [false; 3]);
        for ((size, kept), arg) in size.iter_mut().zip(&mut kept).zip(args) {
            let number = self.value(&arg.value, facts).number().taken();
            let (old, is_share) = (*size, arg.prefix.is_some());
            let new = if is_share { number.mul(old) } else { number };
            // A size that is too large leaves the scope unchanged; a relative size is never too large.
            let is_small = is_share && -1.0 <= number.lo && number.hi <= 1.0 || new.abs().hi <= MOST_SIZE;
            *size = if is_small { new.tame() } else { new.tame().or(old) };
            *kept = is_share && number.known() == Some(1.0);
        }
        shape.sized(size, kept, span)
    }
}

/// The asset of the geometry after an operation: the token of the file's name, while it is that asset or parts of it.
fn asset_after(row: &Operation, args: &[Arg], before: Option<u32>) -> Option<u32> {
    let inserted = row.params.iter().zip(args).find(|(param, _)| param.kind == ParamKind::File(FileUse::Inserted));
    match inserted {
        Some((_, name)) => matches!(name.value.kind, ExprKind::Text(_)).then_some(name.value.span.first),
        None => before.filter(|_| row.scope.keeps_geometry()),
    }
}

/// The join of the ends of several paths.
fn joined(ends: Vec<AbstractState>) -> Option<AbstractState> {
    ends.into_iter().reduce(|all, next| all.or(&next))
}

/// The name of the only successor of a slot, for messages.
pub(crate) fn called(ops: &[Op]) -> Option<&Name> {
    match ops {
        [Op { kind: OpKind::Call(name, _) | OpKind::Leaf(name), .. }] => Some(name),
        _ => None,
    }
}
