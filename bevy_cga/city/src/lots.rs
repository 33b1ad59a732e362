//! A made-up district: blocks between bent streets, with lots along their edges.

/// An outline with its holes, in metres: x to the east, z to the south.
#[derive(Debug, Default)]
pub(crate) struct Outline {
    pub(crate) outer: Vec<[f64; 2]>,
    pub(crate) holes: Vec<Vec<[f64; 2]>>,
}

/// The outlines of the district.
#[derive(Debug, Default)]
pub(crate) struct District {
    /// The meadow around the district.
    pub(crate) meadow: Outline,
    pub(crate) asphalt: Outline,
    /// Pieces of the streets along each block, for which houses look.
    pub(crate) streets: Vec<Outline>,
    pub(crate) sidewalks: Vec<Outline>,
    pub(crate) gardens: Vec<Outline>,
    pub(crate) houses: Vec<Outline>,
}

const STREET: f64 = 13.0;
const SIDEWALK: f64 = 3.0;
/// The width of the part of a street that belongs to one block.
const LANE: f64 = 5.0;
/// The depth of the houses along a street.
const DEPTH: f64 = 12.0;
const WIDTHS: [f64; 5] = [58.0, 66.0, 52.0, 72.0, 60.0];
const DEPTHS: [f64; 4] = [54.0, 62.0, 50.0, 58.0];

/// A rectangle: low and high corner.
#[derive(Clone, Copy)]
struct Rectangle {
    low: [f64; 2],
    high: [f64; 2],
}

/// Numbers that look random and are the same everywhere (SplitMix64).
struct Random(u64);

