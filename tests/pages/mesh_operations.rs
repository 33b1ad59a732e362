//! *resetGeometry operation* and the operations that change the mesh of a shape, on shapes as in the pictures.

use cga::mesh::FaceTag;
use cga::{MeshBuilder, Shape};

use super::example::{Example, example};
use super::setback;

/// In the order of the pages.
pub const ALL: &[Example] =
    &[convexify::EXAMPLE, reset_setbacks::EXAMPLE, rectify::EXAMPLE, terrain::EXAMPLE, terrain_reduced::EXAMPLE];

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

/// The lot of the picture of *rectify operation*, as read from it.
fn slanted_lot() -> Shape {
    let outline = [
        [7.0, 8.1],
        [2.9, 8.5],
        [2.4, 16.3],
        [10.5, 15.9],
        [11.0, 20.4],
        [19.3, 20.7],
        [19.7, 12.8],
        [23.5, 12.4],
        [24.0, 3.4],
        [7.0, 4.1],
    ];
    let mut builder = MeshBuilder::new();
    let points = outline.map(|[x, z]| builder.point([x, 0.0, z]));
    builder.polygon(&points);
    Shape::mesh_axis_aligned(builder.build().expect("a lot"))
}

/// Hills of squares; the picture of *reduceGeometry operation* has four times as many.
fn hills() -> Shape {
    const COUNT: u32 = 64;
    let mut builder = MeshBuilder::new();
    // Triangle waves of several lengths.
    let wave = |x: f64, length: f64| 2.0 * (2.0 * (x / length - (x / length + 0.5).floor())).abs() - 1.0;
    let height = |x: f64, z: f64| 9.0 * wave(x + 0.3 * z, 57.0) * wave(z, 43.0) + wave(x - z, 23.0);
    let places = (0..COUNT).flat_map(|x| (0..COUNT).map(move |z| [f64::from(x), f64::from(z)]));
    let points: Vec<u32> = places.map(|[x, z]| builder.point([x, height(x, z), -z])).collect();
    let at = |x: u32, z: u32| points[(x * COUNT + z) as usize];
    for (x, z) in (0..COUNT - 1).flat_map(|x| (0..COUNT - 1).map(move |z| (x, z))) {
        builder.face(&[at(x, z), at(x + 1, z), at(x + 1, z + 1), at(x, z + 1)], &[], FaceTag::PLAIN);
    }
    Shape::mesh_axis_aligned(builder.build().expect("hills"))
}

example! {
    /// The initial and the rectified shape.
    rectify, "rectify operation, Examples", slanted_lot(),
    r##"@Range(min=0,max=45)
attr angle = 15
@StartRule
Lot -->
	ShowOrig
	ShowRect
ShowOrig -->
	color(1, 0, 0)
ShowRect -->
	t(0, 0, '-1.1)
	rectify(angle)
	color(0, 1, 0)
"##; marks &[Mark::FromAbove]
}

example! {
    /// "Left: the original."
    terrain, "reduceGeometry operation, the original", hills(),
    r##"Terrain --> Terrain.
"##
}

example! {
    /// "Right: after reduceGeometry(0.8)."
    terrain_reduced, "reduceGeometry operation, reduced", hills(),
    r##"Terrain --> reduceGeometry(0.8) Terrain.
"##
}
