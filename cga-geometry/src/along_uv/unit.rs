//! An asset stretched to one cell of texture space, as convex polygons.

use std::ops::Range;

use glam::{DVec2, DVec3};

use super::{AlongUv, HeightAlignment};
use crate::mesh::Mesh;
use crate::nesting::extent::Extent;
use crate::tol::PLANAR_EPSILON;
use crate::triangulate::Triangulator;

/// The polygons of an asset.
pub(super) struct UnitAsset {
    /// For each corner of the asset u and v in [0, 1] as x and y, and the height in metres as z.
    points: Vec<DVec3>,
    /// Corners of the asset, polygon after polygon.
    pub(super) corners: Vec<u32>,
    pub(super) polygons: Vec<AssetPolygon>,
}

/// A convex polygon of an asset.
pub(super) struct AssetPolygon {
    /// The face that it is a part of.
    pub(super) face: usize,
    corners: Range<usize>,
    /// The smallest and the largest coordinates.
    pub(super) extent: Extent,
}

impl UnitAsset {
    pub(super) fn of(asset: &Mesh, options: &AlongUv) -> Self {
        let bounds = asset.bounds();
        // The difference of the largest numbers overflows; the difference of their halves does not.
        let (low, size) = (bounds.low * 0.5, bounds.high * 0.5 - bounds.low * 0.5);
        let share = |at: f64, axis: usize| match size[axis] {
            0.0 => 0.5,
            size => ((at * 0.5 - low[axis]) / size).clamp(0.0, 1.0),
        };
        let height = |y: f64| match options.alignment {
            HeightAlignment::AlignPosition if size.y == 0.0 => 0.0,
            HeightAlignment::AlignPosition => share(y, 1) * options.height,
            HeightAlignment::KeepPosition if size.y == 0.0 => y,
            HeightAlignment::KeepPosition => y * 0.5 / size.y * options.height,
        };
        let place = |p: &DVec3| DVec3::new(share(p.x, 0), 1.0 - share(p.z, 2), height(p.y));
        let points = asset.corners.iter().map(|&point| place(&asset.points[point as usize])).collect();
        let mut unit = UnitAsset { points, corners: Vec::new(), polygons: Vec::new() };
        let (mut triangulator, mut triangles) = (Triangulator::new(), Vec::new());
        for face in asset.faces() {
            let is_simple = face.corner_count() == 3 || face.loops().len() == 1 && is_flat(asset, face.index());
            if is_simple && face.is_convex() {
                unit.add(face.index(), face.corner_range().map(|corner| corner as u32));
                continue;
            }
            triangles.clear();
            triangulator.face(asset, face.index(), &mut triangles);
            triangles.iter().for_each(|triangle| unit.add(face.index(), triangle.iter().copied()));
        }
        unit
    }

    fn add(&mut self, face: usize, corners: impl Iterator<Item = u32>) {
        let start = self.corners.len();
        self.corners.extend(corners);
        let corners = start..self.corners.len();
        let extent = Extent::of(self.corners[start..].iter().map(|&corner| self.points[corner as usize].truncate()));
        self.polygons.push(AssetPolygon { face, corners, extent });
    }

    /// The corners of a polygon: corners of the asset, and their positions in a cell that begins at `cell`.
    pub(super) fn corners(&self, polygon: &AssetPolygon, cell: DVec2) -> impl Iterator<Item = (u32, DVec3)> {
        let corners = self.corners[polygon.corners.clone()].iter();
        corners.map(move |&corner| (corner, self.points[corner as usize] + cell.extend(0.0)))
    }
}

/// Returns true if the corners of a face are in its plane.
fn is_flat(asset: &Mesh, face: usize) -> bool {
    let face = asset.face(face);
    let (normal, mut outline) = (face.normal(), face.outline());
    let Some(from) = outline.next() else { return false };
    outline.all(|point| (point - from).dot(normal).abs() <= PLANAR_EPSILON * (point - from).length())
}
