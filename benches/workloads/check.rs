//! Checks that grammar and hand-written loop make the same output, and the right one.

use cga::sink::buffers::{Buffers, Vertex};
use cga::sink::stats::Stats;

use super::{Fold, Raw, Scene};

/// The counts and sums of an output.
pub(crate) struct Expected {
    pub(crate) terminals: usize,
    pub(crate) triangles: usize,
    pub(crate) vertices: usize,
    /// The sum of the signed tetrahedra between the origin and all triangles.
    pub(crate) checksum: f64,
}

impl Expected {
    #[track_caller]
    fn check(&self, what: &str, vertices: &[Vertex], indices: &[u32]) {
        assert_eq!(indices.len() / 3, self.triangles, "{what}: triangles");
        assert_eq!(vertices.len(), self.vertices, "{what}: vertices");
        self.check_sum(what, checksum(vertices, indices), 1e-6);
    }

    #[track_caller]
    fn check_sum(&self, what: &str, sum: f64, tolerance: f64) {
        let off = (sum - self.checksum).abs() / self.checksum.abs();
        assert!(off < tolerance, "{what}: checksum {sum}, not {}", self.checksum);
    }
}

/// The checksum of rounded coordinates, summed in `f64`.
fn checksum(vertices: &[Vertex], indices: &[u32]) -> f64 {
    let point = |i: u32| {
        let [x, y, z, ..] = vertices[i as usize].map(f64::from);
        [x, y, z]
    };
    let det = |[a, b, c]: [[f64; 3]; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    indices.as_chunks::<3>().0.iter().map(|&triangle| det(triangle.map(point)) / 6.0).sum()
}

/// Makes the scene in every way and compares counts, checksums and runs.
#[track_caller]
pub(crate) fn check(scene: &mut dyn Scene) {
    let (name, expected) = (scene.name(), scene.expected());
    let mut raw = Raw::default();
    scene.by_hand(&mut raw);
    expected.check(&format!("{name} by hand"), &raw.vertices, &raw.indices);

    let mut buffers = Buffers::new();
    scene.buffers(&mut buffers);
    expected.check(&format!("{name} by rules"), buffers.vertices(), buffers.indices());

    // The materials differ, but not the places where they change.
    let by_hand: Vec<_> = raw.runs.iter().map(|run| (run.index, run.vertex as usize)).collect();
    let by_rules: Vec<_> = buffers.submeshes().map(|submesh| (submesh.indices.start, submesh.vertices.start)).collect();
    assert!(by_hand == by_rules, "{name}: {} runs by hand, {} by rules", by_hand.len(), by_rules.len());

    let mut fold = Fold::default();
    scene.fold(&mut fold);
    assert_eq!(fold.leaves as usize, expected.terminals, "{name}: terminals");
    assert!(fold.sum.is_finite(), "{name}: every number is finite");

    let mut stats = Stats::new();
    scene.stats(&mut stats);
    expected.check_sum(&format!("{name} in f64"), stats.checksum(), 1e-9);
}
