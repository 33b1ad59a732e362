//! Workload D: a city of façaded boxes, each façade in one of three colours by chance.
//!
//! `cargo bench --bench city`

mod common;

use cga::{Settings, Shape, Sink, cga};
use common::{Expected, Raw, Scene};

cga! {
    /// Walls and windows on every side.
    grammar City;

    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> 60% : color("#d8c8a8") Front 30% : color("#b08060") Front else : color("#90a0a8") Front
    Front  --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window. | ~0.8 : Wall. }
}

fn floors(lot: usize) -> usize {
    2 + (7 * lot) % 9
}

fn corner(lot: usize) -> [f64; 3] {
    [20.0 * (lot % 40) as f64, 0.0, 20.0 * (lot / 40) as f64]
}

/// One building: the loop knows all sizes. The colours are drawn and kept, a number a façade.
fn by_hand(lot: usize, colours: &mut Vec<u8>, out: &mut Raw) {
    let (m, c) = (floors(lot), corner(lot));
    let (w, h, d) = (13.5, 4.0 + 3.0 * m as f64, 11.0);
    let sides = [
        ([0.0, d], [1.0, 0.0], [0.0, 1.0], w, 5),
        ([w, d], [0.0, -1.0], [1.0, 0.0], d, 4),
        ([w, 0.0], [-1.0, 0.0], [0.0, -1.0], w, 5),
        ([0.0, 0.0], [0.0, 1.0], [-1.0, 0.0], d, 4),
    ];
    for (side, (o, x, n, width, bays)) in sides.into_iter().enumerate() {
        let mut bits = (lot * 4 + side) as u64;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let share = (bits >> 11) as f64 / (1u64 << 53) as f64;
        colours.push(if share < 0.6 { 0 } else { 1 + u8::from(0.9 <= share) });

        let at = |across: f64, up: f64| [c[0] + o[0] + x[0] * across, up, c[2] + o[1] + x[1] * across];
        let along = |by: f64| [x[0] * by, 0.0, x[1] * by];
        let up = |by: f64| [0.0, by, 0.0];
        let n = [n[0], 0.0, n[1]];
        out.quad(at(0.0, 0.0), along(width), up(4.0), n);
        let bay_width = (width - 1.0) / f64::from(bays);
        for floor in 0..m {
            let level = 4.0 + 3.0 * floor as f64;
            out.quad(at(0.0, level), along(0.5), up(3.0), n);
            for bay in 0..bays {
                let left = 0.5 + bay_width * f64::from(bay);
                let side = (bay_width - 1.2) / 2.0;
                let (below, above) = (1.5 / 1.8, 1.5 * 0.8 / 1.8);
                out.quad(at(left, level), along(side), up(3.0), n);
                let left = left + side;
                out.quad(at(left, level), along(1.2), up(below), n);
                out.quad(at(left, level + below), along(1.2), up(1.5), n);
                out.quad(at(left, level + below + 1.5), along(1.2), up(above), n);
                out.quad(at(left + 1.2, level), along(side), up(3.0), n);
            }
            out.quad(at(width - 0.5, level), along(0.5), up(3.0), n);
        }
    }
    out.quad([c[0], h, c[2] + d], [w, 0.0, 0.0], [0.0, 0.0, -d], [0.0, 1.0, 0.0]);
}

fn main() {
    let sums = [30888.0, 324918.0, 980100.0, 3265218.0];
    for (lots, checksum) in [10, 100, 300, 1000].into_iter().zip(sums) {
        let terminals = (0..lots).map(|lot| 5 + 98 * floors(lot)).sum::<usize>();
        let shapes: Vec<Shape> = (0..lots)
            .map(|lot| Shape::cuboid(13.5, 4.0 + 3.0 * floors(lot) as f64, 11.0).at(corner(lot)).seed(lot as u64))
            .collect();
        let (grammar, settings) = (City::default(), Settings::default());
        let mut colours = Vec::new();
        Scene {
            name: format!("city({lots})"),
            terminals,
            expected: Expected { triangles: 2 * terminals, vertices: 4 * terminals, checksum },
            by_hand: &mut |out| {
                colours.clear();
                (0..lots).for_each(|lot| by_hand(lot, &mut colours, out));
            },
            buffers: &mut |out| run(&grammar, &shapes, &settings, out),
            fold: &mut |out| run(&grammar, &shapes, &settings, out),
        }
        .compare();
        assert_eq!(colours.len(), 4 * lots);
    }
}

fn run(grammar: &City, shapes: &[Shape], settings: &Settings, sink: &mut impl Sink) {
    for shape in shapes {
        grammar.generate_into(shape, settings, sink).expect("no limit is reached");
    }
}
