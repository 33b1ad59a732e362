//! Numbers of texture coordinate sets.

use super::Env;
use crate::fault::FaultKind;
use crate::shape::texture::SETS;

impl Env {
    /// The number of a set; a fault for any other number.
    pub(crate) fn uv_set(&mut self, set: f64, what: &str) -> Option<u8> {
        let known = (0..SETS as u8).find(|&known| f64::from(known) == set);
        if known.is_none() {
            self.fault(FaultKind::Value, format!("`{what}`: there is no uv set {set}, only 0 to 9; it does nothing"));
        }
        known
    }
}
