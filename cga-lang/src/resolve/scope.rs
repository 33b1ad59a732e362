//! Scopes of names.

use super::context::Context;
use crate::link::InstanceId;
use crate::ops::Places;
use crate::syntax::ast::Name;

/// The scope of a name: parameters and locals of one declaration, then all declarations of an instance.
pub(crate) struct Scope<'s, 'a, 'd> {
    pub(crate) cx: &'s mut Context<'a, 'd>,
    pub(crate) at: InstanceId,
    /// The instance whose entries are written.
    pub(crate) own: InstanceId,
    pub(crate) inner: Vec<&'a Name>,
    /// The attribute that the value belongs to.
    pub(crate) owner: Option<u32>,
    /// In a selector, the components that its words can read.
    pub(crate) place: Option<Places>,
}
