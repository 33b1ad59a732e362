//! The tower as a picture that follows its rules: `cargo run --release --features live --example live`, then change a rule in
//! `examples/tower.rs` and save the file. Nothing is built again; a mistake is shown, and the last picture stays.

use std::error::Error;
use std::time::Instant;

use cga::{Grammar, Live};

#[allow(dead_code, reason = "it is a program of its own")]
#[path = "tower.rs"]
mod tower;

fn main() -> Result<(), Box<dyn Error>> {
    let lot = tower::lot()?;
    let mut live = Live::new(tower::Tower::default())?;
    loop {
        let begin = Instant::now();
        let model = live.generate(&lot)?;
        let took = begin.elapsed();
        model.write_png("live.png")?;
        println!("{} parts in {:.1} ms; live.png follows examples/tower.rs", model.len(), took.as_secs_f64() * 1e3);
        // A mistake is on standard error.
        while !live.wait() {}
    }
}
