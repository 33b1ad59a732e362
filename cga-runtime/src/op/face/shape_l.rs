//! `shapeL`: front and left edges set back.

use std::ops::ControlFlow;

use crate::comp::select::Word;
use crate::comp::{Arms, Faces};
use crate::op::face::swept_edges::set_back;
use crate::run::env::Env;

/// `shapeL(frontWidth, leftWidth) { shape : … | remainder : … }`: the edges of each face that face the scope's front and left
/// are set back by these distances in metres. Each connected part that they sweep is a `shape`, the rest of the face is a
/// `remainder` (*shapeL, shapeU, shapeO operations*). A distance that is not positive sets nothing back.
///
/// The setback of an edge ends on the neighbouring edges, or on the line of a neighbour that ends at a concave corner. At a
/// corner that turns by less than 45 degrees it ends on the bisector, if the neighbour has another distance. A face without
/// a normal, one that touches itself and one with more than 5000 corners stay whole, as remainders, with a fault. In grammars
/// that use tags, edges have the tags of setbacks.
pub fn shape_l(env: &mut Env, arms: &mut Arms<'_>, front: f64, left: f64) -> ControlFlow<(), Faces> {
    set_back(env, arms, "`shapeL`", &[(Word::Front, front), (Word::Left, left)])
}

#[cfg(test)]
mod tests;
