//! Queries and outputs of rules: geometry, files, attributes of shapes, reports, prints.

use std::sync::Arc;

use cga::{Assets, FaultKind, Grammar, Limits, Mesh, Model, Settings, Shape, ValueType, cga};

use crate::rules;

/// The lines that a rule prints on a lot of 10 by 20 m.
fn printed(model: &Model) -> Vec<String> {
    assert_eq!(model.faults(), []);
    model.prints().iter().map(ToString::to_string).collect()
}

fn lot() -> Shape {
    Shape::rectangle(10.0, 20.0)
}

#[test]
fn a_report_counts_and_sums() {
    let rules = cga! {
        attr h = 1
        Lot --> extrude(h) report("myHeight", scope.sy) report("kind", "house") report("tall", scope.sy > 5) X.
    };
    let mut tall: Box<dyn Grammar> = Box::new(rules);
    tall.set_text("h", "10").expect("a number");
    let model = tall.generate(&lot()).expect("no limit");
    let summary = model.reported("myHeight").expect("reported").summary();
    assert_eq!((summary.count, summary.sum, summary.average()), (1, 10.0, Some(10.0)));
    assert_eq!(model.reports().of_type("tall", ValueType::Bool).expect("reported").summary().sum, 1.0);
    assert_eq!(model.reported("kind").expect("reported").texts().collect::<Vec<_>>(), [("house", 1)]);
}

#[test]
fn values_print_as_they_are() {
    let rules = cga! {
        const a = floatArray(splitString("0,1,2", ","))
        const b = boolArray(splitString("f,f,t", ","))
        const early = print("first")
        Lot --> print("x = " + str(a)) print(b) print(print(1.5) + 1) Part(early)
        Part(x) --> print(x == "first") NIL
    };
    let model = rules.generate(&lot()).expect("no limit");
    let lines: Vec<_> = model.prints().iter().map(|line| (line.rule.to_string(), line.to_string())).collect();
    let expected = [
        ("", "first"),
        ("Lot", "x = (3)[0,1,2]"),
        ("Lot", "(3)[false,false,true]"),
        ("Lot", "1.5"),
        ("Lot", "2.5"),
        ("Part", "true"),
    ];
    assert_eq!(lines, expected.map(|(rule, line)| (rule.to_owned(), line.to_owned())));
}

#[test]
fn the_report_of_the_reference_is_a_table() {
    // *report operation*, its rules on a box of four façades.
    cga! {
        grammar Windows;
        Lot --> extrude(30) comp(f) { side : Facade | top : Roof. }
        Facade --> report("facades", 1) split(y) { { ~5 : Floor | ~0.5 : Ledge. }* }
        Floor --> split(x) { { ~1 : Tile. | 2 : Window | ~1 : Tile. }* }
        Window -->
            40% : report("windowarea", geometry.area()) report("windows.open", 1) NIL
            else : report("windowarea", geometry.area()) report("windows.closed", 1) color("#aaffaa")
    }
    let model = Windows::default().generate(&Shape::rectangle(20.0, 20.0)).expect("no limit");
    let table = model.reports().to_string();
    let row = |name: &str| {
        let line = table.lines().find(|line| line.split_whitespace().next() == Some(name)).expect("a row");
        line.split_whitespace().skip(1).map(|cell| cell.parse::<f64>().expect("a number")).collect::<Vec<_>>()
    };
    assert!(table.starts_with("Report"));
    let names: Vec<_> = table.lines().skip(1).filter_map(|line| line.split_whitespace().next()).collect();
    assert_eq!(names, ["facades", "windowarea", "windows.closed", "windows.open", "windows"]);
    let (open, closed, all, area) = (row("windows.open"), row("windows.closed"), row("windows"), row("windowarea"));
    assert_eq!((row("facades")[0], all[0], all[0]), (4.0, 100.0, open[0] + closed[0]));
    assert_eq!((all[1], area[1]), (100.0, 0.0));
    assert!((open[1] - 100.0 * open[0] / all[0]).abs() < 0.1 && open[1] + closed[1] <= 100.0);
    // Five floors of 5.4545 m, windows of 2 m.
    assert!((area[4] - 2.0 * 60.0 / 11.0).abs() < 1e-9);
}

