use cga::cga;

cga! {
    pub grammar NoSize;
    Facade --> split(x) { 1 : Pillar. | Window. | 1 : Pillar. }
}

cga! {
    pub grammar NoSizeText = "
        Facade --> split(x) { Wall. }";
}

cga! {
    pub grammar NoSlot;
    Facade --> split(x) { 1 : Pillar. | { }* | 1 : Pillar. }
}

cga! {
    pub grammar Floating;
    Lot --> s(~1, 12, ^1) Tower.
}

cga! {
    pub grammar RelativeText = "
        Lot --> r(0, '0.5, 0) extrude(12) Tower.";
}

cga! {
    pub grammar QuoteBehind = "
        Lot --> s('0.5', 12, '1) Tower.";
}

// Rust reads a character.
cga! {
    pub grammar QuotesAround;
    Lot --> s('1', 12, ^1) Tower.
}

fn main() {}
