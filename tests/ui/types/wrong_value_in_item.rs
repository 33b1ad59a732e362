use cga::cga;

static NAME: &str = "x";

cga! {
    pub grammar Tower;
    Lot --> extrude(#NAME) A.
}

fn main() {}