#[test]
fn geometry_is_asked_with_words_and_without() {
    let model = cga! {
        Lot --> print(geometry.area) print(geometry.isOriented(top)) extrude(5) Mass
        Mass -->
            print(geometry.area()) print(geometry.area(all)) print(geometry.area(world.up)) print(geometry.area(side))
            print(geometry.volume) print(geometry.height) print(geometry.nVertices) print(geometry.nEdges)
            print(geometry.nFaces) print(geometry.nHoles) print(geometry.isClosedSurface) print(geometry.isConcave)
            print(geometry.isRectangular(0.1)) print(geometry.isPlanar(0.25)) print(geometry.boundaryLength)
            print(geometry.angle(maxSlope) + geometry.angle(zenith)) print(geometry.isInstanced) X.
    };
    let lines = printed(&model.generate(&lot()).expect("no limit"));
    let expected = "200 true 700 700 200 300 1000 5 8 12 6 0 true false true true 0 90 false";
    assert_eq!(lines.join(" "), expected);
}

#[test]
fn coordinates_are_converted() {
    let model = cga! {
        Lot -->
            t(1, 2, 3)
            print(convert(x, scope, world, pos, 0, 0, 0)) print(convert(scope, world, pos, floatArray(splitString("0,0,0", ","))))
            print(convert(scope, pivot, pos, floatArray(splitString("0,0,1", ",")))) X.
    };
    let lines = printed(&model.generate(&lot().at([100.0, 0.0, 0.0])).expect("no limit"));
    assert_eq!(lines, ["101", "(3)[101,2,3]", "(3)[1,2,-16]"]);
}

#[test]
fn attributes_of_shapes_are_read_and_set() {
    let model = cga! {
        @Allow(missing_asset)
        Lot -->
            print(initialShape.name) print(initialShape.startRule) print(initialShape.origin.px)
            print(trim.vertical) set(trim.vertical, false) print(trim.vertical) print(trim.horizontal)
            set(pivot.py, 4) print(pivot.py) print(scope.elevation)
            set(seedian, 12) print(seedian)
            set(material.dirtmap, "dirt.png") set(material.dirtmap.su, 2) set(material.specular.g, 0.5)
            set(material.doubleSided, false) set(material.color.rgb, "#ff0000")
            print(material.dirtmap + material.dirtmap.su + material.dirtmap.sv + material.specular.g)
            print(material.doubleSided) print(material.color.rgb) Look
        Look -->
            resetMaterial() print(material.shininess + material.shader)
            setMaterial(splitString("color.r,0,roughness,0.25", ",")) print(getMaterial(shape, changed)) X.
    };
    let model = model.generate(&lot().at([5.0, 0.0, 0.0]).named("Lot 1")).expect("no limit");
    // There is no such image, but the attribute keeps its name.
    assert!(model.faults().len() == 1 && model.faults()[0].kind == FaultKind::Asset);
    let lines: Vec<String> = model.prints().iter().map(ToString::to_string).collect();
    let expected = "Lot 1|Lot|5|true|false|false|4|4|12|dirt.png210.5|false|#ff0000|1CityEngineShader|\
        (4x2)\n     color.b      1\n     color.g      1\n     color.r      0\n   roughness   0.25";
    assert_eq!(lines.join("|"), expected);
}

#[test]
fn equal_seeds_give_equal_numbers() {
    let model = cga! {
        Lot --> split(x) { { ~1 : set(seedian, split.index % 2) Draw }* }
        Draw --> print(rand(0, 1)) NIL
    };
    let lines = printed(&model.generate(&lot()).expect("no limit"));
    assert_eq!(lines.len(), 10);
    assert!((2..10).all(|at| lines[at] == lines[at - 2]) && lines[0] != lines[1]);
}

#[test]
fn files_are_found_and_measured() {
    let rules = cga! {
        @Allow(missing_asset)
        Lot -->
            print(fileSearch("*.obj")) print(filesSearch("Name=b*")) print(fileExists("a.obj")) print(fileExists("c.obj"))
            print(assetInfo("sub/b.obj", sx)) print(len(fileRandom("?.obj"))) print(assetNamingInfos("a.obj", g)) X.
    };
    let mesh = || {
        let corners = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(cga::glam::DVec3::from_array);
        Mesh::from_polygon(&corners, &[]).expect("a triangle")
    };
    let assets = Arc::new(Assets::new().with("a.obj", mesh()).with("sub/b.obj", mesh()));
    let model = rules.generate_with(&lot(), &Settings { assets, ..Settings::default() }).expect("no limit");
    assert_eq!(printed(&model), ["a.obj;sub/b.obj;", "(1)[sub/b.obj]", "true", "false", "3", "5", "(0)[]"]);
}

