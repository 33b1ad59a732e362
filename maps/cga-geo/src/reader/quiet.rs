//! Panics of libraries, without their text on the terminal.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    /// The number of calls of [`quiet`] that this thread is in.
    static DEPTH: Cell<u32> = const { Cell::new(0) };
}

/// Calls a function of a library that may panic for a damaged file. `None` after a panic, which is not printed. Panics elsewhere are printed
/// as before: the hook of the process is called for them.
pub(super) fn quiet<T>(call: impl FnOnce() -> T) -> Option<T> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |info| {
            if DEPTH.get() == 0 {
                usual(info);
            }
        }));
    });
    DEPTH.set(DEPTH.get() + 1);
    let result = catch_unwind(AssertUnwindSafe(call));
    DEPTH.set(DEPTH.get() - 1);
    result.ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_caught_at_any_depth() {
        let caught = quiet(|| {
            assert_eq!(quiet(|| -> u32 { panic!("inner") }), None);
            7
        });
        assert_eq!((caught, DEPTH.get()), (Some(7), 0));
    }
}
