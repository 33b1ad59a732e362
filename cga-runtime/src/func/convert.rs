//! Conversions between types.

use super::array::each_concat;
use crate::run::env::Env;
use crate::value::array::{Array, Element, Printed};
use crate::value::number::Number;
use crate::value::text::Text;

/// The text that represents "no value" (*isNull function*). The number that does so is NaN.
const NULL: &str = "\u{e000}";

/// A number as text, as in `str(1.5)` (*str function*).
pub fn float_to_text(x: f64) -> Text {
    Text::from(Number(x).to_string())
}

/// `true` or `false` (*str function*).
pub fn bool_to_text(x: bool) -> Text {
    Text::fixed(if x { "true" } else { "false" })
}

/// Text stays as it is.
pub fn text_to_text(x: Text) -> Text {
    x
}

/// An array in the form that `print` shows (*str function*).
pub fn array_to_text<T: Element>(env: &mut Env, array: Array<T>) -> Text {
    // Many elements may share one long text. The lower bound refuses such an array without printing the text for each
    // element.
    let bytes = array.into_iter().map(Printed::least_bytes).fold(0, usize::saturating_add);
    if env.may_print(bytes) { env.write(array) } else { Text::default() }
}

/// 1 or 0 (*float function*).
pub fn bool_to_float(x: bool) -> f64 {
    if x { 1.0 } else { 0.0 }
}

/// The number at the beginning of the text, after spaces. NaN without one (*float function*, *floatArray function*).
pub fn text_to_float(x: Text) -> f64 {
    let text = x.trim_start();
    // Parses only the bytes of the number, even in a long text.
    text.get(..number_length(text.as_bytes())).and_then(|number| number.parse().ok()).unwrap_or(f64::NAN)
}

