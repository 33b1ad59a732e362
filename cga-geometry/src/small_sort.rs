//! Sorts with little code.
//!
//! The sorts of the standard library become 5 to 30 KB of machine code for each type and order: a quarter of the code of this crate would be
//! sorts. These take 1 to 3 KB. A list of a million random pairs takes a fifth more time with the unstable one; short lists and sorted ones take
//! the same. And the order of equal elements does not depend on the version of the standard library.

use std::cmp::Ordering;

/// Lists of up to this length are sorted by insertion, as the standard library does.
const RUN: usize = 20;

/// Lists from this length on take the median of three medians as a pivot.
const LONG: usize = 200;

/// Sorts with the names and results of the standard library's. They end and lose no element even if the comparisons are
/// inconsistent (they are not exact where products underflow), and take n log n comparisons.
pub trait SmallSort<T> {
    /// Sorts by `Ord`; equal elements keep their order.
    fn small_sort(&mut self)
    where
        T: Ord;

    /// Sorts by a total order; equal elements keep their order.
    fn small_sort_by(&mut self, compare: impl FnMut(&T, &T) -> Ordering);

    /// Sorts by a key; equal elements keep their order.
    fn small_sort_by_key<K: Ord>(&mut self, key: impl FnMut(&T) -> K);

    /// Sorts by `Ord`, long lists in half of the time. Equal elements have no order.
    fn small_sort_unstable(&mut self)
    where
        T: Ord;

    /// Sorts by a total order, long lists in half of the time. Equal elements have no order.
    fn small_sort_unstable_by(&mut self, compare: impl FnMut(&T, &T) -> Ordering);

    /// Moves the element with that index in the sorted order to its place, smaller ones before it and larger ones behind it. Takes time
    /// in proportion to the length. An index beyond the end sorts a part of the list and has no other effect.
    fn small_select_by(&mut self, index: usize, compare: impl FnMut(&T, &T) -> Ordering);
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

    #[inline]
    fn small_sort_unstable(&mut self)
    where
        T: Ord,
    {
        sort_unstable(self, &mut |a, b| a < b);
    }

    #[inline]
    fn small_sort_unstable_by(&mut self, mut compare: impl FnMut(&T, &T) -> Ordering) {
        sort_unstable(self, &mut |a, b| compare(a, b).is_lt());
    }

    #[inline]
    fn small_select_by(&mut self, index: usize, mut compare: impl FnMut(&T, &T) -> Ordering) {
        select(self, index, &mut |a, b| compare(a, b).is_lt());
    }
}

/// Sorts elements that are not copied, by a total order; equal elements keep their order.
pub fn sort_owned_by<T>(list: &mut [T], mut compare: impl FnMut(&T, &T) -> Ordering) {
    if list.len() < 2 {
        return;
    }
    let mut order: Vec<usize> = (0..list.len()).collect();
    order.small_sort_by(|&a, &b| compare(&list[a], &list[b]));
    // Along each cycle of the permutation.
    for start in 0..list.len() {
        let mut to = start;
        loop {
            let from = std::mem::replace(&mut order[to], to);
            if from == start {
                break;
            }
            list.swap(to, from);
            to = from;
        }
    }
}

/// A merge sort of runs that are sorted by insertion.
fn sort<T: Copy>(list: &mut [T], is_less: &mut impl FnMut(&T, &T) -> bool) {
    list.chunks_mut(RUN).for_each(|run| insert(run, is_less));
    merge_runs(list, RUN, is_less);
}

