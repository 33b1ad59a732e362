//! Moves the outlines of faces in or out and fills the difference with strips (*offset operation*).
//!
//! A face is moved in the plane across its normal. The parts of a face that is not planar are not planar either
//! ([`relief`]): old points stay, and new points get heights between the heights of the face.
//!
//! Each face gives the interior of its moved outline, in the order of the first edges of the parts, and then a strip
//! for each of its edges, outline before holes. The parts of a face share their points with each other, but not with
//! other faces: an edge that only one face uses is a border of the parts of one source face. Strips of an inward offset
//! have the orientation of the face and begin with the moved edge, if there is one. Strips of an outward offset have
//! the opposite orientation and begin with the edge itself. So the areas of all parts add up to the area of the face. An interior
//! part begins with the first edge of the face that has a part in it. Strips have the tags of their edges ([`offset_tags`]).

use glam::DVec2;

use super::face::unit;
use super::flat_face::FlatFace;
use super::map::flip;
use super::spread::Spread;
use super::{FaceTag, Mesh};
use crate::geometry::nesting::rings::NestedRings;
use crate::geometry::skeleton::{self, Failure, Left, Strip};
use crate::value::small_sort::SmallSort;
use offset_tags::OffsetTags;

mod offset_tags;
pub(crate) mod region;
mod relief;
pub(crate) mod set_back;
pub(crate) mod side_tags;
pub(crate) mod to_area;

/// A corner of a new loop: a point in the plane, and the corner of the face there.
type RingCorner = (u32, Option<usize>);

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
pub(crate) enum OffsetError {
    NoNormal,
    TooMany,
    Tangled,
}

impl From<Failure> for OffsetError {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::TooMany => OffsetError::TooMany,
            Failure::Tangled => OffsetError::Tangled,
        }
    }
}

/// Moves the faces of a mesh inwards (a negative distance) or outwards. Faces that cannot be moved are copied
/// unchanged, with points of their own, and are also listed with the reason.
pub(crate) fn offset(mesh: &Mesh, distance: f64, keep: OffsetFaces) -> (Mesh, Vec<(usize, OffsetError)>) {
    let (mut made, mut tags) = (mesh.alike(0), OffsetTags::new(mesh));
    let mut refused = Vec::new();
    for face in mesh.faces() {
        let plane = FlatFace::of(&face).ok_or(OffsetError::NoNormal);
        if let Err(why) = plane.and_then(|plane| offset_face(&plane, distance, keep, &mut made, &mut tags)) {
            refused.push((face.index(), why));
            tags.copy(&face, &mut made);
        }
    }
    tags.finish(&mut made);
    // The wavefront numbers points in the order of its events; rules expect vertices in the order of faces.
    made.number_by_use();
    (made, refused)
}

/// Adds the offset of a face to a mesh.
fn offset_face(
    plane: &FlatFace<'_>,
    distance: f64,
    keep: OffsetFaces,
    made: &mut Mesh,
    tags: &mut OffsetTags<'_>,
) -> Result<(), OffsetError> {
    let outwards = 0.0 < distance;
    let (edges, rings) = plane.edges(outwards);
    let swept = skeleton::sweep(&plane.flat, &rings, distance.abs())?;
    let heights = relief::heights(&plane.heights, &rings, &swept);
    let mut part = FaceParts::new(plane, &swept.points, &heights, outwards, made);
    if keep != OffsetFaces::Border {
        part.inside(&edges, &swept.left, tags);
    }
    if keep != OffsetFaces::Inside {
        let mut strips: Vec<([usize; 2], &Strip)> =
            swept.strips.iter().map(|strip| (edges[strip.edge as usize], strip)).collect();
        strips.small_sort_by_key(|(edge, _)| edge[0]);
        strips.iter().for_each(|(edge, strip)| part.strip(*edge, strip, tags));
    }
    Ok(())
}

/// The parts of one face, while they are added to the mesh.
struct FaceParts<'p, 'a> {
    plane: &'p FlatFace<'a>,
    points: &'p [DVec2],
    heights: &'p [f64],
    spread: Spread,
    outwards: bool,
    made: &'p mut Mesh,
    /// The number of each point in the mesh, or [`UNNUMBERED`].
    numbers: Vec<u32>,
}

/// The number of a point that is not in the mesh.
const UNNUMBERED: u32 = u32::MAX;

impl<'p, 'a> FaceParts<'p, 'a> {
    /// Parts with these points in the plane, the points of the face first.
    fn new(
        plane: &'p FlatFace<'a>,
        points: &'p [DVec2],
        heights: &'p [f64],
        outwards: bool,
        made: &'p mut Mesh,
    ) -> Self {
        let spread = Spread::of(plane.corners.iter().map(|&point| plane.flat[point as usize]).collect());
        FaceParts { plane, points, heights, spread, outwards, made, numbers: vec![UNNUMBERED; points.len()] }
    }

