//! *Geometry tagging*: the tags that operations give, and their propagation, to the numbers of the pictures.

use cga::{Model, Settings, Shape, cga};

use cga_tests::pages::example::Example;
use cga_tests::pages::tags as pages;

const BLUE: &str = "0399F5";
const GREEN: &str = "09DE1F";
const YELLOW: &str = "FADB19";
const PURPLE: &str = "8D09DE";
const ORANGE: &str = "FA9100";
const DARK_BLUE: &str = "0000E0";

fn model(example: Example) -> Model {
    let model = example.model(&Settings::default());
    assert!(model.faults().is_empty(), "{}: {:?}", example.title, model.faults());
    model
}

/// The numbers of leaves of a rule by colour.
fn colours(model: &Model, rule: &str) -> Vec<(String, usize)> {
    let mut found: Vec<(String, usize)> = Vec::new();
    for leaf in model.leaves().filter(|leaf| leaf.rule() == rule) {
        let colour = leaf.material().color.expect("a colour");
        let hex = [colour.r, colour.g, colour.b].map(|c| format!("{:02X}", (c * 255.0).round() as u8)).concat();
        match found.iter_mut().find(|(known, _)| *known == hex) {
            Some((_, count)) => *count += 1,
            None => found.push((hex, 1)),
        }
    }
    found.sort();
    found
}

fn check_bars(example: Example, expected: &[(&str, usize)]) {
    let mut expected: Vec<(String, usize)> = expected.iter().map(|(hex, count)| ((*hex).to_owned(), *count)).collect();
    expected.sort();
    assert_eq!(colours(&model(example), "Bar"), expected, "{}", example.title);
}

/// Six front edges make one strip; its ends have the tag of sides, one of them on an edge that was not set back.
#[test]
fn setbacks_tag_the_edges_of_shape_and_remainder() {
    check_bars(pages::setback_shape::EXAMPLE, &[(BLUE, 6), (GREEN, 6), (YELLOW, 2)]);
    // Four edges at the left and behind, and what is left of the right one.
    check_bars(pages::setback_remainder::EXAMPLE, &[(GREEN, 6), (YELLOW, 1), (PURPLE, 5)]);
}

/// Shape and remainder have their back edges in common, and each draws them.
#[test]
fn wings_tag_edges_as_setbacks_do() {
    check_bars(pages::wings_l::EXAMPLE, &[(BLUE, 2), (GREEN, 2 + 2), (YELLOW, 2), (PURPLE, 2)]);
    check_bars(pages::wings_u::EXAMPLE, &[(BLUE, 3), (GREEN, 3 + 3), (YELLOW, 2), (PURPLE, 1)]);
    check_bars(pages::wings_o::EXAMPLE, &[(BLUE, 4), (GREEN, 4 + 4)]);
}

/// The ridge and two eaves in four parts each, and three edges at both ends. New edges and vertices have no tags.
#[test]
fn a_split_keeps_tags_of_old_components() {
    let split = model(pages::split::EXAMPLE);
    assert_eq!(split.counts(), [("Bottom", 4), ("Side", 2), ("Top", 8), ("Cut", 6), ("Bar", 18), ("Ball", 6)]);
    assert_eq!(colours(&split, "Bar"), [(ORANGE.to_owned(), 18)]);
}

/// Each face of the roof becomes a volume whose faces all have its tags.
#[test]
fn faces_over_faces_have_their_tags() {
    let roof = model(pages::over_faces::EXAMPLE);
    assert_eq!(roof.counts(), [("Bottom", 6), ("Side", 2 * 5), ("Top", 2 * 6)]);
}

#[test]
fn faces_over_edges_and_edges_over_vertices_have_their_tags() {
    let edges = [("EdgeA", 4), ("EdgeB", 2)];
    let vertices = [("VertexA", 3), ("VertexB", 1)];
    let upright = [("UprightA", 3), ("UprightB", 1)];
    let counts = |faces: &[(&'static str, usize)], others: &[&[(&'static str, usize)]]| {
        others.iter().fold(faces.to_vec(), |list, more| [&list, *more].concat())
    };
    assert_eq!(model(pages::corner::EXAMPLE).counts(), counts(&[("Face", 1)], &[&edges, &vertices]));
    for (example, over_a, over_b, others) in [
        // The top and the bottom have no tags.
        (pages::extruded::EXAMPLE, 4, 2, 2),
        (pages::inset::EXAMPLE, 4, 2, 1),
        (pages::tapered::EXAMPLE, 4, 2, 1),
        (pages::corner_roof::EXAMPLE, 4, 2, 1),
        // Upright sides and slopes; the slopes meet below the top.
        (pages::corner_envelope::EXAMPLE, 8, 4, 1),
    ] {
        let model = model(example);
        let faces = [("FaceA", over_a), ("FaceB", over_b), ("Face", others)];
        let expected = counts(&faces, &[&edges, &upright, &vertices]);
        for (rule, count) in &expected {
            assert_eq!(model.count(rule), *count, "{}: {rule}", example.title);
        }
        assert_eq!(model.leaves().len(), expected.iter().map(|rule| rule.1).sum::<usize>());
        // The marks of edges lie along the old ones, and the marks of vertices at the old places.
        let old = self::model(pages::corner::EXAMPLE);
        for rule in ["EdgeA", "EdgeB", "VertexA", "VertexB"] {
            let places = |model: &Model| -> Vec<[i64; 3]> {
                let centre =
                    |leaf: cga::LeafView<'_>| leaf.scope().centre().to_array().map(|x| (x * 1e6).round() as i64);
                let mut places: Vec<_> = model.leaves().filter(|leaf| leaf.rule() == rule).map(centre).collect();
                places.sort_unstable();
                places
            };
            assert_eq!(places(&model), places(&old), "{}: {rule}", example.title);
        }
    }
}

