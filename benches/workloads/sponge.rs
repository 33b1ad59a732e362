//! Workload B: the Menger sponge, with recursive rules.

use cga::{Settings, Shape, Sink, cga};

use super::{Expected, Raw, Workload, run};

cga! {
    /// A cube with holes on `level` levels.
    pub(crate) grammar Menger;

    attr level = 3
    Lot  --> S(level)
    S(n) --> case n == 0 : Cube. else : split(y) { ~1 : F(n) | ~1 : H(n) | ~1 : F(n) }
    F(n) --> split(x) { ~1 : Q(n) | ~1 : O(n) | ~1 : Q(n) }
    H(n) --> split(x) { ~1 : O(n) | ~1 : NIL | ~1 : O(n) }
    Q(n) --> split(z) { ~1 : S(n - 1) | ~1 : S(n - 1) | ~1 : S(n - 1) }
    O(n) --> split(z) { ~1 : S(n - 1) | ~1 : NIL | ~1 : S(n - 1) }
}

/// A sponge of `20^n` cubes.
pub(crate) struct Sponge {
    n: u32,
    lot: [Shape; 1],
    grammar: Menger,
    settings: Settings,
}

impl Sponge {
    pub(crate) fn new(n: u32) -> Self {
        let grammar = Menger { level: f64::from(n) };
        Sponge { n, lot: [Shape::cuboid(1.0, 1.0, 1.0)], grammar, settings: Settings::default() }
    }
}

impl Workload for Sponge {
    fn name(&self) -> String {
        format!("B({})", self.n)
    }

    fn expected(&self) -> Expected {
        let boxes = 20usize.pow(self.n);
        let checksum = (20.0f64 / 27.0).powi(self.n as i32);
        Expected { terminals: boxes, triangles: 12 * boxes, vertices: 24 * boxes, checksum }
    }

    fn is_main(&self) -> bool {
        self.n == 4
    }

    fn by_hand(&mut self, out: &mut Raw) {
        out.start_run(0, 0);
        sponge(self.n, [0.0; 3], 1.0, out);
    }

    fn derive<S: Sink>(&mut self, sink: &mut S) {
        run!(self.grammar, &self.settings, &self.lot, sink);
    }
}

fn sponge(n: u32, o: [f64; 3], size: f64, out: &mut Raw) {
    if n == 0 {
        out.cuboid(o, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [size; 3]);
        return;
    }
    let third = size / 3.0;
    for y in 0..3 {
        for x in 0..3 {
            for z in 0..3 {
                if [x, y, z].iter().filter(|&&at| at == 1).count() < 2 {
                    let at = |from: f64, step: usize| from + step as f64 * third;
                    sponge(n - 1, [at(o[0], x), at(o[1], y), at(o[2], z)], third, out);
                }
            }
        }
    }
}
