//! Progress, and runs that another thread ends.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, mpsc};

use cga::sink::buffers::Buffers;
use cga::{Limits, Model, Settings, Shape, Watch, cga};

use super::THREADS;
use super::grammars::{Street, lots};
use crate::laws::with_threads;

cga! {
    /// Two to the power of 200 shapes and not a single leaf.
    grammar Void;
    Lot --> Twice(200)
    Twice(n) --> case n == 0 : NIL else : [ Twice(n - 1) ] Twice(n - 1)
}

cga! {
    /// A function that never ends, before any shape.
    grammar Endless;
    attr depth = 0
    f(n) = case n == 0 : 1 else : f(n - 1) + f(n - 1)
    Lot --> extrude(f(depth)) A.
}

fn endless() -> Limits {
    Limits { shapes: u64::MAX, calls: u64::MAX, ..Limits::default() }
}

/// Runs until another thread stops the watch.
fn stopped_from_outside(run: impl FnOnce(&Settings) -> bool + Send) {
    let (began, begin) = mpsc::channel();
    let first = std::sync::Mutex::new(Some(began));
    let watch = Watch::every(1, move |_| {
        first.lock().ok().and_then(|mut first| first.take()).map(|began| began.send(()));
        ControlFlow::Continue(())
    });
    let settings = Settings { limits: endless(), watch: Some(watch.clone()), ..Settings::default() };
    std::thread::scope(|scope| {
        scope.spawn(move || {
            let _ = begin.recv();
            watch.stop();
        });
        assert!(run(&settings), "the report tells");
    });
}

#[test]
fn a_run_without_leaves_is_ended_from_another_thread() {
    let shape = Shape::cuboid(1.0, 1.0, 1.0);
    stopped_from_outside(|settings| {
        let model = Void::default().generate_with(&shape, settings).expect("no error");
        assert!(model.is_empty() && 0 < model.report().shapes && model.report().shapes < u64::MAX);
        model.report().stopped
    });
    for threads in THREADS {
        stopped_from_outside(|settings| {
            let shapes = vec![shape.clone(); 40];
            let batches = with_threads(threads, || Void::default().generate_all(&shapes, settings)).expect("no error");
            assert_eq!(batches.len(), 1);
            batches.report().stopped
        });
    }
}

#[test]
fn a_function_without_end_is_ended_from_another_thread() {
    stopped_from_outside(|settings| {
        let grammar = Endless { depth: 200.0 };
        let model = grammar.generate_with(&Shape::rectangle(1.0, 1.0), settings).expect("no error");
        model.report().stopped
    });
}

#[test]
fn a_stopped_watch_lets_nothing_begin() {
    let watch = Watch::new();
    watch.stop();
    let settings = Settings { watch: Some(watch.clone()), ..Settings::default() };
    let model = Street::default().generate_with(&lots(1)[0], &settings).expect("no error");
    assert!(model.is_empty() && model.report().stopped);
    let batches = Street::default().run_all(&lots(9), &settings, |_| Buffers::new()).expect("no error");
    assert!(batches.report().stopped && batches.report().leaves == 0 && batches.len() == 1);
    assert_eq!(watch.progress().initial_shapes, 0);
}

#[test]
fn progress_counts_everything_in_the_end_and_changes_nothing() {
    let shapes = lots(120);
    let plain = Street::default().generate_all(&shapes, &Settings::default()).expect("no limit");
    for threads in THREADS {
        let calls = Arc::new(AtomicU64::new(0));
        let watch = Watch::every(10_000, {
            let calls = calls.clone();
            move |progress| {
                assert!(progress.leaves <= progress.shapes);
                calls.fetch_add(1, Ordering::Relaxed);
                ControlFlow::Continue(())
            }
        });
        let settings = Settings { watch: Some(watch.clone()), ..Settings::default() };
        let watched = with_threads(threads, || Street::default().generate_all(&shapes, &settings)).expect("no limit");
        let (progress, report) = (watch.progress(), watched.report());
        assert_eq!(
            (progress.initial_shapes, progress.shapes, progress.leaves),
            (120, report.shapes, report.leaves),
            "{threads} threads"
        );
        let calls = calls.load(Ordering::Relaxed);
        assert!(1 <= calls && calls <= report.shapes / 10_000, "{calls}");
        assert!(watched.to_glb().expect("a file") == plain.to_glb().expect("a file"));
    }
}

#[test]
fn a_callback_ends_the_runs() {
    for threads in THREADS {
        let watch = Watch::every(20_000, |_| ControlFlow::Break(()));
        let settings = Settings { watch: Some(watch.clone()), ..Settings::default() };
        let shapes = lots(400);
        let batches = with_threads(threads, || Street::default().generate_all(&shapes, &settings)).expect("no limit");
        assert!(batches.report().stopped && watch.is_stopped() && batches.len() < 400);
        // All but the last batch are complete.
        for (batch, shape) in batches.iter().zip(&shapes).take(batches.len() - 1) {
            assert_eq!(batch.sink.len(), Street::default().generate(shape).expect("no limit").len());
        }
    }
}

#[test]
fn limits_hold_with_a_watch() {
    let limits = Limits { shapes: 40_000, ..Limits::default() };
    let with = |watch| Settings { limits, watch, ..Settings::default() };
    let shape = Shape::cuboid(1.0, 1.0, 1.0);
    let error = |settings: &Settings| Void::default().run(&shape, settings, &mut Model::new()).expect_err("a limit");
    assert_eq!(error(&with(None)), error(&with(Some(Watch::new()))));
}
