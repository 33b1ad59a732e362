//! Arrays from values: `[1, a; 2:4]` and `base : increment : limit`.

use crate::fault::FaultKind;
use crate::run::env::Env;
use crate::value::array::{Array, Element};

/// An entry of `[…]`, between commas.
#[derive(Clone, Debug)]
pub enum ArrayPart<T> {
    /// A value.
    One(T),
    /// An array whose elements are inserted side by side, such as the array of a range.
    Many(Array<T>),
}

impl<T: Element> From<T> for ArrayPart<T> {
    fn from(value: T) -> Self {
        ArrayPart::One(value)
    }
}

impl<T> From<Array<T>> for ArrayPart<T> {
    fn from(array: Array<T>) -> Self {
        ArrayPart::Many(array)
    }
}

impl<T: Element> ArrayPart<T> {
    fn rows(&self) -> usize {
        match self {
            ArrayPart::One(_) => 1,
            ArrayPart::Many(array) => array.rows(),
        }
    }

    fn columns(&self) -> usize {
        match self {
            ArrayPart::One(_) => 1,
            ArrayPart::Many(array) => array.columns(),
        }
    }

    fn row(&self, row: usize) -> &[T] {
        match self {
            ArrayPart::One(value) if row == 0 => std::slice::from_ref(value),
            ArrayPart::One(_) => &[],
            ArrayPart::Many(array) => array.row(row).unwrap_or_default(),
        }
    }
}

/// `[a, b; c, d]`: parts side by side, rows of them below each other (*array initialization function*).
///
/// Arrays without elements add nothing: `[floatArray, 1]` is `[1]`. The page defines only parts of equal height in a
/// row, and rows of equal length. In other cases the default fills the gaps, with a fault.
pub fn array<T: Element>(env: &mut Env, rows: &[&[ArrayPart<T>]]) -> Array<T> {
    let height = |row: &[ArrayPart<T>]| row.iter().map(ArrayPart::rows).max().unwrap_or_default();
    let width = |row: &[ArrayPart<T>]| row.iter().map(ArrayPart::columns).fold(0, usize::saturating_add);
    let count = rows.iter().map(|row| height(row)).fold(0, usize::saturating_add);
    let columns = rows.iter().map(|row| width(row)).max().unwrap_or_default();
    if !env.may_hold(count.saturating_mul(columns)) {
        return Array::default();
    }
    let mut values = Vec::with_capacity(count * columns);
    let mut gaps = false;
    for row in rows {
        for line in 0..height(row) {
            let end = values.len() + columns;
            for part in *row {
                let elements = part.row(line);
                values.extend_from_slice(elements);
                let missing = part.columns() - elements.len();
                gaps |= 0 < missing;
                values.extend(std::iter::repeat_n(T::default(), missing));
            }
            gaps |= values.len() < end;
            values.resize(end, T::default());
        }
    }
    if gaps {
        let what = T::default();
        env.fault(FaultKind::Value, format!("the parts of an array do not fill its rows; {what:?} fills the gaps"));
    }
    Array::new(values, count, columns)
}

/// `[base : increment : limit]`: `base`, `base + increment`, `base + 2 increment`, … up to `limit` (*colon operator*).
/// Empty when the increment is 0 or leads away from the limit.
pub fn range_by(env: &mut Env, base: f64, increment: f64, limit: f64) -> Array<f64> {
    let base = env.finite(base, "the base of a range");
    let increment = env.finite(increment, "the increment of a range");
    let limit = env.finite(limit, "the limit of a range");
    // The difference of the ends may overflow; then all values are halved.
    let scale = if (limit - base).is_finite() { 1.0 } else { 0.5 };
    let value = |number: usize| (base * scale + number as f64 * (increment * scale)) / scale;
    let exceeds = |value: f64| if 0.0 < increment { limit < value } else { value < limit };
    let steps = ((limit * scale - base * scale) / (increment * scale)).floor();
    // An increment of 0 makes no progress.
    if increment == 0.0 || steps < 0.0 {
        return Array::default();
    }
    // The conversion saturates at the largest integer.
    let count = (steps as usize).saturating_add(1);
    if !env.may_hold(count) {
        return Array::default();
    }
    let mut values: Vec<f64> = (0..count).map(value).take_while(|value| !exceeds(*value)).collect();
    // The rounded quotient may be one too small.
    let next = value(count);
    if values.len() == count && !exceeds(next) && values.last() != Some(&next) && env.may_hold(count + 1) {
        values.push(next);
    }
    Array::from(values)
}

#[cfg(test)]
mod tests {
    use super::super::super::tests::{Random, env, faults, limit, small_env, text};
    use super::*;
    use crate::fault::LimitKind;
    use crate::func::tests::range;

    fn by(base: f64, increment: f64, limit: f64) -> Vec<f64> {
        range_by(&mut env(), base, increment, limit).as_slice().to_vec()
    }

