//! The written grammars call the rows of the operation table.

use std::collections::HashSet;

use crate::write;
use cga_lang::compile::compile_text;
use cga_lang::ir::{Step, StepKind, walk};
use cga_lang::ops::{Operation, all_operations};

/// Grammars that are enough to have each row.
const SEEDS: std::ops::Range<u64> = 0..400;

/// The row that a step calls.
fn row(step: &Step) -> Option<&'static Operation> {
    match &step.kind {
        StepKind::Do(row, _) => Some(row),
        StepKind::Block(block) => Some(block.row),
        _ => None,
    }
}

#[test]
fn grammars_have_each_row_of_the_operation_table() {
    let mut missing: Vec<&Operation> = all_operations().collect();
    for seed in SEEDS {
        let compiled = compile_text(&write::write(seed)).compiled;
        let grammar = compiled.grammar.unwrap_or_else(|| panic!("seed {seed}: {:?}", compiled.diags));
        let mut met: HashSet<*const Operation> = HashSet::new();
        let mut note = |step: &Step| met.extend(row(step).map(std::ptr::from_ref));
        grammar.rules.iter().for_each(|rule| walk::steps(&rule.body, &mut note));
        missing.retain(|row| !met.contains(&std::ptr::from_ref(*row)));
        if missing.is_empty() {
            return;
        }
    }
    let names: Vec<String> =
        missing.iter().map(|row| format!("{} ({} parameters)", row.name, row.params.len())).collect();
    panic!("no grammar of the seeds {SEEDS:?} calls {names:#?}: add calls to `tests/laws/write`");
}
