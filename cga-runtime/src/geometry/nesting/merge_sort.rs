//! A stable sort that tolerates inconsistent comparisons.

use std::cmp::Ordering;

/// A stable sort. It ends and loses no element even if the comparisons are inconsistent (they are not exact where
/// products underflow), and it takes n log n comparisons.
pub(crate) fn merge_sort<T: Copy>(list: &mut [T], spare: &mut Vec<T>, compare: &impl Fn(&T, &T) -> Ordering) {
    if list.len() < 2 {
        return;
    }
    let middle = list.len() / 2;
    merge_sort(&mut list[..middle], spare, compare);
    merge_sort(&mut list[middle..], spare, compare);
    spare.clear();
    spare.extend_from_slice(&list[..middle]);
    let (mut left, mut right) = (0, middle);
    for at in 0..list.len() {
        let take_left =
            left < middle && (right == list.len() || compare(&spare[left], &list[right]) != Ordering::Greater);
        list[at] = if take_left { spare[left] } else { list[right] };
        *(if take_left { &mut left } else { &mut right }) += 1;
    }
}
