//! Operations on whole meshes.

pub(crate) mod boolean;
pub(crate) mod cleanup;
pub(crate) mod convexify;
pub(crate) mod inline;
pub(crate) mod joined;
pub(crate) mod mirror;
pub(crate) mod normals;
pub(crate) mod recompose;
pub(crate) mod rectify;
pub(crate) mod reduce;
pub(crate) mod same_scope;
