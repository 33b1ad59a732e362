//! The part of a face that is left, while its edges are set back in turns.
//!
//! A turn moves some edges, each by a distance of its own, and everything else stays. What they sweep is taken from the
//! region, and the next turn divides the rest: so the parts of all turns and the rest add up to the face, and an
//! earlier turn keeps a corner that a later one reaches too.

use std::collections::BTreeMap;

use glam::DVec2;

use super::sides::{SideKind, SideOrigin, SideOrigins};
use super::{OffsetError, relief};
use crate::disjoint::DisjointSets;
use crate::each::Each;
use crate::mesh::FlatFace;
use crate::nesting::contour::Contour;
use crate::skeleton::{self, SkeletonError, Swept};
use crate::small_sort::SmallSort;
use crate::tol::MEETING_EPSILONS;

/// The piece of a side that is on no edge of the face.
const NONE: usize = usize::MAX;

/// A place on an edge of a face that divides the edge: the number of the corner where the edge begins, counted from the
/// first one of the face, and the share of the edge before the place, from 0 to 1.
pub type EdgeCut = (usize, f64);

/// A side of the region: its first point, and its piece. Pieces are the edges of the face, or the parts of divided
/// ones, in order.
#[derive(Clone, Copy, Debug)]
struct RegionSide {
    point: u32,
    piece: usize,
    /// True if the piece has moved.
    has_moved: bool,
}

/// Loops of a part of a face. A corner has the rank of its next side, and the point.
pub(super) type Loops = Vec<Vec<(usize, u32)>>;

/// A region in the plane of a face.
pub(crate) struct FaceRegion {
    /// The points of the face, the points that divide edges, and the points of all turns.
    pub(super) points: Vec<DVec2>,
    pub(super) heights: Vec<f64>,
    /// The edge of each piece: the number of its first corner, counted from the first one of the face.
    edges: Vec<usize>,
    rings: Vec<Vec<RegionSide>>,
}

impl FaceRegion {
    /// The whole face. The cuts are in the order of edges, and of shares along an edge.
    pub(crate) fn of(plane: &FlatFace<'_>, cuts: &[EdgeCut]) -> Self {
        let (mut points, mut heights) = (plane.flat.clone(), plane.heights.clone());
        let (edges, rings) = plane.edges(false);
        let (mut edges, mut cuts, mut pieces) = (edges.iter(), cuts.iter().peekable(), Vec::new());
        let mut divided = Vec::with_capacity(rings.len());
        for ring in rings {
            let mut sides = Vec::with_capacity(ring.len());
            for edge in edges.by_ref().take(ring.len()) {
                let mut add = |point: u32| {
                    sides.push(RegionSide { point, piece: pieces.len(), has_moved: false });
                    pieces.push(edge[0]);
                };
                let [a, b] = edge.each(|corner| plane.corners[corner]);
                add(a);
                while let Some((_, share)) = cuts.next_if(|cut| cut.0 == edge[0]) {
                    let [a, b] = [a, b].each(|end| end as usize);
                    points.push(points[a].lerp(points[b], *share));
                    heights.push(heights[a] + (heights[b] - heights[a]) * share);
                    add(points.len() as u32 - 1);
                }
            }
            divided.push(sides);
        }
        FaceRegion { points, heights, edges: pieces, rings: divided }
    }

    /// The area.
    pub(crate) fn area(&self) -> f64 {
        let at = |side: &RegionSide| self.points[side.point as usize];
        let twice = |ring: &Vec<RegionSide>| -> f64 {
            let first = at(&ring[0]);
            ring.windows(2).map(|pair| (at(&pair[0]) - first).perp_dot(at(&pair[1]) - first)).sum()
        };
        0.5 * self.rings.iter().map(twice).sum::<f64>()
    }

    /// The total length of the sides on some pieces.
    pub(crate) fn length(&self, of: impl Fn(usize) -> bool) -> f64 {
        let at = |side: &RegionSide| self.points[side.point as usize];
        let sides = self.rings.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
        sides.filter(|(side, _)| side.piece != NONE && of(side.piece)).map(|(a, b)| at(a).distance(at(b))).sum()
    }

