//! Values of functions and attributes, as far as they are known at compile time.

/// The meaning of a function to constant folding and to the analysis of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// Not known at compile time.
    Opaque,
    /// The largest whole number that is not above.
    Floor,
    /// The smallest whole number that is not below.
    Ceil,
    /// The nearest whole number, the even one of two.
    Round,
    /// The number without its sign.
    Abs,
    /// The square root.
    Sqrt,
    /// A number from -1 to 1.
    Wave,
    /// The smaller one of two numbers.
    Min,
    /// The larger one of two numbers.
    Max,
    /// The number of a truth value.
    BoolToFloat,
    /// The truth value of a number.
    FloatToBool,
    /// A random number: from 0 to 1, from 0 to the argument, or from one argument to the other.
    Random,
    /// True with that probability.
    Chance,
}

/// The values that an attribute of shapes may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AttrValues {
    /// Any value of its type.
    Any,
    /// The size of the scope along the axis of that number.
    Size(usize),
    /// Finite numbers, from that number on.
    From(f64),
}