/// The number of bytes of the number at the beginning; 0 without one.
fn number_length(text: &[u8]) -> usize {
    let digits = |from: usize| text[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let sign = |at: usize| usize::from(matches!(text.get(at), Some(b'+' | b'-')));
    let start = sign(0);
    let whole = digits(start);
    let mut end = start + whole;
    if text.get(end) == Some(&b'.') {
        let fraction = digits(end + 1);
        if whole + fraction == 0 {
            return 0;
        }
        end += 1 + fraction;
    } else if whole == 0 {
        return 0;
    }
    if matches!(text.get(end), Some(b'e' | b'E')) {
        let exponent = end + 1 + sign(end + 1);
        let length = digits(exponent.min(text.len()));
        if 0 < length {
            end = exponent + length;
        }
    }
    end
}

/// 0 is false and everything else is true (*bool function*; *CGA changelog 2020.0*: also NaN).
pub fn float_to_bool(x: f64) -> bool {
    x != 0.0
}

/// `f`, `false` and zeros are false, every other text is true (*bool function*).
pub fn text_to_bool(x: Text) -> bool {
    truth(&x)
}

fn truth(text: &str) -> bool {
    let zero = number_length(text.as_bytes()) == text.len() && text.parse::<f64>().is_ok_and(|number| number == 0.0);
    !(zero || matches!(text, "f" | "false"))
}

/// `floatArray()` (*floatArray function*).
pub fn no_floats() -> Array<f64> {
    Array::default()
}

/// `boolArray()` (*boolArray function*).
pub fn no_bools() -> Array<bool> {
    Array::default()
}

/// `stringArray()` (*stringArray function*).
pub fn no_texts() -> Array<Text> {
    Array::default()
}

/// [`bool_to_float`] of each element (*floatArray function*).
pub fn floats_from_bools(env: &mut Env, array: Array<bool>) -> Array<f64> {
    env.map(&array, |truth| bool_to_float(*truth))
}

/// [`text_to_float`] of each element (*floatArray function*).
pub fn floats_from_texts(env: &mut Env, array: Array<Text>) -> Array<f64> {
    env.map(&array, |text| text_to_float(text.clone()))
}

/// [`float_to_bool`] of each element (*boolArray function*).
pub fn bools_from_floats(env: &mut Env, array: Array<f64>) -> Array<bool> {
    env.map(&array, |number| float_to_bool(*number))
}

/// [`text_to_bool`] of each element (*boolArray function*).
pub fn bools_from_texts(env: &mut Env, array: Array<Text>) -> Array<bool> {
    env.map(&array, |text| truth(text))
}

/// [`float_to_text`] of each element (*stringArray function*).
pub fn texts_from_floats(env: &mut Env, array: Array<f64>) -> Array<Text> {
    each_concat(env, array, Text::default())
}

/// [`bool_to_text`] of each element (*stringArray function*).
pub fn texts_from_bools(env: &mut Env, array: Array<bool>) -> Array<Text> {
    env.map(&array, |truth| bool_to_text(*truth))
}

/// Returns true if a number represents "no value" (*isNull function*).
pub fn isnull_float(x: f64) -> bool {
    x.is_nan()
}

/// Returns true if a text represents "no value" (*isNull function*).
pub fn isnull_text(x: Text) -> bool {
    x.as_str() == NULL
}

/// [`isnull_float`] of each element.
pub fn isnull_float_each(env: &mut Env, array: Array<f64>) -> Array<bool> {
    env.map(&array, |number| number.is_nan())
}

/// [`isnull_text`] of each element.
pub fn isnull_text_each(env: &mut Env, array: Array<Text>) -> Array<bool> {
    env.map(&array, |text| text.as_str() == NULL)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{env, limit, small_env, text};
    use super::*;
    use crate::fault::LimitKind;

    #[test]
    fn numbers_print_as_documented() {
        // *str function*.
        let cases = [
            (1.69, "1.69"),
            (1.69 - 0.69, "1"),
            (0.1 + 0.2, "0.3"),
            (-0.0, "0"),
            (-2.5, "-2.5"),
            (1e15 - 1.0, "999999999999999"),
            (1e20, "100000000000000000000"),
            (-123_456_789_012_345_678.0, "-123456789012346000"),
            (1e-7, "0.0000001"),
            (191.0 / 255.0, "0.749019607843137"),
            (f64::NAN, "nan"),
            (f64::INFINITY, "inf"),
            (f64::NEG_INFINITY, "-inf"),
        ];
        for (number, printed) in cases {
            assert_eq!(float_to_text(number).as_str(), printed);
        }
        assert_eq!(float_to_text(f64::MAX).len(), 309);
        assert!(float_to_text(f64::MIN_POSITIVE / 2.0).starts_with("0.000"));
    }

    #[test]
    fn arrays_become_text() {
        let env = &mut env();
        assert_eq!(array_to_text(env, Array::from([0.0, 1.0, 2.0])).as_str(), "(3)[0,1,2]");
        let rows = Array::from(vec![vec![1.0, 2.0], vec![3.0, 4.0]]);
        assert_eq!(array_to_text(env, rows).as_str(), "(2x2)\n   1   2\n   3   4");
        let env = &mut small_env(100, 20);
        // Three cells with a width of eight characters: the first text widens the column.
        array_to_text(env, Array::from(vec![vec![text("12345678")], vec![text("")], vec![text("")]]));
        assert_eq!(limit(env), Some(LimitKind::Text));
        let env = &mut super::super::tests::env();
        let long = text(&"x".repeat(9_000_000));
        array_to_text(env, Array::new(vec![long; 50_000], 25_000, 2));
        assert_eq!(limit(env), Some(LimitKind::Text));
    }

    #[test]
    fn text_is_parsed_as_documented() {
        // *float function*, *floatArray function*, *bool function*.
        let float = |x: &str| text_to_float(text(x));
        assert_eq!((float("5+6"), float("001.5"), float("-2"), float("1e"), float("1e+")), (5.0, 1.5, -2.0, 1.0, 1.0));
        assert_eq!(
            (float(" .5"), float("5."), float("+1e2x"), float("1.2.3"), float("0x1")),
            (0.5, 5.0, 100.0, 1.2, 0.0)
        );
        for none in ["nixda", "", "inf", "nan", ".", "-", "-.", "e5", "ü1", "+-1"] {
            assert!(float(none).is_nan(), "{none}");
        }
        assert_eq!(float("1e999"), f64::INFINITY);
        for (x, expected) in [("f", false), ("false", false), ("0", false), ("0.0", false), ("-0", false), ("x", true)]
        {
            assert_eq!(text_to_bool(text(x)), expected, "{x}");
        }
        assert!(text_to_bool(text("")) && text_to_bool(text("1")) && text_to_bool(text("true")));
        assert!(float_to_bool(6.66) && !float_to_bool(-0.0) && float_to_bool(f64::NAN));
        assert_eq!((bool_to_float(true), float_to_text(1.0 / 0.0).as_str()), (1.0, "inf"));
    }

    #[test]
    fn long_texts_read_in_time() {
        let digits = "1".repeat(300_000);
        assert!(text_to_float(text(&format!("{digits}{}", "e".repeat(300_000)))).is_infinite());
        assert_eq!(text_to_float(text(&format!("1{}", ".1".repeat(300_000)))), 1.1);
    }

    #[test]
    fn arrays_are_converted() {
        let env = &mut env();
        let numbers = floats_from_texts(env, Array::from(["1.5", "-2", "0", "nixda", "5+6"].map(text)));
        assert_eq!(numbers.to_string(), "(5)[1.5,-2,0,nan,5]");
        assert_eq!(floats_from_bools(env, Array::from([true, false, true])), Array::from([1.0, 0.0, 1.0]));
        assert_eq!(bools_from_floats(env, Array::from([1.0, 0.0, 20.0])), Array::from([true, false, true]));
        let truths = Array::from(["true", "1", "0", "f", "false", "schwiizer nati"].map(text));
        assert_eq!(bools_from_texts(env, truths), Array::from([true, true, false, false, false, true]));
        assert_eq!(texts_from_floats(env, Array::from([1.0, 1.777, 20.0])).to_string(), "(3)[1,1.777,20]");
        assert_eq!(texts_from_bools(env, Array::from([true, false])), Array::from(["true", "false"].map(text)));
        assert!(no_floats().is_empty() && no_bools().is_empty() && no_texts().is_empty());
        texts_from_floats(&mut small_env(10, 4), Array::from([1.25]));
        let env = &mut small_env(10, 3);
        assert!(texts_from_floats(env, Array::from([1.25])).is_empty());
        assert_eq!(limit(env), Some(LimitKind::Text));
    }

    #[test]
    fn null_is_nan_or_a_private_character() {
        // *isNull function*.
        let env = &mut env();
        assert!(isnull_float(f64::NAN) && !isnull_float(0.0) && !isnull_float(f64::INFINITY));
        assert!(isnull_text(text("\u{e000}")) && !isnull_text(text("CityEngine")) && !isnull_text(text("")));
        assert_eq!(
            isnull_text_each(env, Array::from(["CityEngine", "\u{e000}"].map(text))),
            Array::from([false, true])
        );
        assert_eq!(isnull_float_each(env, Array::from([0.0, f64::NAN])), Array::from([false, true]));
    }
}
