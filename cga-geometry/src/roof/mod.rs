//! Roofs over a polygon with holes: pure geometry in the coordinates of a face that is laid flat.
//!
//! Hip and gable roofs are the straight skeleton of the outline with heights: the wavefront reaches a point at a time, and
//! the roof is as high there as its planes rise in that distance (`plan`). An edge with a gable does not move, so its
//! strip is the upright pediment (`gable`). An overhang is the wavefront of the region outside. Pyramid, shed and ridge
//! roofs are planes over the outline (`planes`).
//!
//! A roof without overhang and its bottom are a closed volume, because the arcs of the wavefront are shared.

mod arcs;
mod gable;
mod gable_edges;
mod hip;
mod mesh;
mod plan;
mod planes;
mod rectangle;
mod settle;
mod take_back;

use glam::{DVec2, DVec3};

use crate::mesh::unit;
use crate::skeleton::SkeletonError;
use crate::tol::TOUCH_EPSILON;

pub use mesh::{RoofRefusal, Roofs, roof_over};

/// The largest distance of an overhang, relative to the extent of the outline.
const FARTHEST: f64 = 1e6;

/// The rise of roof planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rise {
    /// The tangent of the angle between the planes and the face.
    Slope(f64),
    /// The height of the highest point of the roof, without overhangs, in metres.
    Height(f64),
}

impl Rise {
    /// Returns true if the number is neither NaN nor infinite.
    fn is_finite(self) -> bool {
        let (Rise::Slope(number) | Rise::Height(number)) = self;
        number.is_finite()
    }

    /// The tangent of the angle for a roof whose highest point is at a distance from its eaves.
    fn slope(self, distance: f64) -> f64 {
        match self {
            Rise::Slope(slope) => slope,
            Rise::Height(height) => height / distance,
        }
    }
}

/// The kind of a roof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RoofForm {
    /// A plane rises at each edge.
    Hip {
        /// The length of the overhang on the planes, in metres; a negative one takes the planes back from the eaves.
        overhang: f64,
        /// True to make ridges level.
        even: bool,
    },
    /// A hip roof with upright pediments at its ends.
    Gable {
        /// The length of the overhang at the eaves on the planes, in metres; negative as in a hip roof.
        across: f64,
        /// The overhang beyond the pediments, in metres; a negative one takes the planes back from them.
        along: f64,
        /// True to make ridges level.
        even: bool,
        /// The edge that the ridge is parallel to. Negative numbers count from the end; numbers out of range wrap around.
        edge: Option<i64>,
    },
    /// Triangles to an apex over the mean of the corners.
    Pyramid,
    /// One plane that rises from an edge.
    Shed {
        /// The number of the edge. Negative numbers count from the end; numbers out of range wrap around.
        edge: i64,
    },
    /// Two planes whose ridge is parallel to the x axis, projected into the face.
    Ridge,
}

impl RoofForm {
    /// Returns true if no overhang is NaN.
    fn has_numbers(self) -> bool {
        match self {
            RoofForm::Hip { overhang, .. } => !overhang.is_nan(),
            RoofForm::Gable { across, along, .. } => !across.is_nan() && !along.is_nan(),
            _ => true,
        }
    }

    /// The same roof without overhangs; `None` if it has none.
    fn without_overhangs(self) -> Option<Self> {
        match self {
            RoofForm::Hip { overhang, even } if overhang != 0.0 => Some(RoofForm::Hip { overhang: 0.0, even }),
            RoofForm::Gable { across, along, even, edge } if across != 0.0 || along != 0.0 => {
                Some(RoofForm::Gable { across: 0.0, along: 0.0, even, edge })
            }
            _ => None,
        }
    }
}

/// A part of a roof, for its tag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RoofPart {
    Bottom,
    Top,
    Side,
    Outer,
    Inner,
}

impl RoofPart {
    /// The tag of the part.
    fn tag(self) -> &'static str {
        match self {
            RoofPart::Bottom => "roof.bottom",
            RoofPart::Top => "roof.top",
            RoofPart::Side => "roof.side",
            RoofPart::Outer => "roof.side.outer",
            RoofPart::Inner => "roof.side.inner",
        }
    }
}

/// A polygon with holes. Edges are numbered along its rings.
struct Outline<'a> {
    points: &'a [DVec2],
    /// The outline anticlockwise, then the holes clockwise, as numbers of points.
    rings: &'a [Vec<u32>],
    /// The direction of the shape's x axis.
    x: DVec2,
}

