use cga::cga;

cga! {
    pub grammar Values;
    Lot --> color("red") t(1 / 0, 0, 0) A.
    @Allow(not_implemented)
    Wall --> projectUV(10) A.
}

fn main() {}
