//! Rules that ask about other lots, for a city of any size: party walls without windows, and the rank of each house among all.
//!
//! `cargo run --release --features rayon --example neighbours -- 100000` runs 100,000 lots in streets of terraced houses, once with occlusion
//! queries of neighbours and once with queries of all labelled houses, and prints the rates and the memory.

use std::fs;
use std::time::Instant;

use cga::sink::stats::Stats;
use cga::{Grammar, Scene, Settings, Shape, cga};

cga! {
    /// Windows where no neighbour is.
    grammar Terrace;

    attr height = 6
    Lot    --> extrude(height) comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { { ~3 : Floor }* }
    Floor  --> split(x) { { ~3 : Tile }* }
    Tile   --> case touches(inter) : PartyWall. else : Window.
}

cga! {
    /// The tallest tenth has a garden on its roof.
    grammar Ranked;

    attr height = 6
    Lot   --> extrude(height) label("house") House
    House --> case contextCompare(all, "house", world.highest) < contextCount(all, "house") / 10 : Garden. else : Roof.
}

/// One house of a terrace, of two to six storeys. Forty share their side walls, and a street follows.
fn lot(at: usize) -> Shape {
    let (along, street) = (at % 40, at / 40);
    let storeys = 2 + (7 * at) % 5;
    let height = 3.0 * storeys as f64;
    Shape::rectangle(6.0, 10.0).at([6.0 * along as f64, 0.0, 22.0 * street as f64]).attribute("height", height)
}

/// The largest memory of the process so far, in megabytes; `None` where the system does not tell.
fn peak_memory() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok()? / 1024)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let lots: usize = std::env::args().nth(1).map_or(Ok(1000), |count| count.parse())?;
    let lots: Vec<Shape> = (0..lots).map(lot).collect();
    let grammars: [&(dyn Grammar + Sync); 2] = [&Terrace::default(), &Ranked::default()];
    println!("{} lots, {} MB", lots.len(), peak_memory().unwrap_or_default());
    for grammar in grammars {
        let begin = Instant::now();
        let batches = Scene::new(grammar, &lots).run(&Settings::default(), |_| Stats::new())?;
        let seconds = begin.elapsed().as_secs_f64();
        let (rate, memory) = (lots.len() as f64 / seconds, peak_memory().unwrap_or_default());
        println!("{}: {} leaves, {rate:.0} lots/s, {memory} MB", grammar.name(), batches.report().leaves);
    }
    Ok(())
}
