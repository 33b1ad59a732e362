//! A model of runs: shapes are boxes, sheets and what was flattened, and only sizes count. Splits go to the solver.

mod write;

use super::common::random::Random;
use cga_lang::ir::{
    Arg, Binary, CompArm, Expr, ExprKind, Grammar, Prefix, RuleId, Selector, Size, Split, Step, Target, Value,
};
use cga_lang::span::Span;
use cga_split::solve;

pub(crate) use write::write;

/// Rules that call each other deeper count as endless.
const DEEPEST: usize = 60;

/// Steps after which a run is broken off.
const MOST_STEPS: usize = 20_000;

/// Pieces of one split that are laid out.
const MOST_PIECES: u64 = 1000;

/// Shapes that are thinner are not divided.
const TOO_SMALL: f64 = 1e-4;

/// One slot in one split of a run.
#[derive(Debug)]
pub(crate) struct Slot {
    /// The last token of its size.
    pub(crate) token: u32,
    /// The number as written.
    pub(crate) value: f64,
    /// In metres; infinite for what floats.
    pub(crate) size: f64,
    pub(crate) pieces: Vec<f64>,
    pub(crate) extent: f64,
    /// What all slots get together.
    pub(crate) filled: f64,
    /// What share of its size the last piece of all gets.
    pub(crate) last: f64,
}

/// What was so in a run.
#[derive(Debug, Default)]
pub(crate) struct Facts {
    pub(crate) slots: Vec<Slot>,
    /// Of splits, by the token of the word.
    pub(crate) extents: Vec<(u32, f64)>,
    pub(crate) conditions: Vec<(Span, bool)>,
    pub(crate) rules: Vec<usize>,
    /// The first tokens of selectors that got something.
    pub(crate) selected: Vec<u32>,
    /// Whether it went too deep, or made too much.
    pub(crate) broken_off: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Box,
    /// A rectangle across z.
    Sheet,
    /// Something else, flat along some axes whatever the scope is.
    Flat([bool; 3]),
}

#[derive(Clone, Copy, Debug)]
struct Shape {
    size: [f64; 3],
    kind: Kind,
}

/// A run.
pub(crate) struct Model<'m> {
    grammar: &'m Grammar,
    random: &'m mut Random,
    facts: &'m mut Facts,
    attrs: Vec<f64>,
    steps: usize,
    ended: bool,
}

/// What a run computes with.
#[derive(Clone, Copy)]
struct Here<'h> {
    shape: Shape,
    params: &'h [f64],
}

impl<'m> Model<'m> {
    /// A run with the defaults of attributes, or with any values that a run accepts.
    pub(crate) fn new(grammar: &'m Grammar, random: &'m mut Random, facts: &'m mut Facts, defaults: bool) -> Self {
        let mut model = Model { grammar, random, facts, attrs: Vec::new(), steps: 0, ended: false };
        for attr in &grammar.attrs {
            let default = match attr.known {
                Some(Value::Float(value)) => value,
                _ => 0.0,
            };
            let value = match attr.range {
                _ if defaults => default,
                Some(range) => range.min + (range.max - range.min) * model.random.below(5) as f64 / 4.0,
                None => *model.random.pick(&[-3.0, 0.0, 0.01, 1.0, 2.5, 7.0, 1e3, 1e200, default]),
            };
            model.attrs.push(value);
        }
        model
    }

    /// Runs the start rule on some box.
    pub(crate) fn run(&mut self) {
        let mut size = || *self.random.pick(&[0.02, 0.5, 1.0, 2.0, 3.0, 5.0, 7.25, 10.0, 40.0]);
        let shape = Shape { size: [size(), size(), size()], kind: Kind::Box };
        if let Some(start) = self.grammar.starts.first() {
            self.rule(start.rule, &[], shape, 0);
        }
    }

    fn rule(&mut self, rule: RuleId, params: &[f64], shape: Shape, depth: usize) {
        let rule = rule.0 as usize;
        if DEEPEST < depth || MOST_STEPS < self.steps {
            self.facts.broken_off = true;
            self.ended = true;
        }
        if self.ended {
            return;
        }
        self.facts.rules.push(rule);
        let grammar = self.grammar;
        let mut shape = shape;
        self.sequence(&grammar.rules[rule].body, params, &mut shape, depth);
    }

    /// Says whether the end was reached.
    fn sequence(&mut self, steps: &[Step], params: &[f64], shape: &mut Shape, depth: usize) -> bool {
        for step in steps {
            self.steps += 1;
            if self.ended || !self.step(step, params, shape, depth) {
                return false;
            }
        }
        true
    }

    fn step(&mut self, step: &Step, params: &[f64], shape: &mut Shape, depth: usize) -> bool {
        match step {
            Step::Do(row, args, _) if row.name == "s" => self.resize(args, params, shape),
            Step::Do(row, args, _) if row.name == "extrude" => self.extrude(args, params, shape),
            Step::Give(target) => self.give(target, params, *shape, depth),
            Step::Split(split) => self.split(split, params, *shape, depth),
            Step::Comp(comp) => self.comp(&comp.arms, params, *shape, depth),
            Step::Push(inner) => _ = self.sequence(inner, params, &mut shape.clone(), depth),
            Step::Case { arms, otherwise } => {
                for (condition, body) in arms {
                    let truth = self.truth(condition, Here { shape: *shape, params });
                    if truth {
                        return self.sequence(body, params, shape, depth);
                    }
                }
                return self.sequence(otherwise, params, shape, depth);
            }
            other => panic!("the model has no {other:?}"),
        }
        true
    }