#[test]
fn a_flood_of_reports_and_lines_is_dammed() {
    let rules = cga! { Lot --> split(x) { { 0.01 : report("k" + split.index, 1) print(split.index) NIL }* } };
    let limits = Limits { reports: 10, prints: 20, ..Limits::default() };
    let model = rules.generate_with(&lot(), &Settings { limits, ..Settings::default() }).expect("no limit");
    let report = model.report();
    assert_eq!((model.reports().iter().len(), model.prints().len()), (10, 20));
    assert_eq!(model.reports().left_out(), 990 + report.prints_left_out() - 980);
    let kinds: Vec<_> = model.faults().iter().map(|fault| fault.kind).collect();
    assert_eq!(kinds, [FaultKind::Limit, FaultKind::Limit]);
}

#[test]
fn primitives_are_instances_until_they_are_changed() {
    rules! {
        grammar Instances = r#"
            version "2025.1"
            Lot --> [ extrude(2) Asked ] primitiveQuad() Asked s(5, 4, 3) primitiveCube() Asked t(1, 0, 0) r(0, 20, 0) s('2, '1, '1) Asked
                split(x) { ~1 : Asked | ~1 : i("builtin:cube") Asked } Parts
            Parts --> primitiveCube() split(x) { ~1 : Asked } [ comp(f) { top : Asked | bottom : primitiveQuad() Asked } ] mirror(true, false, false) Asked
                primitiveCube() comp(g) { all : Asked } comp(f) { all = Asked } comp(m) { all = Asked }
            Asked --> print(geometry.isInstanced) NIL
        "#;
    }
    for shape in [lot(), lot().held_as_meshes()] {
        let lines = printed(&Instances::default().generate(&shape).expect("no limit"));
        assert_eq!(lines.join(" "), "false true true true false true false false true false false false false");
    }
}

#[test]
fn the_group_of_an_initial_shape_is_its_name() {
    rules! {
        grammar Groups = r#"
            Lot --> Asked extrude(2) Asked split(x) { ~1 : Asked } comp(g) { all : Asked } [ primitiveCube() Asked ]
            Asked --> print(geometry.groups) NIL
        "#;
    }
    for shape in [lot().named("Lot 7"), lot().named("Lot 7").held_as_meshes()] {
        let mut lines = printed(&Groups::default().generate(&shape).expect("no limit"));
        lines.sort();
        assert_eq!(lines, ["(1)[Lot 7]", "(1)[Lot 7]", "(1)[Lot 7]", "(1)[Lot 7]", "(1)[]"]);
    }
    assert_eq!(printed(&Groups::default().generate(&lot()).expect("no limit")), ["(1)[]"; 5]);
}

#[test]
fn builtin_assets_are_always_there() {
    let model = cga! {
        Lot --> print(fileExists("builtin:uvtest.png")) print(fileExists("builtin:default")) print(fileExists("builtin:cube"))
            print(fileExists("builtin:none")) print(fileExists("uvtest.png")) X.
    };
    assert_eq!(printed(&model.generate(&lot()).expect("no limit")), ["true", "true", "true", "false", "false"]);
}

#[test]
fn a_split_of_several_edges_keeps_the_vertices_that_they_share() {
    rules! {
        grammar Edges = r#"
            Lot --> [ comp(e) { all = Split } ] extrude(5) [ comp(e) { all = Split } ] comp(fe) { all = Split }
            Split --> split(x) { 4 : Asked | ~1 : Asked }
            Asked --> print(str(geometry.nEdges) + "/" + geometry.nVertices) comp(e) { all = print(geometry.nVertices) NIL } NIL
        "#;
    }
    let lines = printed(&Edges::default().generate(&lot()).expect("no limit"));
    // A rectangle, a box, and a box with each edge twice, cut in two.
    let expected = ["3/4", "4", "3/4", "4", "8/8", "8", "8/8", "8", "16/8", "8", "16/8", "8"];
    let mut sorted = [lines.clone(), expected.map(str::to_owned).to_vec()];
    sorted.iter_mut().for_each(|list| list.sort());
    assert_eq!(sorted[0], sorted[1], "{lines:?}");
}
