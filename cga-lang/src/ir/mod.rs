//! The intermediate representation: a checked grammar without names, which a back end translates or evaluates.
//!
//! The central structure is [`Grammar`]. It contains:
//!
//! - [`Rule`]s, which have parameters, locals and a body of [`Step`]s,
//! - [`Function`]s, which have parameters, locals and a value,
//! - [`Global`]s: the attributes and constants,
//! - [`Start`]s, the rules that a run can begin with.
//!
//! A [`Step`] acts on the *current shape* of its rule: it changes the shape, or makes children of it. An [`Expr`] has a value and
//! a type, and does not change the shape. Steps form a tree and contain trees of expressions.
//!
//! # Numbers
//!
//! Names are resolved. A reference to a definition is its number:
//!
//! | number | indexes |
//! |---|---|
//! | [`RuleId`] | [`Grammar::rules`] |
//! | [`FunctionId`] | [`Grammar::functions`] |
//! | [`GlobalId`] | [`Grammar::globals`]: attributes first, then constants |
//! | [`RenewalId`] | [`Grammar::renewals`] |
//! | [`HostId`] | [`Grammar::hosts`] |
//! | [`ExprKind::Param`] | `params` of the rule or function around it |
//! | the slot of an item or a [`Piece`] | `sizes` and `targets` of its [`Slots`] |
//! | the style of [`Start`], [`Init`] and [`ExprKind::Style`] | the styles of the compiled file; `Default` is 0 |
//! | the site of [`ExprKind::Site`] | the import sites that share the rule or function |
//!
//! Names remain as text where the user sees them: in leaves, trails, attributes, start rules.
//!
//! # Scopes
//!
//! Globals, rules and functions are visible everywhere. Parameters belong to one rule or function. `params` lists the parameters
//! that a caller passes, and then the locals of `with`: the last `locals.len()` entries. So a call has
//! `params.len() - locals.len()` arguments, and a local reads parameters and earlier locals only.
//!
//! The contents of braces are a rule of their own, a *block* ([`Rule::block`]), unless they are one successor, leaf or `NIL`. A
//! block reads no parameter of the rule around it. It has copies of the ones that it uses, locals included, as parameters in
//! ascending order, and its [`Target`] passes them. It has no locals. Only rules with its label have steps that call it.
//! It is not a rule for the user: it adds nothing to the trail, and its leaves have the label of the rule around it.
//!
//! # Time of evaluation
//!
//! The current shape changes from step to step, so an expression that reads it has another value before a step than after it. A
//! back end evaluates each expression at these times, and arguments from left to right:
//!
//! | expression | time | shape |
//! |---|---|---|
//! | value of a global | once when a run begins, in the order of [`Grammar::init`] | the initial shape |
//! | value of a *lazy* global | the same, or earlier when another global reads it first | the initial shape |
//! | value of a global with [`Global::known`] | at compile time | none |
//! | locals | in order, when the rule or function is entered | the shape that it gets |
//! | value of a function | at each call, after the arguments | the shape of the expression that calls |
//! | argument of an operation, value of `set` | before the step | the current shape |
//! | condition of a `case` | in order, up to the first one that is true | the current shape |
//! | argument of a successor | when the step is reached | the current shape |
//! | sizes of slots, lengths of sections | once, in order, before the first part is made | the shape that is divided |
//! | depth of a section | for each section that is made | the shape that is divided, with the section's counters |
//! | [`Selector::Index`] | once, before the parts are selected | the shape that is divided |
//! | [`Selector::When`] | for each part that no earlier arm has taken | the part |
//! | argument of the successor of a part, value of an arm of `comp` | for each part | the part |
//! | values given in a call of an import | before the copy is made | the current shape |
//! | values of a [`Renewal`] | in order, after the given ones are set | the copy |
//!
//! [`ExprKind::Case`] evaluates one branch, and [`ExprKind::Comp`] one arm for each component. All other expressions evaluate all
//! parts, also `&&` and `||`.
//! [`ExprKind::Chance`] draws one number from the seed of its shape each time it is evaluated. The draw takes the failures of the
//! branches before it into account, so the arms of a list of percentages are a `case`.
//! A read of a global looks at the current shape first if [`Global::is_set`]; otherwise the value of the run is the only one.
//!
//! # Control flow
//!
//! Steps run in order. A [`StepKind::Case`] is the last step of its list, because the parser puts the steps after it into its
//! branches. So paths meet only at the end of a bracket. [`StepKind::Push`] works on a copy, and its children are children of the
//! rule. [`StepKind::Give`] and the parts of a [`Block`] leave the current shape as it was. With [`BlockParts::Operands`] the block
//! replaces it, and operands are derived before the next step. When other children are derived, a back end decides; their seeds
//! follow from their place alone. At the end of the body the shape becomes a leaf if it has no child, which [`Rule::leaf`] tells
//! in advance where it can.
//!
//! # Invariants
//!
//! A back end may rely on these. It checks nothing and reports nothing:
//!
//! 1. Only a program without errors is lowered. Every number is in range, and [`Grammar::starts`] has only rules that are
//!    not blocks and have no parameters and no sites.
//! 2. Every call has the arguments that its target takes, and [`Expr::ty`] is final. Conversions are explicit
//!    ([`ExprKind::ToText`], functions such as `float`), so [`ExprKind::Binary`] adds two numbers or joins two texts.
//! 3. Operations and functions of the language have an argument for each parameter of their row; defaults are filled in.
//!    [`StepKind::Do`], [`Block`] and [`ExprKind::Builtin`] have only rows that run; the others are `Later`.
//! 4. Constants are folded where every platform computes the same bits. A result that is NaN or infinite is not folded, as it
//!    is a fault of the run.
//! 5. A global comes in [`Grammar::init`] after all globals that it reads, also through functions. Only lazy globals of one cycle
//!    read each other. Globals that are not in the list are never read.
//! 6. A function is on a cycle of calls only if it is [`Function::recursive`], and a rule only with the other rules that have its
//!    number in [`Rule::cycle`].
//! 7. [`Slots::solved`] holds for every shape that reaches the split.
//! 8. [`ExprKind::Style`] occurs only if the file has several styles, [`ExprKind::Site`] only if the rule or function has sites.
//!    A call of a definition with sites passes a site for each site of the caller, or one if the caller has none.
//! 9. Spans are for messages, for editors and for the lines of generated code. No value depends on them.
//!
//! [`facts`] derives from this what each rule reads, and [`plan`] decides from the facts how rules run. [`walk`] visits steps and
//! expressions.

