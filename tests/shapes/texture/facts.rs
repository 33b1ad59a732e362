//! Single facts of the pages *setupProjection*, *projectUV*, *texture*, *translateUV*, *rotateUV*, *normalizeUV*, *tileUV* and *split
//! operation*.

use cga::glam::{DVec2, DVec3};
use cga::sink::picture::Image;
use cga::{Assets, Settings, Shape, cga};

use crate::collect::{Corner, leaves};

fn uv(corner: &Corner) -> DVec2 {
    corner.uvs[0].expect("coordinates")
}

#[track_caller]
fn all_are(corners: &[Corner], expected: impl Fn(DVec3) -> [f64; 2]) {
    assert!(!corners.is_empty());
    for corner in corners {
        let expected = DVec2::from_array(expected(corner.point));
        assert!(uv(corner).abs_diff_eq(expected, 1e-9), "{corner:?}: {expected}");
    }
}

cga! {
    /// *setupProjection operation*: "Choose the scope origin and two of its axes", "Choose the world origin and two of its axes".
    grammar Axes;
    attr kind = 0
    Lot -->
        case kind == 0 : setupProjection(0, scope.xy, 1, 1) projectUV(0) X.
        case kind == 1 : setupProjection(0, scope.xz, 1, 1) projectUV(0) X.
        case kind == 2 : setupProjection(0, scope.yx, 1, 1) projectUV(0) X.
        case kind == 3 : setupProjection(0, scope.yz, 1, 1) projectUV(0) X.
        case kind == 4 : setupProjection(0, scope.zx, 1, 1) projectUV(0) X.
        case kind == 5 : setupProjection(0, scope.zy, 1, 1) projectUV(0) X.
        case kind == 6 : setupProjection(0, world.xy, 1, 1) projectUV(0) X.
        case kind == 7 : setupProjection(0, world.xz, 1, 1) projectUV(0) X.
        case kind == 8 : setupProjection(0, world.yx, 1, 1) projectUV(0) X.
        case kind == 9 : setupProjection(0, world.yz, 1, 1) projectUV(0) X.
        case kind == 10 : setupProjection(0, world.zx, 1, 1) projectUV(0) X.
        else : setupProjection(0, world.zy, 1, 1) projectUV(0) X.
}

#[test]
fn the_first_letter_is_u_and_the_second_one_v() {
    let (at, shape) = (DVec3::new(5.0, 6.0, 7.0), Shape::cuboid(4.0, 3.0, 2.0));
    let pairs = [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)];
    for kind in 0..12 {
        let leaves = leaves!(&Axes { kind: kind as f64 }, &shape.clone().at(at.to_array()));
        let (u, v) = pairs[kind % 6];
        let origin = if kind < 6 { at } else { DVec3::ZERO };
        all_are(&leaves.corners("X"), |p| [(p - origin)[u], (p - origin)[v]]);
    }
}

cga! {
    /// *setupProjection*, *projectUV*, *translateUV*, *rotateUV*, *copyUV*, *deleteUV operation*.
    grammar Kept;
    attr kind = 0
    Lot --> comp(f) { front : Facade }
    Facade -->
        case kind == 0 : setupProjection(0, scope.xy, ~3, ^1) projectUV(0) X.
        case kind == 1 : setupProjection(0, scope.xy, 2, -3) projectUV(0) X.
        case kind == 2 : setupProjection(0, scope.xy, 1, 1) t(1, 2, 0) s(^0.5, ^0.5, ^1) projectUV(0) X.
        case kind == 3 : setupProjection(0, scope.xy, 1, 1) projectUV(0) projectUV(0) X.
        case kind == 4 :
            set(material.colormap.su, 2) set(material.colormap.sv, 3) setupProjection(0, scope.zx, 1, 1, 3, 4) projectUV(0) X.
        case kind == 5 : setupProjection(0, scope.xy, 1, 1) projectUV(0) translateUV(0, 0.5, 0) X.
        case kind == 6 : setupProjection(0, scope.xy, 1, 1) projectUV(0) rotateUV(0, 10) X.
        else : setupProjection(0, scope.xy, 1, 1) projectUV(0) copyUV(0, 5) deleteUV(0) copyUV(5, 0) X.
}

/// The coordinates of a point.
type Expected = Box<dyn Fn(DVec3) -> [f64; 2]>;

#[test]
fn projected_coordinates_are_functions_of_the_place() {
    let (sin, cos) = libm::sincos(10.0_f64.to_radians());
    let expected: [(&str, Expected); 8] = [
        ("~ and ^: three tiles of 3.333, and one", Box::new(|p| [p.x / (10.0 / 3.0), p.y / 8.0])),
        ("negative sizes mirror", Box::new(|p| [p.x / 2.0, -p.y / 3.0])),
        ("shapes change, projections stay", Box::new(|p| [p.x, p.y])),
        ("coordinates are replaced", Box::new(|p| [p.x, p.y])),
        ("offsets are metres, also with `su` set and for scope.zx", Box::new(|p| [p.z - 3.0 + 3.0, p.x - 4.0])),
        ("moved by half a texture", Box::new(|p| [p.x + 0.5, p.y])),
        ("turned anticlockwise", Box::new(move |p| [cos * p.x - sin * p.y, sin * p.x + cos * p.y])),
        ("copied there and back", Box::new(|p| [p.x, p.y])),
    ];
    for (kind, (fact, expected)) in expected.iter().enumerate() {
        let leaves = leaves!(&Kept { kind: kind as f64 }, &Shape::cuboid(10.0, 8.0, 3.0));
        eprintln!("{fact}");
        all_are(&leaves.corners("X"), expected);
    }
}

