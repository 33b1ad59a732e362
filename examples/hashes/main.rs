//! Hashes of many outputs, one on each line: equal on every platform and in every build.
//!
//! `cargo run --release --example hashes` prints them. `.ci/wasm` compares them with the hashes of the same program on
//! wasm.

use std::error::Error;

use cga::parallel::run_all;
use cga::sink::buffers::{Buffers, Chunks};
use cga::sink::gltf::Glb;
use cga::{Flow, Grammar, Repeats, Settings, Shape, Sink};
use hash::{Hash, buffers};

#[allow(dead_code, reason = "the grammar alone is used")]
#[path = "../district.rs"]
mod district;
mod hash;
#[allow(dead_code, reason = "the grammar alone is used")]
#[path = "../tower.rs"]
mod tower;
#[path = "../../benches/workloads/mod.rs"]
mod workloads;

/// Larger workloads exceed 4 GB or take long.
const TERMINALS: usize = 200_000;

fn main() -> Result<(), Box<dyn Error>> {
    for mut scene in workloads::all() {
        if scene.expected().terminals <= TERMINALS {
            workloads::check(&mut *scene);
            let (mut flat, mut file) = (Buffers::new(), Glb::new());
            scene.buffers(&mut flat);
            scene.glb(&mut file);
            println!("{}: buffers {:016x}, GLB {:016x}", scene.name(), buffers(&flat), Hash::of(&file.into_bytes()?));
        }
    }
    grammar("Tower", &tower::Tower::default())?;
    grammar("House", &district::House::default())
}

/// Runs a grammar on some lots, in every way.
fn grammar(name: &str, grammar: &(dyn Grammar + Sync)) -> Result<(), Box<dyn Error>> {
    // Corners with irrational sines and cosines, and a courtyard.
    let outline = |lot: usize| {
        let corner = move |at: usize| {
            let angle = at as f64 / (5 + lot) as f64 * std::f64::consts::TAU;
            [18.0 * libm::cos(angle), 15.0 * libm::sin(angle)]
        };
        (0..5 + lot).map(corner).rev().collect::<Vec<_>>()
    };
    let hole = [[3.0, 2.0], [3.0, -2.5], [-2.5, -2.0]];
    let lot = |lot: usize| {
        let holes = if lot == 2 { vec![hole.to_vec()] } else { Vec::new() };
        let shape = Shape::footprint(&outline(lot), &holes)?.at([117.3 * lot as f64, 0.313, -1013.7]);
        Ok(shape.seed(7 + lot as u64))
    };
    let lots = (0..4).map(lot).collect::<Result<Vec<Shape>, cga::Error>>()?;
    let run = |repeats, sink: &mut dyn Sink| -> Result<(), cga::Error> {
        let settings = Settings { repeats, ..Settings::default() };
        lots.iter().try_for_each(|lot| grammar.run(lot, &settings, sink).map(drop))
    };
    for (way, repeats) in [("kept", Repeats::Kept), ("made again", Repeats::Again)] {
        let (mut flat, mut file) = (Buffers::new(), Glb::new());
        run(repeats, &mut flat)?;
        run(repeats, &mut file)?;
        println!(
            "{name}, templates {way}: buffers {:016x}, GLB {:016x}",
            buffers(&flat),
            Hash::of(&file.into_bytes()?)
        );
    }
    let parts = run_all(grammar, &lots, &Settings::default(), |_| Buffers::new())?;
    let hashes: Vec<String> = parts.sinks().map(|part| format!("{:016x}", buffers(part))).collect();
    println!("{name}, many at once: {}", hashes.join(" "));
    let mut hashes = Vec::new();
    let mut chunks = Chunks::new(1000, |chunk: &Buffers| {
        hashes.extend_from_slice(&buffers(chunk).to_le_bytes());
        Flow::Continue(())
    });
    run(Repeats::Kept, &mut chunks)?;
    let _ = chunks.finish();
    drop(chunks);
    println!("{name}, in {} chunks: {:016x}", hashes.len() / 8, Hash::of(&hashes));
    Ok(())
}
