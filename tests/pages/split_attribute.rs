//! *split operation*, Shape attributes, and *split attribute*, Examples: the index of a part and the number of parts.

use cga::Shape;

use super::example::{Example, example};

/// Both of them.
pub const ALL: &[Example] = &[interleaved::EXAMPLE, slices::EXAMPLE];

/// The arrowhead of the page's picture.
fn arrowhead() -> Shape {
    Shape::footprint(&[[0.0, 0.0], [9.0, 12.0], [12.0, 2.0], [24.0, -2.0]], &[]).expect("an outline")
}

example! {
    /// "`split.index` goes from 0 to 9 with all even numbers on rule A and all odd numbers on rule B while `split.total` will
    /// be 10." The page has no picture and gives no rules for `A` and `B`: these show what they see.
    interleaved, "split operation, Shape attributes", Shape::cuboid(10.0, 1.0, 1.0),
    r##"Lot-->
     primitiveCube()
     split(x) { '0.1 : A | '0.1 : B }*

A --> set(material.name, split.index + " of " + split.total) color("#ffff00")
B --> set(material.name, split.index + " of " + split.total) color("#0000ff")
"##
}

example! {
    /// The lowest slice is red, the highest blue.
    slices, "split attribute, Examples", arrowhead(),
    r##"Lot --> extrude(20) A
A --> split(y){2 : B}*
B -->
    case split.index == 0:
        color("#ff0000") X
    case split.index == split.total-1:
         color("#0000ff") X
    else:
        X.
"##
}
