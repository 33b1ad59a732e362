//! The tree of a grammar, as written.
//!
//! Plain data without back pointers, never changed once built. A name is identified by the index of its token
//! ([`Name::id`]), so side tables need no other numbering.

use crate::span::Span;

/// A grammar as written.
#[derive(Clone, Debug, Default)]
pub struct Ast {
    /// Declarations, in source order.
    pub decls: Vec<Decl>,
    /// Annotations before a `version` line: they count for everything.
    pub head: Vec<Annotation>,
    /// The text of the `version` line.
    pub version: Option<String>,
    /// Names that may be declared in parts that could not be read.
    pub lost: Vec<String>,
}

/// A name and where it stands.
#[derive(Clone, Debug)]
pub struct Name {
    /// As written; dotted names with their dots.
    pub text: String,
    /// Its tokens.
    pub span: Span,
}

impl Name {
    /// What side tables know it by.
    pub fn id(&self) -> u32 {
        self.span.first
    }
}

/// A declaration.
#[derive(Clone, Debug)]
pub struct Decl {
    /// Annotations before it.
    pub annotations: Vec<Annotation>,
    /// Doc comments before it.
    pub docs: Vec<String>,
    /// What it declares.
    pub name: Name,
    /// Its parameters.
    pub params: Vec<Name>,
    /// What the name stands for.
    pub body: Body,
    /// The declaration without annotations.
    pub span: Span,
}

/// What a declaration stands for.
#[derive(Clone, Debug)]
pub enum Body {
    /// `attr name = expr`.
    Attr(Expr),
    /// `const name = expr`.
    Const(Expr),
    /// `name(params) = expr`.
    Function(Expr),
    /// `Name(params) --> ops`.
    Rule(Vec<Op>),
}

/// `@Name(arguments)`.
#[derive(Clone, Debug)]
pub struct Annotation {
    /// The name, without `@`.
    pub name: Name,
    /// `None` when the arguments could not be read as values; then nothing is known about them.
    pub args: Option<Vec<AnnotationArg>>,
}

/// An argument of an annotation.
#[derive(Clone, Debug)]
pub struct AnnotationArg {
    /// `min` in `min = 3`.
    pub name: Option<Name>,
    /// The value.
    pub value: Expr,
}

/// A step of a rule.
#[derive(Clone, Debug)]
pub struct Op {
    /// What it does.
    pub kind: OpKind,
    /// Where it stands.
    pub span: Span,
}

/// What a step of a rule does.
#[derive(Clone, Debug)]
pub enum OpKind {
    /// `name` or `name(args)`: an operation or a successor.
    Call(Name, Vec<Arg>),
    /// `Name.`
    Leaf(Name),
    /// `NIL`
    Nil,
    /// `path::to(args)`: a Rust function.
    Path(Name, Vec<Arg>),
    /// `[ … ]`
    Push(Vec<Op>),
    /// `split(axis) { … }`
    Split(Split),
    /// `comp(f) { … }`
    Comp(Comp),
    /// `case … else`
    Case(Vec<(Expr, Vec<Op>)>, Vec<Op>),
    /// `30% : … else`
    Chance(Vec<(Percent, Vec<Op>)>, Vec<Op>),
    /// Something that was reported.
    Error,
}

/// A percentage, with its number's place.
#[derive(Clone, Debug)]
pub struct Percent {
    /// 30 in `30%`.
    pub value: f64,
    /// The number.
    pub span: Span,
}

/// An argument of an operation, or the size of a slot.
#[derive(Clone, Debug)]
pub struct Arg {
    /// `'` or `~`, and where.
    pub prefix: Option<(Prefix, Span)>,
    /// The value.
    pub value: Expr,
    /// All of it.
    pub span: Span,
}

/// How a size is to be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prefix {
    /// `'`
    Relative,
    /// `~`
    Floating,
}

/// `split(args) { … }`, with or without `*`.
#[derive(Clone, Debug)]
pub struct Split {
    /// The word `split`.
    pub name: Name,
    /// Axis and so on.
    pub args: Vec<Arg>,
    /// The slots.
    pub items: Vec<SplitItem>,
    /// Whether a `*` follows.
    pub repeat: bool,
}

/// What stands between two `|` of a split.
#[derive(Clone, Debug)]
pub enum SplitItem {
    /// `size : operations`
    Slot(Arg, Vec<Op>),
    /// `{ … }`, and whether a `*` follows.
    Group(Vec<SplitItem>, bool),
}

/// `comp(args) { … }`.
#[derive(Clone, Debug)]
pub struct Comp {
    /// The word `comp`.
    pub name: Name,
    /// Kind of component and so on.
    pub args: Vec<Arg>,
    /// The arms.
    pub arms: Vec<CompArm>,
}

/// `selector : operations` or `selector = operations`.
#[derive(Clone, Debug)]
pub struct CompArm {
    /// Which components.
    pub selector: Expr,
    /// `=` instead of `:`.
    pub together: bool,
    /// What they become.
    pub ops: Vec<Op>,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands.
    pub span: Span,
}

/// The kinds of expressions.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// `3.5`
    Number(f64),
    /// `true`
    Bool(bool),
    /// `"text"`
    Text(String),
    /// A name, perhaps dotted.
    Name(Name),
    /// `#name` or `#(…)`
    Host(u32),
    /// `name(args)`
    Call(Name, Vec<Expr>),
    /// `path::to(args)`: a Rust function.
    Path(Name, Vec<Expr>),
    /// `-a`, `+a`, `!a`
    Unary(Unary, Box<Expr>),
    /// `a + b`; the span is the operator's.
    Binary(Binary, Span, Box<Expr>, Box<Expr>),
    /// `case … else`
    Case(Vec<(Expr, Expr)>, Box<Expr>),
    /// `30% : … else`
    Chance(Vec<(Percent, Expr)>, Box<Expr>),
    /// Something that was reported.
    Error,
}

/// Operators with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unary {
    /// `-`
    Minus,
    /// `+`
    Plus,
    /// `!`
    Not,
}

/// Operators with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Binary {
    /// `+`, on floats or text
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
    /// `%`
    Rem,
    /// `==`
    Eq,
    /// `!=`
    Ne,
    /// `<`
    Lt,
    /// `<=`
    Le,
    /// `>`
    Gt,
    /// `>=`
    Ge,
    /// `&&`
    And,
    /// `||`
    Or,
}

impl Binary {
    /// As written.
    pub fn text(self) -> &'static str {
        match self {
            Binary::Add => "+",
            Binary::Sub => "-",
            Binary::Mul => "*",
            Binary::Div => "/",
            Binary::Rem => "%",
            Binary::Eq => "==",
            Binary::Ne => "!=",
            Binary::Lt => "<",
            Binary::Le => "<=",
            Binary::Gt => ">",
            Binary::Ge => ">=",
            Binary::And => "&&",
            Binary::Or => "||",
        }
    }
}
