//! Values of short arrays, mapped one by one.

/// `array::map` for arrays of two to four values, with less work for the compiler: `map` also drops the results so far if
/// the function panics, which is 300 lines of IR for each closure.
pub trait Each<T, const N: usize> {
    /// The results of a function for all values, in order.
    fn each<U>(self, f: impl FnMut(T) -> U) -> [U; N];
}

impl<T> Each<T, 2> for [T; 2] {
    #[inline]
    fn each<U>(self, mut f: impl FnMut(T) -> U) -> [U; 2] {
        let [a, b] = self;
        [f(a), f(b)]
    }
}

impl<T> Each<T, 3> for [T; 3] {
    #[inline]
    fn each<U>(self, mut f: impl FnMut(T) -> U) -> [U; 3] {
        let [a, b, c] = self;
        [f(a), f(b), f(c)]
    }
}

impl<T> Each<T, 4> for [T; 4] {
    #[inline]
    fn each<U>(self, mut f: impl FnMut(T) -> U) -> [U; 4] {
        let [a, b, c, d] = self;
        [f(a), f(b), f(c), f(d)]
    }
}
