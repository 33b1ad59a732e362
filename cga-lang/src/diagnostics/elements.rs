//! The elements of arrays that are written as a list or as a `comp`.

use crate::analysis::interval::Interval;
use crate::analysis::{AbstractState, DataFlow, Value};
use crate::resolve::context::Context;
use crate::resolve::tables::Use;
use crate::span::Span;
use crate::syntax::ast::{Expr, ExprKind};

/// The longest chain of constants that is followed. Constants may be declared in a circle.
const MOST_NAMES: usize = 8;

/// An element of an array.
pub(crate) struct Element {
    /// Its possible values; `None` for a range or an array in the array.
    pub(crate) number: Option<Interval>,
    /// Its place; `None` for the element 0 of components that no arm selects.
    pub(crate) span: Option<Span>,
}

/// The elements of an array. It is empty for an array that is computed otherwise. Constants are followed to their
/// declarations.
pub(crate) fn elements(array: &Expr, facts: &AbstractState, flow: &DataFlow, cx: &Context) -> Vec<Element> {
    let (mut array, mut facts) = (array, facts.clone());
    for _ in 0..MOST_NAMES {
        let Some((value, inside)) = declared(array, &facts, cx) else { break };
        (array, facts) = (value, inside);
    }
    let element = |value: &Expr, facts: &AbstractState| {
        let number = match flow.value(value, facts) {
            Value::Number(number) if !matches!(value.kind, ExprKind::Range(..)) => Some(number),
            _ => None,
        };
        Element { number, span: Some(value.span) }
    };
    match &array.kind {
        ExprKind::Array(rows) => rows.iter().flatten().map(|value| element(value, &facts)).collect(),
        ExprKind::Comp(comp) => {
            // Values are computed on the components.
            let component = facts.on_any_shape();
            let arms = comp.arms.iter().map(|(_, _, value)| element(value, &component));
            let rest = Element { number: Some(Interval::ZERO), span: None };
            arms.chain([rest]).collect()
        }
        _ => Vec::new(),
    }
}

/// The value of a name that always has the same one, with the facts where it is computed.
fn declared<'a>(name: &Expr, facts: &AbstractState, cx: &Context<'a, '_>) -> Option<(&'a Expr, AbstractState)> {
    let ExprKind::Name(name) = &name.kind else { return None };
    let globals = &cx.globals;
    let item = match cx.tables.at(facts.own).of(name)? {
        Use::Const(index) => &globals.consts[index as usize],
        Use::Function(index) => &globals.functions[index as usize],
        _ => return None,
    };
    let (value, own) = item.value()?;
    Some((value, AbstractState::any(own, item.decl.params.len() + item.decl.locals.len())))
}
