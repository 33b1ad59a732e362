//! A sort of lists with millions of elements, which can end early.

use std::cmp::Ordering;

use crate::geometry::work;

/// Parts of this length are sorted by the standard library.
const PART: usize = 1 << 14;

/// The units of work of an element in a part, and in a merge.
const SORTING: usize = 8;
const MERGING: usize = 2;

/// The elements that are merged between two counts of work.
const BLOCK: usize = 1 << 10;

/// Sorts by a total order; elements that are equal in it have no order. Returns false if the work is to end; the list has all its elements
/// then, in no order.
#[must_use]
pub(crate) fn long_sort_by<T: Copy>(list: &mut [T], compare: impl Fn(&T, &T) -> Ordering) -> bool {
    for part in list.chunks_mut(PART) {
        part.sort_unstable_by(&compare);
        if !work::spend(SORTING * part.len()) {
            return false;
        }
    }
    if list.len() <= PART {
        return true;
    }
    let (mut from, mut to) = (list.to_vec(), Vec::with_capacity(list.len()));
    let mut width = PART;
    while width < list.len() {
        to.clear();
        for pair in from.chunks(2 * width) {
            let (left, right) = pair.split_at(width.min(pair.len()));
            if !merge(left, right, &mut to, &compare) {
                return false;
            }
        }
        std::mem::swap(&mut from, &mut to);
        width *= 2;
    }
    list.copy_from_slice(&from);
    true
}

/// Appends the elements of two sorted lists, in order.
fn merge<T: Copy>(mut left: &[T], mut right: &[T], to: &mut Vec<T>, compare: &impl Fn(&T, &T) -> Ordering) -> bool {
    while let ([first, ..], [second, ..]) = (left, right) {
        if to.len().is_multiple_of(BLOCK) && !work::spend(MERGING * BLOCK) {
            return false;
        }
        if compare(second, first).is_lt() {
            to.push(*second);
            right = &right[1..];
        } else {
            to.push(*first);
            left = &left[1..];
        }
    }
    to.extend_from_slice(left);
    to.extend_from_slice(right);
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::random::Rng;
    use crate::geometry::work::Supervisor;

    #[test]
    fn lists_of_all_lengths_are_sorted() {
        let mut rng = Rng(5);
        for count in [0, 1, 2, PART - 1, PART, PART + 1, 2 * PART, 3 * PART + 7, 9 * PART - 5] {
            let mut list: Vec<(u64, u32)> = (0..count as u32).map(|number| (rng.next() % 1000, number)).collect();
            let mut expected = list.clone();
            expected.sort_unstable();
            assert!(long_sort_by(&mut list, Ord::cmp));
            assert_eq!(list, expected);
        }
    }

    #[test]
    fn a_sort_that_ends_early_loses_no_element() {
        let mut list: Vec<u32> = (0..300_000_u32).map(|number| number.wrapping_mul(2_654_435_761)).collect();
        let mut expected = list.clone();
        expected.sort_unstable();
        for questions in 0..60_u32 {
            let left = std::cell::Cell::new(questions);
            let _supervisor = Supervisor::new(move |_| left.replace(left.get().saturating_sub(1)) != 0);
            if !long_sort_by(&mut list, Ord::cmp) {
                let mut all = list.clone();
                all.sort_unstable();
                assert_eq!(all, expected);
            }
        }
        assert!(long_sort_by(&mut list, Ord::cmp));
        assert_eq!(list, expected);
    }
}
