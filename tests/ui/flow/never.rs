#![deny(warnings)]

use cga::cga;

cga! {
    pub grammar House;
    @Range(min = 3, max = 60)
    attr height = 24
    attr width = 3
    const floor = 3

    @StartRule
    Lot --> case height < 2 : A. else : extrude(height) comp(f) { side : Facade(1, 2) | front : Door | all : A. }
    Facade(height, index) --> split(y) { ~1 : A. | ~height : B. }
    Door --> A. color("#ff0000")
    Roof --> 50% : Roof else : A.
    Chimney(size) --> extrude(size) A.
}

fn main() {}
