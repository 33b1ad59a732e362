//! The relational operators.

use crate::value::compare::Compare;

/// `a == b`. Arrays are equal if they have the same shape and equal elements.
#[inline]
pub fn equal<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_eq()
}

/// `a != b`.
#[inline]
pub fn unequal<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_ne()
}

/// `a < b`.
#[inline]
pub fn less<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_lt()
}

/// `a <= b`.
#[inline]
pub fn less_equal<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_le()
}

/// `a > b`.
#[inline]
pub fn greater<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_gt()
}

/// `a >= b`.
#[inline]
pub fn greater_equal<T: Compare>(a: T, b: T) -> bool {
    a.compare(&b).is_ge()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::value::array::Array;
    use crate::value::text::Text;

    fn column(values: &[&'static str]) -> Array<Text> {
        Array::from(values.iter().map(|&value| vec![Text::fixed(value)]).collect::<Vec<_>>())
    }

    #[test]
    fn arrays_are_compared_row_by_row() {
        // *Array types operators*.
        let row = |values: &[f64]| Array::from(values.to_vec());
        let down = Array::from(vec![vec![1.0], vec![2.0]]);
        assert!(!equal(row(&[1.0, 2.0]), down.clone()) && unequal(row(&[1.0, 2.0]), down));
        assert!(less(row(&[1.0, 2.0]), row(&[1.0, 3.0])) && greater(row(&[1.0, 3.0]), row(&[1.0, 2.0])));
        assert!(!less_equal(column(&["a", "b"]), column(&["a"])) && greater(column(&["a", "b"]), column(&["a"])));
        assert!(greater_equal(column(&["a", "b"]), column(&["a", "b"])));
        assert!(greater_equal(row(&[1.0, 2.0, 3.0]), row(&[1.0, 2.0])));
        // The number of columns decides before the second rows are compared.
        let wide = Array::from(vec![vec![1.0, 2.0], vec![0.0, 0.0]]);
        let narrow = Array::from(vec![vec![1.0], vec![9.0]]);
        assert!(less(narrow, wide));
        assert!(less(Array::default(), row(&[-1.0])) && equal(Array::<f64>::default(), Array::default()));
        assert!(unequal(Array::from([true, true]), Array::from([true, false])));
    }

    #[test]
    fn no_number_is_less_and_not_equal() {
        let none = f64::NAN;
        for (a, b) in [(none, 1.0), (1.0, none), (none, none)] {
            assert!(less(a, b) && less_equal(a, b) && unequal(a, b));
            assert!(!equal(a, b) && !greater(a, b) && !greater_equal(a, b));
            assert!(less(Array::from([a]), Array::from([b])) && unequal(Array::from([a]), Array::from([b])));
        }
        assert!(equal(0.0, -0.0) && less(f64::NEG_INFINITY, f64::INFINITY));
    }

    #[test]
    fn text_is_compared_by_characters() {
        assert!(less(Text::fixed("abc"), Text::fixed("abd")) && less(Text::fixed("ab"), Text::fixed("abc")));
        assert!(less(Text::fixed("Z"), Text::fixed("a")) && greater(Text::fixed("ä"), Text::fixed("z")));
    }
}
