//! *Subdivision split*: absolute, relative and floating splits of a box of 5 × 1 × 1, without repeats.
//!
//! The page gives the rules of its introduction in full and of the other examples the split alone. It gives the rule
//! `Blue`; `Green` and `Yellow` are made like it.

use cga::Shape;

use super::example::{Example, example};

/// All of them, in the page's order.
pub const ALL: &[Example] = &[
    introduction::EXAMPLE,
    absolute::EXAMPLE,
    two_absolute::EXAMPLE,
    limited_scope::EXAMPLE,
    no_size::EXAMPLE,
    golden_ratio::EXAMPLE,
    golden_ratio_recursive::EXAMPLE,
    floating::EXAMPLE,
    floating_between::EXAMPLE,
    two_floating::EXAMPLE,
    three_floating::EXAMPLE,
    floating_without_space::EXAMPLE,
];

/// `Lot` sets the size, so any lot will do.
fn lot() -> Shape {
    Shape::rectangle(20.0, 12.0)
}

example! {
    /// "Because the rule parameter height is set to 1, the height of the cube remains unchanged."
    introduction, "Subdivision split, introduction", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
        Blue(1)

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
"##,
    [("Blue", 5.0, 1.0)]
}

example! {
    /// "The cube of length 5 is cut at an absolute value of 3 units."
    absolute, "Subdivision split, Absolute split", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
        split(x) { 3 : Blue(1) }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
"##,
    [("Blue", 3.0, 1.0)]
}

example! {
    /// "After the split, the total resulting length is 3+1=4."
    two_absolute, "Subdivision split, Absolute split: two values", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
        split(x) { 3 : Green(1)
                 | 1 : Blue(0.5) }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    [("Green", 3.0, 1.0), ("Blue", 1.0, 0.5)]
}

example! {
    /// "The resulting shape Yellow has a length of 1 instead of 2", and the rightmost Blue "will not be generated".
    limited_scope, "Subdivision split, Absolute split: values within a limited scope", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
split(x) { 2 : Green(1)  |
           1 : Green(1)  |
           1 : Blue(0.5) |
           2 : Yellow(2) |
           1 : Blue(1)   }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
Yellow(height) --> s('1, 'height, '1) color("#FCE070")
"##,
    [("Green", 2.0, 1.0), ("Green", 1.0, 1.0), ("Blue", 1.0, 0.5), ("Yellow", 1.0, 2.0)]
}

example! {
    /// "Both Yellow shapes are not generated. Blue starts at 1.5. The last Green shape stops at the total length of 5."
    no_size, "Subdivision split, Absolute split: negative or zero-sized values", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
split(x) { 1.5 : Green(1)  |
            -2 : Yellow(1) |
           1.5 : Blue(0.5) |
           1.5 : Green(1)  |
             0 : Yellow(1) |
           1.5 : Green(1)  }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
Yellow(height) --> s('1, 'height, '1) color("#FCE070")
"##,
    [("Green", 1.5, 1.0), ("Blue", 1.5, 0.5), ("Green", 1.5, 1.0), ("Green", 0.5, 1.0)]
}

example! {
    /// "This example cuts the scope using the Golden Ratio."
    golden_ratio, "Subdivision split, Relative split: Golden Ratio", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
        split(x) { '0.382 : A | '0.618 : B }
A --> split(x) { '0.382 : Green(1)  |
                 '0.618 : Yellow(2) }
B --> split(x) { '0.382 : Green(1)  |
                 '0.618 : Yellow(2) }

Green(height) --> s('1, 'height, '1) color("#9BD770")
Yellow(height) --> s('1, 'height, '1) color("#FCE070")
"##,
    [
        ("Green", 5.0 * 0.382 * 0.382, 1.0),
        ("Yellow", 5.0 * 0.382 * 0.618, 2.0),
        ("Green", 5.0 * 0.618 * 0.382, 1.0),
        ("Yellow", 5.0 * 0.618 * 0.618, 2.0),
    ]
}

example! {
    /// "It expands the 1 unit over the remaining space, 5-3=2 units (blue)."
    floating, "Subdivision split, Floating split", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
split(x) { 3 : Green(1) |
          ~1 : Blue(2)  }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    [("Green", 3.0, 1.0), ("Blue", 2.0, 2.0)]
}

example! {
    /// "The floating value 2 fills the space (3 units in yellow) between two absolute values."
    floating_between, "Subdivision split, Floating split: filling the space", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
split(x) { 1 : Blue(1.5) |
          ~2 : Yellow(1) |
           1 : Blue(0.5) }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Yellow(height) --> s('1, 'height, '1) color("#FCE070")
"##,
    [("Blue", 1.0, 1.5), ("Yellow", 3.0, 1.0), ("Blue", 1.0, 0.5)]
}

example! {
    /// "Distributed evenly over the remaining scope space (2 units)."
    two_floating, "Subdivision split, Floating split: two of them", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
split(x) {   3 : Green(1)  |
          ~1.5 : Blue(0.5) |
          ~1.5 : Blue(2)   }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    [("Green", 3.0, 1.0), ("Blue", 1.0, 0.5), ("Blue", 1.0, 2.0)]
}

example! {
    /// "Three floating splits are distributed evenly."
    three_floating, "Subdivision split, Floating split: three of them", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
split(x) { 3 : Green(1)  |
          ~2 : Blue(0.5) |
          ~2 : Blue(2)   |
          ~2 : Blue(1)   }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    [("Green", 3.0, 1.0), ("Blue", 2.0 / 3.0, 0.5), ("Blue", 2.0 / 3.0, 2.0), ("Blue", 2.0 / 3.0, 1.0)]
}

example! {
    /// "If there is no space left for a floating split, the corresponding shape is not generated."
    floating_without_space, "Subdivision split, Floating split: without space", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
split(x) { 5 : Green(1) |
          ~1 : Blue(1)  }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    [("Green", 5.0, 1.0)]
}

example! {
    /// "The recursion stops when the geometry gets too small for a further split."
    golden_ratio_recursive, "Subdivision split, Relative split: recursive, with Golden Ratio", lot(),
    r##"Lot --> s(5, 1, 1)
        primitiveCube()
        split(x) { '0.382 : A | '0.618 : B }
A --> split(x) { '0.382 : A         |
                 '0.618 : C         }
B --> split(x) { '0.382 : B         |
                 '0.618 : D         }
C --> split(x) { '0.382 : Green(1)  |
                 '0.618 : Yellow(2) }
D --> split(x) { '0.382 : Green(1)  |
                 '0.618 : Yellow(2) }

Green(height) --> s('1, 'height, '1) color("#9BD770")
Yellow(height) --> s('1, 'height, '1) color("#FCE070")
"##
}
