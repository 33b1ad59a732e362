//! *shapeL, shapeU, shapeO operations* and *taper operation*.

use cga::glam::DVec3;
use cga::{Mesh, Model, Settings, Shape, cga};

use cga_tests::pages::wings;

cga! {
    grammar Wings = r##"
    # shapeL, shapeU, shapeO operations
    @StartRule
    Left --> shapeL(4, 4) { shape     : Strip.
                          | remainder : Rest. }
    @StartRule
    Middle --> shapeU(4,4,4) { shape : Strip. | remainder : Rest. }
    @StartRule
    Right  --> shapeO(4,4,4,4) { shape : Strip. | remainder : Rest. }

    attr myFrontDepth = 5
    attr myLeftWidth = 11
    @StartRule
    Lot -->
        offset(-3, inside)
        shapeL(myFrontDepth,myLeftWidth) { shape : Footprint | remainder: NIL }
    attr myRightWidth = 3
    @StartRule
    LotU -->
        offset(-3, inside)
        shapeU(myFrontDepth,myRightWidth,myLeftWidth) { shape : Footprint | remainder: NIL }
    attr myBackDepth = 2
    @StartRule
    LotO -->
        offset(-3, inside)
        shapeO(myFrontDepth,myRightWidth,myBackDepth,myLeftWidth) { shape : Footprint | remainder: NIL }
    Footprint -->
        extrude(10) color(1,0,0)
    # Lots of another form, and turned ones.
    @StartRule
    OddL    --> offset(-3, inside) shapeL(5, 11) { shape : Wings }
    @StartRule
    OddU    --> offset(-3, inside) shapeU(5, 3, 11) { shape : Wings }
    @StartRule
    OddO    --> offset(-3, inside) shapeO(5, 3, 2, 11) { shape : Wings }
    @StartRule
    TurnedL --> r(10, 23, 5) OddL
    @StartRule
    TurnedU --> r(10, 23, 5) OddU
    @StartRule
    TurnedO --> r(10, 23, 5) OddO
    Wings   --> extrude(10) Checked
    Checked --> case geometry.isClosedSurface : Closed. else : Open.

    # Without a remainder arm the rest is dropped.
    @StartRule
    Dropped --> shapeO(1, 1, 1, 1) { shape = Strip. }

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

/// "Middle --> shapeU(4,4,4), Right --> shapeO(4,4,4,4)", on 20 x 20.
#[test]
fn a_u_and_an_o_of_a_square() {
    let lot = Shape::rectangle(20.0, 20.0);
    let model = run("Middle", &lot);
    assert_eq!((areas(&model, "Strip"), areas(&model, "Rest")), (vec![208.0], vec![192.0]));
    let model = run("Right", &lot);
    assert_eq!((areas(&model, "Strip"), areas(&model, "Rest")), (vec![256.0], vec![144.0]));
    assert_eq!(areas(&run("Dropped", &lot), "Strip"), [400.0 - 18.0 * 18.0]);
}

#[test]
fn the_examples_fill_three_and_four_sides_of_a_lot() {
    let lot = Shape::rectangle(46.0, 36.0);
    for (rule, court) in [("LotU", 26.0 * 25.0), ("LotO", 26.0 * 23.0)] {
        let model = run(rule, &lot);
        assert_eq!(model.leaves().len(), 1);
        let volume = model.volume();
        assert!((volume - 10.0 * (1200.0 - court)).abs() < 1e-6, "{rule}: {volume}");
    }
}

/// The lots of the pictures have any form. Wings follow their edges, at any place and in any rotation.
#[test]
fn lots_of_any_form_have_wings_that_are_closed() {
    let corners = [[0.0, 0.0], [46.0, -4.0], [50.0, 20.0], [30.0, 18.0], [28.0, 40.0], [-3.0, 37.0]];
    let at = |[x, z]: [f64; 2]| DVec3::new(x, 0.0, -z);
    let lot = Shape::mesh(Mesh::from_polygon(&corners.map(at), &[]).expect("a polygon")).at([300.0, 5.0, -70.0]);
    // The wing of the inner right edge ends on the line of the inner back edge, which stays in a U.
    for (rule, wings) in [("L", 1), ("U", 2), ("O", 1)] {
        let volumes = ["Odd", "Turned"].map(|start| {
            let model = run(&format!("{start}{rule}"), &lot);
            assert_eq!((model.count("Closed"), model.leaves().len()), (wings, wings), "{start}{rule}");
            model.volume()
        });
        assert!((volumes[0] - volumes[1]).abs() < 1e-6 && 0.0 < volumes[0], "{rule}: {volumes:?}");
    }
}

/// ":  Each polygon is put into a new shape. = All polygons corresponding to the selector are combined into one new shape."
#[test]
fn strips_of_several_faces_are_put_together() {
    let model = run("Faces", &Shape::rectangle(20.0, 30.0));
    // Edges that face the front belong to the walls on the left and on the right.
    assert_eq!(areas(&model, "Strips"), [40.0]);
    assert_eq!(areas(&model, "Each"), [200.0, 280.0, 200.0, 280.0]);
}

#[test]
fn a_taper_is_a_pyramid() {
    let model = run("Tapered", &Shape::rectangle(10.0, 8.0));
    assert!((model.volume() - 800.0 / 3.0).abs() < 1e-6);
}

/// The height is drawn, and a court as large as the lot without its margin of 3 m and the wings is left: the heights of the volume
/// and of the scope agree.
#[test]
fn the_examples_have_wings_along_slanted_edges() {
    let lot = (wings::l::EXAMPLE.start)().to_mesh().area();
    let mut last = 0.0;
    for example in [wings::l::EXAMPLE, wings::u::EXAMPLE, wings::o::EXAMPLE] {
        let model = example.model(&Settings::default());
        assert!(model.faults().is_empty() && model.leaves().len() == 1, "{}", example.title);
        let leaf = model.leaves().next().expect("a footprint");
        let height = leaf.size().y;
        assert!((10.0..=20.0).contains(&height) && leaf.mesh().0.is_closed());
        let area = model.volume() / height;
        assert!(last < area && area < 0.5 * lot, "{}: {area} of {lot}", example.title);
        last = area;
    }
    let taper = wings::tapered::EXAMPLE.model(&Settings::default());
    let face = (wings::tapered::EXAMPLE.start)().to_mesh().area();
    assert!((taper.volume() - face * 10.0 / 3.0).abs() < 1e-9);
}
