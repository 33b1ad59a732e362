//! Sorts with little code, for short lists.
//!
//! The sorts of the standard library become 5 to 25 KB of machine code for each type and order. With them alone, a quarter
//! of the code of this crate would be sorts. They still sort the lists that may have thousands of elements.

use std::cmp::Ordering;

/// Lists of up to this length are sorted by insertion, as the standard library does.
const RUN: usize = 20;

/// Stable sorts with the results of `sort`, `sort_by` and `sort_by_key`. They end and lose no element even if the comparisons are
/// inconsistent (they are not exact where products underflow), and take n log n comparisons.
pub trait SmallSort<T> {
    /// Sorts by `Ord`.
    fn small_sort(&mut self)
    where
        T: Ord;

    /// Sorts by a total order.
    fn small_sort_by(&mut self, compare: impl FnMut(&T, &T) -> Ordering);

    /// Sorts by a key.
    fn small_sort_by_key<K: Ord>(&mut self, key: impl FnMut(&T) -> K);
}

impl<T: Copy> SmallSort<T> for [T] {
    #[inline]
    fn small_sort(&mut self)
    where
        T: Ord,
    {
        sort(self, &mut |a, b| a < b);
    }

    #[inline]
    fn small_sort_by(&mut self, mut compare: impl FnMut(&T, &T) -> Ordering) {
        sort(self, &mut |a, b| compare(a, b).is_lt());
    }

    #[inline]
    fn small_sort_by_key<K: Ord>(&mut self, mut key: impl FnMut(&T) -> K) {
        sort(self, &mut |a, b| key(a) < key(b));
    }
}

/// A merge sort of runs that are sorted by insertion.
fn sort<T: Copy>(list: &mut [T], is_less: &mut impl FnMut(&T, &T) -> bool) {
    for run in list.chunks_mut(RUN) {
        for at in 1..run.len() {
            let item = run[at];
            let mut to = at;
            while 0 < to && is_less(&item, &run[to - 1]) {
                run[to] = run[to - 1];
                to -= 1;
            }
            run[to] = item;
        }
    }
    merge_runs(list, RUN, is_less);
}

/// Merges sorted runs of a length. If the comparison returns false from some time on, the rest takes one comparison for each pair of
/// runs.
pub(crate) fn merge_runs<T: Copy>(list: &mut [T], run: usize, is_less: &mut impl FnMut(&T, &T) -> bool) {
    let mut spare = Vec::new();
    let mut width = run;
    while width < list.len() {
        list.chunks_mut(2 * width).for_each(|pair| merge(pair, width, &mut spare, is_less));
        width *= 2;
    }
}

/// Merges the sorted elements before `middle` with the sorted elements from there on.
fn merge<T: Copy>(list: &mut [T], middle: usize, spare: &mut Vec<T>, is_less: &mut impl FnMut(&T, &T) -> bool) {
    if list.len() <= middle || !is_less(&list[middle], &list[middle - 1]) {
        return;
    }
    spare.clear();
    spare.extend_from_slice(&list[..middle]);
    let mut right = middle;
    for (at, left) in spare.iter().enumerate() {
        while right < list.len() && is_less(&list[right], left) {
            list[right - middle + at] = list[right];
            right += 1;
        }
        list[right - middle + at] = *left;
    }
}

#[cfg(test)]
mod tests {
    use super::SmallSort;
    use std::cmp::Ordering;

    /// Pairs of a number and its index, in a mixed order with many equal numbers.
    fn mixed(count: u32) -> Vec<(u32, u32)> {
        (0..count).map(|i| (i.wrapping_mul(2_654_435_761) >> 28, i)).collect()
    }

    #[test]
    fn lists_of_all_lengths_are_sorted_as_by_the_standard_library() {
        for count in (0..200).chain([1000, 10_000]) {
            let (mut ours, mut theirs) = (mixed(count), mixed(count));
            ours.small_sort_by_key(|pair| pair.0);
            theirs.sort_by_key(|pair| pair.0);
            assert_eq!(ours, theirs, "equal keys keep their order");
            let descending = |a: &(u32, u32), b: &(u32, u32)| b.0.cmp(&a.0);
            ours.small_sort_by(descending);
            theirs.sort_by(descending);
            assert_eq!(ours, theirs);
            ours.small_sort();
            theirs.sort_unstable();
            assert_eq!(ours, theirs);
        }
    }

    #[test]
    fn inconsistent_comparisons_lose_no_element() {
        for count in [3, 20, 21, 500] {
            let mut list = mixed(count);
            let mut state = 1_u32;
            list.small_sort_by(|_, _| {
                state = state.wrapping_mul(2_654_435_761).wrapping_add(1);
                if state >> 31 == 0 { Ordering::Less } else { Ordering::Greater }
            });
            let mut numbers: Vec<u32> = list.iter().map(|pair| pair.1).collect();
            numbers.sort_unstable();
            assert!(numbers.into_iter().eq(0..count));
        }
    }
}
