//! Arithmetic and trigonometry. Angles are in degrees.

use crate::fault::FaultKind;
use crate::geometry::rotation::sin_cos;
use crate::run::env::Env;
use crate::value::array::Array;
use crate::value::number::Number;

macro_rules! functions {
    ($($(#[$doc:meta])* $name:ident = |$x:ident| $value:expr;)*) => {$(
        $(#[$doc])*
        #[inline]
        pub fn $name(env: &mut Env, $x: f64) -> f64 {
            let $x = env.finite($x, concat!("the argument of ", stringify!($name)));
            $value
        }
    )*};
}

functions! {
    /// The largest whole number that is not above `x` (*floor function*).
    floor = |x| x.floor();
    /// The smallest whole number that is not below `x` (*ceil function*).
    ceil = |x| x.ceil();
    /// The nearest whole number; ties go to the even one (*rint function*).
    rint = |x| x.round_ties_even();
    /// The absolute value (*abs function*).
    abs = |x| x.abs();
    /// Sine (*sin function*).
    sin = |degrees| sin_cos(degrees).0;
    /// Cosine (*cos function*).
    cos = |degrees| sin_cos(degrees).1;
    /// Tangent (*tan function*).
    tan = |degrees| tangent(degrees);
    /// Arc tangent, in -90..=90 (*atan function*).
    atan = |x| libm::atan(x).to_degrees();
    /// e to the power of x (*exp function*).
    exp = |x| libm::exp(x);
    /// Natural logarithm; `ln(-1)` is the idiom for NaN (*ln function*).
    ln = |x| libm::log(x);
    /// Logarithm to base 10 (*log10 function*).
    log10 = |x| libm::log10(x);
}

/// Square root; NaN below zero, with a fault (*sqrt function*; *CGA changelog 2018.0*).
#[inline]
pub fn sqrt(env: &mut Env, x: f64) -> f64 {
    let x = env.finite(x, "the argument of sqrt");
    if x < 0.0 {
        without_result(env, "sqrt", x, "below 0");
    }
    x.sqrt()
}

/// Arc sine, in -90..=90; NaN outside -1..=1, with a fault (*asin function*; *CGA changelog 2018.0*).
#[inline]
pub fn asin(env: &mut Env, x: f64) -> f64 {
    libm::asin(sine(env, "asin", x)).to_degrees()
}

/// Arc cosine, in 0..=180; NaN outside -1..=1, with a fault (*acos function*; *CGA changelog 2018.0*).
#[inline]
pub fn acos(env: &mut Env, x: f64) -> f64 {
    libm::acos(sine(env, "acos", x)).to_degrees()
}

/// The argument of `asin` or `acos`.
fn sine(env: &mut Env, name: &str, x: f64) -> f64 {
    let x = env.finite(x, format_args!("the argument of {name}"));
    if 1.0 < x.abs() {
        without_result(env, name, x, "outside of -1 to 1");
    }
    x
}

/// Records that a function has no value for its argument.
#[cold]
fn without_result(env: &mut Env, name: &str, x: f64, place: &str) {
    let shown = Number(x);
    env.fault(FaultKind::Value, format!("the argument of {name} is {shown}, {place}; the result is NaN"));
}

/// The tangent, exact for multiples of 45.
fn tangent(degrees: f64) -> f64 {
    match degrees.rem_euclid(180.0) {
        45.0 => 1.0,
        135.0 => -1.0,
        _ => {
            let (sin, cos) = sin_cos(degrees);
            sin / cos
        }
    }
}

/// The angle of the point (x, y), in -180..=180 (*atan2 function*).
pub fn atan2(env: &mut Env, y: f64, x: f64) -> f64 {
    let (y, x) = (env.finite(y, "y of atan2"), env.finite(x, "x of atan2"));
    libm::atan2(y, x).to_degrees()
}

/// Power (*pow function*).
pub fn pow(env: &mut Env, base: f64, exponent: f64) -> f64 {
    let (base, exponent) = (env.finite(base, "the base of pow"), env.finite(exponent, "the exponent of pow"));
    libm::pow(base, exponent)
}

/// [`floor`] of each element.
pub fn floor_each(env: &mut Env, array: Array<f64>) -> Array<f64> {
    env.map(&array, |x| x.floor())
}

/// [`ceil`] of each element.
pub fn ceil_each(env: &mut Env, array: Array<f64>) -> Array<f64> {
    env.map(&array, |x| x.ceil())
}

/// [`rint`] of each element.
pub fn rint_each(env: &mut Env, array: Array<f64>) -> Array<f64> {
    env.map(&array, |x| x.round_ties_even())
}

/// [`abs`] of each element.
pub fn abs_each(env: &mut Env, array: Array<f64>) -> Array<f64> {
    env.map(&array, |x| x.abs())
}

/// Returns true if `x` is NaN (*isnan function*).
pub fn isnan(x: f64) -> bool {
    x.is_nan()
}

/// Returns true if `x` is infinite (*isinf function*).
pub fn isinf(x: f64) -> bool {
    x.is_infinite()
}

/// [`isnan`] of each element.
pub fn isnan_each(env: &mut Env, array: Array<f64>) -> Array<bool> {
    env.map(&array, |x| x.is_nan())
}

/// [`isinf`] of each element.
pub fn isinf_each(env: &mut Env, array: Array<f64>) -> Array<bool> {
    env.map(&array, |x| x.is_infinite())
}

#[cfg(test)]
mod tests {
    use super::super::tests::{env, faults};
    use super::*;

    #[test]
    fn angles_are_degrees_and_exact_where_they_can_be() {
        let env = &mut env();
        assert_eq!((sin(env, 90.0), cos(env, 180.0), tan(env, 45.0), sin(env, 720.0)), (1.0, -1.0, 1.0, 0.0));
        assert_eq!((tan(env, 135.0), tan(env, -45.0), cos(env, -270.0)), (-1.0, -1.0, 0.0));
        assert_eq!((asin(env, 1.0), acos(env, -1.0), atan(env, 1.0)), (90.0, 180.0, 45.0));
        assert_eq!((atan2(env, 1.0, 0.0), atan2(env, 0.0, -1.0), atan2(env, -1.0, 0.0)), (90.0, 180.0, -90.0));
        assert!((sin(env, 30.0) - 0.5).abs() < 1e-15);
        assert_eq!(faults(env), 0);
        assert!(asin(env, 1.5).is_nan() && acos(env, -1.5).is_nan());
        assert_eq!(faults(env), 2);
        assert_eq!((asin(env, f64::NAN), acos(env, f64::NAN)), (0.0, 90.0));
        assert_eq!(faults(env), 2, "an argument that is not finite is one fault");
    }

    #[test]
    fn numbers_are_rounded() {
        let env = &mut env();
        assert_eq!((floor(env, -1.5), ceil(env, -1.5), abs(env, -1.5)), (-2.0, -1.0, 1.5));
        assert_eq!([0.5, 1.5, 2.4, -2.6].map(|x| rint(env, x)), [0.0, 2.0, 2.0, -3.0]);
        let array = Array::from([-1.5, 2.0]);
        assert_eq!(floor_each(env, array.clone()), Array::from([-2.0, 2.0]));
        assert_eq!(ceil_each(env, array.clone()), Array::from([-1.0, 2.0]));
        assert_eq!(rint_each(env, array.clone()), Array::from([-2.0, 2.0]));
        assert_eq!(abs_each(env, array), Array::from([1.5, 2.0]));
        assert!(abs_each(env, Array::from([f64::NAN])).as_slice()[0].is_nan(), "a missing value stays missing");
    }

    #[test]
    fn powers_and_logarithms() {
        let env = &mut env();
        assert_eq!((pow(env, 2.0, 10.0), exp(env, 0.0), log10(env, 1000.0), sqrt(env, 9.0)), (1024.0, 1.0, 3.0, 3.0));
        assert_eq!(sqrt(env, -0.0), 0.0);
        assert_eq!(faults(env), 0);
        assert!(sqrt(env, -1.0).is_nan());
        assert_eq!(faults(env), 1);
    }

    #[test]
    fn infinite_and_nan_are_recognised() {
        let env = &mut env();
        let (infinite, none) = (ln(env, 0.0), ln(env, -1.0));
        assert!(isinf(infinite) && !isnan(infinite) && !isinf(none) && isnan(none));
        assert_eq!(isinf_each(env, Array::from([1.0, 1.0 / 0.0])), Array::from([false, true]));
        assert_eq!(isnan_each(env, Array::from([1.0, none])), Array::from([false, true]));
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn what_is_not_finite_counts_as_zero() {
        let env = &mut env();
        assert_eq!((floor(env, f64::NAN), cos(env, f64::INFINITY), exp(env, f64::NEG_INFINITY)), (0.0, 1.0, 1.0));
        assert_eq!((pow(env, f64::NAN, 0.0), atan2(env, f64::NAN, 1.0)), (1.0, 0.0));
        assert_eq!(faults(env), 5);
    }
}
