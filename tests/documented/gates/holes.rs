//! Surfaces have no holes.

use cga::{Settings, Shape, cga};
use cga_gates::holes;

use super::{check, planted};

/// The parts with gaps, by model: railings, leaves, fences, streets around blocks without ground.
pub(super) fn open(name: &str) -> &'static [&'static str] {
    match name {
        "bridge" => &["Rail", "Crown"],
        "corner" => &["Bar", "Rail"],
        "fence" => &["Slat", "Bar", "Rail", "Plank", "Leaves", "Stalk", "Flower", "Post"],
        "example streets" => &["Pavement", "Roadway"],
        "interior" => &["Leaf"],
        "park" => &["Crown", "Needles"],
        "street" => &["Crown"],
        "town_house" => &["Bar", "Rail"],
        _ => &[],
    }
}

cga! {
    /// A thin wall with a slit of four centimetres, and with a hole of that width.
    grammar Wall;
    Lot  --> s(^1, 8, 0.01) primitiveCube split(x) { ~1 : Wall. | 0.04 : Gap | ~1 : Wall. | 0.04 : Hole | ~1 : Wall. }
    Gap  --> split(y) { 2 : Wall. | ~1 : NIL | 2 : Wall. }
    Hole --> split(y) { ~1 : Wall. | 0.04 : NIL | ~1 : Wall. }
}

#[test]
fn no_background_is_seen_inside_of_silhouettes() {
    check(0, |surveyed| holes(&surveyed.survey, &surveyed.looks, open(&surveyed.drawn.name)));
}

#[test]
fn a_slit_and_a_hole_are_found() {
    let make = |settings: &Settings| Wall::default().generate_with(&Shape::rectangle(10.0, 8.0), settings);
    let found = planted(make, |surveyed| holes(&surveyed.survey, &surveyed.looks, &[]));
    assert!(found.contains("Lot > Wall  beside  Lot > Wall\n"), "{found}");
    assert!(found.contains("Lot > Hole > Wall"), "{found}");
    let named = planted(make, |surveyed| holes(&surveyed.survey, &surveyed.looks, &["Wall"]));
    assert_eq!(named, "");
}
