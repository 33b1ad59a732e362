//! The work of long operations, counted so that they can end early.
//!
//! Algorithms whose time grows faster than their input count their work with [`spend`]. After every `UNITS_A_QUESTION` units the
//! thread asks its [`Supervisor`] whether to go on. A thread without a supervisor always goes on.
//! The count belongs to the thread, because the algorithms lie many calls below the run.

use std::cell::{Cell, RefCell};
use std::fmt;

/// The units of work between two questions. A unit is the comparison of two edges or the like, some nanoseconds.
pub(crate) const UNITS_A_QUESTION: u64 = 1 << 16;

/// Returns true if work goes on. Its argument is the number of units since the last question.
type Question = Box<dyn Fn(u64) -> bool>;

thread_local! {
    static UNITS: Cell<u64> = const { Cell::new(0) };
    static MAY_GO_ON: Cell<bool> = const { Cell::new(true) };
    static QUESTION: RefCell<Option<Question>> = const { RefCell::new(None) };
}

/// Decides whether the work of this thread goes on, until the value is dropped. Then the supervisor before it decides again.
pub struct Supervisor {
    before: Option<Question>,
    units: u64,
    went_on: bool,
}

impl Supervisor {
    /// A supervisor of this thread that answers by `question`, whose argument is the number of units since the last question. After
    /// its first false it is asked no more. Supervisors of one thread are dropped in the reverse order, and `question` makes
    /// none.
    pub fn new(question: impl Fn(u64) -> bool + 'static) -> Self {
        let before = QUESTION.with(|own| own.replace(Some(Box::new(question))));
        Supervisor { before, units: UNITS.replace(0), went_on: MAY_GO_ON.replace(true) }
    }
}

impl fmt::Debug for Supervisor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Supervisor").finish_non_exhaustive()
    }
}

impl Drop for Supervisor {
    fn drop(&mut self) {
        let before = self.before.take();
        QUESTION.with(|own| *own.borrow_mut() = before);
        UNITS.set(self.units);
        MAY_GO_ON.set(self.went_on);
    }
}

/// Counts units of work. Returns false if the work is to end; its result does not matter then.
#[inline]
#[must_use]
pub fn spend(units: usize) -> bool {
    let all = UNITS.get().saturating_add(units as u64);
    UNITS.set(all);
    if all < UNITS_A_QUESTION { MAY_GO_ON.get() } else { ask() }
}

/// Asks whether the work goes on.
#[cold]
pub fn ask() -> bool {
    let units = UNITS.replace(0);
    let goes_on =
        MAY_GO_ON.get() && QUESTION.with(|question| question.borrow().as_ref().is_none_or(|question| question(units)));
    MAY_GO_ON.set(goes_on);
    goes_on
}

#[cfg(test)]
mod tests {
    use std::rc::Rc;

    use super::*;

    #[test]
    fn work_ends_when_the_answer_is_no() {
        assert!(spend(usize::MAX), "without a supervisor work goes on");
        let asked = Rc::new(Cell::new(0));
        let count = asked.clone();
        let outer = Supervisor::new(move |units| {
            count.set(count.get() + units);
            count.get() < 3 * UNITS_A_QUESTION
        });
        assert!(spend(UNITS_A_QUESTION as usize - 1) && asked.get() == 0);
        assert!(spend(1) && asked.get() == UNITS_A_QUESTION);
        {
            let _inner = Supervisor::new(|_| false);
            assert!(spend(5) && !ask() && !spend(5), "the answer stays");
        }
        assert!(spend(UNITS_A_QUESTION as usize) && !spend(UNITS_A_QUESTION as usize) && !spend(1));
        assert_eq!(asked.get(), 3 * UNITS_A_QUESTION, "after the answer no question follows");
        drop(outer);
        assert!(spend(usize::MAX));
    }
}
