//! Stretches of initial shapes, and how one is derived.

use std::ops::Range;

use crate::fault::Error;
use crate::run::derive::Outcome;
use crate::run::report::Report;
use crate::shape::Shape;

/// The most stretches that shapes are divided into: enough for any number of threads, few enough for a sink each.
const MOST: usize = 256;

/// Neighbours in the list of initial shapes that share a sink.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Stretch {
    /// Counts from 0.
    pub number: usize,
    /// Its shapes, by their place in the list.
    pub shapes: Range<usize>,
}

impl Stretch {
    /// Shapes in each stretch but the last.
    fn length(shapes: usize) -> usize {
        shapes.div_ceil(MOST).max(1)
    }

    /// The number of stretches for a number of shapes.
    ///
    /// ```
    /// use cga_runtime::grammar::parallel::Stretch;
    ///
    /// assert_eq!([0, 1, 100, 1000, 100_000].map(Stretch::count), [0, 1, 100, 250, 256]);
    /// ```
    pub fn count(shapes: usize) -> usize {
        shapes.div_ceil(Stretch::length(shapes))
    }

    pub(super) fn of(number: usize, shapes: usize) -> Self {
        let length = Stretch::length(shapes);
        Stretch { number, shapes: number * length..((number + 1) * length).min(shapes) }
    }
}

/// A stretch that was derived.
pub(super) struct Done<T> {
    pub(super) output: T,
    /// Shapes whose runs began.
    pub(super) shapes: Range<usize>,
    /// Reports that are more than counts, one a shape: sums of floats depend on the order in which they are added.
    pub(super) reports: Vec<Report>,
    /// All others taken together.
    pub(super) counts: Report,
    /// Why it ended early, if it did.
    pub(super) end: Option<EarlyEnd>,
}

impl Done<()> {
    /// The same with an output.
    pub(super) fn with<T>(self, output: T) -> Done<T> {
        let Done { output: (), shapes, reports, counts, end } = self;
        Done { output, shapes, reports, counts, end }
    }
}

/// Why nothing comes after a shape.
pub(super) enum EarlyEnd {
    /// The sink or the watch ended its run.
    Stopped,
    /// Its run, by the place of the shape in the list.
    Failed(usize, Error),
}

/// Runs the shapes of a stretch one after the other, unless everything ended before it.
pub(super) fn derive_stretch(
    shapes: &[Shape],
    stretch: &Stretch,
    ended: &dyn Fn() -> bool,
    mut run: impl FnMut(&Shape) -> Outcome,
) -> Done<()> {
    let start = stretch.shapes.start;
    let mut done = Done { output: (), shapes: start..start, reports: Vec::new(), counts: Report::default(), end: None };
    for at in stretch.shapes.clone() {
        if ended() {
            break;
        }
        done.shapes.end = at + 1;
        let Outcome { report, error } = run(&shapes[at]);
        let stopped = report.stopped;
        if report.is_only_counts() {
            done.counts.shapes = done.counts.shapes.saturating_add(report.shapes);
            done.counts.leaves += report.leaves;
        } else {
            done.reports.push(report);
        }
        done.end = error.map(|error| EarlyEnd::Failed(at, error)).or(stopped.then_some(EarlyEnd::Stopped));
        if done.end.is_some() {
            break;
        }
    }
    done
}
