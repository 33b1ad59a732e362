//! The chapter about scopes: where the scopes of its examples are.

use std::collections::BTreeSet;

use cga::glam::DVec3;
use cga::{Scope, Settings};
use cga_tests::pages::example::Example;
use cga_tests::pages::scope;

/// The scopes of the pieces of a rule.
fn scopes(example: &Example, rule: &str) -> Vec<Scope> {
    example.model(&Settings::default()).leaves_of(rule).map(|leaf| leaf.scope()).collect()
}

fn near(a: DVec3, b: DVec3) -> bool {
    (a - b).length() < 1e-9
}

#[test]
fn translations_run_along_the_turned_axes() {
    let first = |example: Example| scopes(&example, "A")[0];
    let [cube, moved, turned, again] =
        [scope::cube::EXAMPLE, scope::moved::EXAMPLE, scope::turned::EXAMPLE, scope::moved_again::EXAMPLE].map(first);
    assert!(near(cube.size, DVec3::ONE) && near(moved.origin, cube.origin + DVec3::X * 2.0));
    let (sin, cos) = (0.5, 3.0_f64.sqrt() / 2.0);
    assert!(near(turned.origin, moved.origin) && near(turned.axes.x_axis, DVec3::new(cos, 0.0, -sin)));
    assert!(
        near(again.origin, turned.origin + 2.0 * turned.axes.x_axis) && near(again.axes.x_axis, turned.axes.x_axis)
    );
}

#[test]
fn sizes_are_absolute_or_shares() {
    let lot = |example: Example| scopes(&example, "Lot")[0];
    let whole = lot(scope::extruded::EXAMPLE).size;
    assert!(near(lot(scope::resized::EXAMPLE).size, DVec3::splat(5.0)));
    assert!(near(lot(scope::resized_relatively::EXAMPLE).size, whole * DVec3::new(0.5, 1.0, 1.5)));
}

#[test]
fn slices_turn_around_the_origin_or_the_middle() {
    let origins = |example: Example| {
        let scopes = scopes(&example, "X");
        scopes.iter().map(|scope| scope.origin * DVec3::new(1.0, 0.0, 1.0)).collect::<Vec<_>>()
    };
    let [origin, center] = [scope::slices_origin::EXAMPLE, scope::slices_center::EXAMPLE].map(origins);
    assert_eq!((origin.len(), center.len()), (9, 9));
    assert!(origin.iter().all(|place| near(*place, origin[0])));
    assert!(center[1..].iter().all(|place| !near(*place, center[0])));
}

#[test]
fn pivots_lie_in_all_corners_and_look_inside() {
    for example in [scope::pivots_xyz::EXAMPLE, scope::pivots_yzx::EXAMPLE, scope::pivots_zxy::EXAMPLE] {
        let pivots = scopes(&example, "Corner");
        let middle = |scope: &Scope| scope.origin + scope.axes * (0.5 * scope.size);
        let corners: BTreeSet<_> =
            pivots.iter().map(|scope| scope.origin.to_array().map(|c| c.round() as i64)).collect();
        assert_eq!((pivots.len(), corners.len()), (8, 8), "{}", example.title);
        for pivot in &pivots {
            assert!(near(middle(pivot), middle(&pivots[0])), "{}", example.title);
            assert!((pivot.axes.determinant() - 1.0).abs() < 1e-9, "{}", example.title);
        }
    }
}

#[test]
fn scopes_turn_and_mirror_around_their_geometry() {
    let model = |example: Example| example.model(&Settings::default());
    let [turned, mirrored] = [scope::turned_scope::EXAMPLE, scope::mirrored_scope::EXAMPLE].map(model);
    assert!((turned.volume() - mirrored.volume()).abs() < 1e-9 && 0.0 < turned.volume());
    assert!(near(turned.bounds().low, mirrored.bounds().low) && near(turned.bounds().high, mirrored.bounds().high));
}
