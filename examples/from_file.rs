//! Rules in a separate file of plain CGA: `cargo run --example from_file` writes `house.png`.
//!
//! The rules are compiled with the program. A change of the file rebuilds it, and errors show the lines of the file.

use std::error::Error;

use cga::{Shape, cga};

cga! {
    /// The house of `rules/house.cga`.
    pub grammar House in "examples/rules/house.cga";
}

fn main() -> Result<(), Box<dyn Error>> {
    let house = House { floors: 4.0, ..House::default() };
    let model = house.generate(&Shape::rectangle(14.0, 9.0).seed(3))?;
    for fault in model.faults() {
        eprintln!("fault: {fault}");
    }
    for (rule, count) in model.counts() {
        println!("{count:>4} {rule}");
    }
    std::fs::create_dir_all("out")?;
    model.write_png("out/house.png")?;
    println!("wrote out/house.png");
    Ok(())
}
