//! What the benches share: timing two ways of making the same output beside each other, and checking that it is the same.

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
    #[allow(dead_code, reason = "the city has no boxes")]
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

/// One scene, made by hand and by rules: times both and prints them beside each other.
pub(crate) struct Scene<'a> {
    pub(crate) name: String,
    pub(crate) terminals: usize,
    pub(crate) expected: Expected,
    pub(crate) by_hand: &'a mut dyn FnMut(&mut Raw),
    /// The grammar, into buffers.
    pub(crate) buffers: &'a mut dyn FnMut(&mut Buffers),
    /// The grammar, terminals only.
    pub(crate) fold: &'a mut dyn FnMut(&mut Fold),
}

impl Scene<'_> {
    /// Best times of the three ways, run in turn so that the machine's moods meet all alike; what they made is checked.
    pub(crate) fn compare(self) {
        const SECONDS: f64 = 1.0;
        let (mut raw, mut folded) = (Raw::default(), Fold::default());
        // Large enough that no run has to grow them.
        let mut out = Buffers::with_capacity(self.expected.vertices, self.expected.triangles * 3);
        let mut best = [Duration::MAX; 3];
        let begin = Instant::now();
        let mut rounds = 0;
        while rounds < 3 || begin.elapsed().as_secs_f64() < SECONDS {
            let ways: [&mut dyn FnMut(); 3] = [
                &mut || {
                    raw.clear();
                    (self.by_hand)(&mut raw);
                },
                &mut || {
                    out.clear();
                    (self.buffers)(&mut out);
                },
                &mut || {
                    folded = Fold::default();
                    (self.fold)(&mut folded);
                },
            ];
            for (way, best) in ways.into_iter().zip(&mut best) {
                let start = Instant::now();
                way();
                *best = (*best).min(start.elapsed());
            }
            rounds += 1;
        }
        self.expected.check("by hand", &raw.vertices, &raw.indices);
        self.expected.check("grammar", out.vertices(), out.indices());
        assert_eq!(folded.leaves as usize, self.terminals);
        assert!(folded.sum.is_finite());
        self.report(best);
    }

    fn report(&self, [hand, ours, fold]: [Duration; 3]) {
        let each = |time: Duration| time.as_secs_f64() * 1e9 / self.terminals as f64;
        let ratio = |time: Duration| time.as_secs_f64() / hand.as_secs_f64();
        println!(
            "{:<16} {:>8} terminals  by hand {:>6.1} ns  grammar {:>6.1} ns  ratio {:>5.2}   terminals only {:>6.1} ns  ratio {:>5.2}",
            self.name,
            self.terminals,
            each(hand),
            each(ours),
            ratio(ours),
            each(fold),
            ratio(fold),
        );
    }
}
