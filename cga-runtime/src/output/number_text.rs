//! Numbers as text: the same digits on every machine.

use std::fmt;
use std::io::Write as _;

use crate::material::Color;

/// The shortest decimal that reads back as the same value, without exponent. −0 and numbers that are not finite are
/// written as 0.
pub(crate) struct Short<T>(pub(crate) T);

impl<T: fmt::Display + Copy + Into<f64>> fmt::Display for Short<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value: f64 = self.0.into();
        if value == 0.0 || !value.is_finite() { f.write_str("0") } else { write!(f, "{}", self.0) }
    }
}

/// Numbers as the elements of a JSON array, separated by commas.
#[cfg(feature = "gltf")]
pub(crate) fn list<T: fmt::Display + Copy + Into<f64>>(values: &[T]) -> String {
    values.iter().map(|&value| Short(value).to_string()).collect::<Vec<_>>().join(",")
}

/// The texts of recently printed numbers: neighbours have equal coordinates, and finding the shortest digits is slow.
#[derive(Debug)]
pub(crate) struct NumberTexts {
    places: Vec<CachedText>,
}

/// A number as bits, and its text. The bits 0 mark an unused entry, as 0 is never looked up.
#[derive(Clone, Copy, Debug, Default)]
struct CachedText {
    bits: u64,
    length: u8,
    text: [u8; 23],
}

/// The number of entries is a power of two; each has 32 bytes.
const PLACE_BITS: u32 = 10;

impl Default for NumberTexts {
    fn default() -> Self {
        NumberTexts { places: vec![CachedText::default(); 1 << PLACE_BITS] }
    }
}

impl NumberTexts {
    /// Appends a number as [`Short`] writes it.
    #[inline]
    pub(crate) fn push(&mut self, to: &mut Vec<u8>, value: f64) {
        if value == 0.0 || !value.is_finite() {
            return to.push(b'0');
        }
        let place = value.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (u64::BITS - PLACE_BITS);
        let known = &mut self.places[place as usize];
        if known.bits != value.to_bits() {
            return print(known, to, value);
        }
        to.extend_from_slice(&known.text[..usize::from(known.length)]);
    }
}

/// Prints a number, and keeps its text unless it is long.
#[inline(never)]
fn print(known: &mut CachedText, to: &mut Vec<u8>, value: f64) {
    let start = to.len();
    // Writing to memory does not fail.
    let _ = write!(to, "{value}");
    let text = &to[start..];
    if let Some(place) = known.text.get_mut(..text.len()) {
        place.copy_from_slice(text);
        (known.bits, known.length) = (value.to_bits(), text.len() as u8);
    }
}

/// Appends an integer.
#[inline]
pub(crate) fn push_whole(to: &mut Vec<u8>, mut value: u64) {
    let mut digits = [0; 20];
    let mut start = digits.len();
    loop {
        start -= 1;
        digits[start] = b'0' + (value % 10) as u8;
        value /= 10;
        if value == 0 {
            return to.extend_from_slice(&digits[start..]);
        }
    }
}

/// An optional share, clamped to 0..=1. NaN counts as no value.
pub(crate) fn share(value: Option<f64>, default: f64) -> f64 {
    value.filter(|value| !value.is_nan()).unwrap_or(default).clamp(0.0, 1.0)
}

/// A colour as six hexadecimal digits.
pub(crate) fn hex(color: &Color) -> String {
    let byte = |channel: f64| libm::round(channel * 255.0) as u8;
    format!("{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back() {
        let text = [0.1, -0.0, 1.0, -2.5, 1e-3, f64::NAN].map(|v| Short(v).to_string());
        assert_eq!(text, ["0.1", "0", "1", "-2.5", "0.001", "0"]);
        assert_eq!(Short(0.1f32).to_string(), "0.1");
    }

    #[test]
    fn texts_that_are_kept_are_those_of_their_numbers() {
        let mut texts = NumberTexts::default();
        let values =
            (0..5000).map(|i| f64::from(i % 1700 - 800) * 0.37).chain([1e-300, -1e-300, 1e300, f64::NAN, -0.0]);
        for value in values {
            let mut text = Vec::new();
            texts.push(&mut text, value);
            assert_eq!(String::from_utf8(text).as_deref(), Ok(&*Short(value).to_string()));
        }
        for value in [0, 9, 10, 1234567890, u64::MAX] {
            let mut text = Vec::new();
            push_whole(&mut text, value);
            assert_eq!(String::from_utf8(text).as_deref(), Ok(&*value.to_string()));
        }
    }
}
