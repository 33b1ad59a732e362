//! The areas that the edges of a polygon sweep when they move inwards: the faces of the straight skeleton up to a
//! distance, and the remaining interior. Edges move equally far, or each by a distance of its own (`speeds`).
//!
//! Edges have the region on their left. Loops are outlines and holes; for the region outside, both are reversed. The
//! edges move as a *wavefront*: loops of *vertices*, which move along bisectors, and of edges between them, each on the
//! *line* of an edge of the polygon (`wavefront`). The structure changes only at *events* (`event`): an edge
//! shrinks to a point, or a reflex vertex reaches an edge. Then all contacts are found by position (`contact`).
//! Vertices that coincide form a *cluster*. Clusters divide the edges that they touch into segments (`arrangement`).
//! Coincident opposite segments touch (`overlap`) and cancel. The remaining ones are joined again by angle
//! (`rejoin`). So simultaneous events at one place (squares, stars, corridors with parallel walls) need no special
//! case. Most events have nothing else near, and take a short way to the same result (`lone`).
//!
//! Paths of vertices are stored as directed arcs between shared nodes, each for the edges on both its sides
//! (`rims`). So the areas of all strips and of the remaining interior add up to the area of the polygon, whatever the
//! rounding errors of single points. A final check ensures that strips do not overlap (`check`). If it fails, because
//! edges are nearly but not exactly coincident, the sweep is repeated with another distance for contacts.
//!
//! The sweep can run until nothing is left. Then the strips are the faces of the whole
//! straight skeleton, and the times of points are their heights on a roof.
//!
//! The time is quadratic in the number of corners, for few or many simultaneous events: an event scans the wavefront a
//! few times, and a reflex vertex is compared with the whole wavefront when it is made. Polygons with 1,000
//! corners take 3 to 40 ms, those with 5,000 corners 50 ms to 1.2 s, and up to eight times as long if other distances
//! for contacts have to be tried.

mod arrangement;
mod blunt;
mod check;
mod contact;
mod event;
mod eventless;
mod limits;
mod lone;
mod meeting;
mod overlap;
mod overtake;
mod rejoin;
mod rims;
mod speeds;
mod step;
mod wavefront;

use glam::DVec2;

use crate::tol::{MEETING_EPSILONS, PLANAR_EPSILON};
pub use blunt::BLUNT;
pub(crate) use check::any_cross;
pub use speeds::Speeds;
use wavefront::Wavefront;

/// The number for "no vertex" and "no point".
const NONE: u32 = u32::MAX;

/// The limit on the total number of corners, because the time is quadratic.
pub const MOST_CORNERS: usize = 5_000;

/// The area that one edge swept.
#[derive(Clone, Debug, PartialEq)]
pub struct Strip {
    /// The number of the edge, which is the number of its first corner.
    pub edge: u32,
    /// The corners, counter-clockwise, as numbers of points. The ring begins with the edge itself, if the edge is part
    /// of it.
    pub ring: Vec<u32>,
    /// For each side of the ring whether it is an edge of the final wavefront.
    pub front: Vec<bool>,
}

/// A corner of the remaining interior, and the edge that is parallel to the next side. Sides that divide a corner
/// between edges of different speeds have numbers after the numbers of the edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrontCorner {
    /// The number of its point.
    pub point: u32,
    /// The number of the edge.
    pub edge: u32,
}

/// The strips and the remaining interior.
#[derive(Clone, Debug, PartialEq)]
pub struct Swept {
    /// The corners of the polygon, followed by new points.
    pub points: Vec<DVec2>,
    /// The time when the wavefront reached each point: 0 for the corners of the polygon.
    pub times: Vec<f64>,
    /// The strips, in the order of edges.
    pub strips: Vec<Strip>,
    /// The loops of the remaining interior, with the region on their left.
    pub left: Vec<Vec<FrontCorner>>,
    /// The largest distance of a point, when the wavefront reaches it, from the line of an edge whose strip has the
    /// point, relative to the extent.
    pub deviation: f64,
}

/// The reason why a sweep fails, or an operation that needs one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SkeletonError {
    /// The polygon has more than [`MOST_CORNERS`] corners.
    TooMany,
    /// Edges reverse their direction, cross each other, or overflow.
    Tangled,
}

