//! Leaves without faces: points and edges, in models, sinks and files.

use std::ops::ControlFlow;
use std::sync::Arc;

use cga::glam::{DAffine3, DVec3};
use cga::sink::gltf::Glb;
use cga::sink::stats::Stats;
use cga::{Flow, Leaf, Mesh, Repeats, Settings, Shape, Sink, cga};

use cga_gates::GlbFile;

cga! {
    grammar Places;

    @StartRule
    Lot --> extrude(3) [ comp(v) { all : Lamp. } ] [ comp(e) { all : Beam. } ] [ comp(f) { top : scatter(surface, 9, uniform) { Spawn. } } ]
        comp(f) { front : color("#ff0000") Wall. }
    @StartRule
    Point --> Spawn.
    @StartRule
    Nothing --> [ subtract { A. | A. } Gone. ] [ comp(e) { 0 : extrude(0) Line. } ] NIL
    @StartRule
    Row --> split(x) { { ~1 : Bay }* }
    Bay --> [ comp(f) { front : Glass. } ] comp(e) { 0 : Rail. }
}

fn model(start: &str, shape: &Shape) -> cga::Model {
    let settings = Settings { start: Some(start.into()), ..Settings::default() };
    Places {}.generate_with(shape, &settings).expect("no limit")
}

#[test]
fn points_and_edges_are_leaves() {
    let model = model("Lot", &Shape::rectangle(4.0, 2.0).at([10.0, 0.0, 0.0]));
    assert_eq!(model.counts(), [("Lamp", 8), ("Beam", 12), ("Spawn", 9), ("Wall", 1)]);
    assert_eq!(model.report().leaves, 30);
    // Faces alone have measures.
    assert_eq!((model.area(), model.stats().total().leaves, model.stats().rule("Lamp").leaves), (12.0, 30, 8));
    assert!(model.bounds().size().abs_diff_eq(DVec3::new(4.0, 3.0, 0.0), 1e-12));
    let corners: Vec<DVec3> = model.placements("Lamp").map(|scope| scope.origin).collect();
    let is_corner =
        |at: &DVec3| [10.0, 14.0].contains(&at.x) && [0.0, 3.0].contains(&at.y) && [0.0, 2.0].contains(&at.z.abs());
    assert!(corners.iter().all(is_corner), "{corners:?}");
    let mut lengths: Vec<f64> = model.placements("Beam").map(|scope| scope.size.x).collect();
    lengths.sort_by(f64::total_cmp);
    assert_eq!(lengths, [2.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 3.0, 4.0, 4.0, 4.0, 4.0]);
    assert!(model.placements("Spawn").all(|scope| scope.origin.y == 3.0 && scope.size == DVec3::ZERO));
    let point = self::model("Point", &Shape::point([1.0, 2.0, 3.0]));
    assert_eq!(point.placements("Spawn").map(|scope| scope.origin.to_array()).collect::<Vec<_>>(), [[1.0, 2.0, 3.0]]);
}

/// What is cut away is not there.
#[test]
fn a_shape_of_which_nothing_is_left_makes_no_leaf() {
    let model = model("Nothing", &Shape::cuboid(2.0, 2.0, 2.0));
    assert_eq!((model.count("Gone"), model.count("Line")), (0, 1), "{:?}", model.faults());
}

/// Placements in a row of templates, by all ways, and as boxes or meshes.
#[test]
fn all_ways_give_the_same_placements() {
    for repeats in [Repeats::Kept, Repeats::Again, Repeats::Direct] {
        for shape in [Shape::cuboid(8.0, 3.0, 1.0), Shape::cuboid(8.0, 3.0, 1.0).held_as_meshes()] {
            let settings = Settings { start: Some("Row".into()), repeats, ..Settings::default() };
            let model = Places {}.generate_with(&shape, &settings).expect("no limit");
            assert_eq!(model.counts(), [("Glass", 8), ("Rail", 8)], "{repeats:?}");
            let order: Vec<&str> = model.leaves().map(|leaf| leaf.rule()).collect();
            assert_eq!(order, ["Glass", "Rail"].repeat(8), "{repeats:?}");
            let mut x: Vec<f64> = model.placements("Rail").map(|scope| scope.origin.x).collect();
            x.sort_by(f64::total_cmp);
            assert!(x.windows(2).all(|pair| (pair[1] - pair[0] - 1.0).abs() < 1e-9), "{x:?}");
        }
    }
}

/// A sink of its own that knows meshes and placements.
#[derive(Default)]
struct Lamps {
    meshes: usize,
    places: Vec<DVec3>,
}

impl Sink for Lamps {
    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        self.meshes += 1;
        ControlFlow::Continue(())
    }

    fn placement(&mut self, leaf: &Leaf<'_>) -> Flow {
        self.places.extend((leaf.rule == "Lamp").then(|| leaf.scope().origin));
        // Enough lamps.
        if self.places.len() == 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn sinks_get_placements_and_may_stop_there() {
    let mut lamps = Lamps::default();
    let report = Places {}.run(&Shape::rectangle(4.0, 2.0), &Settings::default(), &mut lamps).expect("no error");
    assert!(report.stopped && lamps.places.len() == 5 && lamps.meshes == 0);
    // A model passes them on, and itself to another model.
    let model = model("Lot", &Shape::rectangle(4.0, 2.0));
    let (mut again, mut stats) = (cga::Model::new(), Stats::new());
    again.append(&model);
    assert!(model.replay(&mut stats).is_continue());
    assert_eq!((again.counts(), stats.total().leaves), (model.counts(), 30));
}

#[test]
fn a_file_has_nodes_for_placements_on_request() {
    let json = |glb: &[u8]| GlbFile::new(glb).json;
    for (start, count, meshes) in [("Lot", 29, 1), ("Point", 1, 0)] {
        let model = model(start, &Shape::rectangle(4.0, 2.0));
        let write = |glb: Glb| {
            let mut glb = glb;
            assert!(model.replay(&mut glb).is_continue());
            json(&glb.into_bytes().expect("a small file"))
        };
        let (with, without) = (write(Glb::new().with_placements()), write(Glb::new()));
        let nodes = |file: &serde_json::Value| file["nodes"].as_array().map_or(0, Vec::len);
        // A point that is a rectangle's leaf has faces.
        if start == "Point" {
            assert_eq!((nodes(&with), nodes(&without)), (1, 1));
            continue;
        }
        assert_eq!((nodes(&with), nodes(&without)), (1 + count, 1));
        assert_eq!(with["meshes"].as_array().map_or(0, Vec::len), meshes);
        let node = &with["nodes"][9];
        assert_eq!(node["name"], "Beam");
        let length = node["extras"]["size"][0].as_f64().expect("a length");
        assert!(
            [2.0, 3.0, 4.0].contains(&length)
                && node["rotation"].as_array().is_some_and(|rotation| rotation.len() == 4)
        );
    }
    // Without any mesh.
    let model = model("Point", &Shape::point([1.0, 2.0, 3.0]));
    let mut glb = Glb::new().with_placements().with_origin(DVec3::X);
    assert!(model.replay(&mut glb).is_continue());
    let file = json(&glb.into_bytes().expect("a small file"));
    assert_eq!(file["nodes"][1]["translation"], serde_json::json!([0, 2, 3]));
    // The table of buildings is all that is in a buffer.
    assert!(file.get("meshes").is_none() && file.get("accessors").is_none());
}
