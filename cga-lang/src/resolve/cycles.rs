//! Attributes and constants that need each other on every path, and functions that never end. A cycle that conditions
//! may break is computed lazily.

use super::context::Context;
use super::globals::{Declared, Globals, Initializer};
use super::tables::{Entries, Tables, Use};
use crate::diag::by_way_of;
use crate::diag::code::Code;
use crate::graph::{components, is_cycle};
use crate::link::InstanceId;
use crate::syntax::ast::{Expr, ExprKind};

/// The maximum number of names in a cycle that get a line each.
const MOST_TOLD: usize = 4;

/// Finds cycles among attributes, constants and functions, and the order in which values can be computed.
pub(crate) fn find(cx: &mut Context) {
    let items: Vec<&Declared> = cx.globals.values().collect();
    let edges: Vec<Vec<usize>> = items
        .iter()
        .map(|item| {
            let mut list = Vec::new();
            for (value, own) in values(item) {
                let number = |found: Option<Use>| cx.globals.number(found?);
                cx.tables.at(own).uses(value, &mut |found| list.extend(number(found)));
            }
            if let Initializer::Flows(outer) = item.init {
                list.push(outer as usize);
            }
            list.sort_unstable();
            list.dedup();
            list
        })
        .collect();
    let first_function = cx.globals.attrs.len() + cx.globals.consts.len();
    let mut ends = vec![false; items.len()];
    for component in components(&edges) {
        settle(&component, &items, &cx.tables, &cx.globals, &mut ends);
        let cyclic = is_cycle(&component, &edges);
        let is_value = |node: &usize| *node < first_function;
        let endless = component.iter().copied().find(|&node| !ends[node]);
        let value = component.iter().copied().find(|node| is_value(node) && !ends[*node]);
        // The other names of a cycle.
        let way = |node: usize| {
            let others = component.iter().filter(|&&other| other != node).map(|&other| {
                // The name is as written in the file of the blamed declaration, or as the main file writes it.
                let (other, near) = (items[other], items[other].instance == items[node].instance);
                if near { &other.decl.name.text } else { &other.name }
            });
            by_way_of(others)
        };
        if let (true, Some(node)) = (cyclic, value) {
            let name = &items[node].decl.name;
            let message = format!("`{}` needs its own value{}", name.text, way(node));
            let diag = cx.diags.report(Code::InitCycle, name.span, message);
            for &other in component.iter().filter(|&&other| other != node).take(MOST_TOLD) {
                let other = &items[other].decl.name;
                diag.related(format!("`{}` is declared", other.text), other.span);
            }
            diag.help(match component.len() {
                1 => "give it a value that does not need it, at least in one branch of a `case`",
                _ => "give one of them a value that does not need the others, at least in one branch of a `case`",
            });
        } else if let (true, Some(node)) = (cyclic, endless) {
            let item = items[node];
            cx.diags
                .report(
                    Code::EndlessFunction,
                    item.decl.name.span,
                    format!("`{}` calls itself{} and never ends", item.decl.name.text, way(node)),
                )
                .help("a recursive function needs a `case` with a branch that does not call it");
        }
        for &node in &component {
            cx.tables.order.push(node);
            if cyclic && is_value(&node) {
                cx.tables.lazy.insert(node);
            } else if cyclic {
                cx.tables.recursive.insert((node - first_function) as u32);
            }
        }
    }
}

/// The expressions that make up the value of an item, locals first, and the instance that has the entries of their
/// names.
fn values<'a>(item: &Declared<'a>) -> impl Iterator<Item = (&'a Expr, InstanceId)> {
    let own = item.own;
    let locals = item.is_own().then(|| item.decl.locals.iter().map(move |(_, value)| (value, own)));
    locals.into_iter().flatten().chain(item.value())
}

/// Marks the declarations of a component that can end: those with a path on which all calls can end.
fn settle(component: &[usize], items: &[&Declared], tables: &Tables, globals: &Globals, ends: &mut [bool]) {
    for _ in component {
        let mut changed = false;
        for &node in component {
            if !ends[node] && values(items[node]).all(|(value, own)| can_end(value, tables.at(own), globals, ends)) {
                ends[node] = true;
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
}

fn can_end(expr: &Expr, names: Entries, globals: &Globals, ends: &[bool]) -> bool {
    let can = |part: &Expr| can_end(part, names, globals, ends);
    let used = |name| names.of(name).and_then(|found| globals.number(found)).is_none_or(|node| ends[node]);
    match &expr.kind {
        ExprKind::Name(name) => used(name),
        ExprKind::Call(name, args) => used(name) && args.iter().all(can),
        ExprKind::Case(arms, otherwise) => {
            arms.first().is_none_or(|(first, _)| can(first))
                && (can(otherwise) || arms.iter().any(|(_, value)| can(value)))
        }
        // A value that no selector takes is never computed.
        ExprKind::Comp(comp) => {
            comp.arms.first().is_none_or(|(first, ..)| can(first)) && comp.arms.iter().any(|(_, _, value)| can(value))
        }
        ExprKind::Chance(arms, otherwise) => can(otherwise) || arms.iter().any(|(_, value)| can(value)),
        _ => expr.parts().into_iter().all(can),
    }
}
