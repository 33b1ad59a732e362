//! What every pass is given.

use super::globals::Globals;
use super::tables::Tables;
use crate::diag::Diags;
use crate::link::InstanceId;

/// The program, what is known of it so far, and the diagnostics.
pub(crate) struct Context<'a, 'd> {
    pub(crate) globals: Globals<'a>,
    pub(crate) tables: Tables,
    /// The instance that is looked at, for passes that go from one to the next.
    pub(crate) at: InstanceId,
    pub(crate) diags: &'d mut Diags,
}
