//! Operations below a repeat: templates with meshes are as what is derived at its place.

use std::collections::BTreeSet;
use std::sync::Arc;

use cga::{DynSession, Geometry, Limits, Model, Repeats, Settings, Shape, cga};
use cga_lang::ops::{Uses, all_functions, all_operations};

use crate::compare::{Outcome, Tolerance, difference};
use crate::exact;

/// A grammar with a start rule for each row: it makes a façade of parts, each with the operations of the row.
macro_rules! rows {
    ($($name:ident [$($operations:tt)*];)*) => {
        cga! {
            @Allow(missing_asset, old_spelling)
            grammar Rows;
            attr width = 0.7
            attr depth = rand(0.3, 0.4)
            Size(w, c) --> s(scope.sx * w, scope.sy, 0.2) primitiveCylinder(6) color(c) X.
            Glass --> 50% : color("#ffff00") Lit. else : Dark.
            // A drawn bay has no template, but its parts have.
            Bay --> 70% : split(x) { ~1 : Wall | 0.6 : split(y) { ~1 : Pane(width) | 0.4 : Pane(0.5) | 0.2 : Wall } } else : Wall
            Wall --> projectUV(0) Wall.
            Pane(part) --> [ set(trim.vertical, false) t(0, 0, -0.1) s(^part, ^1, 0.1) primitiveCube() reverseNormals() comp(f) { front : NIL | all : Reveal. } ]
                offset(-0.1) comp(f) { border : extrude(0.05) Frame. | inside : Dark. }
            $(
                @StartRule
                $name --> setupProjection(0, world.xy, 1.3, 0.7) extrude(4.7) comp(f) { side : split(x) { 0.3 : Edge. | { ~2 : split(y) { { ~1.5 : $($operations)* }* } }* } | top : X. }
            )*
        }

        const NAMES: &[&str] = &[$(stringify!($name)),*];
        const OPERATIONS: &str = stringify!($($($operations)*)*);
    };
}

