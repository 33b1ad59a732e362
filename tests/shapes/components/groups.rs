//! Groups and materials of assets through operations that make or divide faces (*CGA changelog 2021.0 and 2021.1*).

use cga::mesh::FaceTag;
use cga::{Color, Material, Mesh, MeshBuilder, Shape, cga};

use super::run;

cga! {
    @Allow(rule_not_reached)
    grammar Grouped;

    // The names on the faces of all parts.
    @StartRule Names --> print(geometry.groups()) print(geometry.materials()) NIL
    Comp --> comp(f) { all : Names }
    Split --> split(x) { ^0.5 : Names | ~1 : Names }
    SplitArea --> splitArea(x) { ^0.5 : Names | ~1 : Names }
    Extrude --> extrude(2) Names
    Taper --> taper(2) Names
    Offset --> offset(-0.5) Names
    Outwards --> offset(0.5, border) Names
    Hip --> roofHip(30, 0.5) Names
    Gable --> roofGable(30, 0.5, 0.5) Names
    Pyramid --> roofPyramid(30) Names
    Shed --> roofShed(30) Names
    Ridge --> roofRidge(byAngle, 30) Names
    Envelope --> envelope(normal, 9, 1, 60, 2, 50) Names
    Setback --> setback(1) { front : Names | left : Names | remainder : Names }
    PerEdge --> setbackPerEdge(1) { front : Names | left : Names | remainder : Names }
    ToArea --> setbackToArea(20) { all : Names | remainder : Names }
    Sections --> splitAndSetbackPerimeter(1) { ~5 : 1 : Names }* { remainder : Names }
    L --> shapeL(1, 1) { shape : Names | remainder : Names }
    U --> shapeU(1, 1, 1) { shape : Names | remainder : Names }
    O --> shapeO(1, 1, 1, 1) { shape : Names | remainder : Names }
    Rectangle --> innerRectangle(edge) { shape : Names | remainder : Names }
    Convex --> convexify Names
}

/// A concave face of a group and with a material.
fn grouped(group: &str, material: &str) -> Mesh {
    let mut builder = MeshBuilder::new();
    let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [5.0, 5.0], [5.0, 9.0], [0.0, 9.0]];
    let points = corners.map(|[x, z]| builder.point([x, 0.0, -z]));
    builder.face(&points, &[], FaceTag { group: 0, material: 0, ..FaceTag::PLAIN });
    let mut look = Material::default();
    (look.name, look.color) = (Some(material.into()), Some(Color::new(1.0, 0.5, 0.0)));
    builder.groups([group.to_owned()]).materials([look]);
    builder.build().expect("a face")
}

const RULES: [&str; 22] = [
    "Comp",
    "Split",
    "SplitArea",
    "Extrude",
    "Taper",
    "Offset",
    "Outwards",
    "Hip",
    "Gable",
    "Pyramid",
    "Shed",
    "Ridge",
    "Envelope",
    "Setback",
    "PerEdge",
    "ToArea",
    "Sections",
    "L",
    "U",
    "O",
    "Rectangle",
    "Convex",
];

#[test]
fn new_faces_have_the_group_and_material_of_their_face() {
    let shape = Shape::mesh(grouped("lawn", "grass"));
    for rule in RULES {
        let lines = super::lines(&run(&Grouped::default(), rule, &shape));
        assert!(2 <= lines.len(), "{rule}");
        for pair in lines.chunks(2) {
            assert_eq!(pair, ["(1)[lawn]", "(1)[grass]"], "{rule}");
        }
    }
}
