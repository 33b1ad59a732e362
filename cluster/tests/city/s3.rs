//! Lots and tiles through an S3 interface. `.ci/cluster` starts a local server and names a bucket in `CGA_CLUSTER_S3`, as in `s3://cga`.

use std::collections::BTreeMap;

use cga_city::store::Store as _;
use cga_cluster::store::Objects;

use crate::world::{CHOICES, World, assert_equal, files};

#[tokio::test(flavor = "multi_thread")]
async fn an_s3_interface_has_the_same_tiles() {
    let Ok(bucket) = std::env::var("CGA_CLUSTER_S3") else {
        eprintln!("skipped: an S3 interface, as `CGA_CLUSTER_S3` is not set");
        return;
    };
    let world = World::new(3, 500, 50);
    let run = format!("{bucket}/{}", std::process::id());
    let lots = Objects::open(&format!("{run}/lots")).expect("a store");
    for name in ["town-0.parquet", "town-1.parquet", "town-2.parquet"] {
        lots.write(name, std::fs::read(world.path("lots").join(name)).expect("lots")).expect("room");
    }
    let text = format!("store = \"{run}/out\"\nlots = [\"{run}/lots/\"]\nrules = [\"house.cga\"]\n{CHOICES}");
    std::fs::write(world.path("job.toml"), text).expect("room");
    let summary = world.run().await.expect("a city");
    let out = Objects::open(&format!("{run}/out")).expect("a store");
    let mut found = BTreeMap::new();
    for part in ["tiles", "sets"] {
        let names: Vec<String> = out.list(part).expect("a list").into_iter().map(|(name, _)| name).collect();
        let contents = out.read_all(names.clone()).expect("files");
        found.extend(names.into_iter().zip(contents).map(|(name, bytes)| (name, bytes.expect("a file"))));
    }
    found.insert("tileset.json".to_owned(), out.read("tileset.json").expect("a store").expect("a file"));
    assert_equal(&found, &files(&world.expected()));
    assert!(0 < summary.failed_rows && !out.list("failures/rows").expect("a list").is_empty());
    // Finished work is known there, too.
    assert_eq!(world.run().await.expect("a city").units_made, 0);
}
