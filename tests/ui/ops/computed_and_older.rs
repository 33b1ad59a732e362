#![deny(warnings)]

use cga::cga;

cga! {
    pub grammar Computed;
    Lot --> extrude(12) center(sel("x" + "y")) Tower.
}

cga! {
    pub grammar ComputedText = r#"
        Lot --> extrude(12) center(sel("x" + "y")) Tower."#;
}

cga! {
    pub grammar Older;
    Lot --> extrude(world.y, 12) Tower.
}

cga! {
    pub grammar OlderText = "
        Lot --> extrude(world.y, 12) Tower.";
}

fn main() {}
