//! The tolerances of the geometry, each with the quantity that it is relative to.
//!
//! An *epsilon* covers rounding, relative to the extent of the data. Three questions never depend on these values and
//! are exact: the side of a plane that a point is on, the equality of points, and the closing of loops.

/// The largest distance of a corner from the plane of its face, relative to the extent of the mesh.
pub const PLANAR_EPSILON: f64 = 1e-9;

/// The largest deviation from 1 of the cosine between parallel unit vectors, and from 0 of that between perpendicular
/// ones.
pub const ANGLE_EPSILON: f64 = 1e-12;

/// The largest difference between unit normals of coplanar faces.
pub const COPLANAR_EPSILON: f64 = 1e-9;

/// The step of the grid, relative to about the extent of a face, to which positions are rounded before a triangulation that must not
/// depend on rounding errors. A power of two.
pub(crate) const GRID_EPSILON: f64 = 1.0 / (1u64 << 32) as f64;

/// Loops of a polygon that cross by less than this, relative to its extent, count as touching, and the ends of a ridge of this
/// length as one corner.
pub(crate) const TOUCH_EPSILON: f64 = 1e-7;

/// The largest distance that a loop extends beyond the loop around it, relative to the largest coordinate, because
/// crossings are rounded.
pub(crate) const AROUND_EPSILON: f64 = 1e-12;

/// A point that is as near as this to a plane of a division, relative to the largest coordinate in the world or in the mesh, is moved onto
/// it: the rounding of a few steps.
pub const SNAP_EPSILON: f64 = 16.0 * f64::EPSILON;

/// Edges count as straight if the sine of the angle between their directions is below this.
pub const STRAIGHT_EPSILON: f64 = 1e-7;

/// Areas that differ by less than this, relative to the total area of the geometry, count as equal.
pub const AREA_EPSILON: f64 = 1e-12;

/// A face is across an axis if the sine of the angle between its normal and the axis is below this.
pub const ACROSS_EPSILON: f64 = 1e-6;

/// If rounding moves the line of a face in a plane by more than this, relative to the face's extent, the order of
/// points on the line is not reliable.
pub(crate) const LINE_EPSILON: f64 = 1e-7;

/// An edge whose extent along an axis is below this, relative to the extent of the shape, counts as across the axis:
/// the rounding errors of its ends are of that size.
pub const EDGE_EPSILON: f64 = 1e-15;

/// An upper bound of the rounding error of rotated coordinates, relative to the largest of them.
pub const ROUNDING_EPSILON: f64 = 2e-15;

/// A face whose area is below this, relative to its extent and its largest coordinate, has no plane: the rounding errors of some
/// operations one after the other decide about its normal.
pub(crate) const THIN_EPSILON: f64 = 1e-13;

/// A volume below this, relative to the cube of the largest extent, is a rounding error.
pub(crate) const VOLUME_EPSILON: f64 = 1e-14;

/// A face counts as vertical if its unit normal rises by less than this. An edge counts as horizontal if its direction
/// rises by no more.
pub const UP_EPSILON: f64 = 1e-9;

/// Lengths and heights that differ by less than this, relative to the extent of the shape, count as equal in a search for
/// the largest or the lowest one. The first one is chosen.
pub const TIE_EPSILON: f64 = 1e-9;

/// The distance, relative to the polygon's extent, below which moving edges count as touching. If one value leads to a
/// tangle, the next one is tried.
pub(crate) const MEETING_EPSILONS: [f64; 8] = [1e-10, 1e-9, 1e-8, 1e-7, 1e-11, 3e-10, 3e-9, 1e-6];

/// The distances, relative to the polygon's extent, by which corners are moved if no distance for contacts gives a
/// straight skeleton.
pub(crate) const NUDGE_EPSILONS: [f64; 3] = [1e-9, 1e-8, 1e-7];

/// The weight of the old position of a point that is moved into the planes that meet in it. Planes that are nearly
/// parallel do not determine a point along them.
pub(crate) const SETTLE_DAMPING: f64 = 1e-6;

/// A texture coordinate is affine over a face if its corners deviate by at most this, relative to the range of the
/// coordinate on the face.
pub(crate) const AFFINE_EPSILON: f64 = 1e-9;

/// Texture coordinates that vary by at most this on a triangle, relative to their range, count as constant there. A triangle
/// whose area in texture space is at most this part of the square of its longest edge has none.
pub(crate) const CHART_EPSILON: f64 = 1e-9;

/// Points of texture space closer than this, relative to the largest coordinate and to 1, count as adjacent.
pub const NEXT_EPSILON: f64 = 1e-12;

/// Texture coordinates this near to a whole number, where a copy of an asset ends, are on it.
pub(crate) const WHOLE_EPSILON: f64 = 1e-9;

/// A coordinate that grows by less than this along a direction, relative to its size, counts as constant. Axes are unit
/// vectors only up to rounding.
pub(crate) const CONSTANT_EPSILON: f64 = 1e-14;

/// The distance, relative to the extent of both operands, below which points of a boolean operation are one, and edges go
/// through points. If one value leads to a tangle, the next one is tried.
pub(crate) const BOOLEAN_EPSILONS: [f64; 4] = [1e-9, 1e-8, 1e-10, 1e-7];

/// A closed mesh that is thinner than this, relative to the extent of both operands of a boolean operation, is a flat area.
pub(crate) const THINNEST_SOLID: f64 = 1e-14;

/// Points closer than this, relative to the extent of the mesh, are merged by a cleanup without a tolerance.
pub(crate) const MERGE_EPSILON: f64 = 1e-9;

/// The largest distance from a line or a plane, relative to the extent of the mesh, of points that are on it for a cleanup
/// without a tolerance. Files have numbers of 32 bits.
pub(crate) const FLAT_EPSILON: f64 = 1e-6;

/// The angle below which directions are equal for a cleanup without a tolerance, for the same reason.
pub(crate) const FLAT_ANGLE_EPSILON: f64 = 1e-4;

/// Lengths and angles within this share of the tolerance of a cleanup are equal to it.
pub(crate) const AT_LIMIT_EPSILON: f64 = 1e-9;

/// Texture coordinates that differ by at most this, relative to their size and to 1, are equal for `cleanupGeometry` and `reduceGeometry`.
pub(crate) const TEXTURE_EPSILON: f64 = 1e-6;

/// The distance in metres up to which surfaces are in contact, for relations of geometries that are at least a metre long. It is above
/// the rounding errors of coordinates with 32 bits, and below the thickness of anything that is built.
pub const CONTACT_DISTANCE: f64 = 1e-3;

/// The same for smaller geometries, relative to the longest extent of the smaller one of two.
pub const CONTACT_EPSILON: f64 = 1e-3;
