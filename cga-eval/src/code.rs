//! Expressions as lists of instructions for a stack, so that functions of the rules call each other without the stack of the thread.

use std::sync::Arc;

use cga_lang::ir::Type;
use cga_runtime::rt::{Align, Arm, Components, Env, Mode, Select, Shape, Text, Value, Word};

use crate::dispatch::FunctionCall;
use crate::object::Object;
use crate::stack::Stack;

/// A function of the host program.
pub(crate) type HostFunction = Arc<dyn Fn(&[Value]) -> Value + Send + Sync>;

/// An operation that the host program has registered.
pub(crate) type RegisteredOperation = dyn Fn(&mut Shape, &[Value]) + Send + Sync;

/// An operation of the host program.
#[derive(Clone)]
pub(crate) enum HostOperation {
    /// Registered by the program.
    Registered(Arc<RegisteredOperation>),
    /// Compiled with the rules.
    Compiled(fn(&mut Env, &mut Shape, &[Value])),
}

/// One or more expressions: their values are left on the stack, in order.
#[derive(Debug, Default)]
pub(crate) struct Code {
    pub(crate) steps: Box<[Instruction]>,
    /// True if an expression reads more than a slim shape has.
    pub(crate) is_whole: bool,
}

/// An instruction.
#[derive(Debug)]
pub(crate) enum Instruction {
    /// Adds a number.
    Number(f64),
    /// Adds an object.
    Object(Object),
    /// Adds a parameter or local that is a number.
    LocalNumber(u32),
    /// Adds a parameter or local that is an object.
    LocalObject(u32),
    /// Adds an attribute or constant of the run that is a number, by its slot.
    RunNumber(u32),
    /// Adds an attribute or constant of the run that is an object, by its slot.
    RunObject(u32),
    /// Adds an attribute or constant that shapes may hold, or that is computed on its first read.
    Global(u32),
    /// Replaces a number by its negative.
    Neg,
    /// Replaces a truth value by its opposite.
    Not,
    /// Replaces two numbers by one.
    Numbers(NumberOperator),
    /// Replaces two texts by a truth value.
    Texts(NumberOperator),
    /// Joins two texts.
    Concat,
    /// Calls a function of the language.
    Function(FunctionCall),
    /// Calls a function of the rules, at a site.
    Call(u32, Sites),
    /// Calls a function of the host program.
    Host(Box<HostCall>),
    /// Goes to an instruction.
    Jump(u32),
    /// Takes a truth value, and goes to an instruction if it is false.
    JumpUnless(u32),
    /// Draws a branch with a probability.
    Chance { percent: f64, before: f64 },
    /// Adds whether a word selects the component.
    Word(Word),
    /// Adds whether the style is one of these.
    Style(Box<[u32]>),
    /// Adds whether the site is one of these.
    Site(Box<[u32]>),
    /// Replaces a text by a file that is searched from a folder.
    File(Text),
    /// Replaces texts by files that are searched from a folder.
    Files(Text),
    /// Replaces a file by the name of an image in models.
    Image,
    /// Adds an array with a value for each component.
    Comp(Box<CompCode>),
}

/// Operators on numbers and truth values.
#[derive(Clone, Copy, Debug)]
pub(crate) enum NumberOperator {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    Lt,
    Le,
    Gt,
    Ge,
    Eq,
    Ne,
    And,
    Or,
}

/// The site that a call passes on: one number for each site of the caller.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sites(Box<[u32]>);

impl Sites {
    pub(crate) fn new(numbers: impl IntoIterator<Item = u32>) -> Self {
        Sites(numbers.into_iter().collect())
    }

    /// The number at a site of the caller.
    #[inline]
    pub(crate) fn at(&self, site: u32) -> u32 {
        self.0.get(site as usize).or(self.0.first()).copied().unwrap_or_default()
    }

    /// True for several sites of the caller.
    pub(crate) fn are_many(&self) -> bool {
        1 < self.0.len()
    }
}

/// A call of a function of the host program.
pub(crate) struct HostCall {
    pub(crate) name: String,
    pub(crate) function: HostFunction,
    pub(crate) args: Box<[Type]>,
    pub(crate) ty: Type,
    /// True for a value of the host program (`#name`), which exists once and does not count for limits.
    pub(crate) is_value: bool,
}

impl std::fmt::Debug for HostCall {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("HostCall").field("name", &self.name).finish_non_exhaustive()
    }
}

/// `comp(f) { selector : value }`.
#[derive(Debug)]
pub(crate) struct CompCode {
    pub(crate) components: Components,
    pub(crate) align: Align,
    pub(crate) arms: ArmsCode,
    /// By arm.
    pub(crate) values: Box<[Code]>,
    /// The type of the array.
    pub(crate) ty: Type,
}

/// Arms with their selectors.
#[derive(Debug, Default)]
pub(crate) struct ArmsCode {
    /// By arm; the number of an index is found when the code runs.
    table: Box<[Arm]>,
    /// The numbers of all indices, in order.
    pub(crate) indices: Code,
    /// By arm: its condition.
    pub(crate) conditions: Box<[Option<Code>]>,
}

impl ArmsCode {
    pub(crate) fn new(table: Vec<Arm>, indices: Code, conditions: Vec<Option<Code>>) -> Self {
        ArmsCode { table: table.into(), indices, conditions: conditions.into() }
    }

    /// The table. Takes the numbers of the indices from the stack.
    pub(crate) fn table(&self, stack: &mut Stack) -> Vec<Arm> {
        let mut table = self.table.to_vec();
        for arm in table.iter_mut().rev() {
            if let Select::Index(index) = &mut arm.select {
                *index = stack.float();
            }
        }
        table
    }

    /// The table, unless it has indices.
    pub(crate) fn fixed(&self) -> Option<&[Arm]> {
        self.indices.steps.is_empty().then_some(&*self.table)
    }
}

/// The mode of an arm.
pub(crate) fn mode(mode: cga_lang::ir::ArmMode) -> Mode {
    match mode {
        cga_lang::ir::ArmMode::Each => Mode::Each,
        cga_lang::ir::ArmMode::Together => Mode::Together,
        cga_lang::ir::ArmMode::Connected => Mode::Connected,
    }
}
