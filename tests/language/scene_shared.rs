//! Scenes whose lots have grammars of their own and change.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use cga::{Error, Grammar, Limits, Model, Scene, SceneLot, Settings, Shape, SharedScene, Watch, cga};

use crate::scene_laws::{District, lots};

cga! {
    grammar Row = r#"
        attr height = 10
        Lot --> extrude(height) comp(f) { side : Facade | top : Roof. }
        Facade --> split(y) { 5 : Tile }*
        Tile --> case touches(inter) : Wall. else : Window.
    "#;
}

fn shared(grammar: impl Grammar, shape: &Shape) -> Arc<SceneLot> {
    Arc::new(SceneLot::new(grammar.boxed(), shape.clone(), Settings::default()))
}

/// A row of houses of 10 m without gaps.
fn row(count: u32) -> Vec<Arc<SceneLot>> {
    let place = |at: u32| Shape::rectangle(10.0, 10.0).at([f64::from(at) * 10.0, 0.0, 0.0]);
    (0..count).map(|at| shared(Row::default(), &place(at))).collect()
}

fn model(scene: &SharedScene, at: usize) -> Model {
    scene.generate_lot(at, None).expect("a model")
}

fn counts(scene: &SharedScene) -> Vec<[usize; 2]> {
    (0..scene.lots().len())
        .map(|at| model(scene, at))
        .map(|made| ["Window", "Wall"].map(|rule| made.count(rule)))
        .collect()
}

#[test]
fn the_models_equal_the_models_of_a_scene_in_any_order_and_on_any_thread() {
    let (district, lots) = (District::default(), lots());
    for is_near in [false, true] {
        let scene = Scene::new(&district, &lots);
        let scene = if is_near { scene.occlusion_distance(4.0).context_distance(4.0) } else { scene };
        let batches = scene.generate(&Settings::default()).expect("models");
        let expected: Vec<Model> = batches.into_iter().map(|batch| batch.sink).collect();
        let order: Vec<usize> = (0..lots.len()).map(|at| at * 8 % lots.len()).collect();
        let own = SharedScene::new(order.iter().map(|at| shared(District::default(), &lots[*at])).collect());
        let own = if is_near { own.occlusion_distance(4.0).context_distance(4.0) } else { own };
        thread::scope(|scope| {
            for first in 0..4 {
                let (own, order, expected) = (&own, &order, &expected);
                scope.spawn(move || {
                    for (index, at) in order.iter().enumerate().skip(first).step_by(4) {
                        assert_eq!(model(own, index), expected[*at]);
                    }
                });
            }
        });
    }
}

#[test]
fn lots_have_grammars_and_settings_of_their_own() {
    let lots = row(2);
    let low = Row { height: 5.0 };
    let shape = Shape::rectangle(10.0, 10.0).at([20.0, 0.0, 0.0]);
    let flat = Settings { start: Some("Tile".to_owned()), ..Settings::default() };
    let flat = Arc::new(SceneLot::new(Row::default().boxed(), shape.clone(), flat));
    let scene = |last: Arc<SceneLot>| SharedScene::new(vec![lots[0].clone(), lots[1].clone(), last]);
    assert_eq!(counts(&scene(shared(low, &shape))), [[6, 2], [5, 3], [3, 1]]);
    assert_eq!(counts(&scene(flat)), [[6, 2], [6, 2], [1, 0]]);
}

#[test]
fn old_and_new_states_affect_the_lots_that_ask_about_them() {
    let (lots, distant) = (row(9), shared(Row::default(), &Shape::rectangle(10.0, 10.0).at([200.0, 0.0, 0.0])));
    let scene = SharedScene::new(lots.clone());
    assert_eq!((scene.neighbours(4), scene.neighbours(0), scene.neighbours(9)), (vec![3, 5], vec![1], vec![]));
    assert_eq!(scene.affected_by(&[&*lots[4]]), [3, 4, 5]);
    assert_eq!(scene.affected_by(&[&*lots[4], &*lots[5]]), [3, 4, 5, 6]);
    assert_eq!(scene.affected_by(&[&*distant]), [0_usize; 0]);
    assert_eq!(scene.affected_by(&[]), [0_usize; 0]);
    assert_eq!(SharedScene::new(lots).occlusion_distance(10.0).neighbours(4), [2, 3, 5, 6]);
    // A lot moves from the middle of the row to its end.
    let mut moved = row(9);
    let old = moved.remove(4);
    let new = shared(Row::default(), &Shape::rectangle(10.0, 10.0).at([90.0, 0.0, 0.0]));
    moved.push(new.clone());
    assert_eq!(SharedScene::new(moved).affected_by(&[&*old, &*new]), [3, 4, 7, 8]);
}

#[test]
fn a_lot_with_wrong_numbers_hides_no_neighbour_and_affects_no_other() {
    let distant = shared(Row::default(), &Shape::rectangle(10.0, 10.0).at([200.0, 0.0, 0.0]));
    for shape in [
        Shape::rectangle(f64::NAN, 10.0),
        Shape::rectangle(10.0, 10.0).at([f64::NAN, 0.0, 0.0]),
        Shape::rectangle(10.0, 10.0).at([10.0, 0.0, f64::NEG_INFINITY]),
        Shape::rectangle(10.0, f64::INFINITY),
    ] {
        let wrong = shared(Row::default(), &shape);
        let [one, other]: [_; 2] = row(2).try_into().expect("two lots");
        let scene = SharedScene::new(vec![one, other, wrong.clone(), distant.clone()]);
        assert_eq!([0, 1, 2, 3].map(|at| scene.neighbours(at)), [vec![1], vec![0], vec![], vec![]], "{shape:?}");
        assert_eq!(scene.affected_by(&[&*wrong]), [2], "{shape:?}");
        assert_eq!(model(&scene, 0).count("Wall"), 2);
    }
}

