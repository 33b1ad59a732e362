use cga::{Array, cga};

fn slice(_: &[f64]) -> f64 {
    0.0
}

fn names(_: &Array<f64>) -> Vec<&'static str> {
    vec!["a"]
}

fn main() {
    let height = 3.0;
    let _rules = cga! {
        Lot --> extrude(crate::slice([1, 2])) s(sum(crate::names([1, 2]) .* 2), sum(.-#height), 1) A.
    };
}
