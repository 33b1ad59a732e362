//! What a program means, and what is wrong with it.
//!
//! Passes read the trees and write side tables and findings; all of them run. What could not be resolved has no entry
//! in a table, and nothing more is said about it. [`Checked`] is made only when there was no error.

mod agreed;
mod annotations;
mod arithmetic;
mod arity;
mod assets;
mod bounds;
mod branches;
mod certain;
mod colour;
mod cycles;
mod defaults;
mod duplicates;
mod ends;
mod flow;
mod globals;
mod habits;
mod hidden;
mod interval;
mod levels;
mod names;
mod overrides;
mod reach;
mod repeat;
mod selectors;
mod shapes;
mod size;
mod texture;
mod trailing;
mod types;
mod unused;
mod words;

use crate::ast::Name;
use crate::code::Code;
use crate::diag::{Diags, Level};
use crate::hash::FastMap;
use crate::index::{Named, index};
use crate::ir::Type;
use crate::link::{InstanceId, Key, Program, Wanted};
use crate::ops::{Function, Operation, ShapeAttr};
use std::collections::{HashMap, HashSet};

pub use crate::compile::Door;
pub(crate) use annotations::{AttrInfo, ImportInfo, RuleInfo};
pub(crate) use globals::{Globals, Init, Item};
pub(crate) use selectors::{split_adjust, split_axis};

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

/// What the passes have found out.
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

/// A program without errors. Only this can be lowered.
pub struct Checked<'a> {
    pub(crate) globals: Globals<'a>,
    pub(crate) tables: Tables,
    _private: (),
}

/// What a check leaves behind.
pub(crate) struct Outcome<'a> {
    /// The program, if it had no error.
    pub(crate) checked: Option<Checked<'a>>,
    /// The attributes with their types, as far as they could be told.
    pub(crate) attrs: Vec<(Item<'a>, Option<Type>)>,
    /// Where names are declared and used.
    pub(crate) index: Vec<Named>,
    /// Whether something is of another type than is needed.
    pub(crate) misfit: bool,
    /// Declarations that calls want with other types. When there are some, only that was found out.
    pub(crate) wanted: Vec<Wanted>,
    /// Declarations with types of their own that do not suit them.
    pub(crate) unsuited: Vec<InstanceId>,
}

/// Runs every pass. `levels` are those of the grammar as a whole; annotations in the tree come on top.
/// What follows from sizes and calls is looked for when `program` is as it will be: `last` says that no more declarations
/// are instantiated, and without misfits none are.
pub(crate) fn check<'a>(program: &'a Program, levels: &[(Code, Level)], last: bool, diags: &mut Diags) -> Outcome<'a> {
    let mut cx = Cx { globals: Globals::new(program), tables: Tables::default(), levels: Vec::new(), at: 0, diags };
    levels::collect(&mut cx, levels);
    duplicates::values(&mut cx);
    overrides::check(&mut cx);
    names::uses(&mut cx);
    let types::Found { misfit, wanted, unsuited } = types::infer(&mut cx);
    if !wanted.is_empty() {
        return Outcome { checked: None, attrs: Vec::new(), index: Vec::new(), misfit, wanted, unsuited };
    }
    annotations::read(&mut cx);
    duplicates::operations(&mut cx);
    duplicates::overloads(&mut cx);
    duplicates::styles(&mut cx);
    cycles::find(&mut cx);
    if last || !misfit {
        certain::check(&mut cx);
    }
    let Cx { globals, tables, levels, diags, .. } = cx;
    levels::apply(&levels, diags);
    let ty = |item: &Item| tables.type_of(item);
    let attrs = globals.attrs.iter().map(|item| (item.clone(), ty(item))).collect();
    let index = if last || !misfit { index(&globals, &tables) } else { Vec::new() };
    let checked = (!diags.has_errors()).then_some(Checked { globals, tables, _private: () });
    Outcome { checked, attrs, index, misfit, wanted, unsuited }
}

/// What every pass is given.
struct Cx<'a, 'd> {
    globals: Globals<'a>,
    tables: Tables,
    levels: Vec<levels::Setting>,
    /// The instance that is looked at, for passes that go from one to the next.
    at: InstanceId,
    diags: &'d mut Diags,
}

impl Tables {
    /// The entries of an instance.
    pub(crate) fn at(&self, own: InstanceId) -> Entries<'_> {
        Entries { tables: self, own }
    }

    /// The type of a value that is declared.
    pub(crate) fn type_of(&self, item: &Item) -> Option<Type> {
        self.at(item.own).ty(&item.decl.name)
    }

    /// The types of its parameters.
    fn types_of_params(&self, item: &Item) -> Vec<Option<Type>> {
        item.decl.params.iter().map(|param| self.at(item.own).ty(param)).collect()
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
