//! Tags of edges and vertices through operations that no picture shows, and in every place and direction.

use cga::glam::{DAffine3, DMat3, DQuat, DVec3};
use cga::mesh::{FaceTag, TagSet};
use cga::{Mesh, MeshBuilder, Shape, cga};

use super::{lines, run};

cga! {
    @Allow(rule_not_reached)
    grammar Propagated;

    @StartRule Lot --> Seen
    Seen --> comp(fe) { all : print(str(comp.index) + " " + str(geometry.tags("*", edges)) + str(geometry.tags("*", vertices))) NIL }

    // Edges alone, and parts of them.
    Line --> comp(e) { 0 : split(x) { ^0.25 : Told | ~1 : Told } }
    Told --> print(geometry.tags("*", edges)) print(geometry.tags("*", vertices)) NIL
    Fence --> comp(e) { 0 : extrude(2) Walls }
    Walls --> print(geometry.tags("*", faces)) Seen
    Joined --> inline comp(e) { all = extrude(1) X. } print(geometry.tags("e", faces)) NIL
    Vertices --> comp(v) { all = print(geometry.tags) NIL }

    // Several leaves as one shape.
    Appended --> inline split(x) { ^0.5 : tag("left", edges) X. | ^0.5 : X. } print(geometry.tags) NIL
    Welded --> inline(recompose) split(x) { ^0.5 : tag("left", edges) X. | ^0.5 : tag("right", edges) X. } Seams
    Seams --> comp(e) { inside : print(geometry.tags("*", edges)) NIL }
    Modified --> modify(f) { all : t(0, 1, 0) X. } Seen

    // Parts of faces.
    Inner --> innerRectangle(scope) { shape : print("shape") Seen | remainder : print("rest") Seen }
    Holes --> comp(h) { all : Seen }
    Moved --> mirror(true, false, false) reverseNormals rotate(rel, scope, 10, 20, 30) t(1, 2, 3) s(^2, ^1, ^0.5) Seen
    Beyond --> offset(2, border) print(geometry.tags("e", edges)) comp(f) { 0 : print(geometry.tags("*", faces)) Seen }
    Inside --> offset(-1, inside) print(geometry.tags) NIL
}

fn tags(names: &[&str]) -> TagSet {
    TagSet::new(names.iter().copied())
}

/// A face with a tag `e.N` for each edge and `v.N` for each vertex, holes after the outline.
fn tagged(outline: &[[f64; 2]], holes: &[&[[f64; 2]]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut number = 0;
    let mut ring = |builder: &mut MeshBuilder, corners: &[[f64; 2]]| -> Vec<u32> {
        let points: Vec<u32> = corners.iter().map(|[x, z]| builder.point([*x, 0.0, -*z])).collect();
        for k in 0..points.len() {
            builder.edge_tags([points[k], points[(k + 1) % points.len()]], &tags(&[&format!("e.{number}")]));
            builder.vertex_tags(points[k], &tags(&[&format!("v.{number}")]));
            number += 1;
        }
        points
    };
    let outer = ring(&mut builder, outline);
    let holes: Vec<Vec<u32>> = holes.iter().map(|hole| ring(&mut builder, hole)).collect();
    let holes: Vec<&[u32]> = holes.iter().map(Vec::as_slice).collect();
    builder.face(&outer, &holes, FaceTag::PLAIN);
    builder.build().expect("a face")
}

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [8.0, 0.0], [8.0, 6.0], [0.0, 6.0]];

fn square() -> Shape {
    Shape::mesh(tagged(&SQUARE, &[]))
}

fn told(start: &str, shape: &Shape) -> Vec<String> {
    lines(&run(&Propagated::default(), start, shape))
}

#[test]
fn a_component_has_the_tags_of_the_initial_shape() {
    let expected = |k: usize| {
        let (low, high) = (k.min((k + 1) % 4), k.max((k + 1) % 4));
        format!("{k} (1)[e.{k}](2)[v.{low},v.{high}]")
    };
    assert_eq!(told("Lot", &square()), [0, 1, 2, 3].map(expected));
}

