//! Numbers as text: the same digits on every machine.

use std::fmt;

/// The shortest decimal that reads back as the same value, without exponent; −0 as 0 and what is not finite as 0.
pub(crate) struct Short<T>(pub(crate) T);

impl fmt::Display for Short<f64> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            v if v == 0.0 || !v.is_finite() => f.write_str("0"),
            v => write!(f, "{v}"),
        }
    }
}

impl fmt::Display for Short<f32> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            v if v == 0.0 || !v.is_finite() => f.write_str("0"),
            v => write!(f, "{v}"),
        }
    }
}

/// Numbers as the elements of a JSON array, separated by commas.
#[cfg(feature = "gltf")]
pub(crate) fn list<T: Copy>(values: &[T]) -> String
where
    Short<T>: fmt::Display,
{
    let mut text = String::new();
    for (i, &value) in values.iter().enumerate() {
        let comma = if i == 0 { "" } else { "," };
        text += &format!("{comma}{}", Short(value));
    }
    text
}

/// From an sRGB channel to linear light, both in 0..=1.
pub(crate) fn linear(srgb: f64) -> f64 {
    match srgb {
        c if c <= 0.04045 => c / 12.92,
        c => libm::pow((c + 0.055) / 1.055, 2.4),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back() {
        let text = [0.1, -0.0, 1.0, -2.5, 1e-3, f64::NAN].map(|v| Short(v).to_string());
        assert_eq!(text, ["0.1", "0", "1", "-2.5", "0.001", "0"]);
        assert_eq!(Short(0.1f32).to_string(), "0.1");
        assert_eq!((linear(0.0), linear(1.0)), (0.0, 1.0));
    }
}
