//! The cost of solving, compared with writing the pieces to a list and with the same arithmetic by hand.
//!
//! `cargo bench -p cga-split`. Both ways run alternately in the same process; the best of many runs counts.

#[path = "../../benches/common/mod.rs"]
mod common;

use std::hint::black_box;
use std::ops::ControlFlow;

use cga_split::{Item, Piece, Size, solve};
use common::clock::{fastest, nanoseconds_each};
use common::table::{Table, number};

/// The number of seconds that each row is repeated.
const SECONDS: f64 = 0.3;

const REPEAT: [Item; 3] = [Item::Repeat(2), Item::Slot, Item::Slot];
const WINDOWS: [Size; 2] = [Size::floating(2.5), Size::absolute(0.3)];

/// `{ ~2.5 | 0.3 }*` with `pieces` pieces.
fn repeat(table: &mut Table, pieces: usize) {
    let turns = pieces / 2;
    let extent = turns as f64 * 2.8 + 0.7;
    let blank = Piece { slot: 0, start: 0.0, end: 0.0, length: 0.0 };
    let (mut written, mut solved) = (vec![blank; pieces], vec![blank; pieces]);
    let mut count = 0;
    // A single short split is below the clock's resolution.
    let rounds = (20_000 / pieces).max(1);
    let mut write = || {
        for _ in 0..rounds {
            // The same numbers, with the repetitions known and nothing checked.
            let mut places = written.iter_mut();
            let mut put = |piece| places.next().map(|place| *place = piece);
            let extent = black_box(extent);
            let long = (extent - turns as f64 * 0.3) / turns as f64;
            for turn in 0..turns {
                let start = turn as f64 * (long + 0.3);
                let middle = start + long;
                let end = (turn + 1) as f64 * (long + 0.3);
                put(Piece { slot: 0, start, end: middle, length: long });
                put(Piece { slot: 1, start: middle, end, length: 0.3 });
            }
            black_box(&written);
        }
    };
    let mut solve = || {
        for _ in 0..rounds {
            let mut places = solved.iter_mut();
            count = 0;
            let mut lengths = [0.0; 2];
            let solution = solve(&REPEAT, &WINDOWS, &mut lengths, black_box(extent));
            let _ = solution.each(|piece| {
                count += 1;
                match places.next() {
                    Some(place) => *place = piece,
                    None => return ControlFlow::Break(()),
                }
                ControlFlow::Continue(())
            });
            black_box(&solved);
        }
    };
    let [writing, solving] =
        fastest(SECONDS, [&mut write, &mut solve]).map(|time| nanoseconds_each(time, rounds * pieces));
    assert_eq!(count, pieces);
    for (a, b) in written.iter().zip(&solved) {
        assert!(a.slot == b.slot && (a.start - b.start).abs() < 1e-9 * extent, "{a:?} {b:?}");
    }
    let cells = [solving / writing, writing, solving].map(|value| number(value, 2));
    table.row(&format!("a repeat, {pieces} pieces"), &cells);
}

const FLAT: [Item; 4] = [Item::Slot; 4];
const FRAME: [Size; 4] = [Size::absolute(0.5), Size::floating(1.0), Size::relative(0.1), Size::floating(2.0)];

/// `0.5 | ~1 | '0.1 | ~2`, folded into a number.
fn four_slots(table: &mut Table) {
    const ROUNDS: usize = 10_000;
    let (mut by_hand, mut by_solver) = (0.0, 0.0);
    let fold = |sum: &mut f64, slot: u32, start: f64, length: f64| *sum += start * f64::from(slot + 1) + length;
    let mut hand = || {
        for _ in 0..ROUNDS {
            let extent: f64 = black_box(10.0);
            let extent = if 0.0 < extent && extent <= 1e150 { extent } else { 0.0 };
            let smallest = extent * 1e-12;
            // A size that is too short for a piece takes no room.
            let tenth = extent * 0.1;
            let half = if smallest < 0.5 { 0.5 } else { 0.0 };
            let room = extent - (half + tenth);
            let stretch = if smallest < room { room / 3.0 } else { 0.0 };
            let stretch = if smallest < stretch || 2.0 * stretch <= smallest { stretch } else { f64::NAN };
            let mut from = 0.0;
            for (slot, length) in [half, stretch, tenth, 2.0 * stretch].into_iter().enumerate() {
                let near = extent - smallest;
                if 0.0 < length && from < near {
                    let to = from + length;
                    let (end, length) = if to < near {
                        (to, length)
                    } else if to <= extent + smallest {
                        (extent, length)
                    } else {
                        (extent, extent - from)
                    };
                    fold(&mut by_hand, slot as u32, from, length);
                    from = end;
                }
            }
        }
    };
    let mut solver = || {
        for _ in 0..ROUNDS {
            let mut lengths = [0.0; 4];
            let solution = solve(&FLAT, &FRAME, &mut lengths, black_box(10.0));
            let _ = solution.each(|piece| {
                fold(&mut by_solver, piece.slot, piece.start, piece.length);
                ControlFlow::<()>::Continue(())
            });
        }
    };
    let [hand, solver] = fastest(SECONDS, [&mut hand, &mut solver]).map(|time| nanoseconds_each(time, 4 * ROUNDS));
    assert_eq!(by_hand, by_solver);
    table.row("four slots", &[solver / hand, hand, solver].map(|value| number(value, 2)));
}

fn main() {
    let columns = ["split", "solver / by hand", "by hand, ns a piece", "solver, ns a piece"];
    let mut table = Table::new("The split solver", &columns);
    for pieces in [10, 1_000, 100_000] {
        repeat(&mut table, pieces);
    }
    four_slots(&mut table);
    table.print();
}