    /// Begins parts that share no points with the parts so far.
    fn begin(&mut self) {
        self.numbers.fill(UNNUMBERED);
    }

    /// The number of a point in the mesh. Points of the face are copied bit for bit.
    fn number(&mut self, point: u32) -> u32 {
        let FaceParts { plane, points, heights, made, numbers, .. } = self;
        let at = point as usize;
        if numbers[at] == UNNUMBERED {
            let place = || {
                let p = points[at];
                plane.origin + plane.axes[0] * p.x + plane.axes[1] * p.y + plane.normal * heights[at]
            };
            let own = plane.points.get(at).map(|&point| plane.face.mesh.points[point as usize]);
            numbers[at] = made.add_point(own.unwrap_or_else(place));
        }
        numbers[at]
    }

    /// Adds the interiors of the moved outlines: loops grouped to outlines and holes, each beginning with its first
    /// edge.
    fn inside(&mut self, edges: &[[usize; 2]], left: &[Vec<Left>], tags: &mut OffsetTags<'_>) {
        let rings = left.iter().map(|ring| self.ahead(ring, edges)).collect();
        let (plane, tag) = (self.plane, tags.inside(self.plane));
        self.nested(rings, tag, |_| None, |ring, numbers| tags.ring(plane, ring, numbers));
    }

    /// Adds faces of loops that are grouped to outlines and holes, in the order of the first sides. A corner has the rank
    /// of its next side and the point. `own` gives the corner of the face at a point. Calls `added` with the points of each
    /// loop in the plane and in the mesh. Returns the number of faces.
    fn nested(
        &mut self,
        mut rings: Vec<Vec<(usize, u32)>>,
        tag: FaceTag,
        own: impl Fn(u32) -> Option<usize>,
        mut added: impl FnMut(&[RingCorner], &[u32]),
    ) -> usize {
        rings.sort_unstable_by_key(|ring| ring[0]);
        let nested = NestedRings::of(self.points, rings.iter().map(|ring| ring.iter().map(|corner| corner.1)));
        for rings in nested.polygons() {
            for ring in rings {
                let ring: Vec<RingCorner> = ring.iter().map(|&point| (point, own(point))).collect();
                added(&ring, self.ring(&ring, 1.0));
            }
            self.made.end_face(tag);
        }
        nested.polygons().len()
    }

    /// A loop of the remaining interior in the direction of the face, beginning with the first edge. For each corner it
    /// has the face's edge that the next side belongs to, and the point.
    fn ahead(&self, ring: &[Left], edges: &[[usize; 2]]) -> Vec<(usize, u32)> {
        let count = ring.len();
        let side = |k: usize| {
            let (edge, from) = if self.outwards { (count - 1 - k, (count - k) % count) } else { (k, k) };
            (edges[ring[edge].edge as usize][0], ring[from].point)
        };
        from_first((0..count).map(side).collect())
    }

    /// Adds the strip of an edge of the face.
    fn strip(&mut self, edge: [usize; 2], strip: &Strip, tags: &mut OffsetTags<'_>) {
        let own = |point: u32| edge.into_iter().find(|&c| self.plane.corners[c] == point);
        let mut ring: Vec<RingCorner> = strip.ring.iter().map(|&point| (point, own(point))).collect();
        if self.outwards {
            flip(&mut ring);
        } else {
            // If several sides have moved, the first one along the edge.
            let first = strip.front.iter().rposition(|&front| front);
            ring.rotate_left(first.unwrap_or(0));
        }
        let plane = self.plane;
        tags.ring(plane, &ring, self.ring(&ring, if self.outwards { -1.0 } else { 1.0 }));
        self.made.end_face(tags.strip(plane, edge));
    }

    /// Adds a loop of points of the plane. Returns their numbers in the mesh.
    fn ring(&mut self, ring: &[RingCorner], looking: f64) -> &[u32] {
        let source = self.plane.face.mesh;
        let range = self.plane.face.corner_range();
        for &(point, corner) in ring {
            let number = self.number(point);
            self.made.corners.push(number);
            if source.uvs.is_empty() && source.normals.is_empty() {
                continue;
            }
            let weights = match corner {
                Some(_) => Vec::new(),
                None => self.spread.weights(self.points[point as usize]),
            };
            let mixed =
                |list: &[DVec2]| list[range.clone()].iter().zip(&weights).map(|(&uv, &weight)| uv * weight).sum();
            self.made.uvs.push_from(&source.uvs, |list| corner.map_or_else(|| mixed(list), |c| list[range.start + c]));
            if !source.normals.is_empty() {
                let list = &source.normals[range.clone()];
                let mixed = || unit(list.iter().zip(&weights).map(|(&normal, &weight)| normal * weight).sum());
                self.made.normals.push(corner.map_or_else(mixed, |c| list[c]) * looking);
            }
        }
        self.made.end_loop();
        &self.made.corners[self.made.corners.len() - ring.len()..]
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
