//! *split operation*, Cutting Geometry: a cylinder model is inserted and cut.

use cga::Shape;

use super::example::{Example, example};

/// Both pictures of the page.
pub const ALL: &[Example] = &[cylinder::EXAMPLE, cylinder_cut::EXAMPLE];

/// Sides of the cylinder of the page's pictures.
pub const SIDES: u32 = 16;

/// On the page's pictures the cylinder lies on the ground, its middle above the x axis: the initial shape is 10 metres long
/// and has no height and no depth, so that the model keeps its proportions and its place about the axis.
fn initial() -> Shape {
    Shape::line([0.0, 0.0, 0.0], [10.0, 0.0, 0.0]).expect("a line")
}

example! {
    /// "A cylinder model is inserted into the current shape."
    cylinder, "split operation, Cutting Geometry, before", initial(),
    r#"A-->
i("cylinder.hor.obj")
t(0,'0.5,0)
"#
}

example! {
    /// "Splitting the shape and using NIL in the split rule results in holes. Note how the cut surfaces are closed."
    cylinder_cut, "split operation, Cutting Geometry", initial(),
    r#"A-->
i("cylinder.hor.obj")
t(0,'0.5,0)
split(x) { { ~0.75 : XX | ~1 : NIL } * | ~0.5 : XX }
"#
}
