//! The location of generated code in the rules: debuggers and backtraces find the lines of steps by it.
//!
//! The generator sets the location before it writes a step, as a compiler does before it emits instructions, and all tokens
//! of `code!` get it. It changes no name: names are resolved as names of `Span::mixed_site()` are.

use std::cell::Cell;

use proc_macro2::Span;

thread_local! {
    /// `None` for the macro call itself.
    static LOCATION: Cell<Option<Span>> = const { Cell::new(None) };
}

/// The span of generated tokens.
pub(crate) fn current() -> Span {
    LOCATION.get().unwrap_or_else(Span::mixed_site)
}

/// Writes code at the location of a token.
pub(crate) fn at<T>(token: Span, write: impl FnOnce() -> T) -> T {
    /// Sets the outer location again, also after a panic: a span does not outlive its macro call.
    struct Outer(Option<Span>);

    impl Drop for Outer {
        fn drop(&mut self) {
            LOCATION.set(self.0);
        }
    }

    let _outer = Outer(LOCATION.replace(Some(Span::mixed_site().located_at(token))));
    write()
}
