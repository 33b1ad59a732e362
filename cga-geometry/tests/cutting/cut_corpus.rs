//! Cases that once failed, and arbitrary bytes as cases.

use crate::cut_support::corpus::Case;
use crate::cut_support::{Rng, bytes};

#[test]
fn what_once_failed_holds() {
    let cases = Case::read(include_str!("../corpus/cut.txt"));
    assert!(!cases.is_empty());
    for case in &cases {
        case.check();
        // The printed case reads back as the same case.
        let again = Case::read(&case.to_string());
        assert_eq!(again[0].to_string(), case.to_string());
    }
}

/// The equivalent of `fuzz/fuzz_targets/cut.rs` for a stable compiler.
#[test]
fn any_bytes_are_cut_without_harm() {
    let mut rng = Rng(0xc0ffee);
    for _ in 0..6_000 {
        let bytes: Vec<u8> = (0..20 + rng.below(160)).map(|_| rng.next() as u8).collect();
        bytes::case(&bytes).check();
    }
}
