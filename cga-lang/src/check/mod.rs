//! What a tree means, and what is wrong with it.
//!
//! Passes read the tree and write side tables and findings; all of them run. What could not be resolved has no entry
//! in a table, and nothing more is said about it. [`Checked`] is made only when there was no error.

mod annotations;
mod arity;
mod cycles;
mod levels;
mod names;
mod shapes;
mod types;
mod unify;

use crate::ast::{Ast, Body, Decl, Expr, Name};
use crate::code::Code;
use crate::diag::{Diags, Level};
use crate::ir::Type;
use crate::ops::{Function, Operation, ShapeAttr};
use std::collections::{HashMap, HashSet};

pub use crate::compile::Door;
pub(crate) use annotations::AttrInfo;
pub(crate) use shapes::{split_adjust, split_axis};

/// What a name or call stands for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Use {
    Param(u32),
    Attr(u32),
    Const(u32),
    Function(u32),
    Builtin(&'static Function),
    /// `float`, `bool` or `str`.
    Convert(Type),
    Shape(&'static ShapeAttr),
    Rule(u32),
    /// A call without a rule where that is no error.
    Leaf,
    Operation(&'static Operation),
    SetAttr(u32),
    SetShape(&'static ShapeAttr),
    Selector(&'static str),
}

/// Declarations by kind, and by name. Indices count the declarations of a kind in source order.
pub(crate) struct Globals<'a> {
    pub(crate) attrs: Vec<&'a Decl>,
    pub(crate) consts: Vec<&'a Decl>,
    pub(crate) functions: Vec<&'a Decl>,
    pub(crate) rules: Vec<&'a Decl>,
    /// Attributes and constants.
    values: HashMap<&'a str, Use>,
    /// By number of parameters.
    functions_named: HashMap<&'a str, Vec<(usize, u32)>>,
    rules_named: HashMap<&'a str, Vec<(usize, u32)>>,
    /// Names that may be declared where something could not be read.
    lost: HashSet<&'a str>,
}

/// What the passes have found out.
#[derive(Default)]
pub(crate) struct Tables {
    /// By [`Name::id`].
    pub(crate) uses: HashMap<u32, Use>,
    /// Types of attributes, constants, functions and parameters by [`Name::id`] of the declaration; of Rust values
    /// and Rust calls by their first token. No entry: it could not be told.
    pub(crate) types: HashMap<u32, Type>,
    /// By index of the attribute.
    pub(crate) attrs: Vec<AttrInfo>,
    /// The index of the rule a run begins with.
    pub(crate) start: Option<u32>,
    /// Attributes, then constants, then functions, as one numbering: each after those it needs, as far as there is such
    /// an order.
    pub(crate) order: Vec<usize>,
    /// Functions that can reach themselves, by index.
    pub(crate) recursive: HashSet<u32>,
}

/// A tree without errors. Only this can be lowered.
pub struct Checked<'a> {
    pub(crate) globals: Globals<'a>,
    pub(crate) tables: Tables,
    _private: (),
}

/// What a check leaves behind.
pub struct Outcome<'a> {
    /// The tree, if it had no error.
    pub checked: Option<Checked<'a>>,
    /// The attributes with their types, as far as they could be told.
    pub attrs: Vec<(&'a Decl, Option<Type>)>,
}

/// Runs every pass. `levels` are those of the grammar as a whole; annotations in the tree come on top.
pub fn check<'a>(ast: &'a Ast, door: Door, levels: &[(Code, Level)], diags: &mut Diags) -> Outcome<'a> {
    let mut cx = Cx { globals: Globals::new(ast), tables: Tables::default(), door, levels: Vec::new(), diags };
    levels::collect(&mut cx, ast, levels);
    names::declarations(&mut cx);
    annotations::read(&mut cx, ast);
    names::uses(&mut cx);
    types::infer(&mut cx);
    cycles::find(&mut cx);
    let Cx { globals, tables, levels, diags, .. } = cx;
    levels::apply(&levels, diags);
    let attrs = globals.attrs.iter().map(|decl| (*decl, tables.types.get(&decl.name.id()).copied())).collect();
    let checked = (!diags.has_errors()).then_some(Checked { globals, tables, _private: () });
    Outcome { checked, attrs }
}

/// What every pass is given.
struct Cx<'a, 'd> {
    globals: Globals<'a>,
    tables: Tables,
    door: Door,
    levels: Vec<levels::Setting>,
    diags: &'d mut Diags,
}

impl<'a> Globals<'a> {
    fn new(ast: &'a Ast) -> Self {
        let of = |test: fn(&Body) -> bool| ast.decls.iter().filter(|decl| test(&decl.body)).collect::<Vec<&Decl>>();
        Globals {
            attrs: of(|body| matches!(body, Body::Attr(_))),
            consts: of(|body| matches!(body, Body::Const(_))),
            functions: of(|body| matches!(body, Body::Function(_))),
            rules: of(|body| matches!(body, Body::Rule(_))),
            values: HashMap::new(),
            functions_named: HashMap::new(),
            rules_named: HashMap::new(),
            lost: ast.lost.iter().map(String::as_str).collect(),
        }
    }

    fn rule(&self, name: &str, count: usize) -> Option<u32> {
        find(&self.rules_named, name, count)
    }

    fn function(&self, name: &str, count: usize) -> Option<u32> {
        find(&self.functions_named, name, count)
    }

    /// Everything with a value: attributes, constants, functions.
    fn values(&self) -> impl Iterator<Item = &'a Decl> + '_ {
        self.attrs.iter().chain(&self.consts).chain(&self.functions).copied()
    }
}

fn find(named: &HashMap<&str, Vec<(usize, u32)>>, name: &str, count: usize) -> Option<u32> {
    named.get(name)?.iter().find(|(own, _)| *own == count).map(|(_, index)| *index)
}

impl Tables {
    pub(crate) fn of(&self, name: &Name) -> Option<Use> {
        self.uses.get(&name.id()).copied()
    }
}

impl Decl {
    /// The expression it stands for, unless it is a rule.
    pub(crate) fn value(&self) -> Option<&Expr> {
        match &self.body {
            Body::Attr(value) | Body::Const(value) | Body::Function(value) => Some(value),
            Body::Rule(_) => None,
        }
    }
}