rows! {
    Cube        [ s(scope.sx * 0.5, scope.sy * 0.5, 0.2) center(xy) primitiveCube() X. ];
    CubeSized   [ primitiveCube(0.5, 0.4, 0.3) X. ];
    Sphere      [ s(scope.sx * 0.5, scope.sy * 0.5, 0.5) center(xy) primitiveSphere(8, 5) X. ];
    Cylinder    [ s(scope.sx * 0.5, scope.sy * 0.5, 0.5) center(xy) primitiveCylinder(8) X. ];
    Cone        [ s(scope.sx * 0.5, scope.sy * 0.5, 0.5) primitiveCone(7) color("#ff0000") X. ];
    Disk        [ primitiveDisk(9) X. ];
    Quad        [ primitiveQuad() X. ];
    Reaching    [ s(scope.sx * 2, scope.sy, 0.5) center(x) primitiveCylinder(8) X. ];
    Taper       [ taper(0.4) X. ];
    Offset      [ offset(-0.1, inside) extrude(0.2) X. ];
    Border      [ offset(-0.1, border) X. ];
    Hip         [ roofHip(30, 0.1) X. ];
    HipParts    [ roofHip(30, 0.1) comp(f) { bottom : NIL | all : extrude(0.05) X. } ];
    Gable       [ roofGable(40, 0.1, 0.2) X. ];
    Shed        [ roofShed(10) X. ];
    Pyramid     [ roofPyramid(50) X. ];
    Ridge       [ roofRidge(byAngle, 20) X. ];
    Inner       [ innerRectangle(scope) { shape : A. | remainder : B. } ];
    Setback     [ setback(0.1) { front : A. | remainder : B. } ];
    SetbackAll  [ setback(0.1) { all : extrude(0.1) A. | remainder : B. } ];
    ShapeL      [ shapeL(0.2, 0.3) { shape : extrude(0.1) A. | remainder : B. } ];
    ShapeU      [ shapeU(0.2, 0.3, 0.2) { shape : A. | remainder : B. } ];
    ShapeO      [ shapeO(0.2, 0.3, 0.2, 0.3) { shape : A. | remainder : B. } ];
    Turned      [ r(10, 20, 30) X. ];
    TurnedAbout [ r(scopeCenter, 0, 20, 0) extrude(0.2) X. ];
    TurnedScope [ extrude(0.2) rotateScope(0, 30, 0) X. ];
    Mirrored    [ extrude(0.2) mirrorScope(true, false, false) split(x) { 0.2 : A. | ~1 : B. } ];
    Mirror      [ taper(0.5) mirror(true, false, true) X. ];
    Vertices    [ comp(v) { all : X. } ];
    Edges       [ comp(e) { all : X. } ];
    EdgeBeams   [ comp(e) { all : s(scope.sx, 0.1, 0.1) primitiveCube() X. } ];
    FaceEdges   [ extrude(0.2) comp(fe) { all : X. } ];
    Divided     [ s(scope.sx * 0.8, scope.sy * 0.8, 0.3) primitiveCylinder(12) split(y) { 0.3 : A. | ~1 : B. } ];
    DividedSide [ s(scope.sx * 0.8, scope.sy * 0.8, 0.3) primitiveCylinder(12) split(x) { 0.4 : A. | ~1 : comp(f) { all : B. } } ];
    Area        [ case geometry.area > 2 : A. else : extrude(geometry.area * 0.1) B. ];
    Rectangular [ case geometry.isRectangular(1) : A. else : B. ];
    Convex      [ shapeL(0.2, 0.3) { shape : convexify() comp(f) { all : A. } } ];
    Holes       [ shapeO(0.2, 0.2, 0.2, 0.2) { shape : deleteHoles() A. } ];
    Reversed    [ extrude(0.2) reverseNormals() X. ];
    Normals     [ s(scope.sx * 0.5, scope.sy * 0.5, 0.5) primitiveCylinder(8) setNormals(soft) X. ];
    Softened    [ s(scope.sx * 0.5, scope.sy * 0.5, 0.5) primitiveCylinder(8) softenNormals(50) X. ];
    Rectified   [ r(0, 0, 3) rectify(10) X. ];
    Tagged      [ extrude(0.2) comp(f) { front : tag("glass") A. | all : NIL } ];
    Untagged    [ extrude(0.2) comp(f) { front : tag("glass") deleteTags() A. | all : tag("wall") deleteTags("wall") B. } ];
    Counted     [ extrude(0.2) report("n", geometry.nVertices + geometry.nEdges + geometry.nFaces + geometry.nHoles)
        report("m", geometry.volume + geometry.boundaryLength) X. ];
    Concave     [ case geometry.isConcave : A. else : extrude(0.1) B. ];
    Closed      [ case geometry.isClosedSurface : A. else : extrude(0.1) B. ];
    Planar      [ case geometry.isPlanar(1) : extrude(0.1) A. else : B. ];
    Instanced   [ case geometry.isInstanced : A. else : extrude(0.1) B. ];
    InnerOld    [ innerRect X. ];
    Materials   [ extrude(0.2) setMaterial(getMaterial(used, changed)) resetMaterial() X. ];
    Scope       [ Size(width, "#00ff00") ];
    Drawn       [ s(scope.sx, scope.sy, depth) primitiveCylinder(6) X. ];
    Chance      [ s(scope.sx * 0.5, scope.sy * 0.5, 0.1) primitiveCylinder(6) Glass ];
    ChanceSet   [ set(seedian, 7) Glass ];
    ChanceParts [ split(x) { ~1 : Glass | ~1 : set(seedian, 7) split(y) { ~1 : Glass | ~1 : [ t(0, 0, 0.1) Glass ] t(0, 0, 0.2) Glass } } ];
    World       [ extrude(0.2) comp(f) { world.up : A. | world.side : B. | all : C. } ];
    WorldOnce   [ comp(f) { world.south : A. | world.north : B. | all : C. } ];
    WorldTurned [ r(10, 20, 30) extrude(0.2) comp(f) { world.up : A. | world.east : B. | all : NIL } ];
    Aligned     [ alignScopeToAxes(y) extrude(0.1) X. ];
    AlignedAll  [ extrude(0.3) alignScopeToAxes(world.xyz) split(y) { 0.5 : A. | ~1 : B. } ];
    Upwards     [ r(30, 0, 0) extrude(world.up, 0.3) X. ];
    Footprint   [ r(30, 0, 0) footprint() X. ];
    Angle       [ r(30, 0, 0) extrude(geometry.angle(maxSlope) * 0.01) X. ];
    Azimuth     [ case geometry.angle(azimuth) > 0 : s(scope.sx, scope.sy, geometry.height) primitiveCylinder(6) A. else : B. ];
    AreaSouth   [ case geometry.area(world.south) > 1 : A. else : B. ];
    Object      [ alignScopeToAxes(object.y) X. ];
    Streets     [ extrude(0.2) comp(f) { object.front : A. | all : B. } ];
    Reported    [ report("parts", scope.sx) s(scope.sx, scope.sy, 0.2) primitiveCylinder(5) report("solids", 1) X. ];
    ReportedOn  [ report("parts", "before") Glass report("parts", "after") ];
    Framed      [ s(scope.sx * 0.3, scope.sy * 0.3, 1) center(xy) extrude(0.2) comp(f) { side : s(scope.sx * 1.5, scope.sy * 1.5, 0.1) center(xy) primitiveCube() X. | all : NIL } ];
    Missing     [ i("no/such.obj") X. ];
    Bays        [ Bay ];
    Projected   [ s(scope.sx * 0.5, scope.sy * 0.5, 0.2) primitiveCylinder(6) projectUV(0) X. ];
    Textured    [ projectUV(0) s(scope.sx * 0.5, scope.sy * 0.5, 0.2) extrude(0.1) comp(f) { all : X. } ];
    Flat        [ [ projectUV(0) X. ] extrude(0.1) comp(f) { front : X. | all : NIL } s(1, 1, 1) primitiveCone(5) X. ];
    Beyond      [ set(trim.vertical, false) s(scope.sx * 2, scope.sy, 0.5) center(x) primitiveCylinder(8) X. ];
    BeyondLevel [ set(trim.vertical, false) set(trim.horizontal, true) s(scope.sx, scope.sy * 2, 0.5) center(y) primitiveCylinder(8) X. ];
    BeyondTurned [ r(scopeCenter, 0, 0, 20) alignScopeToAxes(y) t(0.1, 0, -0.1) s(^0.5, ^0.5, 0.3) primitiveCylinder(7) X. ];
    Switched    [ set(trim.horizontal, !trim.horizontal) s(scope.sx, scope.sy * 2, 0.5) center(y) primitiveCylinder(8) X. ];
    Named       [ set(width, 0.3) Size(width, "#00ff00") ];
}

