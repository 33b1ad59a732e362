//! Rules that ask about neighbours find lots of other tiles and other units, as in `cga-city`.

use std::fs;
use std::sync::Arc;

use cga_city::build::Options;
use cga_city::cell::{Cell, key};
use cga_city::surroundings::Distances;
use cga_cluster::run::Summary;
use cga_geo::frame::metres_a_degree;
use datafusion::arrow::array::{ArrayRef, BinaryArray, Float64Array, RecordBatch, StringArray};
use datafusion::dataframe::DataFrameWriteOptions;
use datafusion::prelude::SessionContext;

use crate::cluster::Cluster;
use crate::world::{World, assert_equal, expected_failures, failures, files};

/// Houses without walls where they touch others, with an inner wall where they are in another one, and as high as others are many. A house of
/// 66 m has no end.
const RULES: &str = "attr height = 9
    @StartRule Lot --> case height == 66 : Endless(1) else : extrude(height) label(\"house\") comp(f) { side : Wall | top : Roof. }
    Wall --> case touches(inter) : NIL case overlaps(inter) : Overlap. case inside(inter) : extrude(-0.1) Inside. else : Wall.
    Endless(n) --> case n < 0 : X. else : Endless(n + 1)
    @StartRule Block --> extrude(height) X.
    @StartRule Counted --> extrude(contextCount(inter, \"house\") + minimumDistance(inter, \"house\") / 100 + 1) X. ";

const CHOICES: &str = "start_column = \"rule\"\ntile_lots = 5\nunit_lots = 1\n";

/// A row of a map.
#[derive(Clone, Debug)]
struct House {
    id: Option<String>,
    height: f64,
    rule: Option<&'static str>,
    outline: Option<Vec<[f64; 2]>>,
}

/// A house with a south-west corner and sizes in metres. Longitudes beyond 180 degrees are on the other side of the world.
fn house(id: usize, [longitude, latitude]: [f64; 2], metres: [f64; 2]) -> House {
    let degree = metres_a_degree(latitude);
    let [east, north] = [0, 1].map(|axis| metres[axis] / degree[axis]);
    let turned = longitude - 360.0 * (longitude / 360.0).round();
    let ring = [[0.0, 0.0], [east, 0.0], [east, north], [0.0, north], [0.0, 0.0]];
    let outline = ring.map(|[x, y]| [turned + x, latitude + y]).to_vec();
    House { id: Some(format!("{id:05}")), height: 9.0, rule: None, outline: Some(outline) }
}

fn wkb(outline: &[[f64; 2]]) -> Vec<u8> {
    let mut out = vec![1, 3, 0, 0, 0, 1, 0, 0, 0];
    out.extend((outline.len() as u32).to_le_bytes());
    outline.iter().flatten().for_each(|number| out.extend(number.to_le_bytes()));
    out
}

/// A job with lots in two files.
async fn world(houses: &[House], choices: &str) -> World {
    let mut world = World::empty(RULES);
    write(&mut world, houses).await;
    world.write_job("out", &format!("{CHOICES}{choices}"));
    world
}

/// Houses with other rules on both sides of a border of units.
pub(crate) async fn border_world(rules: &str) -> World {
    let mut world = World::empty(rules);
    let houses = crowd(corner([9.2, 48.0]), 60, 100.0);
    let houses: Vec<House> = houses.into_iter().map(|house| House { rule: None, ..house }).collect();
    write(&mut world, &houses).await;
    world
}

async fn write(world: &mut World, houses: &[House]) {
    for (number, part) in houses.chunks(houses.len().div_ceil(2)).enumerate() {
        let ids: StringArray = part.iter().map(|house| house.id.clone()).collect();
        let heights: Float64Array = part.iter().map(|house| Some(house.height)).collect();
        let rules: StringArray = part.iter().map(|house| house.rule).collect();
        let outlines: BinaryArray = part.iter().map(|house| house.outline.as_deref().map(wkb)).collect();
        let columns: [(&str, ArrayRef); 4] = [
            ("id", Arc::new(ids)),
            ("height", Arc::new(heights)),
            ("rule", Arc::new(rules)),
            ("geometry", Arc::new(outlines)),
        ];
        let path = world.add_lots(&format!("part-{number}.parquet"));
        let rows = SessionContext::new().read_batch(RecordBatch::try_from_iter(columns).expect("rows")).expect("rows");
        rows.write_parquet(&path.to_string_lossy(), DataFrameWriteOptions::new(), None).await.expect("room");
    }
}

/// A corner of four cells of the depth 10, which have blocks and so units of their own.
fn corner(place: [f64; 2]) -> [f64; 2] {
    Cell::with(key(place), 9).middle()
}

/// Random houses around a place, some in and over others.
fn crowd(place: [f64; 2], count: usize, metres: f64) -> Vec<House> {
    let mut random = 11u64;
    let mut number = move || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 11) as f64 / (1u64 << 53) as f64
    };
    let degree = metres_a_degree(place[1]);
    let mut at = |id: usize| {
        let corner = [0, 1].map(|axis| place[axis] + (number() - 0.5) * metres / degree[axis]);
        let size = 3.0 + 9.0 * number();
        let rule = [None, None, Some("Counted"), Some("Block"), Some("Lot")][(5.0 * number()) as usize];
        House { rule, height: 5.0 + (4.0 * number()).floor(), ..house(id, corner, [size, size]) }
    };
    (0..count).map(&mut at).collect()
}

/// Makes the city in this process and with `cga-city`, and compares them. `metres` are the distances for `cga-city`.
async fn compare(world: &World, metres: [f64; 2]) -> Summary {
    let summary = world.run().await.expect("a city");
    let neighbours = Some(Distances { occlusion: metres[0], context: metres[1] });
    let expected = world.expected_with(|options| Options { neighbours, ..options });
    assert_equal(&files(&world.path("out")), &files(&expected));
    let [rows, buildings] = failures(&world.path("out"));
    assert_eq!([&rows, &buildings], expected_failures(&expected).each_ref());
    summary
}

/// Returns true if `cga-city` makes other tiles without neighbours.
fn needs_neighbours(world: &World) -> bool {
    files(&world.expected_with(|options| Options { neighbours: None, ..options })) != files(&world.path("out"))
}

#[tokio::test(flavor = "multi_thread")]
async fn lots_of_other_units_are_neighbours() {
    for place in [corner([9.2, 48.0]), [180.0, 48.0], [0.0, 0.0], [180.0, 84.5], [-180.0, -16.0]] {
        let world = world(&crowd(place, 80, 100.0), "").await;
        let summary = compare(&world, [1.0, 100.0]).await;
        assert!(2 <= summary.units_made, "{place:?}: {summary:?}");
        assert!(needs_neighbours(&world));
        assert_eq!(compare(&world, [1.0, 100.0]).await.units_made, 0);
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn each_distance_has_the_tiles_of_cga_city() {
    let houses = crowd(corner([9.2, 48.0]), 80, 100.0);
    for (choices, metres) in [
        ("occlusion_distance = 0\ncontext_distance = 0", [0.0, 0.0]),
        ("context_distance = 7.5\nlod = [\"Counted\"]", [1.0, 7.5]),
        ("occlusion_distance = 30\ncontext_distance = 20\nlod = [\"Block\", \"Counted@40\"]", [30.0, 20.0]),
        ("context_distance = 1000", [1.0, 1000.0]),
    ] {
        compare(&world(&houses, choices).await, metres).await;
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_large_lot_of_a_far_unit_is_a_neighbour() {
    let [longitude, latitude] = corner([9.2, 48.0]);
    let [east, north] = metres_a_degree(latitude);
    // Houses 30 m west of the border, and halls of 6 km whose middles are 3 km east of it. A second hall ends before the houses.
    let mut houses = crowd([longitude - 80.0 / east, latitude + 500.0 / north], 40, 60.0);
    houses.iter_mut().for_each(|house| house.rule = None);
    let all = world(&houses, "").await;
    compare(&all, [1.0, 100.0]).await;
    let alone = files(&all.path("out"));
    houses.push(house(900, [longitude - 78.0 / east, latitude + 490.0 / north], [6000.0, 20.0]));
    houses.push(house(901, [longitude + 9.0 / east, latitude + 470.0 / north], [6000.0, 20.0]));
    let world = world(&houses, "").await;
    assert_eq!(compare(&world, [1.0, 100.0]).await.units_made, 2);
    let found = files(&world.path("out"));
    assert!(alone.iter().any(|(name, bytes)| found.get(name) != Some(bytes)));
    assert!(needs_neighbours(&world));
}

#[tokio::test(flavor = "multi_thread")]
async fn a_change_beyond_the_border_makes_the_unit_again() {
    let [longitude, latitude] = corner([9.2, 48.0]);
    let [east, north] = metres_a_degree(latitude);
    // Two rows of houses: one touches the border from the west and one from the east, and both have houses far away.
    let place = |metres: f64| [longitude + metres / east, latitude + 500.0 / north];
    let houses: Vec<House> = [-1000.0, -20.0, -10.0, 0.0, 10.0, 1000.0]
        .into_iter()
        .enumerate()
        .map(|(id, metres)| house(id, place(metres), [10.0, 10.0]))
        .collect();
    let mut world = world(&houses, "").await;
    assert_eq!(compare(&world, [1.0, 100.0]).await.units_made, 2);
    for (changed, units_made) in [(3, 2), (5, 1), (1, 2), (0, 1)] {
        let mut higher = houses.clone();
        higher[changed].height = 12.0;
        write(&mut world, &higher).await;
        assert_eq!(compare(&world, [1.0, 100.0]).await.units_made, units_made, "house {changed}");
        // A run that was stopped before the unit had its file.
        fs::remove_dir_all(world.path("out/units")).expect("a folder");
        let again = compare(&world, [1.0, 100.0]).await;
        assert_eq!((again.units_made, again.tally.made), (2, 0));
        write(&mut world, &houses).await;
        assert_eq!(compare(&world, [1.0, 100.0]).await.units_made, units_made, "house {changed}");
    }
    // Rules that do not ask read their own lots alone.
    fs::write(world.path("house.cga"), "attr height = 9 @StartRule Lot --> extrude(height) X.").expect("room");
    assert_eq!(compare(&world, [1.0, 100.0]).await.units_made, 2);
    let mut higher = houses;
    higher[3].height = 15.0;
    write(&mut world, &higher).await;
    assert_eq!(compare(&world, [1.0, 100.0]).await.units_made, 1);
}

#[tokio::test(flavor = "multi_thread")]
async fn hostile_rows_around_a_border_have_the_tiles_of_cga_city() {
    for place in [corner([9.2, 48.0]), [180.0, 60.0]] {
        let mut houses = crowd(place, 60, 80.0);
        let [east, _] = metres_a_degree(place[1]);
        let last = houses.len();
        // Equal ids, and rows that fail, are unknown or cannot be used.
        houses.extend(houses[..5].to_vec());
        houses.push(House { height: 66.0, ..house(last, place, [9.0, 9.0]) });
        houses.push(House { height: f64::NAN, ..house(last + 1, place, [8.0, 9.0]) });
        houses.push(House { rule: Some("Nothing"), ..house(last + 2, place, [7.0, 9.0]) });
        houses.push(House { id: None, ..house(last + 3, place, [6.0, 9.0]) });
        houses.push(House { outline: None, ..house(last + 4, place, [6.0, 9.0]) });
        houses.push(House { outline: Some(vec![[f64::NAN, 1.0]; 4]), ..house(last + 5, place, [6.0, 9.0]) });
        houses.push(House { outline: Some(vec![place; 4]), ..house(last + 6, place, [6.0, 9.0]) });
        // A lot over the border, one of 19 km, and a needle.
        houses.push(house(last + 7, [place[0] - 5.0 / east, place[1]], [10.0, 10.0]));
        houses.push(house(last + 8, [place[0] - 9000.0 / east, place[1]], [19_000.0, 50.0]));
        houses.push(house(last + 9, [place[0] - 300.0 / east, place[1]], [900.0, 0.02]));
        let world = world(&houses, "id = \"id\"").await;
        let summary = compare(&world, [1.0, 100.0]).await;
        assert!(2 <= summary.units_made && 3 <= summary.lost_rows && 1 <= summary.lost, "{summary:?}");
        assert!(needs_neighbours(&world));
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn too_many_lots_beyond_the_border_are_a_note() {
    let [longitude, latitude] = corner([9.2, 48.0]);
    let [east, north] = metres_a_degree(latitude);
    let place = |x: f64, y: f64| [longitude + x / east, latitude + (500.0 + y) / north];
    let mut houses: Vec<House> = (0..33_000)
        .map(|id| House {
            rule: Some("Block"),
            ..house(id, place(1.0 + (id % 200) as f64 / 4.0, (id / 200) as f64 / 4.0), [0.2, 0.2])
        })
        .collect();
    houses.extend((0..4).map(|id| house(90_000 + id, place(-12.0, 10.0 * id as f64), [10.0, 10.0])));
    let world = world(&houses, "").await;
    world.write_job("out", "start_column = \"rule\"\ntile_lots = 2000\nunit_lots = 1\n");
    let summary = compare(&world, [1.0, 100.0]).await;
    assert_eq!((summary.units_made, summary.notes), (2, 1));
    assert!(failures(&world.path("out"))[1][0].contains("more than 32768 lots are within 100 m"));
}

#[tokio::test(flavor = "multi_thread")]
async fn lots_of_other_units_are_neighbours_on_ballista() {
    let mut houses = crowd(corner([9.2, 48.0]), 80, 100.0);
    houses.extend(
        crowd([180.0, 48.0], 80, 100.0)
            .into_iter()
            .map(|house| House { id: house.id.map(|id| format!("b{id}")), ..house }),
    );
    let world = world(&houses, "partitions = 4\n").await;
    let cluster = Cluster::new(&world);
    let (_scheduler, _one, _two) = (cluster.scheduler(), cluster.executor("one"), cluster.executor("two"));
    assert!(cluster.submit().ended_well(), "{}", cluster.logs());
    assert_equal(&files(&world.path("out")), &files(&world.expected()));
    assert!(needs_neighbours(&world));
}
