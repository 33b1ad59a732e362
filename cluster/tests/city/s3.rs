//! Lots and tiles through an S3 interface. `.ci/cluster` starts a local server and names a bucket in `CGA_CLUSTER_S3`, as in `s3://cga`.

use std::collections::BTreeMap;

use cga_city::store::Store as _;
use cga_city::units::store::UnitStore as _;
use cga_cluster::store::Objects;

use crate::cluster::Cluster;
use crate::world::{CHOICES, World, assert_equal, files};

/// The files of a city in a store.
fn found(address: &str) -> BTreeMap<String, Vec<u8>> {
    let out = Objects::open(address).expect("a store");
    let names = ["tiles", "sets"].map(|part| out.list(part).expect("a list")).concat();
    let names: Vec<String> = names.into_iter().map(|(name, _)| name).chain(["tileset.json".to_owned()]).collect();
    let contents = out.read_all(names.clone()).expect("files").into_iter().map(|bytes| bytes.expect("a file"));
    names.into_iter().zip(contents).collect()
}

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
    let write_job = |out: &str| {
        let text = format!("store = \"{run}/{out}\"\nlots = [\"{run}/lots/\"]\nrules = [\"house.cga\"]\n{CHOICES}");
        std::fs::write(world.path("job.toml"), text).expect("room");
    };
    write_job("out");
    let summary = world.run().await.expect("a city");
    let expected = files(&world.expected());
    assert_equal(&found(&format!("{run}/out")), &expected);
    let out = Objects::open(&format!("{run}/out")).expect("a store");
    assert!(0 < summary.failed_rows && !out.list("failures/rows").expect("a list").is_empty());
    // Finished work is known there, too.
    assert_eq!(world.run().await.expect("a city").units_made, 0);

    write_job("cluster");
    let cluster = Cluster::new(&world);
    let (_scheduler, _executor) = (cluster.scheduler(), cluster.executor("one"));
    assert!(cluster.submit().ended_well(), "{}", cluster.logs());
    assert_equal(&found(&format!("{run}/cluster")), &expected);
}
