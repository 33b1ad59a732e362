//! The sources of components: the sides of a box, a mesh, or edges and points.

use std::ops::ControlFlow;

use glam::DVec3;

use super::mesh_parts::MeshParts;
use super::select::{AxesOf, Sense, Subcomponent, Word};
use super::wire_parts::WireParts;
use super::{Align, Arm, Components, Mode};
use crate::comp::orientation::Orientation;
use crate::geometry::Axis;
use crate::run::env::Env;
use crate::shape::scope::Scope;
use crate::shape::unit::{UnitFace, UnitMesh};
use crate::shape::{Geometry, Shape};

/// A shape's components of one kind, by number.
#[derive(Debug)]
pub(super) enum ComponentSource {
    /// The faces of a box or a rectangle, used one by one.
    Quads(Quads),
    Mesh(Box<MeshParts>),
    Wire(Box<WireParts>),
}

impl ComponentSource {
    /// The components of a shape. `Break` when a limit is reached.
    #[inline]
    pub(super) fn of(
        env: &mut Env,
        shape: &Shape,
        components: Components,
        align: Align,
        arms: &[Arm],
    ) -> ControlFlow<(), Self> {
        let each = align == Align::ZUp && arms.iter().all(|arm| arm.mode == Mode::Each);
        if components == Components::Faces
            && each
            && let Some(quads) = Quads::of(shape)
        {
            return ControlFlow::Continue(ComponentSource::Quads(quads));
        }
        env.ask()?;
        if let Some(wire) = shape.to_wire() {
            return ControlFlow::Continue(ComponentSource::Wire(Box::new(WireParts::new(wire, components))));
        }
        if let Geometry::Mesh(placed) = &shape.geometry {
            // Computed on the mesh itself, the adjacency is available to all its copies.
            let alone = components == Components::Faces && arms.iter().all(|arm| arm.looks_only());
            if !alone && placed.mesh.adjacency_in_time().is_none() {
                env.spend(0)?;
            }
        }
        // Components inherit the implicit texture coordinates of the shape.
        let mesh = shape.own_mesh();
        env.count_vertices(&mesh)?;
        let parts = MeshParts::new(mesh, components, env.initial.as_meshes);
        ControlFlow::Continue(ComponentSource::Mesh(Box::new(parts)))
    }

    #[inline]
    pub(super) fn len(&self) -> usize {
        match self {
            ComponentSource::Quads(quads) => quads.len(),
            ComponentSource::Mesh(parts) => parts.len(),
            ComponentSource::Wire(parts) => parts.len(),
        }
    }

    /// Returns true if a word matches a component.
    #[inline]
    pub(super) fn is(&self, looks: &Orientation, number: usize, word: Word) -> bool {
        match self {
            ComponentSource::Quads(quads) => quads.is(looks, number, word),
            ComponentSource::Mesh(parts) => parts.is(looks, number, word),
            ComponentSource::Wire(parts) => parts.is(looks, number, word),
        }
    }

    /// Calls `bond` with the numbers of a component's edges or points. Components with a common number are connected.
    pub(super) fn bonds(&self, number: usize, bond: impl FnMut(u32)) {
        match self {
            ComponentSource::Quads(_) => {}
            ComponentSource::Mesh(parts) => parts.bonds(number, bond),
            ComponentSource::Wire(parts) => parts.bonds(number, bond),
        }
    }
}

/// The sides of a box, or the only one of a rectangle, that is neither flat nor inside out. They need no mesh, and
/// all their properties follow from the scope.
#[derive(Debug)]
pub(super) struct Quads {
    unit: UnitMesh,
}

impl Quads {
    #[inline]
    fn of(shape: &Shape) -> Option<Self> {
        let size = shape.scope.size;
        match shape.geometry {
            Geometry::Box(unit) if 0.0 < size.min_element() => Some(Quads { unit }),
            Geometry::Rect(across, unit) if (0..3).all(|at| at == across.index() || 0.0 < size[at]) => {
                Some(Quads { unit })
            }
            _ => None,
        }
    }

    #[inline]
    fn len(&self) -> usize {
        self.unit.face_count()
    }

    #[inline]
    fn face(&self, number: usize) -> &'static UnitFace {
        &self.unit.sides()[number]
    }

    /// The scope of a side, in a box or a rectangle with the scope `whole`: x along its first edge, z outwards.
    #[inline(always)]
    pub(super) fn scope(&self, whole: &Scope, number: usize) -> Scope {
        let (Scope { origin, axes, size }, face) = (*whole, self.face(number));
        let [width, height] = face.extent(size);
        let from = axes * (face.origin * size);
        Scope { origin: origin + from, axes: face.axes(&axes), size: DVec3::new(width, height, 0.0) }
    }

    #[inline]
    fn is(&self, looks: &Orientation, number: usize, word: Word) -> bool {
        match word.0 {
            Sense::All => true,
            Sense::Uv(_) | Sense::Shape | Sense::Remainder => false,
            Sense::Looks(AxesOf::Scope, direction) => direction.takes_side(self.face(number).side),
            Sense::Looks(axes, direction) => {
                let normal = self.face(number).side.normal();
                looks.takes_at(axes, direction, normal, || self.scope(&looks.scope, number).centre())
            }
            // A rectangle has no neighbours.
            Sense::Border(border) => border == self.is_rectangle(),
            Sense::Roof(_) => false,
        }
    }

    /// Returns true if a tag of a side matches, or a tag of a neighbour.
    pub(super) fn tagged(&self, number: usize, of: Option<Subcomponent>, query: &str) -> bool {
        if of.is_none() {
            return self.face(number).is_tagged(query);
        }
        // Opposite sides of a box share no edge and no vertex.
        let behind = -self.face(number).side.normal();
        self.unit.faces().iter().any(|face| face.side.normal() != behind && face.is_tagged(query))
    }

    /// A side alone.
    #[inline]
    pub(super) fn alone(&self, number: usize) -> Geometry {
        Geometry::Rect(Axis::Z, UnitMesh::face(Axis::Z, self.face(number).provenance))
    }

    /// Returns true if it is one face, without neighbours.
    #[inline]
    pub(super) fn is_rectangle(&self) -> bool {
        self.len() == 1
    }
}
