//! Declarations of all instances of all files, and the lookup of names.

mod overrides;

use crate::link::{InstanceId, Key, Program};
use crate::ops;
use crate::resolve::tables::{Tables, Use};
use crate::suggest::nearest;
use crate::syntax::ast::{Body, Decl, Expr, Name, OpKind, Role};
use crate::syntax::walk;
use crate::types::Type;
use std::cell::Cell;
use std::collections::{HashMap, HashSet};

/// All declarations. Indices count the items of a kind: instance by instance, in source order.
pub(crate) struct Globals<'a> {
    pub(crate) program: &'a Program,
    pub(crate) attrs: Vec<Declared<'a>>,
    pub(crate) consts: Vec<Declared<'a>>,
    pub(crate) functions: Vec<Declared<'a>>,
    pub(crate) rules: Vec<Declared<'a>>,
    names: Vec<NameTable<'a>>,
    /// The remaining number of suggestions.
    hints: Cell<u32>,
}

/// The maximum number of diagnostics that suggest a name of the grammar. It bounds the time for a large file with a
/// mistake on each line.
const MOST_HINTS: u32 = 100;

/// The maximum number of overloads of a name with the same number of parameters. There are hardly that many types,
/// and each call visits all overloads.
const MOST_OVERLOADS: usize = 64;

/// A declaration in an instance.
#[derive(Clone)]
pub(crate) struct Declared<'a> {
    pub(crate) decl: &'a Decl,
    /// The instance that contains it.
    pub(crate) instance: InstanceId,
    /// The instance in which its names are looked up: another one for a rule that overrides an extension of an
    /// import.
    pub(crate) home: InstanceId,
    /// The instance that has its entries in the side tables: `home`, or the number of its types.
    pub(crate) own: InstanceId,
    /// The name with the prefixes of imports: `imp.height`.
    pub(crate) name: String,
    /// The origin of its value.
    pub(crate) init: Initializer<'a>,
    /// The distance of its style from the one in force.
    pub(crate) rank: usize,
    /// True for the value that an overridden attribute would have without the override.
    pub(crate) origin: bool,
}

/// The origin of the value of an attribute.
#[derive(Clone, Copy)]
pub(crate) enum Initializer<'a> {
    /// The declaration.
    Own,
    /// An override in an import. Its names are looked up in the importing instance.
    Override(&'a Expr, InstanceId),
    /// The attribute of the same name in the importing file.
    Flows(u32),
}

/// The meaning of names in an instance.
#[derive(Default)]
struct NameTable<'a> {
    /// Attributes, constants and functions without parameters.
    values: HashMap<&'a str, Use>,
    functions: HashMap<&'a str, Vec<u32>>,
    rules: HashMap<&'a str, Vec<u32>>,
    /// Rules that replace extensions, for calls inside the instance.
    replaced: HashMap<&'a str, u32>,
    /// Rules marked with `start`.
    start: Vec<u32>,
    /// Names that may be declared in unreadable text.
    lost: HashSet<&'a str>,
    /// Default values of overridden attributes, which the overriding expression may use.
    origins: HashMap<&'a str, u32>,
}

impl<'a> Declared<'a> {
    /// The expression of its value, and the instance that has the entries of its names; `None` for a rule.
    pub(crate) fn value(&self) -> Option<(&'a Expr, InstanceId)> {
        match self.init {
            Initializer::Own => self.decl.value().map(|value| (value, self.own)),
            Initializer::Override(value, home) => Some((value, home)),
            Initializer::Flows(_) => None,
        }
    }

    /// Its key in the side tables.
    pub(crate) fn key(&self) -> Key {
        (self.own, self.decl.name.id())
    }

    /// The type of its value, if known.
    pub(crate) fn ty(&self, tables: &Tables) -> Option<Type> {
        tables.at(self.own).ty(&self.decl.name)
    }

    /// The types of its parameters.
    pub(crate) fn types_of_params(&self, tables: &Tables) -> Vec<Option<Type>> {
        self.decl.params.iter().map(|param| tables.at(self.own).ty(param)).collect()
    }

    /// Returns true if its value is the value of the declaration, which may use the parameters and locals.
    pub(crate) fn is_own(&self) -> bool {
        matches!(self.init, Initializer::Own)
    }
}

impl<'a> Globals<'a> {
    pub(crate) fn new(program: &'a Program) -> Self {
        let names = program.instances.iter().map(|_| NameTable::default()).collect();
        let hints = Cell::new(MOST_HINTS);
        let mut globals = Globals {
            program,
            attrs: Vec::new(),
            consts: Vec::new(),
            functions: Vec::new(),
            rules: Vec::new(),
            names,
            hints,
        };
        let mut typed = program.typed_declarations();
        for instance in 0..program.instances.len() {
            globals.collect(instance, typed.remove(&instance).unwrap_or_default());
        }
        globals.take_overrides();
        globals
    }

