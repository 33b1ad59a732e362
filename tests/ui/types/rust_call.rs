use cga::{Shape, cga};

fn noise(_: i32) -> f64 {
    0.0
}

fn nothing() {}

fn arch(_: &mut Shape, _: f64) -> bool {
    true
}

cga! {
    pub grammar Tower;
    Lot --> extrude(crate::noise(scope.sx)) t(crate::nothing(), self::missing(1), 0) crate::arch(2.0) A.
}

fn main() {}
