//! Workload A: a façade, k bays wide and m floors high, on four sides of a box.
//!
//! `cargo bench --bench facade`

mod common;

use cga::{Settings, Shape, cga};
use common::{Expected, Raw, Scene};

cga! {
    /// Walls, windows, frames and set-back glass.
    grammar Facades;

    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
}

/// The same by hand: a loop that knows all sizes.
fn by_hand(k: usize, m: usize, out: &mut Raw) {
    let (w, h) = (1.0 + 2.5 * k as f64, 4.0 + 3.0 * m as f64);
    let y = [0.0, 1.0, 0.0];
    let sides = [
        ([0.0, 0.0, w], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        ([w, 0.0, w], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]),
        ([w, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
        ([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]),
    ];
    for (o, x, n) in sides {
        let at = |across: f64, up: f64, out: f64| {
            [o[0] + x[0] * across + n[0] * out, o[1] + up, o[2] + x[2] * across + n[2] * out]
        };
        let along = |by: f64| [x[0] * by, 0.0, x[2] * by];
        let up = |by: f64| [0.0, by, 0.0];
        out.quad(at(0.0, 0.0, 0.0), along(w), up(4.0), n);
        for floor in 0..m {
            let level = 4.0 + 3.0 * floor as f64;
            out.quad(at(0.0, level, 0.0), along(0.5), up(3.0), n);
            for bay in 0..k {
                let left = 0.5 + 2.5 * bay as f64;
                let (below, above) = (1.5 / 1.8, 1.5 * 0.8 / 1.8);
                out.quad(at(left, level, 0.0), along(0.65), up(3.0), n);
                let left = left + 0.65;
                out.quad(at(left, level, 0.0), along(1.2), up(below), n);
                let sill = level + below;
                // A frame's scope: y outwards, z downwards, the origin at its upper corner.
                let down = [0.0, -1.0, 0.0];
                let mut frame = |left: f64, bottom: f64, width: f64, height: f64| {
                    out.cuboid(at(left, bottom + height, 0.0), [x, n, down], [width, 0.08, height]);
                };
                frame(left, sill, 0.1, 1.5);
                frame(left + 0.1, sill, 1.0, 0.1);
                frame(left + 0.1, sill + 1.4, 1.0, 0.1);
                frame(left + 1.1, sill, 0.1, 1.5);
                out.quad(at(left + 0.1, sill + 0.1, -0.1), along(1.0), up(1.3), n);
                out.quad(at(left, sill + 1.5, 0.0), along(1.2), up(above), n);
                out.quad(at(left + 1.2, level, 0.0), along(0.65), up(3.0), n);
            }
            out.quad(at(w - 0.5, level, 0.0), along(0.5), up(3.0), n);
        }
    }
    out.quad([0.0, h, w], [w, 0.0, 0.0], [0.0, 0.0, -w], y);
}

fn main() {
    let sums = [2825.733333333, 22116.0, 159658.666666667, 1211036.0, 9428958.666666667];
    for ((k, m), checksum) in [(5, 4), (10, 10), (20, 20), (40, 40), (80, 80)].into_iter().zip(sums) {
        let terminals = 4 * (1 + m * (2 + 9 * k)) + 1;
        let width = 1.0 + 2.5 * k as f64;
        let lot = Shape::cuboid(width, 4.0 + 3.0 * m as f64, width);
        let (grammar, settings) = (Facades::default(), Settings::default());
        Scene {
            name: format!("facade({k}, {m})"),
            terminals,
            expected: Expected {
                triangles: 2 * terminals + 160 * k * m,
                vertices: 4 * terminals + 320 * k * m,
                checksum,
            },
            by_hand: &mut |out| by_hand(k, m, out),
            buffers: &mut |out| drop(grammar.generate_into(&lot, &settings, out).expect("no limit is reached")),
            fold: &mut |out| drop(grammar.generate_into(&lot, &settings, out).expect("no limit is reached")),
        }
        .compare();
    }
}
