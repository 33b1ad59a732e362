//! *offset operation*, on a lot like the one of its pictures: offset polygons, border faces and how they look.

use cga::{Model, Shape, cga};

cga! {
    grammar Offsets = r#"
    attr distance = -1

    # Both selectors at once: what looks up is kept apart from what looks down.
    @StartRule
    Lot  --> offset(distance) comp(f) { top : Up. | bottom : Down. }
    @StartRule
    All --> offset(distance, all) P.
    @StartRule
    Inside --> offset(distance, inside) P.
    @StartRule
    Border --> offset(distance, border) P.

    # setback operation
    @StartRule
    Building --> offset(-3, inside)
                 extrude(world.up, 12)
    "#;
}

/// Nine edges, with a notch at the back.
fn lot() -> Shape {
    let outline = [
        [0.0, 0.0],
        [6.0, 2.5],
        [12.0, 0.0],
        [13.0, -5.0],
        [9.0, -9.0],
        [6.5, -8.0],
        [8.0, -4.0],
        [5.5, -3.0],
        [-2.0, -7.0],
    ];
    Shape::footprint(&outline, &[]).expect("an outline")
}

fn run(rule: &str, distance: f64, shape: &Shape) -> Model {
    let model = Offsets { distance, ..Offsets::default() }.generate_from(rule, shape).expect("a model");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

/// "In the interior case, both the inside and the border faces are oriented counter-clockwise"; "in the exterior case, only
/// the blue face is": border faces look down.
#[test]
fn border_faces_look_down_where_the_offset_is_positive() {
    for (distance, up, down) in [(-1.0, 10, 0), (1.0, 1, 9)] {
        let model = run("Lot", distance, &lot());
        assert_eq!((model.count("Up"), model.count("Down")), (up, down), "{distance}");
    }
}

/// "Inside faces + Border faces = Original Face", the border faces being negative for positive distances.
#[test]
fn inside_and_border_make_the_lot() {
    let whole = lot().to_mesh().area();
    for distance in [-2.0, -1.0, -0.5, 1.0, 2.0, 3.0_f64] {
        let [all, inside, border] = ["All", "Inside", "Border"].map(|rule| run(rule, distance, &lot()).area());
        assert!((inside - border * distance.signum() - whole).abs() < 1e-9, "{distance}");
        assert!((all - inside - border).abs() < 1e-9);
    }
    // As in the pictures the polygon falls apart and is gone, and the notch closes.
    let faces = |rule: &str, distance: f64| {
        run(rule, distance, &lot()).leaves().map(|leaf| leaf.mesh().0.face_count()).sum::<usize>()
    };
    assert_eq!([-1.0, 1.0, 3.0].map(|distance| faces("Inside", distance)), [1; 3]);
    assert_eq!([-9.0, 3.0].map(|distance| faces("Border", distance)), [9; 2]);
}

/// *CGA changelog 2022.1*: "In case the inside selector was used but no inside faces were created due to a too large
/// (negative) offset. Now the original geometry is kept."
#[test]
fn too_large_an_offset_keeps_the_lot() {
    assert!((run("Inside", -9.0, &lot()).area() - lot().to_mesh().area()).abs() < 1e-9);
}

#[test]
fn a_building_stands_back_from_its_lot() {
    let model = run("Building", 0.0, &Shape::rectangle(20.0, 16.0));
    assert_eq!((model.len(), model.volume()), (1, 14.0 * 10.0 * 12.0));
}
