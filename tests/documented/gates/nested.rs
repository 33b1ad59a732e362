//! Buildings are not in each other.

use cga::{Settings, Shape, cga};
use cga_gates::nested;

use super::{check, planted};

cga! {
    /// A house with eaves.
    grammar House;
    attr eaves = 0.5
    Lot  --> extrude(5) comp(f) { top : Roof | all : Wall. }
    Roof --> roofHip(40, eaves) Roof.
}

#[test]
fn no_building_reaches_into_another() {
    check(0, |surveyed| nested(&surveyed.survey));
}

#[test]
fn eaves_in_a_neighbour_are_found() {
    let row = |eaves: f64| {
        let lots = [0.0, 10.0].map(|x| Shape::rectangle(10.0, 8.0).at([x, 0.0, 0.0]));
        let make =
            move |settings: &Settings| House { eaves }.generate_all(&lots, settings).map(|models| models.to_model());
        planted(make, |surveyed| nested(&surveyed.survey))
    };
    let found = row(0.5);
    assert!(found.contains(": Lot > Roof\n"), "{found}");
    assert_eq!(row(0.0), "");
}
