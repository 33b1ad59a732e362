//! Where names are looked up.

use super::context::Context;
use crate::link::InstanceId;
use crate::ops::Places;
use crate::syntax::ast::Name;

/// Where names are looked up: parameters and locals of one declaration, then everything of an instance.
pub(crate) struct Scope<'s, 'a, 'd> {
    pub(crate) cx: &'s mut Context<'a, 'd>,
    pub(crate) at: InstanceId,
    /// The instance whose entries are written.
    pub(crate) own: InstanceId,
    pub(crate) inner: Vec<&'a Name>,
    /// The attribute whose value this is.
    pub(crate) owner: Option<u32>,
    /// Inside a selector: which words ask about a component there.
    pub(crate) place: Option<Places>,
}
