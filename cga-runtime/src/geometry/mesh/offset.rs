//! Moves the outlines of faces in or out and fills the difference with strips (*offset operation*).
//!
//! A face is moved in the plane across its normal. The parts of a face that is not planar are not planar either
//! ([`relief`]): old points stay, and new points get heights between those of the face.
//!
//! Each face gives the interior of its moved outline, in the order of the first edges of the parts, and then a strip
//! for each of its edges, outline before holes. The parts of a face share their points with each other, but not with
//! other faces: an edge that only one face uses is a border of the parts of one source face. Strips of an inward offset
//! have the orientation of the face and begin with the moved edge, if there is one. Strips of an outward offset have
//! the opposite orientation and begin with the edge itself. So the areas of all parts add up to the area of the face. An interior
//! part begins with the first edge of the face that has a part in it.

use glam::DVec2;

use super::Mesh;
use super::face::unit;
use super::flat_face::FlatFace;
use super::map::flip;
use super::spread::Spread;
use crate::geometry::nesting::rings::NestedRings;
use crate::geometry::skeleton::{self, Failure, Left, Strip};

pub(crate) mod region;
mod relief;
pub(crate) mod set_back;
pub(crate) mod to_area;

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
    let mut made = mesh.alike(0);
    let mut refused = Vec::new();
    for face in mesh.faces() {
        let plane = FlatFace::of(&face).ok_or(OffsetError::NoNormal);
        if let Err(why) = plane.and_then(|plane| offset_face(&plane, distance, keep, &mut made)) {
            refused.push((face.index(), why));
            made.add_copy(&face);
        }
    }
    // The wavefront numbers points in the order of its events; rules expect vertices in the order of faces.
    made.number_by_use();
    (made, refused)
}

/// Adds the offset of a face to a mesh.
fn offset_face(plane: &FlatFace<'_>, distance: f64, keep: OffsetFaces, made: &mut Mesh) -> Result<(), OffsetError> {
    let outwards = 0.0 < distance;
    let (edges, rings) = plane.edges(outwards);
    let swept = skeleton::sweep(&plane.flat, &rings, distance.abs())?;
    let heights = relief::heights(&plane.heights, &rings, &swept);
    let mut part = FaceParts::new(plane, &swept.points, &heights, outwards, made);
    if keep != OffsetFaces::Border {
        part.inside(&edges, &swept.left);
    }
    if keep != OffsetFaces::Inside {
        let mut strips: Vec<([usize; 2], &Strip)> =
            swept.strips.iter().map(|strip| (edges[strip.edge as usize], strip)).collect();
        strips.sort_by_key(|(edge, _)| edge[0]);
        strips.iter().for_each(|(edge, strip)| part.strip(*edge, strip));
    }
    Ok(())
}

/// The parts of one face, while they are added to the mesh.
struct FaceParts<'p, 'a> {
    plane: &'p FlatFace<'a>,
    points: &'p [DVec2],
    spread: Spread,
    outwards: bool,
    made: &'p mut Mesh,
    /// The start of its points in the mesh.
    base: u32,
}

impl<'p, 'a> FaceParts<'p, 'a> {
    /// Adds the points to the mesh. Old points are copied bit for bit.
    fn new(plane: &'p FlatFace<'a>, points: &'p [DVec2], heights: &[f64], outwards: bool, made: &'p mut Mesh) -> Self {
        let base = made.points.len() as u32;
        let old = plane.points.iter().map(|&point| plane.face.mesh.points[point as usize]);
        let new = points.iter().zip(heights).skip(plane.points.len());
        let place = |(p, &height): (&DVec2, &f64)| {
            plane.origin + plane.axes[0] * p.x + plane.axes[1] * p.y + plane.normal * height
        };
        made.points.extend(old.chain(new.map(place)));
        let spread = Spread::of(plane.corners.iter().map(|&point| plane.flat[point as usize]).collect());
        FaceParts { plane, points, spread, outwards, made, base }
    }

    /// Adds the interiors of the moved outlines: loops grouped to outlines and holes, each beginning with its first
    /// edge.
    fn inside(&mut self, edges: &[[usize; 2]], left: &[Vec<Left>]) {
        let rings = left.iter().map(|ring| self.ahead(ring, edges)).collect();
        self.nested(rings, |_| None);
    }

    /// Adds faces of loops that are grouped to outlines and holes, in the order of the first sides. A corner has the rank
    /// of its next side and the point. `own` gives the corner of the face at a point. Returns the number of faces.
    fn nested(&mut self, mut rings: Vec<Vec<(usize, u32)>>, own: impl Fn(u32) -> Option<usize>) -> usize {
        rings.sort_unstable_by_key(|ring| ring[0]);
        let nested = NestedRings::of(self.points, rings.iter().map(|ring| ring.iter().map(|corner| corner.1)));
        for rings in nested.polygons() {
            for ring in rings {
                let ring: Vec<(u32, Option<usize>)> = ring.iter().map(|&point| (point, own(point))).collect();
                self.ring(&ring, 1.0);
            }
            self.end_face();
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
    fn strip(&mut self, edge: [usize; 2], strip: &Strip) {
        let own = |point: u32| edge.into_iter().find(|&c| self.plane.corners[c] == point);
        let mut ring: Vec<(u32, Option<usize>)> = strip.ring.iter().map(|&point| (point, own(point))).collect();
        if self.outwards {
            flip(&mut ring);
        } else {
            // If several sides have moved, the first one along the edge.
            let first = strip.front.iter().rposition(|&front| front);
            ring.rotate_left(first.unwrap_or(0));
        }
        self.ring(&ring, if self.outwards { -1.0 } else { 1.0 });
        self.end_face();
    }

    /// Adds a loop of points of the plane. Some are corners of the face.
    fn ring(&mut self, ring: &[(u32, Option<usize>)], looking: f64) {
        let source = self.plane.face.mesh;
        let range = self.plane.face.corner_range();
        for &(point, corner) in ring {
            self.made.corners.push(self.base + point);
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
    }

    fn end_face(&mut self) {
        self.made.end_face(self.plane.face.tag());
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
