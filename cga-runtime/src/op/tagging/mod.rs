//! Operations on the tags of components.

pub(crate) mod delete_tags;
pub(crate) mod edge_attr_tags;
pub(crate) mod tag;
