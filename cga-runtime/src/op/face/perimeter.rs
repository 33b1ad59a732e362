//! `splitAndSetbackPerimeter`: sections of outlines set back.

mod short_ends;

use std::ops::ControlFlow;

use self::short_ends::FacePieces;
use crate::comp::{Faces, Section, Sections};
use crate::geometry::mesh::{FaceRef, Mesh};
use crate::geometry::offset::region::EdgeCut;
use crate::geometry::small_sort::SmallSort;
use crate::geometry::tol::TIE_EPSILON;
use crate::geometry::work;
use crate::op::Length;
use crate::op::face::swept_edges::{Turn, divided_at};
use crate::run::env::Env;
use crate::value::array::Array;

/// The name in messages.
const NAME: &str = "splitAndSetbackPerimeter";

/// `splitAndSetbackPerimeter(splitOffset) { length : depth : … | … } { remainder : … }`: the edges of all faces, one after the
/// other, are divided into sections by lengths in metres, as by `split`, and each section is set back by its depth in metres
/// (*splitAndSetbackPerimeter operation*). The pattern begins at the offset, goes along all edges and ends where it began. An
/// offset with `'` is a share of their total length.
///
/// The area that a section sweeps is one shape, the rest of each face a `remainder`. A depth that is not positive makes no
/// shape. Where sections overlap, the deeper one keeps the place, or else the first one. A section ends at right angles to its edge; at a
/// corner it ends as a setback does (see [`shape_l`](fn@crate::op::shape_l)). A section that ends too soon after a corner for a mitre there
/// is as large as the section that ends at the corner. A pattern of more than 500 sections makes none and leaves a fault.
pub fn perimeter(env: &mut Env, sections: &mut Sections<'_>, offset: Length) -> ControlFlow<(), Faces> {
    along(env, sections, offset, 0.0, None)
}

/// `splitAndSetbackPerimeter(splitOffset, firstEdgeIndex, selectedEdgesMask) { … } { … }`: the same on the edges that the
/// mask selects, in the order of `comp(fe)` from an index on, as if nothing were between them. Indices wrap; an edge without an
/// element is not selected.
pub fn perimeter_of(
    env: &mut Env,
    sections: &mut Sections<'_>,
    offset: Length,
    first: f64,
    mask: Array<bool>,
) -> ControlFlow<(), Faces> {
    let first = env.finite(first, format_args!("the first edge of `{NAME}`"));
    along(env, sections, offset, first, Some(mask.as_slice()))
}

/// The units of work of a piece of an edge.
const LINK: usize = 16;

/// An edge of the chain that is divided.
#[derive(Clone, Copy, Debug)]
struct ChainEdge {
    corner: usize,
    /// Where it begins and ends along the chain, in metres.
    start: f64,
    end: f64,
}

fn along(
    env: &mut Env,
    sections: &mut Sections<'_>,
    offset: Length,
    first: f64,
    mask: Option<&[bool]>,
) -> ControlFlow<(), Faces> {
    if !sections.shape().geometry.has_surface() {
        return ControlFlow::Continue(Faces::default());
    }
    let mesh = sections.shape().to_mesh();
    let links = chain(&mesh, first, |corner| mask.is_none_or(|mask| mask.get(corner) == Some(&true)));
    let length = links.last().map_or(0.0, |link| link.end);
    let offset = offset.of(length, env, format_args!("the offset of `{NAME}`"));
    let offset = if 0.0 < length { offset.rem_euclid(length) } else { 0.0 };
    let list = sections.along(env, length, NAME);
    let pieces = pieces(&mesh, &links, &list, offset, length);
    // The deepest sections move first.
    let mut order: Vec<usize> = (0..list.len()).filter(|&section| 0.0 < list[section].depth).collect();
    order.small_sort_by(|&a, &b| list[b].depth.total_cmp(&list[a].depth));
    let turns = |face: &FaceRef<'_>| {
        let (mut cuts, mut owners) = (Vec::new(), Vec::new());
        for (number, corner) in face.corner_range().enumerate() {
            cuts.extend(pieces.cuts_at(corner).iter().map(|&share| -> EdgeCut { (number, share) }));
            owners.extend_from_slice(pieces.sections_at(corner));
        }
        let pieces = FacePieces::of(face, &cuts);
        let turn = |&section: &usize| {
            owners.contains(&Some(section)).then(|| {
                let depth = list[section].depth;
                let mut moves: Vec<bool> = owners.iter().map(|owner| *owner == Some(section)).collect();
                pieces.keep_short_ends(&mut moves, depth);
                let distances = moves.iter().map(|&moves| if moves { depth } else { 0.0 }).collect();
                Turn { arm: Some(section as u32), distances }
            })
        };
        (cuts, order.iter().filter_map(turn).collect())
    };
    ControlFlow::Continue(divided_at(env, &mesh, sections.rest(), &format!("`{NAME}`"), &turns))
}

