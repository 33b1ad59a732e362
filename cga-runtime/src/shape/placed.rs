//! Geometry with the box in its own coordinates that the scope stretches.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use super::unit::UnitMesh;
use crate::geometry::mesh::{Bounds, Mesh};
use crate::geometry::tol::ANGLE_EPSILON;
use crate::geometry::wire::Wire;

/// The state of geometry since its insertion (*geometry.isInstanced function*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Inserted {
    /// It was not inserted, or it has changed since.
    No,
    /// A box or a rectangle. Sinks get its mesh like any other mesh.
    Plain,
    /// An asset or a primitive with a mesh of its own. Sinks get it as an instance.
    Asset,
}

/// A mesh, and the box in its own coordinates that the scope stretches.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    pub(crate) mesh: Arc<Mesh>,
    pub(crate) low: DVec3,
    pub(crate) size: DVec3,
    pub(crate) inserted: Inserted,
    /// True if the mesh itself is mirrored, so that a negative size of the scope mirrors it back.
    pub(crate) mirrored: bool,
}

impl Placed {
    /// A mesh in scope coordinates, with its bounding box.
    pub(crate) fn fitted(mesh: impl Into<Arc<Mesh>>) -> Self {
        let (low, size) = (DVec3::ZERO, DVec3::ZERO);
        let mut placed = Placed { mesh: mesh.into(), low, size, inserted: Inserted::No, mirrored: false };
        placed.fit(placed.mesh.bounds());
        placed
    }

    /// Fits the box to a mesh with these bounds.
    #[inline]
    pub(crate) fn fit(&mut self, bounds: Bounds) {
        self.low = if bounds.low.is_finite() { bounds.low } else { DVec3::ZERO };
        self.size = bounds.size();
    }

    /// The same, after rounding errors along an axis are removed.
    pub(crate) fn flattened(mesh: Mesh) -> Self {
        let placed = Placed::fitted(mesh);
        match flattened(placed.mesh.points(), placed.low, placed.size) {
            Some(points) => Placed::fitted(placed.mesh.with_points(points)),
            None => placed,
        }
    }

    /// The mesh of a box or a rectangle.
    pub(crate) fn unit(unit: UnitMesh) -> Self {
        let inserted = if unit.is_inserted() { Inserted::Plain } else { Inserted::No };
        Placed { inserted, ..Placed::fitted(unit.mesh().clone()) }
    }

    /// The factor from mesh lengths to scope lengths, for each axis.
    pub(crate) fn stretch(&self, size: DVec3) -> DVec3 {
        stretch(self.size, size)
    }

    /// The map from mesh coordinates to scope coordinates.
    pub(crate) fn to_scope(&self, size: DVec3) -> DAffine3 {
        let stretch = self.stretch(size);
        DAffine3 { matrix3: DMat3::from_diagonal(stretch), translation: -self.low * stretch }
    }
}

/// The factor from one size to another, for each axis.
fn stretch(from: DVec3, to: DVec3) -> DVec3 {
    let factor = |have: f64, want: f64| if have == want || have == 0.0 { 1.0 } else { want / have };
    DVec3::new(factor(from.x, to.x), factor(from.y, to.y), factor(from.z, to.z))
}

/// A wire, and the box in its own coordinates that the scope stretches.
#[derive(Clone, Debug)]
pub(crate) struct PlacedWire {
    pub(crate) wire: Wire,
    pub(crate) low: DVec3,
    pub(crate) size: DVec3,
}

impl PlacedWire {
    /// A wire in scope coordinates, with its bounding box.
    pub(crate) fn fitted(wire: Wire) -> Self {
        let bounds = Bounds::of(wire.points.iter().copied());
        let low = if bounds.low.is_finite() { bounds.low } else { DVec3::ZERO };
        PlacedWire { low, size: bounds.size(), wire }
    }

    /// The same, after rounding errors along an axis are removed.
    pub(crate) fn flattened(wire: Wire) -> Self {
        let placed = PlacedWire::fitted(wire);
        match flattened(&placed.wire.points, placed.low, placed.size) {
            Some(points) => PlacedWire::fitted(Wire { points, ..placed.wire }),
            None => placed,
        }
    }

    /// The wire in scope coordinates.
    pub(crate) fn in_scope(&self, size: DVec3) -> Wire {
        let stretch = stretch(self.size, size);
        self.wire.stretched(stretch, -self.low * stretch)
    }
}

/// Points that are flat along an axis except for rounding, made flat, because rules and operations test for sizes of zero. `None` if
/// no axis needs it.
fn flattened(points: &[DVec3], low: DVec3, size: DVec3) -> Option<Vec<DVec3>> {
    let flat = size.cmple(DVec3::splat(ANGLE_EPSILON * size.max_element())) & size.cmpgt(DVec3::ZERO);
    (size.is_finite() && flat.any()).then(|| points.iter().map(|&p| DVec3::select(flat, low, p)).collect())
}
