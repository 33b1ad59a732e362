//! *setNormals* and *softenNormals operations*. The pages show pictures without rules.

use cga::{MeshBuilder, Shape};

use super::example::{Example, example};

/// In the order of the pages.
pub const ALL: &[Example] = &[
    sphere_hard::EXAMPLE,
    sphere_soft::EXAMPLE,
    inconsistent::EXAMPLE,
    consistent::EXAMPLE,
    hemisphere_0::EXAMPLE,
    hemisphere_30::EXAMPLE,
    hemisphere_180::EXAMPLE,
];

fn cube() -> Shape {
    Shape::cuboid(4.0, 4.0, 4.0)
}

/// The corners of a house with a gable roof: its place, width, depth, and the heights of eaves and ridge.
type House = [f64; 6];

/// Houses, of which every third face is turned.
fn houses() -> Shape {
    let mut builder = MeshBuilder::new();
    let mut number = 0;
    let houses: [House; 3] =
        [[0.0, 0.0, 12.0, 9.0, 5.0, 9.0], [12.5, 1.0, 6.0, 6.0, 4.0, 6.0], [3.0, 11.0, 5.0, 8.0, 3.0, 7.0]];
    for [x, z, width, depth, eaves, ridge] in houses {
        let mut at =
            |right: f64, height: f64, front: f64| builder.point([x + right * width, height, z + front * depth]);
        let [a, b, c, d] = [at(0.0, 0.0, 1.0), at(1.0, 0.0, 1.0), at(1.0, 0.0, 0.0), at(0.0, 0.0, 0.0)];
        let [e, f, g, h] = [at(0.0, eaves, 1.0), at(1.0, eaves, 1.0), at(1.0, eaves, 0.0), at(0.0, eaves, 0.0)];
        let [i, j] = [at(0.0, ridge, 0.5), at(1.0, ridge, 0.5)];
        let faces: [&[u32]; 7] = [
            &[d, c, b, a],
            &[a, b, f, e],
            &[b, c, g, j, f],
            &[c, d, h, g],
            &[d, a, e, i, h],
            &[e, f, j, i],
            &[g, h, i, j],
        ];
        for face in faces {
            let mut ring = face.to_vec();
            if number % 3 == 1 {
                ring.reverse();
            }
            number += 1;
            builder.polygon(&ring);
        }
    }
    Shape::mesh_axis_aligned(builder.build().expect("houses"))
}

example! {
    /// "Shaded sphere with hard normals."
    sphere_hard, "setNormals operation, hard", cube(),
    r##"Ball --> primitiveSphere(24, 12) setNormals(hard) Ball.
"##
}

example! {
    /// "Shaded sphere with soft normals."
    sphere_soft, "setNormals operation, soft", cube(),
    r##"Ball --> primitiveSphere(24, 12) setNormals(soft) Ball.
"##
}

example! {
    /// "Building with inconsistent face normals." The picture shows backs in black, as the page's does.
    inconsistent, "setNormals operation, inconsistent faces (backs in black)", houses(),
    r##"Building --> color("#aaaaaa") comp(f) { world.down : Down. | all : Part. }
"##; marks &[Mark::Backs]
}

example! {
    /// "Building with consistent face normals."
    consistent, "setNormals operation, conform (backs in black)", houses(),
    r##"Building --> setNormals(conform) color("#aaaaaa") comp(f) { world.down : Down. | all : Part. }
"##; marks &[Mark::Backs]
}

example! {
    /// "Shaded hemisphere with angle 0 (hard normals)."
    hemisphere_0, "softenNormals operation, angle 0", cube(),
    r##"Ball --> primitiveSphere(40, 20) split(z) { ~1 : softenNormals(0) Half. | ~1 : NIL }
"##; marks &[Mark::From(147.0, 30.0)]
}

example! {
    /// "Shaded hemisphere with angle 30 (auto normals)."
    hemisphere_30, "softenNormals operation, angle 30", cube(),
    r##"Ball --> primitiveSphere(40, 20) split(z) { ~1 : softenNormals(30) Half. | ~1 : NIL }
"##; marks &[Mark::From(147.0, 30.0)]
}

example! {
    /// "Shaded hemisphere with angle 180 (soft normals)."
    hemisphere_180, "softenNormals operation, angle 180", cube(),
    r##"Ball --> primitiveSphere(40, 20) split(z) { ~1 : softenNormals(180) Half. | ~1 : NIL }
"##; marks &[Mark::From(147.0, 30.0)]
}