/// Houses at places that are no round numbers.
fn house() -> Shape {
    let (sin, cos) = (0.6, 0.8);
    let outline = [[0.0, 0.0], [9.3, 0.0], [9.3, 6.1], [0.0, 6.1]].map(|[x, z]| [x * cos - z * sin, x * sin + z * cos]);
    Shape::footprint(&outline, &[]).expect("an outline").at([117.3, 0.313, -1013.7])
}

fn run(start: &str, repeats: Repeats) -> Outcome {
    let settings = Settings { start: Some(start.to_owned()), repeats, ..Settings::default() };
    let mut model = Model::new();
    let report = Rows::default().run(&house(), &settings, &mut model);
    Outcome { model, report: report.map_err(|error| error.to_string()), replayed: 0 }
}

/// The number of leaves that are meshes, and of different meshes among them.
fn meshes(model: &Model) -> [usize; 2] {
    let mesh = |geometry| match geometry {
        Geometry::Mesh { mesh, .. } => Some(Arc::as_ptr(mesh).addr()),
        _ => None,
    };
    let meshes: Vec<usize> = model.leaves().filter_map(|leaf| mesh(leaf.geometry())).collect();
    [meshes.len(), meshes.iter().collect::<BTreeSet<_>>().len()]
}

#[test]
fn a_template_with_meshes_is_what_is_derived_at_its_place() {
    let mut wrong = Vec::new();
    for name in NAMES {
        let [kept, again, direct] = [Repeats::Kept, Repeats::Again, Repeats::Direct].map(|repeats| run(name, repeats));
        wrong.extend(exact::outcomes(&kept, &again).map(|text| format!("{name}, made again: {text}")));
        wrong.extend(
            difference(&kept, &direct, Tolerance { length: 1e-9 }).map(|text| format!("{name}, at its place: {text}")),
        );
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

cga! {
    grammar Switches;
    Lot --> extrude(4.7) comp(f) { front : set(trim.horizontal, true) Inner | back : Inner | left : set(trim.vertical, false) Inner | right : Inner }
    Inner --> split(y) { { ~1 : split(x) { { ~1 : Tile }* } }* }
    Tile --> s(^0.3, ^0.3, ^1) center(xy) extrude(0.2) comp(f) { side : s(^1.5, ^1.5, 0.1) center(xy) primitiveCube() X. | all : NIL }
}

#[test]
fn templates_differ_where_the_switches_of_trim_planes_do() {
    let [kept, direct] = [Repeats::Kept, Repeats::Direct].map(|repeats| {
        let settings = Settings { repeats, ..Settings::default() };
        let mut model = Model::new();
        let report = Switches::default().run(&Shape::rectangle(9.3, 6.1), &settings, &mut model);
        Outcome { model, report: report.map_err(|error| error.to_string()), replayed: 0 }
    });
    assert_eq!(difference(&kept, &direct, Tolerance { length: 1e-9 }), None);
}

cga! {
    grammar Limited;
    Lot   --> extrude(4.7) comp(f) { front : Split | back : Split | side : Split }
    Split --> split(x) { { ~2 : Tile }* }
    Tile  --> s(^1, ^1, 0.2) primitiveCylinder(6) report("tiles", 1) X.
}

#[test]
fn what_a_session_has_made_before_does_not_count() {
    for (vertices, bytes, reports) in
        [(60, 1 << 30, 100), (1 << 30, 20_000, 100), (1 << 30, 5_000, 100), (1 << 30, 1 << 30, 3)]
    {
        let limits = Limits { vertices, bytes, reports, ..Limits::default() };
        let run = |session: &mut dyn DynSession| {
            let mut model = Model::new();
            let report = session.run(&Shape::rectangle(9.3, 6.1), &mut model);
            Outcome { model, report: report.map_err(|error| error.to_string()), replayed: 0 }
        };
        let (grammar, settings) = (Limited::default(), Settings { limits, ..Settings::default() });
        let mut session = grammar.session(&settings).expect("a session");
        let first = run(&mut session);
        for repeats in [Repeats::Kept, Repeats::Again, Repeats::Direct] {
            let settings = Settings { repeats, ..settings.clone() };
            let alone = run(&mut grammar.session(&settings).expect("a session"));
            assert_eq!(difference(&first, &alone, Tolerance { length: 1e-9 }), None, "{limits:?}, {repeats:?}");
        }
        assert_eq!(exact::outcomes(&first, &run(&mut session)), None, "{limits:?}");
    }
}

#[test]
fn repetitions_share_their_meshes() {
    let shares = |name: &&&str| {
        let [all, different] = meshes(&run(name, Repeats::Kept).model);
        2 * different <= all
    };
    let alone: Vec<_> = NAMES.iter().filter(|name| !shares(name)).collect();
    // Three reach the trim planes, one reads the projection, and what has a fault is derived each time.
    assert_eq!(alone, [&"Reaching", &"Missing", &"Textured", &"BeyondLevel", &"Switched"]);
}

#[test]
fn all_operations_that_do_the_same_everywhere_are_compared() {
    let is_template = |uses: Uses| uses.has(Uses::BODY) && !uses.has(Uses::WHOLE);
    let operations = all_operations().filter(|row| is_template(row.uses)).map(|row| row.name);
    let functions = all_functions().filter(|row| is_template(row.uses)).map(|row| row.name);
    let missing: BTreeSet<&str> = operations.chain(functions).filter(|name| !OPERATIONS.contains(name)).collect();
    assert_eq!(missing, BTreeSet::new());
}
