#![deny(warnings)]

use cga::cga;

cga! {
    pub grammar Tower;
    @Rnage(0, 1)
    attr height = 3
    Lot --> extrude(height) NIL color("#ff0000")
}

cga! {
    pub grammar House = "
        Lot --> extrude(3) Wal
        Wall --> X.";
}

cga! {
    @Deny(undefined_rule)
    pub grammar Strict = "Lot --> Wall";
}

fn main() {}
