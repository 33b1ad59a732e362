//! Laws that hold for every pattern and extent. A failure prints the pattern in the notation that `tests/solver/table.rs`
//! reads.

use crate::support::{Pattern, Random};
use cga_split::{Item, Piece, Prefix, Size, solve};

/// The extents for the laws: small integers, tiny, huge, and the extents of usual scopes.
const EXTENTS: [f64; 12] = [1.0, 2.0, 3.0, 5.0, 10.0, 1e-9, 1e9, 1e-3, 12.2, 37.5, 0.1, 1e6];

/// Random patterns on random extents, small enough to be laid out.
fn each(rounds: usize, depth: u64, mut law: impl FnMut(&Pattern, f64, &[Piece])) {
    let mut random = Random::new(depth);
    let mut tried = 0;
    for _ in 0..rounds {
        let extent = random.one_of(&EXTENTS);
        let pattern = random.pattern(extent, depth);
        let mut lengths = vec![0.0; pattern.sizes.len()];
        let solution = solve(&pattern.items, &pattern.sizes, &mut lengths, extent);
        if solution.at_most() < 20_000 {
            law(&pattern, extent, &solution.pieces());
            tried += 1;
        }
    }
    assert!(rounds * 9 / 10 < tried, "{tried} of {rounds} patterns were small enough");
}

#[test]
fn pieces_are_ordered_touch_and_stay_inside() {
    for depth in 0..4 {
        each(8_000, depth, |pattern, extent, pieces| {
            let mut at = 0.0;
            for piece in pieces {
                assert_eq!(piece.start, at, "{} in {extent}: {piece:?}", pattern.text());
                assert!(piece.start < piece.end && piece.end <= extent, "{} in {extent}: {piece:?}", pattern.text());
                let off = (piece.end - piece.start - piece.length).abs();
                assert!(off <= 4e-12 * extent, "{} in {extent}: {piece:?}", pattern.text());
                at = piece.end;
            }
        });
    }
}

#[test]
fn the_scope_is_filled_when_anything_floats() {
    for depth in 0..4 {
        each(8_000, depth, |pattern, extent, pieces| {
            let end = pieces.last().map_or(0.0, |piece| piece.end);
            if pattern.floats() {
                assert_eq!(end, extent, "{}", pattern.text());
            }
        });
    }
}

/// Without floats a group fills the rest of the scope.
#[test]
fn the_scope_is_filled_when_a_group_has_anything_in_it() {
    for depth in 1..4 {
        each(8_000, depth, |pattern, extent, pieces| {
            let end = pieces.last().map_or(0.0, |piece| piece.end);
            let mut slots = pattern.sizes.iter();
            let (mut outside, mut inside) = (0usize, false);
            for item in &pattern.items {
                match item {
                    Item::Repeat(len) => outside = outside.max(*len as usize + 1),
                    Item::Slot => inside |= slots.next().is_some_and(|size| 0 < outside && 0.0 < metres(size, extent)),
                }
                outside = outside.saturating_sub(1);
            }
            if inside {
                assert_eq!(end, extent, "{}", pattern.text());
            }
        });
    }
}

#[test]
fn all_floats_share_one_stretch_and_nothing_else_is_stretched() {
    for depth in 0..3 {
        each(8_000, depth, |pattern, extent, pieces| {
            let mut stretch = None;
            for piece in pieces {
                let size = pattern.sizes[piece.slot as usize];
                // The last one may be cut.
                if piece.end == extent {
                    assert!(piece.length <= metres(&size, extent) || size.prefix == Prefix::Floating);
                } else if size.prefix == Prefix::Floating {
                    let own = piece.length / size.value;
                    let common = *stretch.get_or_insert(own);
                    assert!((own / common - 1.0).abs() < 1e-14, "{} in {extent}", pattern.text());
                } else if !cut(pattern, pieces, piece) {
                    assert_eq!(piece.length, metres(&size, extent), "{} in {extent}: {piece:?}", pattern.text());
                }
            }
        });
    }
}

