//! The coordinate of each corner, and its class among the lines.
//!
//! A *site* is a point of the mesh with one value of the coordinate. Faces that agree at the point, up to rounding, share the site; at a
//! seam a point has several sites.

use std::collections::BTreeMap;

use glam::DVec2;

use super::CORNER;
use super::coordinate::Coordinate;
use crate::cut::class::Class;
use crate::cut::points::{Location, NONE, PieceCorner};
use crate::mesh::Mesh;
use crate::tol::NEXT_EPSILON;
use crate::work;

/// The corners that are read between two counts of work.
const BLOCK: usize = 1 << 10;

/// The sites of a mesh.
pub(super) struct Sites {
    of_corner: Vec<u32>,
    values: Vec<f64>,
    classes: Vec<Class>,
}

impl Sites {
    /// The sites of a mesh; `None` if the work is to end.
    pub(super) fn of(mesh: &Mesh, coordinate: Coordinate, lines: &[f64]) -> Option<Self> {
        let mut first = vec![NONE; mesh.points.len()];
        // The further values of points at seams.
        let mut others: BTreeMap<(u32, i64), u32> = BTreeMap::new();
        let mut values: Vec<f64> = Vec::with_capacity(mesh.points.len());
        let mut site_of = |(&point, uv): (&u32, &DVec2)| {
            let value = uv[coordinate.axis] + 0.0;
            let room = if value.is_finite() { value.abs().max(1.0) * NEXT_EPSILON } else { 0.0 };
            let own = &mut first[point as usize];
            if *own != NONE && (values[*own as usize] == value || (values[*own as usize] - value).abs() <= room) {
                return *own;
            }
            let site = if *own == NONE {
                own
            } else {
                let near = [value - room, value + room].map(|value| (point, ordered(value)));
                if let Some((_, site)) = others.range(near[0]..=near[1]).next() {
                    return *site;
                }
                others.entry((point, ordered(value))).or_insert(NONE)
            };
            *site = values.len() as u32;
            values.push(value);
            *site
        };
        let mut of_corner = Vec::with_capacity(mesh.corners.len());
        for (corners, uvs) in mesh.corners.chunks(BLOCK).zip(mesh.uv_set(coordinate.set).chunks(BLOCK)) {
            if !work::spend(CORNER * corners.len()) {
                return None;
            }
            of_corner.extend(corners.iter().zip(uvs).map(&mut site_of));
        }
        let classes = values.iter().map(|&value| Class::among(lines, value)).collect();
        Some(Sites { of_corner, values, classes })
    }

    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    /// The site of a corner.
    pub(super) fn site(&self, corner: usize) -> u32 {
        self.of_corner[corner]
    }

    /// The coordinate of a corner.
    pub(super) fn value(&self, corner: usize) -> f64 {
        self.values[self.of_corner[corner] as usize]
    }

    /// The class of a corner.
    pub(super) fn class(&self, corner: usize) -> Class {
        self.classes[self.of_corner[corner] as usize]
    }

    /// A corner as a corner of a piece.
    pub(super) fn node(&self, mesh: &Mesh, corner: usize) -> PieceCorner {
        PieceCorner::corner(corner, Location { class: self.class(corner), number: mesh.corners[corner] })
    }
}

/// A number with the order of [`f64::total_cmp`].
fn ordered(value: f64) -> i64 {
    let bits = value.to_bits() as i64;
    bits ^ ((bits >> 63) as u64 >> 1) as i64
}