/// Sorts by insertion.
fn insert<T: Copy>(run: &mut [T], is_less: &mut impl FnMut(&T, &T) -> bool) {
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

/// A quicksort whose short parts are sorted by insertion.
fn sort_unstable<T: Copy>(list: &mut [T], is_less: &mut impl FnMut(&T, &T) -> bool) {
    if RUN < list.len() && list.windows(2).all(|pair| !is_less(&pair[1], &pair[0])) {
        return;
    }
    quicksort(list, most_divisions(list), is_less);
}

/// The number of divisions in turn after which pivots count as bad, and the merge sort goes on.
fn most_divisions<T>(list: &[T]) -> u32 {
    2 * (usize::BITS - list.len().leading_zeros())
}

fn quicksort<T: Copy>(mut list: &mut [T], mut divisions: u32, is_less: &mut impl FnMut(&T, &T) -> bool) {
    while RUN < list.len() {
        if divisions == 0 {
            return sort(list, is_less);
        }
        divisions -= 1;
        let [less, equal] = divide(list, is_less);
        let (left, right) = list.split_at_mut(less);
        quicksort(left, divisions, is_less);
        list = &mut right[equal..];
    }
    insert(list, is_less);
}

/// Finds one place of the sorted list as the quicksort does, in one of the parts.
fn select<T: Copy>(mut list: &mut [T], mut index: usize, is_less: &mut impl FnMut(&T, &T) -> bool) {
    let mut divisions = most_divisions(list);
    while RUN < list.len() && divisions != 0 {
        divisions -= 1;
        let [less, equal] = divide(list, is_less);
        if index < less {
            list = &mut list[..less];
        } else if index < less + equal {
            return;
        } else {
            list = &mut list[less + equal..];
            index -= less + equal;
        }
    }
    sort(list, is_less);
}

/// Divides a list by a pivot: smaller elements, equal ones, and the rest. Returns the lengths of the first two. Of the equal elements, the
/// pivot alone is known unless they are many.
fn divide<T: Copy>(list: &mut [T], is_less: &mut impl FnMut(&T, &T) -> bool) -> [usize; 2] {
    let pivot = pivot(list, is_less);
    list.swap(0, pivot);
    let pivot = list[0];
    let less = move_forward(&mut list[1..], &mut |item| is_less(item, &pivot));
    list.swap(0, less);
    let equal = match less < list.len() / 16 {
        true => move_forward(&mut list[less + 1..], &mut |item| !is_less(&pivot, item)),
        false => 0,
    };
    [less, 1 + equal]
}

/// Moves the elements with a property before the others, without a branch for each. Returns their number.
fn move_forward<T: Copy>(list: &mut [T], is_wanted: &mut impl FnMut(&T) -> bool) -> usize {
    let mut count = 0;
    for at in 0..list.len() {
        let item = list[at];
        let is_first = is_wanted(&item);
        list[at] = list[count];
        list[count] = item;
        count += usize::from(is_first);
    }
    count
}

/// The index of an element near the middle of the sorted order.
fn pivot<T: Copy>(list: &[T], is_less: &mut impl FnMut(&T, &T) -> bool) -> usize {
    let (first, middle, last) = (list.len() / 8, list.len() / 2, list.len() - 1 - list.len() / 8);
    if list.len() < LONG {
        return median(list, [first, middle, last], is_less);
    }
    let medians = [first, middle, last].map(|at| median(list, [at - 1, at, at + 1], is_less));
    median(list, medians, is_less)
}

/// The index of the middle one of three elements.
fn median<T: Copy>(list: &[T], [a, b, c]: [usize; 3], is_less: &mut impl FnMut(&T, &T) -> bool) -> usize {
    let (first, second) = (is_less(&list[a], &list[b]), is_less(&list[b], &list[c]));
    if first == second {
        b
    } else if is_less(&list[a], &list[c]) == first {
        c
    } else {
        a
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

    /// Lists in the orders that lead pivots astray, with all elements different and with few different ones.
    fn lists(count: u32) -> Vec<Vec<(u32, u32)>> {
        let sorted: Vec<(u32, u32)> = (0..count).map(|i| (i / 3, i)).collect();
        let organ = (0..count / 2).chain((0..count / 2).rev()).map(|i| (i, i)).collect();
        let few = |most: u32| (0..count).map(|i| (i.wrapping_mul(2_654_435_761) % most, 0)).collect();
        let reversed = sorted.iter().rev().copied().collect();
        vec![mixed(count), sorted, reversed, organ, few(1), few(2), few(7), few(300)]
    }

    #[test]
    fn unstable_sorts_and_selections_agree_with_the_standard_library() {
        for count in (0..260).chain([1000, 4099, 20_000]) {
            for list in lists(count) {
                let (mut ours, mut theirs) = (list.clone(), list.clone());
                ours.small_sort_unstable();
                theirs.sort_unstable();
                assert_eq!(ours, theirs);
                ours.small_sort_unstable_by(|a, b| b.cmp(a));
                theirs.reverse();
                assert_eq!(ours, theirs);
                theirs.reverse();
                for index in [0, 1, list.len() / 3, list.len() / 2, list.len().saturating_sub(1)] {
                    if index < list.len() {
                        let mut ours = list.clone();
                        ours.small_select_by(index, Ord::cmp);
                        assert_eq!(ours[index], theirs[index]);
                        assert!(ours[..index].iter().all(|item| *item <= ours[index]));
                        assert!(ours[index..].iter().all(|item| ours[index] <= *item));
                        ours.sort_unstable();
                        assert_eq!(ours, theirs);
                    }
                }
            }
        }
    }

    #[test]
    fn elements_that_are_not_copied_are_sorted_as_by_the_standard_library() {
        for count in (0..40).chain([1000, 5000]) {
            for list in lists(count) {
                let mut ours: Vec<Vec<u32>> = list.iter().map(|&(key, number)| vec![key, number]).collect();
                let mut theirs = ours.clone();
                super::sort_owned_by(&mut ours, |a, b| a[0].cmp(&b[0]));
                theirs.sort_by_key(|item| item[0]);
                assert_eq!(ours, theirs, "equal keys keep their order");
            }
        }
    }

    #[test]
    fn an_order_made_against_the_pivots_takes_n_log_n_comparisons() {
        // The comparison decides late which elements are large, so that each pivot turns out to be nearly the smallest.
        let count = 10_000;
        let (values, known) = (std::cell::RefCell::new(vec![u32::MAX; count as usize]), std::cell::Cell::new(0));
        let comparisons = std::cell::Cell::new(0_usize);
        let settle = |item: u32| {
            values.borrow_mut()[item as usize] = known.get();
            known.set(known.get() + 1);
        };
        let mut candidate = 0;
        let mut list: Vec<u32> = (0..count).collect();
        list.reverse();
        list.swap(0, 1);
        list.small_sort_unstable_by(|&a, &b| {
            comparisons.set(comparisons.get() + 1);
            let value = |item: u32| values.borrow()[item as usize];
            if value(a) == u32::MAX && value(b) == u32::MAX {
                settle(if a == candidate { a } else { b });
            }
            if value(a) == u32::MAX {
                candidate = a;
            } else if value(b) == u32::MAX {
                candidate = b;
            }
            value(a).cmp(&value(b))
        });
        let values = values.into_inner();
        assert!(list.is_sorted_by_key(|&item| values[item as usize]));
        assert!(comparisons.get() < 1_000_000, "{}", comparisons.get());
    }

    #[test]
    fn inconsistent_comparisons_lose_no_element() {
        for count in [3, 20, 21, 500] {
            let mut state = 1_u32;
            let mut compare = |_: &(u32, u32), _: &(u32, u32)| {
                state = state.wrapping_mul(2_654_435_761).wrapping_add(1);
                if state >> 31 == 0 { Ordering::Less } else { Ordering::Greater }
            };
            let mut lists = [mixed(count), mixed(count), mixed(count)];
            lists[0].small_sort_by(&mut compare);
            lists[1].small_sort_unstable_by(&mut compare);
            lists[2].small_select_by(count as usize / 2, &mut compare);
            for list in lists {
                let mut numbers: Vec<u32> = list.iter().map(|pair| pair.1).collect();
                numbers.sort_unstable();
                assert!(numbers.into_iter().eq(0..count));
            }
        }
    }
}