mod attr;
mod block;
mod expr;
pub mod facts;
pub mod plan;
pub mod walk;

use crate::ops::{Operation, ShapeAttr};
use crate::span::Span;

pub use crate::types::Type;
pub use cga_split::{Item, Piece, Prefix};

pub use crate::syntax::ast::{ArmMode, Binary};
pub use attr::{AttrGroup, AttrInfo, ChoiceValues, Choices, Presentation, Range};
pub use block::{Arm, Block, BlockParts, Comp, Sections, Selector, Slots, Solved};
pub use expr::{EachUnary, Expr, ExprKind};

/// Index into [`Grammar::rules`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RuleId(pub u32);
/// Index into [`Grammar::globals`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct GlobalId(pub u32);
/// Index into [`Grammar::functions`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FunctionId(pub u32);
/// Index into [`Grammar::renewals`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RenewalId(pub u32);
/// Index into [`Grammar::hosts`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct HostId(pub u32);

/// A grammar that has passed every check.
#[derive(Clone, Debug, Default)]
pub struct Grammar {
    /// `@RuleFileDescription`: what it makes, in Markdown. Empty when nothing is said.
    pub about: String,
    /// Attributes in source order, then constants in source order.
    pub globals: Vec<Global>,
    /// Functions in source order, then the values of attributes and constants with locals, then functions that read the value
    /// of a site.
    pub functions: Vec<Function>,
    /// Rules in source order, then the blocks that became rules.
    pub rules: Vec<Rule>,
    /// The rules a run can begin with: the default first.
    pub starts: Vec<Start>,
    /// Attributes and constants in an order in which each is ready before it is used. Lazy ones of a cycle follow each other.
    pub init: Vec<Init>,
    /// Imports whose values some call computes again.
    pub renewals: Vec<Renewal>,
    /// Rust values used in the rules, one entry for each value and type.
    pub hosts: Vec<Host>,
}

impl Grammar {
    /// An attribute or constant.
    pub fn global(&self, id: GlobalId) -> &Global {
        &self.globals[id.0 as usize]
    }
}

