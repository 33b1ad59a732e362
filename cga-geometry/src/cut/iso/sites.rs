//! The coordinate of each corner, and its class among the lines.
//!
//! A *site* is a point of the mesh with one value of the coordinate. Faces that agree at the point share the site; at a
//! seam a point has several sites.

use std::collections::BTreeMap;

use glam::DVec2;

use super::CORNER;
use super::coordinate::Coordinate;
use crate::cut::class::Class;
use crate::cut::points::{Location, NONE, PieceCorner};
use crate::mesh::Mesh;
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
        let mut others: BTreeMap<(u32, u64), u32> = BTreeMap::new();
        let mut values: Vec<f64> = Vec::with_capacity(mesh.points.len());
        let mut site_of = |(&point, uv): (&u32, &DVec2)| {
            let value = uv[coordinate.axis] + 0.0;
            let site = match &mut first[point as usize] {
                site if *site == NONE => site,
                site if values[*site as usize] == value => return *site,
                _ => others.entry((point, value.to_bits())).or_insert(NONE),
            };
            if *site == NONE {
                *site = values.len() as u32;
                values.push(value);
            }
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
