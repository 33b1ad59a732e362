//! *setupProjection operation*, *projectUV operation*.

use cga::glam::{DVec2, DVec3};
use cga::{Shape, cga};

use crate::collect::leaves;

const NEAR: f64 = 1e-12;

fn range_is(range: [DVec2; 2], low: [f64; 2], high: [f64; 2]) {
    let expected = [DVec2::from_array(low), DVec2::from_array(high)];
    assert!(range[0].abs_diff_eq(expected[0], NEAR) && range[1].abs_diff_eq(expected[1], NEAR), "{range:?}");
}

cga! {
    /// A projection of the façade, made on each piece.
    grammar Facade;
    attr perTile = false
    Lot --> r(0, 35, 0) comp(f) { front : Facade }
    Facade -->
        setupProjection(0, scope.xy, 1.5, 1, 0, 0, 1)
        setupProjection(2, scope.xy, scope.sx, scope.sy, 0, 0, 1)
        split(y) { 4 : Floor | { ~3 : Floor }* }
    Floor --> split(x) { 1 : Wall | { ~3 : Tile }* | 1 : Wall }
    Tile --> split(x) { ~1 : Wall | 1.5 : Window | ~1 : Wall }
    Window --> split(y) { 1 : Wall | 1.5 : Glass. | ~1 : Wall }
    Wall -->
        case perTile : setupProjection(0, scope.xy, 1.5, 1, 0, 0, 1) Brick
        else : Brick
    Brick --> color("#a05040") projectUV(0) projectUV(2) Bricks.
}

#[test]
fn a_projection_of_the_facade_runs_through_all_pieces() {
    let facade = Shape::cuboid(20.0, 13.0, 4.0).at([3.0, 1.0, -7.0]);
    let leaves = leaves!(&Facade::default(), &facade);
    range_is(leaves.range("Bricks", 0), [0.0, 0.0], [20.0 / 1.5, 13.0]);
    range_is(leaves.range("Bricks", 2), [0.0, 0.0], [1.0, 1.0]);
    // Where two pieces meet they have the same coordinates.
    let corners = leaves.corners("Bricks");
    let mut pairs = 0;
    for (at, a) in corners.iter().enumerate() {
        for b in corners[..at].iter().filter(|b| b.point.abs_diff_eq(a.point, 1e-9)) {
            pairs += 1;
            assert!(a.uvs[0].unwrap().abs_diff_eq(b.uvs[0].unwrap(), 1e-9));
        }
    }
    assert!(pairs > 50, "{pairs}");
    assert!(leaves.corners("Glass").iter().all(|corner| corner.uvs == [None; 10]));
}

#[test]
fn a_projection_of_a_piece_begins_at_its_scope() {
    let leaves = leaves!(&Facade { perTile: true }, &Shape::cuboid(20.0, 13.0, 4.0));
    for (rule, faces) in &leaves.0 {
        let Some(first) = faces[0].iter().min_by(|a, b| a.point.length().total_cmp(&b.point.length())) else {
            continue;
        };
        if rule == "Bricks" {
            assert!(first.uvs[0].unwrap().length() < 1e-9, "{first:?}");
        }
    }
}

cga! {
    /// Sizes of all kinds.
    @Allow(missing_uv_set)
    grammar Sizes;
    attr kind = 0
    Lot --> comp(f) { front : Facade }
    Facade -->
        case kind == 0 : setupProjection(0, scope.xy, 1.5, ^0.5) projectUV(0) X.
        case kind == 1 : setupProjection(0, scope.xy, ~3, ^1) projectUV(0) X.
        case kind == 2 : setupProjection(0, scope.xy, -2, ~100) projectUV(0) X.
        case kind == 3 : setupProjection(0, scope.yx, 1, 2, 3, 4) projectUV(0) X.
        case kind == 4 : setupProjection(0, world.xy, 1, 1) projectUV(0) X.
        case kind == 5 : setupProjection(0, scope.xy, 0, 1) projectUV(0) X.
        else : setupProjection(0, scope.xy, 1, 1) projectUV(1) projectUV(0) deleteUV(0) X.
}

#[test]
fn sizes_are_absolute_relative_floating_and_negative() {
    let shape = Shape::cuboid(10.0, 8.0, 3.0).at([5.0, 6.0, 7.0]);
    let range = |kind: u32| leaves!(&Sizes { kind: f64::from(kind) }, &shape).range("X", 0);
    range_is(range(0), [0.0, 0.0], [10.0 / 1.5, 2.0]);
    range_is(range(1), [0.0, 0.0], [3.0, 1.0]);
    range_is(range(2), [-5.0, 0.0], [0.0, 1.0]);
    range_is(range(3), [3.0, -2.0], [11.0, 3.0]);
    range_is(range(4), [5.0, 6.0], [15.0, 14.0]);
    range_is(range(5), [0.0, 0.0], [0.0, 8.0]);
    let leaves = leaves!(&Sizes { kind: 6.0 }, &shape);
    assert!(leaves.corners("X").iter().all(|corner| corner.uvs == [None; 10]));
}

cga! {
    /// Operations on geometry that has coordinates.
    grammar After;
    attr kind = 0
    Lot --> comp(f) { front : Facade }
    Facade --> setupProjection(0, scope.xy, ^1, ^1) projectUV(0) Next
    Next -->
        case kind == 0 : t(1, 2, 3) X.
        case kind == 1 : s(^2, ^0.5, ^1) X.
        case kind == 2 : r(0, 30, 0) t(0, 0, 1) split(x) { ~1 : X. | ~1 : NIL }
        case kind == 3 : extrude(2) X.
        case kind == 4 : setupProjection(0, scope.xy, 1, 1) X.
        case kind == 5 : split(x) { { ~1 : t(0, 0, 1) s(^1, ^0.5, ^1) X. }* }
        case kind == 6 : extrude(2) comp(f) { side : X. }
        else : s(0, ^1, ^1) X.
}

#[test]
fn coordinates_stay_with_the_geometry() {
    let shape = Shape::cuboid(4.0, 2.0, 3.0).at([5.0, 6.0, 7.0]);
    let leaves = |kind: u32| leaves!(&After { kind: f64::from(kind) }, &shape);
    for kind in [0, 1, 3, 4, 5, 6, 7] {
        range_is(leaves(kind).range("X", 0), [0.0, 0.0], [1.0, 1.0]);
    }
    range_is(leaves(2).range("X", 0), [0.0, 0.0], [0.5, 1.0]);
    let flat = leaves(7).corners("X");
    assert!(flat.iter().any(|corner| corner.uvs[0].unwrap().x == 1.0 && corner.point.x == 5.0));
}

cga! {
    /// A projection of a block on all its sides, with the depth behind the front added to u.
    grammar Block;
    Lot --> setupProjection(0, scope.xy, 1, 1, 0, 0, 1) projectUV(0) split(x) { ~1 : X. | ~1 : comp(f) { all : Y. } }
}

#[test]
fn the_uw_factor_goes_on_around_corners() {
    let leaves = leaves!(&Block::default(), &Shape::cuboid(4.0, 3.0, 2.0));
    let mut caps = 0;
    for face in leaves.0.iter().flat_map(|(_, faces)| faces) {
        let is_cap = face.iter().all(|corner| corner.point.x == 2.0);
        caps += usize::from(is_cap);
        for corner in face {
            let DVec3 { x, y, z } = corner.point;
            let expected = if is_cap { DVec2::ZERO } else { DVec2::new(x - z, y) };
            assert!(corner.uvs[0].unwrap().abs_diff_eq(expected, 1e-9), "{corner:?}");
        }
    }
    assert_eq!(caps, 2);
}
