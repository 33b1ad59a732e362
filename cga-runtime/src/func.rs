//! Functions of the language, as its table names them. Angles are in degrees; results are the same on every platform.

use crate::op::sin_cos;
use crate::shape::ShapeRef;
use crate::text::Text;

/// `rand()`: evenly in 0..1, from the shape's own stream.
pub fn rand(shape: &mut ShapeRef<'_>) -> f64 {
    shape.seed.draw()
}

/// `rand(max)`: evenly between 0 and `max`.
pub fn rand_to(shape: &mut ShapeRef<'_>, max: f64) -> f64 {
    max * shape.seed.draw()
}

/// `rand(min, max)`: evenly between the two.
pub fn rand_between(shape: &mut ShapeRef<'_>, min: f64, max: f64) -> f64 {
    min + (max - min) * shape.seed.draw()
}

/// `p(q)`: true with probability `q`; a draw is used up in any case.
pub fn chance(shape: &mut ShapeRef<'_>, q: f64) -> bool {
    shape.seed.draw() < q
}

/// The largest whole number that is not above.
pub fn floor(x: f64) -> f64 {
    x.floor()
}

/// The smallest whole number that is not below.
pub fn ceil(x: f64) -> f64 {
    x.ceil()
}

/// The nearest whole number; of two, the even one.
pub fn rint(x: f64) -> f64 {
    x.round_ties_even()
}

/// Without the sign.
pub fn abs(x: f64) -> f64 {
    x.abs()
}

/// Square root; not a number below zero.
pub fn sqrt(x: f64) -> f64 {
    x.sqrt()
}

/// Sine.
pub fn sin(degrees: f64) -> f64 {
    sin_cos(degrees).0
}

/// Cosine.
pub fn cos(degrees: f64) -> f64 {
    sin_cos(degrees).1
}

/// Tangent.
pub fn tan(degrees: f64) -> f64 {
    // A multiple of 45 is exact.
    match degrees.rem_euclid(180.0) {
        45.0 => 1.0,
        135.0 => -1.0,
        _ => {
            let (sin, cos) = sin_cos(degrees);
            sin / cos
        }
    }
}

/// Arc sine, in -90..=90.
pub fn asin(x: f64) -> f64 {
    libm::asin(x).to_degrees()
}

/// Arc cosine, in 0..=180.
pub fn acos(x: f64) -> f64 {
    libm::acos(x).to_degrees()
}

/// Arc tangent, in -90..=90.
pub fn atan(x: f64) -> f64 {
    libm::atan(x).to_degrees()
}

/// The angle of the point (x, y), in -180..=180.
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x).to_degrees()
}

/// Power.
pub fn pow(base: f64, exponent: f64) -> f64 {
    libm::pow(base, exponent)
}

/// e to the power of x.
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// Natural logarithm; `ln(-1)` is the idiom for "not a number".
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// Logarithm to base 10.
pub fn log10(x: f64) -> f64 {
    libm::log10(x)
}

/// The smaller one.
pub fn min(a: f64, b: f64) -> f64 {
    a.min(b)
}

/// The larger one.
pub fn max(a: f64, b: f64) -> f64 {
    a.max(b)
}

/// `x`, but at least `low` and at most `high`.
pub fn clamp(x: f64, low: f64, high: f64) -> f64 {
    x.max(low).min(high)
}

/// Whether `x` is not a number.
pub fn isnan(x: f64) -> bool {
    x.is_nan()
}

/// Whether `x` is infinite.
pub fn isinf(x: f64) -> bool {
    x.is_infinite()
}

/// A number as text: without trailing zeros, at most 15 digits so that rounding noise stays out of sight.
pub fn float_to_text(x: f64) -> Text {
    if x.is_nan() {
        return Text::fixed("nan");
    }
    if x.is_infinite() {
        return Text::fixed(if 0.0 < x { "inf" } else { "-inf" });
    }
    // Round in decimal, then print the shortest form of what that is.
    let rounded: f64 = format!("{x:.14e}").parse().unwrap_or(x);
    Text::from(format!("{}", if rounded == 0.0 { 0.0 } else { rounded }))
}

/// `true` or `false`.
pub fn bool_to_text(x: bool) -> Text {
    Text::fixed(if x { "true" } else { "false" })
}

/// Text stays as it is.
pub fn text_to_text(x: Text) -> Text {
    x
}

/// 1 or 0.
pub fn bool_to_float(x: bool) -> f64 {
    if x { 1.0 } else { 0.0 }
}

/// Numbers stay as they are.
pub fn float_to_float(x: f64) -> f64 {
    x
}

/// The number that the longest prefix of the text spells; not a number when none does (*float function*).
pub fn text_to_float(x: Text) -> f64 {
    let text = x.trim_start();
    let number = |end: &usize| text.get(..*end).and_then(|part| part.parse::<f64>().ok()).filter(|_| !text.is_empty());
    let plain = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E');
    let longest = text.find(|c| !plain(c)).unwrap_or(text.len());
    (1..=longest).rev().find_map(|end| number(&end)).unwrap_or(f64::NAN)
}

/// 0 is false, everything else true.
pub fn float_to_bool(x: f64) -> bool {
    x != 0.0
}

/// Truth values stay as they are.
pub fn bool_to_bool(x: bool) -> bool {
    x
}

/// `f`, `false` and zeros are false, every other text is true (*bool function*).
pub fn text_to_bool(x: Text) -> bool {
    let zero = x.parse::<f64>().is_ok_and(|number| number == 0.0);
    !(zero || matches!(x.as_str(), "f" | "false"))
}

/// One text after the other.
pub fn concat(a: Text, b: Text) -> Text {
    Text::from([a.as_str(), b.as_str()].concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_print_as_documented() {
        // *str function*.
        assert_eq!(float_to_text(1.69 - 0.69).as_str(), "1");
        assert_eq!(float_to_text(0.1 + 0.2).as_str(), "0.3");
        assert_eq!(float_to_text(-0.0).as_str(), "0");
        assert_eq!(float_to_text(1e20).as_str(), "100000000000000000000");
        assert_eq!(float_to_text(f64::NAN).as_str(), "nan");
    }

    #[test]
    fn text_reads_as_documented() {
        // *float function*, *floatArray function*, *bool function*.
        let float = |text: &'static str| text_to_float(Text::fixed(text));
        assert_eq!((float("5+6"), float("001.5"), float("-2"), float("1e")), (5.0, 1.5, -2.0, 1.0));
        assert!(float("nixda").is_nan() && float("").is_nan() && float("inf").is_nan());
        let truth = |text: &'static str| text_to_bool(Text::fixed(text));
        assert!(!truth("f") && !truth("0") && !truth("0.0") && !truth("false") && truth("x"));
    }

    #[test]
    fn angles_are_degrees_and_exact_where_they_can_be() {
        assert_eq!((sin(90.0), cos(180.0), tan(45.0), sin(720.0)), (1.0, -1.0, 1.0, 0.0));
        assert_eq!((asin(1.0), acos(-1.0), atan2(1.0, 0.0)), (90.0, 180.0, 90.0));
        assert!((sin(30.0) - 0.5).abs() < 1e-15);
    }
}
