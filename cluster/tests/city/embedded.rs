//! Jobs in one process.

use std::fs;

use cga_cluster::engine::Engine;
use cga_cluster::store::Objects;
use cga_cluster::work::{LoadedWork, publish};
use cga_geo::reader::FileCrs;
use datafusion::arrow::array::{Array as _, AsArray as _};
use datafusion::prelude::ParquetReadOptions;

use crate::world::{CHOICES, World, assert_equal, expected_failures, failures, files};

#[tokio::test(flavor = "multi_thread")]
async fn tiles_and_failures_are_those_of_cga_city() {
    let world = World::new(5, 2000, 100);
    let summary = world.run().await.expect("a city");
    let expected = world.expected();
    assert_equal(&files(&world.path("out")), &files(&expected));
    let [rows, buildings] = failures(&world.path("out"));
    assert_eq!([&rows, &buildings], expected_failures(&expected).each_ref());
    // One row in 100 is broken, and some halls fail.
    assert!(100 <= rows.iter().filter(|line| line.contains(" true ")).count());
    assert!(!buildings.is_empty() && buildings.len() as u64 == summary.lost + summary.notes);
    assert_eq!(rows.len() as u64, summary.failed_rows);
    assert_eq!((summary.units_made, summary.units_kept), (5, 0));
}

#[tokio::test(flavor = "multi_thread")]
async fn finished_units_and_tiles_are_not_made_again() {
    let world = World::new(3, 400, 0);
    world.run().await.expect("a city");
    let out = world.path("out");
    let made = files(&out);
    let again = world.run().await.expect("a city");
    assert_eq!((again.units_made, again.units_kept), (0, 3));

    // A run that was stopped: a unit without a file, and a tile that is damaged.
    let unit = cga_city_file(&out.join("units"));
    fs::remove_file(&unit).expect("a file");
    let tile = made.keys().find(|name| name.ends_with(".glb")).expect("a tile");
    fs::write(out.join(tile), "damaged").expect("room");
    let stale = out.join("tiles/0/17/1/1.glb");
    fs::create_dir_all(stale.parent().expect("a folder")).expect("room");
    fs::write(&stale, "stale").expect("room");
    let again = world.run().await.expect("a city");
    assert_eq!((again.units_made, again.units_kept), (1, 2));
    let file: serde_json::Value = serde_json::from_slice(&fs::read(&unit).expect("a file")).expect("JSON");
    let kept = file["tally"]["kept"].as_u64().expect("a number");
    assert!(1 < kept && file["tally"]["made"].as_u64() <= Some(1), "{file}");
    assert!(!stale.exists());

    // Other rules make other tiles, and no old ones stay.
    world.write_job("out", &format!("{CHOICES}set = {{ slope = 50 }}"));
    assert_eq!(world.run().await.expect("a city").units_made, 3);
    assert_equal(&files(&out), &files(&world.expected()));
    assert_ne!(files(&out), made);
}

/// The first file below a folder.
fn cga_city_file(folder: &std::path::Path) -> std::path::PathBuf {
    let mut entries: Vec<_> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    if entries[0].is_dir() { cga_city_file(&entries[0]) } else { entries.remove(0) }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_row_becomes_a_building_or_a_reason() {
    let world = World::new(1, 100, 10);
    let (job, engine) = (world.job(), Engine::embedded(2).expect("an engine"));
    let store = Objects::open(&job.store).expect("a store");
    let work = LoadedWork::new(job.work(&FileCrs::Epsg(4326)).expect("a work"), store.clone()).expect("rules");
    let name = publish(&store, &work.work).expect("room");
    let lots = world.path("lots/town-0.parquet");
    engine
        .context
        .register_parquet("lots", &*lots.to_string_lossy(), ParquetReadOptions::default())
        .await
        .expect("lots");
    let sql = format!(
        "select made['glb'], made['reason'] from (select cga_building('{}/{name}', geometry, \
         named_struct('height', height, 'id', id)) as made from lots order by id)",
        job.store
    );
    let batches = engine.context.sql(&sql).await.expect("a query").collect().await.expect("rows");
    let (mut buildings, mut reasons) = (0, 0);
    for batch in &batches {
        let (files, texts) = (batch.column(0).as_binary::<i64>(), batch.column(1).as_string::<i32>());
        for row in 0..batch.num_rows() {
            assert!(files.is_valid(row) || texts.is_valid(row));
            buildings += usize::from(files.is_valid(row) && files.value(row).starts_with(b"glTF"));
            reasons += usize::from(files.is_null(row));
        }
    }
    assert_eq!((buildings, reasons), (90, 10));
}

#[tokio::test(flavor = "multi_thread")]
async fn wrong_jobs_are_refused_with_a_reason() {
    let world = World::new(1, 20, 0);
    for (choices, why) in [
        ("id = \"gid\"", "no file of lots has the column `gid`; their columns are id, height, floors, kind, geometry"),
        ("attributes = { floors = \"storeys\" }", "`storeys` is not an attribute of the rules"),
        ("lod = [\"Blok\"]", "its start rules are Lot, "),
        ("set = { hight = 3 }", "hight"),
        ("crs = \"Gauss\"", "write `EPSG:25832`"),
    ] {
        world.write_job("out", choices);
        let error = world.run().await.expect_err(choices);
        assert!(error.contains(why), "{choices}: {error}");
    }
    // A folder with other files, and lots that do not exist.
    world.write_job("lots", "");
    assert!(world.run().await.expect_err("refused").contains("has files that are not a city"));
    fs::remove_file(world.path("lots/town-0.parquet")).expect("a file");
    world.write_job("out", "");
    assert!(world.run().await.expect_err("refused").contains("has no file .parquet"));
    // All rows are broken.
    let world = World::new(1, 20, 1);
    assert!(world.run().await.expect_err("empty").contains("the city is empty"));
    assert_eq!(failures(&world.path("out"))[0].len(), 20);
}
