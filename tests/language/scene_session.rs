//! Runs of a part of a scene, one after another.

use cga::{Error, Grammars, Model, Scene, Settings, Shape, cga};

use crate::scene_laws::{District, lots};

cga! {
    grammar Houses = r#"
        attr height = 10
        @StartRule Lot --> extrude(height) comp(f) { side : Facade | top : Roof. }
        Facade --> case touches(inter) : Wall. else : Window.
        @StartRule Broken --> Endless(1)
        Endless(n) --> case n < 0 : X. else : Endless(n + 1)
    "#;
}

#[test]
fn models_equal_the_models_of_the_scene_in_any_order() {
    let (district, lots) = (District::default(), lots());
    let scene = Scene::new(&district, &lots).occlusion_distance(4.0).context_distance(4.0);
    let batches = scene.generate(&Settings::default()).expect("models");
    let expected: Vec<Model> = batches.into_iter().map(|batch| batch.sink).collect();
    let mut session = scene.session(&Settings::default()).expect("a session");
    for at in (0..lots.len()).rev().step_by(2) {
        let mut model = Model::new();
        let report = session.run(at, &mut model).expect("a model");
        assert!(model.leaves().eq(expected[at].leaves()) && report.faults() == expected[at].faults());
    }
    assert!(matches!(session.run(lots.len(), &mut Model::new()), Err(Error::Shape(_))));
}

#[test]
fn a_neighbour_that_fails_takes_no_other_with_it() {
    let lot = |at: u32| Shape::rectangle(10.0, 10.0).at([f64::from(at) * 10.0, 0.0, 0.0]);
    let lots = [lot(0), lot(1).start("Broken"), lot(2), lot(3)];
    let grammars = Grammars::new().with(Houses::default());
    let scene = Scene::of_grammars(&grammars, &lots);
    let mut session = scene.session(&Settings::default()).expect("a session");
    let mut walls = |at: usize| {
        let mut model = Model::new();
        session.run(at, &mut model).map(|_| ["Window", "Wall"].map(|rule| model.count(rule)))
    };
    assert_eq!(walls(0), Ok([4, 0]));
    assert!(walls(1).is_err());
    assert_eq!([walls(2), walls(3)], [Ok([3, 1]), Ok([3, 1])]);
}
