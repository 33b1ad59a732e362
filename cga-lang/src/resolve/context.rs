//! The input of every pass.

use super::globals::Globals;
use super::tables::Tables;
use crate::diag::Diags;
use crate::link::InstanceId;

/// The program, its side tables, and the diagnostics.
pub(crate) struct Context<'a, 'd> {
    pub(crate) globals: Globals<'a>,
    pub(crate) tables: Tables,
    /// The current instance, for passes that visit one after the other.
    pub(crate) at: InstanceId,
    pub(crate) diags: &'d mut Diags,
}