#[test]
fn edges_keep_tags_alone_and_in_parts() {
    assert_eq!(told("Line", &square()), ["(1)[e.0]", "(1)[v.0]", "(1)[e.0]", "(1)[v.1]"]);
    // The fence grows out of the edge, its posts out of the vertices.
    let fence = told("Fence", &square());
    assert_eq!(fence[0], "(2)[e.0,extrude.side.outer]");
    assert_eq!(fence[1..], ["0 (1)[e.0](2)[v.0,v.1]", "1 (1)[v.1](1)[v.1]", "2 (0)[](0)[]", "3 (1)[v.0](1)[v.0]"]);
    assert_eq!(told("Joined", &square()), ["(4)[e.0,e.1,e.2,e.3]"]);
    assert_eq!(told("Vertices", &square()), ["(4)[v.0,v.1,v.2,v.3]"]);
}

#[test]
fn leaves_of_operands_keep_their_tags() {
    let all = "e.0,e.1,e.2,e.3,left,v.0,v.1,v.2,v.3";
    assert_eq!(told("Appended", &square()), [format!("(9)[{all}]")]);
    // Both parts have the seam, and each has tagged it.
    assert_eq!(told("Welded", &square()), ["(2)[left,right]"]);
    assert_eq!(told("Modified", &square()), told("Lot", &square()));
}

#[test]
fn parts_on_an_edge_of_a_face_have_its_tags() {
    // The right side of the rectangle at the left is longer than edge 3, on which it is partly.
    let lot = [[0.0, 0.0], [10.0, 0.0], [10.0, 2.0], [6.0, 2.0], [6.0, 5.0], [0.0, 5.0]];
    let inner = told("Inner", &Shape::mesh(tagged(&lot, &[])));
    assert_eq!(
        inner,
        [
            "shape",
            "rest",
            "0 (1)[e.0](1)[v.0]",
            "1 (0)[](1)[v.4]",
            "2 (1)[e.4](2)[v.4,v.5]",
            "3 (1)[e.5](2)[v.0,v.5]",
            "0 (1)[e.1](2)[v.1,v.2]",
            "1 (1)[e.2](2)[v.2,v.3]",
            "2 (0)[](1)[v.3]",
            "3 (1)[e.0](1)[v.1]",
        ]
    );
}

#[test]
fn holes_have_edges_and_vertices_of_their_face() {
    let hole: &[[f64; 2]] = &[[2.0, 2.0], [2.0, 4.0], [4.0, 4.0], [4.0, 2.0]];
    let lines = told("Holes", &Shape::mesh(tagged(&SQUARE, &[hole])));
    assert_eq!(
        lines,
        ["0 (1)[e.4](2)[v.4,v.5]", "1 (1)[e.7](2)[v.4,v.7]", "2 (1)[e.6](2)[v.6,v.7]", "3 (1)[e.5](2)[v.5,v.6]"]
    );
}

#[test]
fn turning_over_keeps_tags_with_their_edges() {
    let mut moved = told("Moved", &square());
    let mut lot = told("Lot", &square());
    // Another number, because every face is turned over.
    for list in [&mut moved, &mut lot] {
        list.iter_mut().for_each(|line| *line = line[2..].to_owned());
        list.sort();
    }
    assert_eq!(moved, lot);
}

#[test]
fn offsets_hand_tags_on_outwards_too() {
    let lines = told("Beyond", &square());
    assert_eq!(lines[..2], ["(4)[e.0,e.1,e.2,e.3]", "(1)[e.0]"]);
    // The border faces down and begins with the old edge; its mitres have the tags of the corners.
    let mut edges = lines[2..].to_vec();
    edges.sort();
    assert_eq!(edges, ["0 (1)[e.0](2)[v.0,v.1]", "1 (1)[v.1](1)[v.1]", "2 (0)[](0)[]", "3 (1)[v.0](1)[v.0]"]);
    assert_eq!(told("Inside", &square()), ["(0)[]"]);
}