    /// Moves pieces by distances and takes from the region what they sweep. Distances that are not positive leave their
    /// pieces where they are. Returns the loops of the parts that were taken; they begin with the first piece that moved.
    pub(super) fn set_back(&mut self, distances: &[f64]) -> Result<(Loops, SideOrigins), OffsetError> {
        let old: Vec<RegionSide> = self.rings.iter().flatten().copied().collect();
        let distance = |side: &RegionSide| distances.get(side.piece).map_or(0.0, |distance| distance.max(0.0));
        let distances: Vec<f64> = old.iter().map(distance).collect();
        if !distances.iter().any(|distance| 0.0 < *distance) {
            return Ok(Default::default());
        }
        let rings: Vec<Vec<u32>> = self.rings.iter().map(|ring| ring.iter().map(|side| side.point).collect()).collect();
        let mut swept = skeleton::sweep_each(&self.points, &rings, &distances)?;
        let rank = |side: usize| {
            let piece = old[side].piece;
            if 0.0 < distances[side] { piece } else { piece.saturating_add(self.edges.len()) }
        };
        let mut origins = SideOrigins::new();
        let origin = |side: [u32; 2], edge: usize, kind: SideKind| {
            let edge = old.get(edge).and_then(|side| self.edges.get(side.piece)).copied();
            origins.insert(side, SideOrigin { kind, edge });
        };
        let taken = taken(&rings, &mut swept, &distances, rank, origin)?;
        self.heights = relief::heights(&self.heights, &rings, &swept);
        let side = |left: &skeleton::FrontCorner| {
            let edge = left.edge as usize;
            let Some(old) = old.get(edge) else {
                return RegionSide { point: left.point, piece: NONE, has_moved: true };
            };
            RegionSide { point: left.point, piece: old.piece, has_moved: old.has_moved || 0.0 < distances[edge] }
        };
        self.rings = swept.left.iter().map(|ring| ring.iter().map(side).collect()).collect();
        self.points = std::mem::take(&mut swept.points);
        Ok((taken, origins))
    }

    /// The loops of the region. They begin with the first piece that has a side.
    pub(super) fn loops(&self) -> (Loops, SideOrigins) {
        let ring =
            |ring: &Vec<RegionSide>| super::from_first(ring.iter().map(|side| (side.piece, side.point)).collect());
        let mut origins = SideOrigins::new();
        for ring in &self.rings {
            for (side, next) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let kind = match side {
                    RegionSide { piece: NONE, .. } => SideKind::End,
                    RegionSide { has_moved: true, .. } => SideKind::Back,
                    RegionSide { has_moved: false, .. } => SideKind::Remainder,
                };
                let edge = self.edges.get(side.piece).copied();
                origins.insert([side.point, next.point], SideOrigin { kind, edge });
            }
        }
        (self.rings.iter().map(ring).collect(), origins)
    }
}

