use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> split(x) { ~1 : A. | { ~2 : B. * }
}

fn main() {}
