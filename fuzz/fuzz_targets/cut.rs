//! Any bytes as a mesh and planes: cut, and held against the laws. A failure prints the case for `tests/corpus/cut.txt`.

#![no_main]

#[path = "../../cga-geometry/tests/cutting/cut_support/mod.rs"]
mod cut_support;

use std::cell::RefCell;
use std::panic::{set_hook, take_hook};
use std::sync::Once;

use cut_support::corpus::Case;

thread_local! {
    static CURRENT: RefCell<Option<Case>> = const { RefCell::new(None) };
}

static PRINTING: Once = Once::new();

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    // A panic ends the program before anything is dropped.
    PRINTING.call_once(|| {
        let before = take_hook();
        set_hook(Box::new(move |info| {
            CURRENT.with_borrow(|case| case.iter().for_each(|case| eprintln!("{case}")));
            before(info);
        }));
    });
    let case = cut_support::bytes::case(bytes);
    CURRENT.set(Some(case.clone()));
    case.check();
});
