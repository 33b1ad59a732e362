//! Facts of occlusion and context queries that no example of a page shows (*CGA and its context*, *occlusion queries*).
//!
//! The comments have the numbers of a list of facts from the reference.

use std::sync::Arc;

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::mesh::MeshBuilder;
use cga::{Assets, Model, Scene, Settings, Shape, cga};

use crate::{clean, leaves, lines, rules};

/// The model of a lot of 10 m. There is an asset, a cube without its lid.
fn model_of(grammar: &dyn cga::Grammar) -> Model {
    let corners = [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1], [0, 1, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]];
    let mut builder = MeshBuilder::new();
    let points = corners.map(|corner| builder.point(corner.map(f64::from)));
    for face in [[0, 1, 2, 3], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0]] {
        builder.polygon(&face.map(|corner: usize| points[corner]));
    }
    let assets = Arc::new(Assets::new().with("open.obj", builder.build().expect("a mesh")));
    let settings = Settings { assets, ..Settings::default() };
    clean(grammar.generate_with(&Shape::rectangle(10.0, 10.0), &settings).expect("a model"))
}

fn models(scene: &Scene<'_>) -> Vec<Model> {
    let batches = scene.generate(&Settings::default()).expect("models");
    batches.into_iter().map(|batch| clean(batch.sink)).collect()
}

