use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> Wall(1)
    Wall(n) --> extrude(n) A.
    Lot(n) --> A.
    Wall(height) --> B.
}

fn main() {}
