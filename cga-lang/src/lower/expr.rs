//! Expressions, bottom up: each knows its type.

use super::{Lower, block};
use crate::ir::{Binary, EachUnary, Expr, ExprKind, FunctionId, GlobalId, Type, Value};
use crate::ops;
use crate::resolve::tables::Use;
use crate::span::Span;
use crate::syntax::ast::{self, Unary};

impl Lower<'_> {
    pub(super) fn expr(&mut self, expr: &ast::Expr) -> Expr {
        let (kind, ty) = match &expr.kind {
            ast::ExprKind::Number(value) => (ExprKind::Value(Value::Float(*value)), Type::Float),
            ast::ExprKind::Bool(value) => (ExprKind::Value(Value::Bool(*value)), Type::Bool),
            ast::ExprKind::Text(text) => (ExprKind::Value(Value::Text(text.clone())), Type::Text),
            ast::ExprKind::Host(_) => match self.hosts.get(&(self.own, expr.span.first)) {
                Some(&host) => (ExprKind::Host(host), self.ty(expr.span.first)),
                None => nothing(),
            },
            ast::ExprKind::Name(name) => match self.used(name) {
                Some(Use::Selector(word)) => (block::word(word, name.span), Type::Bool),
                found => self.used_value(found, Vec::new()),
            },
            ast::ExprKind::Call(name, args) => {
                let found = self.used(name);
                let args = match found {
                    Some(Use::Builtin(row)) => self.builtin_args(row, args),
                    _ => self.exprs(args),
                };
                self.used_value(found, args)
            }
            ast::ExprKind::Path(name, args) => {
                (ExprKind::Rust(name.text.clone(), self.exprs(args)), self.ty(name.id()))
            }
            ast::ExprKind::Unary(Unary::Plus, operand) => return self.expr(operand),
            ast::ExprKind::Unary(Unary::Minus, operand) => (ExprKind::Neg(Box::new(self.expr(operand))), Type::Float),
            ast::ExprKind::Unary(Unary::Not, operand) => (ExprKind::Not(Box::new(self.expr(operand))), Type::Bool),
            ast::ExprKind::Binary(op, _, left, right) => {
                let (left, right) = (self.expr(left), self.expr(right));
                binary(*op, left, right)
            }
            ast::ExprKind::Chain(first, links) => return self.chain(first, links),
            ast::ExprKind::Case(arms, otherwise) => {
                let arms: Vec<(Expr, Expr)> =
                    arms.iter().map(|(test, value)| (self.expr(test), self.expr(value))).collect();
                let otherwise = self.expr(otherwise);
                let ty = otherwise.ty;
                (ExprKind::Case(arms, Box::new(otherwise)), ty)
            }
            ast::ExprKind::Chance(arms, otherwise) => {
                let draws = draws(arms.iter().map(|(percent, _)| percent));
                let arms = draws.zip(arms).map(|(draw, (_, value))| (draw, self.expr(value))).collect();
                let otherwise = self.expr(otherwise);
                let ty = otherwise.ty;
                (ExprKind::Case(arms, Box::new(otherwise)), ty)
            }
            ast::ExprKind::EachUnary(Unary::Plus, operand) => return self.expr(operand),
            ast::ExprKind::EachUnary(op, operand) => {
                let operand = self.expr(operand);
                let (op, ty) = (if *op == Unary::Not { EachUnary::Not } else { EachUnary::Neg }, operand.ty);
                (ExprKind::EachUnary(op, Box::new(operand)), ty)
            }
            ast::ExprKind::Each(op, _, left, right) => {
                let (left, right) = (self.expr(left), self.expr(right));
                each(*op, left, right)
            }
            ast::ExprKind::Array(rows) => {
                let rows: Vec<Vec<Expr>> = rows.iter().map(|row| self.exprs(row)).collect();
                let ty = rows.iter().flatten().next().map_or(Type::Floats, |first| first.ty.array());
                (ExprKind::Array(rows), ty)
            }
            ast::ExprKind::Range(base, step, limit) => {
                let base = self.expr(base);
                let step = match step {
                    Some(step) => self.expr(step),
                    None => Expr { kind: ExprKind::Value(Value::Float(1.0)), ty: Type::Float, span: expr.span },
                };
                let limit = self.expr(limit);
                (ExprKind::Range(Box::new(base), Box::new(step), Box::new(limit)), Type::Floats)
            }
            ast::ExprKind::Index(array, indices) => {
                let (array, indices) = (self.expr(array), self.exprs(indices));
                let many = indices.iter().any(|index| index.ty.is_array());
                let ty = if many { array.ty } else { array.ty.element() };
                (ExprKind::Index(Box::new(array), indices), ty)
            }
            ast::ExprKind::Comp(comp) => self.comp_value(comp).unwrap_or_else(nothing),
            ast::ExprKind::Error => nothing(),
        };
        Expr { kind, ty, span: expr.span }
    }

    /// Many operators in a row. Before the first operand that is text, the result so far becomes text.
    fn chain(&mut self, first: &ast::Expr, links: &[ast::Link]) -> Expr {
        let mut all = self.expr(first);
        let mut row: Vec<(Binary, Expr)> = Vec::new();
        let closed = |all: Expr, row: Vec<(Binary, Expr)>| {
            let Some((_, last)) = row.last() else { return all };
            let (ty, span) = (all.ty, all.span.to(last.span));
            Expr { kind: ExprKind::Chain(Box::new(all), row), ty, span }
        };
        for ast::Link { op, operand, .. } in links {
            let operand = self.expr(operand);
            let is_text = *op == Binary::Add && (all.ty == Type::Text || operand.ty == Type::Text);
            if is_text && all.ty != Type::Text {
                all = *text(closed(all, std::mem::take(&mut row)));
            }
            row.push((*op, if is_text { *text(operand) } else { operand }));
        }
        closed(all, row)
    }

    pub(super) fn exprs(&mut self, list: &[ast::Expr]) -> Vec<Expr> {
        list.iter().map(|expr| self.expr(expr)).collect()
    }

    /// Words among the arguments are text from here on.
    fn builtin_args(&mut self, row: &'static ops::Function, args: &[ast::Expr]) -> Vec<Expr> {
        let own = args.iter().zip(row.params).map(|(arg, param)| match (arg.word(), &param.kind) {
            (Some(word), ops::ParamKind::Word(_) | ops::ParamKind::Selector) => {
                Expr { kind: ExprKind::Value(Value::Text(word.to_owned())), ty: Type::Text, span: arg.span }
            }
            (_, kind) if kind.is_file() => {
                let name = self.expr(arg);
                self.in_folder(name)
            }
            _ => self.expr(arg),
        });
        own.collect()
    }

    /// The name of a file, with the folder of the rule file that it is written in.
    pub(super) fn in_folder(&self, name: Expr) -> Expr {
        let (ty, span) = (name.ty, name.span);
        let folder = self.checked.globals.program.folder(span.first).to_owned();
        Expr { kind: ExprKind::File(Box::new(name), folder), ty, span }
    }

    /// A call of a function of the language. Omitted arguments get their defaults.
    fn builtin(row: &'static ops::Function, mut args: Vec<Expr>) -> (ExprKind, Type) {
        let span = args.last().map_or_else(Span::default, |last| last.span);
        args.extend(row.params.iter().skip(args.len()).filter_map(|param| default(param, span)));
        (ExprKind::Builtin(row, args), row.ty)
    }

    fn used_value(&self, found: Option<Use>, mut args: Vec<Expr>) -> (ExprKind, Type) {
        let globals = &self.checked.globals;
        match found {
            Some(Use::Param(index)) => (ExprKind::Param(index), self.ty(self.inner[index as usize].id())),
            Some(Use::Attr(index)) => (ExprKind::Global(GlobalId(index)), self.type_of(&globals.attrs[index as usize])),
            Some(Use::Const(index)) => {
                let id = GlobalId(globals.attrs.len() as u32 + index);
                (ExprKind::Global(id), self.type_of(&globals.consts[index as usize]))
            }
            Some(Use::Function(index)) => {
                (ExprKind::Call(FunctionId(index), Vec::new(), args), self.type_of(&globals.functions[index as usize]))
            }
            Some(Use::Builtin(row)) => Self::builtin(row, args),
            Some(Use::Shape(row)) => (ExprKind::Shape(row), row.ty()),
            Some(Use::Convert(ty)) => match args.pop() {
                Some(arg) => convert(arg, ty),
                None => nothing(),
            },
            _ => nothing(),
        }
    }
}

