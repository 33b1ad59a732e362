//! The shape on which an expression is evaluated.

use cga_runtime::rt::{Shape, ShapeRef};
use cga_runtime::rt_eval::Candidate;

/// The current shape.
pub(crate) enum Current<'a, 'b> {
    /// A slim shape. A function that reads more than it has gets the whole shape.
    Slim(&'a ShapeRef<'b>),
    /// A whole shape.
    Whole(&'a mut Shape),
    /// A component that a condition tests.
    Candidate(&'a mut Candidate<'b>),
}

/// An expression with the current shape as a view.
macro_rules! view {
    ($env:ident, $current:ident, |$shape:ident| $value:expr) => {
        match $current {
            $crate::current::Current::Slim(slim) => {
                let $shape = &mut { *slim };
                let _ = &$env;
                $value
            }
            $crate::current::Current::Whole(whole) => {
                let $shape = &mut **whole;
                $value
            }
            $crate::current::Current::Candidate(candidate) => {
                let $shape = candidate.shape();
                $value
            }
        }
    };
}

/// An expression with the current shape as a whole one.
macro_rules! whole {
    ($env:ident, $current:ident, |$shape:ident| $value:expr) => {
        match $current {
            $crate::current::Current::Slim(slim) => {
                let mut whole = $env.whole(slim);
                let value = {
                    let $shape = &mut whole;
                    $value
                };
                slim.drawn(&whole);
                value
            }
            $crate::current::Current::Whole(whole) => {
                let $shape = &mut **whole;
                $value
            }
            $crate::current::Current::Candidate(candidate) => {
                let $shape = candidate.shape();
                $value
            }
        }
    };
}

/// An expression with the component that a condition tests; false elsewhere.
macro_rules! candidate {
    ($current:ident, |$candidate:ident| $value:expr) => {
        match $current {
            $crate::current::Current::Candidate(candidate) => {
                let $candidate = &mut **candidate;
                $value
            }
            _ => false,
        }
    };
}

pub(crate) use {candidate, view, whole};
