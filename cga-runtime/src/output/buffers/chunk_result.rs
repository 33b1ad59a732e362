//! The results of a function that takes chunks.

use std::ops::ControlFlow;

use self::outcome::Outcome;
use crate::run::sink::Flow;

/// The result of a function that takes [`Chunks`](super::Chunks): a [`Flow`], or a [`Result`] whose error ends the run.
pub trait ChunkResult: Outcome {}

impl ChunkResult for Flow {}
impl<E> ChunkResult for Result<(), E> {}

mod outcome {
    /// A result that goes on or ends.
    pub trait Outcome {
        /// The result that goes on.
        fn go_on() -> Self;

        /// Returns true for a result that ends the run.
        fn is_end(&self) -> bool;
    }
}

impl Outcome for Flow {
    fn go_on() -> Self {
        ControlFlow::Continue(())
    }

    fn is_end(&self) -> bool {
        self.is_break()
    }
}

impl<E> Outcome for Result<(), E> {
    fn go_on() -> Self {
        Ok(())
    }

    fn is_end(&self) -> bool {
        self.is_err()
    }
}
