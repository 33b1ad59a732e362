//! Setbacks of edges, for the operations that divide faces into what edges sweep and a remainder.

use std::ops::ControlFlow;

use crate::comp::select::Word;
use crate::comp::{Arms, Faces, face_edges};
use crate::fault::FaultKind;
use crate::geometry::derive::{CornerValues, Derivation};
use crate::geometry::mesh::{FaceRef, Mesh};
use crate::geometry::offset::OffsetError;
use crate::geometry::offset::each_edge::{set_back as set_face_back, stay};
use crate::geometry::offset::region::EdgeCut;
use crate::geometry::offset::to_area::CORNER;
use crate::geometry::work;
use crate::run::env::Env;

/// Edges of a face that move together, and the arm of what they sweep.
pub(in crate::op) struct Turn {
    pub(in crate::op) arm: Option<u32>,
    /// One distance in metres for each piece of the outline.
    pub(in crate::op) distances: Vec<f64>,
}

/// The cuts of the edges of a face, and the turns of the pieces.
type FaceTurns = (Vec<EdgeCut>, Vec<Turn>);

/// Sets back the edges of each face that the words select, each by its distance in metres. An edge belongs to the first word that
/// selects it. Each connected part that the edges sweep is a `shape`, the rest of the face is a `remainder`. A face that cannot
/// be divided is a remainder, with a fault that begins with `what`.
pub(in crate::op) fn set_back(
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
    let edges = face_edges(env, arms.shape(), widths.iter().map(|width| width.0))?;
    let mesh = arms.shape().to_mesh();
    let shape = arms.of(Word::Shape);
    let turns = |face: &FaceRef<'_>| {
        let edges = edges[face.corner_range()].iter();
        let distances = edges.map(|word| word.map_or(0.0, |word| distances[word as usize])).collect();
        vec![Turn { arm: shape, distances }]
    };
    ControlFlow::Continue(divided(env, &mesh, arms.of(Word::Remainder), what, &turns))
}

/// The edges of each face that arms select, in turns: the edges of the first arm move first. `distance` gives the distance in
/// metres of an edge by its corner in the mesh; those that are not positive do not move.
pub(in crate::op) fn turns(face: &FaceRef<'_>, edges: &[Option<u32>], distance: impl Fn(usize) -> f64) -> Vec<Turn> {
    let range = face.corner_range();
    let mut turns: Vec<Turn> = Vec::new();
    for (piece, corner) in range.clone().enumerate() {
        let distance = distance(corner);
        if let Some(arm) = edges[corner]
            && 0.0 < distance
        {
            let at = turns.binary_search_by_key(&Some(arm), |turn| turn.arm).unwrap_or_else(|at| {
                turns.insert(at, Turn { arm: Some(arm), distances: vec![0.0; range.len()] });
                at
            });
            turns[at].distances[piece] = distance;
        }
    }
    turns
}

/// Divides the faces of a mesh. A face that cannot be divided is a remainder, with a fault that begins with `what`.
pub(in crate::op) fn divided(
    env: &mut Env,
    mesh: &Mesh,
    remainder: Option<u32>,
    what: &str,
    turns: &dyn Fn(&FaceRef<'_>) -> Vec<Turn>,
) -> Faces {
    divided_at(env, mesh, remainder, what, &|face| (Vec::new(), turns(face)))
}

/// Divides the faces of a mesh, whose edges are divided into pieces by cuts. In grammars that use tags, edges are tagged: those
/// set back `setback.front`, their new places `setback.back`, the ends `setback.side`, and those left `setback.remainder`
/// (*setback operation*).
pub(in crate::op) fn divided_at(
    env: &mut Env,
    mesh: &Mesh,
    remainder: Option<u32>,
    what: &str,
    turns: &dyn Fn(&FaceRef<'_>) -> FaceTurns,
) -> Faces {
    let (mut made, mut arms) = (Derivation::new(mesh, CornerValues::All, 0).without_trace(), Vec::new());
    for face in mesh.faces() {
        if !work::spend(CORNER * face.corner_count()) {
            break;
        }
        let (cuts, turns) = turns(&face);
        let distances: Vec<&[f64]> = turns.iter().map(|turn| &turn.distances[..]).collect();
        match set_face_back(&face, &cuts, &distances, env.tags_edges, &mut made) {
            Ok(counts) => {
                let turns = turns.iter().map(|turn| turn.arm).chain([remainder]);
                arms.extend(turns.zip(counts).flat_map(|(arm, count)| std::iter::repeat_n(arm, count)));
            }
            Err(why) => {
                let (number, why) = (face.index(), reason(why));
                env.fault(FaultKind::Geometry, format!("{what}: face {number} {why}; it stays whole"));
                stay(&face, env.tags_edges, &mut made);
                arms.push(remainder);
            }
        }
    }
    let mesh = made.finish_by_use();
    if work::spend(0) { Faces { mesh, arms } } else { Faces::default() }
}

fn reason(why: OffsetError) -> &'static str {
    match why {
        OffsetError::NoNormal => "has no normal",
        OffsetError::TooMany => "has too many corners",
        OffsetError::Tangled => "touches itself",
    }
}

#[cfg(test)]
pub(in crate::op) mod tests;
