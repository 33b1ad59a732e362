//! The components of edges and points that have no faces.

use std::cell::RefCell;

use glam::DVec3;

use super::Components;
use super::found_tags::TagQueries;
use super::select::{Sense, Subcomponent, Word};
use crate::comp::orientation::Orientation;
use crate::geometry::Frame;
use crate::geometry::each::Each;
use crate::geometry::extrude_wire::point_normals;
use crate::geometry::face_frame::{along, beside, upright};
use crate::geometry::mesh::unit;
use crate::geometry::wire::Wire;

/// A wire in scope coordinates, with its components of one kind.
#[derive(Debug)]
pub(super) struct WireParts {
    wire: Wire,
    kind: Components,
    parts: Vec<WirePart>,
    queries: RefCell<TagQueries>,
}

/// A component of a wire.
#[derive(Debug)]
struct WirePart {
    /// The start of an edge, or the point.
    origin: DVec3,
    middle: DVec3,
    /// The direction along the edge; zero for points without an edge.
    along: DVec3,
    /// The direction of the component, of length 1.
    normal: DVec3,
}

impl WireParts {
    /// Edges of faces are the edges themselves, vertices of faces their ends, one after the other.
    pub(super) fn new(wire: Wire, kind: Components) -> Self {
        let part = |[origin, middle]: [DVec3; 2], along: DVec3, normal: DVec3| {
            let normal = if normal == DVec3::ZERO { upright(along) } else { normal };
            WirePart { origin, middle, along, normal }
        };
        let edges = || (0..wire.edges.len()).map(|edge| (wire.ends(edge), wire.normals[edge]));
        let parts = match kind {
            Components::Edges | Components::FaceEdges => {
                edges().map(|([a, b], normal)| part([a, (a + b) * 0.5], unit(b - a), normal)).collect()
            }
            Components::FaceVertices => {
                let ends =
                    |([a, b], normal): ([DVec3; 2], DVec3)| [a, b].each(|end| part([end; 2], unit(b - a), normal));
                edges().flat_map(ends).collect()
            }
            Components::Vertices => {
                let points = wire.points.iter().zip(point_normals(&wire));
                points.map(|(&point, normal)| part([point; 2], DVec3::ZERO, normal)).collect()
            }
            _ => Vec::new(),
        };
        WireParts { wire, kind, parts, queries: RefCell::default() }
    }

    pub(super) fn len(&self) -> usize {
        self.parts.len()
    }

    /// Returns true if a word matches a component. As there are no faces, all components are at the border.
    pub(super) fn is(&self, looks: &Orientation, index: usize, word: Word) -> bool {
        match word.0 {
            Sense::All => true,
            Sense::Uv(_) | Sense::Shape | Sense::Remainder => false,
            Sense::Border(border) => border,
            Sense::Roof(_) => false,
            Sense::Looks(axes, direction) => {
                let part = &self.parts[index];
                looks.takes(axes, direction, part.normal, || part.middle)
            }
        }
    }

    /// Returns true if a tag of a component matches. Edges pass their tags on to their vertices. If subcomponents are
    /// named, their tags are tested instead of the component's own (*comp operation*, isTagged).
    pub(super) fn tagged(&self, index: usize, of: Option<Subcomponent>, query: &str) -> bool {
        let Wire { tags, edges, points, .. } = &self.wire;
        if tags.is_empty() {
            return false;
        }
        let mut queries = self.queries.borrow_mut();
        let found = queries.found(query, &[], tags);
        let point = |point: u32| found.point(tags, points.len(), point);
        match self.kind {
            Components::Edges | Components::FaceEdges if of == Some(Subcomponent::Vertices) => {
                edges[index].into_iter().any(point)
            }
            Components::Edges | Components::FaceEdges => found.edge(tags, edges[index]),
            Components::FaceVertices => point(edges[index / 2][index % 2]),
            _ => point(index as u32),
        }
    }

    pub(super) fn frame(&self, index: usize) -> Frame {
        let WirePart { origin, along: edge, normal, .. } = self.parts[index];
        let x = if edge == DVec3::ZERO { beside(normal) } else { edge };
        Frame { origin, axes: along(x, normal) }
    }

    pub(super) fn wire(&self, indices: &[u32]) -> Wire {
        let parts = indices.iter().map(|&index| &self.parts[index as usize]);
        let normals = parts.clone().map(|part| part.normal).collect();
        if !matches!(self.kind, Components::Edges | Components::FaceEdges) {
            let point = |index: u32| match self.kind {
                Components::FaceVertices => self.wire.edges[index as usize / 2][index as usize % 2],
                _ => index,
            };
            let numbers: Vec<u32> = indices.iter().map(|index| point(*index)).collect();
            let points = parts.map(|part| part.origin).collect();
            return Wire::of_points(points, &self.wire.tags, &self.wire.trace, &numbers, normals);
        }
        let Wire { points, edges, tags, trace, .. } = &self.wire;
        Wire::of_edges(points, tags, trace, &mut indices.iter().map(|&index| edges[index as usize]), normals)
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
