//! Scenes with strange lots: none, many in one place, wrong numbers, far from the origin, and runs that end in the first derivation.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use cga::{Error, LimitKind, Limits, Model, Scene, Settings, Shape, Watch, cga};

use crate::{clean, rules};

cga! {
    grammar Asking = r#"
        attr height = 10
        Lot --> extrude(height) label("a") comp(f) { side : Wall | top : Roof. }
        Wall --> split(y) { ~5 : split(x) { ~5 : Tile }* }*
        Tile --> case touches(all) : Hidden. case minimumDistance(inter, "a") < 5 : Near. else : Free.
    "#;
}

fn square(at: [f64; 3]) -> Shape {
    Shape::rectangle(10.0, 10.0).at(at)
}

fn counts(lots: &[Shape]) -> Vec<[usize; 3]> {
    let asking = Asking::default();
    let batches = Scene::new(&asking, lots).generate(&Settings::default()).expect("models");
    let count = |model: Model| ["Hidden", "Near", "Free"].map(|rule| model.count(rule));
    batches.into_iter().map(|batch| count(clean(batch.sink))).collect()
}

#[test]
fn an_empty_scene_has_no_models() {
    let asking = Asking::default();
    let scene = Scene::new(&asking, &[]);
    assert_eq!(scene.generate(&Settings::default()).expect("no models").into_iter().count(), 0);
    assert_eq!(scene.affected_by(0, &Settings::default()), Ok(vec![]));
    assert!(matches!(scene.generate_lot(0, &Settings::default()).expect_err("no lot").error, Error::Shape(_)));
}

#[test]
fn lots_in_one_place_hide_each_other() {
    assert_eq!(counts(&vec![square([0.0; 3]); 20]), [[16, 0, 0]; 20]);
    assert_eq!(counts(&[square([0.0; 3])]), [[0, 0, 16]]);
}

#[test]
fn lots_in_one_point_end() {
    // Lots without a size have no solids.
    let lots = vec![Shape::rectangle(1e-9, 1e-9); 300];
    let batches = Scene::new(&Asking::default(), &lots).generate(&Settings::default()).expect("models");
    assert_eq!(batches.into_iter().count(), 300);
}

#[test]
fn far_lots_have_the_answers_of_near_ones() {
    let row = |place: [f64; 3]| {
        let lot = |at: usize| {
            let [x, y, z] = place;
            square([x + 10.0 * at as f64, y, z]).attribute("height", [10.0, 20.0, 5.0][at])
        };
        counts(&[0, 1, 2].map(lot))
    };
    let expected = row([0.0; 3]);
    assert_eq!(expected[0][0], 4);
    for place in [[1e7, 0.0, 0.0], [-1e7, 0.0, 3e7], [1e7, 1e7, 1e7]] {
        assert_eq!(row(place), expected, "{place:?}");
    }
    // Two of these groups do not disturb each other.
    let both: Vec<Shape> =
        [0.0, 1e7].iter().flat_map(|x| [square([*x, 0.0, 0.0]), square([*x + 10.0, 0.0, 0.0])]).collect();
    assert_eq!(counts(&both), [[4, 4, 8]; 4]);
}

#[test]
fn wrong_lots_are_an_error_with_their_number() {
    let wrong = [
        Shape::rectangle(f64::NAN, 10.0),
        Shape::rectangle(10.0, 10.0).at([f64::NAN, 0.0, 0.0]),
        Shape::rectangle(10.0, 10.0).at([0.0, f64::INFINITY, 0.0]),
        Shape::rectangle(f64::INFINITY, 10.0),
    ];
    for wrong in wrong {
        let lots = [square([0.0; 3]), wrong, square([1e5, 0.0, 0.0])];
        let asking = Asking::default();
        let scene = Scene::new(&asking, &lots);
        let error = scene.generate(&Settings::default()).expect_err("a wrong lot");
        assert!(error.shape == Some(1) && matches!(error.error, Error::Shape(_)), "{error:?}");
        let error = scene.generate_lot(1, &Settings::default()).expect_err("a wrong lot");
        assert!(error.shape == Some(1) && matches!(error.error, Error::Shape(_)), "{error:?}");
        assert!(scene.affected_by(1, &Settings::default()).is_ok_and(|list| list.contains(&1)));
    }
}

