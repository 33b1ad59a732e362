//! Support of the tests of functions.

use super::*;
use crate::fault::{Error, LimitKind};
use crate::run::env::Env;
use crate::run::settings::Settings;
use crate::value::array::Array;
use crate::value::text::Text;

/// A run with the default settings.
pub(super) fn env() -> Env {
    Env::for_tests()
}

/// A run with small limits.
pub(super) fn small_env(array: u64, text: u64) -> Env {
    let mut settings = Settings::default();
    (settings.limits.array, settings.limits.text) = (array, text);
    Env::with_names(&settings, &[], &crate::shape::Shape::rectangle(1.0, 1.0), "")
}

/// The number of faults since the last call.
pub(super) fn faults(env: &mut Env) -> usize {
    env.take_faults().0.len()
}

/// The limit that was reached.
pub(super) fn limit(env: &Env) -> Option<LimitKind> {
    match &env.error {
        Some(Error::Limit { what, .. }) => Some(*what),
        _ => None,
    }
}

pub(super) fn text(text: &str) -> Text {
    Text::from(text)
}

/// splitmix64: the same numbers on every machine.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % bound.max(1) as u64) as usize
    }

    /// Mostly small numbers, with halves, and occasionally a special value.
    pub(super) fn number(&mut self) -> f64 {
        const AWKWARD: [f64; 8] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 1e300, -1e300, 1e-300, 4.5e15];
        if self.below(12) == 0 { AWKWARD[self.below(8)] } else { self.below(25) as f64 / 2.0 - 3.0 }
    }
}

#[test]
fn fractions_are_cut_off() {
    assert_eq!([2.9, -0.5, -1.0, f64::NAN].map(whole), [Some(2), Some(0), None, None]);
    assert_eq!([f64::INFINITY, f64::NEG_INFINITY].map(whole), [Some(usize::MAX), None]);
}

/// `[base : limit]`: in steps of 1 (*colon operator*).
pub(super) fn range(env: &mut Env, base: f64, limit: f64) -> Array<f64> {
    range_by(env, base, 1.0, limit)
}
