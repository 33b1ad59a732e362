//! The steps of rules, compiled once.

use cga_lang::ir::{Prefix, Type};
use cga_runtime::rt::{
    Adjust, Align, Axis, ChangePlace, Components, Item, Piece, Size, Successor, TextureSpace, UvAxis,
};

use crate::code::{ArmsCode, Code, HostOperation, Sites};
use crate::dispatch::{ArmsCall, Change, EachCall, FunctionCall, OperandsCall, SectionsCall, SlimCall};

/// A rule or a block.
#[derive(Debug, Default)]
pub(crate) struct RuleCode {
    pub(crate) body: Body,
    pub(crate) locals: Code,
    /// The types of its parameters without locals; empty for a block.
    pub(crate) params: Box<[Type]>,
    /// True if it has parameters or locals.
    pub(crate) has_values: bool,
    pub(crate) is_block: bool,
    /// True if it tells when it is entered and left, though it is a block.
    pub(crate) tells_part: bool,
    /// Its numbers in trails, by site.
    pub(crate) trail: Sites,
    /// The numbers of its implicit leaves, by site.
    pub(crate) label: Sites,
}

/// Steps up to the end of a rule, a bracket or a branch.
#[derive(Debug, Default)]
pub(crate) struct Body {
    pub(crate) steps: Box<[StepCode]>,
    pub(crate) end: End,
    /// True if a step reads the scope at the start of the rule or bracket.
    pub(crate) reads_scope: bool,
}

/// The end of a path through a rule.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum End {
    /// Nothing happens.
    #[default]
    Nothing,
    /// The shape becomes a leaf.
    Leaf,
    /// The shape becomes a leaf if no child was made.
    IfChildless,
}

/// A step, or several that belong together.
#[derive(Debug)]
pub(crate) enum StepCode {
    /// Steps that change the slim shape.
    Slim(Box<[SlimStep]>),
    /// Steps that change a whole shape.
    Whole(Box<[WholeStep]>),
    /// The last step: the branches with their conditions, and the other branch.
    Case(Box<[(Code, Body)]>, Box<Body>),
    /// A successor with the number of the child. The last one is the current shape itself.
    Give { target: TargetCode, number: u32, is_last: bool },
    /// A call of an import with other values.
    Renew(Box<RenewStep>),
    /// `[ … ]` with the number of the child.
    Push(Body, u32),
    /// A split.
    Split(Box<SplitStep>),
    /// A comp, the components of `modify`, or another operation with arms.
    Arms(Box<ArmsStep>),
    /// An operation with sections.
    Sections(Box<SectionsStep>),
    /// An operation with the same successor for each part.
    Each(Box<EachStep>),
    /// An operation with operands.
    Operands(Box<OperandsStep>),
}

/// A step on the slim shape.
#[derive(Debug)]
pub(crate) enum SlimStep {
    /// Reads the shape alone.
    Says(Code, FunctionCall),
    /// Changes the scope.
    Scope(Code, SlimCall),
    /// Changes the material in the same way each time, for equal parameters.
    Material(MaterialStep),
}

/// Changes of the material that follow each other, whose result is kept.
#[derive(Debug)]
pub(crate) struct MaterialStep {
    pub(crate) steps: Box<[WholeStep]>,
    /// By site, the place of the change; one if it does not depend on the site.
    pub(crate) places: Box<[ChangePlace]>,
    pub(crate) reaches_caps: bool,
    /// The parameters on which it depends: the index of each among the numbers or the objects.
    pub(crate) params: Box<[(u32, cga_lang::ir::Type)]>,
}

/// A step on a whole shape.
#[derive(Debug)]
pub(crate) enum WholeStep {
    /// An operation. The watch is asked before some, and texture coordinates are written before some.
    Change { args: Code, change: Change, asks: bool, bakes: bool },
    /// An operation that reads the shape alone.
    Says(Code, FunctionCall),
    /// A value of an attribute of shapes whose name is computed.
    Named(Code, cga_lang::ir::Type),
    /// A value of an attribute of the grammar.
    Attribute(Code, u32, cga_lang::ir::Type),
    /// An operation of the host program.
    Host { args: Code, types: Box<[cga_lang::ir::Type]>, operation: HostStep },
}

/// An operation of the host program.
pub(crate) struct HostStep(pub(crate) HostOperation);

impl std::fmt::Debug for HostStep {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("HostStep")
    }
}

/// The successor of a child.
#[derive(Debug)]
pub(crate) enum TargetCode {
    /// `NIL`.
    Nil,
    /// `NIL` that moves its neighbours.
    Vanish,
    /// A leaf with the number of its name.
    Leaf(u32),
    /// A rule.
    Rule(RuleCall),
}

