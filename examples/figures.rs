//! The pictures of the notes on the two algorithms, `docs/cutting.png` and `docs/offset.png`, and of `cga-geometry`, drawn from results
//! of the library.
//!
//! `cargo run --release --example figures`

#[path = "figures/cutting.rs"]
mod cutting;
#[path = "figures/offset.rs"]
mod offset;
#[path = "figures/parts.rs"]
mod parts;
#[path = "figures/pen.rs"]
mod pen;
#[path = "figures/sheet.rs"]
mod sheet;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for (path, cells) in [("docs/cutting.png", cutting::cells()?), ("docs/offset.png", offset::cells()?)] {
        sheet::draw(&cells, 2).write_indexed_png(path)?;
        println!("wrote {path}");
    }
    parts::draw("cga-geometry/puzzle.png")?;
    println!("wrote cga-geometry/puzzle.png");
    Ok(())
}