/// The loops of what the sides swept. Calls `origin` with each side of them, the number of the edge from which it comes, and
/// its kind. An error if a loop does not close.
fn taken(
    rings: &[Vec<u32>],
    swept: &mut Swept,
    distances: &[f64],
    rank: impl Fn(usize) -> usize,
    mut origin: impl FnMut([u32; 2], usize, SideKind),
) -> Result<Loops, SkeletonError> {
    let sides = rings.iter().flat_map(|ring| (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]]));
    // The sides along the line of each edge.
    let mut lines: Vec<Vec<[u32; 2]>> = sides.map(|side| vec![side]).collect();
    for ring in &swept.left {
        for (k, left) in ring.iter().enumerate() {
            let side = [ring[(k + 1) % ring.len()].point, left.point];
            let edge = left.edge as usize;
            lines.resize(lines.len().max(edge + 1), Vec::new());
            lines[edge].push(side);
        }
    }
    weld(&mut lines, swept);
    let (mut ranks, mut all) = (BTreeMap::new(), Vec::new());
    for (edge, sides) in lines.iter().enumerate() {
        let is_moved = distances.get(edge).is_some_and(|distance| 0.0 < *distance);
        match &sides[..] {
            [side, moved @ ..] if is_moved => {
                ranks.insert(*side, rank(edge));
                origin(*side, edge, SideKind::Front);
                ranks.extend(moved.iter().map(|side| (*side, NONE)));
                moved.iter().for_each(|side| origin(*side, edge, SideKind::Back));
                all.extend_from_slice(sides);
            }
            _ => {
                let rank = if edge < distances.len() { rank(edge) } else { NONE };
                for side in apart(sides, swept) {
                    ranks.insert(side, rank);
                    origin(side, edge, SideKind::End);
                    all.push(side);
                }
            }
        }
    }
    // Nearly parallel lines may have the same side, or opposite ones. Each side counts, so that all loops close.
    all.retain(|[from, to]| from != to);
    all.small_sort();
    let (mut contour, mut closes) = (Contour::default(), true);
    contour.follow(&all, &swept.points, |_| closes = false);
    if !closes {
        return Err(SkeletonError::Tangled);
    }
    let mut loops = Vec::new();
    let mut from = 0;
    for &end in &contour.ends {
        let ring = &contour.corners[from..end];
        let rank = |k: usize| ranks.get(&[ring[k], ring[(k + 1) % ring.len()]]).copied().unwrap_or(NONE);
        loops.push(super::from_first((0..ring.len()).map(|k| (rank(k), ring[k])).collect()));
        from = end;
    }
    Ok(loops)
}

/// Gives neighbours on a line that are at one place, except for rounding, that place and one number. So parts that meet in a corner are
/// apart there: by their last bits they could overlap, and be one part.
fn weld(lines: &mut [Vec<[u32; 2]>], swept: &mut Swept) {
    let extent = swept.points.iter().fold(0.0, |extent: f64, point| extent.max(point.abs().max_element()));
    let near = MEETING_EPSILONS[0] * extent;
    let mut same = DisjointSets::new(swept.points.len());
    let mut points: Vec<u32> = Vec::new();
    for sides in lines.iter().filter(|sides| 1 < sides.len()) {
        points.clear();
        points.extend(sides.iter().flatten());
        sort_along(&mut points, sides[0], swept);
        for pair in points.windows(2) {
            let [a, b] = [pair[0], pair[1]].each(|point| swept.points[point as usize]);
            if a.distance(b) <= near {
                same.unite(pair[0], pair[1]);
            }
        }
    }
    same.flatten();
    (0..swept.points.len()).for_each(|point| swept.points[point] = swept.points[same.find(point as u32) as usize]);
    lines.iter_mut().flatten().for_each(|side| *side = side.each(|point| same.find(point)));
}

/// Sorts the points of a line in the direction of a side, each once.
fn sort_along(points: &mut Vec<u32>, [from, to]: [u32; 2], swept: &Swept) {
    let at = |point: u32| swept.points[point as usize];
    let along = at(to) - at(from);
    points.small_sort();
    points.dedup();
    points.small_sort_by(|&a, &b| along.dot(at(a)).total_cmp(&along.dot(at(b))));
}

/// The sides of one line, without the parts where two sides of opposite directions cover each other. Parts that several sides
/// cover are returned once for each.
fn apart(sides: &[[u32; 2]], swept: &Swept) -> Vec<[u32; 2]> {
    let Some(&first) = sides.first() else { return Vec::new() };
    let mut points: Vec<u32> = sides.iter().flatten().copied().collect();
    sort_along(&mut points, first, swept);
    let place = |point: u32| points.iter().position(|&other| other == point).unwrap_or(0);
    // For each gap between neighbours the sides ahead less the sides back.
    let mut cover = vec![0i32; points.len()];
    for &[from, to] in sides {
        let (from, to) = (place(from), place(to));
        cover[from.min(to)..from.max(to)].iter_mut().for_each(|count| *count += if from < to { 1 } else { -1 });
    }
    let gaps = points.windows(2).zip(cover);
    let side = |gap: &[u32], count: i32| if 0 < count { [gap[0], gap[1]] } else { [gap[1], gap[0]] };
    gaps.flat_map(|(gap, count)| std::iter::repeat_n(side(gap, count), count.unsigned_abs() as usize)).collect()
}
