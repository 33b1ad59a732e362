//! Steps of a rule. Blocks of splits and comps that do more than name a successor become rules of their own.

use super::{Lower, walk};
use crate::ast::{self, BlockPart, OpKind, SplitItem};
use crate::fold::fold;
use crate::ir::{
    Arg, AttrId, Axis, Childless, Expr, ExprKind, Item, Measure, Param, Prefix, Rule, RuleId, Size, Split, Step,
    Target, TextureSplit, Type, Value,
};
use crate::ops::{self, Braces, ParamKind, Run, Words};
use crate::resolve::tables::Use;
use crate::span::Span;

impl<'c> Lower<'c> {
    pub(super) fn steps(&mut self, ops: &'c [ast::Op]) -> Vec<Step> {
        ops.iter().filter_map(|op| self.step(op)).collect()
    }

    fn step(&mut self, op: &'c ast::Op) -> Option<Step> {
        Some(match &op.kind {
            OpKind::Call(name, args) => return self.call(op.span, name, args),
            OpKind::Leaf(name) => Step::Give(Target::Leaf(name.text.clone(), name.span)),
            OpKind::Nil => Step::Give(Target::Nil),
            OpKind::Path(name, args) => Step::Rust(name.text.clone(), self.values(args), name.span),
            OpKind::Push(ops) => Step::Push(self.steps(ops)),
            OpKind::Block(block) => return self.divided(block, op.span),
            OpKind::Dynamic { import, overrides, rule, args } => {
                return self.dynamic((import, overrides), (rule, args), op.span);
            }
            OpKind::Case(arms, otherwise) => Step::Case {
                arms: arms.iter().map(|(test, ops)| (self.folded(test), self.steps(ops))).collect(),
                otherwise: self.steps(otherwise),
            },
            OpKind::Chance(arms, otherwise) => Step::Chance {
                arms: arms.iter().map(|(percent, ops)| (percent.value, self.steps(ops))).collect(),
                otherwise: self.steps(otherwise),
            },
            OpKind::Error => return None,
        })
    }

    pub(super) fn folded(&mut self, expr: &ast::Expr) -> Expr {
        let mut expr = self.expr(expr);
        fold(&mut expr, &self.known);
        expr
    }

    /// The name of a file, with the folder of the rule file that it is written in.
    fn file(&mut self, expr: &ast::Expr) -> Expr {
        let name = self.folded(expr);
        self.in_folder(name)
    }

    fn values(&mut self, args: &[ast::Arg]) -> Vec<Expr> {
        args.iter().map(|arg| self.folded(&arg.value)).collect()
    }

    fn size(&mut self, arg: &ast::Arg) -> Size {
        let prefix = match arg.prefix {
            None => Prefix::Absolute,
            Some((ast::Prefix::Relative, _)) => Prefix::Relative,
            Some((ast::Prefix::Floating, _)) => Prefix::Floating,
        };
        Size { prefix, value: self.folded(&arg.value) }
    }

    fn call(&mut self, span: Span, name: &'c ast::Name, args: &'c [ast::Arg]) -> Option<Step> {
        if self.is_later(name) {
            return Some(Step::Later(name.text.clone(), span));
        }
        Some(match self.used(name)? {
            Use::Operation(row) if row.run == Run::Later => Step::Later(name.text.clone(), span),
            Use::Operation(row) => {
                let left_out = row.params.iter().skip(args.len()).filter_map(|param| default(param, span));
                let args = row.params.iter().zip(args).map(|(param, arg)| match &param.kind {
                    ParamKind::Value(_) | ParamKind::Any | ParamKind::Color | ParamKind::Channel => {
                        Arg::Value(self.folded(&arg.value))
                    }
                    ParamKind::File(_) | ParamKind::Image(_) => Arg::Value(self.file(&arg.value)),
                    ParamKind::Length | ParamKind::Size => Arg::Length(self.size(arg)),
                    ParamKind::Selector | ParamKind::PerEdge => Arg::Value(self.folded(&arg.value)),
                    ParamKind::Word(words) => Arg::Word(word(arg, words)),
                });
                Step::Do(row, args.collect::<Vec<_>>().into_iter().chain(left_out).collect(), span)
            }
            Use::SetAttr(index) => {
                self.out.attrs[index as usize].is_set = true;
                Step::SetAttr(AttrId(index), self.folded(&args.get(1)?.value), span)
            }
            Use::SetShape(row) if row.set == Some(Run::Later) => Step::Later(format!("set({})", row.name), span),
            Use::SetShape(row) if row.kind.is_file() => Step::SetShape(row, self.file(&args.get(1)?.value), span),
            Use::SetShape(row) => Step::SetShape(row, self.folded(&args.get(1)?.value), span),
            _ => Step::Give(self.successor(name, args)?),
        })
    }

    pub(super) fn successor(&mut self, name: &'c ast::Name, args: &'c [ast::Arg]) -> Option<Target> {
        match self.used(name)? {
            Use::Rule(index) => Some(Target::Rule { rule: RuleId(index), args: self.values(args), span: name.span }),
            Use::Leaf => Some(Target::Leaf(name.text.clone(), name.span)),
            _ => None,
        }
    }

