//! Attributes.

use cga::cga;

cga! {
    pub grammar House;

    /// The number of storeys.
    @Range(min = 1, max = 5)
    attr storeys = 2
    const height = 2.8

    Lot    --> extrude(storeys * height) comp(f) { side : Facade | top : Roof }
    Facade --> color("#e8dcc0") Wall.
    Roof   --> color("#9c4a36") Tiles.
}
