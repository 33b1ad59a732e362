//! What the passes have found out: side tables by name.

use super::info::{AttrInfo, ImportInfo, RuleInfo};
use crate::hash::FastMap;
use crate::link::{InstanceId, Key};
use crate::ops::{Function, Operation, ShapeAttr};
use crate::syntax::ast::Name;
use crate::types::Type;
use std::collections::{HashMap, HashSet};

/// What a name or call stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Use {
    /// A parameter or local.
    Param(u32),
    Attr(u32),
    Const(u32),
    Function(u32),
    Builtin(&'static Function),
    /// The value itself, or a float or bool as text: `str`, and `float` of a float.
    Convert(Type),
    Shape(&'static ShapeAttr),
    Rule(u32),
    /// A call without a rule where that is no error.
    Leaf,
    Operation(&'static Operation),
    SetAttr(u32),
    SetShape(&'static ShapeAttr),
    Selector(&'static str),
    /// One of several, by number into [`Tables::open`]: the types of the arguments decide.
    Open(u32),
}

/// What the passes have found out. Names are keys together with their instance.
#[derive(Default)]
pub(crate) struct Tables {
    pub(crate) uses: FastMap<Key, Use>,
    /// What calls may stand for until the types are known.
    pub(crate) open: Vec<Vec<Use>>,
    /// Types of attributes, constants, functions, parameters and locals by the name in the declaration; of Rust values and
    /// Rust calls by their first token. No entry: it could not be told.
    pub(crate) types: FastMap<Key, Type>,
    /// By index of the attribute.
    pub(crate) attrs: Vec<AttrInfo>,
    /// By style of the root: the index of the rule that a run begins with.
    pub(crate) starts: Vec<Option<u32>>,
    /// By the name of a rule.
    pub(crate) rules: HashMap<Key, RuleInfo>,
    /// By the name of an import.
    pub(crate) imports: HashMap<Key, ImportInfo>,
    /// `@RuleFileDescription`.
    pub(crate) about: String,
    /// Attributes, then constants, then functions, as one numbering: each after those it needs, as far as there is such
    /// an order.
    pub(crate) order: Vec<usize>,
    /// Functions that can reach themselves, by index.
    pub(crate) recursive: HashSet<u32>,
    /// Attributes and constants on a cycle that conditions may keep open, in the numbering of `order`.
    pub(crate) lazy: HashSet<usize>,
    /// Attributes that a dynamic call gives values to, by the name there.
    pub(crate) targets: HashMap<Key, u32>,
    /// Calls that cannot run yet though others of their name do, by their name.
    pub(crate) later: HashSet<Key>,
    /// Constants that serve as levels, by index: rules only compare them with numbers.
    pub(crate) levels: HashSet<u32>,
    /// Default values of overridden attributes that somebody asks for, by index of the constant.
    pub(crate) origins: HashSet<u32>,
}

impl Tables {
    /// The entries of an instance.
    pub(crate) fn at(&self, own: InstanceId) -> Entries<'_> {
        Entries { tables: self, own }
    }
}

/// The entries of the side tables for the names of one instance.
#[derive(Clone, Copy)]
pub(crate) struct Entries<'t> {
    tables: &'t Tables,
    own: InstanceId,
}

impl Entries<'_> {
    /// What a name stands for.
    pub(crate) fn of(self, name: &Name) -> Option<Use> {
        self.tables.uses.get(&(self.own, name.id())).copied()
    }

    /// The type of a name that is declared.
    pub(crate) fn ty(self, name: &Name) -> Option<Type> {
        self.tables.types.get(&(self.own, name.id())).copied()
    }
}
