use cga::cga;

cga! {
    pub grammar Tower;
    Lot -> A.
    Wall --> split(x) { ~1 A. }
    Good --> A.
}

fn main() {}
