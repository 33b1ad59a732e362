//! Moves the outlines of faces in or out and fills the difference with strips.
//!
//! A face is moved in the plane across its normal. The parts of a face that is not planar are not planar either
//! (`relief`): old points stay, and new points get heights between the heights of the face.
//!
//! Each face gives the interior of its moved outline, in the order of the first edges of the parts, and then a strip
//! for each of its edges, outline before holes. The parts of a face share their points with each other, but not with
//! other faces: an edge that only one face uses is a border of the parts of one source face. Strips of an inward offset
//! have the orientation of the face and begin with the moved edge, if there is one. Strips of an outward offset have
//! the opposite orientation and begin with the edge itself. So the areas of all parts add up to the area of the face. An interior
//! part begins with the first edge of the face that has a part in it. Strips have the tags of their edges.

use glam::DVec2;

use crate::derive::{CornerValues, Derivation, FaceOrigin, PointOrigin};
use crate::mesh::{FlatFace, Mesh, flip};
use crate::nesting::polygons::NestedRings;
use crate::skeleton::{self, FrontCorner, SkeletonError, Strip};
use crate::small_sort::{SmallSort, sort_owned_by};
use crate::work;

pub mod each_edge;
pub mod region;
mod relief;
mod sides;
pub mod to_area;

/// The units of work of a corner, besides the units of the wavefront.
const CORNER: usize = 64;

/// The faces that an offset keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OffsetFaces {
    /// The interiors of the moved outlines, and the strips.
    All,
    /// The interiors of the moved outlines.
    Inside,
    /// The strips.
    Border,
}

/// The reason why a face has no offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OffsetError {
    /// The face has no normal: its area is 0 or not finite.
    NoNormal,
    /// The face has too many corners.
    TooMany,
    /// The outlines of the face cross, or a number leads too far.
    Tangled,
}

impl From<SkeletonError> for OffsetError {
    fn from(failure: SkeletonError) -> Self {
        match failure {
            SkeletonError::TooMany => OffsetError::TooMany,
            SkeletonError::Tangled => OffsetError::Tangled,
        }
    }
}

/// Moves the outlines of all faces by `distance` in metres: inwards if it is negative, outwards if it is positive.
///
/// Faces that cannot be moved are copied unchanged, with points of their own. They are also listed, by number, with the reason.
/// An infinite distance inwards leaves nothing of a face. A distance that is NaN leaves the mesh unchanged.
/// The result of work that is to end is empty.
///
/// The time is quadratic in the number of corners of a face.
///
/// ```
/// use cga_geometry::offset::{OffsetFaces, offset};
/// use cga_geometry::primitive;
///
/// // A square with sides of 1, moved inwards by 0.25: a square with sides of 0.5, and four strips.
/// let (inside, refused) = offset(&primitive::quad(), -0.25, OffsetFaces::Inside);
/// assert!((inside.area() - 0.25).abs() < 1e-12 && refused.is_empty());
/// let (border, _) = offset(&primitive::quad(), -0.25, OffsetFaces::Border);
/// assert_eq!(border.face_count(), 4);
/// assert!((border.area() - 0.75).abs() < 1e-12);
/// ```
pub fn offset(mesh: &Mesh, distance: f64, keep: OffsetFaces) -> (Mesh, Vec<(usize, OffsetError)>) {
    if distance.is_nan() {
        return (mesh.clone(), Vec::new());
    }
    let mut made = Derivation::new(mesh, CornerValues::All, 0);
    let mut refused = Vec::new();
    for face in mesh.faces() {
        // A wavefront without events counts no work.
        if !work::spend(CORNER * face.corner_count()) {
            return (Mesh::default(), Vec::new());
        }
        let plane = FlatFace::of(&face).ok_or(OffsetError::NoNormal);
        if let Err(why) = plane.and_then(|plane| offset_face(&plane, distance, keep, &mut made)) {
            made.copy(&face);
            refused.push((face.index(), why));
        }
    }
    // The wavefront numbers points in the order of its events; rules expect vertices in the order of faces.
    (made.finish_by_use(), refused)
}

/// Adds the offset of a face to a mesh.
fn offset_face(
    plane: &FlatFace<'_>,
    distance: f64,
    keep: OffsetFaces,
    made: &mut Derivation<'_>,
) -> Result<(), OffsetError> {
    let outwards = 0.0 < distance;
    let (edges, rings) = plane.edges(outwards);
    let swept = skeleton::sweep(&plane.flat, &rings, distance.abs())?;
    let heights = relief::heights(&plane.heights, &rings, &swept);
    let mut part = FaceParts::new(plane, &swept.points, &heights, made);
    if keep != OffsetFaces::Border {
        let rings = swept.left.iter().map(|ring| ahead(ring, &edges, outwards)).collect();
        part.nested(rings, |_, _, _| {});
    }
    if keep != OffsetFaces::Inside {
        let mut strips: Vec<([usize; 2], &Strip)> =
            swept.strips.iter().map(|strip| (edges[strip.edge as usize], strip)).collect();
        strips.small_sort_by_key(|(edge, _)| edge[0]);
        strips.iter().for_each(|(edge, strip)| part.strip(*edge, strip, outwards));
    }
    Ok(())
}

