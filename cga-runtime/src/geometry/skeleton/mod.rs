//! What the edges of a polygon sweep when they move inwards, each at the same speed: the faces of its straight skeleton up
//! to a distance, and what is left inside.
//!
//! Edges have the region on their left; loops are outlines, holes, or, for the outside, both turned over. They move as a
//! *wavefront*: loops of *vertices*, which move along bisectors, and of the edges between them, each on the *line* of an edge
//! of the polygon ([`wavefront`]). Nothing changes but at *events* ([`event`]): an edge has shrunk to nothing, or a reflex
//! vertex reaches an edge. Then everything that is in contact is found by position ([`contact`]): vertices that coincide are
//! one *cluster*, clusters divide the edges that they touch into segments ([`arrangement`]), segments that lie on each other
//! cancel ([`overlap`]), and those that are left are joined anew by angle ([`rejoin`]). So events at the same time and place
//! (squares, stars, corridors with parallel walls) are no special case.
//!
//! Paths of vertices are kept as directed arcs between shared nodes, each for the edges on both its sides ([`trace`]). So the
//! areas of all strips and of what is left add up to that of the polygon, whatever rounding does to single points. That
//! strips do not overlap either is checked afterwards ([`check`]); where a wavefront went wrong, because edges run nearly but
//! not quite into each other, it is tried again with another idea of what touches.
//!
//! Time is quadratic in the number of corners, whether few things happen at a time or all at once: an event looks through
//! the wavefront a few times, and a vertex is compared with all of it when it is made and when it ends. Polygons of 1,000
//! corners take 3 to 40 ms, those of 5,000 corners 50 ms to 1.2 s; up to eight times that where other ideas of what touches
//! have to be tried.

mod arrangement;
mod check;
mod contact;
mod disjoint;
mod event;
mod limits;
mod overlap;
mod rejoin;
mod step;
mod trace;
mod wavefront;

use glam::DVec2;

use crate::geometry::tol::MEETING_EPSILONS;
use wavefront::Wavefront;

/// Loops with more corners than this, together, are refused: time is quadratic.
pub(crate) const MOST_CORNERS: usize = 5_000;

/// What one edge swept.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Strip {
    /// Number of the edge: that of the corner it starts at.
    pub(crate) edge: u32,
    /// Corners, counter-clockwise, as numbers of points. It begins with the edge itself, if that is part of it.
    pub(crate) ring: Vec<u32>,
    /// For each side of the ring whether it is an edge of the wavefront at the end.
    pub(crate) front: Vec<bool>,
}

/// A corner of what is left, and the edge that the side after it is parallel to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Left {
    pub(crate) point: u32,
    pub(crate) edge: u32,
}

/// Strips and what is left.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Swept {
    /// The corners of the polygon, then what was made.
    pub(crate) points: Vec<DVec2>,
    /// In the order of edges.
    pub(crate) strips: Vec<Strip>,
    /// Loops with the region on their left.
    pub(crate) left: Vec<Vec<Left>>,
}

/// Why there is no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    /// More than [`MOST_CORNERS`].
    TooMany,
    /// Edges that turn back on themselves, cross each other, or leave what numbers hold.
    Tangled,
}

/// Moves the edges of a polygon by a distance to their left. Loops are numbers of points; edges are numbered along the
/// loops. Equal numbers are the same corner.
pub(crate) fn sweep(points: &[DVec2], rings: &[Vec<u32>], distance: f64) -> Result<Swept, Failure> {
    if MOST_CORNERS < rings.iter().map(Vec::len).sum() {
        return Err(Failure::TooMany);
    }
    let mut failure = Failure::Tangled;
    for epsilon in MEETING_EPSILONS {
        match Wavefront::new(points, rings, epsilon, distance).and_then(Wavefront::run) {
            Ok(swept) => return Ok(swept),
            Err(found) => failure = found,
        }
    }
    Err(failure)
}

#[cfg(test)]
mod tests;