cga! {
    grammar Kinds = r#"
        attr kind = ""
        // A probe of 1 m, in a lot of 10 m.
        Lot --> split(x) { ~1 : Made | 0 : NIL } [ t(4, 1, 4) s(1, 1, 1) primitiveCube() Probe ]
        Probe --> case overlaps(intra) : Hidden. else : Free.
        Made -->
            case kind == "open asset" : s(10, 5, 10) i("open.obj") Leaf.
            case kind == "comp function" : extrude(5) print(size(comp(f) { all : 1 })) NIL
            case kind == "comp before nothing" : extrude(5) comp(f) { all : NIL }
            case kind == "shapeL" : extrude(5) shapeL(3, 3) { shape : NIL | remainder : NIL }
            case kind == "shapeU" : extrude(5) shapeU(3, 3, 3) { shape : NIL | remainder : NIL }
            case kind == "shapeO" : extrude(5) shapeO(3, 3, 3, 3) { shape : NIL | remainder : NIL }
            case kind == "splitArea" : extrude(5) splitArea(x) { '1 : NIL }
            case kind == "scatter" : extrude(5) scatter(volume, 3, uniform) { NIL }
            case kind == "innerRectangle" : extrude(5) innerRectangle(scope) { shape : NIL | remainder : NIL }
            case kind == "extruded faces" : comp(f) { all : extrude(10) Leaf. }
            case kind == "thin leaf below a comp" : extrude(5) comp(f) { bottom : extrude(-0.5) Leaf. }
            case kind == "label before nothing" : extrude(5) label("a") NIL
            else : NIL
    "#;
}

#[test]
fn solids_before_a_comp_and_labelled_ones_stay_without_leaves() {
    // Facts 8, 9, 11 and 12: the probe is in the solid before the `comp`, and not in the leaf of 0.5 m.
    let finds = |kind: &str| model_of(&Kinds { kind: kind.to_owned() }).count("Hidden") == 1;
    for kind in ["comp before nothing", "extruded faces", "thin leaf below a comp", "label before nothing"] {
        assert!(finds(kind), "{kind}");
    }
}

#[test]
fn other_operations_make_no_occluder_of_the_shape_before_them() {
    // Facts 5, 9 and 10.
    let kinds = ["open asset", "comp function", "shapeL", "shapeU", "shapeO", "splitArea", "scatter", "innerRectangle"];
    for kind in kinds {
        assert_eq!(model_of(&Kinds { kind: kind.to_owned() }).count("Hidden"), 0, "{kind}");
    }
}

rules! {
    grammar Blocks = r#"
        Lot --> extrude(10) print(touches(inter)) print(overlaps(inter)) X.
        @StartRule
        Over --> extrude(10) t(-4, 0, 0) X.
    "#;
}

#[test]
fn the_neighbourhood_is_a_distance_in_plan_between_initial_shapes() {
    // Fact 24: the second block overhangs the first lot by up to 4 m.
    let found = |gap: f64, distance: Option<f64>| {
        let lots = [
            Shape::rectangle(10.0, 10.0).start("Lot"),
            Shape::rectangle(10.0, 10.0).at([10.0 + gap, 0.0, 0.0]).start("Over"),
        ];
        let blocks = Blocks::default();
        let scene = Scene::new(&blocks, &lots);
        let scene = distance.map_or(scene, |metres| scene.occlusion_distance(metres));
        lines(&models(&scene)[0]).join(" ")
    };
    assert_eq!(found(3.0, None), "false false");
    assert_eq!(found(3.0, Some(3.0)), "true true");
    assert_eq!(found(3.0, Some(2.9)), "false false");
    assert_eq!(found(1.0, None), "true true");
    assert_eq!(found(1.1, None), "false false");
}

#[test]
fn corners_are_neighbours_by_their_euclidean_distance() {
    // Fact 24: gaps of 0.6 m in x and in z are 0.85 m, and gaps of 0.8 m are 1.13 m. The second block is moved over the first lot.
    rules! {
        grammar Corner = r#"
            Lot --> extrude(10) print(overlaps(inter)) X.
            @StartRule
            Over --> extrude(10) t(-4, 0, -4) X.
        "#;
    }
    let found = |gap: f64| {
        let lots = [
            Shape::rectangle(10.0, 10.0).start("Lot"),
            Shape::rectangle(10.0, 10.0).at([10.0 + gap, 0.0, 10.0 + gap]).start("Over"),
        ];
        lines(&models(&Scene::new(&Corner::default(), &lots))[0]).join(" ")
    };
    assert_eq!([found(0.6), found(0.8)], ["true", "false"]);
}

#[test]
fn the_first_derivation_has_the_answers_of_neighbours() {
    // Fact 30: the annex is there only because the neighbour is, and the wall that asks about its own shapes finds it.
    rules! {
        grammar Grown = r#"
            Lot --> extrude(10) Mass
            Mass --> [ t('1, 0, 0) Annex ] comp(f) { right : Wall | all : NIL }
            Annex --> case touches(inter, "tower") : X. else : NIL
            Wall --> case touches(intra) : Hidden. else : Free.
            @StartRule
            Tower --> t(0, 0, 10) extrude(10) label("tower") X.
        "#;
    }
    let lots =
        [Shape::rectangle(10.0, 10.0).start("Lot"), Shape::rectangle(10.0, 10.0).at([10.0, 0.0, 0.0]).start("Tower")];
    let found = |lots: &[Shape]| leaves(&models(&Scene::new(&Grown::default(), lots))[0]).join(" ");
    assert_eq!(found(&lots), "X Hidden");
    assert_eq!(found(&lots[..1]), "Free");
}

#[test]
fn all_queries_have_their_defaults_in_the_first_derivation() {
    // Facts 28 and 32: the first derivation leaves a label for each query that has its default, and the second one counts them.
    cga! {
        grammar Defaults = r#"
            Lot --> label("a") extrude(5) label("a") Mass
            Mass --> case contextCount(intra, "default") > 0 : Counted else : Defaults
            Counted --> print(contextCount(intra, "default")) X.
            Defaults --> [ case inside(intra) : NIL else : label("default") NIL ]
                [ case overlaps(intra) : NIL else : label("default") NIL ]
                [ case touches(intra) : NIL else : label("default") NIL ]
                [ case 1000 < minimumDistance(intra, "a") : label("default") NIL else : NIL ]
                [ case contextCount(intra, "a") == 0 : label("default") NIL else : NIL ]
                [ case contextCompare(intra, "a", area.smallest) == 0 : label("default") NIL else : NIL ]
        "#;
    }
    assert_eq!(lines(&model_of(&Defaults::default())), ["6"]);
}

#[test]
fn the_southernmost_shape_has_the_largest_z() {
    // Fact 64.
    rules! {
        grammar South = r#"
            Lot --> split(z) { ~1 : Row(split.index) }*
            Row(n) --> label("row") Compared(n)
            Compared(n) --> print(n + ":" + contextCompare(intra, "row", world.southernmost) + ";" + contextCompare(intra, "row", world.northernmost)) X.
        "#;
    }
    let model = clean(South::default().generate(&Shape::rectangle(3.0, 3.0)).expect("a model"));
    let mut found: Vec<(f64, String)> = model
        .leaves()
        .zip(lines(&model))
        .map(|(leaf, line)| (leaf.bounds().high.z, line.split_once(':').expect("a number").1.to_owned()))
        .collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert_eq!(found.iter().map(|(_, line)| line.as_str()).collect::<Vec<_>>(), ["2;0", "1;1", "0;2"]);
}
