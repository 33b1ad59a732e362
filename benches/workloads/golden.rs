//! Workload B2: a box that is repeatedly divided in the golden ratio.

use cga::{Settings, Shape, Sink, cga};

use super::{Expected, Raw, Workload, run};

cga! {
    /// A box divided in the golden ratio on `level` levels.
    grammar Divided;

    attr level = 12
    Lot  --> A(level)
    A(n) --> case n == 0 : Box. else : split(x) { ^0.382 : A(n - 1) | ^0.618 : B(n - 1) }
    B(n) --> case n == 0 : Box. else : split(y) { ^0.382 : B(n - 1) | ^0.618 : A(n - 1) }
}

/// A box of 5 x 1 x 1 in `2^n` boxes, or slightly fewer where lengths get too short to be divided.
pub(crate) struct Golden {
    n: u32,
    lot: [Shape; 1],
    grammar: Divided,
    settings: Settings,
}

impl Golden {
    pub(crate) fn new(n: u32) -> Self {
        let grammar = Divided { level: f64::from(n) };
        Golden { n, lot: [Shape::cuboid(5.0, 1.0, 1.0)], grammar, settings: Settings::default() }
    }
}

impl Workload for Golden {
    fn name(&self) -> String {
        format!("B2({})", self.n)
    }

    fn expected(&self) -> Expected {
        let boxes = if self.n == 16 { 65_531 } else { 1 << self.n };
        Expected { terminals: boxes, triangles: 12 * boxes, vertices: 24 * boxes, checksum: 5.0 }
    }

    fn is_main(&self) -> bool {
        self.n == 16
    }

    fn by_hand(&mut self, out: &mut Raw) {
        golden(self.n, false, [0.0; 3], [5.0, 1.0, 1.0], out);
    }

    fn derive<S: Sink>(&mut self, sink: &mut S) {
        run!(self.grammar, &self.settings, &self.lot, sink);
    }
}

/// Lengths up to this are not divided: a millionth of the longest side of the lot.
const TOO_SHORT: f64 = 5e-6;

/// The rule of a box that was divided `level` times. Other boxes are leaves of the rule that would divide them, `A`
/// or `B`.
const BOX: u32 = 2;

/// Divides along y if `upright`, otherwise along x. The smaller part is divided along the same axis.
fn golden(n: u32, upright: bool, o: [f64; 3], size: [f64; 3], out: &mut Raw) {
    let axis = usize::from(upright);
    if n == 0 || size[axis] <= TOO_SHORT {
        out.start_run_if_new(if n == 0 { BOX } else { axis as u32 }, 0);
        out.cuboid(o, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], size);
        return;
    }
    let (mut low, mut high, mut second) = (size, size, o);
    low[axis] = size[axis] * 0.382;
    high[axis] = size[axis] * 0.618;
    second[axis] = o[axis] + low[axis];
    golden(n - 1, upright, o, low, out);
    golden(n - 1, !upright, second, high, out);
}