/// The default of an omitted argument; words are text.
pub(super) fn default(param: &ops::Param, span: Span) -> Option<Expr> {
    let value = match param.default? {
        ops::Default::Float(number) => Value::Float(number),
        ops::Default::Bool(truth) => Value::Bool(truth),
        ops::Default::Text(text) | ops::Default::Word(text) => Value::Text(text.into()),
    };
    Some(Expr { ty: value.ty(), kind: ExprKind::Value(value), span })
}

/// The conditions of branches with percentages.
pub(super) fn draws<'c>(percents: impl Iterator<Item = &'c ast::Percent>) -> impl Iterator<Item = Expr> {
    percents.scan(0.0, |sum, percent| {
        let before = *sum;
        *sum += percent.value;
        let kind = ExprKind::Chance { percent: percent.value, before };
        Some(Expr { kind, ty: Type::Bool, span: percent.span })
    })
}

fn each(op: Binary, left: Expr, right: Expr) -> (ExprKind, Type) {
    if !left.ty.is_array() && !right.ty.is_array() {
        return binary(op, left, right);
    }
    let is_text = [left.ty, right.ty].iter().any(|ty| ty.element() == Type::Text);
    let ty = match op {
        Binary::Add if is_text => Type::Texts,
        Binary::Add | Binary::Sub | Binary::Mul | Binary::Div | Binary::Rem => Type::Floats,
        _ => Type::Bools,
    };
    (ExprKind::Each(op, Box::new(left), Box::new(right)), ty)
}

