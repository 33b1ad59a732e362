//! The examples whose results look the same, by the design of their pages.

/// The titles of examples, each with the title of an earlier example whose picture it shares.
const SAME: &[(&str, &str)] = &[
    (
        "Boolean operations, reference table: inline(unify), plane that ends inside",
        "Boolean operations, reference table: union, plane that ends inside",
    ),
    (
        "Boolean operations, reference table: inline(unify), both closed",
        "Boolean operations, reference table: union, both closed",
    ),
    (
        "Boolean operations, reference table: subtract { Green | Blue }, plane, normal up",
        "Boolean operations, reference table: subtract { Green | Blue }, both closed",
    ),
    (
        "Boolean operations, reference table: intersect, plane, normal down",
        "Boolean operations, reference table: subtract { Green | Blue }, both closed",
    ),
    (
        "Boolean operations, reference table: intersect, both closed",
        "Boolean operations, reference table: subtract { Green | Blue }, plane, normal down",
    ),
    (
        "Boolean operations, reference table: intersect, plane, normal up",
        "Boolean operations, reference table: subtract { Green | Blue }, plane, normal down",
    ),
    ("Subdivision split, Repeat split: floating", "Subdivision split, Repeat split: absolute"),
    (
        "Subdivision split, Repeat split: no space for a floating split at the end",
        "Subdivision split, Repeat split: absolute",
    ),
    (
        "Subdivision split, Repeat split: no space for a floating split at the start",
        "Subdivision split, Repeat split: absolute",
    ),
    ("Geometry tagging, Geometry cleanup, tagged edges", "Geometry tagging, propagation: offset"),
    (
        "setupProjection operation, Global Texture Projection: with offsets",
        "setupProjection operation, Global Texture Projection",
    ),
];

/// The title of the example whose picture an example shares.
pub fn original(title: &str) -> Option<&'static str> {
    SAME.iter().find(|(own, _)| *own == title).map(|(_, original)| *original)
}
