//! The components of edges and points that have no faces.

use glam::DVec3;

use super::Components;
use super::select::{Sense, Word};
use crate::comp::orientation::Looks;
use crate::geometry::Frame;
use crate::geometry::face_frame::{along, beside, upright};
use crate::geometry::mesh::{point_normals, unit};
use crate::geometry::wire::Wire;

/// A wire in scope coordinates, with its components of one kind.
#[derive(Debug)]
pub(super) struct WireParts {
    wire: Wire,
    kind: Components,
    /// The direction of each point: the mean of the edges that end there.
    points: Vec<DVec3>,
}

impl WireParts {
    pub(super) fn new(wire: Wire, kind: Components) -> Self {
        let points = point_normals(&wire);
        WireParts { wire, kind, points }
    }

    /// The number of components. Edges of faces are the edges themselves, vertices of faces their ends, one after the
    /// other.
    pub(super) fn len(&self) -> usize {
        match self.kind {
            Components::Edges | Components::FaceEdges => self.wire.edges.len(),
            Components::Vertices => self.wire.points.len(),
            Components::FaceVertices => 2 * self.wire.edges.len(),
            _ => 0,
        }
    }

    fn point(&self, index: usize) -> DVec3 {
        match self.kind {
            Components::FaceVertices => self.wire.ends(index / 2)[index % 2],
            _ => self.wire.points[index],
        }
    }

    /// The direction of a component, of length 1.
    fn normal(&self, index: usize) -> DVec3 {
        let own = match self.kind {
            Components::Edges | Components::FaceEdges => self.wire.normals[index],
            Components::FaceVertices => self.wire.normals[index / 2],
            _ => self.points[index],
        };
        if own == DVec3::ZERO { upright(self.along(index)) } else { own }
    }

    /// The direction along the edge; zero for points without an edge.
    fn along(&self, index: usize) -> DVec3 {
        let edge = match self.kind {
            Components::Edges | Components::FaceEdges => index,
            Components::FaceVertices => index / 2,
            _ => return DVec3::ZERO,
        };
        let [a, b] = self.wire.ends(edge);
        unit(b - a)
    }

    /// Returns true if a word matches a component. As there are no faces, all components are at the border.
    pub(super) fn is(&self, looks: &Looks, index: usize, word: Word) -> bool {
        match word.0 {
            Sense::All => true,
            Sense::Shape | Sense::Remainder => false,
            Sense::Border(border) => border,
            Sense::Roof(_) => false,
            Sense::Looks(axes, direction) => {
                let place = || match self.kind {
                    Components::Edges | Components::FaceEdges => self.wire.ends(index).iter().sum::<DVec3>() * 0.5,
                    _ => self.point(index),
                };
                looks.takes(axes, direction, self.normal(index), place)
            }
        }
    }

    pub(super) fn frame(&self, index: usize) -> Frame {
        let edge = self.along(index);
        let normal = self.normal(index);
        let x = if edge == DVec3::ZERO { beside(normal) } else { edge };
        let origin = match self.kind {
            Components::Edges | Components::FaceEdges => self.wire.ends(index)[0],
            _ => self.point(index),
        };
        Frame { origin, axes: along(x, normal) }
    }

    pub(super) fn wire(&self, indices: &[u32]) -> Wire {
        let indices = indices.iter().map(|&index| index as usize);
        let normals = indices.clone().map(|index| self.normal(index)).collect();
        if !matches!(self.kind, Components::Edges | Components::FaceEdges) {
            return Wire { points: indices.map(|index| self.point(index)).collect(), edges: Vec::new(), normals };
        }
        Wire::of_edges(&self.wire.points, indices.map(|index| self.wire.edges[index]), normals)
    }

    /// Calls `bond` with the points of a component. Components with a common point are connected.
    pub(super) fn bonds(&self, index: usize, bond: impl FnMut(u32)) {
        match self.kind {
            Components::Edges | Components::FaceEdges => self.wire.edges[index].into_iter().for_each(bond),
            Components::FaceVertices => std::iter::once(self.wire.edges[index / 2][index % 2]).for_each(bond),
            _ => std::iter::once(index as u32).for_each(bond),
        }
    }
}