/// A call of a rule.
#[derive(Debug)]
pub(crate) struct RuleCall {
    pub(crate) rule: usize,
    pub(crate) args: Code,
    pub(crate) sites: Sites,
    /// The levels and the stack that it requests.
    pub(crate) request: Option<(u32, u32)>,
    /// True if templates leave it out.
    pub(crate) is_hole: bool,
    /// True if the rule or a rule below it draws.
    pub(crate) draws: bool,
    /// True if a part that becomes the rule needs a seed of its own.
    pub(crate) reseeds: bool,
}

/// A call of an import with other values.
#[derive(Debug)]
pub(crate) struct RenewStep {
    /// The values that the call gives.
    pub(crate) given: Code,
    /// Their attributes, with their types, in the order of the call.
    pub(crate) attributes: Box<[(u32, cga_lang::ir::Type)]>,
    /// The attributes, sorted.
    pub(crate) sorted: Box<[u32]>,
    pub(crate) renewal: usize,
    pub(crate) target: TargetCode,
    pub(crate) number: u32,
}

/// Slots with their sizes.
#[derive(Debug)]
pub(crate) struct SlotsCode {
    pub(crate) pattern: Box<[Item]>,
    /// The kinds of the sizes.
    pub(crate) prefixes: Box<[Prefix]>,
    /// Their values.
    pub(crate) values: Code,
    /// The sizes, if all are constant.
    pub(crate) known: Option<Box<[Size]>>,
    pub(crate) targets: Box<[TargetCode]>,
}

/// A split.
#[derive(Debug)]
pub(crate) struct SplitStep {
    pub(crate) slots: SlotsCode,
    pub(crate) axis: Axis,
    pub(crate) adjust: Adjust,
    pub(crate) number: u32,
    pub(crate) successors: Box<[Successor]>,
    pub(crate) has_total: bool,
    pub(crate) form: SplitKind,
    /// By slot, the template of a part that repeats; empty if there is none.
    pub(crate) templates: Box<[Option<TemplateCode>]>,
}

/// The kind of a split.
#[derive(Debug)]
pub(crate) enum SplitKind {
    Length,
    Area,
    /// The pieces are known for an extent.
    Solved(f64, Box<[Piece]>),
    /// In texture space; the number of the uv set is evaluated.
    Texture(UvAxis, TextureSpace, Code),
}

/// The template of a repeated part.
#[derive(Debug)]
pub(crate) struct TemplateCode {
    pub(crate) place: u32,
    pub(crate) is_whole: bool,
    pub(crate) reads_axes: bool,
    /// The arguments that it reads, by their types; `None` for constants.
    pub(crate) args: Box<[(cga_lang::ir::Type, bool)]>,
    /// The attributes and constants that it reads.
    pub(crate) globals: Code,
    pub(crate) global_types: Box<[cga_lang::ir::Type]>,
    /// True if it reads values that other runs may not have.
    pub(crate) is_of_run: bool,
}

/// An operation with arms.
#[derive(Debug)]
pub(crate) struct ArmsStep {
    pub(crate) kind: ArmsKind,
    pub(crate) args: Code,
    pub(crate) arms: ArmsCode,
    pub(crate) targets: Box<[TargetCode]>,
    pub(crate) number: u32,
}

/// The kind of an operation with arms.
#[derive(Debug)]
pub(crate) enum ArmsKind {
    Comp(Components, Align),
    /// The operand of `modify`.
    CompAndRest(Components, Align),
    Divide(ArmsCall),
}

/// An operation with sections.
#[derive(Debug)]
pub(crate) struct SectionsStep {
    pub(crate) call: SectionsCall,
    pub(crate) args: Code,
    /// The sections, with targets of the rest after theirs.
    pub(crate) slots: SlotsCode,
    pub(crate) depths: Box<[Code]>,
    pub(crate) rest: ArmsCode,
    pub(crate) number: u32,
}

/// An operation with the same successor for each part.
#[derive(Debug)]
pub(crate) struct EachStep {
    pub(crate) call: EachCall,
    pub(crate) args: Code,
    pub(crate) target: TargetCode,
    pub(crate) number: u32,
}

/// An operation with operands.
#[derive(Debug)]
pub(crate) struct OperandsStep {
    pub(crate) call: OperandsCall,
    pub(crate) args: Code,
    pub(crate) operands: Box<[TargetCode]>,
    pub(crate) recomposes: bool,
    pub(crate) number: u32,
}