    /// Collects the declarations of an instance that count with its style in force. `typed` are those with types of
    /// their own.
    fn collect(&mut self, id: InstanceId, typed: Vec<(InstanceId, &'a Decl)>) {
        let instance = &self.program.instances[id];
        let ast = &instance.file.ast;
        self.names[id].lost = ast.lost.iter().map(String::as_str).collect();
        let decls = || ast.decls.iter().map(|decl| (id, decl)).chain(typed.iter().copied());
        // A declaration replaces another one of a style further down.
        let mut nearest: HashMap<(&str, usize), usize> = HashMap::new();
        let mut counts: HashMap<((&str, usize), usize), usize> = HashMap::new();
        for (_, decl) in decls().filter(|_| !ast.styles.is_empty()) {
            if let Some(rank) = instance.styles.rank(decl.style) {
                nearest.entry(decl.form()).and_modify(|least| *least = rank.min(*least)).or_insert(rank);
                *counts.entry((decl.form(), rank)).or_default() += 1;
            }
        }
        for (own, decl) in decls() {
            let Some(rank) = instance.styles.rank(decl.style) else { continue };
            // Only the types can choose among overloads. All of them stay, and the nearest is tried first.
            let overloads = counts.get(&(decl.form(), rank)).is_some_and(|count| 1 < *count);
            if !overloads && nearest.get(&decl.form()).is_some_and(|least| *least < rank) {
                continue;
            }
            let item = Declared {
                decl,
                instance: id,
                home: id,
                own,
                name: format!("{}{}", instance.prefix, decl.name.text),
                init: Initializer::Own,
                rank,
                origin: false,
            };
            match decl.body {
                Body::Attr(_) => self.attrs.push(item),
                Body::Const(_) => self.consts.push(item),
                Body::Function(_) => self.functions.push(item),
                Body::Rule(_) => self.rules.push(item),
            }
        }
    }

    /// Fills the tables of names. A name that is already declared goes to `twice`.
    pub(super) fn name<'s>(&'s mut self, mut twice: impl FnMut(&Declared<'a>, &Declared<'a>)) {
        let mut found: Vec<(&Declared<'a>, Use)> = Vec::new();
        let mut enter = |items: &'s [Declared<'a>], make: fn(u32) -> Use| {
            found.extend(items.iter().zip((0..).map(make)).filter(|(item, _)| !item.origin));
        };
        enter(&self.attrs, Use::Attr);
        enter(&self.consts, Use::Const);
        enter(&self.functions, Use::Function);
        found.sort_by_key(|(item, ..)| (item.own, item.decl.name.id()));
        for (item, own) in found {
            let (name, names) = (item.decl.name.text.as_str(), &mut self.names[item.instance]);
            if let Use::Function(index) = own {
                overload(names.functions.entry(name).or_default(), index, &self.functions);
                if !item.decl.params.is_empty() {
                    continue;
                }
            }
            match names.values.get(name) {
                // Functions are compared by their types later.
                Some(Use::Function(_)) if matches!(own, Use::Function(_)) => {}
                Some(Use::Attr(first)) => twice(item, &self.attrs[*first as usize]),
                Some(Use::Const(first)) => twice(item, &self.consts[*first as usize]),
                Some(Use::Function(first)) => twice(item, &self.functions[*first as usize]),
                _ => _ = names.values.insert(name, own),
            }
        }
        // The parts that a dynamic call starts again are an instance of their own.
        let mut renewed: HashMap<(InstanceId, &str), Vec<InstanceId>> = HashMap::new();
        for (id, instance) in self.program.instances.iter().enumerate() {
            if let (Some(parent), true) = (instance.parent, 1 < instance.layers.len()) {
                renewed.entry((parent, &instance.prefix)).or_default().push(id);
            }
        }
        for (index, item) in self.rules.iter().enumerate() {
            // A rule that replaces an extension is only found from inside.
            if item.home != item.instance {
                continue;
            }
            let name = item.decl.name.text.as_str();
            let names = &mut self.names[item.instance];
            overload(names.rules.entry(name).or_default(), index as u32, &self.rules);
            if item.decl.role == Role::Start {
                names.start.push(index as u32);
            }
            // `id.Name --> …` continues a leaf of the imported file.
            if let Some((import, rest)) = name.split_once('.')
                && let Some(Some(target)) = self.program.instances[item.instance].imports.get(import)
            {
                let prefix = self.program.instances[*target].prefix.as_str();
                let others = renewed.get(&(item.instance, prefix)).into_iter().flatten();
                for target in [target].into_iter().chain(others) {
                    self.names[*target].rules.entry(rest).or_default().insert(0, index as u32);
                }
            }
        }
    }

