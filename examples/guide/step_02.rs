//! Faces.

use cga::cga;

cga! {
    pub grammar House;

    Lot    --> extrude(6) comp(f) { side : Facade | top : Roof }
    Facade --> color("#e8dcc0") Wall.
    Roof   --> color("#9c4a36") Tiles.
}
