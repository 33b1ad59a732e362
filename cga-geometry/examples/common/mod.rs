//! The mesh of an example: from a file, or a body with bumps.

use std::env;
use std::error::Error;
use std::fs;

use cga_geometry::glam::DVec3;
use cga_geometry::mesh::{Mesh, MeshBuilder, MeshError};
use cga_geometry::obj;
use cga_geometry::rotation::sin_cos;

/// The mesh in the file of the first argument, or a body with bumps without arguments; and the path of the second argument, or
/// `output`.
pub(crate) fn mesh_and_path(output: &str) -> Result<(Mesh, String), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let mesh = match arguments.next() {
        Some(path) => {
            let file = obj::read(&fs::read(&path)?)?;
            file.warnings.finish().iter().for_each(|warning| println!("{path}: {warning}"));
            file.mesh
        }
        None => bumps(72, 36)?,
    };
    Ok((mesh, arguments.next().unwrap_or_else(|| output.to_owned())))
}

/// A body about the origin whose radius waves around the y axis and from pole to pole, in triangles.
pub(crate) fn bumps(around: u32, across: u32) -> Result<Mesh, MeshError> {
    let mut builder = MeshBuilder::new();
    let mut ring = |j: u32| -> Vec<u32> {
        let (up, cos) = sin_cos(180.0 * f64::from(j) / f64::from(across) - 90.0);
        let point = |i: u32| {
            let degrees = 360.0 * f64::from(i) / f64::from(around);
            let ((sin_around, cos_around), wave) = (sin_cos(degrees), sin_cos(5.0 * degrees).0 * cos * cos);
            let radius = 10.0 + 1.5 * wave + 2.0 * up * up;
            builder.point(radius * DVec3::new(cos * cos_around, up, -cos * sin_around))
        };
        // All points of a pole are one.
        (0..=around).map(|i| i % around).map(point).collect()
    };
    let rings: Vec<Vec<u32>> = (0..=across).map(&mut ring).collect();
    for (below, above) in rings.iter().zip(&rings[1..]) {
        for i in 0..around as usize {
            let [a, b, c, d] = [below[i], below[i + 1], above[i + 1], above[i]];
            // At the poles one of the triangles has no area, and the builder drops it.
            builder.polygon(&[a, b, c]).polygon(&[a, c, d]);
        }
    }
    builder.build()
}
