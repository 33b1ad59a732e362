//! A program that panics in a Rust function that its rules call. The argument is the source of the rules: `inline`, `string` or `file`.
//!
//! `tests/lines.rs` finds lines by their ends.

use cga::{Shape, cga};

cga! {
    grammar Inline;

    twice(shape) =
        shape * 2 // in a function

    Lot -->
        extrude(9) // the first step of Lot
        Tower(3) // a successor of Lot

    Tower(cx) -->
        split(y) { // the split of Tower
            cx : // the size of a slot
                Floor(cx, twice(cx)) // a successor in a slot
            | ~1 : NIL
        }

    Floor(height, W) with ( gap := height / 3 ) --> // the rule Floor
        t(0, gap, 0) // the first step of Floor
        [ // brackets
            s(1, gap, W) // a step in brackets
            Brick. // a leaf in brackets
        ]
        [ case gap < 2 : // a condition
            crate::stop(height, W) // a call of Rust
            Stopped.
        else :
            NIL ]
}

cga! {
    // The literal has a line of its own.
    grammar InString =
        r#"
    StringLot --> extrude(9) StringTower(3)
    StringTower(h) --> split(y) { h : StringFloor(h) | ~1 : NIL }
    StringFloor(h) --> crate::stop(h, h)
"#;
}

cga! {
    grammar InFile
        in "rules/tower.cga";
}

/// An operation that ends the program.
fn stop(_: &mut Shape, height: f64, width: f64) {
    panic!("{height} by {width}");
}

fn main() {
    let lot = Shape::rectangle(20.0, 12.0);
    let result = match std::env::args().nth(1).as_deref() {
        Some("inline") => Inline::default().generate(&lot),
        Some("string") => InString::default().generate(&lot),
        Some("file") => InFile::default().generate(&lot),
        _ => return println!("inline, string or file"),
    };
    println!("{result:?}");
}
