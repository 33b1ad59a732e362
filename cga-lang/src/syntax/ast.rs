//! The tree of a grammar, as written.
//!
//! Plain data without back pointers, never changed once built. A name is identified by the index of its token
//! ([`Name::id`]), so side tables need no other numbering.

use crate::span::Span;
use crate::syntax::token::Sym;

/// The style of everything before the first `style`.
pub(crate) const DEFAULT: &str = "Default";

/// A grammar as written.
#[derive(Clone, Debug, Default)]
pub struct Ast {
    /// Declarations, in source order.
    pub decls: Vec<Decl>,
    /// Imports, in source order.
    pub imports: Vec<Import>,
    /// Styles, in source order of their first mention. `Decl::style` counts these from 1; 0 is the style `Default`.
    pub styles: Vec<StyleDecl>,
    /// Annotations before a `version` line: they count for everything.
    pub head: Vec<Annotation>,
    /// The text of the `version` line.
    pub version: Option<String>,
    /// Names that may be declared in parts that could not be read.
    pub lost: Vec<String>,
}

/// A name with its place.
#[derive(Clone, Debug)]
pub struct Name {
    /// As written; dotted names with their dots.
    pub text: String,
    /// Its tokens.
    pub span: Span,
}

impl Name {
    /// The key of the name in side tables.
    pub fn id(&self) -> u32 {
        self.span.first
    }
}

/// `import id(style, …) : "file.cga" (overrides)`.
#[derive(Clone, Debug)]
pub struct Import {
    /// Annotations before it.
    pub annotations: Vec<Annotation>,
    /// The prefix of its names.
    pub id: Name,
    /// The styles to which it is limited, in parentheses after the id.
    pub styles: Option<Vec<Name>>,
    /// The path, as written.
    pub path: String,
    /// The path's token.
    pub path_span: Span,
    /// The parentheses after the path. `None` without parentheses: then attributes of the importing file
    /// override attributes of the same name; an empty list protects all.
    pub overrides: Option<Vec<Override>>,
    /// All of it, without annotations.
    pub span: Span,
}

/// A change that an import makes to the imported file.
#[derive(Clone, Debug)]
pub enum Override {
    /// `name`: this attribute keeps its value.
    Keep(Name),
    /// `name = expr`, evaluated in the importing file.
    Value(Name, Expr),
    /// `Name(params) --> ops`: replaces an extension rule.
    Rule(Decl),
}

/// `style Name extends Base`.
#[derive(Clone, Debug)]
pub struct StyleDecl {
    /// Annotations before it.
    pub annotations: Vec<Annotation>,
    /// Its name.
    pub name: Name,
    /// The style it builds on; `None` for `Default`.
    pub base: Option<Name>,
}

/// A declaration.
#[derive(Clone, Debug)]
pub struct Decl {
    /// Annotations before it.
    pub annotations: Vec<Annotation>,
    /// Doc comments before it.
    pub docs: Vec<String>,
    /// The declared name. Dotted for a rule that continues a leaf of an import (`id.Name --> …`).
    pub name: Name,
    /// The style it belongs to: 0 for `Default`, else a number into [`Ast::styles`], plus 1.
    pub style: u32,
    /// The word before a rule's name.
    pub role: Role,
    /// Its parameters.
    pub params: Vec<Name>,
    /// `with ( name := expr … )`: values computed once when it is entered, each seeing those before.
    pub locals: Vec<(Name, Expr)>,
    /// The meaning of the name.
    pub body: Body,
    /// The declaration without annotations.
    pub span: Span,
}

/// The word before a rule's name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Role {
    /// No word.
    #[default]
    Plain,
    /// `start`: the file's default rule, callable as `start` and `id.start`.
    Start,
    /// `extension`: a default that an importing file may replace.
    Extension,
}

/// The meaning of a declaration.
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
    /// The kind of step.
    pub kind: OpKind,
    /// Its place.
    pub span: Span,
}

/// The kinds of steps.
#[derive(Clone, Debug)]
pub enum OpKind {
    /// `name` or `name(args)`: an operation or a successor. The name is dotted for what an import declares.
    Call(Name, Vec<Arg>),
    /// `id(overrides).Name(args)`: a rule of an import whose attributes are computed again.
    Dynamic {
        /// The import.
        import: Name,
        /// The contents of its parentheses.
        overrides: Vec<Override>,
        /// The rule, without the import's name.
        rule: Name,
        /// Its arguments.
        args: Vec<Arg>,
    },
    /// An operation with braces: `split(x) { ~1 : A }`, `comp(f) { top : B }`, `setback(1) { front : A | remainder : B }`.
    Block(Block),
    /// `Name.`
    Leaf(Name),
    /// `NIL`
    Nil,
    /// `path::to(args)`: a Rust function.
    Path(Name, Vec<Arg>),
    /// `[ … ]`
    Push(Vec<Op>),
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

/// The prefix of a size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prefix {
    /// `'`
    Relative,
    /// `~`
    Floating,
}

impl Prefix {
    /// The places where it is allowed, for a note.
    pub(crate) fn place(self) -> &'static str {
        match self {
            Prefix::Relative => "only lengths can be relative to the scope",
            Prefix::Floating => "only sizes that share a length can float, as in a split",
        }
    }

    /// The help where it is not allowed.
    pub(crate) fn instead(self) -> &'static str {
        match self {
            Prefix::Relative => "leave it out, or multiply: `0.5 * scope.sx` is half of the width",
            Prefix::Floating => "leave it out",
        }
    }
}

/// The contents between two `|` of slots.
#[derive(Clone, Debug)]
pub enum SplitItem {
    /// `size : operations`
    Slot(Arg, Vec<Op>),
    /// `{ … }`, and whether a `*` follows.
    Group(Vec<SplitItem>, bool),
}

