//! The faces of a mesh as shapes, one after the other. The next shape takes the place of the last one in memory.

use std::sync::Arc;

use super::mesh_parts::MeshParts;
use super::part::ComponentPart;
use super::source::ComponentSource;
use super::{Align, AssignedComponents, Components, Mode};
use crate::geometry::level_face::LevelFaces;
use crate::run::context::Cx;
use crate::run::sink::Flow;
use crate::shape::base::Base;
use crate::shape::trim::Trims;
use crate::shape::{Counter, Geometry, Placed, Shape, ShapeRef};

/// The faces of a mesh, and the memory for the next one.
struct NextFace<'m> {
    faces: LevelFaces<'m>,
    /// The last face that was a mesh.
    last: Option<Arc<Placed>>,
}

impl AssignedComponents<'_> {
    /// The mesh whose single faces are the parts of an arm, with coordinate systems of their own.
    pub(super) fn faces_of(&self, number: usize) -> Option<&MeshParts> {
        match &self.source {
            ComponentSource::Mesh(parts)
                if parts.kind == Components::Faces
                    && self.align == Align::ZUp
                    && self.arms[number].mode == Mode::Each =>
            {
                Some(parts)
            }
            _ => None,
        }
    }

    /// Calls `visit` with the shape of each face of an arm. Faces without an origin need no further step. `last` is the last face of an
    /// earlier arm that was a mesh.
    pub(super) fn each_face<C>(
        &self,
        parts: &MeshParts,
        number: usize,
        last: &mut Option<Arc<Placed>>,
        cx: &mut Cx<'_, C>,
        visit: &mut dyn FnMut(&mut Cx<'_, C>, u32, &ShapeRef<'_>) -> Flow,
    ) -> Flow {
        let mine = || self.owners.of(number as u16);
        let total = mine().count();
        let mut faces = mine().enumerate();
        let Some((_, first)) = faces.next() else { return Flow::Continue(()) };
        let mut next = NextFace { faces: LevelFaces::of(&parts.mesh), last: last.take() };
        let look = cx.env.look_id(self.parent.state.look());
        let mut base = Base::new(self.first_face(parts, number, (first, Counter::new(0, total)), &mut next), look);
        visit(cx, number as u32, &base.shape())?;
        for (index, face) in faces {
            base.change(|shape| self.put_face(parts, shape, number, (face, Counter::new(index, total)), &mut next));
            visit(cx, number as u32, &base.shape())?;
        }
        *last = base.into_mesh().or(next.last);
        Flow::Continue(())
    }

    /// The shape of the first face of an arm.
    fn first_face(
        &self,
        parts: &MeshParts,
        number: usize,
        (face, comp): (u32, Counter),
        next: &mut NextFace<'_>,
    ) -> Shape {
        let part = match parts.face_axes(face as usize) {
            Some(axes) => parts.face_part(&next.faces, &self.parent.scope, face as usize, &axes, &mut next.last),
            None => self.source.kept(self.parent, &[face], false),
        };
        let (arm, ComponentPart { scope, pivot, geometry }) = (&self.arms[number], part);
        self.shape(arm, comp, face, scope, pivot, geometry, self.own_trims(arm, face))
    }

    /// Makes the shape of a face of the shape of another face of the same arm, as [`AssignedComponents::part`] does.
    #[inline(always)]
    fn put_face(
        &self,
        parts: &MeshParts,
        shape: &mut Shape,
        number: usize,
        (face, comp): (u32, Counter),
        next: &mut NextFace<'_>,
    ) {
        if let Geometry::Mesh(placed) = std::mem::replace(&mut shape.geometry, Geometry::Empty) {
            next.last = Some(placed);
        }
        match parts.face_axes(face as usize) {
            Some(axes) => {
                let scope = &self.parent.scope;
                parts.face_part(&next.faces, scope, face as usize, &axes, &mut next.last).put_into(shape);
            }
            None => self.source.kept(self.parent, &[face], false).put_into(shape),
        }
        shape.seed = self.parent.seed.part(face, 0);
        shape.comp = comp;
        match (&self.parent.trims, &mut shape.trims) {
            (Trims::None, Trims::Face(_, known)) => *known = face,
            (own, trims) => {
                let planes = self.own_trims(&self.arms[number], face);
                *trims = own.with(&self.parent.pivot, planes, &shape.pivot);
            }
        }
    }
}
