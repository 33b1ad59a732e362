use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> extrud(3) Wall.
}

fn main() {}
