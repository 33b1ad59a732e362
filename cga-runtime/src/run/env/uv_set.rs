//! Numbers of texture coordinate sets.

use super::Env;
use crate::fault::FaultKind;
use crate::shape::texture::SETS;

impl Env {
    /// The number of a uv set. Another number than 0 to 9 is a fault.
    pub(crate) fn uv_set(&mut self, set: f64, what: &str) -> Option<u8> {
        let known = (0..SETS as u8).find(|&known| f64::from(known) == set);
        if known.is_none() {
            self.fault(
                FaultKind::Value,
                format!("`{what}`: uv set {set} does not exist, only 0 to 9; it does nothing"),
            );
        }
        known
    }
}