cga! {
    /// *normalizeUV operation* with several faces, *tileUV operation* without an area.
    grammar Faces;
    attr kind = 0
    Lot -->
        case kind == 0 : setupProjection(0, scope.xy, 1, 1) projectUV(0) normalizeUV(0, uv, separatePerFace) X.
        case kind == 1 : setupProjection(0, scope.xy, 1, 1) projectUV(0) normalizeUV(0, uvUniform, collectiveAllFaces) X.
        else : setupProjection(0, scope.xy, 1, 1) projectUV(0) s(^1, 0, ^1) tileUV(0, 3, ~2) X.
}

#[test]
fn normalizing_takes_each_face_or_all_and_faces_without_an_area_stay_finite() {
    let run = |kind: u32| leaves!(&Faces { kind: f64::from(kind) }, &Shape::cuboid(10.0, 5.0, 3.0));
    for face in &run(0).0[0].1 {
        let high = face.iter().map(uv).reduce(DVec2::max).unwrap();
        // Top and bottom have one v, the sides along z one u.
        assert!(high == DVec2::ONE || high == DVec2::X || high == DVec2::Y, "{high}");
    }
    assert_eq!(run(1).range("X", 0), [DVec2::ZERO, DVec2::new(1.0, 0.5)]);
    assert!(run(2).corners("X").iter().all(|corner| uv(corner).is_finite()));
}

cga! {
    /// *split operation*: borders of splits in texture space.
    grammar Borders;
    attr kind = 0
    Lot -->
        case kind == 0 : comp(f) { front : setupProjection(0, scope.xy, 4, 1, 12, 0) projectUV(0) split(u, uvSpace, 0) { 0.5 : X. | ~1 : Y. } }
        case kind == 1 : primitiveCube() split(u, uvSpace, 0) { 0.5 : X. }*
        else : comp(f) { front : setupProjection(0, scope.xy, 1, 1) projectUV(0) split(u, uvSpace, 0) { { ~2 : Numbered(1) | ~1 : Numbered(0) }* } }
    Numbered(first) --> report("index", split.index) report("total", split.total) [ case first > 0 : X. else : Y. ]
}

#[test]
fn splits_in_texture_space_start_at_the_smallest_coordinate_and_close_nothing() {
    let run = |kind: u32| leaves!(&Borders { kind: f64::from(kind) }, &Shape::cuboid(9.0, 4.0, 3.0));
    // From the smallest coordinate found, here 3.
    assert_eq!(run(0).range("X", 0), [DVec2::new(3.0, 0.0), DVec2::new(3.5, 4.0)]);
    assert_eq!(run(0).range("Y", 0), [DVec2::new(3.5, 0.0), DVec2::new(5.25, 4.0)]);
    // Each side of the cube is cut, and nothing is closed.
    let halves = run(1);
    assert_eq!(halves.0.iter().map(|(_, faces)| faces.len()).collect::<Vec<_>>(), [6, 6]);
    // Numbers of pieces.
    let model = Borders { kind: 2.0 }.generate(&Shape::cuboid(9.0, 4.0, 3.0)).expect("no error");
    let sum = |key: &str| model.reported(key).expect(key).summary().sum;
    assert_eq!((sum("index"), sum("total"), model.count("X"), model.count("Y")), (15.0, 36.0, 3, 3));
}

cga! {
    /// *texture operation*, *Texturing: essential knowledge*.
    @Allow(missing_asset)
    grammar Maps;
    attr image = ""
    Lot -->
        set(material.opacitymap, "builtin:default") texture(image)
        print(material.colormap) print(material.opacitymap) report("uvs", str(geometry.hasUVs()))
        X.
}

#[test]
fn textures_set_or_reset_the_opacity_map_and_make_no_coordinates() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("texture-facts");
    std::fs::create_dir_all(&folder).expect("a folder");
    Image::filled(4, 4, [255, 0, 0, 100]).write_png(folder.join("leaves.png")).expect("a file");
    let settings = Settings { assets: Assets::below(&folder).into(), ..Settings::default() };
    for (image, opacity) in [("leaves.png", "leaves.png"), ("builtin:uvtest.png", "")] {
        let grammar = Maps { image: image.to_owned() };
        let model = grammar.generate_with(&Shape::cuboid(4.0, 4.0, 4.0), &settings).expect("no error");
        let printed: Vec<_> = model.prints().iter().map(|print| print.to_string()).collect();
        assert_eq!(printed, [image, opacity]);
        let has: Vec<_> = model.reported("uvs").expect("a report").texts().map(|(text, _)| text.to_owned()).collect();
        assert_eq!(has, ["false"]);
    }
}

cga! {
    /// Operations on sets that are missing, which the checks report.
    @Allow(missing_uv_set)
    grammar Missing;
    attr kind = 0
    Lot -->
        case kind == 0 : setupProjection(2, scope.xy, 1, 1) projectUV(2) primitiveCube() tileUV(2, 1, 1) scaleUV(3, 2, 2) X.
        case kind == 1 : primitiveCube() copyUV(3, 0) normalizeUV(0, uv, collectiveAllFaces) X.
        case kind == 2 : primitiveCube() projectUV(0) rotateUV(0, 90) X.
        else : primitiveCube() setupProjection(0, scope.xy, 1, 1) copyUV(0, 8) copyUV(8, 9) X.
}

#[test]
fn sets_that_are_missing_stay_missing() {
    let sets = |kind: u32| {
        let leaves = leaves!(&Missing { kind: f64::from(kind) }, &Shape::cuboid(4.0, 4.0, 4.0));
        let corners = leaves.corners("X");
        (0..10).filter(|set| corners.iter().any(|corner| corner.uvs[*set].is_some())).collect::<Vec<usize>>()
    };
    assert_eq!([sets(0), sets(1), sets(2), sets(3)], [vec![0], vec![], vec![], vec![0, 8, 9]]);
}
