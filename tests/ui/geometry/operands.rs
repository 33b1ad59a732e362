#![deny(warnings)]

use cga::cga;

cga! {
    pub grammar House;
    @StartRule
    Lot  --> extrude(6) subtract { A. | Door } Wall.
    Door --> t(0, 0, ^0.5) NIL
}

fn main() {}
