//! Rules that are compiled into the program make the tiles of the same rules that are loaded.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use cga::{Grammar as _, cga};
use cga_city::units::compiled;

use crate::cluster::Cluster;
use crate::neighbours::border_world;
use crate::world::{World, assert_equal, files};

cga! { grammar House in "examples/House.cga"; }

const TEXT: &str = include_str!("../../examples/House.cga");
const CHOICES: &str = "lod = [\"Block\"]\ntile_lots = 5\nunit_lots = 1\nset = { slope = 50 }\n";

fn job(world: &World, store: &str, rules: &str) {
    let text = format!("store = \"{store}\"\nlots = [\"lots\"]\n{rules}\n{CHOICES}");
    fs::write(world.path("job.toml"), text).expect("room");
}

/// The files of a city without the descriptions of tiles, which have the digest of the rules.
fn tiles(city: &Path) -> BTreeMap<String, Vec<u8>> {
    let is_content = |name: &String| name.ends_with(".glb") || !name.starts_with("tiles/");
    files(city).into_iter().filter(|(name, _)| is_content(name)).collect()
}

/// The program of the example, which `cargo test` builds.
fn program() -> PathBuf {
    let folder = Path::new(env!("CARGO_BIN_EXE_cga-cluster")).parent().expect("a folder");
    let program = folder.join("examples/compiled");
    assert!(
        program.exists(),
        "the example is missing; `cargo test` without `--test` builds it, or `cargo build --examples`"
    );
    program
}

#[tokio::test(flavor = "multi_thread")]
async fn compiled_rules_make_the_tiles_of_loaded_ones() {
    let world = border_world(TEXT).await;
    fs::rename(world.path("house.cga"), world.path("House.cga")).expect("a file");
    job(&world, "loaded", "rules = [\"House.cga\"]");
    world.run().await.expect("a city");
    let loaded = tiles(&world.path("loaded"));
    assert!(10 < loaded.len());

    job(&world, "compiled", "compiled = [\"House\"]");
    let error = world.run().await.expect_err("unknown");
    assert!(error.contains("this program has no compiled grammars, so `House` is unknown"), "{error}");
    compiled::add(House::default().boxed()).expect("a name");
    assert!(compiled::add(House::default().boxed()).expect_err("twice").contains("two compiled grammars"));
    world.run().await.expect("a city");
    assert_equal(&tiles(&world.path("compiled")), &loaded);
    assert_eq!(world.run().await.expect("a city").units_made, 0);
    job(&world, "compiled", "compiled = [\"Hose\"]");
    let error = world.run().await.expect_err("unknown");
    assert!(error.contains("did you mean `House`?"), "{error}");

    job(&world, "cluster", "compiled = [\"House\"]");
    let cluster = Cluster::of(&world, program());
    let (_scheduler, _one, _two) = (cluster.scheduler(), cluster.executor("one"), cluster.executor("two"));
    assert!(cluster.submit().ended_well(), "{}", cluster.logs());
    assert_equal(&tiles(&world.path("cluster")), &loaded);
}
