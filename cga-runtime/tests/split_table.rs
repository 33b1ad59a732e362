//! The documented split examples (*split operation*, *Subdivision split* and the examples of *report*), extent → pieces.

use cga_runtime::split::solve::solve;
use cga_runtime::split::{Item, Piece, Size};

/// Reads `1 | { ~2.5 | '.1 }* | 1`; a trailing `*` after the outermost group repeats all.
fn parse(text: &str) -> (Vec<Item>, Vec<Size>) {
    fn group(chars: &mut std::iter::Peekable<std::str::Chars<'_>>, items: &mut Vec<Item>, sizes: &mut Vec<Size>) {
        let mut word = String::new();
        let mut open: Vec<usize> = Vec::new();
        let flush = |word: &mut String, items: &mut Vec<Item>, sizes: &mut Vec<Size>| {
            let text = std::mem::take(word);
            let text = text.trim();
            if text.is_empty() {
                return;
            }
            items.push(Item::Slot);
            sizes.push(match (text.strip_prefix('~'), text.strip_prefix('\'')) {
                (Some(rest), _) => Size::floating(rest.parse().unwrap()),
                (_, Some(rest)) => Size::relative(rest.parse().unwrap()),
                _ => Size::absolute(text.parse().unwrap()),
            });
        };
        while let Some(c) = chars.next() {
            match c {
                '{' => {
                    open.push(items.len());
                    items.push(Item::Repeat(0));
                }
                '}' => {
                    flush(&mut word, items, sizes);
                    let at = open.pop().unwrap();
                    if chars.next_if_eq(&'*').is_some() {
                        items[at] = Item::Repeat((items.len() - at - 1) as u32);
                    } else {
                        items.remove(at);
                    }
                }
                '|' => flush(&mut word, items, sizes),
                _ => word.push(c),
            }
        }
        flush(&mut word, items, sizes);
    }
    let (mut items, mut sizes) = (Vec::new(), Vec::new());
    group(&mut text.chars().peekable(), &mut items, &mut sizes);
    (items, sizes)
}

fn pieces(extent: f64, text: &str) -> Vec<Piece> {
    let (items, mut sizes) = parse(text);
    solve(&items, &mut sizes, extent).pieces()
}

#[track_caller]
fn check(extent: f64, text: &str, expected: &[f64]) {
    let found = pieces(extent, text);
    let lengths: Vec<f64> = found.iter().map(|piece| piece.length).collect();
    assert_eq!(lengths.len(), expected.len(), "{text} in {extent}: {lengths:?}");
    for (found, expected) in lengths.iter().zip(expected) {
        assert!((found - expected).abs() < 5e-5, "{text} in {extent}: {lengths:?}, not {expected:?}");
    }
    for pair in found.windows(2) {
        assert_eq!(pair[0].end, pair[1].start, "{text} in {extent}: pieces touch");
    }
    assert!(found.last().is_none_or(|last| last.end <= extent), "{text} in {extent}: inside");
}

fn times(count: usize, pattern: &[f64]) -> Vec<f64> {
    pattern.iter().copied().cycle().take(count * pattern.len()).collect()
}

fn framed(low: &[f64], middle: &[f64], high: &[f64]) -> Vec<f64> {
    [low, middle, high].concat()
}

