//! Calls of operations, by the form of the operation.

pub(crate) mod arms;
pub(crate) mod each;
pub(super) mod made;
pub(crate) mod operands;
pub(crate) mod says;
pub(crate) mod sections;
pub(crate) mod slim;
pub(super) mod whole;
