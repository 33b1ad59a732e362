//! A tree as CGA text, in either spelling. Brackets show how operators were grouped.

use crate::ast::{
    Annotation, Arg, ArmMode, Ast, Body, Comp, Decl, Expr, ExprKind, Name, Op, OpKind, Percent, Prefix, Split,
    SplitItem, Unary,
};
use crate::token::push_quoted;

/// How relative sizes are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spelling {
    /// `'0.5`, as in CGA text.
    Text,
    /// `^0.5`, as among Rust.
    Inline,
}

/// The text of a tree, one declaration a line.
pub fn print(ast: &Ast, spelling: Spelling) -> String {
    let mut out = Printer { out: String::new(), spelling };
    for annotation in &ast.head {
        out.annotation(annotation);
    }
    if let Some(version) = &ast.version {
        out.word("version ");
        push_quoted(&mut out.out, version);
        out.word("\n");
    }
    for decl in &ast.decls {
        out.decl(decl);
        out.word("\n");
    }
    out.out
}

struct Printer {
    out: String,
    spelling: Spelling,
}

impl Printer {
    fn word(&mut self, text: &str) {
        self.out.push_str(text);
    }

    fn list<T>(&mut self, items: &[T], between: &str, mut each: impl FnMut(&mut Self, &T)) {
        for (index, item) in items.iter().enumerate() {
            if index != 0 {
                self.word(between);
            }
            each(self, item);
        }
    }

    fn annotation(&mut self, annotation: &Annotation) {
        self.word("@");
        self.word(&annotation.name.text);
        match &annotation.args {
            Some(args) if args.is_empty() => {}
            Some(args) => {
                self.word("(");
                self.list(args, ", ", |own, arg| {
                    if let Some(name) = &arg.name {
                        own.word(&name.text);
                        own.word(" = ");
                    }
                    own.expr(&arg.value);
                });
                self.word(")");
            }
            None => self.word("()"),
        }
        self.word("\n");
    }

    fn decl(&mut self, decl: &Decl) {
        for doc in &decl.docs {
            self.word("/// ");
            self.word(doc);
            self.word("\n");
        }
        for annotation in &decl.annotations {
            self.annotation(annotation);
        }
        match &decl.body {
            Body::Attr(_) => self.word("attr "),
            Body::Const(_) => self.word("const "),
            Body::Function(_) | Body::Rule(_) => {}
        }
        self.word(&decl.name.text);
        if !decl.params.is_empty() {
            self.word("(");
            self.list(&decl.params, ", ", |own, param| own.word(&param.text));
            self.word(")");
        }
        match &decl.body {
            Body::Attr(value) | Body::Const(value) | Body::Function(value) => {
                self.word(" = ");
                self.expr(value);
            }
            Body::Rule(ops) => {
                self.word(" -->");
                self.ops(ops);
            }
        }
    }

    fn ops(&mut self, ops: &[Op]) {
        for op in ops {
            self.word(" ");
            self.op(op);
        }
    }

    fn op(&mut self, op: &Op) {
        match &op.kind {
            OpKind::Call(name, args) => self.call(name, args),
            OpKind::Leaf(name) => {
                self.word(&name.text);
                self.word(".");
            }
            OpKind::Nil => self.word("NIL"),
            OpKind::Path(name, args) => {
                self.word(&name.text);
                self.args(args);
            }
            OpKind::Push(ops) => {
                self.word("[");
                self.ops(ops);
                self.word(" ]");
            }
            OpKind::Split(split) => self.split(split),
            OpKind::Comp(comp) => self.comp(comp),
            OpKind::Case(arms, otherwise) => {
                for (condition, ops) in arms {
                    self.word("case ");
                    self.expr(condition);
                    self.word(" :");
                    self.ops(ops);
                    self.word(" ");
                }
                self.word("else :");
                self.ops(otherwise);
            }
            OpKind::Chance(arms, otherwise) => {
                for (percent, ops) in arms {
                    self.percent(percent);
                    self.ops(ops);
                    self.word(" ");
                }
                self.word("else :");
                self.ops(otherwise);
            }
            OpKind::Error | OpKind::Dynamic { .. } | OpKind::Block(_) => self.word("ERROR"),
        }
    }

