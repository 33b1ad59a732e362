//! Workload B: the Menger sponge, rules that call themselves.
//!
//! `cargo bench --bench sponge`

mod common;

use cga::{Settings, Shape, cga};
use common::{Expected, Raw, Scene};

cga! {
    /// A cube with holes, `level` times over.
    grammar Sponge;

    attr level = 3
    Lot  --> S(level)
    S(n) --> case n == 0 : Cube. else : split(y) { ~1 : F(n) | ~1 : H(n) | ~1 : F(n) }
    F(n) --> split(x) { ~1 : Q(n) | ~1 : O(n) | ~1 : Q(n) }
    H(n) --> split(x) { ~1 : O(n) | ~1 : NIL | ~1 : O(n) }
    Q(n) --> split(z) { ~1 : S(n - 1) | ~1 : S(n - 1) | ~1 : S(n - 1) }
    O(n) --> split(z) { ~1 : S(n - 1) | ~1 : NIL | ~1 : S(n - 1) }
}

fn by_hand(n: u32, o: [f64; 3], size: f64, out: &mut Raw) {
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
                    by_hand(n - 1, [at(o[0], x), at(o[1], y), at(o[2], z)], third, out);
                }
            }
        }
    }
}

fn main() {
    for n in 1..=4u32 {
        let boxes = 20usize.pow(n);
        let checksum = (20.0f64 / 27.0).powi(n as i32);
        let lot = Shape::cuboid(1.0, 1.0, 1.0);
        let (grammar, settings) = (Sponge { level: f64::from(n) }, Settings::default());
        Scene {
            name: format!("sponge({n})"),
            terminals: boxes,
            expected: Expected { triangles: 12 * boxes, vertices: 24 * boxes, checksum },
            by_hand: &mut |out| by_hand(n, [0.0; 3], 1.0, out),
            buffers: &mut |out| drop(grammar.generate_into(&lot, &settings, out).expect("no limit is reached")),
            fold: &mut |out| drop(grammar.generate_into(&lot, &settings, out).expect("no limit is reached")),
        }
        .compare();
    }
}
