//! What a comp divides: the sides of a box, a mesh, or edges and points.

use std::ops::ControlFlow;

use glam::{DMat3, DVec3};

use super::candidate::Subcomponent;
use super::looks::Looks;
use super::mesh_parts::MeshParts;
use super::select::{Axes, Sense, Word};
use super::wire_parts::WireParts;
use super::{Align, Arm, Components, Mode};
use crate::env::Env;
use crate::mesh::tag_matches;
use crate::scope::{Axis, Scope};
use crate::shape::{Geometry, ShapeRef};
use crate::side::{Extruded, Sides};
use crate::wire::Wire;

/// A shape's components of one kind, by number.
#[derive(Debug)]
pub(super) enum Source {
    /// The faces of a box or a rectangle, handed out one by one.
    Quads(Quads),
    Mesh(Box<MeshParts>),
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
                return ControlFlow::Continue(Source::Mesh(Box::new(MeshParts::new(mesh, components))));
            }
        };
        ControlFlow::Continue(Source::Wire(WireParts::new(wire, components)))
    }

    #[inline]
    pub(super) fn len(&self) -> usize {
        match self {
            Source::Quads(quads) => quads.len(),
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

/// Sides of a box, or the one of a rectangle, that is neither flat nor turned inside out. They need no mesh, and all that is
/// asked of them follows from the scope.
#[derive(Debug)]
pub(super) struct Quads {
    scope: Scope,
    of: Of,
}

#[derive(Debug)]
enum Of {
    Box(Sides),
    /// Across an axis.
    Rectangle(Axis, Option<Extruded>),
}

/// Where the sides of a box look: front, right, back, left, top, bottom, as [`Cuboid::faces`](crate::sink::Cuboid::faces).
pub(super) const NORMALS: [DVec3; 6] = [DVec3::Z, DVec3::X, DVec3::NEG_Z, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y];

impl Quads {
    #[inline]
    fn of(shape: &ShapeRef<'_>) -> Option<Self> {
        let (scope, size) = (shape.scope, shape.scope.size);
        match shape.geometry {
            Geometry::Box(sides) if 0.0 < size.min_element() => Some(Quads { scope, of: Of::Box(sides) }),
            Geometry::Rect(axis, extruded) if (0..3).all(|at| at == axis.index() || 0.0 < size[at]) => {
                Some(Quads { scope, of: Of::Rectangle(axis, extruded) })
            }
            _ => None,
        }
    }

    #[inline]
    fn len(&self) -> usize {
        if self.is_rectangle() { 1 } else { 6 }
    }

    /// The side of a box that the only one of a rectangle looks like.
    #[inline]
    fn side_of(&self, number: usize) -> usize {
        match self.of {
            Of::Box(sides) => sides.side_of(number),
            Of::Rectangle(Axis::X, _) => 1,
            Of::Rectangle(Axis::Y, _) => 4,
            Of::Rectangle(Axis::Z, _) => 0,
        }
    }

    /// The scope of a side: x along its first edge, z outwards.
    #[inline(always)]
    pub(super) fn scope(&self, number: usize) -> Scope {
        let Scope { origin, axes, size } = self.scope;
        let [x, y, z] = [axes.x_axis, axes.y_axis, axes.z_axis];
        let (width, height, depth) = (size.x, size.y, size.z);
        // A rectangle lies at the low end of the axis that it looks along.
        let far = |axis: DVec3, by: f64| if self.is_rectangle() { DVec3::ZERO } else { axis * by };
        let (from, axes, size) = match self.side_of(number) {
            0 => (far(z, depth), [x, y, z], [width, height]),
            1 => (z * depth + far(x, width), [-z, y, x], [depth, height]),
            2 => (x * width, [-x, y, -z], [width, height]),
            3 => (DVec3::ZERO, [z, y, -x], [depth, height]),
            4 => (z * depth + far(y, height), [x, -z, y], [width, depth]),
            _ => (DVec3::ZERO, [x, z, -y], [width, depth]),
        };
        let [x, y, z] = axes;
        Scope { origin: origin + from, axes: DMat3::from_cols(x, y, z), size: DVec3::new(size[0], size[1], 0.0) }
    }

    #[inline]
    fn is(&self, looks: &Looks, number: usize, word: Word) -> bool {
        match word.sense() {
            Sense::All => true,
            Sense::Looks(Axes::Scope, direction) => direction.takes_side(self.side_of(number)),
            Sense::Looks(axes, direction) => {
                let normal = NORMALS[self.side_of(number)];
                looks.takes_at(axes, direction, normal, || self.scope(number).centre())
            }
            // A rectangle alone has no neighbours.
            Sense::Border(border) => border == self.is_rectangle(),
            Sense::Roof(_) => false,
        }
    }

    /// Whether a tag of a side is found, or of one beside it.
    pub(super) fn tagged(&self, number: usize, of: Option<Subcomponent>, query: &str) -> bool {
        let has = |side: usize| self.extruded(side).is_some_and(|extruded| tag_matches(query, extruded.tag()));
        if self.is_rectangle() {
            return has(0);
        }
        // Opposite sides of a box share no edge and no vertex.
        const OPPOSITE: [usize; 6] = [2, 3, 0, 1, 5, 4];
        if of.is_none() { has(number) } else { (0..6).any(|side| side != OPPOSITE[number] && has(side)) }
    }

    /// Where `extrude` made a face.
    #[inline]
    pub(super) fn extruded(&self, number: usize) -> Option<Extruded> {
        match self.of {
            Of::Rectangle(_, extruded) => extruded,
            Of::Box(sides) => sides.tag(sides.side_of(number)),
        }
    }

    /// Whether it is one face, without neighbours.
    #[inline]
    pub(super) fn is_rectangle(&self) -> bool {
        matches!(self.of, Of::Rectangle(..))
    }
}
