use cga::{Shape, cga};

struct Unfit;

fn main() {
    let (height, unfit) = ("high", Unfit);
    let rules = cga! {
        Lot --> case #unfit : A. else : B
        B --> extrude(#height) color(#(3 + 4)) set(material.name, "x" + #unfit) B.
    };
    let _ = rules.generate(&Shape::rectangle(1.0, 1.0));
}
