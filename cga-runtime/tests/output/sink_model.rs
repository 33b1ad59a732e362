//! Models: the leaves come out as they went in.

use std::sync::Arc;

use crate::sink_support::{Fill, color, front, mixed, plate, tower, upright};
use cga_runtime::output::model::{Geometry, Model};
use cga_runtime::run::sink::{Leaf, Quad, Sink};
use cga_runtime::shape::scope::Scope;
use cga_runtime::value::text::Text;
use glam::{DAffine3, DMat3, DVec3, dvec3};

#[test]
fn leaves_come_back_as_they_were() {
    let mut fill = Fill(Model::new());
    let red = color(1.0, 0.0, 0.0);
    let quads = [
        front(dvec3(1.0, 2.0, 3.0), 4.0, 5.0),
        Quad::new(dvec3(0.0, 0.0, 2.0), DVec3::X, DVec3::Z * -2.0),
        Quad::new(DVec3::ONE, dvec3(0.3, 0.4, 0.0), DVec3::Z),
    ];
    quads.iter().for_each(|quad| fill.quad("Q", &red, *quad));
    let boxes = [upright(DVec3::ONE, dvec3(1.0, 2.0, 3.0)), upright(DVec3::ONE, dvec3(1.0, -2.0, 3.0))];
    boxes.iter().for_each(|cuboid| fill.cuboid("C", &red, *cuboid));
    let model = fill.0;
    let geometry: Vec<_> = model.leaves().map(|leaf| leaf.geometry()).collect();
    assert!((0..3).all(|i| matches!(geometry[i], Geometry::Quad(quad) if quad == quads[i])));
    assert!((0..2).all(|i| matches!(geometry[i + 3], Geometry::Cuboid(cuboid) if cuboid == boxes[i])));
    assert_eq!(model.counts(), [("Q", 3), ("C", 2)]);
    assert_eq!((model.count("C"), model.count("None")), (2, 0));
    assert_eq!(model.leaves().map(|leaf| leaf.volume()).collect::<Vec<_>>(), [0.0, 0.0, 0.0, 6.0, -6.0]);
    assert_eq!(model.leaves().map(|leaf| leaf.area()).collect::<Vec<_>>(), [20.0, 2.0, 0.5, 22.0, 22.0]);
    assert_eq!(model.leaves().next().map(|leaf| leaf.size()), Some(dvec3(4.0, 5.0, 0.0)));
}

#[test]
fn geometry_that_fills_a_turned_scope_is_exact() {
    let axes = DMat3::from_rotation_y(0.7) * DMat3::from_rotation_x(0.3);
    let scope = Scope { origin: dvec3(0.1, 0.2, 0.3), axes, size: dvec3(1.1, 2.2, 0.0) };
    let quad = Quad::new(scope.origin, axes.x_axis * 1.1, axes.y_axis * 2.2);
    let mut model = Model::new();
    let white = color(1.0, 1.0, 1.0);
    let name = Text::fixed("Q");
    let leaf = Leaf::new(&name, &white, &scope);
    assert!(model.quad(&leaf, &quad).is_continue());
    let view = model.leaves().next().expect("one leaf");
    assert!(matches!(view.geometry(), Geometry::Quad(same) if same == quad));
    assert_eq!((view.scope(), view.rule()), (scope, "Q"));
}

#[test]
fn replaying_into_a_model_gives_the_same_model() {
    let model = mixed();
    let mut copy = Model::new();
    assert!(model.replay(&mut copy).is_continue());
    assert_eq!(copy, model);
    assert_eq!(copy.stats(), model.stats());
    let instances = copy.leaves().filter(|leaf| matches!(leaf.geometry(), Geometry::Instance { .. })).count();
    assert_eq!(instances, 3);
}

#[test]
fn models_are_equal_if_their_leaves_are() {
    let red = color(1.0, 0.0, 0.0);
    let one = |rule: &'static str, width: f64| {
        let mut fill = Fill(Model::new());
        fill.quad(rule, &red, front(DVec3::ZERO, width, 1.0));
        fill.0
    };
    let wall = one("Wall", 2.0);
    assert_eq!(wall, one("Wall", 2.0));
    assert!(wall != one("Door", 2.0) && wall != one("Wall", 3.0) && wall != Model::new() && wall != mixed());
    assert_ne!(wall.stats(), one("Wall", 3.0).stats());
    let meshes = |model: &Model| model.meshes(cga_runtime::output::meshes::Granularity::Rule);
    assert_eq!(meshes(&wall), meshes(&one("Wall", 2.0)));
    assert_ne!(meshes(&wall), meshes(&one("Door", 2.0)));
}

#[test]
fn placed_meshes_measure_in_the_world() {
    let mut fill = Fill(Model::new());
    let place = DAffine3::from_translation(dvec3(1e6, 0.0, 0.0)) * DAffine3::from_scale(dvec3(2.0, 3.0, 0.5));
    fill.mesh("Plate", &Arc::default(), &plate(), place);
    let leaf = fill.0.leaves().next().expect("one leaf");
    assert!((leaf.volume() - 30.0).abs() < 1e-9);
    // Two faces of 10, outer sides of 14 and inner sides of 6 along x and y, each stretched differently.
    let expected = 2.0 * 10.0 * 6.0 + 2.0 * (4.0 + 2.0) * 2.0 * 0.5 + 2.0 * (3.0 + 1.0) * 3.0 * 0.5;
    assert!((leaf.area() - expected).abs() < 1e-9);
    assert_eq!(leaf.bounds().low, dvec3(1e6, 0.0, 0.0));
    assert_eq!(leaf.bounds().high, dvec3(1e6 + 8.0, 9.0, 0.5));
}

#[test]
fn checksum_of_closed_leaves_is_their_volume() {
    let mut fill = Fill(Model::new());
    fill.cuboid("Box", &color(1.0, 0.0, 0.0), upright(dvec3(5.0, 6.0, 7.0), dvec3(1.0, 2.0, 3.0)));
    fill.mesh("Plate", &Arc::default(), &plate(), DAffine3::from_translation(dvec3(-3.0, 2.0, 9.0)));
    let stats = fill.0.stats();
    assert!((stats.checksum() - 16.0).abs() < 1e-9);
    assert!((stats.total().volume - 16.0).abs() < 1e-9);
    assert!((fill.0.volume() - 16.0).abs() < 1e-9);
    assert!((stats.rule("Plate").volume - 10.0).abs() < 1e-9);
    assert_eq!((stats.rule("Plate").leaves, stats.rule("Plate").triangles), (1, 32));
}

#[test]
fn stats_and_model_agree_on_bounds() {
    for model in [tower(3), mixed()] {
        assert_eq!(model.bounds(), model.stats().bounds());
        assert!((model.area() - model.stats().total().area).abs() < 1e-9 * model.area());
    }
    assert!(Model::new().bounds().low.x.is_infinite() && Model::new().triangle_count() == 0);
}
