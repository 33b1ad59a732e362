use cga::cga;

// Nothing is said.
cga! {
    @Allow(slot_never_made)
    pub grammar Quiet;
    Lot --> split(x) { ^1 : A. | ^0.1 : B. } Wall
    @Allow(endless_rules, size_not_positive)
    Wall --> split(x) { 0 : A. | ~1 : B. } Wall
}

cga! {
    @Allow(slot_never_made)
    pub grammar QuietText = "Lot --> split(x) { '1 : A. | '0.1 : B. } Wall
        @Allow(endless_rules, size_not_positive) Wall --> split(x) { 0 : A. | ~1 : B. } Wall";
}

cga! {
    @Allow(slot_never_made)
    pub grammar QuietFile in "ui/door/lints.cga";
}

// Each is an error.
cga! {
    @Deny(slot_never_made)
    pub grammar Loud;
    Lot --> split(x) { ^1 : A. | ^0.1 : B. } Wall
    @Deny(size_not_positive)
    Wall --> split(x) { 0 : A. | ~1 : B. }
}

cga! {
    pub grammar LoudText = "
        Lot --> split(x) { '1 : A. | ~1 : B. } Wall
        @Deny(size_not_positive) Wall --> split(x) { 0 : A. | ~1 : B. }";
}

cga! {
    @Deny(slot_never_made)
    pub grammar LoudFile in "ui/door/lints.cga";
}

// A warning only, and the last one counts.
cga! {
    @Allow(endless_rules)
    pub grammar Softer;
    @Warn(endless_rules)
    Lot --> A. Lot
}

fn main() {}
