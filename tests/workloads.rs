//! The workloads of the benches: grammar and hand-written loop make the same counts, checksums and runs.

#[path = "../benches/workloads/mod.rs"]
mod workloads;

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
