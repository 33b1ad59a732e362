use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> split(q) { ~1 : Wall. }
    Wall --> comp(f) { sides : Wall. | top : NIL }
}

fn main() {}
