//! The processor time from the end of a run's time to its return.
//!
//! `cargo bench -p cga-tests --bench stopping`. Each operation runs alone on a comb, a star and a soup of 5,000 corners. A first run
//! finds the longest time between two questions to its watch. The time of a second run ends just after the first of these questions,
//! which is the worst moment. Processor time of the thread is measured, so other programs do not count.

#[path = "../../benches/common/mod.rs"]
mod common;

use std::sync::{Arc, Mutex, OnceLock};
use std::time::Duration;

use cga::{Limits, Settings, Shape, Watch};
use cga_tests::stopped::{Every, bounds, rules, shapes, sphere};
use common::table::{Table, number};

/// The number of rows that are printed.
const PRINTED: usize = 16;

/// The processor time of this thread; where the system does not report it, the time since the first call.
fn now() -> Duration {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        Duration::new(time.tv_sec as u64, time.tv_nsec as u32)
    }
    #[cfg(not(unix))]
    {
        static START: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
        START.elapsed()
    }
}

/// The questions to a watch.
struct Questions {
    count: u64,
    last: Duration,
    /// The longest time between two questions, and the number of the first one.
    longest: (Duration, u64),
    /// The units of work so far, and the most between two questions.
    units: (u64, u64),
}

/// The most processor time of a first run: some rules work for minutes.
const LONGEST: Duration = Duration::from_secs(5);

/// Runs a rule until the question after number `last`, for [`LONGEST`] at most. Returns the questions, and the time of the run.
fn run(rule: &str, shape: &Shape, last: u64) -> (Questions, Duration) {
    let questions = Questions { count: 0, last: now(), longest: (Duration::ZERO, 0), units: (0, 0) };
    let questions = Arc::new(Mutex::new(questions));
    let own: Arc<OnceLock<Watch>> = Arc::default();
    let until = now() + LONGEST;
    let (seen, asked) = (questions.clone(), own.clone());
    let watch = Watch::deadline_by(Duration::from_secs(1), move || {
        let mut seen = seen.lock().expect("no panic");
        let units = asked.get().map_or(0, |watch| watch.progress().work);
        seen.units = (units, seen.units.1.max(units - seen.units.0));
        if seen.count <= last && now() < until {
            seen.longest = seen.longest.max((now() - seen.last, seen.count));
            (seen.last, seen.count) = (now(), seen.count + 1);
            return Duration::ZERO;
        }
        Duration::MAX
    });
    let _ = own.set(watch.clone());
    let limits = Limits { vertices: 20_000_000, bytes: 1 << 32, ..Limits::default() };
    let settings = Settings { start: Some(rule.to_owned()), limits, watch: Some(watch), ..Settings::default() };
    // Some rows end at a limit.
    drop(Every::default().generate_with(shape, &settings));
    let end = now();
    let mut seen = questions.lock().expect("no panic");
    // A stop after the last question waits for the end of the run.
    seen.longest = seen.longest.max((end - seen.last, seen.count));
    (Questions { ..*seen }, end)
}

/// Milliseconds from the end of 300 ms to the return of a run on a large sphere, and from the worst moment.
fn on_large_sphere(asked: &[String]) {
    let shape = sphere(500);
    let columns = ["rule of `tests/rules/one_operation.cga`", "after 300 ms", "at the worst moment", "the longest run"];
    let mut table = Table::new("Milliseconds from stop to return, on a sphere of 500,000 faces", &columns);
    for rule in rules().into_iter().filter(|rule| asked.is_empty() || asked.iter().any(|name| rule.is(name))) {
        let limit = Duration::from_millis(300);
        let watch = Watch::deadline(limit);
        let settings = Settings { start: Some(rule.to_string()), watch: Some(watch), ..Settings::default() };
        let start = std::time::Instant::now();
        drop(Every::default().generate_with(&shape, &settings));
        let late = start.elapsed().saturating_sub(limit).as_secs_f64() * 1e3;
        let start = now();
        let (questions, end) = run(&rule, &shape, u64::MAX);
        let (stopped, returned) = run(&rule, &shape, questions.longest.1.saturating_sub(1));
        let times = [late, (returned - stopped.last).as_secs_f64() * 1e3, (end - start).as_secs_f64() * 1e3];
        println!("{rule} {times:.1?}");
        table.row(&rule, &times.map(|time| number(time, 1)));
    }
    table.print();
}

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).filter(|arg| arg.starts_with('R')).collect();
    if std::env::args().any(|arg| arg == "sphere") {
        return on_large_sphere(&asked);
    }
    let (mut rows, mut units) = (Vec::new(), Vec::new());
    for rule in rules().into_iter().filter(|rule| asked.is_empty() || asked.iter().any(|name| rule.is(name))) {
        let mut most = 0;
        let times = shapes().map(|shape| {
            let start = now();
            let (questions, end) = run(&rule, &shape, u64::MAX);
            most = most.max(questions.units.1);
            let (stopped, returned) = run(&rule, &shape, questions.longest.1.saturating_sub(1));
            [(returned - stopped.last).as_secs_f64() * 1e3, (end - start).as_secs_f64() * 1e3]
        });
        units.push((rule.clone(), most));
        rows.push((times.map(|time| time[0]), times.map(|time| time[1]).into_iter().fold(0.0, f64::max), rule));
    }
    let most = |times: &[f64; 3]| times.iter().copied().fold(0.0, f64::max);
    rows.sort_by(|a, b| most(&b.0).total_cmp(&most(&a.0)));
    let columns = ["rule of `tests/rules/one_operation.cga`", "comb", "star", "soup", "the longest run"];
    let mut table = Table::new("Milliseconds of processor time from stop to return", &columns);
    let slow = rows.iter().filter(|row| 50.0 < most(&row.0)).count();
    table.note(&format!("{slow} of {} rules need more than 50 ms; the slowest rules:", rows.len()));
    for (times, whole, rule) in rows.into_iter().take(PRINTED) {
        let cells: Vec<String> = times.into_iter().chain([whole]).map(|time| number(time, 1)).collect();
        table.row(&rule, &cells);
    }
    table.print();
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/rules/one_operation_units.txt");
    if std::env::var_os("CGA_BLESS").is_some() && asked.is_empty() {
        let lines = units.iter().map(|(rule, units)| format!("{rule} {}\n", units.next_power_of_two()));
        std::fs::write(path, lines.collect::<String>()).expect("the file");
        return;
    }
    for (rule, units) in units {
        match bounds().iter().find(|(own, _)| rule.is(own)) {
            Some((_, bound)) if units <= *bound => {}
            bound => println!("{rule}: {units} units between two questions; the bound is {bound:?}"),
        }
    }
}
