//! Jobs in one process.

use std::fs;

use cga_city::units::plan::Plan;
use cga_cluster::engine::Engine;
use cga_cluster::plan::plan_at;
use cga_cluster::store::Objects;
use cga_cluster::work::{StoredWork, publish};
use cga_geo::reader::FileCrs;
use datafusion::arrow::array::{Array as _, AsArray as _};
use datafusion::arrow::datatypes::Int64Type;
use datafusion::dataframe::DataFrameWriteOptions;
use datafusion::prelude::{ParquetReadOptions, SessionContext};

use crate::world::{CHOICES, World, assert_equal, expected_failures, failures, files};

#[tokio::test(flavor = "multi_thread")]
async fn tiles_and_failures_equal_the_output_of_cga_city() {
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
    assert_eq!(rows.iter().filter(|line| line.contains(" true ")).count() as u64, summary.lost_rows);
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
    let unit = first_file(&out.join("units"));
    fs::remove_file(&unit).expect("a file");
    let tile = made.keys().find(|name| name.ends_with(".glb")).expect("a tile");
    fs::write(out.join(tile), "damaged").expect("room");
    let stale = [out.join("tiles/0/17/1/1.glb"), out.join("tiles/0/17/1/1.glb#1"), out.join(format!("{tile}#12"))];
    fs::create_dir_all(stale[0].parent().expect("a folder")).expect("room");
    stale.iter().for_each(|path| fs::write(path, "stale").expect("room"));
    let own = out.join("tiles/note#x");
    fs::write(&own, "of a person").expect("room");
    let again = world.run().await.expect("a city");
    assert_eq!((again.units_made, again.units_kept), (1, 2));
    let file: serde_json::Value = serde_json::from_slice(&fs::read(&unit).expect("a file")).expect("JSON");
    let kept = file["tally"]["kept"].as_u64().expect("a number");
    assert!(1 < kept && file["tally"]["made"].as_u64() <= Some(1), "{file}");
    assert!(stale.iter().all(|path| !path.exists()) && own.exists());
    fs::remove_file(own).expect("a file");

    // Other rules make other tiles, and no old ones stay.
    world.write_job("out", &format!("{CHOICES}set = {{ slope = 50 }}"));
    assert_eq!(world.run().await.expect("a city").units_made, 3);
    assert_equal(&files(&out), &files(&world.expected()));
    assert_ne!(files(&out), made);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_job_that_was_stopped_inside_of_a_unit_leaves_no_tiles_to_the_job_before() {
    let world = World::new(2, 300, 0);
    world.run().await.expect("a city");
    let out = world.path("out");
    let first = files(&out);

    // Other rules, whose job ends after the tiles of a block and before its file.
    let set = first_file(&out.join("sets"));
    let bytes = fs::read(&set).expect("a file");
    fs::remove_file(&set).expect("a file");
    fs::create_dir_all(set.join("full")).expect("room");
    world.write_job("out", &format!("{CHOICES}set = {{ slope = 50 }}"));
    let error = world.run().await.expect_err("stopped");
    assert!(error.contains("cannot make the unit"), "{error}");
    fs::remove_dir_all(&set).expect("a folder");
    fs::write(&set, bytes).expect("room");
    assert_ne!(files(&out), first);

    world.write_job("out", CHOICES);
    world.run().await.expect("a city");
    assert_equal(&files(&out), &first);
}

#[tokio::test(flavor = "multi_thread")]
async fn changed_assets_make_other_tiles_in_the_same_process() {
    let world = World::new(2, 50, 0);
    fs::create_dir(world.path("assets")).expect("room");
    fs::write(world.path("house.cga"), "@StartRule Lot --> i(\"sign.obj\") X.").expect("room");
    world.write_job("out", "assets = \"assets\"\n");
    let mut cities = Vec::new();
    for faces in ["f 1 2 3\nf 1 3 4\n", "f 1 2 3\nf 1 3 4\nf 1 2 4\n"] {
        let mesh = format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\n{faces}");
        fs::write(world.path("assets/sign.obj"), mesh).expect("room");
        world.run().await.expect("a city");
        cities.push(files(&world.path("out")));
        assert_equal(&cities[cities.len() - 1], &files(&world.expected()));
    }
    assert_ne!(cities[0], cities[1]);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_machine_with_other_assets_than_the_client_makes_no_tiles() {
    let world = World::new(1, 20, 0);
    fs::create_dir(world.path("assets")).expect("room");
    fs::write(world.path("assets/sign.obj"), "v 0 0 0").expect("room");
    world.write_job("out", "assets = \"assets\"\n");
    let job = world.job();
    let store = Objects::open(&job.store).expect("a store");
    let work = StoredWork::new(job.work(&FileCrs::Epsg(4326)).expect("a work"), store.clone()).expect("rules");
    let name = publish(&store, &work.loaded.work).expect("room");
    let plan_of = |digest: &str| {
        let plan = Plan::new(name.clone(), digest, Vec::new(), 1, 1, 0.0);
        plan_at(&format!("{}/{}", job.store, publish(&store, &plan).expect("room")))
    };
    assert!(plan_of(&work.loaded.digest).is_ok());
    let error = plan_of("another").expect_err("refused");
    assert!(error.contains("assets` has other files here than on the client"), "{error}");
}

#[tokio::test(flavor = "multi_thread")]
async fn lots_in_folders_of_folders_are_lots() {
    let world = World::new(2, 100, 0);
    let expected = files(&world.expected());
    fs::create_dir_all(world.path("lots/part/deep")).expect("room");
    fs::rename(&world.lots()[1], world.path("lots/part/deep/town.parquet")).expect("a file");
    world.run().await.expect("a city");
    assert_equal(&files(&world.path("out")), &expected);
}

#[tokio::test(flavor = "multi_thread")]
async fn ids_of_other_types_have_the_texts_of_cga_city() {
    for id in ["Date32", "Timestamp(Millisecond, None)", "Timestamp(Microsecond, None)", "Decimal128(20, 3)", "Utf8"] {
        let world = World::new(1, 60, 0);
        cast_ids(&world, id).await;
        world.run().await.expect("a city");
        assert_equal(&files(&world.path("out")), &files(&world.expected()));
    }
    let world = World::new(1, 60, 0);
    cast_ids(&world, "Timestamp(Nanosecond, None)").await;
    let error = world.run().await.expect_err("refused");
    assert!(error.contains("the column `id` has the type Timestamp"), "{error}");
}

/// Gives the ids of the first town another type.
async fn cast_ids(world: &World, kind: &str) {
    let (context, lots) = (SessionContext::new(), &world.lots()[0]);
    let options = ParquetReadOptions::default();
    context.register_parquet("lots", &*lots.to_string_lossy(), options).await.expect("lots");
    // Dates have 32 bits.
    let whole = if kind == "Date32" { "arrow_cast(id, 'Int32')" } else { "id * 1000001" };
    let sql = format!("select arrow_cast({whole}, '{kind}') as id, height, floors, kind, geometry from lots");
    let path = world.path("cast.parquet");
    let rows = context.sql(&sql).await.expect("a query");
    rows.write_parquet(&path.to_string_lossy(), DataFrameWriteOptions::new(), None).await.expect("room");
    fs::rename(path, lots).expect("room");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_wrong_call_of_a_function_is_refused_with_the_type_that_is_wanted() {
    let world = World::new(1, 20, 0);
    let context = Engine::embedded(1).expect("an engine").context;
    let lots = world.lots()[0].to_string_lossy().into_owned();
    context.register_parquet("lots", &*lots, ParquetReadOptions::default()).await.expect("lots");
    let columns = "named_struct('height', height)";
    for (call, why) in [
        (format!("cga_lots(7, geometry, {columns})"), "write the address of a file in the store"),
        (format!("cga_building('a', height, {columns})"), "write a geometry as WKB"),
        ("cga_failures('a', geometry, height)".to_owned(), "write a group of columns"),
        ("cga_building('a', geometry, named_struct('a', [1]))".to_owned(), "the column `a` has the type List"),
        ("cga_units('a', kind, 1)".to_owned(), "write a whole number"),
        ("cga_tile('a', 1, geometry)".to_owned(), "write footprints"),
        ("cga_tile('a', 1, [1, 2])".to_owned(), "write footprints"),
        (format!("cga_building(concat('a', id), geometry, {columns})"), "write a query for each address"),
        (format!("cga_building('a', geometry, {columns})"), "`a` is not a file of a job"),
    ] {
        let rows = async { context.sql(&format!("select {call} from lots")).await?.collect().await };
        let error = rows.await.expect_err(&call).strip_backtrace();
        assert!(error.contains(why), "{call}: {error}");
    }
}

/// The first file below a folder.
fn first_file(folder: &std::path::Path) -> std::path::PathBuf {
    let mut entries: Vec<_> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    if entries[0].is_dir() { first_file(&entries[0]) } else { entries.remove(0) }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_row_becomes_a_building_or_a_reason() {
    let world = World::new(1, 100, 10);
    let (job, engine) = (world.job(), Engine::embedded(2).expect("an engine"));
    let store = Objects::open(&job.store).expect("a store");
    let work = StoredWork::new(job.work(&FileCrs::Epsg(4326)).expect("a work"), store.clone()).expect("rules");
    let name = publish(&store, &work.loaded.work).expect("room");
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
async fn a_building_without_a_face_has_a_reason() {
    let world = World::new(1, 20, 0);
    fs::write(world.path("house.cga"), "@StartRule Lot --> NIL").expect("room");
    world.write_job("out", "");
    let (job, engine) = (world.job(), Engine::embedded(1).expect("an engine"));
    let store = Objects::open(&job.store).expect("a store");
    let work = StoredWork::new(job.work(&FileCrs::Epsg(4326)).expect("a work"), store.clone()).expect("rules");
    let name = publish(&store, &work.loaded.work).expect("room");
    let lots = world.lots()[0].to_string_lossy().into_owned();
    engine.context.register_parquet("lots", &*lots, ParquetReadOptions::default()).await.expect("lots");
    let sql = format!(
        "select count(*) from (select cga_building('{}/{name}', geometry, named_struct('id', id)) as made from lots) \
         where made['glb'] is null and made['reason'] = 'the rules make no face'",
        job.store
    );
    let batches = engine.context.sql(&sql).await.expect("a query").collect().await.expect("rows");
    assert_eq!(batches[0].column(0).as_primitive::<Int64Type>().value(0), 20);
}

#[tokio::test(flavor = "multi_thread")]
async fn wrong_jobs_are_refused_with_a_reason() {
    let world = World::new(1, 20, 0);
    for (choices, why) in [
        (
            "id = \"gid\"",
            "no file of lots has the column `gid`; did you mean `id`? The columns are `id`, `height`, `floors`, `kind`",
        ),
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
