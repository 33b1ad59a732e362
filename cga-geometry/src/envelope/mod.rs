//! Volumes over faces that may be built on.
//!
//! At each edge of a face an upright side rises to a *base height*, and from there a *slope* leans inwards. Edges of holes
//! have upright sides. The volume is cut off level at its maximum height.
//!
//! If the whole outline is in front of each edge that has a slope, as in every convex outline, the volume is the prism over
//! the outline, cut by the planes of all slopes (`planes`). Otherwise slopes end at each other as the planes of a roof do: a
//! wavefront from the outline has one speed for each edge, and starts again at each base height (`layers`). Holes are then
//! taken away as upright shafts (`shafts`), so slopes go on behind them.
//!
//! Both ways work along the direction in which the volume is erected. The slope of an edge rises at its angle to the level
//! plane across that direction, from a line that is parallel to the edge.

mod layers;
mod planes;
mod shafts;

use std::collections::BTreeMap;
use std::ops::Range;

use glam::{DVec2, DVec3};

use crate::derive::{CornerValues, Derivation, FaceOrigin, PointOrigin};
use crate::each::Each;
use crate::mesh::{FaceRef, FaceTag, FlatFace, Mesh, Tags, unit};
use crate::nesting::extent::Extent;
use crate::skeleton::MOST_CORNERS;
use crate::tol::{PLANAR_EPSILON, TOUCH_EPSILON};
use crate::work;

/// The units of work of a corner of a face.
const CORNER: usize = 128;

/// The side of an envelope at an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnvelopeSide {
    /// The height of the upright part, in metres.
    pub base: f64,
    /// The angle of the slope, from 0 to 90 degrees.
    pub angle: f64,
}

impl EnvelopeSide {
    /// An upright side up to the top.
    pub const UPRIGHT: EnvelopeSide = EnvelopeSide { base: 0.0, angle: 90.0 };

    fn is_upright(self) -> bool {
        90.0 <= self.angle
    }
}

/// The reason why a face has no envelope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EnvelopeRefusal {
    /// The face has no normal: its area is 0 or not finite.
    NoNormal,
    /// The face has too many corners.
    TooMany,
    /// The outlines of the face cross.
    Tangled,
    /// The maximum height is below a part of the face, or nothing is left below the slopes.
    Empty,
    /// The face is upright, or looks down.
    Aside,
}

/// A part of an envelope.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum EnvelopePart {
    Bottom,
    Top,
    /// The upright side at a hole.
    Inner(u32),
    /// The upright side and the slope at an edge of the outline, by its corner.
    Base(u32),
    Slope(u32),
}

impl EnvelopePart {
    /// The tag of the part.
    fn tag(self) -> &'static str {
        match self {
            EnvelopePart::Bottom => "envelope.bottom",
            EnvelopePart::Top => "envelope.top",
            EnvelopePart::Inner(_) => "envelope.side.inner",
            EnvelopePart::Base(_) => "envelope.side.base",
            EnvelopePart::Slope(_) => "envelope.side.slope",
        }
    }

    /// A number in place of the tags of a face, while faces are cut.
    fn to_mark(self) -> u32 {
        match self {
            EnvelopePart::Bottom => 0,
            EnvelopePart::Top => 1,
            EnvelopePart::Inner(edge) => 2 + 3 * edge,
            EnvelopePart::Base(edge) => 3 + 3 * edge,
            EnvelopePart::Slope(edge) => 4 + 3 * edge,
        }
    }

    fn of_mark(mark: u32) -> EnvelopePart {
        match mark {
            0 => EnvelopePart::Bottom,
            1 => EnvelopePart::Top,
            _ => match ((mark - 2) % 3, (mark - 2) / 3) {
                (0, edge) => EnvelopePart::Inner(edge),
                (1, edge) => EnvelopePart::Base(edge),
                (_, edge) => EnvelopePart::Slope(edge),
            },
        }
    }
}

/// A face without holes, and the sides over its edges by corner, counted from the first one of the face.
struct Ground<'a> {
    flat: FlatFace<'a>,
    sides: Vec<EnvelopeSide>,
    /// The direction in which the volume is erected, of length 1.
    up: DVec3,
    /// The height along `up` at which the volume ends.
    top: f64,
}

