//! Surfaces are not in one place.

use cga::{Settings, Shape, cga};
use cga_gates::fights;

use super::{check, planted};

/// The pixels of a model that may fight, in twelve pictures together.
pub(super) const MOST: usize = 50;

cga! {
    /// A sign in the surface of a wall, or in front of it.
    grammar Sign;
    attr distance = 0
    Lot   --> extrude(6) comp(f) { front : Front | all : Wall. }
    Front --> [ Wall. ] s(^0.5, ^0.5, 0) center(xy) t(0, 0, distance) color("#a04030") Sign.
}

#[test]
fn few_pixels_have_two_surfaces_in_one_place() {
    check(MOST, |surveyed| fights(&surveyed.survey, &surveyed.looks));
}

#[test]
fn a_sign_in_its_wall_is_found() {
    let found = |distance: f64| {
        let make = move |settings: &Settings| Sign { distance }.generate_with(&Shape::rectangle(10.0, 8.0), settings);
        planted(make, |surveyed| fights(&surveyed.survey, &surveyed.looks))
    };
    let flat = found(0.0);
    assert!(flat.contains(": Lot > Front > Wall  beside  Lot > Front > Sign\n"), "{flat}");
    let count: usize = flat.split(' ').next().and_then(|count| count.parse().ok()).expect("a number");
    assert!(MOST < count, "{count}");
    assert_eq!(found(0.02), "");
}
