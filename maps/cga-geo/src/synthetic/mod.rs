//! Made-up outlines, and files of them: towns without data of others, for tests, measurements and a first try.

#[cfg(feature = "flatgeobuf")]
mod flatgeobuf;
#[cfg(feature = "geojson")]
mod geojson;
#[cfg(feature = "geoparquet")]
mod geoparquet;
#[cfg(feature = "shapefile")]
mod shapefile;

use std::path::Path;

use crate::frame::metres_a_degree;
use crate::outline::Corner;

/// The metres from a lot to the next one.
const SPACING: f64 = 28.0;

/// A town of made-up outlines around a place: rectangles, L and U, courtyards, two buildings in a row, slivers, and, on request,
/// rows that cannot be used. Equal towns have equal rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Town {
    /// The number of rows.
    pub rows: u64,
    /// The seed of all random choices.
    pub seed: u64,
    /// The longitude and latitude of its middle in degrees.
    pub middle: Corner,
    /// One in this many rows cannot be used; 0 for none.
    pub broken: u64,
}

/// A row of a town.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeRow {
    /// The column `id`.
    pub id: i64,
    /// The column `height` in metres.
    pub height: f64,
    /// The column `floors`.
    pub floors: i64,
    /// The column `kind`: home, shop or hall.
    pub kind: &'static str,
    /// Polygons of rings of corners in degrees; the last corner of a ring repeats the first.
    pub polygons: Vec<Vec<Vec<Corner>>>,
}

impl Town {
    /// A town of good rows.
    pub fn new(rows: u64) -> Self {
        Town { rows, seed: 1, middle: [10.0, 50.0], broken: 0 }
    }

    /// The rows, one after another.
    pub fn iter(&self) -> impl Iterator<Item = MadeRow> + use<> {
        let town = *self;
        (0..self.rows).map(move |number| town.row(number))
    }

    fn row(&self, number: u64) -> MadeRow {
        let mut random = Random(self.seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ number);
        let height = (random.between(4.0, 22.0) * 10.0).round() / 10.0;
        let kind = ["home", "home", "home", "shop", "hall"][random.below(5)];
        let place = self.place(number, &mut random);
        let mut polygons = outline(&mut random);
        polygons.iter_mut().flatten().flatten().for_each(|corner| *corner = place.corner(*corner));
        if 0 < self.broken && number % self.broken == self.broken - 1 {
            damage(&mut polygons, number / self.broken);
        }
        for ring in polygons.iter_mut().flatten() {
            ring.extend(ring.first().copied());
        }
        MadeRow { id: number as i64 + 1, height, floors: (height / 3.0) as i64, kind, polygons }
    }

    /// The place of a lot on a square grid.
    fn place(&self, number: u64, random: &mut Random) -> Place {
        let side = ((self.rows as f64).sqrt().ceil() as u64).max(1);
        let steps = [(number % side) as f64, (number / side) as f64].map(|step| step - side as f64 / 2.0);
        let (sin, cos) = libm::sincos(random.between(-0.5, 0.5));
        Place {
            middle: self.middle,
            degree: metres_a_degree(self.middle[1]),
            offset: steps.map(|step| step * SPACING),
            sin,
            cos,
        }
    }

    /// Writes the rows to a file: GeoJSON, FlatGeobuf (which orders the rows itself), Shapefile or GeoParquet, by the ending of its name.
    ///
    /// # Errors
    /// A sentence about the file.
    pub fn write(&self, path: &Path) -> Result<(), String> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
        let written: Result<(), Box<dyn std::error::Error>> = match ending.as_str() {
            #[cfg(feature = "geojson")]
            "geojson" => geojson::write(self, path),
            #[cfg(feature = "flatgeobuf")]
            "fgb" => flatgeobuf::write(self, path),
            #[cfg(feature = "shapefile")]
            "shp" => shapefile::write(self, path),
            #[cfg(feature = "geoparquet")]
            "parquet" => geoparquet::write(self, path),
            _ => Err("its name ends in none of .geojson, .fgb, .shp and .parquet".into()),
        };
        written.map_err(|why| format!("cannot write `{}`: {why}", path.display()))
    }
}

/// The place of a lot, turned by an angle.
struct Place {
    middle: Corner,
    /// The metres in a degree.
    degree: Corner,
    offset: Corner,
    sin: f64,
    cos: f64,
}

impl Place {
    fn corner(&self, [x, y]: Corner) -> Corner {
        let turned = [x * self.cos - y * self.sin, x * self.sin + y * self.cos];
        [0, 1].map(|axis| self.middle[axis] + (self.offset[axis] + turned[axis]) / self.degree[axis])
    }
}

/// Polygons in metres, counter-clockwise with clockwise holes; one in ten runs the other way.
fn outline(random: &mut Random) -> Vec<Vec<Vec<Corner>>> {
    let (w, d) = (random.between(8.0, 20.0), random.between(8.0, 16.0));
    let ring = |corners: &[[f64; 2]]| -> Vec<Corner> { corners.iter().map(|[x, y]| [x * w, y * d]).collect() };
    let whole = ring(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let mut polygons = match random.below(100) {
        0..60 => vec![vec![whole]],
        60..78 => vec![vec![ring(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.5, 0.5], [0.5, 1.0], [0.0, 1.0]])]],
        78..88 => {
            let u =
                [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.65, 1.0], [0.65, 0.4], [0.35, 0.4], [0.35, 1.0], [0.0, 1.0]];
            vec![vec![ring(&u)]]
        }
        88..93 => vec![vec![whole, ring(&[[0.3, 0.3], [0.3, 0.7], [0.7, 0.7], [0.7, 0.3]])]],
        93..97 => {
            let right = ring(&[[0.6, 0.0], [1.0, 0.0], [1.0, 1.0], [0.6, 1.0]]);
            vec![vec![ring(&[[0.0, 0.0], [0.4, 0.0], [0.4, 1.0], [0.0, 1.0]])], vec![right]]
        }
        _ => vec![vec![ring(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.01], [0.0, 0.01]])]],
    };
    if random.below(10) == 0 {
        polygons.iter_mut().flatten().for_each(|ring| ring[1..].reverse());
    }
    polygons
}

/// Makes a row useless, in one of several ways.
fn damage(polygons: &mut Vec<Vec<Vec<Corner>>>, way: u64) {
    let [first, second] = [polygons[0][0][0], polygons[0][0][1]];
    polygons.truncate(1);
    match way % 5 {
        0 => polygons[0] = vec![vec![first, second, [f64::NAN, first[1]]]],
        1 => polygons[0] = vec![vec![first, first, first]],
        // The long way around: the two lobes of the knot have different areas.
        2 => {
            let [x, y] = first;
            polygons[0] = vec![vec![first, [x + 2e-4, y + 2e-4], [x + 2e-4, y], [x, y + 1e-4]]];
        }
        3 => polygons[0][0][1][0] += 90.0,
        // One row has very many corners.
        _ if way == 4 => {
            let corner = |at: u32| {
                [first[0] + 1e-4 * libm::cos(f64::from(at) / 2e4), first[1] + 1e-4 * libm::sin(f64::from(at) / 2e4)]
            };
            polygons[0] = vec![(0..100_000).map(corner).collect()];
        }
        _ => polygons[0] = vec![vec![first, second, first, second]],
    }
}

/// Random numbers by splitmix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, count: u64) -> usize {
        (self.next() % count) as usize
    }
}
