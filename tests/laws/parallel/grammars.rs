//! Grammars with everything that runs collect.

use std::sync::Arc;

use cga::{Assets, Grammar, Mesh, MeshBuilder, Settings, Shape, cga};

cga! {
    /// Workload D with colours by chance, reports and prints.
    pub(crate) grammar Street;
    attr floor_h = 3
    Lot    --> report("lots", 1) report("area." + "lot", scope.sx * scope.sz / 3)
               comp(f) { side : Facade | top : Roof. }
    Facade --> 60% : color("#d8c8a8") Front 30% : color("#b08060") Front else : color("#90a0a8") Front
    Front  --> print(scope.sx) split(y) { 4 : Shop. | { ~floor_h : Floor }* }
    Floor  --> report("floor", scope.sx / 7) split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> 20% : t(0, 0, 0.1) extrude(0.2) Bay. else : Window.
}

cga! {
    /// Assets, cut meshes, faults, materials by chance, texts.
    @Allow(missing_asset)
    pub(crate) grammar Park;
    Lot   --> split(x) { { ~4 : Row(split.index) }* }
    Row(n) --> split(z) { { ~4 : Place(n) }* }
    Place(n) --> 40% : s(^0.5, 3, ^0.5) center(xz) Planted(n)
                 30% : s(1, 2, 1) i("missing-" + n % 2) Lost.
                 else : primitiveCylinder(9) s(2, 2, 2) split(y) { ~1 : color(rand, 0.5, 0.5) Slice. | ~2 : NIL | ~1 : Slice. }
    Planted(n) --> 50% : i("tree") Tree(n) else : i("tree", zUp) Tree(n)
    Tree(n) --> case n % 2 == 0 : report("tree", "even") Tree. else : report("tree", "odd " + n) color(1 / (n - n), 0, 0) Odd.
}

cga! {
    /// Recursion that waits on the list of the run, mostly without leaves.
    pub(crate) grammar Deep;
    Lot  --> Down(600)
    Down(n) --> case n == 0 : Leaf. else : [ t(0, 0.01, 0) Down(n - 1) ] case_of(n)
    case_of(n) --> case n % 100 == 0 : print(n) Leaf. else : NIL
}

fn tree() -> Mesh {
    let mut builder = MeshBuilder::new();
    let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 2.0, 0.0], [0.5, 1.0, 0.7]].map(|point| builder.point(point));
    for face in [[0, 1, 2], [1, 3, 2], [3, 0, 2], [1, 0, 3]] {
        builder.face(&face.map(|at| points[at]), &[], cga::mesh::FaceTag::PLAIN);
    }
    builder.build().expect("a mesh")
}

pub(crate) fn settings() -> Settings {
    Settings { assets: Arc::new(Assets::new().with("tree", tree())), ..Settings::default() }
}

/// Lots of different sizes, each with a seed of its own.
pub(crate) fn lots(count: usize) -> Vec<Shape> {
    let lot = |at: usize| {
        let height = 4.0 + 3.0 * (2 + (7 * at) % 9) as f64;
        Shape::cuboid(13.5, height, 11.0).at([20.0 * (at % 40) as f64, 0.0, 20.0 * (at / 40) as f64]).seed(at as u64)
    };
    (0..count).map(lot).collect()
}

/// A grammar that threads may share.
pub(crate) trait Shared: Grammar + Sync {}
impl<G: Grammar + Sync> Shared for G {}

/// Each grammar with a number of lots for it: more than one a stretch, one a stretch, one, none.
pub(crate) fn cases() -> Vec<(Box<dyn Shared>, Vec<Shape>)> {
    vec![
        (Box::new(Street::default()), lots(80)),
        (Box::new(Street { floor_h: 2.5 }), lots(1)),
        (Box::new(Street::default()), lots(0)),
        (Box::new(Park::default()), lots(40)),
        (Box::new(Deep::default()), lots(20)),
    ]
}
