//! The rules of streets, gardens and trees. Buildings have the rules of the example `district`.

use cga::{Assets, Mesh, MeshBuilder, MeshError, Settings, cga};

cga! {
    pub grammar Ground;

    /// The trees on 1,000 square metres.
    @Range(min = 0, max = 40)
    attr density = 14

    @StartRule
    Meadow   --> color("#6f8553") Meadow.
    @StartRule
    Asphalt  --> color("#5b5d61") Asphalt.
    // The asphalt has the surface of all streets; houses look for the label.
    @StartRule
    Street   --> label("street") NIL
    @StartRule
    Sidewalk --> extrude(0.15) color("#b7b1a5") Sidewalk.
    @StartRule
    Garden   --> [ color("#68844a") Lawn. ] scatter(surface, density * geometry.area / 1000, uniform) { Tree(rand(4.5, 9)) }
    Tree(h)  --> [ s(0.35, 0.5 * h, 0.35) center(xz) primitiveCube color("#6a5039") Trunk. ]
                 t(0, 0.25 * h, 0) s(0.6 * h, 0.75 * h, 0.6 * h) center(xz) i("crown") color(leaves) Crown.
    leaves   = 40% : "#5c7c3c" 35% : "#6d8c46" else : "#4f6f3f"
}

/// The settings of a run with a start rule.
pub(crate) fn settings(assets: &std::sync::Arc<Assets>, start: &str) -> Settings {
    Settings { start: Some(start.to_owned()), assets: assets.clone(), ..Settings::default() }
}

/// The crown of a tree: a ball of 128 triangles in a cube of one metre.
pub(crate) fn crown() -> Result<Mesh, MeshError> {
    const PARTS: usize = 4;
    let mut builder = MeshBuilder::new();
    // Each of eight sides is a triangular grid, blown up to a ball; neighbours share the points of their edges.
    let mut known: Vec<([i32; 3], u32)> = Vec::new();
    let mut point = |builder: &mut MeshBuilder, at: [i32; 3]| {
        if let Some((_, index)) = known.iter().find(|(known, _)| *known == at) {
            return *index;
        }
        let [x, y, z] = at.map(f64::from);
        let length = (x * x + y * y + z * z).sqrt();
        // The crowns of trees are lumpy.
        let radius = 0.5 - 0.035 * f64::from((at[0] * 7 + at[1] * 5 + at[2] * 3).rem_euclid(4));
        let index = builder.point([x, y, z].map(|part| 0.5 + radius * part / length));
        known.push((at, index));
        index
    };
    let parts = PARTS as i32;
    for [x, y, z] in
        [[1, 1, 1], [-1, 1, -1], [-1, -1, 1], [1, -1, -1], [-1, 1, 1], [1, 1, -1], [1, -1, 1], [-1, -1, -1]]
    {
        let is_turned = x * y * z < 0;
        for i in 0..parts {
            for j in 0..parts - i {
                let mut corner = |i: i32, j: i32| point(&mut builder, [x * i, y * j, z * (parts - i - j)]);
                let (a, b, c) = (corner(i, j), corner(i + 1, j), corner(i, j + 1));
                let mut faces = vec![[a, b, c]];
                if i + j + 1 < parts {
                    faces.push([b, corner(i + 1, j + 1), c]);
                }
                for [a, b, c] in faces {
                    let face = if is_turned { [a, c, b] } else { [a, b, c] };
                    builder.polygon(&face);
                }
            }
        }
    }
    builder.build()
}
