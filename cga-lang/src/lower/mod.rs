//! A checked program to [`ir`](crate::ir): names become indices, blocks become rules, constants are folded.

mod block;
mod body;
mod childless;
mod definition;
mod expr;
mod extent;
mod fold;
mod globals;
mod import;
mod merge;
mod share;
mod variant;

use crate::check::Checked;
use crate::graph::{components, is_cycle};
use crate::ir::walk::calls;
use crate::ir::{GlobalId, Grammar, Host, HostId, Init, Param, RenewalId, Rule, RuleId, Start, Step, Type};
use crate::link::{InstanceId, Key};
use crate::lower::fold::Folded;
use crate::resolve::globals::Declared;
use crate::resolve::info::RuleInfo;
use crate::resolve::tables::Use;
use crate::syntax::ast::{Body, Decl, Name};
use crate::syntax::token::{Tok, Tokens};
use merge::DefinitionStyles;
use std::collections::HashMap;

/// Longest text of a rule kept for its doc line, in bytes.
const LONGEST_SOURCE: usize = 400;

/// Lowers a checked program.
pub(crate) fn lower(checked: &Checked) -> Grammar {
    let mut lower = Lower {
        checked,
        tokens: &checked.globals.program.tokens,
        inner: Vec::new(),
        own: 0,
        label: String::new(),
        name: String::new(),
        blocks: HashMap::new(),
        hosts: HashMap::new(),
        renewals: HashMap::new(),
        known: Folded::default(),
        owners: DefinitionStyles::default(),
        init: Vec::new(),
        out: Grammar::default(),
    };
    lower.hosts();
    lower.globals();
    lower.rules();
    lower.merge();
    cycles(&mut lower.out);
    if share::share(&mut lower.out) {
        cycles(&mut lower.out);
    }
    extent::solve_known(&mut lower.out);
    lower.out
}

struct Lower<'c> {
    checked: &'c Checked<'c>,
    tokens: &'c Tokens,
    /// Parameters and locals of the declaration at hand.
    inner: Vec<&'c Name>,
    /// The instance whose entries its names have.
    own: InstanceId,
    /// The name of implicit leaves of the current rule.
    label: String,
    /// Name of the rule at hand, with its style.
    name: String,
    /// Blocks so far, by the name of their rule.
    blocks: HashMap<String, u32>,
    /// By instance and token.
    hosts: HashMap<Key, HostId>,
    /// By instance.
    renewals: HashMap<InstanceId, RenewalId>,
    /// Constants and functions whose value is known.
    known: Folded,
    owners: DefinitionStyles,
    /// By style: attributes and constants in an order in which each is ready before it is used.
    init: Vec<Vec<GlobalId>>,
    out: Grammar,
}

impl<'c> Lower<'c> {
    /// The type of a name or Rust value in the declaration at hand, by its first token.
    fn ty(&self, token: u32) -> Type {
        self.checked.tables.types.get(&(self.own, token)).copied().unwrap_or(Type::Float)
    }

    fn type_of(&self, item: &Declared) -> Type {
        item.ty(&self.checked.tables).unwrap_or(Type::Float)
    }

    fn used(&self, name: &Name) -> Option<Use> {
        self.checked.tables.at(self.own).of(name)
    }

    /// The style of the compiled file that a declaration belongs to.
    fn style(&self, item: &Declared) -> u32 {
        self.checked.globals.program.instances[item.instance].root_style
    }

    /// One definition for each name, whatever the number of styles.
    fn merge(&mut self) {
        match &self.init[..] {
            [only] => self.out.init = only.iter().map(|&global| Init { global, styles: None }).collect(),
            init => merge::merge(&mut self.out, &self.owners, init),
        }
    }