    /// Follows the names of imports to an instance and the rest of the name. `None` leads to a file that could not be
    /// read.
    fn way<'n>(&self, from: InstanceId, name: &'n str) -> Option<(InstanceId, &'n str)> {
        let (mut at, mut rest) = (from, name);
        while let Some((first, behind)) = rest.split_once('.') {
            match self.program.instances[at].imports.get(first) {
                Some(Some(next)) => (at, rest) = (*next, behind),
                Some(None) => return None,
                // The import itself could not be read.
                None if self.names[at].lost.contains(first) => return None,
                None => break,
            }
        }
        Some((at, rest))
    }

    /// Returns true if a name may be declared in unreadable text.
    pub(crate) fn is_lost(&self, from: InstanceId, name: &str) -> bool {
        self.way(from, name)
            .is_none_or(|(at, rest)| self.program.instances[at].file.is_torn || self.names[at].lost.contains(rest))
    }

    /// The attribute, constant or function without parameters with a name.
    pub(crate) fn value(&self, from: InstanceId, name: &str) -> Option<Use> {
        let (at, rest) = self.way(from, name)?;
        self.names[at].values.get(rest).copied()
    }

    /// The value that an overridden attribute would have without the override.
    pub(crate) fn origin(&self, from: InstanceId, name: &str) -> Option<u32> {
        let (at, rest) = self.way(from, name)?;
        self.names[at].origins.get(rest).copied()
    }

    /// The functions with a name.
    pub(crate) fn functions(&self, from: InstanceId, name: &str) -> &[u32] {
        let list = self.way(from, name).and_then(|(at, rest)| self.names[at].functions.get(rest));
        list.map(Vec::as_slice).unwrap_or_default()
    }

    /// The rules with a name; `start` means the rules marked with it.
    pub(crate) fn rules(&self, from: InstanceId, name: &str) -> Vec<u32> {
        // A dotted name that continues a leaf of an import is declared here.
        if let Some(list) = self.names[from].rules.get(name).filter(|_| name.contains('.')) {
            return list.clone();
        }
        let Some((at, rest)) = self.way(from, name) else { return Vec::new() };
        let names = &self.names[at];
        if let Some(&rule) = names.replaced.get(rest).filter(|_| at == from) {
            return vec![rule];
        }
        match names.rules.get(rest) {
            Some(list) => list.clone(),
            None if rest == "start" => names.start.clone(),
            None => Vec::new(),
        }
    }

    /// The rules with a name as the instance declares them, without replacements.
    pub(crate) fn plain_rules(&self, id: InstanceId, name: &str) -> &[u32] {
        self.names[id].rules.get(name).map(Vec::as_slice).unwrap_or_default()
    }

    /// The declaration that a name means.
    pub(crate) fn item(&self, found: Use) -> Option<&Declared<'a>> {
        let (items, index) = match found {
            Use::Attr(index) => (&self.attrs, index),
            Use::Const(index) => (&self.consts, index),
            Use::Function(index) => (&self.functions, index),
            Use::Rule(index) => (&self.rules, index),
            _ => return None,
        };
        items.get(index as usize)
    }

    /// All items with a value: attributes, constants, functions.
    pub(crate) fn values(&self) -> impl Iterator<Item = &Declared<'a>> + '_ {
        self.attrs.iter().chain(&self.consts).chain(&self.functions)
    }

    /// The number of an attribute, constant or function among all [`values`](Globals::values).
    pub(crate) fn number(&self, found: Use) -> Option<usize> {
        match found {
            Use::Attr(index) => Some(index as usize),
            Use::Const(index) => Some(self.attrs.len() + index as usize),
            Use::Function(index) => Some(self.attrs.len() + self.consts.len() + index as usize),
            _ => None,
        }
    }

    /// The values that several styles declare, by name and number of parameters. Overloads of a style are left out,
    /// because it is not known which of them correspond.
    pub(crate) fn by_style(&self) -> Vec<Vec<&Declared<'a>>> {
        let style = |item: &Declared| self.program.instances[item.instance].root_style;
        let mut groups: HashMap<(&str, usize), Vec<&Declared<'a>>> = HashMap::new();
        for item in self.values().filter(|item| !item.origin && 1 < self.program.roots.len()) {
            groups.entry((&item.name, item.decl.params.len())).or_default().push(item);
        }
        let overloads = |group: &Vec<&Declared>| group.windows(2).any(|pair| style(pair[0]) == style(pair[1]));
        groups.into_values().filter(|group| !overloads(group)).collect()
    }

    /// All items.
    pub(crate) fn items(&self) -> impl Iterator<Item = &Declared<'a>> + '_ {
        self.rules.iter().chain(self.values())
    }

    /// The declared name that may be meant by `name`. If `name` begins with the name of an import, the imported names
    /// are searched, otherwise also `others`.
    pub(crate) fn meant<'o>(
        &self,
        from: InstanceId,
        name: &str,
        kind: Namespace,
        others: impl IntoIterator<Item = &'o str>,
    ) -> Option<String> {
        let (at, rest) = self.way(from, name)?;
        if at != from {
            let near = nearest(rest, self.near(at, kind))?;
            return Some(format!("{}{near}", &name[..name.len() - rest.len()]));
        }
        let own = nearest(name, self.near(from, kind)).map(str::to_owned);
        let other = nearest(name, others).map(str::to_owned);
        nearest(name, own.iter().chain(&other).map(String::as_str)).map(str::to_owned)
    }

    /// The leaf of an instance with a similar name, with its dot.
    pub(crate) fn leaf(&self, from: InstanceId, name: &str) -> Option<String> {
        self.hints.get().checked_sub(1)?;
        let mut leaves: Vec<&str> = Vec::new();
        for item in self.rules.iter().filter(|item| item.home == from) {
            if let Body::Rule(ops) = &item.decl.body {
                leaves.extend(walk::ops(ops).filter_map(|op| match &op.kind {
                    OpKind::Leaf(leaf) if leaf.text != name => Some(leaf.text.as_str()),
                    _ => None,
                }));
            }
        }
        leaves.sort_unstable();
        leaves.dedup();
        nearest(name, leaves).map(|near| format!("{near}."))
    }

    /// The names declared in an instance, sorted; empty after the maximum number of suggestions.
    pub(crate) fn near(&self, from: InstanceId, kind: Namespace) -> Vec<&'a str> {
        let names = &self.names[from];
        let Some(left) = self.hints.get().checked_sub(1) else { return Vec::new() };
        self.hints.set(left);
        let mut list: Vec<&'a str> = match kind {
            Namespace::Values => names.values.keys().copied().collect(),
            Namespace::Attrs => {
                let attr = |(name, found): (&&'a str, &Use)| matches!(found, Use::Attr(_)).then_some(*name);
                names.values.iter().filter_map(attr).collect()
            }
            Namespace::Functions => names.functions.keys().copied().collect(),
            Namespace::Rules => names.rules.keys().copied().collect(),
            Namespace::Extensions => {
                let decls = names.rules.values().flatten().map(|index| self.rules[*index as usize].decl);
                decls.filter(|decl| decl.role == Role::Extension).map(|decl| decl.name.text.as_str()).collect()
            }
            Namespace::Imports => self.program.instances[from].imports.keys().map(String::as_str).collect(),
        };
        list.sort_unstable();
        list
    }
}

