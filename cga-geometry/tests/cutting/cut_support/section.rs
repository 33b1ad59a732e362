//! The areas of sections, computed without loops. Also used by `benches/cutting.rs`.

use cga_geometry::Axis;
use cga_geometry::glam::{DVec2, DVec3};
use cga_geometry::mesh::Mesh;

/// The area of the section of a closed mesh by a plane, for faces without holes. Green's formula over the lines of
/// the section needs no loops. Points in the plane count as above it.
pub(crate) fn section(mesh: &Mesh, axis: Axis, at: f64) -> f64 {
    let index = axis.index();
    let mut sum = 0.0;
    for face in mesh.faces() {
        let ring: Vec<DVec3> = face.outer().iter().map(|&point| mesh.points()[point as usize]).collect();
        let mut ends = [None; 2];
        for (i, &a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            if (a[index] < at) != (b[index] < at) {
                let p = a + (b - a) * ((at - a[index]) / (b[index] - a[index]));
                ends[usize::from(a[index] < at)] = Some(DVec2::new(p[(index + 1) % 3], p[(index + 2) % 3]));
            }
        }
        if let [Some(from), Some(to)] = ends {
            sum += from.perp_dot(to);
        }
    }
    (sum / 2.0).abs()
}
