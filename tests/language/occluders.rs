//! The shapes that occlusion queries find (*occlusion queries*, *label operation*, *comp operation*, *offset operation*).
//!
//! The comments have the numbers of a list of facts from the reference.

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::glam::DVec3;
use cga::mesh::MeshBuilder;
use cga::{FaultKind, Mesh, Model, Scene, Settings, Shape, cga};

use crate::{clean, leaves, lines, rules};

fn model_of(grammar: &dyn cga::Grammar) -> Model {
    clean(grammar.generate(&Shape::rectangle(10.0, 10.0)).expect("a model"))
}

cga! {
    grammar Kinds = r#"
        attr kind = ""
        attr name = ""
        // A probe of 1 m is in the middle of what each kind makes.
        Lot --> split(x) { ~1 : Made | 0 : NIL } [ t(4, 1, 4) s(1, 1, 1) primitiveCube() Probe ]
        Probe --> case overlaps(intra, name) : Hidden. else : Free.
        Made -->
            case kind == "leaf" : extrude(5) Solid.
            case kind == "comp" : extrude(5) comp(f) { top : Roof. | bottom : NIL | side : NIL }
            case kind == "comp without parts" : extrude(5) comp(f) { 99 : Roof. }
            case kind == "comp of a lot" : comp(f) { all : t(0, 1.5, 0) Face. }
            case kind == "offset with faces" : extrude(5) offset(-1, inside) NIL
            case kind == "offset" : extrude(5) offset(-1) NIL
            case kind == "offset all" : extrude(5) offset(-1, all) NIL
            case kind == "split" : extrude(5) split(x) { '1 : NIL }
            case kind == "setback" : t(0, 1.5, 0) setback(1) { all : NIL }
            case kind == "label" : extrude(5) label("a") NIL
            case kind == "label of a lot" : t(0, 1.5, 0) label("a") NIL
            case kind == "nil" : extrude(5) NIL
            case kind == "modify" : extrude(5) modify(f) { top : t(0, 0, 1) Face. } NIL
            case kind == "inline" : [ inline(append) { extrude(5) comp(f) { all : Face. } } NIL ]
            case kind == "gable" : roofGable(60) Solid.
            case kind == "gable with eaves" : roofGable(60, 1, 1) Solid.
            else : NIL
    "#;
}

/// True if the probe finds a kind of shapes with a label.
fn finds(kind: &str, name: &str) -> bool {
    let model = model_of(&Kinds { kind: kind.to_owned(), name: name.to_owned() });
    model.count("Hidden") == 1
}

#[test]
fn leaves_divided_and_labelled_solids_occlude() {
    // Facts 1, 3, 6, 9, 11, 12.
    for kind in ["leaf", "comp", "comp without parts", "offset with faces", "offset all", "label", "gable"] {
        assert!(finds(kind, ""), "{kind}");
    }
}

#[test]
fn other_shapes_do_not_occlude() {
    // Facts 2, 4, 5, 8, 9, 10, 12.
    for kind in [
        "",
        "comp of a lot",
        "offset",
        "split",
        "setback",
        "label of a lot",
        "nil",
        "modify",
        "inline",
        "gable with eaves",
    ] {
        assert!(!finds(kind, ""), "{kind}");
    }
}

#[test]
fn a_label_chooses_solids_and_open_shapes_stay_open() {
    // Fact 17.
    assert!(finds("label", "a") && !finds("label", "b") && !finds("leaf", "a") && !finds("label of a lot", "a"));
}

#[test]
fn an_empty_label_is_a_fault_and_leaves_no_shape() {
    // Facts 18 and 55.
    rules! {
        grammar Empty = r#"
            attr none = ""
            Lot --> label(none) print(contextCount(intra, none)) print(minimumDistance(intra, none)) print(contextCompare(intra, none, world.highest)) X."#;
    }
    let model = Empty::default().generate(&Shape::rectangle(1.0, 1.0)).expect("a model");
    assert_eq!(lines(&model), ["0", "inf", "0"]);
    let kinds: Vec<FaultKind> = model.faults().iter().map(|fault| fault.kind).collect();
    assert_eq!(kinds, [FaultKind::Value], "{:?}", model.faults());
}

#[test]
fn a_label_leaves_a_copy_of_the_shape_at_that_moment() {
    // Facts 16, 56 and 57: the copy is flat, it has the place before `t`, and it is found by the rule that leaves it and by the rules below.
    rules! {
        grammar Copied = r#"
            Lot --> label("a") t(0, 0, 5) print(minimumDistance(intra, "a")) Below
            Below --> t(0, 7, 0) print(rint(1000 * minimumDistance(intra, "a"))) print(contextCount(intra, "a")) X."#;
    }
    let model = clean(Copied::default().generate(&Shape::rectangle(2.0, 2.0)).expect("a model"));
    assert_eq!(lines(&model), ["3", "7616", "1"]);
}

#[test]
fn solids_of_a_bracket_have_the_place_of_their_rule() {
    // Fact 21: a bracket works on a copy of the shape, so a solid in it is the shape itself for the faces after it.
    cga! {
        grammar Brackets = r#"
            attr calls = false
            Lot --> extrude(10) Mass
            Mass --> [ comp(f) { top : Roof. } ] comp(f) { side : Wall } [ case calls : Annex else : t('1, 0, 0) label("annex") comp(f) { top : Roof. } ]
            Annex --> t('1, 0, 0) label("annex") comp(f) { top : Roof. }
            Wall --> case touches(intra) : Hidden. else : Free.
        "#;
    }
    let walls = |calls: bool| {
        let model = model_of(&Brackets { calls });
        [model.count("Hidden"), model.count("Free")]
    };
    assert_eq!(walls(false), [0, 4]);
    // A rule that the bracket calls has a place of its own.
    assert_eq!(walls(true), [1, 3]);
}

#[test]
fn surfaces_with_two_faces_at_each_edge_occlude_if_these_agree_on_a_side() {
    // Fact 4. Two cubes with a common edge are not closed by the page, and a cube with a turned face has no inside.
    let cube = |at: f64| (0..8).map(move |corner| [1, 2, 4].map(|axis| at + f64::from(u8::from(corner & axis != 0))));
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mesh = |turned: bool, is_double: bool| -> Mesh {
        let mut builder = MeshBuilder::new();
        let mut points: Vec<[f64; 3]> = Vec::new();
        let mut add = |builder: &mut MeshBuilder, corner: [f64; 3]| -> u32 {
            let known = points.iter().position(|point| *point == corner);
            known.map_or_else(
                || {
                    points.push(corner);
                    builder.point(corner)
                },
                |at| at as u32,
            )
        };
        for at in if is_double { 0..2 } else { 0..1 } {
            // The second cube has the edge at (1, 1, z) in common with the first one.
            let corners: Vec<u32> =
                cube(0.0).map(|[x, y, z]| add(&mut builder, [x + f64::from(at), y + f64::from(at), z])).collect();
            for (number, face) in faces.iter().enumerate() {
                let mut face = face.map(|corner| corners[corner]);
                if turned && number == 1 {
                    face.reverse();
                }
                builder.polygon(&face);
            }
        }
        builder.build().expect("a mesh")
    };
    rules! {
        grammar Asked = r#"
            Lot --> split(y) { '1 : print(geometry.isClosedSurface) Solid. } [ t(0.3, 0.3, 0.3) s(0.2, 0.2, 0.2) primitiveCube() Probe ]
            Probe --> case inside(intra) : Hidden. else : Free.
        "#;
    }
    let found = |mesh: Mesh| {
        let model = Asked::default().generate(&Shape::mesh(mesh)).expect("a model");
        (lines(&model).join(""), model.count("Hidden"))
    };
    assert_eq!(found(mesh(false, false)), ("true".to_owned(), 1));
    assert_eq!(found(mesh(false, true)), ("false".to_owned(), 0));
    assert_eq!(found(mesh(true, false)), ("true".to_owned(), 0));
}

#[test]
fn shapes_of_the_first_derivation_alone_are_not_seen_by_neighbours() {
    // Facts 14, 29 and 32.
    rules! {
        grammar Gone = r#"
            Lot --> split(z) { ~1 : Front | ~1 : Back }
            Front --> case contextCount(intra, "back") == 0 : extrude(10) Tower. else : extrude(1) Base.
            Back --> label("back") NIL
            @StartRule
            Ask --> print(touches(inter)) extrude(10) Up
            Up --> t(0, 5, 0) print(touches(inter)) X.
        "#;
    }
    let lots =
        [Shape::rectangle(10.0, 10.0).start("Lot"), Shape::rectangle(10.0, 10.0).at([10.0, 0.0, 0.0]).start("Ask")];
    let batches = Scene::new(&Gone::default(), &lots).generate(&Settings::default()).expect("models");
    let models: Vec<Model> = batches.into_iter().map(|batch| batch.sink).collect();
    assert_eq!(leaves(&models[0]), ["Base"]);
    assert_eq!(lines(&models[1]), ["false", "false"]);
}

#[test]
fn constants_and_attributes_may_ask_about_neighbours() {
    // Fact 26.
    rules! {
        grammar Asking = r#"
            attr near = minimumDistance(inter, "a")
            const sides = comp(fe) { all : minimumDistance(inter, "a") }
            const hidden = touches(inter)
            Lot --> label("a") print(near) print(sides) print(hidden) extrude(near) X.
        "#;
    }
    let lots: Vec<Shape> = (0..2).map(|at| Shape::rectangle(4.0, 4.0).at([f64::from(at) * 7.0, 0.0, 0.0])).collect();
    let model = Scene::new(&Asking::default(), &lots).generate_lot(0, &Settings::default()).expect("a model");
    assert_eq!(lines(&model), ["3", "(4)[3,3,3,7]", "false"]);
    assert_eq!(model.bounds().high, DVec3::new(4.0, 3.0, 4.0));
}

#[test]
fn each_target_finds_its_own_shapes() {
    // Facts 7 and 23: inserted assets are leaves; without a target both count.
    rules! {
        grammar Targets = r#"
            attr kind = "none"
            Lot --> [ t(2, 0, 2) s(6, 5, 6) Own ] [ t(4, 1, 4) s(1, 1, 1) primitiveCube() Probe ]
            Own --> case kind == "own" : i("builtin:cube") Solid. else : NIL
            Probe --> print(overlaps(intra) + ";" + overlaps(inter) + ";" + overlaps(all) + ";" + overlaps()) NIL
            @StartRule
            Over --> t(-8, 0, 0) extrude(5) Solid.
        "#;
    }
    let answers = |kind: &str| {
        let lots = [
            Shape::rectangle(10.0, 10.0).start("Lot").attribute("kind", kind),
            Shape::rectangle(10.0, 10.0).at([10.0, 0.0, 0.0]).start("Over"),
        ];
        let lots = if kind == "over" { &lots[..] } else { &lots[..1] };
        let model = Scene::new(&Targets::default(), lots).generate_lot(0, &Settings::default()).expect("a model");
        lines(&model).join(" ")
    };
    assert_eq!(answers("none"), "false;false;false;false");
    assert_eq!(answers("own"), "true;false;true;true");
    assert_eq!(answers("over"), "false;true;true;true");
}

#[test]
fn ranks_and_counts_of_neighbours_leave_out_the_own_shapes() {
    // Facts 63 to 66: a shape without the label has a rank, too, and a rank is the number of shapes that are better.
    rules! {
        grammar Ranked = r#"
            attr height = 1
            Lot --> extrude(height) label("tower") print(ranks) X.
            ranks = contextCompare(inter, "tower", world.highest) + ";" + contextCompare(inter, "tower", world.northernmost)
            @StartRule
            Asks --> print(contextCompare(inter, "tower", world.highest) + ";" + contextCount(inter, "tower")) X.
        "#;
    }
    let lot = |at: usize| {
        let place = [20.0 * at as f64, 0.0, at as f64];
        Shape::rectangle(5.0, 5.0).at(place).attribute("height", [3.0, 9.0, 9.0, 1.0][at]).start("Lot")
    };
    let mut lots: Vec<Shape> = (0..4).map(lot).collect();
    lots.push(Shape::rectangle(5.0, 5.0).at([0.0, 4.0, 50.0]).start("Asks"));
    let batches = Scene::new(&Ranked::default(), &lots).generate(&Settings::default()).expect("models");
    let all: Vec<String> = batches.iter().map(|batch| lines(&batch.sink).join("")).collect();
    assert_eq!(all, ["2;0", "0;1", "0;2", "3;3", "2;4"]);
}

#[test]
fn closed_shapes_of_operands_are_not_found_and_keys_go_on() {
    // Facts 9 and 71.
    rules! {
        grammar Operands = r#"
            Lot --> inline(append) { extrude(5) comp(f) { all : Face. } } Part Part
            Part --> print(getTreeKey) X.
        "#;
    }
    assert_eq!(lines(&model_of(&Operands::default())), ["0;0;", "0;1;"]);
}
