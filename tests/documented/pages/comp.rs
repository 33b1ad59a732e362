//! *comp operation*, Examples: a ball of 16 × 16 faces and a building with wings.

use cga::Shape;

use super::example::{Example, example};
use super::meshes;

/// The pictures of the page that need no trim planes.
pub(crate) const ALL: &[Example] =
    &[quadrants::EXAMPLE, angles::EXAMPLE, operator_each::EXAMPLE, operator_together::EXAMPLE];

fn ball() -> Shape {
    Shape::mesh_axis_aligned(meshes::sphere(16, 16, 5.0))
}

/// A comb with six teeth to the front: with its sides it has six front faces.
pub(crate) fn comb() -> Shape {
    let tooth = |at: u32| {
        let x = 4.0 * f64::from(at);
        [[x, 10.0], [x + 2.0, 10.0], [x + 2.0, 6.0], [x + 4.0, 6.0]]
    };
    let mut outline: Vec<[f64; 2]> = (0..3).flat_map(tooth).collect();
    outline.extend([[12.0, 0.0], [0.0, 0.0]]);
    Shape::footprint(&outline, &[]).expect("an outline")
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
"##
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
"##
}

example! {
    /// "Using the : operator results in a new shape for each component selected by the selector."
    operator_each, "comp operation, Separating operator :", comb(),
    r##"Lot -->
   extrude(10)
   comp(f) { front :  color(rand,rand,rand)
                      Front.
           | all   =  Mass. }
"##
}

example! {
    /// "Using the = operator results in exactly one new shape for all components selected by the selector."
    operator_together, "comp operation, Combining operator =", comb(),
    r##"Lot -->
   extrude(10)
   comp(f) { front =  color(rand,rand,rand)
                      Front.
           | all   =  Mass. }
"##
}
