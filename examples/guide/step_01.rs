//! A block.

use cga::cga;

cga! {
    pub grammar House;

    Lot --> extrude(6) House.
}
