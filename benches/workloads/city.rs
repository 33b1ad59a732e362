//! Workload D: a city of façaded boxes, each façade in a random one of three colours.

use cga::{Settings, Shape, Sink, cga};

use super::share::share;
use super::{Expected, Raw, Workload, run};

cga! {
    /// Walls and windows on every side.
    grammar Buildings;

    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> 60% : color("#d8c8a8") Front 30% : color("#b08060") Front else : color("#90a0a8") Front
    Front  --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window. | ~0.8 : Wall. }
}

/// A building on each lot.
pub(crate) struct City {
    lots: Vec<Shape>,
    grammar: Buildings,
    settings: Settings,
}

impl City {
    pub(crate) fn new(lots: usize) -> Self {
        let lot = |lot| Shape::cuboid(13.5, 4.0 + 3.0 * floors(lot) as f64, 11.0).at(corner(lot)).seed(lot as u64);
        City { lots: (0..lots).map(lot).collect(), grammar: Buildings::default(), settings: Settings::default() }
    }
}

impl Workload for City {
    fn name(&self) -> String {
        format!("D({})", self.lots.len())
    }

    fn expected(&self) -> Expected {
        let checksum = match self.lots.len() {
            10 => 30_888.0,
            100 => 324_918.0,
            300 => 980_100.0,
            1000 => 3_265_218.0,
            other => panic!("the checksum of {other} lots is not known"),
        };
        let terminals = (0..self.lots.len()).map(|lot| 5 + 98 * floors(lot)).sum::<usize>();
        Expected { terminals, triangles: 2 * terminals, vertices: 4 * terminals, checksum }
    }

    fn is_main(&self) -> bool {
        self.lots.len() == 1000
    }

    fn by_hand(&mut self, out: &mut Raw) {
        (0..self.lots.len()).for_each(|lot| building(lot, out));
    }

    fn derive<S: Sink>(&mut self, sink: &mut S) {
        run!(self.grammar, &self.settings, &self.lots, sink);
    }
}

fn floors(lot: usize) -> usize {
    2 + (7 * lot) % 9
}

fn corner(lot: usize) -> [f64; 3] {
    [20.0 * (lot % 40) as f64, 0.0, 20.0 * (lot / 40) as f64]
}

/// The rules by number, as recorded by the loop.
const SHOP: u32 = 0;
const WALL: u32 = 1;
const WINDOW: u32 = 2;
const ROOF: u32 = 3;

/// One building, by a loop that knows all sizes. Material 0 belongs to the roof, which has no colour.
fn building(lot: usize, out: &mut Raw) {
    let (m, c) = (floors(lot), corner(lot));
    let (w, h, d) = (13.5, 4.0 + 3.0 * m as f64, 11.0);
    let sides = [
        ([0.0, d], [1.0, 0.0], [0.0, 1.0], w, 5),
        ([w, d], [0.0, -1.0], [1.0, 0.0], d, 4),
        ([w, 0.0], [-1.0, 0.0], [0.0, -1.0], w, 5),
        ([0.0, 0.0], [0.0, 1.0], [-1.0, 0.0], d, 4),
    ];
    for (side, (o, x, n, width, bays)) in sides.into_iter().enumerate() {
        let share = share((lot * 4 + side) as u64);
        let colour = if share < 0.6 { 1 } else { 2 + u32::from(0.9 <= share) };

        let at = |across: f64, up: f64| [c[0] + o[0] + x[0] * across, up, c[2] + o[1] + x[1] * across];
        let along = |by: f64| [x[0] * by, 0.0, x[1] * by];
        let up = |by: f64| [0.0, by, 0.0];
        let n = [n[0], 0.0, n[1]];
        out.start_run(SHOP, colour);
        out.quad(at(0.0, 0.0), along(width), up(4.0), n);
        let bay_width = (width - 1.0) / f64::from(bays);
        out.start_run(WALL, colour);
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
                out.start_run(WINDOW, colour);
                out.quad(at(left, level + below), along(1.2), up(1.5), n);
                out.start_run(WALL, colour);
                out.quad(at(left, level + below + 1.5), along(1.2), up(above), n);
                out.quad(at(left + 1.2, level), along(side), up(3.0), n);
            }
            out.quad(at(width - 0.5, level), along(0.5), up(3.0), n);
        }
    }
    out.start_run(ROOF, 0);
    out.quad([c[0], h, c[2] + d], [w, 0.0, 0.0], [0.0, 0.0, -d], [0.0, 1.0, 0.0]);
}