#[test]
fn tags_of_edge_attributes_are_sampled_and_kept_by_setbacks() {
    check_bars(pages::attributes::EXAMPLE, &[(GREEN, 2), (DARK_BLUE, 2)]);
    check_bars(pages::sampled::EXAMPLE, &[(GREEN, 5), (DARK_BLUE, 7)]);
    // The front edges, their new places, and the ends on the side edges.
    check_bars(pages::kept_in_shape::EXAMPLE, &[(GREEN, 4), (DARK_BLUE, 2)]);
    check_bars(pages::kept_in_remainder::EXAMPLE, &[(GREEN, 2), (DARK_BLUE, 2)]);
}

/// "The side faces of a cube are projected along their normals onto the face edges of the initial shape."
#[test]
fn shapes_sample_the_edge_in_front_of_them() {
    let toward = |model: &Model, rule: &str| -> Vec<(String, [f64; 2])> {
        let centre = cga::glam::DVec3::new(10.0, 0.0, 10.0);
        let leaves = model.leaves().filter(|leaf| leaf.rule() == rule);
        leaves
            .map(|leaf| {
                let way = leaf.scope().centre() - centre;
                let colour = leaf.material().color.expect("a colour");
                (format!("{}{}{}", colour.r, colour.g, colour.b), [way.x, way.z])
            })
            .collect()
    };
    let colour_of = |[x, z]: [f64; 2]| match () {
        () if x.abs() < z => "110",
        () if z.abs() < x => "100",
        () if x.abs() < -z => "010",
        () => "001",
    };
    for (example, rule, count) in [(pages::walls::EXAMPLE, "Wall", 4), (pages::poles::EXAMPLE, "Pole", 22)] {
        let model = model(example);
        let found = toward(&model, rule);
        assert_eq!(found.len(), count);
        for (colour, way) in found {
            assert_eq!(colour, colour_of(way), "{}: {way:?}", example.title);
        }
    }
}

cga! {
    @Allow(rule_not_reached)
    grammar Attributes;
    @StartRule Lot --> comp(fe) { all : print(edgeAttr.getFloat("width")) Values }
    // Of another type, and without an attribute of that name.
    Values --> print(edgeAttr.getBool("wet")) print(edgeAttr.getString("width")) print(edgeAttr.getFloat("none")) NIL
    Tagged --> setTagsFromEdgeAttrs print(geometry.tags) NIL
    // The second call replaces the tags of the first one, but not the tags of others.
    Twice --> tag("edgeattr.other", edges) setTagsFromEdgeAttrs r(scopeCenter, 0, 180, 0) setTagsFromEdgeAttrs Edges
    Edges --> comp(fe) { all : print(geometry.tags) NIL }
    // Edges between two faces have the tags of both.
    Cube --> s(^0.5, 4, ^0.5) center(xz) primitiveCube setTagsFromEdgeAttrs
        comp(e) { vertical : print(geometry.tags("edgeattr", edges)) NIL }
    attr at_start = edgeAttr.getFloat("width")
    Start --> print(at_start) NIL
}

fn printed(start: &str, lot: &Shape) -> Vec<String> {
    let model = Attributes::default().generate_from(start, lot).expect("a model");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model.prints().iter().map(ToString::to_string).collect()
}

