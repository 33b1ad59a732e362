//! *split operation*, Examples: the initial shape is a box of 10 × 1 × 1, cut along x.
//!
//! `Z` without an argument stands for `Z(1)`: the page gives no rule for it, and its pictures show a green box of that height.

use cga::Shape;

use super::example::{Example, example, joined, times};

/// All of them, in the page's order.
pub const ALL: &[Example] = &[
    setup::EXAMPLE,
    relative_sizes::EXAMPLE,
    floating_sizes_only::EXAMPLE,
    absolute_and_floating_sizes::EXAMPLE,
    oversized::EXAMPLE,
    repeat_with_absolute_sizes::EXAMPLE,
    repeat_with_floating_sizes::EXAMPLE,
    interleaved_repeat::EXAMPLE,
    rhythm::EXAMPLE,
    rhythm_as_first_printed::EXAMPLE,
];

fn initial() -> Shape {
    Shape::cuboid(10.0, 1.0, 1.0)
}

example! {
    /// "This is the initial shape before the split." The page gives no rule for that picture.
    setup, "split operation, Setup", initial(),
    r##"A-->
  Initial.
"##,
    [("Initial", 10.0, 1.0)]
}

example! {
    /// "The total sum of all shape sizes in x-direction is 8, therefore the gap at the end."
    relative_sizes, "split operation, Relative Sizes", initial(),
    r##"A-->
  split(x){ '0.5 : Z |
            '0.1 : Y(2) |
            '0.2 : X(1) }

X(h)-->
  s('1,'h,'1)
  color("#0000ff")

Y(h)-->
  s('1,'h,'1)
  color("#ffff00")

Z(h)-->
  s('1,'h,'1)
  color("#00ff00")

Z--> Z(1)
"##,
    [("Z", 5.0, 1.0), ("Y", 1.0, 2.0), ("X", 2.0, 1.0)]
}

example! {
    /// "Note how the whole initial scope is filled (no gap at the end), and the ratios are kept."
    floating_sizes_only, "split operation, Floating Sizes only: Ratios", initial(),
    r##"A-->
split(x) { ~0.5 : Z |
           ~0.1 : Y(2) |
           ~0.2 : X(1) }

X(h)--> s('1,'h,'1) color("#0000ff")
Y(h)--> s('1,'h,'1) color("#ffff00")
Z(h)--> s('1,'h,'1) color("#00ff00")
Z--> Z(1)
"##,
    [("Z", 6.25, 1.0), ("Y", 1.25, 2.0), ("X", 2.5, 1.0)]
}

example! {
    /// "Its size is adjusted from 3 to 1.7 to fulfill the absolute constraints."
    absolute_and_floating_sizes, "split operation, Absolute and Floating Sizes", initial(),
    r##"A-->
split(x) { 3.3 : Z(1) |
           ~3   : Y(2) |
           5    : X(1) }

X(h)--> s('1,'h,'1) color("#0000ff")
Y(h)--> s('1,'h,'1) color("#ffff00")
Z(h)--> s('1,'h,'1) color("#00ff00")
"##,
    [("Z", 3.3, 1.0), ("Y", 1.7, 2.0), ("X", 5.0, 1.0)]
}

example! {
    /// "The second one Y (yellow) is cut at size 5. The X never gets created because there is no space left."
    oversized, "split operation, Oversized", initial(),
    r##"A-->
split(x) { '0.5 : Z(1) |
           '0.6 : Y(2) |
           3    : X(1) }

X(h)--> s('1,'h,'1) color("#0000ff")
Y(h)--> s('1,'h,'1) color("#ffff00")
Z(h)--> s('1,'h,'1) color("#00ff00")
"##,
    [("Z", 5.0, 1.0), ("Y", 5.0, 2.0)]
}

example! {
    /// "The XY pattern is repeated 3 times, and the remaining unit is filled with half a X."
    repeat_with_absolute_sizes, "split operation, Repeat Split with Absolute Sizes", initial(),
    r##"A-->
split(x) { 2 : X(2) |
           1 : Y(1) } *

X(h)--> s('1,'h,'1) color("#0000ff")
Y(h)--> s('1,'h,'1) color("#ffff00")
"##,
    joined(&[&times(3, &[("X", 2.0, 2.0), ("Y", 1.0, 1.0)]), &[("X", 1.0, 2.0)]])
}

example! {
    /// "No shape is cut but the sizes are adjusted"; the picture shows three repetitions.
    repeat_with_floating_sizes, "split operation, Repeat Split with Floating Sizes", initial(),
    r##"A-->
split(x){ ~2 : X(2) |
          ~1 : Y(1) }*

X(h)--> s('1,'h,'1) color("#0000ff")
Y(h)--> s('1,'h,'1) color("#ffff00")
"##,
    times(3, &[("X", 20.0 / 9.0, 2.0), ("Y", 10.0 / 9.0, 1.0)])
}

example! {
    /// "The yellow Y shapes have floating sizes which turn out to be 0.9."
    interleaved_repeat, "split operation, Interleaved Repeat Split", initial(),
    r##"A-->
split(x){ 1 : X(3) |
          { ~1 : Y(2) |
            0.2 : Z(1) |
            ~1 : Y(2) }* |
          1 : X(3) }

X(h)--> s('1,'h,'1) color("#0000ff")
Y(h)--> s('1,'h,'1) color("#ffff00")
Z(h)--> s('1,'h,'1) color("#00ff00")
"##,
    joined(&[
        &[("X", 1.0, 3.0)],
        &times(4, &[("Y", 0.9, 2.0), ("Z", 0.2, 1.0), ("Y", 0.9, 2.0)]),
        &[("X", 1.0, 3.0)],
    ])
}

example! {
    /// The picture shows three repetitions; from 2018.0 on the page prints the size that gives them.
    rhythm, "split operation, Rhythm, as printed from 2018 on", initial(),
    r##"A-->
split(x){ { 1 : X(3) |
         ~2.7 : Y(1) }* |
          1 : X(3) }

X(h)--> s('1,'h,'1) color("#0000ff")
Y(h)--> s('1,'h,'1) color("#ffff00")
"##,
    joined(&[&times(3, &[("X", 1.0, 3.0), ("Y", 2.0, 1.0)]), &[("X", 1.0, 3.0)]])
}

example! {
    /// Up to 2017 the page prints `~3` above the same picture: that size gives two repetitions.
    rhythm_as_first_printed, "split operation, Rhythm, as printed up to 2017", initial(),
    r##"A-->
split(x){ { 1 : X(3) |
           ~3 : Y(1) }* |
          1 : X(3) }

X(h)--> s('1,'h,'1) color("#0000ff")
Y(h)--> s('1,'h,'1) color("#ffff00")
"##,
    joined(&[&times(2, &[("X", 1.0, 3.0), ("Y", 3.5, 1.0)]), &[("X", 1.0, 3.0)]])
}