#[test]
fn the_thirty_cases() {
    check(10.0, "'.5 | '.1 | '.2", &[5.0, 1.0, 2.0]);
    check(10.0, "~.5 | ~.1 | ~.2", &[6.25, 1.25, 2.5]);
    check(10.0, "3.3 | ~3 | 5", &[3.3, 1.7, 5.0]);
    check(10.0, "'.5 | '.6 | 3", &[5.0, 5.0]);
    check(5.0, "3", &[3.0]);
    check(5.0, "2 | 1 | 1 | 2 | 1", &[2.0, 1.0, 1.0, 1.0]);
    check(5.0, "'.382 | '.618", &[1.91, 3.09]);
    check(5.0, "1 | ~2 | 1", &[1.0, 3.0, 1.0]);
    check(5.0, "3 | ~2 | ~2 | ~2", &[3.0, 0.66667, 0.66667, 0.66667]);
    check(10.0, "{2}*", &[2.0; 5]);
    check(10.0, "1 | {~2.5}* | 1", &[1.0, 2.66667, 2.66667, 2.66667, 1.0]);
    check(10.0, "~1 | {2}*", &[2.0; 5]);
    check(10.0, "{1 | ~2.7}* | 1", &[1.0, 2.0, 1.0, 2.0, 1.0, 2.0, 1.0]);
    check(40.0, "{~2.7 | .3}*", &times(13, &[2.77692, 0.3]));
    check(30.0, "{~5 | ~.5}*", &times(5, &[5.45455, 0.545455]));
    check(10.0, "{2 | 1}*", &[2.0, 1.0, 2.0, 1.0, 2.0, 1.0, 1.0]);
    check(10.0, "{~2 | ~1}*", &times(3, &[2.22222, 1.11111]));
    check(10.0, "1 | {~1|.2|~1}* | 1", &framed(&[1.0], &times(4, &[0.9, 0.2, 0.9]), &[1.0]));
    check(10.0, "{1 | ~3}* | 1", &[1.0, 3.5, 1.0, 3.5, 1.0]);
    check(5.0, "3 | 1", &[3.0, 1.0]);
    check(5.0, "1.5|-2|1.5|1.5|0|1.5", &[1.5, 1.5, 1.5, 0.5]);
    check(5.0, "3 | ~1", &[3.0, 2.0]);
    check(5.0, "3 | ~1.5 | ~1.5", &[3.0, 1.0, 1.0]);
    check(5.0, "5 | ~1", &[5.0]);
    check(10.0, "{~2.1}*", &[2.0; 5]);
    check(10.0, "{2}* | ~1", &[2.0; 5]);
    check(10.0, "~2 | {1 | ~2}*", &[1.75, 1.0, 1.75, 1.0, 1.75, 1.0, 1.75]);
    check(12.2, "4.4 | .3 | {~3|.3}*", &[4.4, 0.3, 3.45, 0.3, 3.45, 0.3]);
    check(20.0, "{~2.7 | .3}*", &times(7, &[2.55714, 0.3]));
    check(10.0, "{~.75|~1}* | ~.5", &framed(&times(5, &[0.81081, 1.08108]), &[0.54054], &[]));
}

#[test]
fn conformance_facts_beyond_the_table() {
    // Numbers of the language digest's list.
    check(10.0, "~1 | {2}* | ~1", &[1.0, 2.0, 2.0, 2.0, 2.0, 1.0]); // 25
    check(10.0, "{~1 | .25 | ~1}*", &times(5, &[0.875, 0.25, 0.875])); // 27
    check(10.0, "~1 | {~1}* | ~1 | {~1}* | ~1", &[1.0; 10]); // 29
    check(10.0, "1 | {2}* | {1}* | 1", &[1.0, 2.0, 2.0, 2.0, 1.0, 1.0, 1.0]); // 30
    check(10.0, "{'.1 | '.1}*", &[1.0; 10]); // 31
    check(20.0, "{2}*", &[2.0; 10]); // 32
    let w = 2.15;
    let third = w / 3.0;
    check(w, &format!("{{~{third} | .25}}* | ~{third}"), &[0.55, 0.25, 0.55, 0.25, 0.55]); // 35
    check(w, &format!("{{~{w} | .25}}* | ~{w}"), &[w]); // 36
}

#[test]
fn absolute_sizes_come_out_bit_for_bit() {
    let found = pieces(10.0, "3.3 | ~3 | 5");
    assert_eq!((found[0].length, found[2].length), (3.3, 5.0));
    assert_eq!(found[2].end, 10.0);
}