    fn percent(&mut self, percent: &Percent) {
        self.word(&percent.value.to_string());
        self.word("% :");
    }

    fn call(&mut self, name: &Name, args: &[Arg]) {
        self.word(&name.text);
        if !args.is_empty() {
            self.args(args);
        }
    }

    fn args(&mut self, args: &[Arg]) {
        self.word("(");
        self.list(args, ", ", Self::arg);
        self.word(")");
    }

    fn arg(&mut self, arg: &Arg) {
        match (arg.prefix, self.spelling) {
            (Some((Prefix::Relative, _)), Spelling::Text) => self.word("'"),
            (Some((Prefix::Relative, _)), Spelling::Inline) => self.word("^"),
            (Some((Prefix::Floating, _)), _) => self.word("~"),
            (None, _) => {}
        }
        self.expr(&arg.value);
    }

    fn split(&mut self, split: &Split) {
        self.word("split");
        self.args(&split.args);
        self.word(" ");
        self.items(&split.items, split.repeat);
    }

    fn items(&mut self, items: &[SplitItem], repeat: bool) {
        self.word("{ ");
        self.list(items, " | ", |own, item| match item {
            SplitItem::Slot(size, ops) => {
                own.arg(size);
                own.word(" :");
                own.ops(ops);
            }
            SplitItem::Group(items, repeat) => own.items(items, *repeat),
        });
        self.word(if repeat { " }*" } else { " }" });
    }

    fn comp(&mut self, comp: &Comp) {
        self.word("comp");
        self.args(&comp.args);
        self.word(" { ");
        self.list(&comp.arms, " | ", |own, arm| {
            own.expr(&arm.selector);
            own.word(match arm.mode {
                ArmMode::Each => " :",
                ArmMode::Together => " =",
                ArmMode::Connected => " =:",
            });
            own.ops(&arm.ops);
        });
        self.word(" }");
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Number(value) => self.word(&value.to_string()),
            ExprKind::Bool(value) => self.word(&value.to_string()),
            ExprKind::Text(text) => push_quoted(&mut self.out, text),
            ExprKind::Name(name) => self.word(&name.text),
            ExprKind::Host(handle) => self.word(&format!("#{handle}")),
            ExprKind::Call(name, args) | ExprKind::Path(name, args) => {
                self.word(&name.text);
                self.word("(");
                self.list(args, ", ", Self::expr);
                self.word(")");
            }
            ExprKind::Unary(op, operand) => {
                self.word(match op {
                    Unary::Minus => "-",
                    Unary::Plus => "+",
                    Unary::Not => "!",
                });
                self.expr(operand);
            }
            ExprKind::Binary(op, _, left, right) => {
                self.word("(");
                self.expr(left);
                self.word(" ");
                self.word(op.text());
                self.word(" ");
                self.expr(right);
                self.word(")");
            }
            ExprKind::Case(arms, otherwise) => {
                self.word("(");
                for (condition, value) in arms {
                    self.word("case ");
                    self.expr(condition);
                    self.word(" : ");
                    self.expr(value);
                    self.word(" ");
                }
                self.branch_end(otherwise);
            }
            ExprKind::Chance(arms, otherwise) => {
                self.word("(");
                for (percent, value) in arms {
                    self.percent(percent);
                    self.word(" ");
                    self.expr(value);
                    self.word(" ");
                }
                self.branch_end(otherwise);
            }
            _ => self.word("ERROR"),
        }
    }

    fn branch_end(&mut self, otherwise: &Expr) {
        self.word("else : ");
        self.expr(otherwise);
        self.word(")");
    }
}