/// Moves the edges of a polygon to their left by a distance. Loops are numbers of points, and edges are numbered along
/// the loops. Equal numbers are the same corner. Takes time quadratic in the number of corners.
///
/// ```
/// use cga_geometry::glam::DVec2;
/// use cga_geometry::skeleton::sweep;
///
/// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
/// let swept = sweep(&square, &[vec![0, 1, 2, 3]], 1.0)?;
/// assert_eq!((swept.strips.len(), swept.left.len()), (4, 1));
/// let left: Vec<DVec2> = swept.left[0].iter().map(|corner| swept.points[corner.point as usize]).collect();
/// assert!(left.contains(&DVec2::new(1.0, 1.0)) && left.contains(&DVec2::new(3.0, 3.0)));
/// # Ok::<(), cga_geometry::skeleton::SkeletonError>(())
/// ```
///
/// # Errors
/// [`SkeletonError::Tangled`] also for coordinates that are not finite, and for a distance that is negative or NaN.
///
/// # Panics
/// Panics if a loop has the number of a point that does not exist, or if there are fewer distances or speeds than edges.
pub fn sweep(points: &[DVec2], rings: &[Vec<u32>], distance: f64) -> Result<Swept, SkeletonError> {
    sweep_at(points, rings, Speeds::Equal, distance)
}

/// Moves each edge of a polygon to its left by a distance of its own, which is not negative. All edges arrive at the
/// same time. See [`sweep`] for errors and panics; there is one distance for each edge.
pub fn sweep_each(points: &[DVec2], rings: &[Vec<u32>], distances: &[f64]) -> Result<Swept, SkeletonError> {
    let most = distances.iter().fold(0.0, |most: f64, &distance| most.max(distance));
    let speed = |distance: &f64| if most == 0.0 { 1.0 } else { distance / most };
    let speeds: Vec<f64> = distances.iter().map(speed).collect();
    sweep_at(points, rings, Speeds::Places(&speeds), most)
}

/// Moves edges until a time; an infinite time gives the whole straight skeleton. If heights count, several distances for
/// contacts are tried until all points are in the planes that meet in them, and the best result is taken.
///
/// Neighbours in one line with different speeds do not determine the path of the vertex between them. The kind of
/// [`Speeds`] decides about them. See [`sweep`] for errors and panics.
pub fn sweep_at(points: &[DVec2], rings: &[Vec<u32>], speeds: Speeds<'_>, until: f64) -> Result<Swept, SkeletonError> {
    if MOST_CORNERS < rings.iter().map(Vec::len).sum() {
        return Err(SkeletonError::TooMany);
    }
    if until.is_nan() || until < 0.0 {
        return Err(SkeletonError::Tangled);
    }
    if let Some(swept) = eventless::sweep_without_events(points, rings, speeds, until) {
        return Ok(swept);
    }
    sweep_with_events(points, rings, speeds, until)
}

fn sweep_with_events(
    points: &[DVec2],
    rings: &[Vec<u32>],
    speeds: Speeds<'_>,
    until: f64,
) -> Result<Swept, SkeletonError> {
    let mut failure = SkeletonError::Tangled;
    let mut best: Option<((bool, f64), Swept)> = None;
    for epsilon in MEETING_EPSILONS {
        match Wavefront::new(points, rings, speeds, epsilon, until).and_then(Wavefront::run) {
            Ok(swept) if !speeds.has_heights() => return Ok(swept),
            Ok(swept) => {
                let flaws = (has_divided_strips(&swept), swept.deviation);
                if !flaws.0 && flaws.1 <= PLANAR_EPSILON {
                    return Ok(swept);
                }
                if best.as_ref().is_none_or(|best| flaws < best.0) {
                    best = Some((flaws, swept));
                }
            }
            Err(found) => failure = found,
        }
    }
    best.map(|best| best.1).ok_or(failure)
}

/// Returns true if an edge has several strips. All but one of them are rounding errors.
fn has_divided_strips(swept: &Swept) -> bool {
    swept.strips.windows(2).any(|pair| pair[0].edge == pair[1].edge)
}

#[cfg(test)]
pub mod tests;