#[test]
fn a_wrong_lot_changes_no_model_before_its_error() {
    let lots = [0.0, 10.0, f64::NAN, 1e5].map(|x| square([x, 0.0, 0.0]));
    let asking = Asking::default();
    let scene = Scene::new(&asking, &lots).context_distance(50.0);
    let hidden = |at: usize| scene.generate_lot(at, &Settings::default()).map(|model| model.count("Hidden"));
    assert_eq!([0, 1, 3].map(|at| hidden(at).expect("a model")), [4, 4, 0]);
    let mut models = Vec::new();
    let error = scene.generate_each(&Settings::default(), |_, model| {
        models.push(model.count("Hidden"));
        std::ops::ControlFlow::Continue(())
    });
    assert_eq!((error.expect_err("a wrong lot").shape, models), (Some(2), vec![4, 4]));
}

#[test]
fn wrong_distances_count_as_zero() {
    let lots = [square([0.0; 3]), square([10.0, 0.0, 0.0]), square([20.5, 0.0, 0.0])];
    let asking = Asking::default();
    let hidden = |distance: f64| -> Vec<usize> {
        let scene = Scene::new(&asking, &lots).occlusion_distance(distance).context_distance(distance);
        let batches = scene.generate(&Settings::default()).expect("models");
        batches.into_iter().map(|batch| batch.sink.count("Hidden")).collect()
    };
    for distance in [f64::NAN, -1.0, 0.0, 1.0, f64::INFINITY] {
        assert_eq!(hidden(distance), [4, 4, 0], "{distance}");
    }
}

#[test]
fn a_limit_in_the_first_derivation_ends_the_run() {
    rules! {
        grammar Wasteful = r#"
            Lot --> label("a") Asks
            Asks --> case contextCount(intra, "a") == 0 : split(x) { 0.001 : label("b") X. }* else : Y.
        "#;
    }
    let few = Settings { limits: Limits { shapes: 1_000, ..Limits::default() }, ..Settings::default() };
    let lots = [square([0.0; 3])];
    let wasteful = Wasteful::default();
    let error = Scene::new(&wasteful, &lots).generate(&few).expect_err("a limit");
    assert!(matches!(error.error, Error::Limit { what: LimitKind::Shapes, .. }), "{error:?}");
    // Without the limit, the wasted shapes are not in the model.
    let model = Scene::new(&wasteful, &lots).generate_lot(0, &Settings::default()).expect("a model");
    assert_eq!((model.len(), model.count("Y")), (1, 1));
}

static WATCH: Mutex<Option<Watch>> = Mutex::new(None);
static PASSES: AtomicUsize = AtomicUsize::new(0);

/// Stops the run that calls it.
fn stopping() -> f64 {
    PASSES.fetch_add(1, Ordering::SeqCst);
    WATCH.lock().expect("a watch").iter().for_each(Watch::stop);
    1.0
}

#[test]
fn a_stop_in_the_first_derivation_ends_the_run_without_leaves() {
    cga! {
        grammar Stopped;
        Lot   --> split(x) { { 0.0001 : Slice }* }
        Slice --> extrude(crate::scene_hostile::stopping()) label("a") Face
        Face  --> case contextCount(intra, "a") == 0 : First. else : Second.
    }
    for is_scene in [false, true] {
        let watch = Watch::new();
        *WATCH.lock().expect("a watch") = Some(watch.clone());
        PASSES.store(0, Ordering::SeqCst);
        let settings = Settings { watch: Some(watch), ..Settings::default() };
        let (stopped, lot) = (Stopped::default(), square([0.0; 3]));
        let model = if is_scene {
            Scene::new(&stopped, std::slice::from_ref(&lot)).generate_lot(0, &settings)
        } else {
            cga::Grammar::generate_with(&stopped, &lot, &settings).map_err(Into::into)
        };
        let model = model.expect("no error");
        assert!(model.report().stopped && model.is_empty());
        // A derivation asks its watch after many shapes.
        let passes = PASSES.load(Ordering::SeqCst);
        assert!(passes <= 16_384, "{passes}");
    }
}

#[test]
fn rules_that_ask_for_their_own_labels_end() {
    // Each derivation asks the one before it, so a rule cannot wait for itself.
    rules! {
        grammar Circle = r#"
            Lot --> case contextCount(all, "a") == 0 : label("a") A else : A
            A --> print(contextCount(all, "a") + ";" + contextCount(intra, "a") + ";" + contextCount(inter, "a")) X.
        "#;
    }
    let lots = [square([0.0; 3]), square([10.0, 0.0, 0.0])];
    let batches = Scene::new(&Circle::default(), &lots).generate(&Settings::default()).expect("models");
    for batch in batches {
        // A neighbour's own queries are answered without the neighbours, so it finds its label and does not leave it again.
        assert_eq!(crate::lines(&batch.sink), ["1;1;0"]);
    }
}