/// A loop of the remaining interior in the direction of the face, beginning with the first edge. For each corner it
/// has the face's edge that the next side belongs to, and the point.
fn ahead(ring: &[FrontCorner], edges: &[[usize; 2]], outwards: bool) -> Vec<(usize, u32)> {
    let count = ring.len();
    let side = |k: usize| {
        let (edge, from) = if outwards { (count - 1 - k, (count - k) % count) } else { (k, k) };
        (edges[ring[edge].edge as usize][0], ring[from].point)
    };
    from_first((0..count).map(side).collect())
}

/// The parts of one face, while they are added to the mesh.
struct FaceParts<'p, 'a, 's> {
    plane: &'p FlatFace<'a>,
    points: &'p [DVec2],
    heights: &'p [f64],
    made: &'p mut Derivation<'s>,
    /// The number of each point in the mesh, or [`UNNUMBERED`].
    numbers: Vec<u32>,
}

/// The number of a point that is not in the mesh.
const UNNUMBERED: u32 = u32::MAX;

impl<'p, 'a, 's> FaceParts<'p, 'a, 's> {
    /// Parts with these points in the plane, the points of the face first.
    fn new(plane: &'p FlatFace<'a>, points: &'p [DVec2], heights: &'p [f64], made: &'p mut Derivation<'s>) -> Self {
        FaceParts { plane, points, heights, made, numbers: vec![UNNUMBERED; points.len()] }
    }

    /// Begins parts that share no points with the parts so far.
    fn begin(&mut self) {
        self.numbers.fill(UNNUMBERED);
    }

    /// The number of a point in the mesh. Points of the face are copied bit for bit.
    fn number(&mut self, point: u32) -> u32 {
        let FaceParts { plane, points, heights, made, numbers } = self;
        let at = point as usize;
        if numbers[at] == UNNUMBERED {
            numbers[at] = match plane.points.get(at) {
                Some(&old) => made.old_point(old),
                None => {
                    let p = points[at];
                    let place = plane.origin + plane.axes[0] * p.x + plane.axes[1] * p.y + plane.normal * heights[at];
                    made.point(place, PointOrigin::Grown)
                }
            };
        }
        numbers[at]
    }

    /// Adds pieces of the face: loops that are grouped to outlines and holes, in the order of their first sides. A corner has the
    /// rank of its next side and the point. Calls `added` with the points of each loop in the plane and in the mesh. Returns the
    /// number of faces.
    fn nested(
        &mut self,
        mut rings: Vec<Vec<(usize, u32)>>,
        mut added: impl FnMut(&mut Derivation<'s>, &[u32], &[u32]),
    ) -> usize {
        if let [ring] = &rings[..] {
            let ring: Vec<u32> = ring.iter().map(|corner| corner.1).collect();
            self.polygon([&ring[..]].into_iter(), &mut added);
            return 1;
        }
        sort_owned_by(&mut rings, |a, b| a[0].cmp(&b[0]));
        let nested = NestedRings::of(self.points, rings.iter().map(|ring| ring.iter().map(|corner| corner.1)));
        nested.polygons().for_each(|rings| self.polygon(rings, &mut added));
        nested.polygons().len()
    }

    /// Adds a piece of the face: its outline, and then its holes.
    fn polygon<'r>(
        &mut self,
        rings: impl Iterator<Item = &'r [u32]>,
        added: &mut impl FnMut(&mut Derivation<'s>, &[u32], &[u32]),
    ) {
        let mut face = Vec::with_capacity(1);
        for ring in rings {
            let numbers: Vec<u32> = ring.iter().map(|&point| self.number(point)).collect();
            added(self.made, ring, &numbers);
            face.push(numbers);
        }
        self.made.face(face, FaceOrigin::piece(&self.plane.face));
    }

    /// Adds the strip of an edge of the face.
    fn strip(&mut self, edge: [usize; 2], strip: &Strip, outwards: bool) {
        let mut ring: Vec<u32> = strip.ring.iter().map(|&point| self.number(point)).collect();
        if outwards {
            flip(&mut ring);
        } else {
            // If several sides have moved, the first one along the edge.
            let first = strip.front.iter().rposition(|&front| front);
            ring.rotate_left(first.unwrap_or(0));
        }
        let first = self.plane.face.corner_range().start;
        let origin = FaceOrigin::strip(&self.plane.face, edge.map(|corner| first + corner));
        self.made.face([ring], if outwards { origin.turned() } else { origin });
    }
}

/// A loop of sides that begins with the first one by rank.
fn from_first(mut sides: Vec<(usize, u32)>) -> Vec<(usize, u32)> {
    let first = (0..sides.len()).min_by_key(|&k| sides[k].0).unwrap_or(0);
    sides.rotate_left(first);
    sides
}

#[cfg(test)]
mod tests;