/// Without floats the last piece of the group that is cut may be cut, at any position.
fn cut(pattern: &Pattern, pieces: &[Piece], piece: &Piece) -> bool {
    let last = pieces.iter().rposition(|other| other.slot == piece.slot).map(|at| pieces[at]);
    !pattern.floats() && last == Some(*piece)
}

/// The length of a slot before floats are stretched. Zero for a slot that is too short for a piece.
fn metres(size: &Size, extent: f64) -> f64 {
    let value = if size.prefix == Prefix::Relative { size.value * extent } else { size.value };
    if cga_split::is_size(value) && extent * 1e-12 < value { value } else { 0.0 }
}

/// The stretch that `counts` repetitions of the groups give, computed independently. `None` when absolute sizes do not
/// fit.
fn stretch(pattern: &Pattern, extent: f64, counts: &[u64]) -> Option<f64> {
    fn add(items: &[Item], sizes: &mut &[Size], counts: &mut &[u64], times: f64, extent: f64, sum: &mut (f64, f64)) {
        let mut at = 0;
        while at < items.len() {
            match items[at] {
                Item::Slot => {
                    let length = metres(&sizes[0], extent) * times;
                    match sizes[0].prefix {
                        Prefix::Floating => sum.1 += length,
                        _ => sum.0 += length,
                    }
                    *sizes = &sizes[1..];
                }
                Item::Repeat(len) => {
                    let times = times * counts[0] as f64;
                    *counts = &counts[1..];
                    add(&items[at + 1..at + 1 + len as usize], sizes, counts, times, extent, sum);
                    at += len as usize;
                }
            }
            at += 1;
        }
    }
    let mut sum = (0.0, 0.0);
    add(&pattern.items, &mut pattern.sizes.as_slice(), &mut { counts }, 1.0, extent, &mut sum);
    (sum.0 <= extent && 0.0 < sum.1).then(|| (extent - sum.0) / sum.1)
}

/// One group: no other count has a stretch nearer to 1.
#[test]
fn no_other_count_of_a_lone_group_is_nearer() {
    let mut seen = 0;
    each(60_000, 1, |pattern, extent, _| {
        let groups = pattern.items.len() - pattern.sizes.len();
        if groups != 1 || !pattern.floats() {
            return;
        }
        let mut lengths = vec![0.0; pattern.sizes.len()];
        let chosen = solve(&pattern.items, &pattern.sizes, &mut lengths, extent).count(0);
        let Some(found) = stretch(pattern, extent, &[chosen]) else { return };
        seen += 1;
        let least = u64::from(stretch(pattern, extent, &[0]).is_none());
        for count in least..(4 * chosen + 20).min(2_000) {
            if let Some(other) = stretch(pattern, extent, &[count]) {
                let (near, far) = ((found - 1.0).abs(), (other - 1.0).abs());
                assert!(near <= far * (1.0 + 1e-12) + 1e-14, "{} in {extent}: {chosen}, not {count}", pattern.text());
                assert!(near != far || count <= chosen || found == other, "{}: a tie", pattern.text());
            }
        }
    });
    assert!(5_000 < seen, "{seen} patterns with one group and floats");
}

/// Several groups: no other total of repetitions, dealt out one by one, has a stretch nearer to 1.
#[test]
fn no_other_number_of_repetitions_dealt_out_is_nearer() {
    let mut seen = 0;
    each(40_000, 2, |pattern, extent, _| {
        let groups = pattern.items.len() - pattern.sizes.len();
        // Groups without content get no repetitions; here all groups have content.
        let all = pattern.sizes.iter().all(|size| 0.0 < metres(size, extent));
        if groups < 2 || !pattern.floats() || !all {
            return;
        }
        let dealt = |turns: u64| -> Vec<u64> {
            let groups = groups as u64;
            (0..groups).map(|group| turns / groups + u64::from(group < turns % groups)).collect()
        };
        let mut lengths = vec![0.0; pattern.sizes.len()];
        let solution = solve(&pattern.items, &pattern.sizes, &mut lengths, extent);
        let counts: Vec<u64> = (0..groups).map(|group| solution.count(group)).collect();
        let chosen: u64 = counts.iter().sum();
        assert_eq!(counts, dealt(chosen), "{}", pattern.text());
        let Some(found) = stretch(pattern, extent, &counts) else { return };
        seen += 1;
        let least = if stretch(pattern, extent, &dealt(0)).is_some() { 0 } else { groups as u64 };
        for turns in least..(2 * chosen + 20).min(2_000) {
            if let Some(other) = stretch(pattern, extent, &dealt(turns)) {
                let (near, far) = ((found - 1.0).abs(), (other - 1.0).abs());
                assert!(near <= far * (1.0 + 1e-12) + 1e-14, "{} in {extent}: {chosen}, not {turns}", pattern.text());
            }
        }
    });
    assert!(1_500 < seen, "{seen} patterns with several groups and floats");
}

