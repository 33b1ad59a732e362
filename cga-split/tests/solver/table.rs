//! The documented examples, extent → lengths, with the page they come from.

use crate::support::Pattern;

#[track_caller]
fn check(extent: f64, text: &str, expected: &[f64]) {
    let found = Pattern::read(text).solve(extent);
    let lengths: Vec<f64> = found.iter().map(|piece| piece.length).collect();
    assert_eq!(lengths.len(), expected.len(), "{text} in {extent}: {lengths:?}");
    for (found, expected) in lengths.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{text} in {extent}: {lengths:?}, not {expected:?}");
    }
    for pair in found.windows(2) {
        assert_eq!(pair[0].end, pair[1].start, "{text} in {extent}: pieces touch");
    }
    assert!(found.last().is_none_or(|last| last.end <= extent), "{text} in {extent}: inside");
}

fn times(count: usize, pattern: &[f64]) -> Vec<f64> {
    pattern.repeat(count)
}

fn framed(low: &[f64], middle: &[f64], high: &[f64]) -> Vec<f64> {
    [low, middle, high].concat()
}

/// *split operation*.
#[test]
fn examples_of_the_split_operation() {
    check(10.0, "'0.5 | '0.1 | '0.2", &[5.0, 1.0, 2.0]);
    check(10.0, "~0.5 | ~0.1 | ~0.2", &[6.25, 1.25, 2.5]);
    check(10.0, "3.3 | ~3 | 5", &[3.3, 1.7, 5.0]);
    check(10.0, "'0.5 | '0.6 | 3", &[5.0, 5.0]);
    check(10.0, "{ 2 | 1 }*", &[2.0, 1.0, 2.0, 1.0, 2.0, 1.0, 1.0]);
    check(10.0, "{ ~2 | ~1 }*", &times(3, &[20.0 / 9.0, 10.0 / 9.0]));
    check(10.0, "1 | { ~1 | 0.2 | ~1 }* | 1", &framed(&[1.0], &times(4, &[0.9, 0.2, 0.9]), &[1.0]));
    check(10.0, "{ 1 | ~2.7 }* | 1", &[1.0, 2.0, 1.0, 2.0, 1.0, 2.0, 1.0]);
    check(10.0, "{ 1 | ~3 }* | 1", &[1.0, 3.5, 1.0, 3.5, 1.0]);
    check(10.0, "{ '0.1 | '0.1 }*", &[1.0; 10]);
    check(10.0, "{ ~.75 | ~1 }* | ~.5", &framed(&times(5, &[30.0 / 37.0, 40.0 / 37.0]), &[20.0 / 37.0], &[]));
}

/// *Subdivision split*, Absolute, Relative and Floating split.
#[test]
fn examples_of_absolute_relative_and_floating_sizes() {
    check(5.0, "3", &[3.0]);
    check(5.0, "3 | 1", &[3.0, 1.0]);
    check(5.0, "2 | 1 | 1 | 2 | 1", &[2.0, 1.0, 1.0, 1.0]);
    check(5.0, "1.5 | -2 | 1.5 | 1.5 | 0 | 1.5", &[1.5, 1.5, 1.5, 0.5]);
    check(5.0, "'0.382 | '0.618", &[1.91, 3.09]);
    check(1.91, "'0.382 | '0.618", &[0.72962, 1.18038]); // the first piece, split again
    check(3.09, "'0.382 | '0.618", &[1.18038, 1.90962]); // the second piece, split again
    check(5.0, "3 | ~1", &[3.0, 2.0]);
    check(5.0, "1 | ~2 | 1", &[1.0, 3.0, 1.0]);
    check(5.0, "3 | ~1.5 | ~1.5", &[3.0, 1.0, 1.0]);
    check(5.0, "3 | ~2 | ~2 | ~2", &[3.0, 2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]);
    check(5.0, "5 | ~1", &[5.0]);
}