    #[test]
    fn ranges_stop_at_their_limit() {
        let env = &mut env();
        assert_eq!(range(env, 2.0, 4.0), Array::from([2.0, 3.0, 4.0]));
        assert_eq!(range(env, 0.5, 3.0), Array::from([0.5, 1.5, 2.5]));
        assert!(range(env, 4.0, 2.0).is_empty());
        assert_eq!(by(1.0, 0.5, 3.0), [1.0, 1.5, 2.0, 2.5, 3.0]);
        assert_eq!(by(4.0, -1.0, 2.0), [4.0, 3.0, 2.0]);
        assert_eq!(by(1.0, -0.5, 2.0), [0.0; 0]);
        assert_eq!(by(1.0, -0.5, 1.0), [1.0]);
        assert_eq!(by(1.0, 0.0, 1.0), [0.0; 0]);
        // "Floating point imprecision".
        assert_eq!(range_by(env, 0.0, 0.15, 0.5).to_string(), "(4)[0,0.15,0.3,0.45]");
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn ranges_of_awkward_numbers_end() {
        let env = &mut env();
        assert_eq!(range(env, f64::NAN, 2.0), Array::from([0.0, 1.0, 2.0]));
        assert!(range_by(env, 1.0, f64::INFINITY, 2.0).is_empty());
        assert_eq!(range(env, 0.0, f64::INFINITY), Array::from([0.0]));
        assert_eq!(faults(env), 3);
        assert!(by(1.0, -0.0, 1.0).is_empty());
        for (base, increment, end) in [(0.0, 1e-300, 1.0), (0.0, 1.0, 1e300), (f64::MIN, 1.0, f64::MAX)] {
            let mut env = small_env(1000, 1000);
            assert!(range_by(&mut env, base, increment, end).is_empty());
            assert_eq!(limit(&env), Some(LimitKind::Array));
        }
        assert_eq!(by(f64::MIN, f64::MAX, f64::MAX), [f64::MIN, 0.0, f64::MAX]);
        assert_eq!(range(&mut small_env(3, 0), 1.0, 3.0).len(), 3);
    }

    #[test]
    fn ranges_keep_within_their_ends_and_leave_nothing_out() {
        let mut random = Random(77);
        for _ in 0..20_000 {
            let (base, increment, end) = (random.number(), random.number() / 7.0, random.number());
            let mut env = small_env(1000, 0);
            let values = range_by(&mut env, base, increment, end);
            if env.ended() || ![base, increment, end].iter().all(|number| number.is_finite()) {
                continue;
            }
            let exceeds = |value: f64| if 0.0 < increment { end < value } else { value < end };
            if values.is_empty() {
                assert!(increment == 0.0 || exceeds(base));
                continue;
            }
            for (number, &value) in values.into_iter().enumerate() {
                assert_eq!(value, base + number as f64 * increment);
                assert!(!exceeds(value), "{base}:{increment}:{end}");
            }
            let next = base + values.len() as f64 * increment;
            let stuck = values.as_slice().last() == Some(&next);
            assert!(stuck || exceeds(next), "{base}:{increment}:{end} ends before {next}");
        }
    }

    #[test]
    fn arrays_are_built_of_values_and_arrays() {
        // *array initialization function*.
        let env = &mut env();
        let inner = Array::from(["B", "C", "D"].map(text));
        let row = array(env, &[&[text("A").into(), inner.into(), text("E").into()]]);
        assert_eq!(row.to_string(), "(5)[A,B,C,D,E]");
        let a = array(env, &[&[(-1.0).into()], &[(-2.0).into()]]);
        let range = range(env, 0.0, 2.0);
        let b = array(env, &[&[range.into()], &[3.0.into(), 3.0.into(), 3.0.into()]]);
        assert_eq!((b.rows(), b.columns()), (2, 3));
        let (a, b) = (ArrayPart::from(a), ArrayPart::from(b));
        let c = array(env, &[&[a.clone(), b.clone()], &[b, a]]);
        let lines = ["(4x4)", "   -1   0   1    2", "   -2   3   3    3", "    0   1   2   -1", "    3   3   3   -2"];
        assert_eq!(c.to_string(), lines.join("\n"));
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn arrays_without_elements_add_nothing() {
        let env = &mut env();
        let none = || ArrayPart::Many(Array::default());
        assert_eq!(array(env, &[&[none(), 1.0.into(), none()], &[none()]]), Array::from([1.0]));
        assert!(array::<f64>(env, &[&[none(), none()], &[none()]]).is_empty() && array::<bool>(env, &[]).is_empty());
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn gaps_are_filled_with_a_fault() {
        let env = &mut env();
        let down = array(env, &[&[2.0.into()], &[3.0.into()]]);
        let ragged = array(env, &[&[1.0.into(), down.into(), 4.0.into()], &[5.0.into()]]);
        assert_eq!(ragged, Array::from(vec![vec![1.0, 2.0, 4.0], vec![0.0, 3.0, 0.0], vec![5.0, 0.0, 0.0]]));
        assert_eq!(faults(env), 1);
    }

    #[test]
    fn arrays_have_a_limit() {
        let env = &mut small_env(10, 0);
        let row = ArrayPart::Many(Array::from([0.0; 4]));
        assert_eq!(array(env, &[&[row.clone(), row.clone()]]).len(), 8);
        assert!(array(env, &[&[row.clone(), row.clone(), row]]).is_empty());
        assert_eq!(limit(env), Some(LimitKind::Array));
    }
}