    fn divided(&mut self, block: &'c ast::Block, span: Span) -> Option<Step> {
        let Use::Operation(row) = self.used(&block.name)? else { return None };
        let later = || Step::Later(block.name.text.clone(), span);
        Some(match (row.run, row.braces, block.parts.as_slice()) {
            (Run::Now(_), Braces::Slots(measure), [BlockPart::Slots(items, repeat)]) => {
                Step::Split(self.split(block, measure, items, *repeat))
            }
            (Run::Now(_), Braces::Components, [BlockPart::Arms(arms)]) => Step::Comp(self.comp(block, arms)?),
            _ => later(),
        })
    }

    fn split(&mut self, block: &'c ast::Block, measure: ops::Measure, items: &'c [SplitItem], repeat: bool) -> Split {
        let span = block.name.span;
        let measure = match measure {
            ops::Measure::Length => Measure::Length,
            ops::Measure::Area => Measure::Area,
            ops::Measure::Texture => {
                let word = |at: usize| block.args.get(at).and_then(|arg| arg.value.word());
                let set = match block.args.get(2) {
                    Some(set) => self.folded(&set.value),
                    None => Expr { kind: ExprKind::Value(Value::Float(0.0)), ty: Type::Float, span },
                };
                let (along_v, in_metres) = (word(0) == Some("v"), word(1) == Some("unitSpace"));
                Measure::Texture(TextureSplit { along_v, in_metres, set })
            }
        };
        let mut out = Split {
            axis: block.axis().unwrap_or(Axis::X),
            measure,
            adjust: block.adjusts(),
            sizes: Vec::new(),
            pattern: Vec::new(),
            slots: Vec::new(),
            solved: None,
            span,
        };
        self.group(items, repeat, &mut out);
        out
    }

    fn group(&mut self, items: &'c [SplitItem], repeat: bool, out: &mut Split) {
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
                    let target = self.block(ops, block_span(ops, out.span));
                    out.slots.push(target);
                }
                SplitItem::Group(items, repeat) => self.group(items, *repeat, out),
            }
        }
        if repeat {
            out.pattern[start] = Item::Repeat((out.pattern.len() - start - 1) as u32);
        }
    }

    /// What a part becomes: a lone successor, leaf or `NIL` is that, anything else a rule of its own.
    pub(super) fn block(&mut self, ops: &'c [ast::Op], span: Span) -> Target {
        if let [op] = ops {
            match &op.kind {
                OpKind::Leaf(name) => return Target::Leaf(name.text.clone(), name.span),
                OpKind::Nil => return Target::Nil,
                OpKind::Call(name, args) => {
                    if let Some(target) = self.successor(name, args) {
                        return target;
                    }
                }
                _ => {}
            }
        }
        let count = self.blocks.entry(self.name.clone()).or_default();
        *count += 1;
        let name = format!("{}/{count}", self.name);
        let rule = RuleId(self.out.rules.len() as u32);
        self.out.rules.push(Rule {
            name,
            label: self.label.clone(),
            params: Vec::new(),
            locals: Vec::new(),
            body: Vec::new(),
            block: true,
            leaf: Childless::Always,
            cycle: None,
            source: String::new(),
            span,
        });
        let mut body = self.steps(ops);
        let captured = capture(&mut body);
        let own = |&index: &u32| {
            let name = self.inner[index as usize];
            Param { name: name.text.clone(), ty: self.ty(name.id()), span: name.span }
        };
        let params: Vec<Param> = captured.iter().map(own).collect();
        let pass = |(index, param): (&u32, &Param)| Expr { kind: ExprKind::Param(*index), ty: param.ty, span };
        let args = captured.iter().zip(&params).map(pass).collect();
        self.out.rules[rule.0 as usize].params = params;
        self.finish(rule.0 as usize, body);
        Target::Rule { rule, args, span }
    }
}

/// Numbers the parameters a body reads anew, without gaps; returns the old numbers in order.
fn capture(body: &mut [Step]) -> Vec<u32> {
    let mut captured = Vec::new();
    walk::exprs(body, &mut |expr| walk::params(expr, &mut |index| captured.push(*index)));
    captured.sort_unstable();
    captured.dedup();
    walk::exprs(body, &mut |expr| {
        walk::params(expr, &mut |index| {
            *index = captured.binary_search(index).unwrap_or_default() as u32;
        });
    });
    captured
}

/// What counts for an argument that was left out.
fn default(param: &ops::Param, span: Span) -> Option<Arg> {
    let value = |value, ty| Expr { kind: ExprKind::Value(value), ty, span };
    let value = match param.default? {
        ops::Default::Float(number) => value(Value::Float(number), Type::Float),
        ops::Default::Bool(truth) => value(Value::Bool(truth), Type::Bool),
        ops::Default::Text(text) => value(Value::Text(text.into()), Type::Text),
        ops::Default::Word(word) => return Some(Arg::Word(word)),
    };
    Some(match param.kind {
        ParamKind::Length | ParamKind::Size => Arg::Length(Size { prefix: Prefix::Absolute, value }),
        _ => Arg::Value(value),
    })
}

/// Where a block stands: its first token, else what it belongs to.
pub(super) fn block_span(ops: &[ast::Op], owner: Span) -> Span {
    ops.first().map_or(owner, |op| Span::one(op.span.first))
}

fn word(arg: &ast::Arg, words: &Words) -> &'static str {
    let text = arg.value.word().unwrap_or_default();
    words.list.iter().copied().find(|word| *word == text).unwrap_or_default()
}
