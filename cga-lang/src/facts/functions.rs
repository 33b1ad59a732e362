//! Uses of functions, attributes and constants.

use std::collections::HashMap;

use super::closure::closure;
use super::{Facts, Uses};
use crate::ir::{AttrId, ConstId, Expr, ExprKind, Global, Grammar};
use crate::ir_walk;

impl Facts {
    /// Finds uses of functions, and of reading attributes and constants. An attribute or constant is a value of the run: the
    /// shape that reads it only counts where shapes may hold values of their own. One that is computed when it is first read
    /// asks the run where its value does.
    pub(super) fn find_functions(&mut self, grammar: &Grammar) {
        let held = |is_held: bool| if is_held { Uses::STATE } else { Uses::NONE };
        self.attrs = grammar.attrs.iter().map(|attr| held(attr.is_set)).collect();
        self.consts = grammar.consts.iter().map(|it| held(it.is_set && it.known.is_none())).collect();
        self.functions = vec![Uses::NONE; grammar.functions.len()];

        // Functions, then what is computed late.
        let count = grammar.functions.len();
        let late: Vec<Global> = grammar.globals().filter(|global| is_lazy(grammar, *global)).collect();
        let numbers: HashMap<Global, usize> = late.iter().copied().zip(count..).collect();
        let functions = grammar.functions.iter().map(|it| it.locals.iter().chain([&it.body]).collect());
        let nodes: Vec<Vec<&Expr>> = functions.chain(late.iter().map(|own| vec![value(grammar, *own)])).collect();
        let mut own: Vec<Uses> = nodes.iter().map(|exprs| self.exprs(exprs.iter().copied())).collect();
        for (own, function) in own.iter_mut().zip(&grammar.functions) {
            // The run counts calls.
            own.says |= function.recursive;
        }
        let reads: Vec<Vec<usize>> = nodes.iter().map(|exprs| read(exprs, &numbers)).collect();
        let calls: Vec<Vec<usize>> =
            reads[..count].iter().map(|read| read.iter().copied().filter(|&at| at < count).collect()).collect();

        let says = closure(&reads, &own.iter().map(|own| own.says).collect::<Vec<_>>());
        let mut functions = closure(&calls, &own[..count]);
        functions.iter_mut().zip(&says).for_each(|(uses, says)| uses.says |= says);
        self.functions = functions;
        for (global, says) in late.into_iter().zip(&says[count..]) {
            match global {
                Global::Attr(AttrId(at)) => self.attrs[at as usize].says |= says,
                Global::Const(ConstId(at)) => self.consts[at as usize].says |= says,
            }
        }
    }
}

/// The nodes that expressions read: functions by their numbers, attributes and constants by `numbers`.
fn read(exprs: &[&Expr], numbers: &HashMap<Global, usize>) -> Vec<usize> {
    let mut read = Vec::new();
    for expr in exprs {
        ir_walk::parts(expr, &mut |part| match &part.kind {
            ExprKind::Call(id, _) => read.push(id.0 as usize),
            ExprKind::Attr(id) => read.extend(numbers.get(&Global::Attr(*id))),
            ExprKind::Const(id) => read.extend(numbers.get(&Global::Const(*id))),
            _ => {}
        });
    }
    read
}

/// Whether an attribute or constant is computed when it is first read.
pub(super) fn is_lazy(grammar: &Grammar, global: Global) -> bool {
    match global {
        Global::Attr(id) => grammar.attrs[id.0 as usize].lazy,
        Global::Const(id) => grammar.consts[id.0 as usize].lazy,
    }
}

/// The expression that computes an attribute or constant.
pub(super) fn value(grammar: &Grammar, global: Global) -> &Expr {
    match global {
        Global::Attr(id) => &grammar.attrs[id.0 as usize].default,
        Global::Const(id) => &grammar.consts[id.0 as usize].value,
    }
}
