//! Workload A: a façade, `k` bays wide and `m` floors high, on four sides of a box.

use cga::{Settings, Shape, Sink, cga};

use super::{Expected, Raw, Workload, run};

cga! {
    /// Walls, windows, frames and set-back glass.
    pub(crate) grammar Facades;

    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
}

/// The façade in one colour.
pub(crate) struct Facade {
    size: Size,
    lot: [Shape; 1],
    grammar: Facades,
    settings: Settings,
}

impl Facade {
    pub(crate) fn new(size: Size) -> Self {
        Facade { lot: [size.lot()], size, grammar: Facades::default(), settings: Settings::default() }
    }
}

impl Workload for Facade {
    fn name(&self) -> String {
        self.size.name("A")
    }

    fn expected(&self) -> Expected {
        self.size.expected()
    }

    fn is_main(&self) -> bool {
        self.size.is_main()
    }

    fn by_hand(&mut self, out: &mut Raw) {
        self.size.by_hand(PLAIN, || (GLASS, PLAIN), out);
    }

    fn derive<S: Sink>(&mut self, sink: &mut S) {
        run!(self.grammar, &self.settings, &self.lot, sink);
    }
}

/// The material of a rule that sets none.
pub(crate) const PLAIN: u32 = 0;

/// The rules by number, as recorded by the hand-written loop.
const SHOP: u32 = 0;
const WALL: u32 = 1;
const FRAME: u32 = 2;
const ROOF: u32 = 3;
/// The rule of the glass. Other workloads may use the numbers from here on.
pub(crate) const GLASS: u32 = 4;

/// The number of bays and floors of a façade.
#[derive(Clone, Copy)]
pub(crate) struct Size {
    k: usize,
    m: usize,
    checksum: f64,
}

/// The sizes that are measured.
pub(crate) fn sizes() -> [Size; 5] {
    let sums = [2825.733333333, 22116.0, 159658.666666667, 1211036.0, 9428958.666666667];
    let mut sums = sums.into_iter();
    [(5, 4), (10, 10), (20, 20), (40, 40), (80, 80)].map(|(k, m)| Size { k, m, checksum: sums.next().unwrap_or(0.0) })
}

impl Size {
    pub(crate) fn name(self, workload: &str) -> String {
        format!("{workload}({}, {})", self.k, self.m)
    }

    pub(crate) fn is_main(self) -> bool {
        self.k == 40
    }

    /// The width, which is also the depth, and the height.
    fn extent(self) -> (f64, f64) {
        (1.0 + 2.5 * self.k as f64, 4.0 + 3.0 * self.m as f64)
    }

    pub(crate) fn lot(self) -> Shape {
        let (width, height) = self.extent();
        Shape::cuboid(width, height, width)
    }

    pub(crate) fn expected(self) -> Expected {
        let Size { k, m, checksum } = self;
        let terminals = 4 * (1 + m * (2 + 9 * k)) + 1;
        Expected { terminals, triangles: 2 * terminals + 160 * k * m, vertices: 4 * terminals + 320 * k * m, checksum }
    }

    /// A loop that knows all sizes. `bay` is the material of the bays, `glass` returns rule and material of a pane.
    #[inline]
    pub(crate) fn by_hand(self, bay: u32, mut glass: impl FnMut() -> (u32, u32), out: &mut Raw) {
        let (w, h) = self.extent();
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
            out.start_run(SHOP, PLAIN);
            out.quad(at(0.0, 0.0, 0.0), along(w), up(4.0), n);
            for floor in 0..self.m {
                let level = 4.0 + 3.0 * floor as f64;
                out.start_run_if_new(WALL, PLAIN);
                out.quad(at(0.0, level, 0.0), along(0.5), up(3.0), n);
                for column in 0..self.k {
                    let left = 0.5 + 2.5 * column as f64;
                    let (below, above) = (1.5 / 1.8, 1.5 * 0.8 / 1.8);
                    out.start_run_if_new(WALL, bay);
                    out.quad(at(left, level, 0.0), along(0.65), up(3.0), n);
                    let left = left + 0.65;
                    out.quad(at(left, level, 0.0), along(1.2), up(below), n);
                    let sill = level + below;
                    // The scope of a frame: y outwards, z downwards, the origin at its upper corner.
                    let down = [0.0, -1.0, 0.0];
                    let frame = |out: &mut Raw, left: f64, bottom: f64, width: f64, height: f64| {
                        out.cuboid(at(left, bottom + height, 0.0), [x, n, down], [width, 0.08, height]);
                    };
                    out.start_run(FRAME, bay);
                    frame(out, left, sill, 0.1, 1.5);
                    frame(out, left + 0.1, sill, 1.0, 0.1);
                    let (rule, material) = glass();
                    out.start_run(rule, material);
                    out.quad(at(left + 0.1, sill + 0.1, -0.1), along(1.0), up(1.3), n);
                    out.start_run(FRAME, bay);
                    frame(out, left + 0.1, sill + 1.4, 1.0, 0.1);
                    frame(out, left + 1.1, sill, 0.1, 1.5);
                    out.start_run(WALL, bay);
                    out.quad(at(left, sill + 1.5, 0.0), along(1.2), up(above), n);
                    out.quad(at(left + 1.2, level, 0.0), along(0.65), up(3.0), n);
                }
                out.start_run_if_new(WALL, PLAIN);
                out.quad(at(w - 0.5, level, 0.0), along(0.5), up(3.0), n);
            }
        }
        out.start_run(ROOF, PLAIN);
        out.quad([0.0, h, w], [w, 0.0, 0.0], [0.0, 0.0, -w], y);
    }
}