#[test]
fn absolutes_outside_a_group_without_floats_are_reserved_first() {
    check(9.0, "1 | {2}* | 1", &[1.0, 2.0, 2.0, 2.0, 1.0, 1.0]);
    check(10.0, "5 | {2}* | 5", &[5.0, 5.0]);
    check(10.0, "6 | {2}* | 6", &[6.0, 4.0]);
}

#[test]
fn sizes_that_are_no_sizes_make_nothing() {
    for bad in ["NaN", "inf", "-inf", "0", "-1"] {
        check(5.0, &format!("1 | {bad} | 2"), &[1.0, 2.0]);
        check(5.0, &format!("1 | ~{bad} | 2"), &[1.0, 2.0]);
        check(5.0, &format!("1 | {{{bad}}}* | 2"), &[1.0, 2.0]);
    }
    check(0.0, "1 | ~1", &[]);
    check(0.0, "{1}*", &[]);
}

#[test]
fn a_repeat_inside_a_repeat_ends() {
    let found = pieces(10.0, "{1 | {~1}* | 1}*");
    assert_eq!(found.last().unwrap().end, 10.0);
    let found = pieces(10.0, "{1 | {2}* | 1}*");
    assert_eq!(found.last().unwrap().end, 10.0);
    let found = pieces(10.0, "{{{2}*}*}*");
    assert!((found.iter().map(|piece| piece.length).sum::<f64>() - 10.0).abs() < 1e-12);
}

#[test]
fn a_million_pieces_neither_drift_nor_gape() {
    let found = pieces(1000.0, "{~.001}*");
    assert_eq!(found.len(), 1_000_000);
    assert!(found.windows(2).all(|pair| pair[0].end == pair[1].start));
    assert_eq!(found.last().unwrap().end, 1000.0);
    assert!((found[700_000].start - 700.0).abs() < 1e-9);
}

#[test]
fn laws_hold_for_random_patterns() {
    let mut seed = 0x9e37_79b9_7f4a_7c15u64;
    let mut draw = move |below: u64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 33) % below
    };
    for _ in 0..20_000 {
        let mut text = String::new();
        let mut depth = 0;
        for at in 0..1 + draw(6) {
            if 0 < at {
                text.push('|');
            }
            if draw(4) == 0 && depth < 3 {
                text.push('{');
                depth += 1;
            }
            let value = if draw(2) == 0 { draw(6) as f64 } else { draw(1000) as f64 / 100.0 };
            text.push_str(["", "~", "'"][draw(3) as usize]);
            // Relative sizes are shares.
            let value = if text.ends_with('\'') { value / 10.0 } else { value };
            text.push_str(&format!("{value}"));
            if 0 < depth && draw(3) == 0 {
                text.push('}');
                text.push_str(["", "*"][draw(2) as usize]);
                depth -= 1;
            }
        }
        for _ in 0..depth {
            text.push_str("}*");
        }
        let extent = [10.0, 1.0, 0.125, 37.5, 1e-3][draw(5) as usize];
        let (items, mut sizes) = parse(&text);
        let floats = text.contains('~')
            && sizes.iter().any(|s| s.prefix == cga_runtime::split::Prefix::Floating && 0.0 < s.value);
        let solution = solve(&items, &mut sizes, extent);
        assert!(solution.total() <= solution.at_most());
        let found = solution.pieces();
        assert_eq!(found.len() as u64, solution.total());
        let mut at = 0.0;
        for piece in &found {
            assert_eq!(piece.start, at, "{text} in {extent}: touch");
            assert!(piece.start < piece.end && piece.end <= extent, "{text} in {extent}: {piece:?}");
            assert!((piece.end - piece.start - piece.length).abs() <= 1e-9 * extent, "{text} in {extent}: {piece:?}");
            at = piece.end;
        }
        if floats {
            assert!(found.is_empty() || (at - extent).abs() <= 1e-9 * extent, "{text} in {extent}: filled to {at}");
        }
    }
}
