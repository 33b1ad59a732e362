//! A city of any size, streamed in parallel and in constant memory: each chunk of triangles is measured, or written
//! to a file, and dropped.
//!
//! `cargo run --release --features rayon --example metropolis -- 100000` derives 100,000 buildings with 59 million
//! parts. With a folder as second argument, it writes a GLB file for each chunk.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::time::Instant;

use cga::sink::buffers::{Buffers, Chunks};
use cga::{Settings, Shape, Watch, cga};

cga! {
    /// Walls and windows on every side, in one of three colours.
    pub grammar City;

    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> 60% : color("#d8c8a8") Front 30% : color("#b08060") Front else : color("#90a0a8") Front
    Front  --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window. | ~0.8 : Wall. }
}

/// The vertices of a chunk: about 2 MB with its indices.
const CHUNK: usize = 1 << 16;

/// The number of lots in memory at a time. The list of initial shapes need not be in memory as a whole.
const BATCH: usize = 8192;

/// One building of 2 to 10 storeys, 40 in a row.
pub(crate) fn lot(at: usize) -> Shape {
    let storeys = 2 + (7 * at) % 9;
    Shape::cuboid(13.5, 4.0 + 3.0 * storeys as f64, 11.0)
        .at([20.0 * (at % 40) as f64, 0.0, 20.0 * (at / 40) as f64])
        .seed(at as u64)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let lots: usize = arguments.next().map_or(Ok(1000), |count| count.parse())?;
    let folder = arguments.next().map(PathBuf::from);
    let (grammar, begin) = (City::default(), Instant::now());
    let watch = Watch::every(20_000_000, |progress| {
        eprintln!("{} buildings, {} parts", progress.initial_shapes, progress.leaves);
        ControlFlow::Continue(())
    });
    let settings = Settings { watch: Some(watch.clone()), ..Settings::default() };
    let (triangles, chunks, largest) = (AtomicU64::new(0), AtomicU64::new(0), AtomicUsize::new(0));
    for first in (0..lots).step_by(BATCH) {
        let shapes: Vec<Shape> = (first..lots.min(first + BATCH)).map(lot).collect();
        let parts = grammar.run_all(&shapes, &settings, |stretch| {
            let (triangles, chunks, largest, folder) = (&triangles, &chunks, &largest, &folder);
            let (from, mut number) = (first + stretch.shapes.start, 0);
            Chunks::new(CHUNK, move |chunk: &Buffers| {
                number += 1;
                chunks.fetch_add(1, Ordering::Relaxed);
                triangles.fetch_add(chunk.triangle_count() as u64, Ordering::Relaxed);
                largest.fetch_max(chunk.memory(), Ordering::Relaxed);
                let Some(folder) = folder else { return Ok(()) };
                chunk.write_glb(folder.join(format!("from-{from:07}-{number:03}.glb")))
            })
        })?;
        // The first error of a chunk ended the runs.
        parts.into_iter().try_for_each(|part| part.sink.into_result())?;
    }
    let (progress, seconds) = (watch.progress(), begin.elapsed().as_secs_f64());
    println!("{} buildings, {} parts, {} triangles", progress.initial_shapes, progress.leaves, triangles.into_inner());
    println!("{:.1} million parts a second", progress.leaves as f64 / seconds / 1e6);
    println!("{} chunks, the largest {:.1} MB", chunks.into_inner(), largest.into_inner() as f64 / 1e6);
    if let Some(peak) = peak_memory() {
        println!("peak memory of the process {peak}");
    }
    Ok(())
}

/// The peak memory of the process, if the system reports it.
fn peak_memory() -> Option<String> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    Some(status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?.trim().to_owned())
}
