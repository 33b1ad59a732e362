//! *Subdivision split*, Repeat split: a box of 10 × 1 × 1, with patterns that repeat.
//!
//! `Green` and `Yellow` are made like `Blue`, whose rule the page gives.

use cga::Shape;

use super::example::{Example, example, joined, times};

/// All of them, in the page's order.
pub const ALL: &[Example] = &[
    absolute::EXAMPLE,
    floating::EXAMPLE,
    bordered::EXAMPLE,
    absolute_then_float::EXAMPLE,
    float_then_absolute::EXAMPLE,
    between_floats::EXAMPLE,
    same_size::EXAMPLE,
    pattern::EXAMPLE,
    pattern_inside::EXAMPLE,
    parallel_floating::EXAMPLE,
    parallel_absolute::EXAMPLE,
];

/// `Lot` sets the size, so any lot will do.
fn lot() -> Shape {
    Shape::rectangle(20.0, 12.0)
}

example! {
    /// "Exactly 5 cubes of length 2 fit in the scope."
    absolute, "Subdivision split, Repeat split: absolute", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
        split(x) { 2 : Green(1) }*

Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    times(5, &[("Green", 2.0, 1.0)])
}

example! {
    /// "A split to 5 successor shapes (with a length of 2 each) still approximates the target length of 2.1 best."
    floating, "Subdivision split, Repeat split: floating", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) { ~2.1 : Green(1) }*

Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    times(5, &[("Green", 2.0, 1.0)])
}

example! {
    /// "The resulting length of the floating splits is (10-2)/3, the best approximation for the target value 2.5."
    bordered, "Subdivision split, Repeat split: bordered by two absolute splits", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) {    1 : Blue(2)     |
         { ~2.5 : Green(1) }* |
              1 : Blue(3)     }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    joined(&[&[("Blue", 1.0, 2.0)], &times(3, &[("Green", 8.0 / 3.0, 1.0)]), &[("Blue", 1.0, 3.0)]])
}

example! {
    /// "The floating splits do not get any space to be generated."
    absolute_then_float, "Subdivision split, Repeat split: no space for a floating split at the end", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) {  { 2 : Green(1) }* |
             ~1 : Blue(2)     }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    times(5, &[("Green", 2.0, 1.0)])
}

example! {
    /// "Evaluated first independently on whichever side of the split the repetition is denoted."
    float_then_absolute, "Subdivision split, Repeat split: no space for a floating split at the start", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) {   ~1 : Blue(2)     |
         {    2 : Green(1)    }*}

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    times(5, &[("Green", 2.0, 1.0)])
}

example! {
    /// "A repeat split with absolute values can be bordered by two neighboring floating splits." The lengths have the
    /// least stretch; the page gives none.
    between_floats, "Subdivision split, Repeat split: bordered by two floating splits", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) { ~1 : Green(1)     |
         {  2 : Blue(0.5) }* |
           ~1 : Green(1)     }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    joined(&[&[("Green", 1.0, 1.0)], &times(4, &[("Blue", 2.0, 0.5)]), &[("Green", 1.0, 1.0)]])
}

example! {
    /// "Equally distributed 4 times (blue) to the resulting length of (10-3)/4=1.75."
    same_size, "Subdivision split, Repeat split: floating and repeat split of the same size", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) { ~2 : Blue(1)    |
         {  1 : Green(2)   |
           ~2 : Blue(1) }* }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
"##,
    joined(&[&[("Blue", 1.75, 1.0)], &times(3, &[("Green", 1.0, 2.0), ("Blue", 1.75, 1.0)])])
}

example! {
    /// "A pattern is created and repeated." Four and five repetitions stretch it equally; the larger count is taken.
    pattern, "Subdivision split, Repeat split, Patterns", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) {  ~1 : Yellow(2) |
          0.25 : Green(1)  |
            ~1 : Yellow(2) }*

Green(height) --> s('1, 'height, '1) color("#9BD770")
Yellow(height) --> s('1, 'height, '1) color("#FCE070")
"##,
    times(5, &[("Yellow", 0.875, 2.0), ("Green", 0.25, 1.0), ("Yellow", 0.875, 2.0)])
}

example! {
    /// "Repeating patterns can be inserted within other geometries."
    pattern_inside, "Subdivision split, Repeat split, Patterns: within other geometries", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) {  1 : Blue(3)      |
         { ~1 : Yellow(2)    |
          0.2 : Green(1)     |
           ~1 : Yellow(2) }* |
            1 : Blue(3)      }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
Yellow(height) --> s('1, 'height, '1) color("#FCE070")
"##,
    joined(&[
        &[("Blue", 1.0, 3.0)],
        &times(4, &[("Yellow", 0.9, 2.0), ("Green", 0.2, 1.0), ("Yellow", 0.9, 2.0)]),
        &[("Blue", 1.0, 3.0)],
    ])
}

example! {
    /// "Two repeat splits (yellow and blue) are bordered by floating splits (green)." Ten parts of 1, dealt out in turn.
    parallel_floating, "Subdivision split, Repeat split, Parallel: bordered by floating splits", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) { ~1 : Green(1)     |
         { ~1 : Yellow(2) }* |
           ~1 : Green(1)     |
         { ~1 : Blue(2)   }* |
           ~1 : Green(1)     }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
Yellow(height) --> s('1, 'height, '1) color("#FCE070")
"##,
    joined(&[
        &[("Green", 1.0, 1.0)],
        &times(4, &[("Yellow", 1.0, 2.0)]),
        &[("Green", 1.0, 1.0)],
        &times(3, &[("Blue", 1.0, 2.0)]),
        &[("Green", 1.0, 1.0)],
    ])
}

example! {
    /// "Two successive repeat splits (green and yellow) are bordered by absolute splits (blue)." Repetitions are dealt out in
    /// turn; the page gives no numbers.
    parallel_absolute, "Subdivision split, Repeat split, Parallel: bordered by absolute splits", lot(),
    r##"Lot --> s(10, 1, 1)
        primitiveCube()
split(x) { 1 : Blue(2)      |
         { 2 : Green(1) }*  |
         { 1 : Yellow(1) }* |
           1 : Blue(3)      }

Blue(height) --> s('1, 'height, '1)
                 color("#84C0fC")
Green(height) --> s('1, 'height, '1) color("#9BD770")
Yellow(height) --> s('1, 'height, '1) color("#FCE070")
"##,
    joined(&[
        &[("Blue", 1.0, 2.0)],
        &times(3, &[("Green", 2.0, 1.0)]),
        &times(2, &[("Yellow", 1.0, 1.0)]),
        &[("Blue", 1.0, 3.0)],
    ])
}
