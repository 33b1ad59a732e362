//! *shapeL, shapeU, shapeO operations* and *taper operation*.

use cga::{Model, Shape, cga};

cga! {
    grammar Wings = r##"
    # shapeL, shapeU, shapeO operations
    @StartRule
    Left --> shapeL(4, 4) { shape     : Strip.
                          | remainder : Rest. }

    attr myFrontDepth = 5
    attr myLeftWidth = 11
    @StartRule
    Lot -->
        offset(-3, inside)
        shapeL(myFrontDepth,myLeftWidth) { shape : Footprint | remainder: NIL }
    Footprint -->
        extrude(10) color(1,0,0)

    # Several faces.
    @StartRule
    Faces --> extrude(10) comp(f) { side = Walls | all : NIL }
    Walls --> shapeL(2, 0) { shape = Strips. | remainder : Each. }

    # taper operation
    @StartRule
    Tapered --> taper(10)
    "##;
}

fn run(rule: &str, shape: &Shape) -> Model {
    let model = Wings::default().generate_from(rule, shape).expect("a model");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

/// The areas of the leaves of a rule.
fn areas(model: &Model, rule: &str) -> Vec<f64> {
    model.leaves_of(rule).map(|leaf| (leaf.area() * 1e6).round() / 1e6).collect()
}

/// "Select a number of edges, depending on predefined spatial selectors, and set them back."
#[test]
fn an_l_of_a_square() {
    let model = run("Left", &Shape::rectangle(20.0, 20.0));
    assert_eq!((areas(&model, "Strip"), areas(&model, "Rest")), (vec![144.0], vec![256.0]));
}

#[test]
fn the_example_fills_the_front_and_the_left_of_a_lot() {
    let model = run("Lot", &Shape::rectangle(46.0, 36.0));
    // 40 x 30 is left of the lot; the court has 29 x 25.
    assert_eq!(model.leaves().len(), 1);
    let volume = model.volume();
    assert!((volume - 10.0 * (1200.0 - 29.0 * 25.0)).abs() < 1e-6, "{volume}");
}

/// ":  Each polygon is put into a new shape. = All polygons corresponding to the selector are combined into one new shape."
#[test]
fn strips_of_several_faces_are_put_together() {
    let model = run("Faces", &Shape::rectangle(20.0, 30.0));
    // Edges that face the front are those of the walls on the left and on the right.
    assert_eq!(areas(&model, "Strips"), [40.0]);
    assert_eq!(areas(&model, "Each"), [200.0, 280.0, 200.0, 280.0]);
}

#[test]
fn a_taper_is_a_pyramid() {
    let model = run("Tapered", &Shape::rectangle(10.0, 8.0));
    assert!((model.volume() - 800.0 / 3.0).abs() < 1e-6);
}
