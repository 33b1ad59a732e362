//! The texts of Parquet's dates, times and decimal numbers, the same for all readers.

use parquet::data_type::{ByteArray, Decimal};
use parquet::record::Field;

use super::quiet::quiet;

/// The most digits of a decimal number.
const DIGITS: i32 = 39;

/// The text of a date in days since 1970, as in `2024-02-29`. `None` if it is out of range.
pub fn date(days: i32) -> Option<String> {
    of_field(&Field::Date(days))
}

/// The text of a time in milliseconds since 1970, as in `2024-02-29 12:30:00.000 +00:00`. `None` if it is out of range.
pub fn milliseconds(count: i64) -> Option<String> {
    of_field(&Field::TimestampMillis(count))
}

/// The text of a time in microseconds since 1970, as in `2024-02-29 12:30:00.000000 +00:00`. `None` if it is out of range.
pub fn microseconds(count: i64) -> Option<String> {
    of_field(&Field::TimestampMicros(count))
}

/// The text of a decimal number with a number of digits after the point, as in `12.50`.
pub fn decimal(digits: i128, scale: i32) -> Option<String> {
    let bytes = ByteArray::from(digits.to_be_bytes().to_vec());
    of_field(&Field::Decimal(Decimal::from_bytes(bytes, DIGITS, scale)))
}

/// The text of a field. `None` if the library has no text for its value.
pub(super) fn of_field(field: &Field) -> Option<String> {
    let text = quiet(|| field.to_string())?;
    // Decimal numbers without digits after the point end with it.
    let is_whole = matches!(&field, Field::Decimal(number) if number.scale() == 0);
    Some(if is_whole { text.trim_end_matches('.').to_owned() } else { text })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_the_texts_of_rows() {
        assert_eq!(date(19_782).as_deref(), Some("2024-02-29"));
        assert_eq!(milliseconds(1_709_209_800_250).as_deref(), Some("2024-02-29 12:30:00.250 +00:00"));
        assert_eq!(microseconds(1_709_209_800_250_001).as_deref(), Some("2024-02-29 12:30:00.250001 +00:00"));
        assert_eq!(decimal(-1250, 2).as_deref(), Some("-12.50"));
        assert_eq!(decimal(12, 2).as_deref(), Some("0.12"));
        assert_eq!(decimal(7, 0).as_deref(), Some("7"));
    }

    #[test]
    fn values_out_of_range_have_no_text() {
        assert_eq!(milliseconds(i64::MAX), None);
        assert_eq!(decimal(7, -1), None);
    }
}
