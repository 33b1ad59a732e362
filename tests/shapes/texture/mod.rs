//! Texture coordinates: projections and operations on sets (*setupProjection*, *projectUV*, *texture*, *tileUV* and the pages beside
//! them), on boxes and on meshes, from templates and without.

mod along;
mod box_sides;
mod caps;
mod facts;
mod hostile;
mod laws;
mod orders;
mod projections;
mod sets;
mod splits;
