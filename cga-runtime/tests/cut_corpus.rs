//! Cases that once failed, and any bytes as cases.

mod cut_support;

use cut_support::corpus::Case;
use cut_support::{Rng, bytes};

#[test]
fn what_once_failed_holds() {
    let cases = Case::read(include_str!("corpus/cut.txt"));
    assert!(!cases.is_empty());
    for case in &cases {
        case.check();
        // And reads back as it prints.
        let again = Case::read(&case.to_string());
        assert_eq!(again[0].to_string(), case.to_string());
    }
}

/// The twin of `fuzz/fuzz_targets/cut.rs` that needs no nightly compiler.
#[test]
fn any_bytes_are_cut_without_harm() {
    let mut rng = Rng(0xc0ffee);
    for _ in 0..6_000 {
        let bytes: Vec<u8> = (0..20 + rng.below(160)).map(|_| rng.next() as u8).collect();
        bytes::case(&bytes).check();
    }
}
