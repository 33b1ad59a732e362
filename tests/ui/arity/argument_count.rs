use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> s(1, 2) t(min(1), 0, 0) Wall(1, 2)
    Wall(n) --> A.
}

fn main() {}
