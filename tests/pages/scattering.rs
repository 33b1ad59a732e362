//! *scatter operation*: points on a footprint, with boxes inserted.

use cga::Shape;

use super::example::{Example, example};

/// The three pictures of the page.
pub const ALL: &[Example] = &[uniform::EXAMPLE, gaussian::EXAMPLE, left::EXAMPLE];

/// The quadrilateral of the pictures, with corners as read from them. Its left edge is nearly along the left side of its scope.
fn initial() -> Shape {
    let outline = [[0.0, 0.0], [3.75, -1.25], [6.075, -8.775], [-3.525, -10.775]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

example! {
    /// "Uniform point distribution on a surface."
    uniform, "scatter operation, uniform", initial(),
    r##"Init-->
scatter(surface, 100, uniform) { Leaf }
Leaf-->
primitiveCube()
s(0.2,0.3,0.1)
color("#ff0000")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "Gaussian normal point distribution on a surface."
    gaussian, "scatter operation, gaussian", initial(),
    r##"Init-->
scatter(surface, 100, gaussian) { Leaf }
Leaf-->
primitiveCube()
s(0.2,0.3,0.1)
color("#ff0000")
"##; marks &[Mark::Initial, Mark::FromAbove]
}

example! {
    /// "The mean of the distribution is moved to the scope's left side and a smaller standard deviation is used."
    left, "scatter operation, gaussian, left", initial(),
    r##"Init-->
scatter(surface, 100, gaussian, left, '0.1) { Leaf }
Leaf-->
primitiveCube()
s(0.2,0.3,0.1)
color("#ff0000")
"##; marks &[Mark::Initial, Mark::FromAbove]
}
