//! *comp operation*, Examples: selectors on a ball of 16 × 16 faces, and the operators on a building with bays.

use cga::Shape;

use super::example::{Example, example};
use super::meshes;

/// In the order of the page.
pub const ALL: &[Example] = &[
    quadrants::EXAMPLE,
    angles::EXAMPLE,
    operator_each::EXAMPLE,
    operator_together::EXAMPLE,
    operator_connected::EXAMPLE,
];

fn ball() -> Shape {
    Shape::mesh_axis_aligned(meshes::sphere(16, 16, 5.0))
}

/// A building with six front faces: two bays that stand back and four that stand out.
pub fn bays() -> Shape {
    let back = [[0.0, 15.0], [5.0, 14.4], [10.0, 14.4]];
    let out = [[10.0, 20.0], [15.0, 21.2], [20.0, 21.2], [25.0, 20.0], [30.0, 17.4]];
    let outline = [&back[..], &out, &[[30.0, 0.0], [0.0, 0.0]]].concat();
    Shape::footprint(&outline, &[]).expect("an outline").seed(5)
}

example! {
    /// "Selectors are demonstrated by using them to color the faces of a spherical geometry."
    quadrants, "comp operation, Selectors 1: Quadrant-based", ball(),
    r##"Sphere -->
   comp(f) {
      top:    color("#0000ff") X |
      bottom: color("#ffff00") X |
      front:  color("#ff0000") X |
      back:   color("#ff00ff") X |
      left:   color("#00ffff") X |
      right:  color("#00ff00") X
   }
"##; marks &[Mark::InitialBox, Mark::InitialScope]
}

example! {
    /// "Note the horizontal areas (blue) on the sphere's poles."
    angles, "comp operation, Selectors 2: Angle to y-axis based", ball(),
    r##"Sphere -->
   comp(f) {
      horizontal: color("#0000ff") X |
      aslant:     color("#ff0000") X |
      vertical:   color("#ffff00") X |
      nutant:     color("#ff00ff") X
   }
"##; marks &[Mark::InitialBox, Mark::InitialScope]
}

example! {
    /// "Using the : operator results in a new shape for each component selected by the selector."
    operator_each, "comp operation, Separating operator :", bays(),
    r##"Lot -->
   extrude(10)
   comp(f) { front :  color(rand,rand,rand)
                      Front.
           | all   =  Mass. }
"##; marks &[Mark::Pivots("Front")]
}

example! {
    /// "Using the = operator results in exactly one new shape for all components selected by the selector."
    operator_together, "comp operation, Combining operator =", bays(),
    r##"Lot -->
   extrude(10)
   comp(f) { front =  color(rand,rand,rand)
                      Front.
           | all   =  Mass. }
"##; marks &[Mark::Boxes("Front"), Mark::Pivots("Front")]
}

example! {
    /// "Two Front shapes are created for all six front faces of the extruded geometry."
    operator_connected, "comp operation, Connecting operator =:", bays(),
    r##"Lot -->
   extrude(10)
   comp(f) { front =: color(rand,rand,rand)
                      Front.
           | all   =  Mass. }
"##; marks &[Mark::Boxes("Front"), Mark::Pivots("Front")]
}
