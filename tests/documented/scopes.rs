//! Pages about one operation: *i*, *primitiveCube*, *t*, *s*, *r*, *center*, *push / pop*, *translate*, *extrude*, *NIL*.

use std::sync::Arc;

use cga::{Assets, MeshBuilder, Model, Settings, Shape, cga};
use cga_tests::pages::{inserting, scope};

cga! {
    @Allow(undefined_rule, missing_asset)
    grammar Pages = r##"
    # i operation, Insertion and Zero Scope Dimensions
    @StartRule
    HeadLine -->
        s(9,0,0)
        i("beethoven.obj")
    @StartRule
    HeadFlat -->
        s(9,9,0)
        i("beethoven.obj")
    @StartRule
    HeadPoint -->
        s(0,0,0)
        i("beethoven.obj")

    # primitiveCube operation: the flat lot's height comes from the other two sizes.
    @StartRule
    CubeOnLot --> primitiveCube()
    @StartRule
    CubeOfSize --> primitiveCube(10,15,20)

    # t operation, Translate - Rotation Concatenation
    @StartRule
    Moved-->
       primitiveCube()
       t(2,0,0)
       r(0,30,0)
       t('2,0,0)

    # s operation, Basic Usage
    @StartRule
    Resized-->
       extrude(10)
       s('0.5,'1,'1.5)

    # push / pop operation, Rotation Example
    @StartRule
    BuiltOn -->
        extrude(15)
        r(scopeCenter, 0, 22.5, 0) X.
        r(scopeCenter, 0, 22.5, 0) X.
        r(scopeCenter, 0, 22.5, 0) X.
    @StartRule
    Independent -->
        extrude(15)
        [ r(scopeCenter, 0, 22.5, 0) X. ]
        [ r(scopeCenter, 0, 22.5, 0) X. ]
        [ r(scopeCenter, 0, 22.5, 0) X. ]

    # push / pop operation, Translation Example
    @StartRule
    House-->
        Cylinder
        [ t(  0, 0, ' 1) Cylinder ]
        [ t(  0, 0, '-1) Cylinder ]
        [ t(' 1, 0,   0) Cylinder ]
        [ t('-1, 0,   0) Cylinder ]
    Cylinder -->
        primitiveCylinder(16, 1, 2)

    # push / pop operation, Condition Example
    @StartRule
    Condition -->
        s(1,1,1)
        [ case scope.sx == 1 : primitiveCube() Cube.
          else : primitiveCylinder() Cylinder. ]

    # translate operation, with `t`: the scope has the world's axes here.
    @StartRule
    Copies --> primitiveCube()
               X
               t(2, 0, 0)
               color("#ff0000")
               X

    @StartRule
    Extruded --> extrude(10)
    @StartRule
    Nothing --> extrude(10) NIL
    "##;
}

/// A box of that size with its low corner there.
fn block(low: [f64; 3], size: [f64; 3]) -> cga::Mesh {
    let mut builder = MeshBuilder::new();
    let shape = Shape::cuboid(size[0], size[1], size[2]).at(low);
    let mesh = shape.to_mesh();
    for point in mesh.points() {
        builder.point([point.x + low[0], point.y + low[1], point.z + low[2]]);
    }
    for face in mesh.faces() {
        builder.polygon(face.outer());
    }
    builder.build().unwrap()
}

fn run(rule: &str, shape: &Shape) -> Model {
    let assets = Assets::new().with("beethoven.obj", block([12.3, 4.3, 7.2], [2.0, 4.0, 6.0]));
    let settings = Settings { start: Some(rule.into()), assets: Arc::new(assets), ..Settings::default() };
    let model = Pages::default().generate_with(shape, &settings).unwrap();
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

/// Compares the scope of a leaf, which has the world's axes, and the box of its geometry with it.
#[track_caller]
fn stands(leaf: &str, model: &Model, origin: [f64; 3], size: [f64; 3]) {
    let found = model.leaves_of(leaf).next().unwrap();
    let near = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    let scope = found.scope();
    assert!(near(scope.origin.to_array(), origin), "origin {}", scope.origin);
    assert!(near(scope.size.to_array(), size), "size {}", scope.size);
    let bounds = found.bounds();
    assert!(near(bounds.low.to_array(), origin) && near(bounds.size().to_array(), size), "geometry {bounds:?}");
}

/// Scope at (1, 2, 3).
fn lot() -> Shape {
    Shape::rectangle(9.0, 9.0).at([1.0, 2.0, 3.0])
}

#[test]
fn an_asset_in_a_line_keeps_its_proportions() {
    // 9 / 2 = 4.5 times as large; along the sizes that were zero it stands as in its file.
    stands("HeadLine", &run("HeadLine", &lot()), [1.0, 2.0 + 4.5 * 4.3, 3.0 + 4.5 * 7.2], [9.0, 18.0, 27.0]);
}

#[test]
fn an_asset_on_a_rectangle_takes_the_average() {
    stands("HeadFlat", &run("HeadFlat", &lot()), [1.0, 2.0, 3.0], [9.0, 9.0, (9.0 / 2.0 + 9.0 / 4.0) * 0.5 * 6.0]);
}

#[test]
fn an_asset_at_a_point_stands_as_in_its_file() {
    stands("HeadPoint", &run("HeadPoint", &lot()), [13.3, 6.3, 10.2], [2.0, 4.0, 6.0]);
}

#[test]
fn a_cube_on_a_flat_lot() {
    stands("CubeOnLot", &run("CubeOnLot", &Shape::rectangle(10.0, 20.0)), [0.0; 3], [10.0, 15.0, 20.0]);
    // With sizes: in the middle of the lot, on the ground.
    let model = run("CubeOfSize", &Shape::rectangle(30.0, 40.0));
    stands("CubeOfSize", &model, [10.0, 0.0, 10.0], [10.0, 15.0, 20.0]);
}

#[test]
fn moving_goes_along_the_scope_that_was_turned() {
    let model = run("Moved", &Shape::cuboid(1.0, 1.0, 1.0));
    let scope = model.leaves().next().unwrap().scope();
    let (sin, cos) = (libm::sin(30f64.to_radians()), libm::cos(30f64.to_radians()));
    assert!((scope.axes.x_axis - scope.axes.x_axis.with_x(cos).with_y(0.0).with_z(-sin)).length() < 1e-12);
    let expected = [2.0 + 2.0 * cos, 0.0, -2.0 * sin];
    assert!(scope.origin.to_array().iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{}", scope.origin);
}

#[test]
fn relative_sizes_are_shares_of_the_scope() {
    stands("Resized", &run("Resized", &Shape::rectangle(8.0, 6.0)), [0.0; 3], [4.0, 10.0, 9.0]);
}

#[test]
fn turns_build_on_each_other_unless_brackets_undo_them() {
    let lot = Shape::rectangle(8.0, 6.0);
    for (rule, steps) in [("BuiltOn", [1.0, 2.0, 3.0]), ("Independent", [1.0, 1.0, 1.0])] {
        let model = run(rule, &lot);
        let turned = model.leaves_of("X").map(|leaf| leaf.scope().axes.x_axis);
        let expected = steps.map(|step| (22.5f64 * step).to_radians());
        assert_eq!(model.counts(), [("X", 3)]);
        for (x, angle) in turned.zip(expected) {
            assert!((x.x - libm::cos(angle)).abs() < 1e-12 && (x.z + libm::sin(angle)).abs() < 1e-12, "{rule}: {x}");
        }
        let centres = model.leaves_of("X").map(|leaf| leaf.scope().centre());
        assert!(centres.into_iter().all(|centre| (centre - lot.scope().centre()).with_y(0.0).length() < 1e-9));
    }
}

#[test]
fn brackets_start_from_the_initial_scope() {
    let model = run("House", &Shape::rectangle(10.0, 6.0));
    assert_eq!(model.counts(), [("Cylinder", 5)]);
    let centres = [[5.0, 3.0], [5.0, 9.0], [5.0, -3.0], [15.0, 3.0], [-5.0, 3.0]];
    for (leaf, [x, z]) in model.leaves().zip(centres) {
        let (low, high) = (leaf.bounds().low, leaf.bounds().high);
        assert!((low + high - low.with_x(2.0 * x).with_y(2.0).with_z(2.0 * z)).length() < 1e-9, "{low} {high}");
        // Sixteen corners on a circle, an edge between two of them in front.
        let wide = 2.0 * libm::cos(std::f64::consts::PI / 16.0);
        assert!((leaf.size() - low.with_x(wide).with_y(2.0).with_z(wide)).length() < 1e-9);
    }
}

#[test]
fn brackets_may_begin_with_a_case() {
    assert_eq!(run("Condition", &lot()).counts(), [("Cube", 1)]);
    stands("Cube", &run("Condition", &lot()), [1.0, 2.0, 3.0], [1.0; 3]);
}

#[test]
fn what_follows_a_successor_does_not_touch_it() {
    let model = run("Copies", &Shape::cuboid(1.0, 1.0, 1.0));
    let found: Vec<_> =
        model.leaves().map(|leaf| (leaf.rule(), leaf.scope().origin.x, leaf.material().color)).collect();
    assert_eq!(found, [("X", 0.0, None), ("X", 2.0, Some(cga::Color::new(1.0, 0.0, 0.0)))]);
}

#[test]
fn centring_along_each_choice_of_axes() {
    let model = scope::centers::EXAMPLE.model(&Settings::default());
    let middle = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, 0, 1], [0, 1, 1], [1, 1, 1]];
    assert_eq!(model.counts(), [("X", 7)]);
    for (leaf, axes) in model.leaves_of("X").zip(middle) {
        let expected = axes.map(|centred| if centred == 1 { -0.5 } else { -2.0 });
        assert_eq!(leaf.scope().origin.to_array(), expected);
        assert_eq!(leaf.size().to_array(), [1.0; 3]);
    }
}

#[test]
fn windows_on_a_facade() {
    // 47 metres of 1 and 8 give five floors; 20 of 1 and 5 give three windows, 14 give two.
    let assets = Assets::new().with("window.obj", block([0.0; 3], [1.0, 1.0, 0.25]));
    let settings = Settings { assets: Arc::new(assets), ..Settings::default() };
    let model = (inserting::windows::EXAMPLE.run)(&Shape::rectangle(20.0, 14.0), &settings).unwrap();
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    assert_eq!(model.count("Window"), 5 * 2 * (3 + 2));
    let window = model.leaves_of("Window").next().unwrap();
    let (wide, high) = (5.0 * 20.0 / 19.0, 8.0 * 47.0 / 46.0);
    let (depth, size) = ((wide + high) * 0.5 * 0.25, window.size());
    assert!((size - size.with_x(wide).with_y(high).with_z(depth)).length() < 1e-9, "{size}");
    assert!((window.bounds().low.z - 14.0).abs() < 1e-9, "in front of the façade");
}

/// "extrude": a polygon with n corners, holes included, gives n + 2 faces and 2n vertices.
#[test]
fn extrusion_gives_sides_top_and_bottom() {
    let square = [[0.0, 10.0], [10.0, 10.0], [10.0, 0.0], [0.0, 0.0]];
    let hole = vec![[4.0, 4.0], [6.0, 4.0], [5.0, 6.0]];
    for (holes, corners) in [(vec![], 4), (vec![hole], 7)] {
        let model = run("Extruded", &Shape::footprint(&square, &holes).unwrap());
        let (mesh, _) = model.leaves().next().unwrap().mesh();
        assert_eq!((mesh.points().len(), mesh.face_count()), (2 * corners, corners + 2));
        assert_eq!(mesh.faces().map(|face| face.holes().count()).sum::<usize>(), 2 * holes.len());
        assert!(mesh.is_closed());
        assert!((model.volume() - 10.0 * (100.0 - 2.0 * holes.len() as f64)).abs() < 1e-9);
    }
    let hexagon = [[2.0, 4.0], [4.0, 4.0], [6.0, 2.0], [4.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
    let (mesh, _) = run("Extruded", &Shape::footprint(&hexagon, &[]).unwrap()).leaves().next().unwrap().mesh();
    assert_eq!((mesh.face_count(), mesh.points().len()), (8, 12));
}

#[test]
fn nil_leaves_nothing() {
    assert!(run("Nothing", &lot()).is_empty());
}
