//! Setbacks of the edges that selectors choose, for the operations that divide faces into `shape` and `remainder`.

use std::ops::ControlFlow;

use crate::comp::select::Word;
use crate::comp::{Arm, Arms, Faces, Mode, Select, face_edges, never};
use crate::fault::FaultKind;
use crate::geometry::mesh::offset::OffsetError;
use crate::geometry::mesh::offset::set_back::{renumber, set_back as set_face_back};
use crate::run::env::Env;

/// Sets back the edges of each face that the words select, each by its distance in metres. An edge belongs to the first word that
/// selects it. Each connected part that the edges sweep is a `shape`, the rest of the face is a `remainder`. A face that cannot
/// be divided is a remainder, with a fault that begins with `what`.
pub(super) fn set_back(
    env: &mut Env,
    arms: &mut Arms<'_>,
    what: &str,
    widths: &[(Word, f64)],
) -> ControlFlow<(), Faces> {
    let distance = |width: &(Word, f64)| env.finite(width.1, format_args!("a width of {what}"));
    let distances: Vec<f64> = widths.iter().map(distance).collect();
    if !arms.shape().geometry.has_surface() {
        return ControlFlow::Continue(Faces::default());
    }
    let word = |width: &(Word, f64)| Arm { select: Select::Word(width.0), mode: Mode::Each, text: "" };
    let words: Vec<Arm> = widths.iter().map(word).collect();
    let edges = face_edges(env, arms.shape(), &words, &mut never)?;
    let mesh = arms.shape().to_mesh();
    let labels = [Word::Shape, Word::Remainder].map(|word| arms.of(word));
    let mut made = Faces { mesh: mesh.alike(0), arms: Vec::new() };
    for face in mesh.faces() {
        let by: Vec<f64> =
            edges[face.corner_range()].iter().map(|arm| arm.map_or(0.0, |arm| distances[arm as usize])).collect();
        let [setback, remainder] = match set_face_back(&face, &by, &mut made.mesh) {
            Ok(counts) => [counts.setback, counts.remainder],
            Err(why) => {
                let (number, why) = (face.index(), reason(why));
                env.fault(FaultKind::Geometry, format!("{what}: face {number} {why}; it stays whole"));
                made.mesh.add_copy(&face);
                [0, 1]
            }
        };
        made.arms.extend(std::iter::repeat_n(labels[0], setback));
        made.arms.extend(std::iter::repeat_n(labels[1], remainder));
    }
    renumber(&mut made.mesh);
    ControlFlow::Continue(made)
}

fn reason(why: OffsetError) -> &'static str {
    match why {
        OffsetError::NoNormal => "has no normal",
        OffsetError::TooMany => "has too many corners",
        OffsetError::Tangled => "touches itself",
    }
}

#[cfg(test)]
pub(super) mod tests;
