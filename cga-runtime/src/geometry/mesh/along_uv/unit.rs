//! An asset stretched to one cell of texture space, as convex polygons.

use std::ops::Range;

use glam::{DVec2, DVec3};

use super::{AlongUv, HeightAlignment};
use crate::geometry::mesh::Mesh;
use crate::geometry::tol::PLANAR_EPSILON;
use crate::geometry::triangulate::Triangulator;

/// The polygons of an asset. Its points have u and v in [0, 1] as x and y, and the height in metres as z.
pub(super) struct UnitAsset {
    points: Vec<DVec3>,
    /// Corners of the asset, polygon after polygon.
    corners: Vec<u32>,
    /// The end of each polygon in `corners`, and its face.
    polygons: Vec<(usize, usize)>,
    /// The smallest and the largest coordinates of each polygon.
    ranges: Vec<[DVec2; 2]>,
    /// The points of its corners.
    of_corner: Vec<u32>,
}

impl UnitAsset {
    pub(super) fn of(asset: &Mesh, options: &AlongUv) -> Self {
        let bounds = asset.bounds();
        // The difference of the largest numbers overflows; that of their halves does not.
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
        let points = asset.points.iter().map(place).collect();
        let (mut corners, mut polygons) = (Vec::new(), Vec::new());
        let (mut triangulator, mut triangles) = (Triangulator::new(), Vec::new());
        for face in asset.faces() {
            let is_simple = face.corner_count() == 3 || face.loops().len() == 1 && is_flat(asset, face.index());
            if is_simple && face.is_convex() {
                corners.extend(face.corner_range().map(|corner| corner as u32));
                polygons.push((corners.len(), face.index()));
                continue;
            }
            triangles.clear();
            triangulator.face(asset, face.index(), &mut triangles);
            for triangle in &triangles {
                corners.extend(triangle);
                polygons.push((corners.len(), face.index()));
            }
        }
        let mut unit = UnitAsset { points, corners, polygons, ranges: Vec::new(), of_corner: asset.corners.clone() };
        let range = |polygon: usize| {
            let none = [DVec2::INFINITY, DVec2::NEG_INFINITY];
            let places = unit.corners(polygon).iter().map(|&corner| unit.at(corner, DVec2::ZERO).truncate());
            places.fold(none, |[low, high], uv| [low.min(uv), high.max(uv)])
        };
        unit.ranges = unit.polygons().map(range).collect();
        unit
    }

    /// The smallest and the largest coordinates of a polygon in a cell.
    pub(super) fn range(&self, polygon: usize, cell: DVec2) -> [DVec2; 2] {
        self.ranges[polygon].map(|uv| uv + cell)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.polygons.is_empty()
    }

    pub(super) fn corner_count(&self) -> usize {
        self.corners.len()
    }

    /// The numbers of all polygons.
    pub(super) fn polygons(&self) -> Range<usize> {
        0..self.polygons.len()
    }

    /// The face that a polygon is a part of.
    pub(super) fn face(&self, polygon: usize) -> usize {
        self.polygons[polygon].1
    }

    /// The corners of a polygon, as corners of the asset.
    pub(super) fn corners(&self, polygon: usize) -> &[u32] {
        let start = if polygon == 0 { 0 } else { self.polygons[polygon - 1].0 };
        &self.corners[start..self.polygons[polygon].0]
    }

    /// The position of a corner in a cell that begins at `cell`.
    pub(super) fn at(&self, corner: u32, cell: DVec2) -> DVec3 {
        self.points[self.of_corner[corner as usize] as usize] + cell.extend(0.0)
    }
}

/// Returns true if the corners of a face are in its plane.
fn is_flat(asset: &Mesh, face: usize) -> bool {
    let face = asset.face(face);
    let (normal, mut outline) = (face.normal(), face.outline());
    let Some(from) = outline.next() else { return false };
    outline.all(|point| (point - from).dot(normal).abs() <= PLANAR_EPSILON * (point - from).length())
}
