//! Normals of vertices survive operations, cuts and sinks (*setNormals operation*).

use std::sync::Arc;

use cga::glam::DVec3;
use cga::sink::buffers::Buffers;
use cga::sink::picture::Picture;
use cga::{Assets, Model, Repeats, Settings, Shape, cga};

cga! {
    /// An ellipsoid in a box of 6, 4 and 2 metres.
    @Allow(missing_asset)
    grammar Balls = r##"
    @StartRule
    Whole --> primitiveSphere(32, 16) setNormals(soft) X.
    # Normals stay at right angles to a surface that is stretched.
    @StartRule
    Stretched --> s(2, 2, 2) primitiveSphere(32, 16) setNormals(soft) s(6, 4, 2) X.
    @StartRule
    Split --> primitiveSphere(32, 16) setNormals(soft) split(x) { { 0.7 : split(y) { ~1.1 : X. | ~1.7 : split(z) { '0.3 : X. | ~1 : X. } } }* }
    @StartRule
    Textured --> primitiveSphere(32, 16) setNormals(soft) split(u, uvSpace, 0) { { 0.13 : split(v, uvSpace, 0) { 0.4 : X. | ~1 : X. } }* }
    @StartRule
    Areas --> primitiveSphere(32, 16) setNormals(soft) splitArea(x) { 20 : X. | ~1 : X. }
    @StartRule
    Faces --> primitiveSphere(32, 16) setNormals(soft) comp(f) { top : X. | 7 = X. | all : t(0, 0, 0) X. }
    @StartRule
    Halves --> primitiveSphere(32, 16) setNormals(soft) comp(f) { top = X. | all = X. }
    @StartRule
    Joined --> primitiveSphere(32, 16) setNormals(soft) inline(append) comp(f) { all : X. } Y.
    @StartRule
    Recomposed --> primitiveSphere(32, 16) setNormals(soft) inline(recompose) split(x) { { 0.7 : X. }* } Y.
    @StartRule
    Modified --> primitiveSphere(32, 16) setNormals(soft) modify(f) { top : color("#ff0000") } X.
    @StartRule
    Mirrored --> primitiveSphere(32, 16) setNormals(soft) mirror(true, false, true) mirror(false, true, false) X.
    @StartRule
    Convex --> primitiveSphere(32, 16) setNormals(soft) convexify deleteHoles X.
    @StartRule
    Aligned --> primitiveSphere(32, 16) setNormals(soft) rotateScope(10, 20, 30) setPivot(yzx, 3) X.
    @StartRule
    Trimmed --> primitiveSphere(32, 16) setNormals(soft) trim() X.
    @StartRule
    Reversed --> primitiveSphere(32, 16) setNormals(soft) reverseNormals X.
    @StartRule
    Hard --> primitiveSphere(32, 16) setNormals(soft) setNormals(hard) X.
    @StartRule
    Turned --> primitiveSphere(32, 16) setNormals(soft) r(scopeCenter, 0, 90, 90) split(x) { 2 : X. | ~1 : X. }
    # Operations that make new faces.
    @StartRule
    Grown --> primitiveSphere(12, 6) setNormals(soft) extrude(0.2) X.
    @StartRule
    GrownAlong --> primitiveSphere(12, 6) setNormals(soft) extrude(vertex.normal, 0.2) X.
    @StartRule
    Shrunk --> primitiveSphere(12, 6) setNormals(soft) offset(-0.05, inside) offset(-0.05, border) X.
    @StartRule
    SetBack --> primitiveSphere(12, 6) setNormals(soft) setback(0.05) { all : X. | remainder : X. }
    @StartRule
    Strips --> primitiveSphere(12, 6) setNormals(soft) shapeU(0.05, 0.05, 0.05) { shape : X. | remainder : X. }
    @StartRule
    Inner --> primitiveSphere(12, 6) setNormals(soft) innerRectangle(edge) { shape : X. | remainder : X. }
    @StartRule
    Roofed --> primitiveSphere(12, 6) setNormals(soft) roofHip(10) X.
    @StartRule
    Pyramids --> primitiveSphere(12, 6) setNormals(soft) comp(f) { all : roofPyramid(30) X. }
    @StartRule
    Printed --> primitiveSphere(12, 6) setNormals(soft) footprint() envelope(normal, 3, 1, 60) X.
    @StartRule
    Ball --> s(0, 0, 0) i("ball.glb") X.
    @StartRule
    BallOfText --> s(0, 0, 0) i("ball.obj") X.
    "##;
}

fn shape() -> Shape {
    Shape::cuboid(6.0, 4.0, 2.0)
}

fn run(rule: &str) -> Model {
    let model = Balls::default().generate_from(rule, &shape()).expect("a model");
    assert!(model.faults().is_empty(), "{rule}: {:?}", model.faults());
    model
}

/// The normal of the ellipsoid in the direction of a point.
fn normal_at(point: DVec3) -> DVec3 {
    ((point - DVec3::new(3.0, 2.0, 1.0)) / DVec3::new(9.0, 4.0, 1.0)).normalize()
}

/// The points and normals of the vertices of a model.
fn vertices(model: &Model) -> Vec<[DVec3; 2]> {
    let mut buffers = Buffers::new();
    assert!(model.replay(&mut buffers).is_continue());
    let vector = |numbers: &[f32]| DVec3::new(f64::from(numbers[0]), f64::from(numbers[1]), f64::from(numbers[2]));
    buffers.vertices().iter().map(|vertex| [vector(&vertex[..3]), vector(&vertex[3..])]).collect()
}

#[test]
fn normals_survive_operations() {
    let rules = [
        "Whole",
        "Stretched",
        "Split",
        "Textured",
        "Areas",
        "Faces",
        "Halves",
        "Joined",
        "Recomposed",
        "Modified",
        "Mirrored",
        "Convex",
        "Aligned",
        "Trimmed",
    ];
    for rule in rules {
        let all = vertices(&run(rule));
        let mut smooth = 0u32;
        for [point, normal] in &all {
            assert!((normal.length() - 1.0).abs() < 1e-6, "{rule}");
            // Caps are flat.
            let is_cap = (normal.abs().max_element() - 1.0).abs() < 1e-6;
            let near = normal_at(*point).dot(*normal);
            assert!(is_cap || 0.97 < near, "{rule}: {near} at {point}, {normal}");
            smooth += u32::from(!is_cap);
        }
        // Only cuts make caps.
        let least = if ["Split", "Recomposed"].contains(&rule) { 0.5 } else { 0.9 };
        assert!(least * (all.len() as f64) < f64::from(smooth), "{rule}: {smooth} of {}", all.len());
    }
}

#[test]
fn operations_that_make_faces_keep_values_and_corners_together() {
    for rule in ["Grown", "GrownAlong", "Shrunk", "SetBack", "Strips", "Inner", "Roofed", "Pyramids", "Printed"] {
        let model = Balls::default().generate_from(rule, &shape()).expect("a model");
        assert!(!model.is_empty());
        for leaf in model.leaves() {
            let (mesh, _) = leaf.mesh();
            let corners = mesh.corners().len();
            assert!([0, corners].contains(&mesh.normals().len()), "{rule}");
            assert!(mesh.normals().iter().all(|normal| (normal.length() - 1.0).abs() < 1e-9), "{rule}");
        }
    }
}

#[test]
fn turned_shapes_turn_their_normals() {
    let whole = vertices(&run("Whole"));
    let reversed = vertices(&run("Reversed"));
    assert!(reversed.iter().all(|[point, normal]| normal_at(*point).dot(*normal) < -0.97));
    assert_eq!(whole.len(), reversed.len());
    // By 90 degrees about y and then about z, x goes to -z, y to -x and z to y.
    for [point, normal] in vertices(&run("Turned")) {
        let centre = DVec3::new(3.0, 2.0, 1.0);
        let back = |v: DVec3| DVec3::new(-v.z, -v.x, v.y);
        let expected = normal_at(centre + back(point - centre));
        let is_cap = (normal.abs().max_element() - 1.0).abs() < 1e-6;
        assert!(is_cap || 0.97 < expected.dot(back(normal)), "{point} {normal}");
    }
}

#[test]
fn hard_normals_are_those_of_triangles() {
    let all = vertices(&run("Hard"));
    // Each face has one normal: the normal of its plane.
    let mut buffers = Buffers::new();
    assert!(run("Hard").replay(&mut buffers).is_continue());
    for triangle in buffers.indices().chunks(3) {
        let [a, b, c] = [0, 1, 2].map(|k| all[triangle[k] as usize]);
        let flat = (b[0] - a[0]).cross(c[0] - a[0]).normalize();
        for [_, normal] in [a, b, c] {
            assert!(0.9999 < normal.dot(flat), "{normal} {flat}");
        }
    }
}

/// The model, written to a file and inserted again.
fn read_back(name: &str, rule: &str, write: impl Fn(&Model, &std::path::Path)) -> Model {
    let folder = std::env::temp_dir().join(format!("cga-normals-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    write(&run("Whole"), &folder.join(name));
    let settings =
        Settings { assets: Arc::new(Assets::below(&folder)), start: Some(rule.into()), ..Settings::default() };
    let model = Balls::default().generate_with(&shape(), &settings).expect("a model");
    std::fs::remove_dir_all(&folder).expect("the folder");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    model
}

#[test]
fn files_have_the_normals() {
    let whole = vertices(&run("Whole"));
    let glb = vertices(&read_back("ball.glb", "Ball", |model, path| model.write_glb(path).expect("a file")));
    let obj = vertices(&read_back("ball.obj", "BallOfText", |model, path| model.write_obj(path).expect("files")));
    for (name, read) in [("GLB", glb), ("OBJ", obj)] {
        assert!(whole.len() <= read.len(), "{name}");
        for [point, normal] in &read {
            let near = |other: &&[DVec3; 2]| (other[0] - *point).length() < 1e-4;
            let written = whole.iter().find(near).expect("the point");
            assert!((written[1] - *normal).length() < 1e-4, "{name}: {point}");
        }
    }
}

#[test]
fn pictures_shade_smooth_faces_smoothly() {
    let tones = |rule: &str| {
        let image = Picture::new(160, 120).render(&run(rule));
        let at = |place: usize| image.pixel(place % 160, place / 160);
        let mut tones: Vec<[u8; 4]> = (0..160 * 120).filter_map(at).collect();
        tones.sort_unstable();
        tones.dedup();
        tones.len()
    };
    let (hard, smooth) = (tones("Hard"), tones("Whole"));
    assert!(hard * 5 < smooth * 4, "{hard} {smooth}");
}

#[test]
fn results_do_not_depend_on_templates_or_boxes() {
    for rule in ["Split", "Faces", "Whole"] {
        let with = |shape: &Shape, repeats: Repeats| {
            let settings = Settings { repeats, start: Some(rule.into()), ..Settings::default() };
            vertices(&Balls::default().generate_with(shape, &settings).expect("a model"))
        };
        let expected = with(&shape(), Repeats::Kept);
        for (shape, repeats) in
            [(shape(), Repeats::Again), (shape(), Repeats::Direct), (shape().held_as_meshes(), Repeats::Kept)]
        {
            let found = with(&shape, repeats);
            assert_eq!(found.len(), expected.len());
            for (a, b) in found.iter().zip(&expected) {
                assert!((a[0] - b[0]).length() < 1e-5 && (a[1] - b[1]).length() < 1e-5, "{rule}");
            }
        }
    }
}