impl Ground<'_> {
    fn at(&self, corner: usize) -> DVec3 {
        self.flat.face.position(self.flat.face.corner_range().start + corner)
    }

    /// All corners.
    fn corners(&self) -> Range<usize> {
        0..self.flat.corners.len()
    }

    fn next(&self, corner: usize) -> usize {
        (corner + 1) % self.flat.corners.len()
    }

    /// The corners whose sides have a slope that may cut the volume.
    fn slopes(&self) -> impl Iterator<Item = usize> + Clone {
        self.corners().filter(|&corner| !self.sides[corner].is_upright())
    }

    /// The level direction from an edge inwards.
    fn inwards(&self, corner: usize) -> DVec3 {
        unit(self.up.cross(self.at(self.next(corner)) - self.at(corner)))
    }

    /// Returns true if the whole outline is in front of an edge.
    fn is_outermost(&self, corner: usize) -> bool {
        let flat = |corner: usize| self.flat.flat[self.flat.corners[corner] as usize];
        let (from, along) = (flat(corner), (flat(self.next(corner)) - flat(corner)).normalize_or_zero());
        let Extent { low, high } = Extent::of(self.flat.flat.iter().copied());
        let slack = PLANAR_EPSILON * (high - low).max_element();
        self.corners().all(|other| -slack <= along.perp_dot(flat(other) - from))
    }
}

/// Returns true if loops of a face cross.
fn is_tangled(face: &FlatFace<'_>) -> bool {
    let flat = &face.flat;
    let (_, rings) = face.edges(false);
    let sides = |ring: &Vec<u32>| -> Vec<[DVec2; 2]> {
        (0..ring.len()).map(|k| [flat[ring[k] as usize], flat[ring[(k + 1) % ring.len()] as usize]]).collect()
    };
    let Extent { low, high } = Extent::of(flat.iter().copied());
    let slack = TOUCH_EPSILON * (high - low).max_element();
    crate::skeleton::any_cross(rings.iter().flat_map(sides).collect(), slack)
}

/// Builds the envelope of each face: a volume with upright sides and slopes, cut off at a maximum height in metres.
///
/// `sides` has a side for each corner of the mesh, for the edge that begins there. Without `up`, an envelope is erected along the
/// normal of its face; `up` has length 1. The maximum height is measured from the lowest point of a face. Faces without an
/// envelope are copied. They are also listed, by number, with the reason.
///
/// The faces over a face are the bottom, the top, the upright sides in the order of edges, and then the slopes. The time is
/// quadratic in the number of corners of a face. If the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile, the result
/// has no meaning.
///
/// # Panics
/// Panics if the number of sides differs from the number of corners of the mesh.
///
/// ```
/// use cga_geometry::envelope::{EnvelopeSide, envelopes};
/// use cga_geometry::primitive;
///
/// // A square with sides of 1. Slopes of 45 degrees rise at once: the volume up to 0.25 is a truncated pyramid.
/// let sides = [EnvelopeSide { base: 0.0, angle: 45.0 }; 4];
/// let (volume, refused) = envelopes(&primitive::quad(), &sides, 0.25, None);
/// assert!(refused.is_empty() && volume.is_closed());
/// assert!((volume.volume() - 0.25 / 3.0 * (1.0 + 0.5 + 0.25)).abs() < 1e-12);
/// ```
pub fn envelopes(
    source: &Mesh,
    sides: &[EnvelopeSide],
    height: f64,
    up: Option<DVec3>,
) -> (Mesh, Vec<(usize, EnvelopeRefusal)>) {
    assert_eq!(sides.len(), source.corners().len(), "one side for each corner of the mesh");
    let mut made = Derivation::new(source, CornerValues::Dropped, 0).without_trace();
    let mut refused = Vec::new();
    for face in source.faces() {
        if !work::spend(CORNER * face.corner_count()) {
            return (Mesh::default(), Vec::new());
        }
        match envelope(&face, &sides[face.corner_range()], height, up) {
            Ok(volume) => add(&mut made, &face, &volume),
            Err(why) => {
                made.copy(&face);
                refused.push((face.index(), why));
            }
        }
    }
    (made.finish(), refused)
}

