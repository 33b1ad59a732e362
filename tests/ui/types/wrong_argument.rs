use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> extrude("high") color(3) A.
}

fn main() {}
