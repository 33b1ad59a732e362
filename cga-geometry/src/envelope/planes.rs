//! The prism over an outline, cut by the planes of slopes.

use std::sync::Arc;

use glam::DVec3;

use super::{EnvelopePart, EnvelopeRefusal, Ground, capped};
use crate::cut::{Plane, halves};
use crate::mesh::{FaceTag, FlatFace, Mesh, flip};

/// Points closer to a plane, relative to the extent of the prism, are in it: planes meet in corners that earlier cuts have
/// rounded.
const IN_PLANE: f64 = 1e-11;

/// The volume below all planes. The faces have marks of their parts in place of tags.
pub(super) fn cut(ground: &Ground<'_>) -> Result<Mesh, EnvelopeRefusal> {
    let mut volume = Arc::new(prism(&ground.flat, ground.up, ground.top).known_closed(true));
    let tolerance = IN_PLANE * volume.bounds().size().max_element();
    for corner in ground.slopes() {
        let side = ground.sides[corner];
        let (sin, cos) = libm::sincos(side.angle.to_radians());
        let inwards = ground.inwards(corner);
        if inwards == DVec3::ZERO {
            continue;
        }
        let normal = ground.slope_normal(corner, sin, cos);
        let plane = Plane { point: ground.at(corner) + ground.up * side.base, normal };
        let below = halves(&volume, &plane, tolerance).parts.swap_remove(0).ok_or(EnvelopeRefusal::Empty)?;
        volume = Arc::new(capped(&below, EnvelopePart::Slope(corner as u32)));
    }
    // Every cut keeps the sides that it does not remove, so a volume without a bottom or with less than a tetrahedron's
    // faces has no contents.
    if volume.face_count() < 4
        || !volume.faces().any(|face| EnvelopePart::of_mark(face.tag().tags) == EnvelopePart::Bottom)
    {
        return Err(EnvelopeRefusal::Empty);
    }
    Ok(Arc::unwrap_or_clone(volume))
}

impl Ground<'_> {
    /// The normal of the slope at an edge, which looks up and outwards.
    fn slope_normal(&self, corner: usize, sin: f64, cos: f64) -> DVec3 {
        let along = self.at(self.next(corner)) - self.at(corner);
        along.cross(self.inwards(corner) * cos + self.up * sin).normalize_or_zero()
    }
}

/// The prism from a face without holes to a height along a direction.
pub(super) fn prism(flat: &FlatFace<'_>, up: DVec3, top: f64) -> Mesh {
    let mut mesh = Mesh::default();
    let low: Vec<DVec3> = flat.points.iter().map(|&point| flat.face.mesh.points()[point as usize]).collect();
    let high = low.iter().map(|p| *p + up * (top - p.dot(up)));
    mesh.points = low.iter().copied().chain(high).collect();
    let count = low.len() as u32;
    let ring = &flat.corners;
    let end_face = |mesh: &mut Mesh, part: EnvelopePart| {
        mesh.end_loop();
        mesh.end_face(FaceTag { tags: part.to_mark(), ..FaceTag::PLAIN });
    };
    let mut bottom = ring.clone();
    flip(&mut bottom);
    mesh.corners.extend(bottom);
    end_face(&mut mesh, EnvelopePart::Bottom);
    mesh.corners.extend(ring.iter().map(|point| point + count));
    end_face(&mut mesh, EnvelopePart::Top);
    for (corner, (&a, &b)) in (0..).zip(ring.iter().zip(ring.iter().cycle().skip(1))) {
        mesh.corners.extend([a, b, b + count, a + count]);
        end_face(&mut mesh, EnvelopePart::Base(corner));
    }
    mesh
}