fn envelope(
    face: &FaceRef<'_>,
    sides: &[EnvelopeSide],
    height: f64,
    up: Option<DVec3>,
) -> Result<Mesh, EnvelopeRefusal> {
    if MOST_CORNERS < face.corner_count() {
        return Err(EnvelopeRefusal::TooMany);
    }
    let flat = FlatFace::of(face).ok_or(EnvelopeRefusal::NoNormal)?;
    let up = up.unwrap_or(flat.normal);
    if up.dot(flat.normal) <= TOUCH_EPSILON {
        return Err(EnvelopeRefusal::Aside);
    }
    let heights = || face.corner_range().map(|corner| face.position(corner).dot(up));
    let (low, high) = heights().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), at| (l.min(at), h.max(at)));
    let top = low + height;
    if !(top > high && top.is_finite()) {
        return Err(EnvelopeRefusal::Empty);
    }
    if is_tangled(&flat) {
        return Err(EnvelopeRefusal::Tangled);
    }
    let rings: Vec<Vec<usize>> = face.loop_ranges().map(Iterator::collect).collect();
    let filled = plain(face, &rings[0]);
    let flat = FlatFace::of(&filled.face(0)).ok_or(EnvelopeRefusal::NoNormal)?;
    let ground = Ground { flat, sides: sides[..rings[0].len()].to_vec(), up, top };
    let volume = match ground.slopes().all(|corner| ground.is_outermost(corner)) {
        true => planes::cut(&ground)?,
        false => layers::stack(&ground)?,
    };
    let volume = if rings.len() == 1 { volume } else { shafts::drilled(volume, &ground, face)? };
    Ok(begun_at_outline(&ground, &volume))
}

/// The volume with slopes that begin with their edge nearest to the outline.
fn begun_at_outline(ground: &Ground<'_>, volume: &Mesh) -> Mesh {
    let mut made = volume.clone();
    for face in volume.faces() {
        let EnvelopePart::Slope(corner) = EnvelopePart::of_mark(face.tag().tags) else { continue };
        let (from, inwards) = (ground.at(corner as usize), ground.inwards(corner as usize));
        let ring = face.outer();
        let at = |k: usize| volume.points()[ring[k % ring.len()] as usize];
        let off = |k: usize| inwards.dot(at(k) - from).max(inwards.dot(at(k + 1) - from));
        let first = (0..ring.len()).min_by(|&a, &b| off(a).total_cmp(&off(b))).unwrap_or(0);
        let range = face.corner_range().start;
        made.corners[range..range + ring.len()].rotate_left(first);
    }
    made
}

/// The mesh with other tags.
fn marked(mesh: &Mesh, mark: impl Fn(FaceTag) -> FaceTag) -> Mesh {
    let mut made = mesh.clone();
    made.tags = Tags::default();
    mesh.faces().for_each(|face| made.tags.push(mark(face.tag())));
    made
}

/// The mesh with its caps marked as a part.
fn capped(mesh: &Mesh, part: EnvelopePart) -> Mesh {
    marked(mesh, |tag| if tag.cap { FaceTag { tags: part.to_mark(), ..FaceTag::PLAIN } } else { tag })
}

/// A mesh of one face with a loop of corners of a face, without texture coordinates and normals. Corners at one place have one
/// point, except for neighbours.
fn plain(face: &FaceRef<'_>, ring: &[usize]) -> Mesh {
    let mut mesh = Mesh::default();
    let mut numbers = BTreeMap::new();
    for (place, &corner) in ring.iter().enumerate() {
        let at = face.position(corner);
        let known = *numbers.entry(at.to_array().each(f64::to_bits)).or_insert_with(|| mesh.add_point(at));
        let is_repeated = mesh.corners.last() == Some(&known) || place + 1 == ring.len() && mesh.corners[0] == known;
        let number = if is_repeated { mesh.add_point(at) } else { known };
        mesh.corners.push(number);
    }
    mesh.end_loop();
    mesh.end_face(face.tag());
    mesh.checked()
}

/// Adds the faces of a volume over a face. The bottom has the points of the face bit for bit.
fn add(made: &mut Derivation<'_>, face: &FaceRef<'_>, volume: &Mesh) {
    let key = |point: DVec3| point.to_array().each(|x| (x + 0.0).to_bits());
    let points = face.corner_range().map(|corner| (key(face.position(corner)), face.mesh.corners()[corner]));
    let olds: BTreeMap<[u64; 3], u32> = points.collect();
    let origin = |point: DVec3| olds.get(&key(point)).map_or(PointOrigin::Grown, |old| PointOrigin::Old(*old));
    let numbers: Vec<u32> = volume.points().iter().map(|&point| made.point(point, origin(point))).collect();
    let edges: Vec<[usize; 2]> = face.edges().collect();
    for own in volume.faces() {
        let part = EnvelopePart::of_mark(own.tag().tags);
        let origin = match part {
            EnvelopePart::Bottom | EnvelopePart::Top => FaceOrigin::over(face, part.tag()),
            EnvelopePart::Inner(corner) | EnvelopePart::Base(corner) | EnvelopePart::Slope(corner) => {
                FaceOrigin::over_edge(face, part.tag(), edges[corner as usize])
            }
        };
        let rings = own.loops().map(|ring| ring.iter().map(|&point| numbers[point as usize]).collect::<Vec<_>>());
        made.face(rings, origin);
    }
}

#[cfg(test)]
mod tests;
