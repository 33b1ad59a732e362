//! Scenes: rules that ask about other initial shapes.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};

use cga::{Batches, Error, Grammars, Limits, Model, Scene, Settings, Shape, Watch, cga};

use crate::scene_laws::{District, lots};
use crate::{leaves, rules};

cga! {
    grammar Towers = r#"
        Lot --> extrude(rand(10)) label("label") Colored
        Colored -->
            case contextCompare(inter, "label", world.highest) == 0 : Red.
            case contextCompare(inter, "label", world.lowest) == 0 : Green.
            else : Blue.
    "#;
}

/// A row of lots of 10 m, so far from each other, each with a seed of its own.
fn row(count: u64, gap: f64) -> Vec<Shape> {
    let lot = |at: u64| Shape::rectangle(10.0, 10.0).at([at as f64 * (10.0 + gap), 0.0, 0.0]).seed(at);
    (0..count).map(lot).collect()
}

fn models(scene: &Scene<'_>) -> Vec<Model> {
    let batches = scene.generate(&Settings::default()).expect("models");
    let models: Vec<Model> = batches.into_iter().map(|batch| batch.sink).collect();
    assert!(models.iter().all(|model| model.faults().is_empty()));
    models
}

#[test]
fn the_highest_of_all_towers_is_red() {
    let lots = row(20, 2.0);
    let models = models(&Scene::new(&Towers::default(), &lots));
    let heights: Vec<f64> = models.iter().map(|model| model.volume() / 100.0).collect();
    let highest = heights.iter().copied().fold(0.0, f64::max);
    for (model, height) in models.iter().zip(&heights) {
        // All stand on the ground, so none is lower than another.
        assert_eq!(leaves(model), [if *height == highest { "Red" } else { "Green" }]);
    }
}

#[test]
fn a_shape_is_compared_with_its_own_initial_shape_only_by_intra_and_all() {
    rules! {
        grammar Counted = r#"Lot --> label("a") label("b") print(contextCount(intra, "a") + ";" + contextCount(inter, "a")
            + ";" + contextCount(all, "a") + ";" + minimumDistance(inter, "b") + ";" + minimumDistance(all, "b")) X."#;
    }
    let lots = row(3, 4.0);
    for (distance, near) in [(f64::INFINITY, [2, 2, 2]), (4.0, [1, 2, 1]), (3.9, [0, 0, 0])] {
        let counted = Counted::default();
        let models = models(&Scene::new(&counted, &lots).context_distance(distance));
        for (model, near) in models.iter().zip(near) {
            let least = if near == 0 { "inf" } else { "4" };
            assert_eq!(crate::lines(model), [format!("1;{near};{};{least};0", near + 1)], "{distance}");
        }
    }
}

#[test]
fn edges_that_face_a_block_are_set_back() {
    rules! {
        grammar Street = r#"
            Lot --> extrude(4) label("Block") comp(f) { bottom : NIL | top : Garden | side : NIL }
            Garden --> setbackPerEdge(dist) { all : Strip. | remainder : Rest. }
            dist = case minimumDistance(inter, "Block") < 3 : 2 else : 0
        "#;
    }
    let models = models(&Scene::new(&Street::default(), &row(3, 2.5)));
    let strips =
        |model: &Model| model.leaves().filter(|leaf| leaf.rule() == "Strip").map(|leaf| leaf.area()).sum::<f64>();
    // The ends of the edges at right angles are near, too: 6 by 8 m are left at the ends of the row, and 6 by 6 m between them.
    assert_eq!(models.iter().map(strips).collect::<Vec<_>>(), [52.0, 64.0, 52.0]);
}

rules! {
    grammar Blocks = r#"
        attr height = 10
        Lot --> extrude(height) comp(f) { side : Facade | top : Roof. }
        Facade --> split(y) { 5 : Tile }*
        Tile --> case inside(inter) : NIL case touches(inter) : Wall. else : Window.
    "#;
}

#[test]
fn party_walls_have_no_windows() {
    let lots: Vec<Shape> =
        row(2, 0.0).into_iter().zip([10.0, 18.0]).map(|(lot, height)| lot.attribute("height", height)).collect();
    let models = models(&Scene::new(&Blocks::default(), &lots));
    let counts = |model: &Model| [model.count("Window"), model.count("Wall")];
    // The wall of the low block is inside the high one's; of the high one, the tiles up to 10 m are, and none is partly hidden.
    assert_eq!(models.iter().map(counts).collect::<Vec<_>>(), [[6, 0], [12 + 2, 0]]);
    // A tile of 5 m that is hidden up to 2 m is a wall.
    let lots = [lots[0].clone().attribute("height", 12.0), lots[1].clone()];
    let models = self::models(&Scene::new(&Blocks::default(), &lots));
    assert_eq!(models.iter().map(counts).collect::<Vec<_>>(), [[9, 0], [13, 1]]);
}

