//! What a comp divides: the sides of a box, a mesh, or edges and points.

use std::ops::ControlFlow;

use glam::DVec3;

use super::candidate::Subcomponent;
use super::looks::Looks;
use super::mesh_parts::MeshParts;
use super::select::{Sense, Word};
use super::wire_parts::WireParts;
use super::{Align, Arm, Components, Mode};
use crate::env::Env;
use crate::mesh::tag_matches;
use crate::place;
use crate::shape::{Geometry, ShapeRef};
use crate::side::{EXTRUDED, Sides};
use crate::sink::Quad;
use crate::wire::Wire;

/// A shape's components of one kind, by number.
#[derive(Debug)]
#[allow(clippy::large_enum_variant, reason = "the large one is the common one and must not allocate")]
pub(super) enum Source {
    /// The faces of a box or a rectangle, handed out one by one.
    Quads(Quads),
    Mesh(MeshParts),
    Wire(WireParts),
}

impl Source {
    /// Of a shape. `Break` when a limit was reached.
    #[inline]
    pub(super) fn of(
        env: &mut Env,
        shape: &ShapeRef<'_>,
        components: Components,
        align: Align,
        arms: &[Arm],
    ) -> ControlFlow<(), Self> {
        let each = align == Align::ZUp && arms.iter().all(|arm| arm.mode == Mode::Each);
        if components == Components::Faces
            && each
            && let Some(quads) = Quads::of(shape)
        {
            return ControlFlow::Continue(Source::Quads(quads));
        }
        let wire = match &shape.geometry {
            Geometry::Wire(placed) => placed.in_scope(shape.scope.size),
            Geometry::Edge => Wire::edge(shape.scope.size.x),
            Geometry::Vertex => Wire::point(),
            geometry => {
                if let Geometry::Mesh(placed) = geometry {
                    // Found on the mesh itself, what is next to what is there for all its copies.
                    let alone = components == Components::Faces && arms.iter().all(|arm| arm.looks_only());
                    (!alone).then(|| placed.mesh.adjacency());
                }
                let mesh = shape.to_mesh();
                env.count_vertices(&mesh)?;
                return ControlFlow::Continue(Source::Mesh(MeshParts::new(mesh, components)));
            }
        };
        ControlFlow::Continue(Source::Wire(WireParts::new(wire, components)))
    }

    #[inline]
    pub(super) fn len(&self) -> usize {
        match self {
            Source::Quads(quads) => quads.count,
            Source::Mesh(parts) => parts.len(),
            Source::Wire(parts) => parts.len(),
        }
    }

    /// Whether a word takes a component.
    #[inline]
    pub(super) fn is(&self, looks: &Looks, number: usize, word: Word) -> bool {
        match self {
            Source::Quads(quads) => quads.is(looks, number, word),
            Source::Mesh(parts) => parts.is(looks, number, word),
            Source::Wire(parts) => parts.is(looks, number, word),
        }
    }

    /// Calls with the numbers of what a component has: those that have one in common are connected.
    pub(super) fn bonds(&self, number: usize, bond: impl FnMut(u32)) {
        match self {
            Source::Quads(_) => {}
            Source::Mesh(parts) => parts.bonds(number, bond),
            Source::Wire(parts) => parts.bonds(number, bond),
        }
    }
}

/// Sides of a box, or the one of a rectangle, that is neither flat nor turned inside out.
#[derive(Debug)]
pub(super) struct Quads {
    pub(super) list: [Quad; 6],
    count: usize,
    /// Outwards, in scope axes.
    normals: [DVec3; 6],
    sides: Sides,
}

impl Quads {
    #[inline]
    fn of(shape: &ShapeRef<'_>) -> Option<Self> {
        let size = shape.scope.size;
        let (list, count) = match shape.geometry {
            Geometry::Box(_) if 0.0 < size.min_element() => (place::cuboid(&shape.scope).faces(), 6),
            Geometry::Rect(axis) if (0..3).all(|at| at == axis.index() || 0.0 < size[at]) => {
                (std::array::from_fn(|_| place::rect(&shape.scope, axis)), 1)
            }
            _ => return None,
        };
        let to_scope = shape.scope.axes.transpose();
        let normals =
            std::array::from_fn(|side: usize| to_scope * list[side].u.cross(list[side].v).normalize_or_zero());
        let sides = if let Geometry::Box(sides) = shape.geometry { sides } else { Sides::PLAIN };
        Some(Quads { list, count, normals, sides })
    }

    #[inline]
    fn is(&self, looks: &Looks, number: usize, word: Word) -> bool {
        match word.sense() {
            Sense::All => true,
            Sense::Looks(axes, direction) => {
                let quad = &self.list[number];
                looks.takes_at(axes, direction, self.normals[number], || quad.origin + (quad.u + quad.v) * 0.5)
            }
            // A rectangle alone has no neighbours.
            Sense::Border(border) => border == (self.count == 1),
            Sense::Roof(_) => false,
        }
    }

    /// Whether a tag of a side is found, or of one beside it.
    pub(super) fn tagged(&self, number: usize, of: Option<Subcomponent>, query: &str) -> bool {
        let has = |side: usize| self.sides.tag(side).is_some_and(|tag| tag_matches(query, EXTRUDED[tag]));
        // Opposite sides of a box share no edge and no vertex.
        const OPPOSITE: [usize; 6] = [2, 3, 0, 1, 5, 4];
        if of.is_none() { has(number) } else { (0..6).any(|side| side != OPPOSITE[number] && has(side)) }
    }

    /// Whether the faces have neighbours.
    pub(super) fn are_sides(&self) -> bool {
        self.count == 6
    }
}
