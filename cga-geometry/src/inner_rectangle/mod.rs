//! The largest rectangle with given directions in a polygon with holes.
//!
//! A rectangle from `l` to `r` is as high as the largest *gap* of the strip between them: the edges of the polygon in the strip
//! cover parts of the y axis, and gaps are what is left inside. Lines through all corners divide the plane into *slabs*. For a
//! left side in one slab and a right side in another, the sides of the largest rectangle solve a small problem with linear
//! limits, in closed form (`corner`). The pairs of slabs are searched best first, by the widest rectangle and the largest gap
//! that a set of pairs allows (`search`). So the result is exact, except for rounding.

mod corner;
pub mod face;
mod search;
mod slabs;

use glam::{DMat2, DVec2};

use crate::each::Each;
use crate::nesting::extent::Extent;
use crate::small_sort::SmallSort;
use crate::tol::{STRAIGHT_EPSILON, TIE_EPSILON};
use slabs::PolygonSlabs;

/// A rectangle along two directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InnerRectangle {
    /// The direction of its first side, of length 1.
    pub(crate) along: DVec2,
    /// The corners anticlockwise; the first side runs along `along`.
    pub(crate) corners: [DVec2; 4],
}

/// The directions that a rectangle may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RectangleSides {
    /// Along the axes.
    Axes,
    /// One side is parallel to an edge. For each loop the edges count that are longer than a quarter of its longest one.
    Edges,
}

/// The limit on visits of edges: half a second at most. It is reached by polygons with hundreds of directions, or with thousands
/// of corners.
const MOST_VISITS: usize = 8_000_000;

/// The visits of edges that slabs count for.
const SETUP: usize = 8;

/// A rectangle while it is searched for.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Found {
    low: DVec2,
    high: DVec2,
    area: f64,
}

impl Found {
    fn middle(&self) -> DVec2 {
        (self.low + self.high) * 0.5
    }
}

/// The largest rectangle in a polygon: loops of numbers of points, the outline anticlockwise and holes clockwise. Among
/// rectangles that are equally large it is the one nearest to the centre of gravity. `None` if the polygon has no area.
///
/// The search ends after a fixed amount of work. Then it is the largest rectangle so far; directions of longer edges come
/// first.
pub(crate) fn largest(points: &[DVec2], rings: &[Vec<u32>], sides: RectangleSides) -> Option<InnerRectangle> {
    let Extent { low, high } = Extent::of(points.iter().copied());
    let (middle, extent) = (low * 0.5 + high * 0.5, (high - low).max_element());
    if !(1e-100..1e100).contains(&extent) {
        return None;
    }
    // Areas of about 1.
    let flat: Vec<DVec2> = points.iter().map(|p| (*p - middle) / extent).collect();
    let centre = centre_of_gravity(&flat, rings);
    let directions = match sides {
        RectangleSides::Axes => vec![DVec2::X],
        RectangleSides::Edges => directions(&flat, rings),
    };
    let mut budget = MOST_VISITS;
    let mut best: Option<(Found, DVec2)> = None;
    for along in directions {
        let turn = DMat2::from_cols(along, along.perp());
        let back = turn.transpose();
        let turned: Vec<DVec2> = flat.iter().map(|p| back * *p).collect();
        let slabs = PolygonSlabs::of(&turned, rings);
        search::spend(&mut budget, SETUP * slabs.edge_count());
        if budget == 0 && best.is_some() {
            break;
        }
        let least = best.map_or(0.0, |best| best.0.area);
        let Some(found) = search::search(&slabs, back * centre, least, &mut budget) else { continue };
        let off = |found: &Found, turn: &DMat2| (*turn * found.middle()).distance(centre);
        let is_better = best.is_none_or(|(known, known_along)| {
            let known_turn = DMat2::from_cols(known_along, known_along.perp());
            let is_tied = (found.area - known.area).abs() <= TIE_EPSILON * known.area;
            if is_tied { off(&found, &turn) < off(&known, &known_turn) - TIE_EPSILON } else { known.area < found.area }
        });
        if is_better {
            best = Some((found, along));
        }
    }
    let (Found { low, high, .. }, along) = best?;
    let turn = DMat2::from_cols(along, along.perp());
    let corners = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
    Some(InnerRectangle { along, corners: corners.each(|corner| middle + turn * corner * extent) })
}

/// The centre of gravity.
fn centre_of_gravity(flat: &[DVec2], rings: &[Vec<u32>]) -> DVec2 {
    let (mut area, mut moment) = (0.0, DVec2::ZERO);
    for ring in rings {
        for (k, &a) in ring.iter().enumerate() {
            let [a, b] = [a, ring[(k + 1) % ring.len()]].each(|point| flat[point as usize]);
            let twice = a.perp_dot(b);
            area += twice;
            moment += (a + b) * twice;
        }
    }
    if area == 0.0 { DVec2::ZERO } else { moment / (3.0 * area) }
}

/// The directions of the edges that are longer than a quarter of the longest one of their loop, from the longest one on.
/// Directions that are parallel or across count once.
fn directions(flat: &[DVec2], rings: &[Vec<u32>]) -> Vec<DVec2> {
    let mut edges: Vec<DVec2> = Vec::new();
    for ring in rings {
        let edge = |k: usize| flat[ring[(k + 1) % ring.len()] as usize] - flat[ring[k] as usize];
        let longest = (0..ring.len()).map(|k| edge(k).length()).fold(0.0, f64::max);
        edges.extend((0..ring.len()).map(edge).filter(|edge| 0.25 * longest < edge.length()));
    }
    edges.small_sort_by(|a, b| b.length().total_cmp(&a.length()));
    let mut kept: Vec<DVec2> = Vec::new();
    for edge in edges {
        let along = edge.normalize_or(DVec2::X);
        let is_known = |other: &DVec2| along.dot(*other).abs().min(along.perp_dot(*other).abs()) <= STRAIGHT_EPSILON;
        if !kept.iter().any(is_known) {
            kept.push(along);
        }
    }
    kept
}

#[cfg(test)]
mod tests;
