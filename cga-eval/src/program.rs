//! Loaded rules, compiled once.

use cga_lang::ir::Type;
use cga_runtime::rt::{Text, Value};

use crate::code::Code;
use crate::steps::RuleCode;

/// Rules, functions, attributes and constants. Numbers of the intermediate representation are indexes here.
#[derive(Debug, Default)]
pub(crate) struct Program {
    pub(crate) rules: Vec<RuleCode>,
    pub(crate) functions: Vec<FunctionCode>,
    pub(crate) globals: Vec<GlobalCode>,
    pub(crate) renewals: Vec<RenewalCode>,
    /// Attributes and constants in the order in which a run computes them.
    pub(crate) init: Vec<InitCode>,
    /// The number of attributes and constants in each kind of slot.
    pub(crate) slots: SlotCounts,
    /// The attributes that the host program may set.
    pub(crate) fields: Vec<FieldCode>,
}

/// A function of the rules.
#[derive(Debug)]
pub(crate) struct FunctionCode {
    /// Its locals, then its value.
    pub(crate) code: Code,
    /// The numbers of arguments that are numbers, and that are objects.
    pub(crate) args: (usize, usize),
    pub(crate) ty: Type,
    /// The stack that it requests, if it does.
    pub(crate) request: Option<u32>,
}

/// An attribute or constant.
#[derive(Debug)]
pub(crate) struct GlobalCode {
    pub(crate) name: Text,
    pub(crate) ty: Type,
    pub(crate) slot: Slot,
    /// Its value or default.
    pub(crate) value: Code,
    /// The value, if it is a constant.
    pub(crate) known: Option<Value>,
    /// True if the value is a literal, which draws nothing.
    pub(crate) is_literal: bool,
    pub(crate) is_set: bool,
    pub(crate) is_attribute: bool,
    /// The number of its random stream.
    pub(crate) stream: u32,
    /// The stack that the first read of a lazy one requests.
    pub(crate) stack: u32,
    /// The field whose value it has, if it has one.
    pub(crate) field: Option<usize>,
    /// The field whose value it has when an import is renewed.
    pub(crate) renewed_field: Option<usize>,
}

/// The place of an attribute or constant among the values of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slot {
    Number(u32),
    Object(u32),
    Lazy(u32),
}

/// The numbers of slots.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SlotCounts {
    pub(crate) numbers: u32,
    pub(crate) objects: u32,
    pub(crate) lazy: u32,
}

/// An attribute or constant that a run computes.
#[derive(Debug)]
pub(crate) struct InitCode {
    pub(crate) global: usize,
    /// The styles that have it; `None` for all.
    pub(crate) styles: Option<Vec<u32>>,
}

impl InitCode {
    /// True if the style has it.
    pub(crate) fn is_in(&self, style: u32) -> bool {
        self.styles.as_ref().is_none_or(|styles| styles.contains(&style))
    }
}

/// An attribute that the host program may set.
#[derive(Debug)]
pub(crate) struct FieldCode {
    /// The default, if it is the same constant in every style.
    pub(crate) known: Option<Value>,
    /// The attributes with its name among [`Program::init`], in the order of the run.
    pub(crate) inits: Vec<usize>,
}

/// The values of an import that are computed again.
#[derive(Debug)]
pub(crate) struct RenewalCode {
    /// Runs of lazy ones, or a single one.
    pub(crate) groups: Vec<Vec<usize>>,
}