/// *Subdivision split*, Repeat split.
#[test]
fn examples_of_repeats() {
    check(10.0, "{ 2 }*", &[2.0; 5]);
    check(10.0, "{ ~2.1 }*", &[2.0; 5]);
    check(10.0, "1 | { ~2.5 }* | 1", &framed(&[1.0], &[8.0 / 3.0; 3], &[1.0]));
    check(10.0, "{ 2 }* | ~1", &[2.0; 5]);
    check(10.0, "~1 | { 2 }*", &[2.0; 5]);
    check(10.0, "~1 | { 2 }* | ~1", &[1.0, 2.0, 2.0, 2.0, 2.0, 1.0]); // the page says only that floats are allowed
    check(10.0, "~2 | { 1 | ~2 }*", &[1.75, 1.0, 1.75, 1.0, 1.75, 1.0, 1.75]);
}

/// *Subdivision split*, Patterns and Parallel. The parallel repeats are inferred: the page has pictures without
/// numbers.
#[test]
fn examples_of_patterns_and_parallel_repeats() {
    check(10.0, "{ ~1 | 0.25 | ~1 }*", &times(5, &[0.875, 0.25, 0.875]));
    check(10.0, "1 | { ~1 | 0.2 | ~1 }* | 1", &framed(&[1.0], &times(4, &[0.9, 0.2, 0.9]), &[1.0]));
    check(10.0, "~1 | { ~1 }* | ~1 | { ~1 }* | ~1", &[1.0; 10]);
    let slots: Vec<u32> =
        Pattern::read("~1 | { ~1 }* | ~1 | { ~1 }* | ~1").solve(10.0).iter().map(|piece| piece.slot).collect();
    assert_eq!(slots, [0, 1, 1, 1, 1, 2, 3, 3, 3, 4], "four and three");
    check(10.0, "1 | { 2 }* | { 1 }* | 1", &[1.0, 2.0, 2.0, 2.0, 1.0, 1.0, 1.0]);
}

/// One example each of *split attribute*, *report* and *r operation*; the others are inferred from a published building
/// rule.
#[test]
fn examples_of_other_pages() {
    check(20.0, "{ 2 }*", &[2.0; 10]); // *split attribute*
    check(30.0, "{ ~5 | ~0.5 }*", &times(5, &[60.0 / 11.0, 6.0 / 11.0])); // *report*
    check(18.0, "{ 2 }*", &[2.0; 9]); // *r operation*
    let (w, third) = (2.15, 2.15 / 3.0);
    check(w, &format!("{{ ~{third} | 0.25 }}* | ~{third}"), &[0.55, 0.25, 0.55, 0.25, 0.55]); // inferred
    check(w, &format!("{{ ~{w} | 0.25 }}* | ~{w}"), &[w]); // inferred
}

/// Examples from a published building and the pictures of *report*: the least stretch decides the count, not rounding.
#[test]
fn counts_of_real_facades() {
    check(12.2, "4.4 | .3 | { ~3 | .3 }*", &[4.4, 0.3, 3.45, 0.3, 3.45, 0.3]);
    check(40.0, "{ ~2.7 | .3 }*", &times(13, &[36.1 / 13.0, 0.3]));
    check(20.0, "{ ~2.7 | .3 }*", &times(7, &[17.9 / 7.0, 0.3]));
}

#[test]
fn absolute_sizes_come_out_bit_for_bit() {
    let found = Pattern::read("3.3 | ~3 | 5").solve(10.0);
    assert_eq!((found[0].length, found[2].length), (3.3, 5.0));
    assert_eq!(found[2].end, 10.0);
    // Ten times 0.1 is a little less than 1, which does not make an eleventh piece.
    let found = Pattern::read("{ 0.1 }*").solve(1.0);
    assert!(found.len() == 10 && found.iter().all(|piece| piece.length == 0.1) && found[9].end == 1.0);
}

#[test]
fn absolutes_outside_a_group_without_floats_are_reserved_first() {
    check(9.0, "1 | { 2 }* | 1", &[1.0, 2.0, 2.0, 2.0, 1.0, 1.0]);
    check(9.0, "{ 2 }* | 1.5 | 1", &[2.0, 2.0, 2.0, 0.5, 1.5, 1.0]);
    check(10.0, "5 | { 2 }* | 5", &[5.0, 5.0]);
    check(10.0, "6 | { 2 }* | 6", &[6.0, 4.0]);
    // Two groups: the group with the last repetition is cut.
    check(9.5, "{ 2 }* | { 1 }*", &[2.0, 2.0, 2.0, 0.5, 1.0, 1.0, 1.0]);
    check(8.5, "{ 2 }* | { 1 }*", &[2.0, 2.0, 2.0, 1.0, 1.0, 0.5]);
}

