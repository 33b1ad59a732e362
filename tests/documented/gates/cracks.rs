//! Watertight models have no cracks; the same models without it have.

use cga::sink::buffers::Buffers;
use cga::{Model, Settings, Shape, cga};
use cga_gates::Triangles;
use cga_tests::drawn::drawn;

cga! {
    /// Walls of storeys with different bays around an empty building.
    grammar Bays;
    Lot   --> extrude(12) comp(f) { side : Facade }
    Facade --> split(y) { { 1 : Storey(split.index + 3) }* }
    Storey(bays) --> split(x) { { scope.sx / bays : Bay. }* }
}

/// The sides of the pictures.
const VIEWS: u32 = 24;

/// The points inside of edges, the pinholes in all pictures, the triangles.
fn cracks(model: &Model, pixels: usize) -> [usize; 3] {
    let mut buffers = Buffers::new();
    let _ = model.replay(&mut buffers);
    let positions: Vec<[f32; 3]> = buffers.vertices().iter().map(|&[x, y, z, ..]| [x, y, z]).collect();
    let triangles = Triangles { positions: &positions, indices: buffers.indices() };
    let view = |view: u32| {
        let elevation = 3.0 + 57.0 * f64::from(view) / f64::from(VIEWS - 1);
        triangles.pinholes(15.0 * f64::from(view) + 7.0, elevation, pixels)
    };
    [triangles.points_inside_edges(), (0..VIEWS).map(view).sum(), buffers.triangle_count()]
}

/// The text of a failure.
fn text(before: [usize; 3], after: [usize; 3]) -> String {
    format!("points in edges, pinholes and triangles are {before:?}, and with `watertight` {after:?}")
}

#[test]
fn a_wall_of_storeys_with_different_bays_has_no_cracks() {
    let wall = Bays::default().generate_with(&Shape::rectangle(11.0, 8.0), &Settings::default()).expect("a model");
    let [before, after] = [&wall, &wall.watertight()].map(|model| cracks(model, 500));
    assert!(0 < before[0] && 0 < before[1], "{}", text(before, after));
    assert_eq!(after[..2], [0, 0], "{}", text(before, after));
    // Each bay has corners of the bays above and below.
    assert!(after[2] < 2 * before[2], "{}", text(before, after));
}

/// Some points of narrow frames remain inside of edges.
#[test]
fn the_house_of_the_readme_has_few_points_inside_of_edges() {
    let house = drawn().into_iter().find(|drawn| drawn.name == "example readme").expect("the house").model(false);
    let [before, after] = [&house, &house.watertight()].map(|model| cracks(model, 500));
    assert!(5 * after[0] < before[0] && after[1] == 0, "{}", text(before, after));
    assert!(10 * after[2] < 18 * before[2], "{}", text(before, after));
}
