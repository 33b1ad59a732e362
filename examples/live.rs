//! A picture that follows its rules: `cargo run --release --features live --example live`, then change a rule in `examples/live/tower.cga`
//! and save the file. Nothing is built again; a mistake is shown, and the last picture stays.

use std::error::Error;

use cga::{Grammar, Live, Shape, cga};

cga! {
    pub grammar Tower in "examples/live/tower.cga";
}

fn main() -> Result<(), Box<dyn Error>> {
    let lot = Shape::rectangle(20.0, 15.0);
    let mut tower = Live::new(Tower::default())?;
    loop {
        let model = tower.generate(&lot)?;
        model.write_png("live.png")?;
        println!("{} parts in live.png; change examples/live/tower.cga", model.len());
        // A mistake is on standard error.
        while !tower.wait() {}
    }
}
