//! Faces that close cuts have the coordinates (0, 0), and later operations on coordinates reach them.

use cga::glam::DVec2;
use cga::{Shape, cga};

use crate::collect::{Corner, Leaves, leaves};

cga! {
    /// Coordinates before and after cuts of a solid.
    grammar Solid;
    attr kind = 0
    attr form = 0
    Lot -->
        case form == 0 : extrude(4) Start
        case form == 1 : extrude(4) primitiveCube() Start
        case form == 2 : extrude(4) primitiveCylinder(12) Start
        else : extrude(4) deleteUV(1) tag("a") Start
    Start --> setupProjection(0, world.xy, 2, 1, 0.5, 3) Kinds
    Kinds -->
        case kind == 0 : projectUV(0) Cut
        case kind == 1 : projectUV(0) translateUV(0, 0.25, 0.5) scaleUV(0, 2, 2) Cut
        case kind == 2 : projectUV(0) split(y) { 1 : NIL | ~1 : translateUV(0, 0.25, 0.5) Cut | 1 : NIL }
        case kind == 3 : projectUV(0) split(y) { 1 : NIL | ~1 : copyUV(0, 3) split(x) { { ~1 : X. }* } | 1 : NIL }
        case kind == 4 : split(y) { 1 : NIL | ~1 : projectUV(0) X. | 1 : NIL }
        case kind == 5 : projectUV(0) split(y) { 1 : NIL | ~1 : projectUV(0) X. | 1 : NIL }
        case kind == 6 : projectUV(0) split(y) { 1 : NIL | ~1 : comp(f) { top : extrude(1) X. } | 1 : NIL }
        case kind == 7 : projectUV(0) split(y) { 1 : NIL | ~1 : comp(f) { top : split(x) { { ~1 : X. }* } } | 1 : NIL }
        case kind == 8 : projectUV(0) split(y) { 1 : NIL | ~1 : comp(f) { top : rotateUV(0, 30) translateUV(0, 1, 2) X. } | 1 : NIL }
        else : projectUV(0) split(y) { { ~1 : t(0, 0.5, 0) s(^2, ^1, ^1) X. }* }
    Cut --> split(x) { 0.5 : NIL | ~1 : X. | 0.5 : NIL }
}

/// The corners of all faces of leaves for which a test holds.
fn faces(leaves: &Leaves, test: impl Fn(&Corner) -> bool) -> Vec<Corner> {
    let faces = leaves.0.iter().flat_map(|(_, faces)| faces);
    let found: Vec<Corner> = faces.filter(|face| face.iter().all(&test)).flatten().cloned().collect();
    assert!(!found.is_empty());
    found
}

fn run(kind: u32, form: u32) -> Leaves {
    leaves!(Solid { kind: f64::from(kind), form: f64::from(form) }, &Shape::rectangle(6.0, 3.0))
}

/// The projection of the grammar.
fn projected(corner: &Corner) -> DVec2 {
    DVec2::new((corner.point.x + 0.5) / 2.0, corner.point.y - 3.0)
}

fn are(corners: &[Corner], set: usize, expected: impl Fn(&Corner) -> DVec2) {
    for corner in corners {
        assert!(corner.uvs[set].expect("coordinates").abs_diff_eq(expected(corner), 1e-12), "{corner:?}");
    }
}

#[test]
fn caps_have_no_place_in_texture_space() {
    for form in 0..4 {
        for kind in [0, 1] {
            let leaves = run(kind, form);
            are(&faces(&leaves, |corner| (corner.point.x - 0.5).abs() < 1e-9), 0, |_| DVec2::ZERO);
            are(&faces(&leaves, |corner| (corner.point.x - 5.5).abs() < 1e-9), 0, |_| DVec2::ZERO);
            let top = faces(&leaves, |corner| (corner.point.y - 4.0).abs() < 1e-9);
            are(&top, 0, |corner| match kind {
                0 => projected(corner),
                _ => (projected(corner) + DVec2::new(0.25, 0.5)) * 2.0,
            });
        }
    }
}

