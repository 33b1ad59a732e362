//! Every tolerance of the geometry, with what it is relative to.
//!
//! *Epsilon* is rounding: relative to the extent of what is looked at. Which side of a plane a point is on, which
//! points are the same and which loops close is never decided by one of these: that is exact.

/// How far a corner may lie from the plane of its face, relative to the extent of the mesh.
pub(crate) const PLANAR_EPSILON: f64 = 1e-9;

/// How far from 1 the cosine between parallel unit vectors may be, and from 0 that between perpendicular ones.
pub(crate) const ANGLE_EPSILON: f64 = 1e-12;

/// Unit normals of coplanar faces may differ by this much.
pub(crate) const COPLANAR_EPSILON: f64 = 1e-9;

/// Loops of a polygon that cross by less than this, relative to its extent, were meant to touch.
pub(crate) const TOUCH_EPSILON: f64 = 1e-7;

/// A loop may reach out of the one around it by this much, relative to the largest coordinate: crossings are rounded.
pub(crate) const AROUND_EPSILON: f64 = 1e-12;

/// Edges whose directions have a sine below this between them go straight on.
pub(crate) const STRAIGHT_EPSILON: f64 = 1e-7;

/// Areas that differ by less than this, relative to all of the geometry's area, are the same.
pub(crate) const AREA_EPSILON: f64 = 1e-12;

/// A face whose normal leaves an axis by a sine below this lies across it.
pub(crate) const ACROSS_EPSILON: f64 = 1e-6;

/// Where rounding moves the line in which a face meets a plane by more than this, relative to the face's extent, the line
/// does not tell what lies where on it.
pub(crate) const LINE_EPSILON: f64 = 1e-7;

/// An edge that extends along an axis by less than this, relative to the extent of the shape, lies across it: the rounding of
/// its ends is as large.
pub(crate) const EDGE_EPSILON: f64 = 1e-15;

/// Coordinates are rounded by less than this when they are turned, relative to the largest of them.
pub(crate) const ROUNDING_EPSILON: f64 = 2e-15;

/// A volume smaller than this, relative to the cube of the largest extent, is rounding.
pub(crate) const VOLUME_EPSILON: f64 = 1e-14;

/// Faces whose unit normal rises by less than this look sideways, and an edge whose direction rises by no more is level.
pub(crate) const UP_EPSILON: f64 = 1e-9;

/// Lengths and heights that differ by less than this, relative to the extent of the shape, are the same where the largest or
/// lowest is looked for, and the first of them is taken.
pub(crate) const TIE_EPSILON: f64 = 1e-9;

/// What is nearer to each other than this touches where edges of a polygon move, relative to its extent. Where one leads
/// to a tangle, the next is tried.
pub(crate) const MEETING_EPSILONS: [f64; 8] = [1e-10, 1e-9, 1e-8, 1e-7, 1e-11, 3e-10, 3e-9, 1e-6];

/// A texture coordinate is affine over a face when its corners are off by no more than this, relative to the range that the
/// coordinate has there.
pub(crate) const AFFINE_EPSILON: f64 = 1e-9;

/// Texture coordinates that change by no more than this on a triangle, relative to their range, are constant there.
pub(crate) const CHART_EPSILON: f64 = 1e-9;

/// Places of texture space that are nearer than this, relative to the largest coordinate and to 1, are next to each other.
pub(crate) const NEXT_EPSILON: f64 = 1e-12;

/// The share of a coordinate's growth up to which it counts as constant along a direction: axes are unit vectors but for rounding.
pub(crate) const CONSTANT_EPSILON: f64 = 1e-14;