    /// Rust values. One that is used in several instances is computed once, for each type.
    fn hosts(&mut self) {
        let tokens = self.tokens.as_slice();
        let is_host = |(_, token): &&Key| matches!(tokens[*token as usize], Tok::Host(_));
        let mut keys: Vec<Key> = self.checked.tables.types.keys().filter(is_host).copied().collect();
        keys.sort_unstable();
        let mut numbers: HashMap<(u32, Type), HostId> = HashMap::new();
        for key @ (_, token) in keys {
            let (Tok::Host(handle), ty) = (&tokens[token as usize], self.checked.tables.types[&key]) else { continue };
            let next = HostId(self.out.hosts.len() as u32);
            let id = *numbers.entry((*handle, ty)).or_insert(next);
            if id == next {
                self.out.hosts.push(Host { handle: *handle, ty });
            }
            self.hosts.insert(key, id);
        }
    }

    /// Begins with a declaration.
    fn enter(&mut self, item: &Declared<'c>) {
        self.inner = item.decl.inner().collect();
        self.own = item.own;
    }

    /// Parameters and locals of the declaration at hand.
    fn declared_params(&self) -> Vec<Param> {
        let param = |name: &&Name| Param { name: name.text.clone(), ty: self.ty(name.id()) };
        self.inner.iter().map(param).collect()
    }

    fn locals(&mut self, decl: &'c Decl) -> Vec<crate::ir::Expr> {
        decl.locals.iter().map(|(_, value)| self.folded(value)).collect()
    }

    fn rules(&mut self) {
        let checked = self.checked;
        for item in &checked.globals.rules {
            self.enter(item);
            let style = self.style(item);
            self.owners.rules.push(style);
            let style = checked.globals.program.roots.get(style as usize);
            let style = style.and_then(|&root| checked.globals.program.instances[root].styles.name.as_deref());
            self.out.rules.push(Rule {
                name: style.map_or_else(|| item.name.clone(), |style| format!("{style}${}", item.name)),
                label: item.name.clone(),
                params: self.declared_params(),
                source: self.tokens.text(item.decl.span, LONGEST_SOURCE, '\''),
                span: item.decl.name.span,
                ..Rule::default()
            });
        }
        for (index, item) in checked.globals.rules.iter().enumerate() {
            if let Body::Rule(ops) = &item.decl.body {
                self.enter(item);
                self.label.clone_from(&item.name);
                self.name.clone_from(&self.out.rules[index].name);
                self.out.rules[index].locals = self.locals(item.decl);
                let body = self.steps(ops);
                self.finish(index, body);
            }
        }
        self.out.about.clone_from(&checked.tables.about);
        self.starts();
    }

    /// Rules without parameters of the root, in each style.
    fn starts(&mut self) {
        let (globals, starts) = (&self.checked.globals, &self.checked.tables.starts);
        for (style, (&root, &default)) in globals.program.roots.iter().zip(starts).enumerate() {
            let rules = globals.rules.iter().enumerate();
            let own = rules.filter(|(_, item)| {
                item.instance == root
                    && item.home == root
                    && item.decl.params.is_empty()
                    && !item.decl.name.text.contains('.')
            });
            let mut own: Vec<u32> = own.map(|(index, _)| index as u32).collect();
            own.sort_by_key(|&index| (Some(index) != default, index));
            for index in own {
                let name = self.out.rules[index as usize].name.clone();
                let info = self.checked.tables.rules.get(&globals.rules[index as usize].key());
                let RuleInfo { doc, marked, hidden } = info.cloned().unwrap_or_default();
                self.out.starts.push(Start { name, style: style as u32, rule: RuleId(index), doc, marked, hidden });
            }
        }
    }

    /// Puts a body into its rule.
    fn finish(&mut self, rule: usize, body: Vec<Step>) {
        self.out.rules[rule].leaf = childless::of(&body);
        self.out.rules[rule].body = body;
    }
}

/// Numbers the cycles of rules.
fn cycles(grammar: &mut Grammar) {
    let edges = calls(grammar, |_| true);
    let mut count = 0;
    for component in components(&edges) {
        if is_cycle(&component, &edges) {
            for rule in component {
                grammar.rules[rule].cycle = Some(count);
            }
            count += 1;
        }
    }
}