/// The selected edges, from the one with an index on. Indices wrap.
fn chain(mesh: &Mesh, first: f64, is_selected: impl Fn(usize) -> bool) -> Vec<ChainEdge> {
    let edges: Vec<[usize; 2]> = mesh.faces().flat_map(|face| face.edges()).collect();
    let at = |corner: usize| mesh.points()[mesh.corners()[corner] as usize];
    let from = if edges.is_empty() { 0 } else { first.floor().rem_euclid(edges.len() as f64) as usize % edges.len() };
    let mut end = 0.0;
    let links = edges[from..].iter().chain(&edges[..from]).filter(|edge| is_selected(edge[0])).map(|&[a, b]| {
        let start = end;
        end += at(a).distance(at(b));
        ChainEdge { corner: a, start, end }
    });
    links.collect()
}

/// The pieces of all edges: the shares where an edge is cut, and the section of each piece.
#[derive(Clone, Debug)]
struct Pieces {
    cuts: Vec<f64>,
    sections: Vec<Option<usize>>,
    /// The start and the end of the cuts and of the sections of each edge, by corner.
    ranges: Vec<[u32; 4]>,
}

impl Pieces {
    fn cuts_at(&self, corner: usize) -> &[f64] {
        let [start, end, ..] = self.ranges[corner];
        &self.cuts[start as usize..end as usize]
    }

    fn sections_at(&self, corner: usize) -> &[Option<usize>] {
        let [.., start, end] = self.ranges[corner];
        &self.sections[start as usize..end as usize]
    }
}

/// The pieces of each edge. The sections begin at an offset along the chain and wrap at its end. Edges that are not in the chain
/// have one piece without a section, and so do some others if the work is to end.
fn pieces(mesh: &Mesh, links: &[ChainEdge], sections: &[Section], offset: f64, length: f64) -> Pieces {
    let ranges = vec![[0, 0, 0, 1]; mesh.corners().len()];
    let mut pieces = Pieces { cuts: Vec::new(), sections: vec![None], ranges };
    let near = TIE_EPSILON * length;
    let mut ends: Vec<f64> = sections.iter().flat_map(|section| [section.start, section.end]).collect();
    ends.iter_mut().for_each(|end| *end = (*end + offset).rem_euclid(length));
    ends.small_sort_by(f64::total_cmp);
    ends.dedup_by(|a, b| *a - *b <= near);
    let section_at = |place: f64| {
        let place = (place - offset).rem_euclid(length);
        let next = sections.partition_point(|section| section.end <= place);
        sections.get(next).is_some_and(|section| section.start <= place).then_some(next)
    };
    for link in links {
        let from = ends.partition_point(|end| *end <= link.start + near);
        let inside = ends[from..].iter().copied().take_while(|end| *end < link.end - near);
        let mut places: Vec<f64> = std::iter::once(link.start).chain(inside).collect();
        if !work::spend(LINK * places.len()) {
            break;
        }
        let counts = |pieces: &Pieces| [pieces.cuts.len() as u32, pieces.sections.len() as u32];
        let start = counts(&pieces);
        pieces.cuts.extend(places[1..].iter().map(|place| (place - link.start) / (link.end - link.start)));
        places.push(link.end);
        pieces.sections.extend(places.windows(2).map(|pair| section_at(0.5 * (pair[0] + pair[1]))));
        let end = counts(&pieces);
        pieces.ranges[link.corner] = [start[0], end[0], start[1], end[1]];
    }
    pieces
}

#[cfg(test)]
mod tests;
