//! *footprint*, *envelope* and *innerRectangle operations*.

use cga::Shape;

use super::example::{Example, example};

/// In the order of the pages.
pub(crate) const ALL: &[Example] = &[
    envelope_parameters::EXAMPLE,
    envelope_slope::EXAMPLE,
    envelope_tags::EXAMPLE,
    envelope_notch::EXAMPLE,
    envelope_concave::EXAMPLE,
    footprint::EXAMPLE,
];

/// A lot with a front of 20 metres.
fn lot() -> Shape {
    Shape::footprint(&[[0.0, 30.0], [20.0, 30.0], [20.0, 0.0], [0.0, 0.0]], &[]).expect("an outline")
}

fn yard() -> Shape {
    let hole = vec![[6.0, 6.0], [14.0, 6.0], [14.0, 14.0], [6.0, 14.0]];
    Shape::footprint(&[[0.0, 20.0], [20.0, 20.0], [20.0, 0.0], [0.0, 0.0]], &[hole]).expect("an outline")
}

fn bent_lot() -> Shape {
    let outline = [[0.0, 22.0], [12.0, 22.0], [12.0, 10.0], [26.0, 10.0], [26.0, 0.0], [0.0, 0.0]];
    Shape::footprint(&outline, &[]).expect("an outline")
}

example! {
    /// The page has a picture and no numbers.
    envelope_parameters, "envelope operation, basic parameters", lot(),
    r#"Lot --> envelope(normal, 16, 8, 50, 7, 55, 7.5, 60) Envelope.
"#
}

example! {
    /// "The example code above creates a building envelope with a slope of 30 degrees facing the street-side." The page sets the
    /// front back first, with `setback`, which does not run yet.
    envelope_slope, "envelope operation, Street-facing Slope", lot(),
    r#"Building -->
   envelope(normal, 50, 15, 30)
"#
}

example! {
    /// The colours of the page; its picture shows a base that is lower at one side.
    envelope_tags, "envelope operation, Component tags", yard(),
    r##"Lot --> envelope(normal, 8, 4.5, 60, 4.5, 60, 5.5, 60, 4.5, 60) Colored
Colored --> comp(f) {
   isTagged("envelope.bottom") : color("#0399F5") Bottom. | isTagged("envelope.side.base") : color("#FADB19") Base. |
   isTagged("envelope.side.slope") : color("#FF9900") Slope. | isTagged("envelope.side.inner") : color("#FF360A") Inner. |
   isTagged("envelope.top") : color("#09DE1F") Top. }
"##
}

example! {
    /// Without a base height the slope begins at the ground; here it reaches the hole.
    envelope_notch, "component tags, a slope with a notch", yard(),
    r##"Lot --> envelope(normal, 6, 0, 38, 4, 60, 4, 60, 4, 60) Colored
Colored --> comp(f) {
   isTagged("envelope.bottom") : color("#0399F5") Bottom. | isTagged("envelope.side.base") : color("#FADB19") Base. |
   isTagged("envelope.side.slope") : color("#FF9900") Slope. | isTagged("envelope.side.inner") : color("#FF360A") Inner. |
   isTagged("envelope.top") : color("#09DE1F") Top. }
"##
}

example! {
    /// Not on the page: slopes of a concave lot end at each other.
    envelope_concave, "envelope operation, a concave lot", bent_lot(),
    r##"Lot --> envelope(normal, 9, 5, 45, 5, 45, 5, 45) comp(f) {
   isTagged("envelope.side.base") : color("#FADB19") Base. | isTagged("envelope.side.slope") : color("#FF9900") Slope. |
   isTagged("envelope.top") : color("#09DE1F") Top. | all : Bottom. }
"##
}

example! {
    /// "A schematic low-poly version of a building is created by an extrusion of the footprint."
    footprint, "footprint operation", Shape::point([0.0, 0.0, 0.0]),
    r#"Example -->
    i("building.obj")
    ShowAsset.
    Footprint(scope.sy)
Footprint(height) -->
    footprint()
    extrude(height)
    set(material.opacity, 0.25)
"#
}
