use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> split(x) { '0.5 : A. | '2 : B. | 1 : C. }
}

fn main() {}
