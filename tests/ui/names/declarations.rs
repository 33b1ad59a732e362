use cga::cga;

cga! {
    pub grammar EmptyRange;
    @Range(min = 60, max = 3)
    attr height = 24
    Lot --> extrude(height) Tower.
}

cga! {
    pub grammar EmptyRangeText = "
        @Range(min = 60, max = 3)
        attr height = 24
        Lot --> extrude(height) Tower.";
}

cga! {
    pub grammar Default;
    @Deny(stray_default)
    @Enum("flat", "gable")
    attr roof = "gabel"
    Lot --> label(roof) Tower.
}

cga! {
    pub grammar Finding;
    @Allow(slot_never_maid)
    Lot --> split(x) { ^0.2 : Wall. | ~1 : Window. }
}

cga! {
    pub grammar NoStart;
    Tower(height) --> extrude(height) Wall.
}

cga! {
    pub grammar Style;
    Lot --> extrude(12) Wall
    Wall --> color("#c08060") Bricks.
    style Evening
    Wall --> color("#604030") Bricks.
    style Night extends Evning
    Wall --> color("#203040") Bricks.
}

cga! {
    pub grammar Constant;
    const height = 12
    Lot --> set(height, 2 * height) extrude(height) Tower.
}

cga! {
    pub grammar ConstantText = "
        const height = 12
        Lot --> set(height, 2 * height) extrude(height) Tower.";
}

cga! {
    pub grammar Word;
    Lot --> extrude(12) center(yx) Tower.
}

cga! {
    pub grammar WordText = "
        Lot --> extrude(12) alignScopeToAxes(up) Tower.";
}

cga! {
    pub grammar Helper;
    Roof --> roofHip(30) Tiles.
    Lot --> extrude(6) comp(f) { top : Roof | side : Wall. }
}

fn main() {}
