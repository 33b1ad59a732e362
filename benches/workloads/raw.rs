//! The output of the hand-written loops: the same buffers as [`cga::sink::buffers::Buffers`], without a grammar.

use cga::sink::buffers::Vertex;

/// Vertices, indices and runs.
#[derive(Default)]
pub(crate) struct Raw {
    pub(crate) vertices: Vec<Vertex>,
    pub(crate) indices: Vec<u32>,
    pub(crate) runs: Vec<Run>,
}

/// The start of consecutive triangles with one rule and one material.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Run {
    pub(crate) rule: u32,
    pub(crate) material: u32,
    pub(crate) index: usize,
    pub(crate) vertex: u32,
}

/// A point or a direction.
pub(crate) type V = [f64; 3];

fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

impl Raw {
    /// Empty buffers with room for numbers of vertices and indices.
    pub(crate) fn with_capacity(vertices: usize, indices: usize) -> Self {
        Raw { vertices: Vec::with_capacity(vertices), indices: Vec::with_capacity(indices), runs: Vec::new() }
    }

    pub(crate) fn clear(&mut self) {
        self.vertices.clear();
        self.indices.clear();
        self.runs.clear();
    }

    /// Starts a new run, where the loop knows that rule or material changes.
    #[inline(always)]
    pub(crate) fn start_run(&mut self, rule: u32, material: u32) {
        let run = Run { rule, material, index: self.indices.len(), vertex: self.vertices.len() as u32 };
        self.runs.push(run);
    }

    /// Starts a new run unless the last one has the same rule and material.
    #[inline(always)]
    pub(crate) fn start_run_if_new(&mut self, rule: u32, material: u32) {
        match self.runs.last() {
            Some(last) if last.rule == rule && last.material == material => {}
            _ => self.start_run(rule, material),
        }
    }

    /// Adds a rectangle with a known normal.
    #[inline(always)]
    pub(crate) fn quad(&mut self, o: V, u: V, v: V, n: V) {
        let start = self.vertices.len() as u32;
        let vertex = |p: V| [p[0] as f32, p[1] as f32, p[2] as f32, n[0] as f32, n[1] as f32, n[2] as f32];
        let b = add(o, u);
        self.vertices.extend_from_slice(&[vertex(o), vertex(b), vertex(add(b, v)), vertex(add(o, v))]);
        self.indices.extend_from_slice(&[start, start + 1, start + 2, start, start + 2, start + 3]);
    }

    /// Adds a box with known unit axes.
    #[inline(always)]
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
