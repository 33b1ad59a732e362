//! Rust values that are used several times, in several styles or imports.

use std::collections::HashMap;

use crate::ir::{ExprKind, Grammar, HostId, Type};
use crate::ir_walk;

/// A Rust value is one host, whatever the number of its uses.
pub(super) fn share(grammar: &mut Grammar) {
    let mut first: HashMap<(u32, Type), u32> = HashMap::new();
    let mut kept = Vec::new();
    let mut numbers = Vec::with_capacity(grammar.hosts.len());
    for host in std::mem::take(&mut grammar.hosts) {
        let number = *first.entry((host.handle, host.ty)).or_insert(kept.len() as u32);
        if number as usize == kept.len() {
            kept.push(host);
        }
        numbers.push(number);
    }
    let changed = kept.len() < numbers.len();
    grammar.hosts = kept;
    if changed {
        ir_walk::all_exprs_mut(grammar, &mut |expr| {
            if let ExprKind::Host(id) = &mut expr.kind {
                *id = HostId(numbers[id.0 as usize]);
            }
        });
    }
}
