//! A sort of lists with millions of elements, which can end early.

use std::cmp::Ordering;

use crate::small_sort::{SmallSort, merge_runs};
use crate::work;

/// Parts of this length are sorted without a question.
const PART: usize = 1 << 14;

/// The units of work of an element in a part, and of a comparison in a merge.
const SORTING: usize = 8;
const MERGING: usize = 2;

/// Sorts by a total order; elements that are equal in it have no order. Returns false if the work is to end; the list has all its elements
/// then, in no order.
#[must_use]
pub fn long_sort_by<T: Copy>(list: &mut [T], compare: impl Fn(&T, &T) -> Ordering) -> bool {
    sort(list, |part| part.small_sort_unstable_by(&compare), &compare)
}

/// The same, with the order of equal elements kept. Lists are mostly short.
#[must_use]
pub fn long_stable_sort_by<T: Copy>(list: &mut [T], compare: impl Fn(&T, &T) -> Ordering) -> bool {
    sort(list, |part| part.small_sort_by(&compare), &compare)
}

/// Sorts parts by a sort, and merges them.
fn sort<T: Copy>(list: &mut [T], mut sort_part: impl FnMut(&mut [T]), compare: impl Fn(&T, &T) -> Ordering) -> bool {
    for part in list.chunks_mut(PART) {
        sort_part(part);
        if !work::spend(SORTING * part.len()) {
            return false;
        }
    }
    let mut goes_on = true;
    merge_runs(list, PART, &mut |a, b| {
        goes_on = goes_on && work::spend(MERGING);
        goes_on && compare(a, b).is_lt()
    });
    goes_on
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Rng;
    use crate::work::Supervisor;

    #[test]
    fn lists_of_all_lengths_are_sorted() {
        let mut rng = Rng(5);
        for count in [0, 1, 2, PART - 1, PART, PART + 1, 2 * PART, 3 * PART + 7, 9 * PART - 5] {
            let mut list: Vec<(u64, u32)> = (0..count as u32).map(|number| (rng.next() % 1000, number)).collect();
            let mut expected = list.clone();
            expected.sort_unstable();
            let mut by_key = list.clone();
            assert!(long_sort_by(&mut list, Ord::cmp));
            assert_eq!(list, expected);
            assert!(long_stable_sort_by(&mut by_key, |a, b| a.0.cmp(&b.0)));
            assert_eq!(by_key, expected);
        }
    }

    #[test]
    fn a_sort_that_ends_early_loses_no_element() {
        let mut list: Vec<u32> = (0..100_000_u32).map(|number| number.wrapping_mul(2_654_435_761)).collect();
        let mut expected = list.clone();
        expected.sort_unstable();
        for questions in (0..60_u32).step_by(3) {
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
