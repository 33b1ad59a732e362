#![deny(warnings)]

use cga::cga;

cga! {
    pub grammar Park;
    @StartRule
    Lot --> scatter(surface, 9, uniform) { Tree }
    Tree --> s(1, 4, 1) comp(f) { side : Bark. }
}

fn main() {}
