//! *Shape recomposition*: `inline(recompose)` and `modify`.

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::glam::DVec3;
use cga::{Model, Settings, Shape, cga};

use crate::{clean, leaves, lines, rules, written};

cga! {
    grammar Recomposed = r##"
    @StartRule
    Topology -->
        primitiveCube
        print("start: " + geometry.nVertices)
        inline(recompose) comp(f) { all: SetColor }
        print("inline(recompose): " + geometry.nVertices)
    SetColor --> color(comp.index/comp.total, 0, 0)

    # The shapes of the reference's pictures.
    @StartRule
    FShape --> inline(recompose) split(x) { 10 : Moved(0) | ~1 : split(z) { 10 : X. | 10 : NIL }* } X.
    @StartRule
    FShapeMoved --> inline(recompose) split(x) { 10 : Moved(8) | ~1 : split(z) { 10 : X. | 10 : NIL }* } X.
    Moved(d) --> t(0, 0, d) X.
    @StartRule
    VertexMove --> modify(fe) { 0 : s('0.5, 0, 0) center(x) X. | 1 : s('0.6, 0, 0) center(x) X. } X.
    @StartRule
    SharedEdge --> inline(recompose) split(x) { '0.5 : Wide | '0.5 : Sixths } X.
    Wide --> s('1, '1, '1.5) center(z) split(z) { '1/3 : X. }*
    Sixths --> split(z) { '1/6 : X. }*
    @StartRule
    Slanted --> inline(recompose) split(x) { '0.5 : Long | '0.5 : Fifths } X.
    Long --> s('1, '1, '1.5)
    Fifths --> split(x) { '0.2 : X. }*
    @StartRule
    FourFaces --> inline(recompose) split(x) { '0.5 : split(z) { '0.5 : X. }* }* modify(f, noAlign) { all : t(0, 1, 0) X. } X.
    @StartRule
    Turned --> r(13, 27, 41) inline(recompose) split(x) { '0.3 : X. | ~1 : split(z) { '0.7 : X. }* } modify(fe) { all : split(x) { ~2.3 : X. }* } X.
    @StartRule
    Insets --> modify(fe) { all : split(x) { ~1 : X. | 1 : X. | 3 : t(0, 0, -2) X. | 1 : X. | ~1 : X. } } X.

    @StartRule
    ShiftedPlane --> inline(recompose) SplitAndTranslate X.
    SplitAndTranslate --> split(x) { ~1 : X. | ~1 : X. | ~1 : t(0, 2, 0) X. }
    @StartRule
    ShiftedTop --> extrude(5) modify(f, noAlign) { top : SplitAndTranslate } X.
    @StartRule
    ShiftedSides --> extrude(5) modify(f, noAlign) { top : SplitAndTranslateNIL } X.
    SplitAndTranslateNIL --> split(x) { ~1 : NIL | ~1 : NIL | ~1 : t(0, 2, 0) NIL }
    @StartRule
    Tapered --> extrude(5) modify(f) { top : s('0.5, '0.5, '0.5) center(xy) X. } X.
    @StartRule
    Ridge --> roofHip(45) modify(e) { ridge : t(0, 2, 0) X. } X.

    attr Twist_Angle = 180
    attr Taper_Factor = 0.5
    attr Resolution = 24
    @StartRule
    Twist -->
        extrude(100)
        inline(recompose) split(y) { '1/Resolution : Slice }*
        X.
    Slice --> modify(f, noAlign) { top : RotateRescale }
    RotateRescale with(
        a := split.index / (Resolution-1)
        f := (1-a) + a*Taper_Factor
    ) -->
        r(0, (split.index+1)*Twist_Angle/Resolution, 0)
        s('f, '1, 'f)
        center(xz)

    attr Max_Height = scope.sx/2
    @StartRule
    Paraboloid with(
        center := getPivotCoord(scope.sx/2, 0, scope.sz/2)
        cenX := center[0]
        cenZ := center[2]
        a := getDampingFac(scope.sx/2)
        b := getDampingFac(scope.sz/2)
        yPos := scope.ty
    ) -->
        inline(recompose) Grid
        modify(v, noAlign) { all : Move(cenX, cenZ, a, b) }
        set(scope.ty, yPos)
    Grid --> split(x, noAdjust) { '0.1 : split(z) { '0.1 : Cell. }* }*
    Move(centerX, centerZ, a, b) with(
        x := scope.tx - centerX
        z := scope.tz - centerZ
    ) --> t(0, hyperbolic(x, z, a, b), 0)
    hyperbolic(x, z, a, b) = (z*z)/(b*b) - (x*x)/(a*a)
    getPivotCoord(x, y, z) = convert(scope, pivot, pos, [x, y, z])
    getDampingFac(l) = l / sqrt(Max_Height*0.5)
    @StartRule
    HyperbolicRoof --> extrude(5) modify(f, noAlign) { top : Paraboloid } X.

    @StartRule
    Chaikin --> modify(fe) { all : split(x) { '0.25 : CornerCut. | ~1 : Fixed. | '0.25 : s(0, 0, 0) Collapse. } } X.

    @StartRule
    RandomCells --> inline(recompose) RandomSplitX X.
    RandomSplitX --> split(x) { rand(0.5, 1) : RandomSplitZ | ~1 : RandomSplitX }
    RandomSplitZ --> split(z) { rand(0.5, 1) : Cell | ~1 : RandomSplitZ }
    Cell --> t(0, rand(-0.2, 0.2), 0)

    # Parts that nothing has moved.
    @StartRule
    Untouched --> roofHip(30) inline(recompose) split(y) { '0.3 : split(x) { 3 : X. }* | ~1 : split(z) { 1 : X. }* } X.
    @StartRule
    Faces --> roofHip(30) inline(recompose) comp(f) { all : X. } X.
    @StartRule
    Nothing --> roofHip(30) modify(f) { 99 : NIL } X.
    @StartRule
    Removed --> extrude(3) modify(f) { top : NIL } X.
    @StartRule
    Emptied --> modify(f) { all : NIL } print(geometry.area) X.

    # Two squares that touch are two components of the geometry.
    @StartRule
    Touching --> inline { X. t('1, 0, 0) X. } modify(v) { all : t(0, 1, 0) X. } print(geometry.nVertices) X.

    # Edges and points without faces.
    @StartRule
    Outline --> inline(recompose) comp(e) { all : split(x) { '0.5 : X. }* } print(geometry.nEdges) print(geometry.nVertices) X.
    @StartRule
    Corners --> inline(recompose) comp(fv) { all : X. } print(geometry.nVertices) X.

    # Bodies on a face keep its vertices; inserted geometry has none of them.
    @StartRule
    Extruded --> modify(f) { all : extrude(1) X. } print(geometry.nVertices) X.
    @StartRule
    Grown --> inline(recompose) split(x) { '0.5 : extrude(1) X. | ~1 : X. } print(geometry.nVertices) X.
    @StartRule
    Inserted --> inline(recompose) split(x) { '0.5 : primitiveCube X. | ~1 : X. } print(geometry.nVertices) X.
    @StartRule
    SetBack --> extrude(1) modify(f) { top : shapeL(1, 1) { shape : X. | remainder : X. } } print(geometry.nVertices) X.

    # Their parts are not connected with each other, and not with the other faces.
    @StartRule
    SetBackAll --> extrude(1) modify(f) { top : setback(1) { all : X. | remainder : X. } } print(geometry.nVertices) X.
    @StartRule
    ToArea --> extrude(1) modify(f) { top : setbackToArea(9) { all : X. | remainder : X. } } print(geometry.nVertices) X.
    @StartRule
    Perimeter --> extrude(1) modify(f) { top : splitAndSetbackPerimeter(0) { 8 : 1 : X. } { remainder : X. } } print(geometry.nVertices) X.
    @StartRule
    Rectangle --> modify(f) { all : innerRectangle(scope) { shape : X. | remainder : X. } } print(geometry.nVertices) X.
    @StartRule
    Areas --> extrude(1) modify(f) { top : splitArea(x) { '0.5 : X. | ~1 : X. } } print(geometry.nVertices) X.
    @StartRule
    Subtracted --> extrude(1) modify(f) { top : subtract { X. | s('0.5, '0.5, '1) X. } } print(geometry.nVertices) X.
    @StartRule
    Envelope --> extrude(1) modify(f) { top : envelope(normal, 2, 1, 45) X. } print(geometry.nVertices) X.

    # Operations that keep points of a face.
    @StartRule
    Roofed --> extrude(5) modify(f) { top : roofPyramid(45) X. } print(geometry.nVertices) X.
    @StartRule
    Offset --> extrude(5) modify(f) { top : offset(-1) X. } print(geometry.nVertices) X.
    @StartRule
    Mapped --> setupProjection(0, scope.xy, 1, 1) projectUV(0) inline(recompose) split(u, uvSpace, 0) { '0.5 : X. | ~1 : t(0, 1, 0) X. } print(geometry.nVertices) X.

    # A part is moved before it is divided: its movement counts once.
    @StartRule
    Once --> inline(recompose) split(x) { '0.5 : t(0, 1, 0) split(z) { '0.5 : X. }* | ~1 : X. } X.
    @StartRule
    Twice --> inline(recompose) split(x) { '0.5 : t(0, 1, 0) split(z) { '0.5 : t(0, 1, 0) X. }* | ~1 : X. } X.

    # One part alone is taken as it is, also if it is moved. Attributes and materials are as with `inline`.
    @StartRule
    Single --> inline(recompose) split(x) { '0.5 : r(0, 30, 0) color("#ff0000") X. } print(scope.ry) X.
    @StartRule
    Pivot --> r(0, 30, 0) modify(f) { all : t(0, 1, 0) X. } print(scope.ry) print(comp.index) X.
    "##;
}

fn run_on(shape: &Shape, rule: &str) -> Model {
    let settings = Settings { start: Some(rule.to_owned()), ..Settings::default() };
    clean(Recomposed::default().generate_with(shape, &settings).expect("a model"))
}

/// The points of the only leaf, in the world.
fn points(model: &Model) -> Vec<DVec3> {
    let [leaf] = &model.leaves().collect::<Vec<_>>()[..] else { panic!("{} leaves", model.leaves().count()) };
    let (mesh, place) = leaf.mesh();
    assert!(mesh.check().iter().all(|flaw| matches!(flaw, cga::mesh::Flaw::NotPlanar { .. })), "{:?}", mesh.check());
    mesh.points().iter().map(|point| place.transform_point3(*point)).collect()
}

fn faces(model: &Model) -> usize {
    model.leaves().next().expect("a leaf").mesh().0.face_count()
}

/// The points as texts, sorted.
fn sorted(points: &[DVec3]) -> Vec<String> {
    let round = |x: f64| (x * 1e6).round() / 1e6 + 0.0;
    let mut list: Vec<String> =
        points.iter().map(|p| format!("{} {} {}", round(p.x), round(p.y), round(p.z))).collect();
    list.sort();
    list
}

fn on(width: f64, depth: f64, rule: &str) -> Model {
    run_on(&Shape::rectangle(width, depth), rule)
}

/// The sum of the volumes of bodies that share faces, without the faces, and the volume of the whole.
fn volume(model: &Model) -> f64 {
    model.leaves().map(|leaf| leaf.mesh().0.volume()).sum()
}

#[test]
fn vertices_are_merged() {
    let model = on(2.0, 2.0, "Topology");
    assert_eq!(written(&model), ["\"start: 8\"", "\"inline(recompose): 8\""]);
    let mesh = model.leaves().next().expect("a leaf").mesh().0.clone();
    assert!(mesh.is_closed() && mesh.material_list().len() == 6);
}

#[test]
fn vertices_are_inserted_and_follow() {
    let model = on(40.0, 40.0, "FShape");
    assert_eq!((faces(&model), points(&model).len(), model.area()), (3, 11, 1000.0));
    let moved = sorted(&points(&on(40.0, 40.0, "FShapeMoved")));
    let lower = ["0 0 48", "0 0 8", "10 0 18", "10 0 28", "10 0 38", "10 0 48", "10 0 8"];
    let upper = ["40 0 0", "40 0 10", "40 0 20", "40 0 30"];
    assert_eq!(moved, [&lower[..], &upper].concat());
}

#[test]
fn movements_of_shared_vertices_add_up() {
    // The corner of both edges moves by 0.25 and 0.2.
    assert_eq!(sorted(&points(&on(1.0, 1.0, "VertexMove"))), ["0 0 0", "0.25 0 1", "0.75 0 0.8", "1 0 0.2"]);
    let grid = sorted(&points(&on(2.0, 2.0, "FourFaces")));
    let [corners, middles] = [["0 1 0", "0 1 2", "2 1 0", "2 1 2"], ["0 2 1", "1 2 0", "1 2 2", "2 2 1"]];
    let mut expected: Vec<&str> = corners.into_iter().chain(middles).chain(["1 4 1"]).collect();
    expected.sort_unstable();
    assert_eq!(grid, expected);
}

#[test]
fn points_on_shared_edges_are_interpolated() {
    let found = sorted(&points(&on(6.0, 6.0, "SharedEdge")));
    let shared: Vec<&String> = found.iter().filter(|point| point.starts_with("3 ")).collect();
    // Two of the six new points are at the points of the thirds.
    assert_eq!(shared, ["3 0 -1.5", "3 0 0", "3 0 1.5", "3 0 3", "3 0 4.5", "3 0 6", "3 0 7.5"]);
    assert_eq!(found.len(), 18);
    let slanted = sorted(&points(&on(6.0, 6.0, "Slanted")));
    let right = ["3 0 9", "3.6 0 8.4", "4.2 0 7.8", "4.8 0 7.2", "5.4 0 6.6", "6 0 6"];
    assert!(right.iter().all(|point| slanted.contains(&(*point).to_owned())), "{slanted:?}");
}

#[test]
fn edges_give_insets() {
    let model = on(10.0, 10.0, "Insets");
    let found = sorted(&points(&model));
    assert_eq!((faces(&model), found.len()), (1, 20));
    assert!(["2.5 0 0", "3.5 0 2", "6.5 0 2", "7.5 0 0"].iter().all(|point| found.contains(&(*point).to_owned())));
    // Four trapezoids of 2 x 4 are missing.
    assert!((model.area() - 68.0).abs() < 1e-9);
}

/// Parts that lie in one plane are in it up to rounding. `scope.sy` is 0 all the same, so that rules can ask for it.
#[test]
fn a_flat_shape_stays_flat() {
    for number in 1..50 {
        let side = f64::from(number) * 0.37;
        let model = on(side, 7.3, "Turned");
        let size = model.leaves().next().expect("a leaf").scope().size;
        assert_eq!(size.to_array().iter().filter(|&&size| size == 0.0).count(), 1, "{size}");
    }
}

#[test]
fn shifted_planes_and_their_sides() {
    let plane = ["0 0 0", "0 0 2", "3 0 0", "3 0 2", "6 2 0", "6 2 2", "9 2 0", "9 2 2"];
    assert_eq!(sorted(&points(&on(9.0, 2.0, "ShiftedPlane"))), plane);
    let top = ["0 5 0", "0 5 2", "3 5 0", "3 5 2", "6 7 0", "6 7 2", "9 7 0", "9 7 2"];
    let body = || ["0 0 0", "0 0 2", "9 0 0", "9 0 2"].into_iter().chain(top).map(str::to_owned);
    // The removed parts still move the sides.
    for (rule, count) in [("ShiftedTop", 8), ("ShiftedSides", 5)] {
        let model = on(9.0, 2.0, rule);
        let mut expected: Vec<String> = body().collect();
        expected.sort();
        assert_eq!((sorted(&points(&model)), faces(&model)), (expected, count), "{rule}");
    }
    let model = on(9.0, 2.0, "ShiftedTop");
    assert!(model.leaves().all(|leaf| leaf.mesh().0.is_closed()));
    assert!((volume(&model) - (90.0 + 2.0 * (3.0 + 6.0))).abs() < 1e-9);
}

#[test]
fn components_of_bodies_are_moved() {
    let model = on(4.0, 4.0, "Tapered");
    assert!(model.leaves().all(|leaf| leaf.mesh().0.is_closed()));
    assert!((volume(&model) - 5.0 / 3.0 * (16.0 + 4.0 + 8.0)).abs() < 1e-9);
    let ridge = sorted(&points(&on(8.0, 4.0, "Ridge")));
    assert_eq!(ridge, ["0 0 0", "0 0 4", "2 2 4", "6 2 4", "8 0 0", "8 0 4"]);
}

#[test]
fn slices_twist_and_taper() {
    let model = on(10.0, 10.0, "Twist");
    let found = points(&model);
    // 25 levels of four points; each slice has its bottom and its top.
    assert_eq!((found.len(), faces(&model)), (100, 24 * 6));
    for level in 1..=24 {
        let at = |index: i32| f64::from(index) / 23.0;
        let half = 5.0 * (1.0 - at(level - 1) * 0.5);
        let angle = f64::from(level) * 7.5f64.to_radians();
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let ring: Vec<&DVec3> = found.iter().filter(|p| (p.y - 100.0 / 24.0 * f64::from(level)).abs() < 1e-6).collect();
        assert_eq!(ring.len(), 4, "{level}");
        for corner in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
            let (x, z) = (corner.0 * half, corner.1 * half);
            let (x, z) = (x * cos + z * sin + 5.0, z * cos - x * sin + 5.0);
            assert!(ring.iter().any(|p| (p.x - x).hypot(p.z - z) < 1e-9), "{level}");
        }
    }
}

#[test]
fn hyperbolic_grids_are_connected() {
    let model = on(10.0, 8.0, "Paraboloid");
    assert_eq!((points(&model).len(), faces(&model)), (121, 100));
    let roof = on(10.0, 8.0, "HyperbolicRoof");
    assert_eq!((points(&roof).len(), faces(&roof)), (121 + 4, 105));
    assert!(roof.leaves().all(|leaf| leaf.mesh().0.is_closed()));
}

#[test]
fn random_cells_are_a_continuous_surface() {
    let model = on(10.0, 10.0, "RandomCells");
    let mesh = model.leaves().next().expect("a leaf").mesh().0.clone();
    // Every border edge is on the border of the square.
    let all = points(&model);
    let mut uses = std::collections::BTreeMap::new();
    for ring in mesh.faces().flat_map(|face| face.loops().map(<[u32]>::to_vec).collect::<Vec<_>>()) {
        for (at, point) in ring.iter().enumerate() {
            let next = ring[(at + 1) % ring.len()];
            *uses.entry([*point.min(&next), *point.max(&next)]).or_insert(0) += 1;
        }
    }
    let is_at = |a: f64, b: f64| [0.0, 10.0].iter().any(|side| (a - side).abs() < 1e-9 && (b - side).abs() < 1e-9);
    for (edge, count) in uses {
        let [p, q] = edge.map(|point| all[point as usize]);
        assert!(count == 2 || (count == 1 && (is_at(p.x, q.x) || is_at(p.z, q.z))), "{p} {q} {count}");
    }
}

#[test]
fn parts_that_nothing_moves_are_the_whole_again() {
    let whole = {
        rules! { grammar Plain = r#"Lot --> roofHip(30) X."#; }
        clean(Plain::default().generate_with(&Shape::rectangle(9.0, 6.0), &Settings::default()).expect("a model"))
    };
    for rule in ["Faces", "Nothing"] {
        let model = on(9.0, 6.0, rule);
        assert_eq!((sorted(&points(&model)), faces(&model)), (sorted(&points(&whole)), faces(&whole)), "{rule}");
        assert!(model.leaves().all(|leaf| leaf.mesh().0.is_closed()) && (model.area() - whole.area()).abs() < 1e-9);
    }
    // Bodies with the faces between them, which cancel.
    let model = on(9.0, 6.0, "Untouched");
    assert!((volume(&model) - volume(&whole)).abs() < 1e-9);
    let found = sorted(&points(&model));
    let distinct: std::collections::BTreeSet<&String> = found.iter().collect();
    assert_eq!(distinct.len(), found.len());
}

#[test]
fn removed_components_leave_the_rest() {
    let model = on(4.0, 4.0, "Removed");
    assert_eq!((faces(&model), points(&model).len()), (5, 8));
    let model = on(4.0, 4.0, "Emptied");
    assert_eq!((lines(&model), leaves(&model).len()), (vec!["0".to_owned()], 0));
}

#[test]
fn only_vertices_of_one_origin_are_merged() {
    assert_eq!(lines(&on(2.0, 2.0, "Touching")), ["8"]);
    assert_eq!(lines(&on(2.0, 2.0, "Outline")), ["8", "8"]);
    assert_eq!(lines(&on(2.0, 2.0, "Corners")), ["4"]);
    assert_eq!(lines(&on(2.0, 2.0, "Extruded")), ["8"]);
    // The body and the half share an edge.
    assert_eq!(lines(&on(2.0, 2.0, "Grown")), ["10"]);
    assert_eq!(lines(&on(2.0, 2.0, "Inserted")), ["12"]);
    assert_eq!(lines(&on(4.0, 4.0, "Roofed")), ["9"]);
    assert_eq!(lines(&on(4.0, 4.0, "Offset")), ["12"]);
    assert_eq!(lines(&on(4.0, 4.0, "Mapped")), ["6"]);
    // The parts of the top are appended to the five other faces.
    assert_eq!(lines(&on(8.0, 8.0, "SetBack")), ["16"]);
}

/// "The resulting shapes will not be automatically reconnected with the rest of the geometry; they are simply appended."
#[test]
fn operations_without_connectivity_append_their_parts() {
    // The five other faces have 8 vertices.
    let body = 8;
    for (rule, parts) in [
        // A ring and a square.
        ("SetBackAll", 8 + 4),
        ("ToArea", 8 + 4),
        ("Perimeter", 4 + 4),
        ("Areas", 4 + 4),
        ("Subtracted", 6),
        // The front has a slope.
        ("Envelope", 10),
    ] {
        assert_eq!(lines(&on(8.0, 8.0, rule)), [(body + parts).to_string()], "{rule}");
    }
    // A rectangle in a triangle, and two triangles beside it.
    let triangle = Shape::footprint(&[[0.0, 0.0], [9.0, 0.0], [0.0, -9.0]], &[]).expect("a triangle");
    assert_eq!(lines(&run_on(&triangle, "Rectangle")), ["10"]);
}

#[test]
fn a_part_that_is_divided_later_moves_once() {
    let heights = |rule: &str| {
        let mut list: Vec<f64> = points(&on(2.0, 2.0, rule)).iter().map(|p| p.y).collect();
        list.sort_by(f64::total_cmp);
        list
    };
    assert_eq!(heights("Once"), [0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0]);
    assert_eq!(heights("Twice"), [0.0, 0.0, 2.0, 2.0, 2.0, 2.0, 3.0, 3.0]);
}

#[test]
fn scopes_and_attributes() {
    assert_eq!(lines(&on(2.0, 2.0, "Single")), ["30"]);
    assert_eq!(lines(&on(2.0, 2.0, "Pivot")), ["30", "-1"]);
}

#[test]
fn many_parts_take_little_time() {
    cga! { grammar Many = r#"
        attr count = 100
        Lot --> inline(recompose) split(x) { '1/count : split(z) { '1/count : t(0, rand(0.1), 0) X. }* }* X.
    "#; }
    let run = |count: f64| {
        let start = std::time::Instant::now();
        let model = Many { count }.generate_with(&Shape::rectangle(100.0, 100.0), &Settings::default());
        let model = clean(model.expect("a model"));
        println!("{count}: {:?}", start.elapsed());
        points(&model).len()
    };
    assert_eq!([run(25.0), run(50.0), run(100.0)], [26 * 26, 51 * 51, 101 * 101]);
}

#[test]
fn shapes_that_would_be_too_high_stay_flat() {
    cga! { grammar High = r#"
        attr height = 0
        Lot --> extrude(height) modify(f) { top : s('0.5, '0.5, '1) center(xy) X. } X.
    "#; }
    for height in [1e300, -1e300, 1e150] {
        let model = High { height }.generate(&Shape::rectangle(2.0, 4.0)).expect("a model");
        let faults: Vec<&str> = model.faults().iter().map(|fault| fault.message.as_str()).collect();
        assert_eq!(faults, ["`extrude` overflows; the shape stays as it is"]);
        assert_eq!(model.area(), 2.0);
    }
}
