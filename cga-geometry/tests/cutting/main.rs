//! The tests of geometry from outside: cuts, cuts along lines of constant texture coordinate, triangulation.

mod cut_corpus;
mod cut_first;
mod cut_hostile;
mod cut_laws;
mod cut_nest;
mod cut_plane;
mod cut_rough;
mod cut_shapes;
mod cut_sheets;
mod cut_support;
mod cut_tags;
mod iso_cases;
mod iso_hostile;
mod iso_laws;
mod iso_support;
mod triangulate;
