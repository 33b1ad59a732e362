//! Random divisions that are recomposed (*Shape recomposition*): the result is the whole, and its faces fit together.

use std::collections::{BTreeMap, BTreeSet};

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::mesh::FaceRef;
use cga::{Mesh, Model, Settings, Shape, cga};

use crate::{clean, rules};

cga! {
    grammar Random = r##"
    attr depth = 4
    attr height = 0
    @StartRule
    Flat --> inline(recompose) Cut(depth) X.
    @StartRule
    Solid --> extrude(7) inline(recompose) Cut(depth) X.
    @StartRule
    Roofed --> extrude(5) comp(f) { top = roofGable(40) inline(recompose) Cut(depth) X. | all = NIL }
    @StartRule
    Nested --> extrude(7) inline(recompose) split(y) { ~rand(1, 2) : t(0, rand(height), 0) inline(recompose) Cut(2) | ~1 : Cut(3) } X.
    @StartRule
    Mapped --> setupProjection(0, scope.xz, 3, 3) projectUV(0) inline(recompose) Mapping(depth) X.
    Mapping(n) -->
        case n == 0 : t(0, rand(height), 0) X.
        else : 50% : split(u, uvSpace, 0) { '0.5 : Mapping(n - 1) | ~1 : Mapping(n - 1) }
        else : split(z) { '0.3 : Mapping(n - 1) | ~1 : Mapping(n - 1) }
    Cut(n) -->
        case n == 0 : t(0, rand(height), 0) X.
        else :
            30% : split(x) { ~rand(1, 3) : Cut(n - 1) | ~rand(1, 3) : Cut(n - 1) }
            30% : split(z) { ~rand(1, 3) : Cut(n - 1) | '0.25 : Cut(n - 1) | ~2 : Cut(n - 1) }
            20% : split(y) { '0.5 : Cut(n - 1) | ~1 : Cut(n - 1) }
            else : comp(f) { all : Pieces(n - 1) }
    Pieces(n) --> case n == 0 : t(0, rand(height), 0) X. else : split(x) { '0.4 : Pieces(n - 1) | ~1 : Pieces(n - 1) }
    "##;
}

fn model(start: &str, seed: u64, height: f64) -> Model {
    let settings = Settings { start: Some(start.to_owned()), ..Settings::default() };
    let lot = Shape::rectangle(9.0, 6.0).seed(seed);
    clean(Random { height, ..Random::default() }.generate_with(&lot, &settings).expect("a model"))
}

fn mesh(model: &Model) -> Mesh {
    let leaf = model.leaves().next().expect("a leaf");
    let (mesh, place) = leaf.mesh();
    mesh.map(&place)
}

/// The edges of a face, in its direction.
fn edges<'m>(face: &FaceRef<'m>) -> Vec<[u32; 2]> {
    let ring = |ring: &[u32]| (0..ring.len()).map(|at| [ring[at], ring[(at + 1) % ring.len()]]).collect::<Vec<_>>();
    face.loops().flat_map(ring).collect()
}

/// On the outside no two points are at one place, and no point is on an edge. Between two bodies, the faces that close both may be
/// divided differently.
fn fits(mesh: &Mesh, name: &str) {
    let outside: Vec<[u32; 2]> = mesh.faces().filter(|face| !face.tag().cap).flat_map(|face| edges(&face)).collect();
    let used: BTreeSet<u32> = outside.iter().flatten().copied().collect();
    for [a, b] in outside {
        let [p, q] = [a, b].map(|point| mesh.points()[point as usize]);
        for number in used.iter().filter(|number| ![a, b].contains(number)) {
            let point = mesh.points()[*number as usize];
            let share = ((point - p).dot(q - p) / (q - p).length_squared()).clamp(0.0, 1.0);
            let apart = (point - p - (q - p) * share).length();
            assert!(1e-7 < apart, "{name}: point {number} at {point} is on the edge from {p} to {q}");
        }
    }
}

fn volume(mesh: &Mesh) -> f64 {
    mesh.faces().map(|face| mesh.points()[face.outer()[0] as usize].dot(face.normal()) * face.area() / 3.0).sum()
}

#[test]
fn divisions_are_undone() {
    let whole = |start: &str| -> [f64; 2] {
        rules! {
            grammar Plain = r#"
            @StartRule
            Solid --> extrude(7) X.
            @StartRule
            Roofed --> extrude(5) comp(f) { top = roofGable(40) X. | all = NIL }
            @StartRule
            Flat --> X.
            "#;
        }
        let start = match start {
            "Nested" => "Solid",
            "Mapped" => "Flat",
            start => start,
        };
        let settings = Settings { start: Some(start.to_owned()), ..Settings::default() };
        let model = clean(Plain::default().generate_with(&Shape::rectangle(9.0, 6.0), &settings).expect("a model"));
        let mesh = mesh(&model);
        [mesh.area(), volume(&mesh)]
    };
    for start in ["Flat", "Solid", "Roofed", "Nested", "Mapped"] {
        let [area, solid] = whole(start);
        for seed in 0..12 {
            let mesh = mesh(&model(start, seed, 0.0));
            let name = format!("{start} {seed}");
            fits(&mesh, &name);
            assert!((volume(&mesh) - solid).abs() < 1e-6 * (1.0 + solid), "{name}: {} {solid}", volume(&mesh));
            assert!(area - 1e-6 < mesh.area(), "{name}");
        }
    }
}

#[test]
fn moved_parts_stay_connected() {
    for start in ["Flat", "Solid", "Roofed", "Nested", "Mapped"] {
        for seed in 0..12 {
            let [still, moved] = [0.0, 0.3].map(|height| mesh(&model(start, seed, height)));
            let corners = |mesh: &Mesh| mesh.faces().map(|face| edges(&face)).collect::<Vec<_>>();
            assert!(corners(&still) == corners(&moved), "{start} {seed}");
            assert!(moved.points().iter().all(|point| point.is_finite()));
            // Both directions of an edge are used as often as before.
            let mut uses: BTreeMap<[u32; 2], i32> = BTreeMap::new();
            for [a, b] in moved.faces().flat_map(|face| edges(&face)) {
                *uses.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
            }
            if !["Flat", "Mapped"].contains(&start) {
                assert!(uses.values().all(|sum| *sum == 0), "{start} {seed}");
            }
        }
    }
}

#[test]
fn odd_places_do_no_harm() {
    rules! {
        grammar Odd = r##"
        @StartRule
        NotANumber --> inline(recompose) split(x) { '0.5 : t(0, 0/0, 0) X. | ~1 : s('1, '1, 1/0) X. } X.
        @StartRule
        Huge --> inline(recompose) split(x) { '0.5 : t(0, 1e300, 0) X. | ~1 : s('1e200, '1, '1) X. | '0.1 : X. } X.
        @StartRule
        Flattened --> extrude(2) modify(f) { all : s(0, 0, 0) X. } X.
        @StartRule
        Points --> comp(v) { all : inline(recompose) comp(v) { all : X. } modify(v) { all : t(0, 1, 0) X. } X. }
        @StartRule
        Edges --> comp(e) { all : modify(e) { all : split(x) { '0.5 : X. | ~1 : NIL } } extrude(1) X. }
        @StartRule
        Sliver --> s(1e-7, '1, '1) inline(recompose) split(z) { '0.5 : split(x) { '0.5 : X. | ~1 : X. } | ~1 : X. } X.
        @StartRule
        Mirrored --> s(-4, '1, '1) extrude(2) inline(recompose) split(x) { '0.5 : X. | ~1 : split(z) { '0.5 : X. }* } X.
        "##;
    }
    for start in ["NotANumber", "Huge", "Flattened", "Points", "Edges", "Sliver", "Mirrored"] {
        let settings = Settings { start: Some(start.to_owned()), ..Settings::default() };
        let model = Odd::default().generate_with(&Shape::rectangle(9.0, 6.0), &settings).expect("a model");
        for leaf in model.leaves() {
            let (mesh, place) = leaf.mesh();
            assert!(mesh.points().iter().all(|point| place.transform_point3(*point).is_finite()), "{start}");
        }
        assert!(!model.leaves().any(|leaf| leaf.mesh().0.faces().any(|face| edges(&face).len() < 3)), "{start}");
    }
}
