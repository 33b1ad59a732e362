//! The workloads of the benches: grammar and hand-written loop make the same counts, checksums and runs.

#[path = "../benches/build/rules.rs"]
mod rules;
#[path = "../../benches/workloads/mod.rs"]
mod workloads;

use cga_lang::compile::compile_text;

/// Larger sizes are checked by the benches themselves.
const TERMINALS: usize = 20_000;

#[test]
fn small_workloads_have_their_documented_output() {
    let mut checked = 0;
    for mut scene in workloads::all() {
        if scene.expected().terminals <= TERMINALS {
            workloads::check(&mut *scene);
            checked += 1;
        }
    }
    assert!(12 <= checked, "{checked} scenes");
}

#[test]
fn the_rules_of_the_build_bench_have_no_diagnostics() {
    let source = compile_text(&rules::rules(30));
    assert!(source.compiled.diags.is_empty(), "{:?}", source.compiled.diags.first());
    assert!(30 <= source.compiled.grammar.expect("a grammar").rules.len());
}
