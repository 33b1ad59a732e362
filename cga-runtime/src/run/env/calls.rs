//! The calls of functions of the rules.

use super::Env;
use crate::fault::{Error, LimitKind};
use crate::geometry::work;
use crate::run::sink::Flow;
use crate::value::text::Text;

/// The largest nesting of functions that reserve stack, as CGA documents it (*CGA changelog 2014.1*).
const DEEPEST_CALLS: u32 = 1024;

/// The stack that functions may use, in bytes of a build without optimisation, by the estimate of the compiler.
/// A function that needs more can run only while no other does. Threads have two megabytes, of which rules have their
/// share: see `STACK` in `run/context.rs`.
const FUNCTIONS: u32 = 640 * 1024;

/// The functions that are being called, and the number of calls.
#[derive(Debug, Default)]
pub(crate) struct FunctionCalls {
    /// The nesting of functions that have reserved stack.
    nested: u32,
    /// The part of [`FUNCTIONS`] that they use.
    stack: u32,
    pub(crate) made: u64,
    /// The lazy attributes and constants that are being computed, from the outermost on.
    pub(crate) open: Vec<Text>,
}

impl Env {
    /// Enters a function that needs `stack` bytes of `FUNCTIONS`. Returns false at the depth of calls that CGA allows
    /// (*CGA changelog 2014.1*: function call depth), and if the stack has no room. If it returns true,
    /// [`Env::called`] follows.
    #[inline]
    pub fn call(&mut self, stack: u32) -> bool {
        self.calls.made += 1;
        let stack = self.calls.stack + stack.min(FUNCTIONS);
        if FUNCTIONS < stack || self.calls.nested == DEEPEST_CALLS {
            let _: Flow = self.limit(LimitKind::Nesting, u64::from(self.calls.nested));
        } else if self.checkpoint.calls < self.calls.made || !work::spend(1) {
            let _: Flow = self.at_calls();
        }
        let may = !self.ended();
        if may {
            (self.calls.nested, self.calls.stack) = (self.calls.nested + 1, stack);
        }
        may
    }

    /// Counts the work of a function that reads a text or an array of a size. Returns false if the run has ended.
    #[inline]
    pub fn may_read(&mut self, size: usize) -> bool {
        (work::spend(size) || self.spend(0).is_continue()) && !self.ended()
    }

    /// Ends the run because a lazy attribute or constant needs its own value.
    #[cold]
    pub(crate) fn close_cycle(&mut self, name: &Text) {
        let first = self.calls.open.iter().rposition(|open| open == name).unwrap_or(0);
        let names = self.calls.open[first..].to_vec();
        self.error.get_or_insert(Error::Cycle { names });
        self.end();
    }

    /// Leaves a function that has reserved `stack` bytes.
    #[inline]
    pub fn called(&mut self, stack: u32) {
        self.calls.nested -= 1;
        self.calls.stack -= stack.min(FUNCTIONS);
    }
}
