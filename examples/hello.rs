//! Three floors on a lot, printed: `cargo run --example hello`

use cga::{Shape, cga};

cga! {
    /// A house of three floors.
    grammar Hello;

    Lot   --> extrude(9) split(y) { ~1 : Floor. | ~1 : Floor. | ~1 : Floor. }
}

fn main() -> Result<(), cga::Error> {
    let model = Hello::default().generate(&Shape::rectangle(12.0, 8.0))?;
    for leaf in model.leaves() {
        println!("{} of {} m at height {}", leaf.rule(), leaf.size(), leaf.scope().origin.y);
    }
    Ok(())
}
