//! *resetGeometry operation* and the operations that change the mesh of a shape, on shapes like those of the pictures.

use cga::Shape;

use super::example::{Example, example};
use super::setback;

/// In the order of the pages.
pub(crate) const ALL: &[Example] = &[convexify::EXAMPLE, reset_setbacks::EXAMPLE];

/// The lots of the picture of *convexify operation*, as read from it. A metre is 28 of its pixels.
fn concave_lots() -> Shape {
    setback::faces(&[
        &[[1.84, 7.55], [4.36, 8.09], [6.04, 7.57], [2.00, 10.21]],
        &[[3.93, 5.14], [8.34, 5.70], [8.02, 6.68], [4.75, 6.37], [4.86, 7.43], [4.44, 7.43]],
        &[
            [2.54, 0.54],
            [4.36, 0.86],
            [3.11, 7.25],
            [2.36, 7.11],
            [3.07, 3.57],
            [2.71, 3.46],
            [2.00, 7.07],
            [1.18, 6.93],
        ],
        &[
            [5.05, 2.44],
            [5.04, 0.96],
            [9.83, 1.18],
            [8.85, 4.77],
            [7.70, 4.71],
            [8.02, 3.05],
            [7.43, 3.02],
            [6.95, 4.75],
            [6.35, 4.73],
            [6.64, 3.60],
            [6.24, 3.57],
            [6.13, 3.81],
            [5.21, 4.33],
            [5.20, 4.07],
            [4.51, 4.04],
        ],
    ])
}

/// The lot of the picture of *resetGeometry operation*: an L with slightly slanted sides.
fn bent_lot() -> Shape {
    let outline = [[0.0, 45.0], [22.0, 49.0], [25.0, 39.0], [63.0, 44.0], [67.0, 4.0], [4.0, 0.0]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

example! {
    /// The four lots of the picture.
    convexify, "convexify operation, Examples", concave_lots(),
    r##"attr maxLength = 1
Lot -->
	convexify(maxLength)
	comp(f){all: SubShapes}
SubShapes -->
	case scope.sx >= maxLength && scope.sy >= maxLength :
		color("#00ff00")
	else:
		color("#ff0000")
"##; marks &[Mark::FromAbove]
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
