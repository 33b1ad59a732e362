//! The results of runs on many shapes.

mod models;

use std::fmt;
use std::ops::Range;

use crate::fault::Error;
use crate::run::report::Report;

/// The sinks of all stretches, in order, and the merged report of the runs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Batches<S> {
    pub(crate) batches: Vec<Batch<S>>,
    pub(crate) report: Report,
}

/// A sink and the initial shapes whose leaves it has.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Batch<S> {
    /// The indices of the shapes in the list.
    pub shapes: Range<usize>,
    /// The sink, with all leaves of these shapes, in order.
    pub sink: S,
}

impl<S> Batches<S> {
    /// The batches, in the order of the shapes.
    pub fn iter(&self) -> std::slice::Iter<'_, Batch<S>> {
        self.batches.iter()
    }

    /// The sinks, in the order of the shapes.
    pub fn sinks(&self) -> impl ExactSizeIterator<Item = &S> + DoubleEndedIterator + Clone {
        self.batches.iter().map(|batch| &batch.sink)
    }

    /// The number of batches.
    pub fn len(&self) -> usize {
        self.batches.len()
    }

    /// Returns true if there are no batches, as there were no shapes.
    pub fn is_empty(&self) -> bool {
        self.batches.is_empty()
    }

    /// The reports of all runs, [merged](Report::merge) in the order of the shapes.
    pub fn report(&self) -> &Report {
        &self.report
    }
}

impl<S> IntoIterator for Batches<S> {
    type Item = Batch<S>;
    type IntoIter = std::vec::IntoIter<Batch<S>>;

    fn into_iter(self) -> Self::IntoIter {
        self.batches.into_iter()
    }
}

impl<'a, S> IntoIterator for &'a Batches<S> {
    type Item = &'a Batch<S>;
    type IntoIter = std::slice::Iter<'a, Batch<S>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// An error of one of many runs. `?` converts it to an [`Error`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RunError {
    /// The index of the initial shape in the list; `None` if the error does not depend on a shape.
    pub shape: Option<usize>,
    /// The reason why its run ended.
    pub error: Error,
}

/// The old name of [`RunError`].
#[deprecated(note = "it is called `RunError`")]
pub type ShapeError = RunError;

impl From<Error> for RunError {
    fn from(error: Error) -> Self {
        RunError { shape: None, error }
    }
}

impl From<RunError> for Error {
    fn from(error: RunError) -> Self {
        error.error
    }
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(shape) = self.shape {
            write!(f, "initial shape {shape}: ")?;
        }
        self.error.fmt(f)
    }
}

impl std::error::Error for RunError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.error)
    }
}