#[test]
fn edge_attributes_have_a_value_for_each_edge() {
    let lot = || Shape::rectangle(10.0, 6.0);
    let full = lot().edge_attribute("width", [3.0, 0.5, 2.0]).edge_attribute("wet", [true, false, true, true]);
    let lines = printed("Lot", &full);
    // The last edge has no width. Wrong types and unknown names give 0, false and an empty text.
    assert_eq!(lines[..4], ["3", "0.5", "2", "0"]);
    let others = ["true", "false", "true", "true"].map(|wet| [wet, "", "0"]).concat();
    assert_eq!(lines[4..], others);
    assert_eq!(printed("Lot", &lot()), [["0"; 4].to_vec(), ["false", "", "0"].repeat(4)].concat());
    // Only texts become tags.
    assert_eq!(printed("Tagged", &full), ["(0)[]"]);
    let named = lot()
        .edge_attribute("side", ["a.b", "c*", "", "a.b"])
        .edge_attribute("?", ["x"])
        .edge_attribute("width", [1.0; 4]);
    assert_eq!(printed("Tagged", &named), ["(3)[edgeattr..x,edgeattr.side.a.b,edgeattr.side.c]"]);
    let around = lot().edge_attribute("to", ["south", "east", "north", "west"]);
    let other = |to: &str| format!("(2)[edgeattr.other,edgeattr.to.{to}]");
    assert_eq!(printed("Twice", &around), ["north", "west", "south", "east"].map(other));
    assert_eq!(
        printed("Cube", &around),
        ["east,south", "south,west", "east,north", "north,west"].map(|both| {
            let tags: Vec<String> = both.split(',').map(|to| format!("edgeattr.to.{to}")).collect();
            format!("(2)[{}]", tags.join(","))
        })
    );
    // An attribute of the rules is computed on the lot itself, which faces up: the nearest edge, the first of equal ones.
    assert_eq!(printed("Start", &full), ["3"]);
}

cga! {
    @Allow(rule_not_reached)
    grammar Own;
    @StartRule Again --> extrude(2) tag("own") extrude(1) print(geometry.tags) NIL
    Roofs --> roofGable(30) tag("mine", edges) roofHip(30) print(geometry.tags("roof", faces)) print(geometry.tags("*", edges)) NIL
    Setbacks --> setback(1) { front : NIL | remainder : Inner }
    Inner --> print(geometry.tags("setback", edges)) setback(1) { all : NIL | remainder : print(geometry.tags) NIL }
    // The roofs' base is the same, and so is the setbacks'.
    attr kind = 0
    RoofAgain -->
        roofShed(30)
        print(geometry.tags("*", faces))
        [ case kind == 0 : roofGable(30) Faces
          case kind == 1 : roofHip(30) Faces
          case kind == 2 : roofPyramid(30) Faces
          else : roofRidge(byAngle, 30) Faces ]
    Faces --> print(geometry.tags("*", faces)) NIL
    SetbackAgain -->
        case kind == 0 : setback(1) { front : NIL | remainder : Around }
        case kind == 1 : shapeL(1, 1) { shape : NIL | remainder : Around }
        case kind == 2 : shapeU(1, 1, 1) { shape : NIL | remainder : Around }
        else : setbackToArea(30) { front : NIL | remainder : Around }
    Around --> print(geometry.tags("*", edges)) setback(0.2) { all : NIL | remainder : print(geometry.tags("*", edges)) NIL }
    // Tags that edges and vertices get in `modify` stay.
    Modified --> modify(fe) { 0 : split(x) { ^0.25 : tag("side") X. | ~1 : tag("outset") X. } | 1 : tag("whole") X. | 2 : tag("gone") NIL }
        print(geometry.tags("*", edges)) extrude(1)
        comp(f) { isTagged("side") : Side. | isTagged("outset") : Outset. | isTagged("whole") : Whole. }
    ModifiedVertices --> modify(v) { 0 : tag("corner") X. | 1 : t(1, 0, 0) tag("moved") X. }
        print(geometry.tags("*", vertices)) extrude(1)
        comp(e) { geometry.hasTags("corner", edges) : primitiveCube Upright. | geometry.hasTags("moved", edges) : primitiveCube Leaning. }
    Cleared --> tag("f") tag("e", edges) tag("v", vertices) [ Counted ] [ primitiveCube Counted ] [ footprint Counted ]
        [ resetGeometry Counted ] [ splitArea(x) { ^1 : Counted } ] [ extrude(1) splitArea(y) { ^1 : Counted } ]
        [ i("builtin:cube") Counted ] [ reduceGeometry(0.5) Counted ]
        [ setupProjection(0, scope.xz, ^1, ^1) projectUV(0) tag("f") insertAlongUV(0, "builtin:cube", 1) Counted ] NIL
    Counted --> print(geometry.tags) NIL
    // Inherited tags count for isTagged alone.
    Inherits --> tag("f") comp(e) { geometry.hasTags("f", edges) : primitiveCube Own. | isTagged("f") : primitiveCube Inherited. }
    FromEdges --> tag("e", edges) comp(v) { geometry.hasTags : primitiveCube Own. | isTagged("e") : primitiveCube Inherited. }
    FromBelow --> extrude(2) tag("e", edges) comp(f) { isTagged("e") : Own. | isTagged("e", e) : Edges. | all : Plain. }
    Ends --> tag("v", vertices) comp(e) { isTagged("v") : primitiveCube Own. | isTagged("v", v) : primitiveCube Ends. }
    Deleted --> tag("a.b", edges) tag("a.c", faces) deleteTags("a.b") comp(e) { isTagged("a.b") : primitiveCube Left. | isTagged("a") : primitiveCube Face. }
}

