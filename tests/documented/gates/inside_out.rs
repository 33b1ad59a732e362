//! Closed parts are not inside out.

use cga::{Settings, Shape, cga};
use cga_gates::inside_out;

use super::{check, planted};

cga! {
    grammar Turned;
    Lot  --> [ extrude(3) House. ] t(12, 0, 0) Shed
    Shed --> extrude(2) reverseNormals Box.
}

#[test]
fn closed_parts_have_their_outside_outside() {
    check(0, |surveyed| inside_out(&surveyed.survey));
}

#[test]
fn a_turned_box_is_found() {
    let make = |settings: &Settings| Turned::default().generate_with(&Shape::rectangle(10.0, 8.0), settings);
    let found = planted(make, |surveyed| inside_out(&surveyed.survey));
    assert_eq!(found, "1 x, first at (17.00, 1.00, 4.00): Lot > Shed > Box\n");
}