#[test]
fn neighbours_are_near_in_plan_and_their_queries_have_defaults() {
    rules! {
        grammar Grown = r#"
            attr up = 0
            Lot --> extrude(10) t(0, up, 0) Block
            Block --> case overlaps(inter) : Hidden. else : s('1.5, '1, '1.5) center(xz) Free.
        "#;
    }
    let found = |gap: f64, up: f64| {
        let lots: Vec<Shape> = row(2, gap).into_iter().map(|lot| lot.attribute("up", up)).collect();
        models(&Scene::new(&Grown::default(), &lots)).iter().map(|model| leaves(model).join("")).collect::<Vec<_>>()
    };
    // Neighbours grow by 2.5 m in their derivation, as their queries give false there.
    assert_eq!(found(0.9, 0.0), ["Hidden", "Hidden"]);
    assert_eq!(found(1.0, 0.0), ["Hidden", "Hidden"]);
    assert_eq!(found(1.1, 0.0), ["Free", "Free"]);
    let lots =
        [Shape::rectangle(10.0, 10.0), Shape::rectangle(10.0, 10.0).at([10.5, 300.0, 0.0]).attribute("up", -300)];
    let models = models(&Scene::new(&Grown::default(), &lots));
    assert!(models.iter().all(|model| leaves(model) == ["Hidden"]));
}

#[test]
fn scenes_have_lots_of_several_grammars() {
    cga! { grammar Church = r#"Lot --> label("church") Church."#; }
    cga! { grammar House = r#"Lot --> print(minimumDistance(inter, "church")) House."#; }
    let grammars = Grammars::new().with(House::default()).with(Church::default());
    let lots: Vec<Shape> = row(4, 5.0);
    let lots = [&lots[..2], &[lots[2].clone().grammar("Church")], &lots[3..]].concat();
    let models = models(&Scene::of_grammars(&grammars, &lots));
    let lines: Vec<String> = models.iter().map(|model| crate::lines(model).join("")).collect();
    assert_eq!(lines, ["20", "5", "", "5"]);
}

static DERIVED: AtomicUsize = AtomicUsize::new(0);

fn derived() -> f64 {
    DERIVED.fetch_add(1, Ordering::Relaxed);
    0.0
}

#[test]
fn each_neighbour_is_derived_once_for_all_queries() {
    cga! {
        grammar Derived;
        Lot --> extrude(10 + crate::scene::derived()) label("a") Mass
        Mass --> print(touches(inter)) print(overlaps(inter)) print(contextCount(inter, "a")) comp(f) { all : Wall }
        Wall --> case touches(inter) : Hidden. else : Free.
    }
    let lots = row(30, 0.5);
    let grammar = Derived::default();
    models(&Scene::new(&grammar, &lots));
    assert_eq!(DERIVED.swap(0, Ordering::Relaxed), 60);
    // Two neighbours, for each of both kinds of queries.
    let model =
        Scene::new(&grammar, &lots).context_distance(1.0).generate_lot(4, &Settings::default()).expect("a model");
    assert_eq!((DERIVED.swap(0, Ordering::Relaxed), crate::lines(&model)[2].as_str()), (3, "2"));
}

#[test]
fn the_order_of_lots_makes_no_difference() {
    let (district, lots) = (District::default(), lots());
    let expected = models(&Scene::new(&district, &lots));
    let order: Vec<usize> = (0..lots.len()).map(|at| at * 8 % lots.len()).collect();
    let other: Vec<Shape> = order.iter().map(|at| lots[*at].clone()).collect();
    let found = models(&Scene::new(&district, &other));
    assert!(order.iter().zip(&found).all(|(at, model)| *model == expected[*at]));
    let scene = Scene::new(&district, &lots);
    let one = |at: usize| scene.generate_lot(at, &Settings::default()).expect("a model");
    assert!([0, 5, 11, 23].into_iter().all(|at| one(at) == expected[at]));
}

#[test]
#[cfg(feature = "rayon")]
fn the_number_of_threads_makes_no_difference() {
    let (district, lots) = (District::default(), lots());
    let scene = Scene::new(&district, &lots);
    let expected = models(&scene);
    for threads in [1, 2, 8] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let found = pool.install(|| scene.generate(&Settings::default())).expect("models");
        assert!(found.iter().map(|batch| &batch.sink).eq(&expected), "{threads}");
        let mut streamed = Vec::new();
        let take = |at: usize, model: Model| {
            streamed.push((at, model));
            ControlFlow::Continue(())
        };
        let report = pool.install(|| scene.generate_each(&Settings::default(), take)).expect("models");
        assert_eq!(&report, found.report());
        assert!(
            streamed.iter().map(|(at, _)| *at).eq(0..lots.len())
                && streamed.iter().map(|(_, model)| model).eq(&expected)
        );
    }
}

#[test]
fn a_changed_lot_changes_the_affected_ones_alone() {
    let (blocks, lots) = (Blocks::default(), row(9, 0.0));
    let scene = Scene::new(&blocks, &lots);
    let before = models(&scene);
    let affected = scene.affected_by(4, &Settings::default()).expect("lots");
    assert_eq!(affected, [3, 4, 5]);
    let mut changed = lots.clone();
    changed[4] = lots[4].clone().attribute("height", 5);
    let after = models(&Scene::new(&blocks, &changed));
    let differs: Vec<usize> = (0..9).filter(|at| before[*at] != after[*at]).collect();
    assert_eq!(differs, [3, 4, 5]);
    assert_eq!(Scene::new(&Towers::default(), &lots).affected_by(4, &Settings::default()), Ok((0..9).collect()));
    assert_eq!(scene.affected_by(9, &Settings::default()), Ok(vec![]));
}

#[test]
fn a_scene_without_queries_gives_what_generate_all_gives() {
    cga! { grammar Plain = "Lot --> extrude(rand(10)) split(y) { ~1 : X. }*"; }
    let (plain, lots, settings) = (Plain::default(), row(20, 0.0), Settings::default());
    assert_eq!(Scene::new(&plain, &lots).generate(&settings), plain.generate_all(&lots, &settings));
}

#[test]
fn scenes_end_with_the_first_error_a_watch_or_what_takes_the_models() {
    let (blocks, lots) = (Blocks::default(), row(20, 0.0));
    let scene = Scene::new(&blocks, &lots);
    let few = Settings { limits: Limits { shapes: 3, ..Limits::default() }, ..Settings::default() };
    // The first lot asks about the second one, whose derivation fails.
    let error = scene.generate(&few).expect_err("a limit");
    assert_eq!(error.shape, Some(1));
    let error = scene.generate_lot(20, &few).expect_err("no such lot");
    assert!(error.shape.is_none() && matches!(error.error, Error::Shape(_)));
    let watch = Watch::new();
    watch.stop();
    let stopped = Settings { watch: Some(watch), ..Settings::default() };
    let batches: Batches<Model> = scene.generate(&stopped).expect("no error");
    assert!(batches.report().stopped && batches.count("Roof") == 0);
    let mut taken = 0;
    let take = |_: usize, _: Model| {
        taken += 1;
        if taken < 3 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let report = scene.generate_each(&Settings::default(), take).expect("no error");
    assert!(taken == 3 && report.stopped);
}

#[test]
fn an_error_names_the_neighbour_whose_derivation_failed() {
    rules! { grammar Asking = "Lot --> print(touches(inter)) X."; }
    cga! { grammar Endless = "Lot --> split(x) { 0.1 : extrude(1) Y. }*"; }
    let grammars = Grammars::new().with(Asking::default()).with(Endless::default());
    let few = Settings { limits: Limits { shapes: 20, ..Limits::default() }, ..Settings::default() };
    let mut lots = row(5, 0.0);
    lots[3] = lots[3].clone().grammar("Endless");
    let scene = Scene::of_grammars(&grammars, &lots);
    // Lot 2 asks about lot 3.
    let mut taken = 0;
    let count = |_: usize, _: Model| {
        taken += 1;
        ControlFlow::Continue(())
    };
    let errors = [
        scene.generate(&few).expect_err("a limit"),
        scene.generate_each(&few, count).expect_err("a limit"),
        scene.generate_lot(4, &few).expect_err("a limit"),
        scene.generate_lot(3, &few).expect_err("a limit"),
    ];
    assert_eq!((errors.map(|error| error.shape), taken), ([Some(3); 4], 2));
    assert!(scene.generate_lot(1, &few).is_ok());
}

#[test]
fn turned_party_walls_are_found_as_well() {
    // A row of four houses whose walls are coplanar only up to rounding.
    let turned = |at: usize, degrees: f64| {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let corner = |x: f64, z: f64| [300.0 + x * cos + z * sin, 700.0 - x * sin + z * cos];
        let x = 10.0 * at as f64;
        let outline = [corner(x, 10.0), corner(x + 10.0, 10.0), corner(x + 10.0, 0.0), corner(x, 0.0)];
        Shape::footprint(&outline, &[]).expect("a lot").attribute("height", 10.0 + 5.0 * (at % 2) as f64)
    };
    let counts = |degrees: f64| -> Vec<[usize; 2]> {
        let lots: Vec<Shape> = (0..4).map(|at| turned(at, degrees)).collect();
        let models = models(&Scene::new(&Blocks::default(), &lots));
        models.iter().map(|model| [model.count("Window"), model.count("Wall")]).collect()
    };
    let expected = counts(0.0);
    // Low houses have hidden side walls; tall ones have a free storey above their neighbours.
    assert_eq!(expected, [[6, 0], [8, 0], [4, 0], [10, 0]]);
    for degrees in [7.0, 30.0, 45.0, 61.3, 123.4] {
        assert_eq!(counts(degrees), expected, "{degrees}");
    }
}
