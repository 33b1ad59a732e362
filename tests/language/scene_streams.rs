//! Scenes in bounded memory: finished models that wait, derivations of neighbours, and scenes that are stopped while neighbours are derived.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use cga::{Model, Scene, Settings, Shape, Watch, cga};

/// A row of lots of 1 m that touch each other.
fn row(count: usize) -> Vec<Shape> {
    (0..count).map(|at| Shape::rectangle(1.0, 1.0).at([at as f64, 0.0, 0.0])).collect()
}

/// The number of threads.
const THREADS: usize = 4;

/// Runs on several threads, where the feature is on.
fn on_threads<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    #[cfg(feature = "rayon")]
    return rayon::ThreadPoolBuilder::new().num_threads(THREADS).build().expect("threads").install(work);
    #[cfg(not(feature = "rayon"))]
    work()
}

/// The most models that may wait for an earlier one.
const MOST_AHEAD: usize = 128;

static BEGUN: AtomicUsize = AtomicUsize::new(0);

/// Counts a run. The run of a wide lot takes until no other run begins.
fn begun(width: f64) -> f64 {
    BEGUN.fetch_add(1, Ordering::SeqCst);
    let mut before = 0;
    while 1.0 < width && before < BEGUN.load(Ordering::SeqCst) {
        before = BEGUN.load(Ordering::SeqCst);
        std::thread::sleep(std::time::Duration::from_millis(100));
    }
    1.0
}

#[test]
fn finished_models_wait_in_bounded_number() {
    cga! {
        grammar Counted;
        Lot --> extrude(crate::scene_streams::begun(scope.sx)) X.
    }
    let mut lots = row(1_000);
    lots[0] = Shape::rectangle(2.0, 1.0);
    lots[500] = Shape::rectangle(3.0, 1.0);
    let (mut taken, mut most) = (0, 0);
    let take = |at: usize, model: Model| {
        assert_eq!((at, model.count("X")), (taken, 1));
        most = most.max(BEGUN.load(Ordering::SeqCst) - taken);
        taken += 1;
        // A receiver that takes long.
        if at % 100 == 7 {
            std::thread::sleep(std::time::Duration::from_millis(20));
        }
        ControlFlow::Continue(())
    };
    on_threads(|| Scene::new(&Counted::default(), &lots).generate_each(&Settings::default(), take)).expect("no error");
    assert_eq!(taken, 1_000);
    assert!(most <= MOST_AHEAD + THREADS, "{most}");
}

static DERIVED: AtomicUsize = AtomicUsize::new(0);

/// Counts a derivation.
fn derived() -> f64 {
    DERIVED.fetch_add(1, Ordering::Relaxed);
    1.0
}

#[test]
fn labelled_neighbours_of_large_scenes_are_derived_twice() {
    cga! {
        grammar Both;
        Lot  --> extrude(crate::scene_streams::derived()) label("a") Mass
        Mass --> case touches(inter) && contextCount(inter, "a") == others : Hidden. else : Free.
        attr others = 0
    }
    // Up to 4,096 labelled lots, closed shapes stay until the last neighbour has run.
    for (count, derivations) in [(4_096, 2), (4_097, 3)] {
        let both = Both { others: count as f64 - 1.0 };
        let lots = row(count);
        let batches = on_threads(|| Scene::new(&both, &lots).generate(&Settings::default())).expect("models");
        assert_eq!((batches.count("Hidden"), DERIVED.swap(0, Ordering::Relaxed)), (count, derivations * count));
    }
}

/// The watch of the scene that runs.
static WATCH: Mutex<Option<Watch>> = Mutex::new(None);
static STEPS: AtomicUsize = AtomicUsize::new(0);

/// Counts a step, and stops the scene at the tenth.
fn step() -> f64 {
    if STEPS.fetch_add(1, Ordering::SeqCst) == 9 {
        WATCH.lock().expect("a watch").iter().for_each(Watch::stop);
    }
    1.0
}

#[test]
fn a_scene_ends_while_neighbours_are_derived() {
    cga! {
        grammar Stopped;
        @StartRule
        Labelled --> extrude(crate::scene_streams::step()) label("a") Counted
        @StartRule
        Solid    --> extrude(crate::scene_streams::step()) Asked
        @StartRule
        Long     --> split(x) { { 0.00001 : Slice }* }
        Slice    --> extrude(crate::scene_streams::step()) Asked
        Asked    --> case touches(inter) : X. else : Y.
        Counted  --> case contextCount(inter, "a") > 0 : X. else : Y.
    }
    // The labels of all lots, closed shapes of neighbours, and neighbours with 100,000 shapes.
    // A derivation asks its watch after many shapes.
    for (start, count, most) in [("Labelled", 3_000, 10), ("Solid", 3_000, 10), ("Long", 2, 16_384)] {
        let (watch, lots) = (Watch::new(), row(count));
        *WATCH.lock().expect("a watch") = Some(watch.clone());
        STEPS.store(0, Ordering::SeqCst);
        let settings = Settings { start: Some(start.to_owned()), watch: Some(watch.clone()), ..Settings::default() };
        let batches = on_threads(|| Scene::new(&Stopped::default(), &lots).generate(&settings)).expect("no error");
        assert!(batches.report().stopped && watch.is_stopped(), "{start}");
        // The other threads end their shapes.
        let steps = STEPS.load(Ordering::SeqCst);
        assert!(steps <= most + 2 * THREADS, "{start}: {steps}");
        assert!(batches.count("X") + batches.count("Y") < 10, "{start}");
    }
}