#[test]
fn lots_without_labels_affect_no_queries_of_labels() {
    cga! { grammar Church = r#"Lot --> label("church") Church."#; }
    cga! { grammar House = r#"Lot --> print(minimumDistance(inter, "church")) House."#; }
    cga! { grammar Tree = "Lot --> Tree."; }
    let place = |at: u32| Shape::rectangle(2.0, 2.0).at([f64::from(at) * 10.0, 0.0, 0.0]);
    let (church, tree) = (shared(Church::default(), &place(3)), shared(Tree::default(), &place(1)));
    let (near, far) = (shared(House::default(), &place(2)), shared(House::default(), &place(9)));
    let scene = SharedScene::new(vec![near.clone(), church.clone(), far, tree.clone()]);
    assert_eq!(scene.affected_by(&[&*church]), [0, 1, 2]);
    assert_eq!(scene.affected_by(&[&*tree, &*near]), [0, 3]);
    assert_eq!([0, 1, 2, 3].map(|at| scene.neighbours(at)), [vec![1], vec![], vec![1], vec![]]);
    assert!(near.asks_about_neighbours() && !tree.asks_about_neighbours());
    assert_eq!([0, 2].map(|at| crate::lines(&model(&scene, at)).join("")), ["8", "58"]);
    let alone = SharedScene::new(vec![church.clone(), tree.clone()]);
    assert_eq!((alone.affected_by(&[&*tree]), alone.affected_by(&[&*near])), (vec![1], vec![]));
    assert_eq!((scene.context_neighbours(0), scene.occlusion_neighbours(0)), (vec![1], vec![]));
    let scene = scene.context_distance(10.0);
    assert_eq!(scene.affected_by(&[&*church]), [0, 1]);
    assert_eq!(crate::lines(&model(&scene, 2)), ["inf"]);
}

static DERIVED: AtomicUsize = AtomicUsize::new(0);

fn derived() -> f64 {
    DERIVED.fetch_add(1, Ordering::Relaxed);
    0.0
}

#[test]
fn each_neighbour_is_derived_once_for_all_lots() {
    cga! {
        grammar Derived;
        Lot --> extrude(10 + crate::scene_shared::derived()) label("a") Mass
        Mass --> print(touches(inter)) print(contextCount(inter, "a")) Mass.
    }
    let place = |at: u32| Shape::rectangle(10.0, 10.0).at([f64::from(at) * 10.0, 0.0, 0.0]);
    let lots: Vec<_> = (0..12).map(|at| shared(Derived::default(), &place(at))).collect();
    let scene = SharedScene::new(lots.clone()).context_distance(1.0);
    (3..6).for_each(|at| drop(model(&scene, at)));
    // Lots 2 to 6 for queries, and three runs.
    assert_eq!(DERIVED.swap(0, Ordering::Relaxed), 8);
    let scene = SharedScene::new(lots);
    (0..12).for_each(|at| assert_eq!(crate::lines(&model(&scene, at))[1], "11"));
    assert_eq!(DERIVED.swap(0, Ordering::Relaxed), 24);
}

#[test]
fn a_neighbour_that_fails_or_panics_leaves_no_shapes() {
    cga! { grammar Broken; Lot --> extrude(crate::scene_shared::broken()) Mass. }
    let (mut lots, place) = (row(3), Shape::rectangle(10.0, 10.0).at([10.0, 0.0, 0.0]));
    assert_eq!(counts(&SharedScene::new(lots.clone()))[0], [6, 2]);
    lots[1] = shared(Broken::default(), &place);
    let scene = SharedScene::new(lots.clone());
    assert_eq!([0, 2].map(|at| model(&scene, at).count("Window")), [8, 8]);
    assert!(std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| scene.generate_lot(1, None))).is_err());
    let few = Settings { limits: Limits { shapes: 3, ..Limits::default() }, ..Settings::default() };
    let unknown = Settings { start: Some("Unknown".to_owned()), ..Settings::default() };
    for (settings, shape) in
        [(few, place.clone()), (unknown, place), (Settings::default(), Shape::rectangle(f64::NAN, 1.0))]
    {
        lots[1] = Arc::new(SceneLot::new(Row::default().boxed(), shape, settings));
        let scene = SharedScene::new(lots.clone());
        assert_eq!([0, 2].map(|at| model(&scene, at).count("Window")), [8, 8]);
        assert!(scene.generate_lot(1, None).is_err());
    }
    assert!(matches!(SharedScene::new(lots).generate_lot(3, None), Err(Error::Shape(_))));
}

fn broken() -> f64 {
    panic!("a broken function")
}

#[test]
fn a_watch_that_stops_one_run_leaves_the_others_alone() {
    let scene = SharedScene::new(row(3));
    let watch = Watch::new();
    watch.stop();
    assert!(scene.generate_lot(1, Some(&watch)).is_ok_and(|model| model.report().stopped && model.is_empty()));
    let breaks = Watch::every(1, |_| panic!("a broken watch"));
    assert!(std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| scene.generate_lot(1, Some(&breaks)))).is_err());
    assert_eq!(counts(&scene), [[6, 2], [4, 4], [6, 2]]);
}
