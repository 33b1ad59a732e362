//! Files of lots with other columns than each other.

use std::fs;

use datafusion::dataframe::DataFrameWriteOptions;
use datafusion::prelude::{ParquetReadOptions, SessionContext};

use crate::world::{World, assert_equal, expected_failures, failures, files};

/// Changes the columns of a file of lots by a query.
async fn change(world: &World, file: usize, columns: &str) {
    let (context, lots) = (SessionContext::new(), &world.lots()[file]);
    context.register_parquet("lots", &*lots.to_string_lossy(), ParquetReadOptions::default()).await.expect("lots");
    let rows = context.sql(&format!("select {columns} from lots")).await.expect("a query");
    let path = world.path("changed.parquet");
    rows.write_parquet(&path.to_string_lossy(), DataFrameWriteOptions::new(), None).await.expect("room");
    fs::rename(path, lots).expect("room");
}

/// Writes a job that names the files of lots one by one, from the first to the last or from the last to the first.
fn name_files(world: &World, is_reversed: bool) {
    let mut names = ["\"lots/town-0.parquet\"", "\"lots/town-1.parquet\""];
    if is_reversed {
        names.reverse();
    }
    let text = format!("store = \"out\"\nlots = [{}]\nrules = [\"house.cga\"]\n", names.join(", "));
    fs::write(world.path("job.toml"), text).expect("room");
}

#[tokio::test(flavor = "multi_thread")]
async fn lots_without_a_column_for_the_rules_are_built() {
    let world = World::new(1, 60, 20);
    change(&world, 0, "geometry").await;
    let summary = world.run().await.expect("a city");
    assert_eq!(summary.lost_rows, 3);
    assert_equal(&files(&world.path("out")), &files(&world.expected()));
}

#[tokio::test(flavor = "multi_thread")]
async fn equal_batches_of_rows_that_failed_have_all_their_lines() {
    let world = World::new(1, 60, 0);
    // Several batches have nothing but rows without a geometry.
    change(&world, 0, "unnest(array_resize([geometry], case id when 1 then 40001 else 1 end)) as geometry").await;
    let summary = world.run().await.expect("a city");
    assert_eq!((summary.failed_rows, summary.lost_rows), (40_000, 40_000));
    assert_equal(&files(&world.path("out")), &files(&world.expected()));
    let found = failures(&world.path("out"));
    assert!(found == expected_failures(&world.path("expected")), "{} lines", found[0].len());
    // The same parts again.
    world.run().await.expect("a city");
    assert!(found == failures(&world.path("out")));
}

#[tokio::test(flavor = "multi_thread")]
async fn a_column_of_one_file_is_read_in_any_order_of_the_files() {
    let world = World::new(2, 60, 0);
    change(&world, 0, "id, geometry").await;
    for is_reversed in [false, true] {
        name_files(&world, is_reversed);
        world.run().await.expect("a city");
        assert_equal(&files(&world.path("out")), &files(&world.expected()));
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn numbers_and_texts_of_several_types_are_read_as_the_same_column() {
    let world = World::new(2, 60, 0);
    let types = "arrow_cast(id, 'Int64') as id, arrow_cast(height, 'Float32') as height, \
                 arrow_cast(kind, 'Dictionary(Int32, Utf8)') as kind, floors > 2 as floors, geometry";
    change(&world, 0, types).await;
    change(&world, 1, "arrow_cast(id, 'Int32') as id, arrow_cast(height, 'Int16') as height, kind, floors, geometry")
        .await;
    world.write_job("out", "");
    world.run().await.expect("a city");
    let whole = files(&world.path("out"));
    assert_equal(&whole, &files(&world.expected()));
    for is_reversed in [false, true] {
        name_files(&world, is_reversed);
        world.run().await.expect("a city");
        assert_equal(&files(&world.path("out")), &whole);
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn columns_that_differ_too_much_and_geometries_of_other_types_are_refused() {
    let world = World::new(2, 20, 0);
    change(&world, 0, "id, 3 < height as height, floors, kind, geometry").await;
    for is_reversed in [false, true] {
        name_files(&world, is_reversed);
        let error = world.run().await.expect_err("refused");
        let files = ["town-0.parquet` is Boolean", "town-1.parquet` is Float64"];
        assert!(files.iter().all(|file| error.contains(file)), "{error}");
        assert!(error.contains("the column `height`") && error.contains("write one type"), "{error}");
    }
    let world = World::new(1, 20, 0);
    change(&world, 0, "id, 'POINT (1 2)' as geometry").await;
    let error = world.run().await.expect_err("refused");
    assert!(error.contains("the column `geometry` has the type Utf8") && error.contains("write it as WKB"), "{error}");
}
