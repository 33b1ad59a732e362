//! A recording.

use super::Hole;
use crate::shape::base::Base;

/// The recording of a template under construction.
pub(crate) struct Tape<'r, C> {
    /// The base of the shape at the origin.
    pub(super) base: &'r Base,
    /// The number of leaves of the run that fill their scopes, of others, and of rules on its trail, before the template.
    pub(super) filled: u64,
    pub(super) leaves: u64,
    pub(super) trail: usize,
    pub(super) holes: Vec<Hole<C>>,
}
