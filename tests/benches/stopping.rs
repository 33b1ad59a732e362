//! The time from the end of a run's time to its return.
//!
//! `cargo bench -p cga-tests --bench stopping`. Each operation runs alone on a comb, a star and a soup of 5,000 corners. A first run
//! finds the longest time between two questions to its watch. The time of a second run ends just after the first of these questions,
//! which is the worst moment.

#[path = "../../benches/common/mod.rs"]
mod common;

use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use cga::{Limits, Settings, Shape, Watch};
use cga_tests::stopped::{Every, rules, shapes};
use common::table::{Table, number};

/// The number of rows that are printed.
const PRINTED: usize = 16;

/// The questions to a watch.
struct Questions {
    count: u64,
    last: Instant,
    /// The longest time between two questions, and the number of the first one.
    longest: (Duration, u64),
}

/// Runs a rule until the question after number `last`. Returns the questions, and the time of the run.
fn run(rule: &str, shape: &Shape, last: u64) -> (Questions, Instant) {
    let questions = Questions { count: 0, last: Instant::now(), longest: (Duration::ZERO, 0) };
    let questions = Arc::new(Mutex::new(questions));
    let seen = questions.clone();
    let watch = Watch::deadline_by(Duration::from_secs(1), move || {
        let mut seen = seen.lock().expect("no panic");
        if seen.count <= last {
            seen.longest = seen.longest.max((seen.last.elapsed(), seen.count));
            (seen.last, seen.count) = (Instant::now(), seen.count + 1);
            return Duration::ZERO;
        }
        Duration::MAX
    });
    let limits = Limits { vertices: 3_000_000, ..Limits::default() };
    let settings = Settings { start: Some(rule.to_owned()), limits, watch: Some(watch), ..Settings::default() };
    // Some rows end at a limit.
    drop(Every::default().generate_with(shape, &settings));
    let end = Instant::now();
    drop(settings);
    let questions = Arc::into_inner(questions).expect("the watch is gone").into_inner().expect("no panic");
    (questions, end)
}

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).filter(|arg| arg.starts_with('R')).collect();
    let mut rows = Vec::new();
    for rule in rules().into_iter().filter(|rule| asked.is_empty() || asked.iter().any(|name| rule.is(name))) {
        let times = shapes().map(|shape| {
            let start = Instant::now();
            let (questions, end) = run(&rule, &shape, u64::MAX);
            let (stopped, returned) = run(&rule, &shape, questions.longest.1.saturating_sub(1));
            [(returned - stopped.last).as_secs_f64() * 1e3, (end - start).as_secs_f64() * 1e3]
        });
        rows.push((times.map(|time| time[0]), times.map(|time| time[1]).into_iter().fold(0.0, f64::max), rule));
    }
    let most = |times: &[f64; 3]| times.iter().copied().fold(0.0, f64::max);
    rows.sort_by(|a, b| most(&b.0).total_cmp(&most(&a.0)));
    let columns = ["rule of `tests/rules/one_operation.cga`", "comb", "star", "soup", "the longest run"];
    let mut table = Table::new("Milliseconds from stop to return", &columns);
    let slow = rows.iter().filter(|row| 50.0 < most(&row.0)).count();
    table.note(&format!("{slow} of {} rules need more than 50 ms; the slowest rules:", rows.len()));
    for (times, whole, rule) in rows.into_iter().take(PRINTED) {
        let cells: Vec<String> = times.into_iter().chain([whole]).map(|time| number(time, 1)).collect();
        table.row(&rule, &cells);
    }
    table.print();
}