#[test]
fn a_group_is_made_once_at_least_unless_something_outside_floats() {
    check(2.0, "{ ~5 }*", &[2.0]);
    check(2.0, "{ 3 | ~1 }*", &[2.0]);
    check(2.0, "1 | { ~5 | 0.5 }*", &[1.0, 0.5, 0.5]);
    check(2.0, "~2 | { ~5 }*", &[2.0]);
    check(2.0, "~2 | { 1.9 }*", &[2.0]);
    // Both are off by 1, so the larger count wins.
    check(2.0, "~1 | { 2 }*", &[2.0]);
}

#[test]
fn a_group_in_brackets_only_is_no_group() {
    check(10.0, "1 | { ~1 | { 0.2 } | ~1 } | 1", &[1.0, 3.9, 0.2, 3.9, 1.0]);
    check(10.0, "{ { 2 } | { { 1 } } }*", &[2.0, 1.0, 2.0, 1.0, 2.0, 1.0, 1.0]);
}

#[test]
fn sizes_that_are_no_sizes_make_nothing() {
    for bad in ["NaN", "inf", "-inf", "0", "-1"] {
        check(5.0, &format!("1 | {bad} | 2"), &[1.0, 2.0]);
        check(5.0, &format!("1 | ~{bad} | 2"), &[1.0, 2.0]);
        check(5.0, &format!("1 | '{bad} | 2"), &[1.0, 2.0]);
        check(5.0, &format!("1 | {{ {bad} }}* | 2"), &[1.0, 2.0]);
        check(5.0, &format!("1 | {{ ~{bad} | 1 }}* | 2"), &[1.0, 1.0, 1.0, 2.0]);
        check(5.0, &format!("~1 | {{ {{ {bad} }}* }}* | 2"), &[3.0, 2.0]);
    }
    for extent in [0.0, -0.0, -5.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for text in ["1 | ~1", "{ 1 }*", "'1 | { ~1 }*", "{ ~1 | { 2 }* }*"] {
            check(extent, text, &[]);
        }
    }
}

#[test]
fn sums_too_large_for_a_number_keep_their_ratios() {
    check(6.0, "~1e308 | ~1e308 | ~1e308", &[2.0; 3]);
    check(6.0, "1 | { ~1e308 | ~1e308 }*", &[1.0, 2.5, 2.5]);
    check(6.0, "1e308 | ~1 | 1e308 | 1e308", &[6.0]);
    check(6.0, "{ ~1e20 }*", &[6.0]);
    check(10.0, "~1 | { 1e308 | 1e308 }*", &[10.0]);
    check(1e149, "{ ~1e308 | ~1e308 }* | ~1e140", &[1e149 / 2.0; 2]);
    // Larger extents have no finite areas.
    check(1e149, "~1 | { 2e148 }*", &[2e148; 5]);
    check(1e151, "~1 | { 1e150 }*", &[]);
}

/// The reference allows any depth and shows no example. Repetitions are dealt out evenly, see `choices.rs`.
#[test]
fn a_repeat_inside_a_repeat() {
    // The outer group three times, the inner one twice in each: 6 pieces of 1 and 6 floats of 2/3.
    check(10.0, "{ 1 | { ~1 }* | 1 }*", &times(3, &[1.0, 2.0 / 3.0, 2.0 / 3.0, 1.0]));
    check(8.0, "{ 1 | { ~1 }* | 1 }*", &times(2, &[1.0, 1.0, 1.0, 1.0]));
    // Without floats the outer group is cut, in the middle of its second repetition.
    check(10.0, "{ 1 | { 2 }* | 1 }*", &[1.0, 2.0, 2.0, 1.0, 1.0, 2.0, 1.0]);
    check(10.0, "{ { { 2 }* }* }*", &times(5, &[2.0]));
    // Two groups inside one: all three repeat twice.
    let (float, half) = (8.0 / 9.0, 0.5);
    let turn = [float, float, half, float, float, half];
    check(10.0, "{ { ~1 }* | 0.5 | { ~1 }* | 0.5 }* | ~1", &framed(&turn, &turn, &[float]));
}

