//! The levels around a grammar hold for its warnings: only the last two are shown.

#[allow(deprecated)]
mod silent {
    cga::cga! { pub grammar Tower; Lot --> NIL color("#ff0000") }
}

#[allow(deprecated)]
fn quiet() {
    let _rules = cga::cga! { Lot --> NIL color("#ff0000") };
}

fn loud() {
    let _rules = cga::cga! { Lot --> NIL color("#ff0000") };
}

#[deny(deprecated)]
mod denied {
    cga::cga! { pub grammar Tower; Lot --> NIL color("#ff0000") }
}

fn main() {
    quiet();
    loud();
}