impl Outline<'_> {
    /// The ends of all edges, as numbers of points.
    fn edges(&self) -> Vec<[u32; 2]> {
        let ends = |ring: &Vec<u32>| -> Vec<[u32; 2]> {
            (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]).collect()
        };
        self.rings.iter().flat_map(ends).collect()
    }

    /// The edge with a number, which may be out of range.
    fn edge(&self, number: i64) -> usize {
        let count: usize = self.rings.iter().map(Vec::len).sum();
        number.rem_euclid(count.max(1) as i64) as usize
    }

    fn at(&self, point: u32) -> DVec2 {
        self.points[point as usize]
    }

    /// The direction of an edge.
    fn along(&self, [a, b]: [u32; 2]) -> DVec2 {
        (self.at(b) - self.at(a)).normalize_or(DVec2::X)
    }
}

/// A face of a roof.
#[derive(Clone, Debug)]
struct RoofFace {
    part: RoofPart,
    /// The edge of the polygon out of which it grows.
    edge: Option<u32>,
    /// The outline anticlockwise as seen from outside, then the holes, as numbers of points.
    rings: Vec<Vec<u32>>,
}

/// A roof over one polygon, without its bottom.
#[derive(Clone, Debug, Default)]
struct Roof {
    /// The corners of the polygon, then new points. The third coordinate is the height over the polygon.
    points: Vec<DVec3>,
    faces: Vec<RoofFace>,
    /// True for points that `even` has moved. Faces with such points are bent.
    moved: Vec<bool>,
    /// True if the roof is below the polygon, which then looks outwards. The rings of its faces are clockwise.
    below: bool,
}

impl Roof {
    /// A roof without faces.
    fn over(outline: &Outline<'_>) -> Self {
        Roof { points: outline.points.iter().map(|p| p.extend(0.0)).collect(), ..Roof::default() }
    }

    fn point(&mut self, at: DVec3) -> u32 {
        self.points.push(at);
        self.points.len() as u32 - 1
    }

    fn face(&mut self, part: RoofPart, edge: u32, ring: Vec<u32>) {
        self.faces.push(RoofFace { part, edge: Some(edge), rings: vec![ring] });
    }

    /// Returns true if overhangs are not too far away, every face that `even` does not bend is flat, and no roof plane is
    /// turned over as seen from above, except for rounding.
    fn is_sound(&self, outline: &Outline<'_>) -> bool {
        let size = |points: &[DVec2]| points.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element()));
        let flat: Vec<DVec2> = self.points.iter().map(|point| point.truncate()).collect();
        if FARTHEST * size(outline.points) < size(&flat) {
            return false;
        }
        self.faces.iter().all(|face| {
            face.rings.iter().all(|ring| {
                let at = |point: u32| self.points[point as usize] - self.points[ring[0] as usize];
                let size = ring.iter().fold(0.0, |most: f64, &point| most.max(at(point).abs().max_element()));
                let normal = (1..ring.len()).fold(DVec3::ZERO, |sum, i| sum + at(ring[i - 1]).cross(at(ring[i])));
                let above = unit(normal);
                let is_bent = ring.iter().any(|&point| self.moved.get(point as usize) == Some(&true));
                let is_top = face.part == RoofPart::Top;
                (!is_top || -TOUCH_EPSILON * size * size <= normal.z)
                    && (is_top && is_bent
                        || ring.iter().all(|&point| above.dot(at(point)).abs() <= TOUCH_EPSILON * size))
            })
        })
    }
}

/// Makes a roof over a polygon, and returns true if it has the overhangs of its form. Overhangs are left out if they lead too
/// far, as at edges that are nearly opposite, or if they would turn faces over or bend them.
fn roof_with_or_without_overhangs(
    outline: &Outline<'_>,
    form: RoofForm,
    rise: Rise,
) -> Result<(Roof, bool), SkeletonError> {
    let without = form.without_overhangs();
    match (roof(outline, form, rise), without) {
        (Ok(made), None) => Ok((made, true)),
        (Ok(made), Some(_)) if made.is_sound(outline) => Ok((made, true)),
        (Ok(_) | Err(SkeletonError::Tangled), Some(without)) => Ok((roof(outline, without, rise)?, false)),
        (Err(failure), _) => Err(failure),
    }
}

/// Makes a roof over a polygon in the general way.
fn roof(outline: &Outline<'_>, form: RoofForm, rise: Rise) -> Result<Roof, SkeletonError> {
    match form {
        RoofForm::Hip { overhang, even } => hip::hip(outline, rise, overhang, even),
        RoofForm::Gable { across, along, even, edge } => {
            let ends = match edge {
                Some(edge) => gable_edges::ends_along(outline, outline.edge(edge)),
                None => gable_edges::ends(outline),
            };
            gable::gable(outline, &ends, rise, [across, along], even && edge.is_none())
        }
        RoofForm::Pyramid => Ok(planes::pyramid(outline, rise)),
        RoofForm::Shed { edge } => Ok(planes::shed(outline, outline.edge(edge), rise)),
        RoofForm::Ridge => Ok(planes::ridge(outline, outline.x, rise)),
    }
}

#[cfg(test)]
mod tests;