/// The kind of names to suggest.
#[derive(Clone, Copy)]
pub(crate) enum Namespace {
    Values,
    Attrs,
    Functions,
    Rules,
    Extensions,
    Imports,
}

/// Adds to the declarations of a name.
fn overload(list: &mut Vec<u32>, index: u32, items: &[Declared]) {
    let params = |index: u32| items[index as usize].decl.params.len();
    // The last declarations are counted first, in case a name is declared ten thousand times.
    if list.iter().rev().filter(|other| params(**other) == params(index)).take(MOST_OVERLOADS).count() < MOST_OVERLOADS
    {
        // The nearest style comes first, because the first of several fitting overloads is taken.
        let style = |index: u32| items[index as usize].rank;
        let at = list.partition_point(|other| style(*other) <= style(index));
        list.insert(at, index);
    }
}

impl Body {
    /// The kind of declaration.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Body::Attr(_) => "attribute",
            Body::Const(_) => "constant",
            Body::Function(_) => "function",
            Body::Rule(_) => "rule",
        }
    }
}

impl Decl {
    /// The expression of its value, unless it is a rule.
    pub(crate) fn value(&self) -> Option<&Expr> {
        match &self.body {
            Body::Attr(value) | Body::Const(value) | Body::Function(value) => Some(value),
            Body::Rule(_) => None,
        }
    }

    /// Its name and number of parameters.
    pub(crate) fn form(&self) -> (&str, usize) {
        (&self.name.text, self.params.len())
    }

    /// The parameters, then the locals, as numbered by [`Use::Param`].
    pub(crate) fn inner(&self) -> impl Iterator<Item = &Name> {
        self.params.iter().chain(self.locals.iter().map(|(name, _)| name))
    }
}

/// The functions of the language with a name that take `count` arguments.
pub(crate) fn builtins(name: &str, count: usize) -> Vec<&'static ops::Function> {
    ops::functions(name).filter(|row| row.takes(count)).collect()
}
