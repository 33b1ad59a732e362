//! Arbitrary bytes as a glTF file.
#![allow(unreachable_pub)]

use cga_runtime::asset::gltf::read_gltf;
use cga_runtime::geometry::mesh::Flaw;

/// Reads a file whose buffers and images in other files contain the same bytes. It may be refused. A mesh that is read
/// has only the flaws that any file may have, and contains finite numbers.
pub fn check(bytes: &[u8]) {
    let given = bytes.to_vec();
    let Ok(file) = read_gltf(bytes, &mut |_| Some(given.clone())) else { return };
    let flaws = file.mesh.check();
    let known = |flaw: &Flaw| matches!(flaw, Flaw::NotPlanar { .. } | Flaw::Hole { .. });
    assert!(flaws.iter().all(known), "{flaws:?}");
    assert!(file.mesh.points().iter().all(|point| point.is_finite()));
    assert!(file.mesh.normals().iter().all(|normal| normal.is_normalized()));
}
