//! Stretches of initial shapes, and their derivation.

use std::ops::Range;

use crate::fault::Error;
use crate::run::derive::RunOutcome;
use crate::run::report::Report;

/// The largest number of stretches: enough for any number of threads, and few enough for one sink each.
const MOST: usize = 256;

/// Neighbours in the list of initial shapes that share a sink.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Stretch {
    /// The index among the stretches, from 0.
    pub number: usize,
    /// The indices of its shapes in the list.
    pub shapes: Range<usize>,
}

impl Stretch {
    /// The number of shapes in each stretch but the last.
    fn length(shapes: usize) -> usize {
        shapes.div_ceil(MOST).max(1)
    }

    /// The number of stretches for a number of shapes.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::Stretch;
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

/// The result of a stretch.
pub(super) struct Done<T> {
    pub(super) output: T,
    /// The shapes whose runs began.
    pub(super) shapes: Range<usize>,
    /// Reports with more than counts, one for each shape: sums of floats depend on the order of addition.
    pub(super) reports: Vec<Report>,
    /// All other reports, merged.
    pub(super) counts: Report,
    /// The reason for an early end.
    pub(super) end: Option<EarlyEnd>,
}

/// The reason why no later shape is derived.
pub(super) enum EarlyEnd {
    /// The sink or the watch ended its run.
    Stopped,
    /// A run failed. The number is the index of the shape whose derivation failed.
    Failed(usize, Error),
}

/// Runs the shapes of a stretch one after the other, until an earlier stretch ends everything. `run` gets the index of a shape and adds to
/// the output.
pub(super) fn derive_stretch<T>(
    stretch: &Stretch,
    ended: &dyn Fn() -> bool,
    output: T,
    mut run: impl FnMut(&mut T, usize) -> RunOutcome,
) -> Done<T> {
    let start = stretch.shapes.start;
    let mut done = Done { output, shapes: start..start, reports: Vec::new(), counts: Report::default(), end: None };
    for at in stretch.shapes.clone() {
        if ended() {
            break;
        }
        done.shapes.end = at + 1;
        let RunOutcome { report, error, failed_neighbour } = run(&mut done.output, at);
        let failed = failed_neighbour.unwrap_or(at);
        let stopped = report.stopped;
        if report.is_only_counts() {
            done.counts.shapes = done.counts.shapes.saturating_add(report.shapes);
            done.counts.leaves += report.leaves;
        } else {
            done.reports.push(report);
        }
        done.end = error.map(|error| EarlyEnd::Failed(failed, error)).or(stopped.then_some(EarlyEnd::Stopped));
        if done.end.is_some() {
            break;
        }
    }
    done
}
