use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> split(x) { '(1 / 3) : A. | ~1 : B. }
}

fn main() {}
