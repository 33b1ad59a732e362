//! Arbitrary bytes as an OBJ file.
#![allow(unreachable_pub)]

use std::sync::Arc;

use cga_runtime::asset::obj::read_obj;
use cga_runtime::geometry::Axis;
use cga_runtime::geometry::cut::slabs;
use cga_runtime::geometry::mesh::Flaw;

/// Reads a file whose material libraries contain the same bytes. It may be refused. A mesh that is read has only the
/// flaws that any file may have, contains finite numbers, and can be cut.
pub fn check(bytes: &[u8]) {
    let given = bytes.to_vec();
    let Ok(file) = read_obj(bytes, &mut |_| Some(given.clone())) else { return };
    let flaws = file.mesh.check();
    let known = |flaw: &Flaw| matches!(flaw, Flaw::NotPlanar { .. } | Flaw::Hole { .. });
    assert!(flaws.iter().all(known), "{flaws:?}");
    assert!(file.mesh.points().iter().all(|point| point.is_finite()));
    let mesh = Arc::new(file.mesh);
    let bounds = mesh.bounds();
    if !mesh.is_empty() {
        let middle = bounds.low.y * 0.5 + bounds.high.y * 0.5;
        let parts = slabs(&mesh, Axis::Y, &[middle]).parts;
        assert!(parts.iter().flatten().all(|part| part.points().iter().all(|point| point.is_finite())));
    }
}
