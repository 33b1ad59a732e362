//! Values of functions and attributes, as known at compile time.

/// The meaning of a function to constant folding and to the analysis of values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// Unknown at compile time.
    Opaque,
    /// The largest whole number that is not greater.
    Floor,
    /// The smallest whole number that is not less.
    Ceil,
    /// The nearest whole number, the even one if two are equally near.
    Round,
    /// The number without its sign.
    Abs,
    /// The square root.
    Sqrt,
    /// A number from -1 to 1, as of a sine.
    Wave,
    /// The minimum of two numbers.
    Min,
    /// The maximum of two numbers.
    Max,
    /// The number of a truth value.
    BoolToFloat,
    /// The truth value of a number.
    FloatToBool,
    /// A random number: from 0 to 1, from 0 to the argument, or from one argument to the other.
    Random,
    /// True with the given probability.
    Chance,
}

/// The values that an attribute of shapes may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AttrValues {
    /// Any value of its type.
    Any,
    /// The size of the scope along the axis with this number.
    Size(usize),
    /// Finite numbers from this number.
    From(f64),
}
