//! `innerRectangle` and `innerRect`: the largest rectangle in each face.

use std::ops::ControlFlow;

use crate::comp::select::Word;
use crate::comp::{Arms, Faces};
use crate::fault::FaultKind;
use crate::geometry::derive::{CornerValues, Derivation};
use crate::geometry::each::Each;
use crate::geometry::inner_rectangle::RectangleSides;
use crate::geometry::inner_rectangle::face::{RectangleRefusal, cut_rectangle};
use crate::run::env::Env;
use crate::shape::Shape;

/// The units of work of a corner of a face.
const CORNER: usize = 128;

/// The directions of a rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RectangleAlignment {
    /// Along the axes of the scope.
    Scope,
    /// Along an edge of the face that is longer than a quarter of the longest one of its loop.
    Edge,
}

impl RectangleAlignment {
    fn sides(self) -> RectangleSides {
        match self {
            RectangleAlignment::Scope => RectangleSides::Axes,
            RectangleAlignment::Edge => RectangleSides::Edges,
        }
    }
}

/// `innerRectangle(scope | edge) { shape : … | remainder : … }`: divides each face into the largest rectangle inside it, the
/// `shape`, and the rest. Each connected part of the rest is a `remainder` (*innerRectangle operation*). A face is seen along
/// the axis of the scope that is nearest to its normal: from there the `shape` is a rectangle. Of rectangles that are equally
/// large, the one nearest to the centre of gravity is taken. Parts narrower than 1e-7 of the extent of the face are dropped as
/// rounding errors.
///
/// The rectangle is exact except for rounding. The search is limited to about half a second for each face. Along the scope no
/// face that was tried reached the limit; along edges, faces with hundreds of directions do. Then longer edges count first.
///
/// A face that has no normal, touches itself, is so narrow that the corners of its rectangle fall together, or has more than
/// 5000 corners stays whole, as a remainder, with a fault. Faces keep their tags, and sides on
/// edges of the face have the tags of the edges.
pub fn inner_rectangle(env: &mut Env, arms: &mut Arms<'_>, alignment: RectangleAlignment) -> ControlFlow<(), Faces> {
    if !arms.shape().geometry.has_surface() {
        return ControlFlow::Continue(Faces::default());
    }
    let mesh = arms.shape().to_mesh();
    let labels = [Word::Shape, Word::Remainder].each(|word| arms.of(word));
    let (mut made, mut arms_of) = (Derivation::new(&mesh, CornerValues::All, 0).without_trace(), Vec::new());
    for face in mesh.faces() {
        env.spend(CORNER * face.corner_count())?;
        let count = match cut_rectangle(&face, alignment.sides(), labels[1].is_some(), &mut made) {
            Ok(count) => {
                arms_of.push(labels[0]);
                count
            }
            Err(why) => {
                let (number, why) = (face.index(), reason(why));
                env.fault(FaultKind::Geometry, format!("`innerRectangle`: face {number} {why}; it stays whole"));
                made.copy(&face);
                1
            }
        };
        arms_of.extend(std::iter::repeat_n(labels[1], count));
    }
    let mesh = made.finish_by_use();
    env.spend(0)?;
    ControlFlow::Continue(Faces { mesh, arms: arms_of })
}

/// `innerRect()`, the form before 2016.0: replaces each face by the largest rectangle along the scope's axes (*innerRect
/// operation*); see [`inner_rectangle`]. The scope is fitted to the result; its axes and the pivot stay. A face that has none
/// stays, with a fault.
pub fn inner_rect(env: &mut Env, shape: &mut Shape) {
    if !shape.geometry.has_surface() {
        return;
    }
    let mesh = shape.to_mesh();
    let mut made = Derivation::new(&mesh, CornerValues::All, 0).without_trace();
    let mut refused = 0;
    for face in mesh.faces() {
        if env.spend(CORNER * face.corner_count()).is_break() {
            return;
        }
        if let Err(why) = cut_rectangle(&face, RectangleSides::Axes, false, &mut made) {
            let (number, why) = (face.index(), reason(why));
            env.fault(FaultKind::Geometry, format!("`innerRect`: face {number} {why}; it stays as it is"));
            made.copy(&face);
            refused += 1;
        }
    }
    let made = made.finish_by_use();
    if refused < mesh.face_count() && env.count_corners(made.corners().len() as u64).is_continue() {
        shape.set_mesh(made);
    }
}

fn reason(why: RectangleRefusal) -> &'static str {
    match why {
        RectangleRefusal::NoNormal => "has no normal",
        RectangleRefusal::TooMany => "has too many corners",
        RectangleRefusal::Tangled => "touches itself or has no area",
        RectangleRefusal::TooNarrow => "is too narrow",
    }
}

#[cfg(test)]
mod tests;
