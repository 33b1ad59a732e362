//! Expressions, bottom up: each knows its type.

use super::Lower;
use crate::ast::{self, Unary};
use crate::check::Use;
use crate::ir::{AttrId, Binary, ConstId, Expr, ExprKind, FunctionId, Type, Value};
use crate::ops;

impl Lower<'_> {
    pub(super) fn expr(&mut self, expr: &ast::Expr) -> Expr {
        let (kind, ty) = match &expr.kind {
            ast::ExprKind::Number(value) => (ExprKind::Value(Value::Float(*value)), Type::Float),
            ast::ExprKind::Bool(value) => (ExprKind::Value(Value::Bool(*value)), Type::Bool),
            ast::ExprKind::Text(text) => (ExprKind::Value(Value::Text(text.clone())), Type::Text),
            ast::ExprKind::Host(_) => match self.hosts.get(&expr.span.first) {
                Some(&host) => (ExprKind::Host(host), self.ty(expr.span.first)),
                None => nothing(),
            },
            ast::ExprKind::Name(name) => self.used_value(self.used(name), Vec::new()),
            ast::ExprKind::Call(name, args) => {
                let args = self.exprs(args);
                self.used_value(self.used(name), args)
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
            ast::ExprKind::Case(arms, otherwise) => {
                let arms: Vec<(Expr, Expr)> =
                    arms.iter().map(|(test, value)| (self.expr(test), self.expr(value))).collect();
                let otherwise = self.expr(otherwise);
                let ty = otherwise.ty;
                (ExprKind::Case(arms, Box::new(otherwise)), ty)
            }
            ast::ExprKind::Chance(arms, otherwise) => {
                let arms = arms.iter().map(|(percent, value)| (percent.value, self.expr(value))).collect();
                let otherwise = self.expr(otherwise);
                let ty = otherwise.ty;
                (ExprKind::Chance(arms, Box::new(otherwise)), ty)
            }
            ast::ExprKind::Error
            | ast::ExprKind::EachUnary(..)
            | ast::ExprKind::Each(..)
            | ast::ExprKind::Array(_)
            | ast::ExprKind::Range(..)
            | ast::ExprKind::Index(..)
            | ast::ExprKind::Comp(_) => nothing(),
        };
        Expr { kind, ty, span: expr.span }
    }

    pub(super) fn exprs(&mut self, list: &[ast::Expr]) -> Vec<Expr> {
        list.iter().map(|expr| self.expr(expr)).collect()
    }

    fn used_value(&self, found: Option<Use>, mut args: Vec<Expr>) -> (ExprKind, Type) {
        let globals = &self.checked.globals;
        match found {
            Some(Use::Param(index)) => (ExprKind::Param(index), self.ty(self.params[index as usize].id())),
            Some(Use::Attr(index)) => (ExprKind::Attr(AttrId(index)), self.ty(globals.attrs[index as usize].name.id())),
            Some(Use::Const(index)) => {
                (ExprKind::Const(ConstId(index)), self.ty(globals.consts[index as usize].name.id()))
            }
            Some(Use::Function(index)) => {
                (ExprKind::Call(FunctionId(index), args), self.ty(globals.functions[index as usize].name.id()))
            }
            Some(Use::Builtin(row)) => (ExprKind::Builtin(row, args), row.ty),
            Some(Use::Shape(row)) => (ExprKind::Shape(row), row.ty),
            Some(Use::Convert(ty)) => match args.pop() {
                Some(arg) => convert(arg, ty),
                None => nothing(),
            },
            _ => nothing(),
        }
    }
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

fn binary(op: ast::Binary, left: Expr, right: Expr) -> (ExprKind, Type) {
    let (op, ty) = match op {
        ast::Binary::Add if left.ty == Type::Text || right.ty == Type::Text => {
            return (ExprKind::Binary(Binary::Concat, text(left), text(right)), Type::Text);
        }
        ast::Binary::Add => (Binary::Add, Type::Float),
        ast::Binary::Sub => (Binary::Sub, Type::Float),
        ast::Binary::Mul => (Binary::Mul, Type::Float),
        ast::Binary::Div => (Binary::Div, Type::Float),
        ast::Binary::Rem => (Binary::Rem, Type::Float),
        ast::Binary::Eq => (Binary::Eq, Type::Bool),
        ast::Binary::Ne => (Binary::Ne, Type::Bool),
        ast::Binary::Lt => (Binary::Lt, Type::Bool),
        ast::Binary::Le => (Binary::Le, Type::Bool),
        ast::Binary::Gt => (Binary::Gt, Type::Bool),
        ast::Binary::Ge => (Binary::Ge, Type::Bool),
        ast::Binary::And => (Binary::And, Type::Bool),
        ast::Binary::Or => (Binary::Or, Type::Bool),
    };
    (ExprKind::Binary(op, Box::new(left), Box::new(right)), ty)
}
