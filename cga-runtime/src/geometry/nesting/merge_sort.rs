//! A stable sort that bears comparisons without an order.

use std::cmp::Ordering;

/// Sorts, equal ones in their order. Whatever the comparisons say (where products underflow they are not exact), it ends and
/// loses nothing, and it takes n log n of them.
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
