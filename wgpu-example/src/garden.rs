//! The rules of the garden, and the mesh of its trees.

use cga::mesh::FaceTag;
use cga::{Assets, Mesh, MeshBuilder, MeshError, Model, Settings, Shape, cga};

cga! {
    grammar Garden;
    /// The slope of the roof in degrees.
    @Range(min = 10, max = 60)
    attr slope = 32
    Lot     --> setback(9) { all : color("#8fa66b") Lawn | remainder : House }
    Lawn    --> [ Lawn. ] scatter(surface, 6, uniform) { Tree }
    Tree    --> s(3, rand(4, 7), 3) center(xz) i("tree") color("#4d7a48") Tree.
    House   --> [ extrude(0.4) color("#b9b0a2") Plinth. ] t(0, 0.4, 0) [ extrude(5.6) Walls ] t(0, 5.6, 0) Roof
    Walls   --> color("#e8dcc3") comp(f) { side : split(y) { ~1 : Storey | ~1 : Storey } }
    Storey  --> split(x) { ~1 : Wall. | { ~2.6 : split(y) { 0.7 : Wall. | ~1 : Window | 0.4 : Wall. } }* | ~1 : Wall. }
    Window  --> split(x) { ~1 : Wall. | 1.3 : Frame | ~1 : Wall. }
    Frame   --> [ color("#55707f") Glass. ] offset(-0.12) comp(f) { border : color("#fbf7ee") extrude(0.06) Frame. }
    Roof    --> roofHip(slope, 0.8) color("#9a5a44") Roof.
}

pub(crate) fn model() -> Result<Model, Box<dyn std::error::Error>> {
    let lot = Shape::rectangle(32.0, 28.0);
    let settings = Settings { assets: Assets::new().with("tree", tree()?).into(), ..Settings::default() };
    Ok(Garden::default().generate_with(&lot, &settings)?)
}

/// A pyramid with eight sides, one metre wide and high.
fn tree() -> Result<Mesh, MeshError> {
    let mut builder = MeshBuilder::new();
    let top = builder.point([0.5, 1.0, 0.5]);
    let (near, far) = (0.15, 0.85);
    let ring: [[f64; 2]; 8] =
        [[0.0, 0.5], [near, far], [0.5, 1.0], [far, far], [1.0, 0.5], [far, near], [0.5, 0.0], [near, near]];
    let ring = ring.map(|[x, z]| builder.point([x, 0.0, z]));
    for (k, &a) in ring.iter().enumerate() {
        builder.face(&[a, ring[(k + 1) % 8], top], &[], FaceTag::PLAIN);
    }
    builder.build()
}
