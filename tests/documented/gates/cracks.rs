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

/// Checks a model with and without cracks. Without `watertight`, it has both kinds.
fn check(name: &str, model: &Model, pixels: usize) {
    let [points, pinholes, triangles] = cracks(model, pixels);
    let [points_after, pinholes_after, triangles_after] = cracks(&model.watertight(), pixels);
    let text = format!(
        "{name}: {points} points in edges and {pinholes} pinholes in {triangles} triangles, then {points_after} and {pinholes_after} in {triangles_after}"
    );
    assert!(0 < points && points_after == 0, "{text}");
    assert!(pinholes_after == 0, "{text}");
    assert!((triangles_after as f64) < 1.8 * triangles as f64, "{text}");
}

#[test]
fn a_wall_of_storeys_with_different_bays_has_no_cracks() {
    let wall = Bays::default().generate_with(&Shape::rectangle(11.0, 8.0), &Settings::default()).expect("a model");
    let before = cracks(&wall, 500);
    assert!(0 < before[1], "the pictures show pinholes without `watertight`");
    check("bays", &wall, 500);
}

#[test]
fn the_house_of_the_readme_and_the_tower_have_no_cracks() {
    for drawn in drawn().into_iter().filter(|drawn| ["example readme", "example tower"].contains(&drawn.name.as_str()))
    {
        check(&drawn.name, &drawn.model(false), 500);
    }
}

#[test]
fn the_district_has_no_cracks() {
    let district =
        drawn().into_iter().find(|drawn| drawn.name == "example district").expect("the district").model(false);
    let watertight = district.watertight();
    // Each initial shape keeps its own corners.
    for ((building, leaves), (_, before)) in watertight.buildings().zip(district.buildings()) {
        assert_eq!(leaves, before);
        let mut one = Model::new();
        watertight.leaves().skip(leaves.start).take(leaves.len()).for_each(|leaf| drop(leaf.replay(&mut one)));
        let [points, pinholes, _] = cracks(&one, 250);
        assert_eq!([points, pinholes], [0, 0], "{}", building.name);
    }
}