#[test]
fn a_million_pieces_neither_drift_nor_gape() {
    let found = Pattern::read("{ ~.001 }*").solve(1000.0);
    assert_eq!(found.len(), 1_000_000);
    assert!(found.windows(2).all(|pair| pair[0].end == pair[1].start));
    assert_eq!(found.last().unwrap().end, 1000.0);
    assert!((found[700_000].start - 700.0).abs() < 1e-9);
}

/// A length below the smallest piece takes no room, in any position.
#[test]
fn slivers_are_no_pieces() {
    check(10.0, "1 | 1e-20 | 1", &[1.0, 1.0]);
    check(10.0, "1 | '1e-13 | ~1", &[1.0, 9.0]);
    check(10.0, "~1 | ~1e-13 | ~1", &[5.0, 5.0]);
    check(10.0, "~1 | { 0.00000000001 }* | '0.1", &[9.0, 1.0]);
    check(1.0, "{ ~0.25 | { 0.000000000001 }* | 1 }*", &[1.0]);
    check(10.0, "{ ~2.5 | { '0.000000000001 }* }*", &[2.5; 4]);
    check(10.0, "{ ~2.5 | ~1e-14 }*", &[2.5; 4]);
    // Dropping one sliver may leave another with too little room.
    check(10.0, "~1 | ~1e-12 | 10", &[10.0]);
    // A group that vanishes in rounding beside the sizes outside must not be counted up endlessly.
    for text in ["9 | { 1e-300 }*", "9 | { 1e-20 }* | { 5e-17 }*", "{ { 1e-300 }* | 9 }*"] {
        check(9.0, text, &[9.0]);
    }
    check(10.0, "~9 | { 1e-300 }*", &[10.0]);
}

/// The documented ties hold in every unit, except the one that only `f64` decides.
#[test]
fn absolute_repeats_come_first_whatever_rounding_says() {
    for tenths in 1..1000 {
        let k = f64::from(tenths) / 10.0;
        for text in [format!("{{ {} }}* | ~{k}", 2.0 * k), format!("~{k} | {{ {} }}*", 2.0 * k)] {
            let found = Pattern::read(&text).solve(10.0 * k);
            assert_eq!(found.len(), 5, "{text} in {}", 10.0 * k);
        }
    }
}

#[test]
fn there_is_no_repetition_without_room() {
    check(10.0, "10 | { ~1 }*", &[10.0]);
    let pattern = Pattern::read("10 | { ~1 }*");
    let mut lengths = [0.0; 2];
    assert_eq!(cga_split::solve(&pattern.items, &pattern.sizes, &mut lengths, 10.0).count(0), 1);
}

#[test]
fn a_hundred_thousand_levels_need_no_stack() {
    let mut items = vec![cga_split::Item::Repeat(0); 100_000];
    items.push(cga_split::Item::Slot);
    let count = items.len();
    for (at, item) in items.iter_mut().enumerate().take(count - 1) {
        *item = cga_split::Item::Repeat((count - at - 1) as u32);
    }
    let pattern = Pattern { items, sizes: vec![cga_split::Size::floating(3.0)] };
    assert_eq!(pattern.solve(4.0).len(), 1);
}

/// Inconsistent lists give some solution or none, never a panic or a wrong bound.
#[test]
fn malformed_patterns_do_no_harm() {
    let mut random = crate::support::Random::new(5);
    for _ in 0..20_000 {
        let item = |random: &mut crate::support::Random| match random.below(3) {
            0 => cga_split::Item::Repeat(random.below(6) as u32),
            1 => cga_split::Item::Repeat(u32::MAX),
            _ => cga_split::Item::Slot,
        };
        let items: Vec<_> = (0..1 + random.below(7)).map(|_| item(&mut random)).collect();
        let count = random.below(items.len() as u64 + 1);
        let sizes: Vec<_> = (0..count).map(|_| random.size(10.0)).collect();
        let mut lengths = vec![0.0; sizes.len()];
        let solution = cga_split::solve(&items, &sizes, &mut lengths, 10.0);
        let bound = solution.at_most();
        assert!(100_000 < bound || solution.total() <= bound, "{items:?} {sizes:?}");
    }
}