impl Random {
    /// A number from `low` to `high`.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.0;
        word = (word ^ word >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ word >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        low + (high - low) * ((word ^ word >> 31) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

impl Rectangle {
    fn grown(self, by: f64) -> Self {
        Rectangle { low: self.low.map(|part| part - by), high: self.high.map(|part| part + by) }
    }

    /// The lanes along the four sides, in pieces that are short enough for the bends. The first edge of a piece is along its street.
    fn lanes(self) -> Vec<Outline> {
        let ([x, z], [far_x, far_z]) = (self.low, self.high);
        let corners = [[x, z], [x, far_z], [far_x, far_z], [far_x, z]];
        let mut lanes = Vec::new();
        for (at, from) in corners.into_iter().enumerate() {
            let to = corners[(at + 1) % 4];
            let size = [0, 1].map(|axis| to[axis] - from[axis]);
            let length = size[0].abs() + size[1].abs();
            let outward = [-size[1] / length * LANE, size[0] / length * LANE];
            let parts = (length / 15.0).ceil();
            let point =
                |k: f64, out: f64| bent([0, 1].map(|axis| from[axis] + size[axis] * k / parts + outward[axis] * out));
            lanes.extend((0..parts as u32).map(f64::from).map(|k| Outline {
                outer: vec![point(k + 1.0, 0.0), point(k, 0.0), point(k, 1.0), point(k + 1.0, 1.0)],
                holes: Vec::new(),
            }));
        }
        lanes
    }

    /// The bent outline, with points every few metres.
    fn outline(self, step: f64) -> Vec<[f64; 2]> {
        let ([x, z], [far_x, far_z]) = (self.low, self.high);
        let corners = [[x, z], [x, far_z], [far_x, far_z], [far_x, z]];
        let mut points = Vec::new();
        for (at, from) in corners.iter().enumerate() {
            let to = corners[(at + 1) % 4];
            let parts = ((to[0] - from[0]).abs().max((to[1] - from[1]).abs()) / step).ceil().max(1.0);
            let part = |k: u32| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * f64::from(k) / parts);
            points.extend((0..parts as u32).map(|k| bent(part(k))));
        }
        points
    }

    /// The bent outline with four corners.
    fn lot(self) -> Outline {
        Outline { outer: self.outline(f64::INFINITY), holes: Vec::new() }
    }
}

/// Bends the grid.
fn bent([x, z]: [f64; 2]) -> [f64; 2] {
    [x + 0.0011 * z * z - 12.0, z + 0.0007 * x * x + 0.00001 * x * x * x - 14.0]
}

pub(crate) fn district() -> District {
    let whole = |list: &[f64]| list.iter().sum::<f64>() + STREET * (list.len() - 1) as f64;
    let half = [whole(&WIDTHS) / 2.0, whole(&DEPTHS) / 2.0];
    let all = Rectangle { low: half.map(|half| -half), high: half };
    let mut district = District {
        meadow: Outline {
            outer: vec![[-1500.0, -1500.0], [-1500.0, 1500.0], [1500.0, 1500.0], [1500.0, -1500.0]],
            holes: Vec::new(),
        },
        asphalt: Outline { outer: all.grown(STREET).outline(6.0), holes: Vec::new() },
        ..District::default()
    };
    let mut random = Random(7);
    let mut x = -half[0];
    for (column, width) in WIDTHS.into_iter().enumerate() {
        let mut z = -half[1];
        for (row, depth) in DEPTHS.into_iter().enumerate() {
            let block = Rectangle { low: [x, z], high: [x + width, z + depth] };
            district.sidewalks.push(Outline { outer: block.outline(6.0), holes: Vec::new() });
            district.streets.extend(block.lanes());
            let inner = block.grown(-SIDEWALK);
            match (column, row) {
                (2, 1) => district.gardens.push(Outline { outer: inner.outline(6.0), holes: Vec::new() }),
                (1, 2) => courtyard(&mut district, inner),
                (3, 3) => halls(&mut district, inner),
                _ => rows(&mut district, &mut random, inner),
            }
            z += depth + STREET;
        }
        x += width + STREET;
    }
    district
}

/// One building around a courtyard.
fn courtyard(district: &mut District, block: Rectangle) {
    let court = block.grown(-15.0);
    district.houses.push(Outline { outer: block.lot().outer, holes: vec![court.lot().outer] });
    district.gardens.push(court.grown(-1.0).lot());
}

/// Two buildings shaped like an L.
fn halls(district: &mut District, block: Rectangle) {
    let ([x, z], [far_x, far_z]) = (block.low, block.high);
    let middle = (x + far_x) / 2.0;
    let outline = |points: [[f64; 2]; 6]| Outline { outer: points.map(bent).to_vec(), holes: Vec::new() };
    district.houses.push(outline([
        [x, z],
        [x, far_z],
        [x + 14.0, far_z],
        [x + 14.0, z + 14.0],
        [middle - 3.0, z + 14.0],
        [middle - 3.0, z],
    ]));
    district.houses.push(outline([
        [far_x, far_z],
        [far_x, z],
        [far_x - 14.0, z],
        [far_x - 14.0, far_z - 14.0],
        [middle + 3.0, far_z - 14.0],
        [middle + 3.0, far_z],
    ]));
    district.gardens.push(Rectangle { low: [x + 15.0, z + 15.0], high: [far_x - 15.0, far_z - 15.0] }.lot());
}

/// Rows of houses along all four streets, and a garden in the middle.
fn rows(district: &mut District, random: &mut Random, block: Rectangle) {
    let ([x, z], [far_x, far_z]) = (block.low, block.high);
    for (low, high) in [(z, z + DEPTH), (far_z - DEPTH, far_z)] {
        for [left, right] in cuts(random, x, far_x) {
            district.houses.push(Rectangle { low: [left, low], high: [right, high] }.lot());
        }
    }
    for (low, high) in [(x, x + DEPTH), (far_x - DEPTH, far_x)] {
        // A gap on each side leads to the garden.
        for [left, right] in cuts(random, z + DEPTH + 4.0, far_z - DEPTH) {
            district.houses.push(Rectangle { low: [low, left], high: [high, right] }.lot());
        }
    }
    district.gardens.push(block.grown(-DEPTH - 0.5).lot());
}

/// Divides a length into fronts of 9 to 17 metres.
fn cuts(random: &mut Random, low: f64, high: f64) -> Vec<[f64; 2]> {
    let mut cuts = Vec::new();
    let mut at = low;
    while at < high {
        let mut next = at + random.between(9.0, 17.0);
        if high - next < 9.0 {
            next = high;
        }
        cuts.push([at, next]);
        at = next;
    }
    cuts
}