/// A rule that a run can begin with.
#[derive(Clone, Debug)]
pub struct Start {
    /// The name for the host program: `Lot`, or `Style$Lot`.
    pub name: String,
    /// The style in force, by number; `Default` is 0.
    pub style: u32,
    /// The rule; it has no parameters.
    pub rule: RuleId,
    /// `@Description`, else doc comments, joined by line ends.
    pub doc: String,
    /// `@StartRule`, or marked with `start`.
    pub marked: bool,
    /// `@Hidden`: user interfaces leave it out.
    pub hidden: bool,
}

/// A value that is computed when a run begins.
#[derive(Clone, Debug)]
pub struct Init {
    /// The attribute or constant.
    pub global: GlobalId,
    /// The styles that have it, by number; `None` for all.
    pub styles: Option<Vec<u32>>,
}

/// A value known while compiling.
#[derive(Clone, Debug)]
pub enum Value {
    /// A number.
    Float(f64),
    /// A truth value.
    Bool(bool),
    /// Text.
    Text(String),
    /// An array; never empty, all rows of one length.
    Array(Vec<Vec<Value>>),
}

impl PartialEq for Value {
    /// Numbers are compared by their bits: equal values are the same in every use.
    fn eq(&self, other: &Value) -> bool {
        match (self, other) {
            (Value::Float(a), Value::Float(b)) => a.to_bits() == b.to_bits(),
            (Value::Bool(a), Value::Bool(b)) => a == b,
            (Value::Text(a), Value::Text(b)) => a == b,
            (Value::Array(a), Value::Array(b)) => a == b,
            _ => false,
        }
    }
}

/// `attr name = expr` or `const name = expr`.
#[derive(Clone, Debug)]
pub struct Global {
    /// The name, after the names of imports: `imp.height`.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Its value, or the default of an attribute. It is evaluated once for each initial shape.
    pub value: Expr,
    /// The value when it is a constant. Then the public field of an attribute holds it. Otherwise the field is an `Option` and
    /// `None` means "compute the default for each initial shape".
    pub known: Option<Value>,
    /// True if some rule sets it or a renewal may change it: only then do reads look at the shape first.
    pub is_set: bool,
    /// True on a cycle that conditions may keep open: it is computed on its first read.
    pub lazy: bool,
    /// True for an attribute that the host program may set.
    pub public: bool,
    /// The annotations of an attribute; `None` for a constant.
    pub attr: Option<AttrInfo>,
    /// The name in its declaration.
    pub span: Span,
}

impl Global {
    /// The number of its random stream: from its name (FNV-1a), so that another attribute or constant changes nothing.
    pub fn stream(&self) -> u32 {
        let hash = |hash: u32, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        self.name.bytes().fold(0x811c_9dc5, hash)
    }
}

/// `name(params) = expr`, evaluated in the current shape at each use.
#[derive(Clone, Debug)]
pub struct Function {
    /// As written; several may share a name.
    pub name: String,
    /// Its parameters, then its locals.
    pub params: Vec<Param>,
    /// The values of its locals, computed in order when it is entered: they belong to the last parameters.
    pub locals: Vec<Expr>,
    /// The type of the result.
    pub ty: Type,
    /// The value.
    pub body: Expr,
    /// True for a recursive function, which counts its depth.
    pub recursive: bool,
    /// The number of sites that share it; 0 for a function of one site.
    pub sites: u32,
    /// The name in its declaration.
    pub span: Span,
}

/// A parameter of a rule or function.
#[derive(Clone, Debug)]
pub struct Param {
    /// As written.
    pub name: String,
    /// Inferred type.
    pub ty: Type,
}

/// `Name(params) --> body`, or the operations of a part in braces.
#[derive(Clone, Debug, Default)]
pub struct Rule {
    /// `Facade`; blocks inside it are `Facade/1`, `Facade/2`, … Several rules may share a name with other parameters.
    pub name: String,
    /// The name its implicit leaves carry: `Facade`, for its blocks too.
    pub label: String,
    /// Parameters, then locals. The parameters of a block are captured, in the order of the enclosing rule.
    pub params: Vec<Param>,
    /// The values of its locals, computed in order when it is entered: they belong to the last parameters.
    pub locals: Vec<Expr>,
    /// The steps.
    pub body: Vec<Step>,
    /// True for a block: a part of the rule around it, not a rule that is called.
    pub block: bool,
    /// Tells if the shape becomes a leaf at the end of the body.
    pub leaf: Childless,
    /// The cycle of rules it belongs to, if any: a call from a rule to one of the same cycle may be deferred.
    pub cycle: Option<u32>,
    /// Its text, for the doc line in the generated code; empty for blocks.
    pub source: String,
    /// The sites that share it; empty for a rule of one site.
    pub sites: Vec<RuleSite>,
    /// The name in its declaration; for a block, its first token.
    pub span: Span,
}