    fn give(&mut self, target: &Target, params: &[f64], shape: Shape, depth: usize) {
        if let Target::Rule { rule, args, .. } = target {
            let args: Vec<f64> = args.iter().map(|arg| self.number(arg, Here { shape, params })).collect();
            self.rule(*rule, &args, shape, depth + 1);
        }
    }

    fn resize(&mut self, args: &[Arg], params: &[f64], shape: &mut Shape) {
        let mut new = shape.size;
        for (axis, arg) in args.iter().enumerate() {
            let Arg::Length(Size { prefix, value }) = arg else { panic!("`s` takes lengths") };
            let value = finite(self.number(value, Here { shape: *shape, params }));
            new[axis] = if *prefix == Prefix::Relative { value * shape.size[axis] } else { value };
        }
        if !new.iter().all(|size| size.is_finite()) {
            return;
        }
        let flat = match shape.kind {
            Kind::Box => [false; 3],
            Kind::Sheet => [false, false, true],
            Kind::Flat(flat) => flat,
        };
        let now = [0, 1, 2].map(|axis| flat[axis] || new[axis] == 0.0);
        shape.kind = match shape.kind {
            Kind::Box if now == [false; 3] => Kind::Box,
            Kind::Sheet if now == [false, false, true] && new[2] == 0.0 => Kind::Sheet,
            _ => Kind::Flat(now),
        };
        shape.size = new;
    }

    fn extrude(&mut self, args: &[Arg], params: &[f64], shape: &mut Shape) {
        let Some(Arg::Length(Size { value, .. })) = args.first() else { panic!("`extrude` takes a length") };
        let by = finite(self.number(value, Here { shape: *shape, params }));
        let [x, y, z] = shape.size;
        *shape = match shape.kind {
            _ if by == 0.0 => *shape,
            Kind::Sheet if z == 0.0 && 0.0 <= x.min(y) => Shape { size: [x, by, y], kind: Kind::Box },
            _ => Shape { size: [x.abs(), y.abs() + by.abs(), z.abs()], kind: Kind::Flat([false; 3]) },
        };
    }

    fn split(&mut self, split: &Split, params: &[f64], shape: Shape, depth: usize) {
        let axis = split.axis as usize;
        let whole = shape.size[axis].abs();
        self.facts.extents.push((split.span.first, whole));
        let here = Here { shape, params };
        let values: Vec<f64> = split.sizes.iter().map(|size| self.number(&size.value, here)).collect();
        let extent = if TOO_SMALL < whole { whole } else { 0.0 };
        let sizes: Vec<cga_split::Size> = split
            .sizes
            .iter()
            .zip(&values)
            .map(|(size, value)| cga_split::Size { prefix: size.prefix, value: finite(*value) })
            .collect();
        let mut lengths = vec![0.0; sizes.len()];
        let solution = solve(&split.pattern, &sizes, &mut lengths, extent);
        if MOST_PIECES < solution.at_most() {
            self.facts.broken_off = true;
            self.ended = true;
            return;
        }
        let pieces = solution.pieces();
        let metres = |slot: usize| match sizes[slot].prefix {
            Prefix::Absolute => sizes[slot].value,
            Prefix::Relative => sizes[slot].value * extent,
            Prefix::Floating => f64::INFINITY,
        };
        let filled = pieces.iter().map(|piece| piece.length).sum();
        let last = pieces.last().map_or(0.0, |piece| piece.length / metres(piece.slot as usize));
        for (slot, size) in split.sizes.iter().enumerate() {
            let own = pieces.iter().filter(|piece| piece.slot as usize == slot);
            self.facts.slots.push(Slot {
                token: size.value.span.last,
                value: finite(values[slot]),
                size: metres(slot),
                pieces: own.map(|piece| piece.length).collect(),
                extent,
                filled: if extent == 0.0 { -1.0 } else { filled },
                last,
            });
        }
        for piece in pieces {
            let part = part(shape, axis, piece.start, piece.length);
            self.give(&split.slots[piece.slot as usize], params, part, depth);
        }
    }