/// Stands for what a check has refused; it never gets here.
fn nothing() -> (ExprKind, Type) {
    (ExprKind::Value(Value::Float(0.0)), Type::Float)
}

fn convert(arg: Expr, ty: Type) -> (ExprKind, Type) {
    if arg.ty == ty {
        return (arg.kind, ty);
    }
    let name = match ty {
        Type::Text => return (ExprKind::ToText(Box::new(arg)), ty),
        Type::Float => "float",
        Type::Bool => "bool",
        Type::Floats => "floatArray",
        Type::Bools => "boolArray",
        Type::Texts => "stringArray",
    };
    match ops::functions(name).find(|row| matches!(row.params, [param] if param.kind == ops::ParamKind::Value(arg.ty)))
    {
        Some(row) => (ExprKind::Builtin(row, vec![arg]), ty),
        None => (arg.kind, ty),
    }
}

fn text(expr: Expr) -> Box<Expr> {
    let span = expr.span;
    let (kind, ty) = convert(expr, Type::Text);
    Box::new(Expr { kind, ty, span })
}

fn binary(op: Binary, left: Expr, right: Expr) -> (ExprKind, Type) {
    if op == Binary::Add && (left.ty == Type::Text || right.ty == Type::Text) {
        return (ExprKind::Binary(Binary::Add, text(left), text(right)), Type::Text);
    }
    let ty = match op {
        Binary::Add | Binary::Sub | Binary::Mul | Binary::Div | Binary::Rem => Type::Float,
        _ => Type::Bool,
    };
    (ExprKind::Binary(op, Box::new(left), Box::new(right)), ty)
}
