//! Side tables: the results of the passes, by name.

use super::info::{ImportInfo, RuleInfo};
use crate::hash::FastMap;
use crate::ir::AttrInfo;
use crate::link::{InstanceId, Key};
use crate::ops::{Function, Operation, ShapeAttr};
use crate::syntax::ast::{Expr, ExprKind, Name};
use crate::types::Type;
use std::collections::{HashMap, HashSet};

/// The meaning of a name or call.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Use {
    /// A parameter or local.
    Param(u32),
    Attr(u32),
    Const(u32),
    Function(u32),
    Builtin(&'static Function),
    /// A value converted to its own type (`float` of a float), or a float or bool converted to text (`str`).
    Convert(Type),
    Shape(&'static ShapeAttr),
    Rule(u32),
    /// A call without a rule, where that is not an error.
    Leaf,
    Operation(&'static Operation),
    SetAttr(u32),
    SetShape(&'static ShapeAttr),
    Selector(&'static str),
    /// One of several candidates, by number into [`Tables::open`]. The types of the arguments decide.
    Open(u32),
}

/// The results of the passes. The keys are names with their instances.
#[derive(Default)]
pub(crate) struct Tables {
    pub(crate) uses: FastMap<Key, Use>,
    /// The candidates of calls until the types are known.
    pub(crate) open: Vec<Vec<Use>>,
    /// Types of attributes, constants, functions, parameters and locals by the name in the declaration; of Rust
    /// values and Rust calls by their first token. An unknown type has no entry.
    pub(crate) types: FastMap<Key, Type>,
    /// By index of the attribute.
    pub(crate) attrs: Vec<AttrInfo>,
    /// The index of the start rule, by style of the root.
    pub(crate) starts: Vec<Option<u32>>,
    /// By the name of a rule.
    pub(crate) rules: HashMap<Key, RuleInfo>,
    /// By the name of an import.
    pub(crate) imports: HashMap<Key, ImportInfo>,
    /// `@RuleFileDescription`.
    pub(crate) about: String,
    /// Attributes, then constants, then functions, in one numbering. Each comes after the values that it needs, if
    /// such an order exists.
    pub(crate) order: Vec<usize>,
    /// Recursive functions, by index.
    pub(crate) recursive: HashSet<u32>,
    /// Attributes and constants on a cycle that conditions may break, in the numbering of `order`.
    pub(crate) lazy: HashSet<usize>,
    /// The attributes that dynamic calls give values to, by their name in the call.
    pub(crate) targets: HashMap<Key, u32>,
    /// Constants that serve as levels, by index: rules only compare them with numbers.
    pub(crate) levels: HashSet<u32>,
    pub(crate) given_tags: GivenTags,
    /// Default values of overridden attributes that are used, by index of the constant.
    pub(crate) origins: HashSet<u32>,
}

/// The tags that the rules of a program give themselves.
#[derive(Debug, Default)]
pub(crate) struct GivenTags {
    pub(crate) names: Vec<String>,
    /// True if there may be others: a name is computed, or files that import this one may give them.
    pub(crate) has_others: bool,
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
    /// The meaning of a name.
    pub(crate) fn of(self, name: &Name) -> Option<Use> {
        self.tables.uses.get(&(self.own, name.id())).copied()
    }

    /// Calls `visit` with the meaning of each name in an expression.
    pub(crate) fn uses(self, expr: &Expr, visit: &mut dyn FnMut(Option<Use>)) {
        if let ExprKind::Name(name) | ExprKind::Call(name, _) = &expr.kind {
            visit(self.of(name));
        }
        expr.parts().into_iter().for_each(|part| self.uses(part, visit));
    }

    /// The type of a declared name.
    pub(crate) fn ty(self, name: &Name) -> Option<Type> {
        self.tables.types.get(&(self.own, name.id())).copied()
    }
}
