//! Divides a face into its largest rectangle and the rest.

use glam::{DVec2, DVec3};

use super::{RectangleSides, largest};
use crate::derive::{Derivation, EdgeOrigin, EdgeSource, FaceOrigin, PointOrigin};
use crate::each::Each;
use crate::mesh::FaceRef;
use crate::overlay::{OverlayError, wound};
use crate::segment::nearest_share;
use crate::skeleton::{MOST_CORNERS, any_cross};
use crate::tol::{TIE_EPSILON, TOUCH_EPSILON};

/// The reason why a face is not divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RectangleRefusal {
    /// The face has no normal: its area is 0 or not finite.
    NoNormal,
    /// The face has too many corners.
    TooMany,
    /// The outlines of the face cross.
    Tangled,
    /// Corners of the rectangle are one point of the face.
    TooNarrow,
}

/// A face as seen along the axis that is nearest to its normal.
struct Seen<'a> {
    face: FaceRef<'a>,
    axes: [DVec3; 2],
    /// The axis of view, and the plane of the face: its normal, and the place of the plane along it.
    view: DVec3,
    normal: DVec3,
    at: f64,
    /// The distinct points, and their numbers in the mesh.
    flat: Vec<DVec2>,
    points: Vec<u32>,
    rings: Vec<Vec<u32>>,
}

/// Adds the largest rectangle in a face to a mesh, and, with `rest`, the connected parts of the rest of the face. Returns the
/// number of parts. A face that is refused adds nothing.
///
/// The face is seen along the axis that is nearest to its normal, and so are the angles of the rectangle. Without
/// `sides` along edges it follows the axes. Parts of the rest are in the order of the points of the face, and begin with an
/// edge on its outline if they have one. Texture coordinates and normals of new points continue the values of the face. Sides on
/// edges of the face have their tags. `made` is a mesh that is made of the mesh of the face.
///
/// The search ends after a fixed amount of work, half a second at most, with the largest rectangle so far.
///
/// ```
/// use cga_geometry::derive::{CornerValues, Derivation};
/// use cga_geometry::inner_rectangle::{RectangleSides, face::cut_rectangle};
/// use cga_geometry::mesh::MeshBuilder;
///
/// // An L of a bar of 5 by 2 and a block of 2 by 1.
/// let mut builder = MeshBuilder::new();
/// let l = [[0.0, 0.0], [5.0, 0.0], [5.0, 2.0], [2.0, 2.0], [2.0, 3.0], [0.0, 3.0]];
/// let corners = l.map(|[x, y]| builder.point([x, y, 0.0]));
/// builder.polygon(&corners);
/// let mesh = builder.build()?;
/// let mut made = Derivation::new(&mesh, CornerValues::All, 0);
/// assert_eq!(cut_rectangle(&mesh.face(0), RectangleSides::Axes, true, &mut made), Ok(1));
/// let areas: Vec<f64> = made.finish_by_use().faces().map(|face| face.area()).collect();
/// assert!((areas[0] - 10.0).abs() < 1e-9 && (areas[1] - 2.0).abs() < 1e-9);
/// # Ok::<(), cga_geometry::mesh::MeshError>(())
/// ```
///
/// # Errors
/// The reason why the face is refused.
pub fn cut_rectangle(
    face: &FaceRef<'_>,
    sides: RectangleSides,
    rest: bool,
    made: &mut Derivation<'_>,
) -> Result<usize, RectangleRefusal> {
    if MOST_CORNERS < face.corner_count() {
        return Err(RectangleRefusal::TooMany);
    }
    let seen = Seen::of(face).ok_or(RectangleRefusal::NoNormal)?;
    let extent = seen.extent();
    if any_cross(seen.edges().collect(), TOUCH_EPSILON * extent) {
        return Err(RectangleRefusal::Tangled);
    }
    let rectangle = largest(&seen.flat, &seen.rings, sides).ok_or(RectangleRefusal::Tangled)?;
    if (0..4).any(|k| rectangle.corners[k].distance(rectangle.corners[(k + 1) % 4]) <= 2.0 * TIE_EPSILON * extent) {
        return Err(RectangleRefusal::TooNarrow);
    }
    let own = seen.flat.len() as u32;
    let mut all = seen.flat.clone();
    all.extend(rectangle.corners);
    let polygons = if rest {
        let hole: Vec<u32> = (own..own + 4).rev().collect();
        let rings = seen.rings.iter().chain([&hole]).map(Vec::as_slice);
        let region = wound(&all, rings, seen.flat.len()).map_err(|error| match error {
            OverlayError::TooMany => RectangleRefusal::TooMany,
            OverlayError::Tangled => RectangleRefusal::Tangled,
        })?;
        all = region.points;
        region.polygons
    } else {
        Vec::new()
    };
    let base = made.point_count() as u32;
    seen.points.iter().for_each(|&point| _ = made.old_point(point));
    all[seen.flat.len()..].iter().for_each(|p| _ = made.point(seen.place(*p), PointOrigin::New));
    // A corner of the rectangle in a corner of the face is that corner.
    let same = |corner: u32| {
        let at = all[corner as usize];
        (0..own).find(|&point| seen.flat[point as usize].distance(at) <= TIE_EPSILON * extent).unwrap_or(corner)
    };
    let corners: Vec<u32> = (own..own + 4).map(same).collect();
    seen.add(&[corners], &all, base, extent, made);
    let count = polygons.len();
    for mut polygon in polygons {
        let outline = &mut polygon[0];
        let is_own = |k: usize| {
            let side = [outline[k], outline[(k + 1) % outline.len()]].each(|point| all[point as usize]);
            seen.edge_at(side, extent).is_some()
        };
        let first = (0..outline.len()).find(|&k| is_own(k)).unwrap_or(0);
        outline.rotate_left(first);
        seen.add(&polygon, &all, base, extent, made);
    }
    Ok(count)
}

