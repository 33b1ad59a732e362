//! Operators that work element by element: `.+`, `.==`, `.&&`, … (*Array types operators*).
//!
//! One side may be a single value, which is combined with every element of the other side. Two arrays must have the
//! same shape; otherwise the result is empty, with a fault.

use crate::fault::FaultKind;
use crate::run::env::Env;
use crate::value::array::{Array, Element, Printed};
use crate::value::compare::Compare;
use crate::value::text::Text;

/// An operand of such an operator: a value or an array.
pub trait Operand {
    /// The type of its values.
    type Item: Element;

    /// Rows and columns; `None` for a single value.
    fn form(&self) -> Option<(usize, usize)>;

    /// The element with this number, counted row by row; the default beyond the end.
    fn item(&self, number: usize) -> Self::Item;
}

impl<T: Element> Operand for Array<T> {
    type Item = T;

    fn form(&self) -> Option<(usize, usize)> {
        Some((self.rows(), self.columns()))
    }

    fn item(&self, number: usize) -> T {
        self.get(number).cloned().unwrap_or_default()
    }
}

macro_rules! single_values {
    ($([$ty:ty])*) => {$(
        impl Operand for $ty {
            type Item = $ty;

            fn form(&self) -> Option<(usize, usize)> {
                None
            }

            fn item(&self, _: usize) -> $ty {
                self.clone()
            }
        }
    )*};
}

single_values! { [f64] [bool] [Text] }

/// The rows and columns of the result. `None`, with a fault, when the operands differ in shape.
fn common_form(env: &mut Env, what: &str, a: &impl Operand, b: &impl Operand) -> Option<(usize, usize)> {
    match (a.form(), b.form()) {
        (Some(left), Some(right)) if left != right => {
            let ((rows, columns), (other_rows, other_columns)) = (left, right);
            env.fault(
                FaultKind::Value,
                format!("{what} of {rows}x{columns} and {other_rows}x{other_columns} elements; the result has none"),
            );
            None
        }
        (Some(form), _) | (None, Some(form)) => Some(form),
        (None, None) => Some((1, 1)),
    }
}

/// Returns true if two arrays have the same shape; if not, there is a fault.
pub(in super::super) fn same_form<T: Element>(env: &mut Env, what: &str, a: &Array<T>, b: &Array<T>) -> bool {
    common_form(env, what, a, b).is_some()
}

/// Applies a function to each pair of elements.
pub(in super::super) fn each_pair<A: Operand, B: Operand, R: Element>(
    env: &mut Env,
    what: &str,
    a: A,
    b: B,
    pair: impl Fn(A::Item, B::Item) -> R,
) -> Array<R> {
    let Some((rows, columns)) = common_form(env, what, &a, &b) else { return Array::default() };
    if !env.may_hold(rows * columns) {
        return Array::default();
    }
    let values: Vec<R> = (0..rows * columns).map(|number| pair(a.item(number), b.item(number))).collect();
    Array::new(values, rows, columns)
}