/// The prints of a rule with a value for `kind`.
fn own_with(start: &str, kind: usize) -> Vec<String> {
    let model = Own { kind: kind as f64 }.generate_from(start, &Shape::rectangle(8.0, 6.0)).expect("a model");
    assert!(model.faults().is_empty(), "{kind}: {:?}", model.faults());
    model.prints().iter().map(ToString::to_string).collect()
}

fn own(start: &str) -> (Vec<String>, Vec<(&'static str, usize)>) {
    let model = Own::default().generate_from(start, &Shape::rectangle(8.0, 6.0)).expect("a model");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    let counts = model.counts().into_iter().map(|(rule, count)| (&*rule.to_owned().leak(), count)).collect();
    (model.prints().iter().map(ToString::to_string).collect(), counts)
}

/// "Auto-tags applied by a certain operation remain accessible until the operation is called again."
#[test]
fn operations_replace_their_own_tags_alone() {
    assert_eq!(own("Again").0, ["(4)[extrude.bottom,extrude.side.outer,extrude.top,own]"]);
    // All roofs have the same base, so the pediments' tags are gone. Edges of the old roof give their tags to new faces.
    let (lines, _) = own("Roofs");
    assert_eq!(lines, ["(2)[roof.bottom,roof.top]", "(1)[mine]"]);
    let first = "(3)[setback.back,setback.remainder]".replace('3', "2");
    assert_eq!(own("Setbacks").0, [first, "(1)[setback.back]".into()]);
}

/// "All roof operations apply the same base tag"; setbacks do too.
#[test]
fn operations_of_a_family_replace_the_tags_of_each_other() {
    let shed = "(3)[roof.bottom,roof.side.outer,roof.top]";
    let plain = "(2)[roof.bottom,roof.top]";
    let second = ["(3)[roof.bottom,roof.side,roof.top]", plain, plain, shed];
    for (kind, second) in second.into_iter().enumerate() {
        assert_eq!(own_with("RoofAgain", kind), [shed, second], "{kind}");
    }
    for kind in 0..4 {
        let [first, second] = <[String; 2]>::try_from(own_with("SetbackAgain", kind)).expect("two lines");
        assert!(first.contains("setback.back"), "{kind}: {first}");
        assert_eq!(second, "(1)[setback.back]", "{kind}: {first}");
    }
}

#[test]
fn edges_and_vertices_keep_the_tags_that_they_get_in_modify() {
    let (lines, counts) = own("Modified");
    assert_eq!(lines, ["(3)[outset,side,whole]"]);
    assert_eq!(counts, [("Side", 1), ("Outset", 1), ("Whole", 1)]);
    let (lines, counts) = own("ModifiedVertices");
    assert_eq!(lines, ["(2)[corner,moved]"]);
    assert_eq!(counts, [("Upright", 1), ("Leaning", 1)]);
}

#[test]
fn operations_that_replace_geometry_clear_its_tags() {
    let none = "(0)[]";
    assert_eq!(own("Cleared").0, ["(3)[e,f,v]", none, none, none, none, none, none, none, none]);
}

#[test]
fn components_inherit_tags_from_those_above() {
    assert_eq!(own("Inherits").1, [("Inherited", 4)]);
    assert_eq!(own("FromEdges").1, [("Inherited", 4)]);
    // Faces never inherit, but their subcomponents can be asked.
    assert_eq!(own("FromBelow").1, [("Edges", 6)]);
    assert_eq!(own("Ends").1, [("Ends", 4)]);
    assert_eq!(own("Deleted").1, [("Face", 4)]);
}

cga! {
    grammar Case = r##"
    @Allow(unknown_tag)
    Lot --> extrude(3) comp(f) { top : tag("Roof.Flat") print(geometry.hasTags("Roof.Flat", faces)) print(geometry.hasTags("roof.flat", faces)) print(geometry.hasTags("Roof.*", faces)) X. }
    "##;
}

/// No page says that tags differ in more or less than their letters, so the case counts, as in names of rules.
#[test]
fn the_case_of_tags_counts() {
    let model = Case::default().generate(&Shape::rectangle(2.0, 2.0)).expect("a model");
    let prints: Vec<String> = model.report().prints().iter().map(|print| print.to_string()).collect();
    assert_eq!(prints, ["true", "false", "true"]);
}