impl<'a> Seen<'a> {
    /// `None` for a face without a normal.
    fn of(face: &FaceRef<'a>) -> Option<Self> {
        let normal = face.normal();
        let size = normal.abs();
        let largest = if size.z >= size.x && size.z >= size.y { 2 } else { usize::from(size.y >= size.x) };
        if normal == DVec3::ZERO {
            return None;
        }
        // From outside, the second axis points up, or to the back.
        let (x, y, view) = match largest {
            0 => (DVec3::NEG_Z, DVec3::Y, DVec3::X),
            1 => (DVec3::X, DVec3::NEG_Z, DVec3::Y),
            _ => (DVec3::X, DVec3::Y, DVec3::Z),
        };
        let axes = if normal.dot(view) < 0.0 { [-x, y] } else { [x, y] };
        let (mut flat, mut points, mut rings) = (Vec::new(), Vec::new(), Vec::new());
        let mut numbers = std::collections::BTreeMap::new();
        for ring in face.loops() {
            let number = |&point: &u32| {
                *numbers.entry(point).or_insert_with(|| {
                    let p = face.mesh.points()[point as usize];
                    flat.push(DVec2::new(p.dot(axes[0]), p.dot(axes[1])));
                    points.push(point);
                    points.len() as u32 - 1
                })
            };
            rings.push(ring.iter().map(number).collect::<Vec<u32>>());
        }
        let count = face.corner_count() as f64;
        let at = face.corner_range().map(|corner| face.position(corner).dot(normal)).sum::<f64>() / count;
        Some(Seen { face: *face, axes, view, normal, at, flat, points, rings })
    }

    fn extent(&self) -> f64 {
        self.flat.iter().fold(0.0, |most: f64, p| most.max((*p - self.flat[0]).abs().max_element()))
    }

    fn edges(&self) -> impl Iterator<Item = [DVec2; 2]> + '_ {
        let at = |point: u32| self.flat[point as usize];
        let edges = move |ring: &'_ Vec<u32>| -> Vec<[DVec2; 2]> {
            (0..ring.len()).map(|k| [at(ring[k]), at(ring[(k + 1) % ring.len()])]).collect()
        };
        self.rings.iter().flat_map(edges)
    }

    /// The edge of the face on which a side is, as the numbers of its points.
    fn edge_at(&self, side: [DVec2; 2], extent: f64) -> Option<[u32; 2]> {
        let near = |p: DVec2, [a, b]: [DVec2; 2]| a.lerp(b, nearest_share(p, [a, b])).distance(p);
        let is_there = |edge: [DVec2; 2]| side.iter().all(|&p| near(p, edge) <= TIE_EPSILON * extent);
        let ends = self.rings.iter().flat_map(|ring| (0..ring.len()).map(|k| [ring[k], ring[(k + 1) % ring.len()]]));
        self.edges().zip(ends).find(|(edge, _)| is_there(*edge)).map(|(_, ends)| ends)
    }

    /// The place of a point in the plane of the face.
    fn place(&self, p: DVec2) -> DVec3 {
        let beside = self.axes[0] * p.x + self.axes[1] * p.y;
        beside + self.view * ((self.at - self.normal.dot(beside)) / self.normal.dot(self.view))
    }

    /// Adds a piece of the face. Its sides on edges of the face have their tags.
    fn add(&self, rings: &[Vec<u32>], all: &[DVec2], base: u32, extent: f64, made: &mut Derivation<'_>) {
        let has_tags = made.has_component_tags();
        let sides = rings.iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
        for side in sides.map(|(&from, &to)| [from, to]).take_while(|_| has_tags) {
            if let Some(edge) = self.edge_at(side.each(|point| all[point as usize]), extent) {
                let source = EdgeSource::Edge(edge.each(|end| self.points[end as usize]));
                made.edge(side.each(|point| base + point), EdgeOrigin { source, tag: None });
            }
        }
        let rings = rings.iter().map(|ring| ring.iter().map(|point| base + point).collect::<Vec<u32>>());
        made.face(rings, FaceOrigin::piece(&self.face));
    }
}