/// A site of a shared rule. A file that is imported several times is one definition with the site as a parameter.
#[derive(Clone, Debug)]
pub struct RuleSite {
    /// The name of the rule there.
    pub name: String,
    /// The name of its implicit leaves there.
    pub label: String,
}

/// Tells if a rule has no child at the end of its body. A shape without children is a leaf.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Childless {
    /// No path makes a child, so the shape is a leaf.
    #[default]
    Always,
    /// Every path that gets to the end has made a child.
    Never,
    /// It depends on the path taken, or on a split that may not divide: a flag decides.
    Depends,
}

/// One step of a rule. Steps act on the current shape, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The kind of step.
    pub kind: StepKind,
    /// The operation or successor in the rules.
    pub span: Span,
}

/// The kinds of steps.
#[derive(Clone, Debug, PartialEq)]
pub enum StepKind {
    /// Changes the current shape.
    Do(&'static Operation, Vec<Arg>),
    /// `set(name, value)` on a declared attribute.
    SetAttr(GlobalId, Expr),
    /// `set(name, value)` on an attribute of the shape itself.
    SetShape(&'static ShapeAttr, Expr),
    /// A Rust function as operation: `path::to(args)`.
    Rust(String, Vec<Expr>),
    /// A successor: hands a copy of the current shape on.
    Give(Target),
    /// Makes parts of the current shape, each with a successor.
    Block(Block),
    /// `[ … ]`: works on a copy.
    Push(Vec<Step>),
    /// `import( … ).Rule`: a copy on which the attributes and constants of an import are computed again.
    Renew(Renew),
    /// `case … else`, or `p% : … else` with conditions that are drawn.
    Case {
        /// Condition and body, tried in order.
        arms: Vec<(Expr, Vec<Step>)>,
        /// The `else` body.
        otherwise: Vec<Step>,
    },
}

/// A call of a rule of an import whose attributes are computed again (*import*).
#[derive(Clone, Debug, PartialEq)]
pub struct Renew {
    /// The values given in the call. They and the rule's arguments are evaluated before anything changes.
    pub given: Vec<(GlobalId, Expr)>,
    /// The values that are computed again, except the given ones.
    pub renewal: RenewalId,
    /// The rule that goes on with the copy.
    pub target: Target,
}

/// The values of an import that are computed again.
#[derive(Clone, Debug)]
pub struct Renewal {
    /// The name of the import at its first call.
    pub import: String,
    /// The attributes and constants of the import and of its own imports, each after those that it uses. They are evaluated on
    /// the copy.
    pub globals: Vec<GlobalId>,
}

/// The successor of a child shape.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// Goes on with a rule. The arguments are evaluated on the shape that is handed on for a split or comp part
    /// (so `split.index` is the part's), and on the current shape for a successor.
    Rule {
        /// The rule.
        rule: RuleId,
        /// The site of a shared rule: one number for each site of the caller; empty if the rule is not shared.
        sites: Vec<u32>,
        /// One a parameter.
        args: Vec<Expr>,
        /// The use, for go-to-definition.
        span: Span,
    },
    /// Becomes a leaf of that name.
    Leaf(String),
    /// `NIL`: makes no leaf. It is a child all the same.
    Nil,
}

/// A scope axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The scope's x axis.
    X,
    /// The scope's y axis.
    Y,
    /// The scope's z axis.
    Z,
}

impl Axis {
    /// The axis of that name.
    pub fn named(name: &str) -> Option<Axis> {
        match name {
            "x" => Some(Axis::X),
            "y" => Some(Axis::Y),
            "z" => Some(Axis::Z),
            _ => None,
        }
    }
}

/// The size of a slot.
#[derive(Clone, Debug, PartialEq)]
pub struct Size {
    /// The kind of size.
    pub prefix: Prefix,
    /// The number.
    pub value: Expr,
}

/// An argument of an operation.
#[derive(Clone, Debug, PartialEq)]
pub enum Arg {
    /// A plain value.
    Value(Expr),
    /// A length that may be relative to the scope.
    Length(Size),
    /// A word of the parameter's set of words.
    Word(&'static str),
}

/// A Rust value used in the rules.
#[derive(Clone, Debug)]
pub struct Host {
    /// The number of the Rust expression in its source.
    pub handle: u32,
    /// The type the rules need it to have.
    pub ty: Type,
}
