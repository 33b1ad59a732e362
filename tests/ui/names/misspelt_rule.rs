use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> extrude(3) Facde
    Facade --> split(x) { ~1 : Wall. }
}

fn main() {}
