//! *resetGeometry operation* and the operations that change the mesh of a shape, on shapes like those of the pictures.

use cga::Shape;

use super::example::{Example, example};

/// In the order of the pages.
pub(crate) const ALL: &[Example] = &[reset_setbacks::EXAMPLE];

/// The lot of the picture of *resetGeometry operation*: an L with slightly slanted sides.
fn bent_lot() -> Shape {
    let outline = [[0.0, 45.0], [22.0, 49.0], [25.0, 39.0], [63.0, 44.0], [67.0, 4.0], [4.0, 0.0]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

example! {
    /// Floors that fit the gross floor area are opaque.
    reset_setbacks, "resetGeometry operation, Recursive setbacks", bent_lot(),
    r##"const maxGFA      = 5000
const floorHeight = 10

Example -->
    color("#FFAA00")
    SetBackRec(0, 0)

SetBackRec(sumGFA, iFloor) -->
    resetGeometry()
    setback(iFloor*3) {
        all : NIL |
        remainder : Floor(sumGFA + geometry.area, iFloor)
    }

Floor(sumGFA, iFloor) -->
    CreateFloor(sumGFA, iFloor)
    SetBackRec(sumGFA, iFloor + 1)

CreateFloor(sumGFA, iFloor) -->
    set(material.opacity,
        case sumGFA > maxGFA : 0.1 else : 1) 
    t(0, iFloor*floorHeight, 0)
    extrude(floorHeight)
"##
}
