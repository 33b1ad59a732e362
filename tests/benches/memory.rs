//! The memory of workloads A, B, B2 and D: the peak of a run beside its output, and the peak of growing buffers.
//!
//! `cargo bench -p cga-tests --bench memory`. A counting allocator gives the same bytes in every run and on every system. The
//! stack is not counted.

#[path = "../../benches/common/mod.rs"]
mod common;
#[path = "../../benches/workloads/mod.rs"]
mod workloads;

use cga::sink::buffers::{Buffers, Vertex};
use common::table::{Table, number};
use peak_alloc::PeakAlloc;
use workloads::Raw;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The largest number of bytes that `work` holds at once.
fn peak(work: impl FnOnce()) -> usize {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    work();
    MEMORY.peak_usage() - before
}

fn main() {
    let columns = [
        "scene",
        "beside the buffers, bytes a terminal",
        "by hand",
        "terminals only, bytes a terminal",
        "growing buffers, peak / output",
        "by hand",
        "terminals",
        "output, MB",
    ];
    let mut table = Table::new("Memory: peak of a run", &columns);
    for mut scene in workloads::all() {
        let expected = scene.expected();
        let (vertices, indices) = (expected.vertices, 3 * expected.triangles);
        let output = vertices * size_of::<Vertex>() + indices * size_of::<u32>();

        // A process makes some meshes once and keeps them. They are made here, before the measurement.
        workloads::check(&mut *scene);
        let mut out = Buffers::with_capacity(vertices, indices);
        let beside = peak(|| scene.buffers(&mut out));
        assert_eq!((out.vertices().len(), out.indices().len()), (vertices, indices));
        drop(out);
        let mut raw = Raw::with_capacity(vertices, indices);
        let beside_by_hand = peak(|| scene.by_hand(&mut raw));
        drop(raw);
        let fold = peak(|| scene.fold(&mut workloads::Fold::default()));
        let growing = peak(|| scene.buffers(&mut Buffers::new()));
        let growing_by_hand = peak(|| scene.by_hand(&mut Raw::default()));

        let a_terminal = |bytes: usize| number(bytes as f64 / expected.terminals as f64, 2);
        let of_output = |bytes: usize| number(bytes as f64 / output as f64, 2);
        table.row(
            &scene.name(),
            &[
                a_terminal(beside),
                a_terminal(beside_by_hand),
                a_terminal(fold),
                of_output(growing),
                of_output(growing_by_hand),
                expected.terminals.to_string(),
                number(output as f64 / 1e6, 1),
            ],
        );
    }
    table.note(
        "Beside vertices and indices there are runs of equal rule and material, and what a run holds while it goes on. A list \
         that grows counts twice for a moment, as not every system can lengthen it in place.",
    );
    table.print();
}
