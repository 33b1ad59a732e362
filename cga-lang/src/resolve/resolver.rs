//! The state of name resolution.

use super::context::Context;
use crate::link::InstanceId;
use crate::ops::SelectorPlaces;
use crate::syntax::ast::Name;

/// Resolves the names of a declaration: to its parameters and locals, then to the declarations of an instance.
pub(crate) struct Resolver<'s, 'a, 'd> {
    pub(crate) cx: &'s mut Context<'a, 'd>,
    pub(crate) at: InstanceId,
    /// The instance whose entries are written.
    pub(crate) own: InstanceId,
    pub(crate) inner: Vec<&'a Name>,
    /// The attribute that the value belongs to.
    pub(crate) owner: Option<u32>,
    /// In a selector, the components that its words can read.
    pub(crate) place: Option<SelectorPlaces>,
}
