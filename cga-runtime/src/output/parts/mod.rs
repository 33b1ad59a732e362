//! The results of runs on many shapes.

mod models;

use std::fmt;
use std::ops::Range;

use crate::fault::Error;
use crate::run::report::Report;

/// The sinks of all stretches, in order, and the merged report of the runs.
#[derive(Clone, Debug, Default)]
pub struct Parts<S> {
    pub(crate) parts: Vec<Part<S>>,
    pub(crate) report: Report,
}

/// A sink and the initial shapes whose leaves it has.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Part<S> {
    /// The indices of the shapes in the list.
    pub shapes: Range<usize>,
    /// The sink, with all leaves of these shapes, in order.
    pub sink: S,
}

impl<S> Parts<S> {
    /// The parts, in the order of the shapes.
    pub fn iter(&self) -> std::slice::Iter<'_, Part<S>> {
        self.parts.iter()
    }

    /// The sinks, in the order of the shapes.
    pub fn sinks(&self) -> impl ExactSizeIterator<Item = &S> + DoubleEndedIterator + Clone {
        self.parts.iter().map(|part| &part.sink)
    }

    /// The number of parts.
    pub fn len(&self) -> usize {
        self.parts.len()
    }

    /// Returns true if there are no parts, as there were no shapes.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// The reports of all runs, [merged](Report::merge) in the order of the shapes.
    pub fn report(&self) -> &Report {
        &self.report
    }
}

impl<S> IntoIterator for Parts<S> {
    type Item = Part<S>;
    type IntoIter = std::vec::IntoIter<Part<S>>;

    fn into_iter(self) -> Self::IntoIter {
        self.parts.into_iter()
    }
}

impl<'a, S> IntoIterator for &'a Parts<S> {
    type Item = &'a Part<S>;
    type IntoIter = std::slice::Iter<'a, Part<S>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// An error of one of many runs. `?` converts it to an [`Error`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ShapeError {
    /// The index of the initial shape in the list; `None` if the error does not depend on a shape.
    pub shape: Option<usize>,
    /// The reason why its run ended.
    pub error: Error,
}

impl From<Error> for ShapeError {
    fn from(error: Error) -> Self {
        ShapeError { shape: None, error }
    }
}

impl From<ShapeError> for Error {
    fn from(error: ShapeError) -> Self {
        error.error
    }
}

impl fmt::Display for ShapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(shape) = self.shape {
            write!(f, "initial shape {shape}: ")?;
        }
        self.error.fmt(f)
    }
}

impl std::error::Error for ShapeError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.error)
    }
}
