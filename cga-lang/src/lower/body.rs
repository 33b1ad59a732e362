//! Steps of a rule. Operations of a part in braces become a rule of their own, unless they only name a successor.

use super::{Lower, expr};
use crate::ir::{Arg, Expr, ExprKind, GlobalId, Param, Prefix, Rule, RuleId, Size, Step, StepKind, Target, walk};
use crate::lower::fold::fold;
use crate::ops::{self, Operation, ParamKind, Words};
use crate::resolve::tables::Use;
use crate::span::Span;
use crate::syntax::ast::{self, OpKind};

impl<'c> Lower<'c> {
    pub(super) fn steps(&mut self, ops: &'c [ast::Op]) -> Vec<Step> {
        ops.iter().filter_map(|op| self.step(op)).collect()
    }

    fn step(&mut self, op: &'c ast::Op) -> Option<Step> {
        let kind = match &op.kind {
            OpKind::Call(name, args) => self.call(op.span, name, args)?,
            OpKind::Leaf(name) => StepKind::Give(Target::Leaf(name.text.clone())),
            OpKind::Nil => StepKind::Give(Target::Nil),
            OpKind::Path(name, args) => StepKind::Rust(name.text.clone(), self.values(args)),
            OpKind::Push(ops) => StepKind::Push(self.steps(ops)),
            OpKind::Block(block) => self.block(block)?,
            OpKind::Dynamic { import, overrides, rule, args } => self.dynamic((import, overrides), (rule, args))?,
            OpKind::Case(arms, otherwise) => StepKind::Case {
                arms: arms.iter().map(|(test, ops)| (self.folded(test), self.steps(ops))).collect(),
                otherwise: self.steps(otherwise),
            },
            OpKind::Chance(arms, otherwise) => {
                let draws = expr::draws(arms.iter().map(|(percent, _)| percent));
                let arms = draws.zip(arms).map(|(draw, (_, ops))| (draw, self.steps(ops))).collect();
                StepKind::Case { arms, otherwise: self.steps(otherwise) }
            }
            OpKind::Error => return None,
        };
        Some(Step { kind, span: op.span })
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

    pub(super) fn size(&mut self, arg: &ast::Arg) -> Size {
        let prefix = match arg.prefix {
            None => Prefix::Absolute,
            Some((ast::Prefix::Relative, _)) => Prefix::Relative,
            Some((ast::Prefix::Floating, _)) => Prefix::Floating,
        };
        Size { prefix, value: self.folded(&arg.value) }
    }

    /// The arguments of an operation, with the defaults of those that are left out.
    pub(super) fn args(&mut self, row: &'static Operation, args: &[ast::Arg], span: Span) -> Vec<Arg> {
        let given = row.params.iter().zip(args).map(|(param, arg)| match &param.kind {
            ParamKind::Value(_) | ParamKind::Any | ParamKind::Color | ParamKind::Channel | ParamKind::Selector => {
                Arg::Value(self.folded(&arg.value))
            }
            ParamKind::PerEdge => Arg::Value(self.per_edge(&arg.value)),
            ParamKind::File(_) | ParamKind::Files(_) | ParamKind::Image(_) => Arg::Value(self.file(&arg.value)),
            ParamKind::Length | ParamKind::Size => Arg::Length(self.size(arg)),
            ParamKind::Word(words) => Arg::Word(word(&arg.value, words)),
        });
        let mut list: Vec<Arg> = given.collect();
        list.extend(row.params.iter().skip(args.len()).filter_map(|param| default(param, span)));
        list
    }

    fn call(&mut self, span: Span, name: &'c ast::Name, args: &'c [ast::Arg]) -> Option<StepKind> {
        Some(match self.used(name)? {
            Use::Operation(row) => StepKind::Do(row, self.args(row, args, span)),
            Use::SetAttr(index) => {
                self.out.globals[index as usize].is_set = true;
                StepKind::SetAttr(GlobalId(index), self.folded(&args.get(1)?.value))
            }
            Use::SetShape(row) if row.kind.is_file() => StepKind::SetShape(row, self.file(&args.get(1)?.value)),
            Use::SetShape(row) => StepKind::SetShape(row, self.folded(&args.get(1)?.value)),
            _ => StepKind::Give(self.successor(name, args)?),
        })
    }

    pub(super) fn successor(&mut self, name: &'c ast::Name, args: &'c [ast::Arg]) -> Option<Target> {
        match self.used(name)? {
            Use::Rule(index) => {
                Some(Target::Rule { rule: RuleId(index), sites: Vec::new(), args: self.values(args), span: name.span })
            }
            Use::Leaf => Some(Target::Leaf(name.text.clone())),
            _ => None,
        }
    }

    /// The successor of a part: a lone successor, leaf or `NIL` is that, anything else a rule of its own.
    pub(super) fn part(&mut self, ops: &'c [ast::Op], owner: Span) -> Target {
        let span = ops.first().map_or(owner, |op| Span::one(op.span.first));
        if let [op] = ops {
            match &op.kind {
                OpKind::Leaf(name) => return Target::Leaf(name.text.clone()),
                OpKind::Nil => return Target::Nil,
                OpKind::Call(name, args) => {
                    if let Some(target) = self.successor(name, args) {
                        return target;
                    }
                }
                _ => {}
            }
        }
        self.block_rule(span, |lower| lower.steps(ops))
    }

    /// A rule of its own for steps in braces, with the parameters that they read.
    pub(super) fn block_rule(&mut self, span: Span, steps: impl FnOnce(&mut Self) -> Vec<Step>) -> Target {
        let count = self.blocks.entry(self.name.clone()).or_default();
        *count += 1;
        let name = format!("{}/{count}", self.name);
        let rule = RuleId(self.out.rules.len() as u32);
        self.out.rules.push(Rule { name, label: self.label.clone(), block: true, span, ..Rule::default() });
        let mut body = steps(self);
        let captured = capture(&mut body);
        let own = |&index: &u32| {
            let name = self.inner[index as usize];
            Param { name: name.text.clone(), ty: self.ty(name.id()) }
        };
        let params: Vec<Param> = captured.iter().map(own).collect();
        let pass = |(index, param): (&u32, &Param)| Expr { kind: ExprKind::Param(*index), ty: param.ty, span };
        let args = captured.iter().zip(&params).map(pass).collect();
        self.out.rules[rule.0 as usize].params = params;
        self.finish(rule.0 as usize, body);
        Target::Rule { rule, sites: Vec::new(), args, span }
    }
}

/// Renumbers the parameters that a body reads, without gaps; returns the old numbers in order.
fn capture(body: &mut [Step]) -> Vec<u32> {
    let mut captured = Vec::new();
    walk::exprs_mut(body, &mut |expr| walk::params_mut(expr, &mut |index| captured.push(*index)));
    captured.sort_unstable();
    captured.dedup();
    walk::exprs_mut(body, &mut |expr| {
        walk::params_mut(expr, &mut |index| *index = captured.binary_search(index).unwrap_or_default() as u32);
    });
    captured
}

/// The default of an omitted argument.
fn default(param: &ops::Param, span: Span) -> Option<Arg> {
    if let ops::Default::Word(word) = param.default? {
        return Some(Arg::Word(word));
    }
    let value = expr::default(param, span)?;
    Some(match param.kind {
        ParamKind::Length | ParamKind::Size => Arg::Length(Size { prefix: Prefix::Absolute, value }),
        _ => Arg::Value(value),
    })
}

/// The word in an argument.
fn word(arg: &ast::Expr, words: &Words) -> &'static str {
    let text = arg.word().unwrap_or_default();
    words.list.iter().copied().find(|word| *word == text).unwrap_or_default()
}