    fn comp(&mut self, arms: &[CompArm<Target>], params: &[f64], shape: Shape, depth: usize) {
        let [x, y, z] = shape.size.map(f64::abs);
        let faces: Vec<(&str, [f64; 3])> = match shape.kind {
            Kind::Sheet => vec![("front", [x, y, 0.0])],
            _ => vec![
                ("bottom", [x, z, 0.0]),
                ("top", [x, z, 0.0]),
                ("front", [x, y, 0.0]),
                ("right", [z, y, 0.0]),
                ("back", [x, y, 0.0]),
                ("left", [z, y, 0.0]),
            ],
        };
        for (index, (side, size)) in faces.into_iter().enumerate() {
            let takes = |arm: &&CompArm<Target>| match &arm.selector {
                Selector::Word(word) => match *word {
                    "all" => true,
                    "side" | "vertical" => !matches!(side, "top" | "bottom"),
                    "horizontal" => matches!(side, "top" | "bottom"),
                    "aslant" => false,
                    word => word == side,
                },
                Selector::Index(at) => matches!(at.kind, ExprKind::Value(Value::Float(at)) if at == index as f64),
                Selector::When(_) => panic!("the model has no conditions"),
            };
            if size[0] == 0.0 || size[1] == 0.0 {
                continue;
            }
            if let Some(arm) = arms.iter().find(takes) {
                self.facts.selected.push(selector_token(arm));
                self.give(&arm.then, params, Shape { size, kind: Kind::Sheet }, depth);
            }
        }
    }

    fn truth(&mut self, expr: &Expr, here: Here) -> bool {
        let truth = match &expr.kind {
            ExprKind::Value(Value::Bool(truth)) => *truth,
            ExprKind::Not(operand) => !self.truth(operand, here),
            ExprKind::Binary(Binary::And, a, b) => self.truth(a, here) & self.truth(b, here),
            ExprKind::Binary(Binary::Or, a, b) => self.truth(a, here) | self.truth(b, here),
            ExprKind::Binary(op, a, b) => {
                let (a, b) = (self.number(a, here), self.number(b, here));
                // What is no number is less than anything.
                let odd = a.is_nan() || b.is_nan();
                match op {
                    Binary::Lt => a < b || odd,
                    Binary::Le => a <= b || odd,
                    Binary::Gt => a > b,
                    Binary::Ge => a >= b,
                    Binary::Eq => a == b,
                    _ => a != b,
                }
            }
            other => panic!("no condition: {other:?}"),
        };
        self.facts.conditions.push((expr.span, truth));
        truth
    }

    fn number(&mut self, expr: &Expr, here: Here) -> f64 {
        match &expr.kind {
            ExprKind::Value(Value::Float(value)) => *value,
            ExprKind::Param(index) => here.params[*index as usize],
            ExprKind::Attr(id) => self.attrs[id.0 as usize],
            ExprKind::Const(id) => {
                let grammar = self.grammar;
                self.number(&grammar.consts[id.0 as usize].value, here)
            }
            ExprKind::Shape(row) => {
                here.shape.size[["scope.sx", "scope.sy", "scope.sz"]
                    .iter()
                    .position(|name| *name == row.name)
                    .expect("a size of the scope")]
            }
            ExprKind::Neg(operand) => -self.number(operand, here),
            ExprKind::Binary(op, a, b) => {
                let (a, b) = (self.number(a, here), self.number(b, here));
                match op {
                    Binary::Add => a + b,
                    Binary::Sub => a - b,
                    Binary::Mul => a * b,
                    Binary::Div => a / b,
                    _ => a % b,
                }
            }
            ExprKind::Case(arms, otherwise) => {
                for (condition, value) in arms {
                    if self.truth(condition, here) {
                        return self.number(value, here);
                    }
                }
                self.number(otherwise, here)
            }
            ExprKind::Builtin(row, args) => {
                let args: Vec<f64> = args.iter().map(|arg| self.number(arg, here)).collect();
                match (row.name, args.as_slice()) {
                    ("min", [a, b]) => a.min(*b),
                    ("max", [a, b]) => a.max(*b),
                    // What is not finite counts as zero.
                    ("abs" | "floor", [a]) if !a.is_finite() => 0.0,
                    ("abs", [a]) => a.abs(),
                    ("floor", [a]) => a.floor(),
                    ("rand", [a, b]) => a + (b - a) * self.random.below(9) as f64 / 8.0,
                    other => panic!("the model has no {other:?}"),
                }
            }
            other => panic!("no number: {other:?}"),
        }
    }
}

/// The first token of a selector: its target's rule or leaf stands behind it.
fn selector_token(arm: &CompArm<Target>) -> u32 {
    let target = match &arm.then {
        Target::Rule { span, .. } | Target::Leaf(_, span) => span.first,
        Target::Nil => return u32::MAX,
    };
    // `selector :` come before it.
    target - 2
}

fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}

fn part(shape: Shape, axis: usize, start: f64, length: f64) -> Shape {
    let mut size = shape.size;
    size[axis] = length.copysign(shape.size[axis]);
    let flat = match shape.kind {
        Kind::Box => return Shape { size, ..shape },
        Kind::Sheet if axis != 2 => return Shape { size, ..shape },
        Kind::Sheet => [false, false, true],
        Kind::Flat(flat) => flat,
    };
    // Parts shrink to what is in them; what is flat lies at the low end, and the others are empty.
    if flat[axis] && start != 0.0 {
        return Shape { size, kind: Kind::Flat(flat) };
    }
    for (size, flat) in size.iter_mut().zip(flat) {
        *size = if flat { 0.0 } else { *size };
    }
    Shape { size, kind: Kind::Flat(flat) }
}