/// `selector : operations` or `selector = operations`.
#[derive(Clone, Debug)]
pub struct Arm {
    /// Selects parts of the shape.
    pub selector: Expr,
    /// The operator.
    pub mode: ArmMode,
    /// The successors.
    pub ops: Vec<Op>,
}

/// The operator of an arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArmMode {
    /// `:`, one shape a component.
    Each,
    /// `=`, one shape for all.
    Together,
    /// `=:`, one shape for those that touch each other.
    Connected,
}

/// `name(args) { … }`: an operation that makes parts of the shape, each with operations of its own.
#[derive(Clone, Debug)]
pub struct Block {
    /// The operation's name.
    pub name: Name,
    /// The arguments in parentheses, words among them.
    pub args: Vec<Arg>,
    /// The contents of each pair of braces; `splitAndSetbackPerimeter` has two pairs.
    pub parts: Vec<BlockPart>,
}

/// The contents of a pair of braces.
#[derive(Clone, Debug)]
pub enum BlockPart {
    /// `size : operations | …`, and whether a `*` follows.
    Slots(Vec<SplitItem>, bool),
    /// `length : depth : operations | …`, and whether a `*` follows.
    Sections(Vec<Section>, bool),
    /// `selector : operations | …`.
    Arms(Vec<Arm>),
    /// Operations; one sequence for each side of `|`. `inline Rule` has one, and so has `union Rule`, as it was written
    /// before 2025: the other side is then the shape itself, on the left unless the argument is `swap`.
    Ops(Vec<Vec<Op>>),
}

/// `length : depth : operations`: a part of a boundary.
#[derive(Clone, Debug)]
pub struct Section {
    /// The length.
    pub length: Arg,
    /// The setback distance; evaluated for each section that is made.
    pub depth: Expr,
    /// The successors.
    pub ops: Vec<Op>,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// The kind of expression.
    pub kind: ExprKind,
    /// Its place.
    pub span: Span,
    /// The height of its tree. Code that walks the tree must not overflow the stack.
    pub depth: u32,
}

impl Expr {
    /// The place of an expression that could not be read, which was reported.
    pub(crate) fn error(span: Span) -> Expr {
        Expr { kind: ExprKind::Error, span, depth: 1 }
    }
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
    /// `.-a`, `.+a`, `.!a`: element by element.
    EachUnary(Unary, Box<Expr>),
    /// `a + b`; the span is the operator's.
    Binary(Binary, Span, Box<Expr>, Box<Expr>),
    /// `a .+ b`: element by element.
    Each(Binary, Span, Box<Expr>, Box<Expr>),
    /// `a + b - c …`: many operators of one level, from left to right. Few operators are [`ExprKind::Binary`].
    Chain(Box<Expr>, Vec<Link>),
    /// `[a, b; c, d]`, by rows. An entry may be a range.
    Array(Vec<Vec<Expr>>),
    /// `base : limit` or `base : step : limit`. Only as an entry of an array or an index.
    Range(Box<Expr>, Option<Box<Expr>>, Box<Expr>),
    /// `a[i]` or `a[row, column]`.
    Index(Box<Expr>, Vec<Expr>),
    /// `comp(f) { selector : expr | … }`: an array with a value a component.
    Comp(CompValue),
    /// `case … else`
    Case(Vec<(Expr, Expr)>, Box<Expr>),
    /// `30% : … else`
    Chance(Vec<(Percent, Expr)>, Box<Expr>),
    /// Something that was reported.
    Error,
}

/// An operator of a chain and its right operand.
#[derive(Clone, Debug)]
pub struct Link {
    /// Arithmetic, `&&` or `||`.
    pub op: Binary,
    /// The operator's place.
    pub at: Span,
    /// The right operand.
    pub operand: Expr,
}

/// `comp(args) { selector : expr | … }` as a value.
#[derive(Clone, Debug)]
pub struct CompValue {
    /// The word `comp`.
    pub name: Name,
    /// Kind of component and so on.
    pub args: Vec<Expr>,
    /// Selector, operator, value.
    pub arms: Vec<(Expr, ArmMode, Expr)>,
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

/// The operators with two operands, their signs, and their levels: a higher level binds more tightly.
pub(crate) const OPERATORS: [(Binary, Sym, u8); 13] = [
    (Binary::Or, Sym::OrOr, 1),
    (Binary::And, Sym::AndAnd, 2),
    (Binary::Eq, Sym::EqEq, 3),
    (Binary::Ne, Sym::NotEq, 3),
    (Binary::Lt, Sym::Less, 4),
    (Binary::Le, Sym::LessEq, 4),
    (Binary::Gt, Sym::Greater, 4),
    (Binary::Ge, Sym::GreaterEq, 4),
    (Binary::Add, Sym::Plus, 5),
    (Binary::Sub, Sym::Minus, 5),
    (Binary::Mul, Sym::Star, 6),
    (Binary::Div, Sym::Slash, 6),
    (Binary::Rem, Sym::Percent, 6),
];

impl Binary {
    /// Returns true if many operators of its level are a [`ExprKind::Chain`]: a comparison of comparisons is rare.
    pub(crate) fn is_chained(self) -> bool {
        use Binary::{Add, And, Div, Mul, Or, Rem, Sub};
        matches!(self, Add | Sub | Mul | Div | Rem | And | Or)
    }

    /// As written.
    pub fn text(self) -> &'static str {
        OPERATORS.iter().find(|(own, ..)| *own == self).map_or("", |(_, sign, _)| sign.text())
    }
}
