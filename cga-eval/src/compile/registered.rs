//! Functions of the host program that rules call.

use std::collections::BTreeMap;

use crate::code::{HostFunction, HostOperation};

/// The functions and operations of the host program, by their paths in rules.
#[derive(Clone, Default)]
pub(crate) struct Registered {
    pub(crate) functions: BTreeMap<String, HostFunction>,
    pub(crate) operations: BTreeMap<String, HostOperation>,
}

impl std::fmt::Debug for Registered {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.functions.keys()).entries(self.operations.keys()).finish()
    }
}