/// Bit for bit: a power of two changes no digit.
#[test]
fn scaling_sizes_and_extent_by_a_power_of_two_scales_the_pieces() {
    for factor in [0.5, 4.0, 1.0 / (1u64 << 40) as f64, (1u64 << 30) as f64] {
        each(4_000, 2, |pattern, extent, pieces| {
            let mut larger = pattern.clone();
            for size in larger.sizes.iter_mut().filter(|size| size.prefix != Prefix::Relative) {
                size.value *= factor;
            }
            let scaled = |piece: &Piece| Piece {
                start: piece.start * factor,
                end: piece.end * factor,
                length: piece.length * factor,
                ..*piece
            };
            let expected: Vec<Piece> = pieces.iter().map(scaled).collect();
            assert_eq!(larger.solve(extent * factor), expected, "{} in {extent}", pattern.text());
        });
    }
}

#[test]
fn the_total_is_the_number_made_and_the_bound_is_one() {
    for depth in 0..4 {
        each(4_000, depth, |pattern, extent, pieces| {
            let mut lengths = vec![0.0; pattern.sizes.len()];
            let solution = solve(&pattern.items, &pattern.sizes, &mut lengths, extent);
            assert_eq!(solution.total(), pieces.len() as u64, "{}", pattern.text());
            assert!(solution.total() <= solution.at_most(), "{}", pattern.text());
        });
    }
}

/// Groups that are never made change no bit, although patterns without groups, with one group and with several are laid
/// out by different code.
#[test]
fn dead_groups_change_nothing() {
    for depth in 0..3 {
        each(8_000, depth, |pattern, extent, pieces| {
            let mut longer = pattern.clone();
            for _ in 0..2 {
                longer.items.extend([Item::Repeat(1), Item::Slot]);
                longer.sizes.push(Size::absolute(0.0));
            }
            assert_eq!(longer.solve(extent), pieces, "{} in {extent}", pattern.text());
        });
    }
}

/// Two rewrites change nothing: brackets around everything without a `*`, and a group written out as often as it
/// repeats.
#[test]
fn a_repeat_is_its_repetitions_written_out() {
    each(4_000, 1, |pattern, extent, pieces| {
        if !pattern.floats() {
            return;
        }
        let mut lengths = vec![0.0; pattern.sizes.len()];
        let solution = solve(&pattern.items, &pattern.sizes, &mut lengths, extent);
        let (mut flat, mut from, mut at, mut group) = (Vec::new(), 0, 0, 0);
        while at < pattern.items.len() {
            let (len, count) = match pattern.items[at] {
                Item::Slot => (1, 1),
                Item::Repeat(len) => {
                    at += 1;
                    group += 1;
                    (len as usize, solution.count(group - 1))
                }
            };
            for _ in 0..count {
                flat.extend_from_slice(&pattern.sizes[from..from + len]);
            }
            (at, from) = (at + len, from + len);
        }
        let flat = Pattern { items: vec![Item::Slot; flat.len()], sizes: flat };
        let written_out = flat.solve(extent);
        assert_eq!(written_out.len(), pieces.len(), "{} in {extent}", pattern.text());
        for (a, b) in written_out.iter().zip(pieces) {
            assert!((a.start - b.start).abs() < 1e-9 * extent, "{} in {extent}: {a:?} {b:?}", pattern.text());
        }
    });
}
