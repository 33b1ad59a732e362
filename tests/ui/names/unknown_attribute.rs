use cga::cga;

const HEIGHT: f64 = 3.0;

cga! {
    pub grammar Tower;
    attr height = 3
    Lot --> extrude(heigth) split(y) { HEIGHT : Floor. }
}

fn main() {
    let _ = Tower { height: HEIGHT };
}
