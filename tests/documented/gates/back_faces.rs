//! The backs of surfaces are not seen.

use cga::{Settings, Shape, cga};
use cga_gates::back_faces;

use super::{check, planted};

cga! {
    /// A house whose glass is behind its wall, with reveals or without.
    grammar House;
    attr hasReveals = false
    Lot    --> extrude(6) comp(f) { front : Front | side : Wall. | top : Roof. }
    Front  --> split(x) { ~1 : Wall. | 2 : Window | ~1 : Wall. }
    Window --> case hasReveals : [ Recess ] t(0, 0, -0.4) Glass. else : t(0, 0, -0.4) Glass.
    Recess --> t(0, 0, -0.4) s(^1, ^1, 0.4) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : Reveal. }
}

#[test]
fn no_back_is_seen_from_twelve_sides() {
    check(0, |surveyed| back_faces(&surveyed.survey, &surveyed.looks));
}

#[test]
fn the_inside_beside_a_window_is_found() {
    let found = |reveals: bool| {
        let make = move |settings: &Settings| {
            House { hasReveals: reveals }.generate_with(&Shape::rectangle(10.0, 8.0), settings)
        };
        planted(make, |surveyed| back_faces(&surveyed.survey, &surveyed.looks))
    };
    let open = found(false);
    assert!(open.contains(" x, first at (") && open.contains("Lot > Wall\n"), "{open}");
    assert_eq!(found(true), "");
}