macro_rules! operators {
    ($($(#[$doc:meta])* $name:ident = $what:literal $item:ty, $result:ty, $pair:expr;)*) => {$(
        $(#[$doc])*
        pub fn $name(
            env: &mut Env,
            a: impl Operand<Item = $item>,
            b: impl Operand<Item = $item>,
        ) -> Array<$result> {
            each_pair(env, $what, a, b, $pair)
        }
    )*};
}

operators! {
    /// `a .+ b`.
    each_add = ".+" f64, f64, |a, b| a + b;
    /// `a .- b`.
    each_subtract = ".-" f64, f64, |a, b| a - b;
    /// `a .* b`.
    each_multiply = ".*" f64, f64, |a, b| a * b;
    /// `a ./ b`.
    each_divide = "./" f64, f64, |a, b| a / b;
    /// `a .% b`: the remainder, with the sign of `a`.
    each_remainder = ".%" f64, f64, |a, b| a % b;
    /// `a .&& b`.
    each_and = ".&&" bool, bool, |a, b| a & b;
    /// `a .|| b`.
    each_or = ".||" bool, bool, |a, b| a | b;
}

macro_rules! comparisons {
    ($($(#[$doc:meta])* $name:ident = $what:literal $test:ident;)*) => {$(
        $(#[$doc])*
        pub fn $name<A: Operand>(env: &mut Env, a: A, b: impl Operand<Item = A::Item>) -> Array<bool> {
            each_pair(env, $what, a, b, |a, b| a.compare(&b).$test())
        }
    )*};
}

comparisons! {
    /// `a .== b`.
    each_equal = ".==" is_eq;
    /// `a .!= b`.
    each_unequal = ".!=" is_ne;
    /// `a .< b`.
    each_less = ".<" is_lt;
    /// `a .<= b`.
    each_less_equal = ".<=" is_le;
    /// `a .> b`.
    each_greater = ".>" is_gt;
    /// `a .>= b`.
    each_greater_equal = ".>=" is_ge;
}

/// `.- a`.
pub fn each_minus(env: &mut Env, a: Array<f64>) -> Array<f64> {
    env.map(&a, |value| -value)
}

/// `.! a`.
pub fn each_not(env: &mut Env, a: Array<bool>) -> Array<bool> {
    env.map(&a, |value| !value)
}

/// `a .+ b` where one side is text: both as text, joined.
pub fn each_concat(env: &mut Env, a: impl Operand, b: impl Operand) -> Array<Text> {
    let Some((rows, columns)) = common_form(env, ".+", &a, &b) else { return Array::default() };
    if !env.may_hold(rows * columns) {
        return Array::default();
    }
    let mut values = Vec::with_capacity(rows * columns);
    let mut bytes = 0;
    for number in 0..rows * columns {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = a.item(number).print(&mut text).and_then(|()| b.item(number).print(&mut text));
        bytes += text.len();
        if !env.may_print(bytes) {
            return Array::default();
        }
        values.push(Text::from(text));
    }
    if !env.may_write(bytes) {
        return Array::default();
    }
    Array::new(values, rows, columns)
}

#[cfg(test)]
mod tests {
    use super::super::super::tests::{env, faults, limit, small_env, text};
    use super::*;
    use crate::fault::LimitKind;

    fn row<T: Element, const N: usize>(values: [T; N]) -> Array<T> {
        Array::from(values)
    }

    fn down<T: Element, const N: usize>(values: [T; N]) -> Array<T> {
        Array::new(values.to_vec(), N, 1)
    }

    fn square<T: Element>([a, b, c, d]: [T; 4]) -> Array<T> {
        Array::from(vec![vec![a, b], vec![c, d]])
    }

    #[test]
    fn arithmetic_works_element_by_element() {
        // *Array types operators*, every example.
        let env = &mut env();
        assert_eq!(each_add(env, row([1.0, 2.0]), 1.0), row([2.0, 3.0]));
        assert_eq!(each_add(env, 1.0, down([1.0, 2.0])), down([2.0, 3.0]));
        assert_eq!(each_add(env, row([1.0, 2.0]), row([2.0, 1.0])), row([3.0, 3.0]));
        assert_eq!(each_subtract(env, square([1.0, 2.0, 3.0, 4.0]), 1.0), square([0.0, 1.0, 2.0, 3.0]));
        assert_eq!(each_subtract(env, 3.0, row([1.0, 2.0])), row([2.0, 1.0]));
        assert_eq!(each_subtract(env, down([3.0, 2.0]), down([2.0, 1.0])), down([1.0, 1.0]));
        assert_eq!(each_minus(env, down([1.0, 2.0])), down([-1.0, -2.0]));
        assert_eq!(each_multiply(env, row([4.0, 2.0]), 2.5), row([10.0, 5.0]));
        assert_eq!(each_multiply(env, -4.0, down([0.25, -0.75, -1.0])), down([-1.0, 3.0, 4.0]));
        let product = each_multiply(env, square([1.0, 2.0, 3.0, 4.0]), square([4.0, 3.0, 2.0, 1.0]));
        assert_eq!(product, square([4.0, 6.0, 6.0, 4.0]));
        assert_eq!(each_divide(env, down([4.0, 3.0]), 2.0), down([2.0, 1.5]));
        assert_eq!(each_divide(env, 12.0, row([2.0, 3.0, 4.0])), row([6.0, 4.0, 3.0]));
        assert_eq!(each_divide(env, row([1.6, 3.8]), row([0.8, 1.9])), row([2.0, 2.0]));
        assert_eq!(each_remainder(env, down([8.0, -5.0, 0.0]), 3.0), down([2.0, -2.0, 0.0]));
        assert_eq!(each_remainder(env, 7.0, row([2.7, -3.0])).to_string(), "(2)[1.6,1]");
        assert_eq!(each_remainder(env, row([-5.0, 3.8]), row([-3.0, 0.7])).to_string(), "(2)[-2,0.3]");
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn logic_and_comparison_work_element_by_element() {
        // *Array types operators*, the examples.
        let env = &mut env();
        assert_eq!(each_not(env, row([true, false])), row([false, true]));
        assert_eq!(each_or(env, row([true, false]), true), row([true, true]));
        assert_eq!(each_or(env, false, down([false, true])), down([false, true]));
        assert_eq!(each_or(env, row([false, true]), row([false, false])), row([false, true]));
        assert_eq!(each_and(env, down([false, true]), true), down([false, true]));
        assert_eq!(each_and(env, false, down([true; 3])), down([false; 3]));
        assert_eq!(each_and(env, row([true, false]), row([false, true])), row([false, false]));
        assert_eq!(each_equal(env, 1.0, row([1.0, 2.0])), row([true, false]));
        assert_eq!(each_equal(env, row(["a", "b"].map(text)), text("b")), row([false, true]));
        assert_eq!(each_equal(env, down([true, false]), down([true, false])), down([true, true]));
        let unequal = each_unequal(env, square([1.0, 1.0, 2.0, 2.0]), square([1.0, 2.0, 1.0, 2.0]));
        assert_eq!(unequal, square([false, true, true, false]));
        assert_eq!(each_unequal(env, row([text("a")]), text("a")), row([false]));
        assert_eq!(each_unequal(env, false, row([true])), row([true]));
        let greater = each_greater(env, square([1.0, 2.0, 3.0, 4.0]), square([1.0, 1.0, 3.0, 3.0]));
        assert_eq!(greater, square([false, true, false, true]));
        assert_eq!(each_greater(env, text("a"), down(["a", "a"].map(text))), down([false, false]));
        assert_eq!(each_greater(env, down(["a", "b"].map(text)), text("a")), down([false, true]));
        let greater = each_greater_equal(env, down([1.0, 2.0, 3.0]), down([2.0, 2.0, 2.0]));
        assert_eq!(greater, down([false, true, true]));
        assert_eq!(each_greater_equal(env, 2.0, row([1.0, 2.0, 3.0])), row([true, true, false]));
        assert_eq!(each_less(env, 1.0, row([1.0, 2.0])), row([false, true]));
        assert_eq!(each_less_equal(env, 1.0, row([1.0, 2.0, 0.0])), row([true, true, false]));
        assert_eq!(each_less(env, row([f64::NAN]), 0.0), row([true]), "as for single values");
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn text_is_joined_element_by_element() {
        // *Array types operators*, the examples.
        let env = &mut env();
        let texts = |values: [&str; 2]| row(values.map(text));
        assert_eq!(each_concat(env, texts(["a", "b"]), text("c")), texts(["ac", "bc"]));
        assert_eq!(each_concat(env, text("a"), down(["b", "c"].map(text))), down(["ab", "ac"].map(text)));
        assert_eq!(each_concat(env, texts(["a", "b"]), texts(["c", "d"])), texts(["ac", "bd"]));
        assert_eq!(each_concat(env, texts(["a", "b"]), 1.0), texts(["a1", "b1"]));
        let numbered = each_concat(env, text("a"), square([1.0, 2.0, 3.0, 4.0]));
        assert_eq!(numbered, square(["a1", "a2", "a3", "a4"].map(text)));
        assert_eq!(each_concat(env, down([1.0, 2.0]), down(["a", "b"].map(text))), down(["1a", "2b"].map(text)));
        assert_eq!(each_concat(env, down([true, false]), text("a")), down(["truea", "falsea"].map(text)));
        assert_eq!(each_concat(env, text("a"), row([true])), row([text("atrue")]));
        let truths = each_concat(env, down(["a", "b"].map(text)), down([false, true]));
        assert_eq!(truths, down(["afalse", "btrue"].map(text)));
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn forms_must_agree() {
        let env = &mut env();
        assert!(each_add(env, row([1.0, 2.0]), row([1.0])).is_empty());
        assert!(each_equal(env, row([1.0, 2.0]), down([1.0, 2.0])).is_empty());
        assert!(each_concat(env, row([1.0, 2.0]), row([text("a")])).is_empty());
        assert_eq!(faults(env), 3);
        assert!(each_add(env, Array::default(), 1.0).is_empty());
        assert!(each_add(env, Array::default(), Array::default()).is_empty());
        assert_eq!(faults(env), 0);
    }

    #[test]
    fn texts_have_a_limit() {
        let env = &mut small_env(10, 5);
        assert_eq!(each_concat(env, text("a"), row([1.0, 2.0])).len(), 2);
        assert!(each_concat(env, text("a"), row([1.0, 2.0, 3.0])).is_empty());
        assert_eq!(limit(env), Some(LimitKind::Text));
    }
}
