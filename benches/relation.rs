//! Relations of façade tiles, boxes and points to the buildings of a city.
//!
//! `cargo bench --bench relation`, with `-- --instructions` instructions instead of times. The city has blocks of ten buildings with party
//! walls. It is turned, so that the boxes of the tree are larger than the buildings.

mod common;

use std::hint::black_box;
use std::sync::Arc;

use cga::Mesh;
use cga::glam::{DAffine3, DMat3, DVec3};
use cga_geometry::extrude::{Extrude, extrude};
use cga_geometry::relation::{Occluder, Occluders, QueryGeometry, Relation};
use cga_geometry::rotation;
use common::clock::{fastest, nanoseconds_each};
use common::instructions::{Work, counted};
use common::table::{Table, number};

/// The queries of each row.
const QUERIES: usize = 10_000;

/// The sides of a building, in metres.
const BUILDING: [f64; 2] = [12.0, 15.0];

/// Pseudo-random numbers from 0 to 1.
fn mixed(i: usize) -> f64 {
    let mixed = (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    ((mixed ^ mixed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 11) as f64 / (1u64 << 53) as f64
}

/// A turn of the city.
fn city(degrees: f64) -> DAffine3 {
    DAffine3 { matrix3: rotation::turn(0.0, degrees, 0.0), translation: DVec3::new(5e3, 0.0, 3e3) }
}

/// The places of buildings, each with a height: two rows of five buildings in a block, back to back.
fn buildings(count: usize) -> Vec<DAffine3> {
    let blocks_a_row = ((count / 10) as f64).sqrt().ceil() as usize;
    let building = |index: usize| {
        let (block, place) = (index / 10, index % 10);
        let [x, z] = [
            (block % blocks_a_row) as f64 * (5.0 * BUILDING[0] + 14.0) + (place % 5) as f64 * BUILDING[0],
            (block / blocks_a_row) as f64 * (2.0 * BUILDING[1] + 14.0) + (place / 5) as f64 * BUILDING[1],
        ];
        let height = 6.0 + (mixed(index) * 8.0).floor() * 3.0;
        let matrix3 = DMat3::from_diagonal(DVec3::new(BUILDING[0], height, BUILDING[1]));
        DAffine3 { matrix3, translation: DVec3::new(x, 0.0, z) }
    };
    (0..count).map(building).collect()
}

/// A solid with the outline of an L in the unit box.
fn corner_house() -> Mesh {
    let outline = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.4], [0.4, 0.4], [0.4, 1.0], [0.0, 1.0]];
    let outline = outline.map(|[x, z]| DVec3::new(x, 0.0, 1.0 - z));
    extrude(&Mesh::from_polygon(&outline, &[]).expect("an outline"), Extrude::FaceNormal, 1.0)
}

/// The geometries that are compared with the buildings, each with the number of its own building.
fn tiles(places: &[DAffine3], turn: &DAffine3, is_box: bool) -> Vec<(QueryGeometry<'static>, u32)> {
    let tile = |index: usize| {
        let own = (mixed(3 * index) * places.len() as f64) as usize;
        let place = &places[own];
        let size = DVec3::new(BUILDING[0], place.matrix3.y_axis.y, BUILDING[1]);
        let [along, across] = if index & 1 == 0 { [DVec3::X, DVec3::Z] } else { [DVec3::Z, DVec3::X] };
        let face = if index % 4 < 2 { DVec3::ZERO } else { across * size };
        let at = along * ((size.dot(along) - 3.0) * mixed(3 * index + 1))
            + DVec3::Y * ((size.y - 3.0) * mixed(3 * index + 2));
        let corner = turn.transform_point3(place.translation + face + at);
        let sides = [along * 3.0, DVec3::Y * 3.0, across].map(|side| turn.matrix3 * side);
        let geometry = if is_box {
            let matrix3 = DMat3::from_cols(sides[0], sides[1], sides[2]);
            QueryGeometry::cuboid(DAffine3 { matrix3, translation: corner })
        } else {
            QueryGeometry::rectangle(corner, [sides[0], sides[1]])
        };
        (geometry, own as u32)
    };
    (0..QUERIES).map(tile).collect()
}

/// A row of the table.
#[derive(Clone, Copy)]
struct Row {
    name: &'static str,
    buildings: usize,
    /// The turn of the city.
    degrees: f64,
    /// True for boxes on façades, false for tiles.
    is_box: bool,
    /// True for buildings with an outline like an L.
    is_concave: bool,
    wanted: Relation,
}

const TILES: Row = Row {
    name: "tiles, 100,000 boxes",
    buildings: 100_000,
    degrees: 20.0,
    is_box: false,
    is_concave: false,
    wanted: Relation::ALL,
};

const ROWS: [Row; 7] = [
    Row { name: "tiles, 1,000 boxes", buildings: 1_000, ..TILES },
    Row { name: "tiles, 10,000 boxes", buildings: 10_000, ..TILES },
    TILES,
    Row { name: "tiles, 100,000 boxes along the axes", degrees: 0.0, ..TILES },
    Row { name: "tiles, 100,000 boxes, touches alone", wanted: Relation::TOUCHES, ..TILES },
    Row { name: "boxes on façades, 100,000 boxes", is_box: true, ..TILES },
    Row { name: "tiles, 100,000 concave buildings", is_concave: true, ..TILES },
];

impl Row {
    /// All queries of the row.
    fn prepared(self) -> impl FnMut() {
        let (places, turn) = (buildings(self.buildings), city(self.degrees));
        let mesh = self.is_concave.then(|| Arc::new(corner_house()));
        let occluder = |place: &DAffine3| match &mesh {
            Some(mesh) => Occluder::mesh(mesh.clone(), turn * *place),
            None => Occluder::cuboid(turn * *place),
        };
        let occluders = Occluders::new(places.iter().map(occluder));
        let geometries = tiles(&places, &turn, self.is_box);
        move || {
            let mut related = 0;
            for (geometry, own) in &geometries {
                let found = occluders.query(black_box(geometry), self.wanted, &mut |number| number != *own);
                related += usize::from(found != Relation::NONE);
            }
            // Party walls.
            assert!(QUERIES / 8 < related && related < QUERIES * 3 / 4, "{related} queries have a relation");
        }
    }
}

fn main() {
    let work = |row: Row| Work::new(row.name, move || (QUERIES, row.prepared()));
    if counted("Relations to buildings", "query", &ROWS.map(work)) {
        return;
    }
    let mut table = Table::new("Relations to buildings", &["queries", "ns a query"]);
    for row in ROWS {
        let [best] = fastest(0.5, [&mut row.prepared()]);
        table.row(row.name, &[number(nanoseconds_each(best, QUERIES), 0)]);
    }
    table.print();
    let mut table = Table::new("A tree of buildings", &["buildings", "ns a building"]);
    let (places, turn) = (buildings(TILES.buildings), city(TILES.degrees));
    let mut build = || _ = black_box(Occluders::new(places.iter().map(|place| Occluder::cuboid(turn * *place))));
    let [best] = fastest(0.5, [&mut build]);
    table.row("100,000 boxes", &[number(nanoseconds_each(best, places.len()), 0)]);
    table.print();
}
