//! Watertight models have no cracks; the same models without it have.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use cga::glam::DAffine3;
use cga::sink::buffers::Buffers;
use cga::sink::watertight::Watertight;
use cga::{Cuboid, Flow, Leaf, Mesh, Model, Quad, Settings, Shape, Sink, Watch, cga};
use cga_gates::Triangles;
use cga_tests::drawn::drawn;

cga! {
    /// Walls of storeys with different bays around an empty building.
    grammar Bays;
    Lot   --> extrude(12) comp(f) { side : Facade }
    Facade --> split(y) { { 1 : Storey(split.index + 3) }* }
    Storey(bays) --> split(x) { { scope.sx / bays : Bay. }* }
}

/// The number of pictures, each from another side.
const VIEWS: u32 = 24;

/// The buffers of each building.
#[derive(Default)]
struct Buildings(Vec<Buffers>);

impl Buildings {
    fn last(&mut self) -> &mut Buffers {
        if self.0.is_empty() {
            self.0.push(Buffers::new());
        }
        self.0.last_mut().expect("buffers")
    }
}

impl Sink for Buildings {
    fn begin_building(&mut self, _: &str, _: u64) {
        self.0.push(Buffers::new());
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.last().quad(leaf, quad)
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.last().cuboid(leaf, cuboid)
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.last().mesh(leaf, mesh, placement)
    }

    fn instance(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        // Inserted assets keep their own corners.
        ControlFlow::Continue(())
    }
}

/// The points inside of edges, the pinholes in pictures of a number of pixels, the triangles; of all buildings of a model, each on its own.
fn cracks(model: &Model, pixels: usize) -> [usize; 3] {
    let mut buildings = Buildings::default();
    let _ = model.replay(&mut buildings);
    let of_building = |buffers: &Buffers| {
        let positions: Vec<[f32; 3]> = buffers.vertices().iter().map(|&[x, y, z, ..]| [x, y, z]).collect();
        let triangles = Triangles { positions: &positions, indices: buffers.indices() };
        let view = |view: u32| {
            let elevation = 3.0 + 57.0 * f64::from(view) / f64::from(VIEWS - 1);
            triangles.pinholes(15.0 * f64::from(view) + 7.0, elevation, pixels)
        };
        let views = if pixels == 0 { 0 } else { VIEWS };
        [triangles.points_inside_edges(), (0..views).map(view).sum(), buffers.triangle_count()]
    };
    let add = |sum: [usize; 3], own: [usize; 3]| [sum[0] + own[0], sum[1] + own[1], sum[2] + own[2]];
    buildings.0.iter().map(of_building).fold([0; 3], add)
}

/// Checks that a model has cracks, and with `watertight` none, for at most 1.8 times the triangles.
fn check(name: &str, model: &Model, pixels: usize, has_pinholes: bool) {
    let before = cracks(model, if has_pinholes { pixels } else { 0 });
    let after = cracks(&model.watertight(), pixels);
    let text =
        format!("{name}: points in edges, pinholes and triangles are {before:?}, and with `watertight` {after:?}");
    assert!(0 < before[0] && (!has_pinholes || 0 < before[1]), "{text}");
    assert_eq!(after[..2], [0, 0], "{text}");
    // Each point adds a triangle on each side of its edge.
    assert!(10 * after[2] <= 18 * before[2] || after[2] <= before[2] + before[0], "{text}");
}

fn bays() -> Model {
    Bays::default().generate_with(&Shape::rectangle(11.0, 8.0), &Settings::default()).expect("a model")
}

#[test]
fn watertight_models_have_no_cracks() {
    check("bays", &bays(), 400, true);
    // Large models have many triangles or many buildings, so their pictures are small.
    let models = [("example front", 200), ("example tower", 150), ("example district", 80)];
    let drawn = drawn();
    for (name, pixels) in models {
        let drawn = drawn.iter().find(|drawn| drawn.name == name).expect("the model");
        check(name, &drawn.model(false), pixels, false);
    }
}

/// A run whose time ends while its corners are added has all leaves, as they were, and tells it.
#[test]
fn a_run_can_be_stopped_while_corners_are_added() {
    let run = |last: u64| {
        let count = Arc::new(AtomicU64::new(0));
        let seen = count.clone();
        let watch = Watch::deadline_by(Duration::from_secs(1), move || {
            if seen.fetch_add(1, Ordering::Relaxed) <= last { Duration::ZERO } else { Duration::MAX }
        });
        let settings = Settings { watch: Some(watch), ..Settings::default() };
        let mut sink = Watertight::new(Model::new());
        let report = Bays::default().run(&Shape::rectangle(1100.0, 800.0), &settings, &mut sink).expect("no limit");
        let model = sink.into_inner();
        (count.load(Ordering::Relaxed), report.stopped, model.len(), model.triangle_count())
    };
    let (questions, is_stopped, leaves, triangles) = run(u64::MAX);
    assert!(!is_stopped && 2 * leaves < triangles);
    let (_, is_stopped, stopped_leaves, stopped_triangles) = run(questions - 2);
    assert!(is_stopped && stopped_leaves == leaves && stopped_triangles < triangles);
}
