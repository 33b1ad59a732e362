//! Functions of the language, with the names in its table. Angles are in degrees; results are the same on every
//! platform.
//!
//! A function takes the run's [`Env`](crate::run::env::Env) first if an argument can be unusable or its result can be
//! large. NaN and infinite arguments count as 0 and leave a fault (*CGA changelog 2013.1*: "replace with zero", for all
//! float parameters). Elements of arrays are not replaced, because NaN is a missing value there (*isNull function*).
//! Counts and indices are truncated.

mod array;
mod choose;
mod colour;
mod compare;
mod convert;
pub mod host;
mod limit;
mod list;
mod math;
mod path;
mod ramp;
mod random;
mod split;
mod string;
#[cfg(test)]
pub(crate) mod tests;

pub use array::*;
pub use choose::*;
pub use colour::*;
pub use compare::*;
pub use convert::*;
pub use list::*;
pub use math::*;
pub use path::*;
pub use ramp::*;
pub use random::*;
pub use split::*;
pub use string::*;

/// A count or an index, truncated. `None` below 0 and for NaN. The reference does not define fractions; C's conversion
/// of a float to an integer truncates them.
fn whole(number: f64) -> Option<usize> {
    let number = number.trunc();
    // The conversion saturates at the largest integer.
    if 0.0 <= number { Some(number as usize) } else { None }
}
