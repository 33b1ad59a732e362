//! What the benches share: timing two ways of making the same output beside each other, and checking that it is the same.
#![allow(dead_code, reason = "each bench uses a part")]

use std::hint::black_box;
use std::time::{Duration, Instant};

use cga::sink::buffers::{Buffers, Vertex};
use cga::{Cuboid, Flow, Leaf, Mesh, Quad, Sink};

/// Vertices and indices as a hand-written loop fills them.
#[derive(Default)]
pub(crate) struct Raw {
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) indices: Vec<u32>,
}

type V = [f64; 3];

fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

impl Raw {
    pub(crate) fn clear(&mut self) {
        self.vertices.clear();
        self.indices.clear();
    }

    /// A rectangle with a known normal.
    #[inline]
    pub(crate) fn quad(&mut self, o: V, u: V, v: V, n: V) {
        let start = self.vertices.len() as u32;
        let vertex = |p: V| [p[0] as f32, p[1] as f32, p[2] as f32, n[0] as f32, n[1] as f32, n[2] as f32];
        let b = add(o, u);
        self.vertices.extend_from_slice(&[vertex(o), vertex(b), vertex(add(b, v)), vertex(add(o, v))]);
        self.indices.extend_from_slice(&[start, start + 1, start + 2, start, start + 2, start + 3]);
    }

    /// A box with known unit axes.
    #[inline]
    pub(crate) fn cuboid(&mut self, o: V, axes: [V; 3], size: V) {
        let scaled = |axis: V, by: f64| [axis[0] * by, axis[1] * by, axis[2] * by];
        let minus = |a: V| [-a[0], -a[1], -a[2]];
        let (x, y, z) = (scaled(axes[0], size[0]), scaled(axes[1], size[1]), scaled(axes[2], size[2]));
        self.quad(add(o, z), x, y, axes[2]);
        self.quad(add(add(o, z), x), minus(z), y, axes[0]);
        self.quad(add(o, x), minus(x), y, minus(axes[2]));
        self.quad(o, z, y, minus(axes[0]));
        self.quad(add(add(o, z), y), x, minus(z), axes[1]);
        self.quad(o, x, z, minus(axes[1]));
    }
}

/// Sum of the signed tetrahedra between the origin and all triangles, from `f32` coordinates in `f64`.
pub(crate) fn checksum(vertices: &[Vertex], indices: &[u32]) -> f64 {
    let point = |i: u32| vertices[i as usize][..3].iter().map(|&c| f64::from(c)).collect::<Vec<_>>();
    let det = |a: &[f64], b: &[f64], c: &[f64]| {
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    indices.chunks_exact(3).map(|t| det(&point(t[0]), &point(t[1]), &point(t[2])) / 6.0).sum()
}

/// What an output must be.
pub(crate) struct Expected {
    pub(crate) triangles: usize,
    pub(crate) vertices: usize,
    pub(crate) checksum: f64,
}

impl Expected {
    #[track_caller]
    pub(crate) fn check(&self, what: &str, vertices: &[Vertex], indices: &[u32]) {
        assert_eq!(indices.len() / 3, self.triangles, "{what}: triangles");
        assert_eq!(vertices.len(), self.vertices, "{what}: vertices");
        let sum = checksum(vertices, indices);
        let off = (sum - self.checksum).abs() / self.checksum.abs();
        assert!(off < 1e-6, "{what}: checksum {sum}, not {}", self.checksum);
    }
}

/// Folds every leaf into a number and keeps nothing.
#[derive(Default)]
pub(crate) struct Fold {
    pub(crate) leaves: u64,
    pub(crate) sum: f64,
}

impl Sink for Fold {
    #[inline]
    fn quad(&mut self, _: &Leaf<'_>, quad: &Quad) -> Flow {
        self.leaves += 1;
        self.sum += black_box(quad.origin.x + quad.u.x + quad.v.y);
        Flow::Continue(())
    }

    #[inline]
    fn cuboid(&mut self, _: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.leaves += 1;
        self.sum += black_box(cuboid.origin.x + cuboid.sides.x_axis.x);
        Flow::Continue(())
    }

    fn mesh(&mut self, _: &Leaf<'_>, mesh: &std::sync::Arc<Mesh>, _: &cga::glam::DAffine3) -> Flow {
        self.leaves += 1;
        self.sum += black_box(mesh.points().len() as f64);
        Flow::Continue(())
    }
}

/// Best times of three ways, run in turn so that the machine's moods meet all alike.
pub(crate) fn best(mut ways: [&mut dyn FnMut(); 3], seconds: f64) -> [Duration; 3] {
    let mut best = [Duration::MAX; 3];
    let begin = Instant::now();
    let mut rounds = 0;
    while rounds < 3 || begin.elapsed().as_secs_f64() < seconds {
        for (way, best) in ways.iter_mut().zip(&mut best) {
            let start = Instant::now();
            way();
            *best = (*best).min(start.elapsed());
        }
        rounds += 1;
    }
    best
}

/// Prints a line of results.
pub(crate) fn report(name: &str, terminals: usize, [hand, ours, fold]: [Duration; 3]) {
    let nanoseconds = |time: Duration| time.as_secs_f64() * 1e9 / terminals as f64;
    println!(
        "{name:<16} {terminals:>8} terminals  by hand {:>6.1} ns  grammar {:>6.1} ns  ratio {:>5.2}   terminals only {:>6.1} ns  ratio {:>5.2}",
        nanoseconds(hand),
        nanoseconds(ours),
        ours.as_secs_f64() / hand.as_secs_f64(),
        nanoseconds(fold),
        fold.as_secs_f64() / hand.as_secs_f64(),
    );
}

/// Buffers large enough that no run has to grow them.
pub(crate) fn buffers(expected: &Expected) -> Buffers {
    Buffers::with_capacity(expected.vertices, expected.triangles * 3)
}