#[test]
fn later_changes_move_caps_and_earlier_ones_do_not() {
    for form in 0..4 {
        let leaves = run(2, form);
        let moved = DVec2::new(0.25, 0.5);
        for y in [1.0, 3.0] {
            are(&faces(&leaves, |corner| (corner.point.y - y).abs() < 1e-9), 0, |_| moved);
        }
        are(&faces(&leaves, |corner| (corner.point.x - 0.5).abs() < 1e-9), 0, |_| DVec2::ZERO);
        let copied = run(3, form);
        for set in [0, 3] {
            are(&faces(&copied, |corner| (corner.point.y - 3.0).abs() < 1e-9), set, |_| DVec2::ZERO);
            are(&faces(&copied, |corner| (corner.point.x - 3.0).abs() < 1e-12), set, |_| DVec2::ZERO);
        }
        assert!(copied.corners("X").iter().all(|corner| corner.uvs[1..3].iter().all(Option::is_none)));
    }
}

#[test]
fn a_projection_reaches_the_caps_of_earlier_cuts() {
    for form in 0..4 {
        for kind in [4, 5] {
            are(&run(kind, form).corners("X"), 0, projected);
        }
    }
}

#[test]
fn caps_keep_their_coordinates_as_components_and_as_they_grow_and_move() {
    for form in 0..4 {
        for kind in [6, 7] {
            are(&run(kind, form).corners("X"), 0, |_| DVec2::ZERO);
        }
        are(&run(8, form).corners("X"), 0, |_| DVec2::new(1.0, 2.0));
        let moved = run(9, form);
        // Each piece is half a metre above its place.
        for y in [1.5, 2.5, 3.5] {
            are(&faces(&moved, |corner| (corner.point.y - y).abs() < 1e-12), 0, |_| DVec2::ZERO);
        }
    }
}

cga! {
    /// A split along texture coordinates after a split along an axis.
    grammar Bands;
    attr from = 0
    Lot --> extrude(4) setupProjection(0, world.xz, 6, 3, from, 0) projectUV(0) split(y) { ~1 : NIL | 1 : Slab }
    Slab --> comp(f) { top : Band | bottom : Cap | all = Band }
    Band --> split(u, uvSpace, 0) { { ~0.25 : X. }* }
    Cap --> case geometry.du(0, uvSpace) == 0 && geometry.uMax(0) == 0 : Y. else : Z.
}

#[test]
fn a_cap_is_a_point_of_texture_space() {
    for from in [0.0, 2.0, -17.0] {
        let leaves = leaves!(Bands { from }, &Shape::rectangle(6.0, 3.0));
        assert_eq!(leaves.0.iter().filter(|(rule, _)| rule == "Y").count(), 1);
        assert!(leaves.0.iter().all(|(rule, _)| rule != "Z"));
    }
}

#[test]
fn a_split_along_coordinates_leaves_caps_whole_in_the_piece_at_zero() {
    // u from 0 to 1, from -0.75 to 0.25 and from 2 to 3. The last range begins with the caps at 0, and the caps are alone there.
    for (from, pieces, at) in [(0.0, 2, 0), (-4.5, 2, 1), (12.0, 3, 0)] {
        let leaves = leaves!(Caps { from }, &Shape::rectangle(6.0, 3.0));
        let level = |face: &&Vec<Corner>| face.iter().all(|corner| corner.point.y == face[0].point.y);
        let counts: Vec<usize> = leaves.0.iter().map(|(_, faces)| faces.iter().filter(level).count()).collect();
        assert_eq!((counts.len(), counts[at], counts.iter().sum::<usize>()), (pieces, 2, 2), "{from}: {counts:?}");
    }
}

cga! {
    /// Two caps, and pieces of the sides.
    grammar Caps;
    attr from = 0
    Lot --> extrude(4) setupProjection(0, world.xy, 6, 4, from, 0) projectUV(0) split(y) { 1 : NIL | 2 : Part | 1 : NIL }
    Part --> split(u, uvSpace, 0) { { ~0.5 : X. }* }
}
