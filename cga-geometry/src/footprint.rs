//! The outline of a mesh as seen from above.

use glam::{DVec2, DVec3};

use crate::each::Each;
use crate::mesh::{FaceTag, Mesh};
use crate::overlay::{OverlayError, wound};
use crate::tol::PLANAR_EPSILON;
use crate::triangulate::Triangulator;
use crate::work;

/// The units of work of a corner.
const CORNER: usize = 16;

/// The union of the projections of all faces to the plane y = 0: faces that look up, with holes where no face covers the
/// plane. Without faces if no face covers an area.
///
/// A face begins with the corner of the point of the mesh with the lowest number. Corners at which the outline runs straight
/// on are dropped. The faces have no values, tags or materials.
///
/// # Errors
/// An error if too many edges cross, or if edges that are nearly at one place cannot be told apart.
///
/// ```
/// use cga_geometry::glam::{DAffine3, DVec3};
/// use cga_geometry::{footprint, primitive};
///
/// let tower = primitive::cube().map(&DAffine3::from_scale(DVec3::new(2.0, 9.0, 3.0)));
/// let plan = footprint::footprint(&tower)?;
/// assert_eq!((plan.face_count(), plan.area()), (1, 6.0));
/// # Ok::<(), cga_geometry::overlay::OverlayError>(())
/// ```
pub fn footprint(mesh: &Mesh) -> Result<Mesh, OverlayError> {
    let flat: Vec<DVec2> = mesh.points.iter().map(|p| DVec2::new(p.x, -p.z)).collect();
    let rings = covering(mesh, &flat);
    let region = wound(&flat, rings.iter().map(Vec::as_slice), 0)?;
    let mut made = Mesh::default();
    let mut numbers = vec![u32::MAX; region.points.len()];
    for polygon in &region.polygons {
        for ring in polygon {
            for &point in ring {
                if numbers[point as usize] == u32::MAX {
                    let p = region.points[point as usize];
                    // No coordinate is -0.
                    numbers[point as usize] = made.add_point(DVec3::new(p.x, 0.0, 0.0 - p.y));
                }
                made.corners.push(numbers[point as usize]);
            }
            made.end_loop();
        }
        made.end_face(FaceTag::PLAIN);
    }
    Ok(made)
}

/// Rings that run anticlockwise around the area of each face, holes clockwise. Some are missing if the work is to end.
fn covering(mesh: &Mesh, flat: &[DVec2]) -> Vec<Vec<u32>> {
    // In a closed mesh as many faces look up as down over each place.
    let both_sides = !mesh.is_closed();
    let (mut rings, mut triangles, mut triangulator) = (Vec::new(), Vec::new(), Triangulator::new());
    let extent = mesh.bounds().size().max_element();
    for face in mesh.faces() {
        if !work::spend(CORNER * face.corner_count()) {
            break;
        }
        let normal = face.normal();
        let from = face.position(face.corner_range().start);
        let is_planar = face.corner_range().len() == 3
            || face.corner_range().all(|c| (face.position(c) - from).dot(normal).abs() <= PLANAR_EPSILON * extent);
        let start = rings.len();
        if is_planar {
            rings.extend(face.loops().map(<[u32]>::to_vec));
        } else {
            triangles.clear();
            triangulator.face(mesh, face.index(), &mut triangles);
            rings.extend(triangles.iter().map(|corners| corners.each(|corner| mesh.corners[corner as usize]).to_vec()));
        }
        // The parts of a bent face may look up and down.
        let parts = if is_planar { rings.len() - start } else { 1 };
        let mut kept = start;
        let mut at = start;
        while at < rings.len() {
            let area: f64 = rings[at..at + parts].iter().map(|ring| signed_area(ring, flat)).sum();
            let is_used = 0.0 < area || (area < 0.0 && both_sides);
            for k in at..at + parts {
                if is_used {
                    if area < 0.0 {
                        rings[k].reverse();
                    }
                    rings.swap(kept, k);
                    kept += 1;
                }
            }
            at += parts;
        }
        rings.truncate(kept);
    }
    rings
}

fn signed_area(ring: &[u32], flat: &[DVec2]) -> f64 {
    let at = |i: usize| flat[ring[i] as usize] - flat[ring[0] as usize];
    (1..ring.len().saturating_sub(1)).map(|i| at(i).perp_dot(at(i + 1))).sum()
}
