//! The first error in the order of the shapes is the error of the whole.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use cga::glam::DAffine3;
use cga::{Error, Flow, Leaf, LimitKind, Limits, Mesh, RunError, Settings, Shape, Sink, cga};

use super::THREADS;
use super::grammars::{Street, lots};
use crate::laws::with_threads;

cga! {
    grammar Wide;
    @Range(min = 1, max = 9)
    attr piece = 1
    Lot --> split(x) { { piece : A. }* }
}

fn widths(widths: impl IntoIterator<Item = u32>) -> Vec<Shape> {
    widths.into_iter().map(|width| Shape::cuboid(f64::from(width), 1.0, 1.0)).collect()
}

#[test]
fn the_first_error_wins() {
    let settings = Settings { limits: Limits { shapes: 100, ..Limits::default() }, ..Settings::default() };
    // Lots 310, 400 and 900 have more pieces than allowed.
    let shapes = widths((0..1000).map(|at| if [310, 400, 900].contains(&at) { 200 } else { 20 }));
    for threads in THREADS {
        for _ in 0..20 {
            let error =
                with_threads(threads, || Wide::default().generate_all(&shapes, &settings)).expect_err("a limit");
            assert_eq!(error.shape, Some(310), "{threads} threads");
            assert!(matches!(error.error, Error::Limit { what: LimitKind::Shapes, limit: 100, .. }));
            assert!(error.to_string().starts_with("initial shape 310: more shapes than the limit of 100 allows"));
        }
    }
    // `?` in a function with the usual error.
    let result = (|| -> Result<usize, Error> { Ok(Wide::default().generate_all(&shapes, &settings)?.len()) })();
    assert!(matches!(result, Err(Error::Limit { .. })));
}

#[test]
fn what_does_not_depend_on_a_shape_is_found_without_one() {
    let wrong = Settings { start: Some("Lit".into()), ..Settings::default() };
    let RunError { shape, error, .. } = Wide::default().generate_all(&[], &wrong).expect_err("no such rule");
    assert!(shape.is_none() && matches!(error, Error::StartRule { .. }));
    let wide = Wide { piece: 10.0 };
    let error = wide.generate_all(&widths([1]), &Settings::default()).expect_err("out of range");
    assert!(error.shape.is_none() && matches!(&error.error, Error::Attribute { name, .. } if name == "piece"));
    assert!(wide.session(&Settings::default()).is_err());
}

/// Takes some leaves and then ends its run.
struct Few<'a> {
    room: usize,
    finished: &'a AtomicUsize,
}

impl Sink for Few<'_> {
    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        self.room -= 1;
        if self.room == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn finish(&mut self) -> Flow {
        self.finished.fetch_add(1, Ordering::Relaxed);
        ControlFlow::Continue(())
    }
}

#[test]
fn a_sink_that_ends_its_run_ends_the_whole_there() {
    // The sinks have room for 50 leaves; lots 6 and 8 have more.
    let shapes = widths((0..12).map(|at| if [6, 8].contains(&at) { 60 } else { 10 }));
    for threads in THREADS {
        let finished = AtomicUsize::new(0);
        let batches = with_threads(threads, || {
            Wide::default().run_all(&shapes, &Settings::default(), |_| Few { room: 50, finished: &finished })
        });
        let batches = batches.expect("no limit");
        assert_eq!((batches.len(), batches.report().stopped, batches.report().leaves), (7, true, 6 * 10 + 50));
        assert!(7 <= finished.load(Ordering::Relaxed));
    }
}

#[test]
fn every_sink_is_finished_once_and_only_by_its_owner() {
    for threads in THREADS {
        let finished = AtomicUsize::new(0);
        let sink = || Few { room: usize::MAX, finished: &finished };
        let batches = with_threads(threads, || {
            Street::default().run_all(&lots(700), &Settings::default(), |_| sink()).expect("no limit")
        });
        assert_eq!((batches.len(), finished.load(Ordering::Relaxed)), (234, 234));
        let mut one = sink();
        for lot in lots(3) {
            assert!(Street::default().run(&lot, &Settings::default(), &mut one).is_ok());
        }
        assert_eq!(finished.load(Ordering::Relaxed), 234);
    }
}