cga! {
    @Allow(rule_not_reached)
    grammar Turned;

    @StartRule Setback --> setback(1) { front : Parts("front") | left : Parts("left") | remainder : Parts("rest") }
    Two --> setback(1) { isTagged("e.0") : NIL | remainder : setback(0.5) { isTagged("setback.back") : Parts("back") | remainder : Parts("rest") } }
    Roof --> roofHip(40) Parts("roof")
    Mass --> extrude(3) Parts("mass")
    Spire --> taper(5) Parts("spire")
    Envelope --> envelope(normal, 6, 1, 60, 2, 50, 3, 70, 0, 60) Parts("envelope")
    Border --> offset(-0.7) Parts("border")
    Perimeter --> splitAndSetbackPerimeter(1) { ~3 : 0.5 : Parts("piece") | ~2 : 1 : Parts("deep") }* { remainder : Parts("rest") }
    Cut --> extrude(4) split(x) { ^0.3 : split(z) { ^0.4 : Parts("a") | ~1 : Parts("b") } | ~1 : Parts("c") }
    Parts(name) --> [ comp(f) { all : print(name + " f " + comp.index + str(geometry.tags("*", faces))) NIL } ]
        [ comp(e) { all : print(name + " e " + rint(scope.sx * 970.13) + str(geometry.tags("*", edges)) + str(geometry.tags("*", vertices))) NIL } ]
        NIL
}

/// The tags of all components do not depend on the place and the direction of the initial shape.
#[test]
fn tags_turn_with_the_initial_shape() {
    let lot = [[0.0, 0.0], [9.0, 1.0], [10.0, 7.0], [5.0, 5.0], [1.0, 9.0]];
    let hole: &[[f64; 2]] = &[[3.0, 3.0], [3.0, 4.0], [4.5, 3.5]];
    for (mesh, starts) in [
        (tagged(&lot, &[hole]), &["Setback", "Two", "Mass", "Spire", "Border", "Cut"][..]),
        (tagged(&lot, &[]), &["Setback", "Two", "Roof", "Envelope", "Perimeter", "Border", "Mass"]),
    ] {
        for start in starts {
            let at = |turn: DQuat, by: DVec3| {
                let map = DAffine3 { matrix3: DMat3::from_quat(turn), translation: by };
                lines(&run(&Turned::default(), start, &Shape::mesh(mesh.map(&map))))
            };
            let first = at(DQuat::IDENTITY, DVec3::ZERO);
            assert!(first.iter().any(|line| line.contains("e.")), "{start}");
            for turn in 1..6 {
                let turn = f64::from(turn);
                let axis = DVec3::new(0.3 * turn, 1.0, -0.2 * turn).normalize();
                let other = at(DQuat::from_axis_angle(axis, 0.9 * turn), DVec3::new(7.0, -3.0, 11.0) * turn);
                assert_eq!(other, first, "{start}, turn {turn}");
            }
        }
    }
}

cga! {
    @Allow(rule_not_reached, out_of_range)
    grammar Turns;

    // The first arm keeps the corner; the second one ends at the back of the first one.
    @StartRule Arms --> setback(2) { front : Told("front") | left : Told("left") | remainder : Told("rest") }
    Told(name) --> comp(fe) { all : print(name + " " + str(geometry.tags("*", edges))) NIL }
    Nothing --> setback(0) { front : NIL | remainder : Told("rest") }
    Twice --> setback(1) { front : NIL | remainder : setback(1) { back : Told("back") | remainder : Told("rest") } }
}

#[test]
fn ends_at_another_arm_are_sides() {
    let lot = Shape::rectangle(10.0, 8.0);
    let told = |start: &str| {
        let mut lines = lines(&run(&Turns::default(), start, &lot));
        lines.sort();
        lines
    };
    let line = |arm: &str, kind: &str| format!("{arm} (1)[setback.{kind}]");
    let expected = |list: &[(&str, &[&str])]| {
        let mut all: Vec<String> =
            list.iter().flat_map(|(arm, kinds)| kinds.iter().map(|kind| line(arm, kind))).collect();
        all.sort();
        all
    };
    assert_eq!(
        told("Arms"),
        expected(&[
            ("front", &["front", "side", "back", "side"]),
            ("left", &["side", "back", "side", "front"]),
            ("rest", &["back", "remainder", "remainder", "back"]),
        ])
    );
    assert_eq!(told("Nothing"), expected(&[("rest", &["remainder"; 4])]));
    // A new setback replaces the tags of the first one on every edge.
    assert_eq!(
        told("Twice"),
        expected(&[
            ("back", &["front", "side", "back", "side"]),
            ("rest", &["remainder", "remainder", "back", "remainder"]),
        ])
    );
}
