//! The component split: which face goes to which arm, and the shapes they make.

pub mod faces;
pub mod frame;
pub mod select;

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::derive::Cx;
use crate::env::Env;
use crate::mesh::Mesh;
use crate::place;
use crate::scope::{Axis, Frame, Scope};
use crate::seed::{Seed, Tag};
use crate::shape::{Counter, Geometry, Placed, ShapeRef};
use crate::sink::{Flow, Quad, Sink};
use frame::FaceFrame;
use select::Select;

/// One `selector : …` or `selector = …` of a comp.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    /// Which components it takes.
    pub select: Select,
    /// One shape a component, or one for all.
    pub mode: Mode,
    /// `comp.sel`.
    pub text: &'static str,
}

/// The operator of an arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// `:`, one shape a component.
    Each,
    /// `=`, one shape for all.
    Together,
}

/// Divides a shape into its faces and calls `visit` with every part's arm and shape: arms in writing order, the faces of
/// each in the mesh's order (*comp operation*).
#[inline]
pub fn comp<S: Sink + ?Sized, C>(
    cx: &mut Cx<'_, S, C>,
    shape: &mut ShapeRef<'_>,
    arms: &[Arm],
    mut visit: impl FnMut(&mut Cx<'_, S, C>, u32, &mut ShapeRef<'_>) -> Flow,
) -> Flow {
    let parts = faces(&mut cx.env, shape, arms)?;
    parts.each(|arm, part| visit(cx, arm, part))
}

/// The faces of a shape, each given to an arm, ready to be handed out.
#[derive(Debug)]
struct Parts<'s> {
    parent: &'s ShapeRef<'s>,
    arms: &'s [Arm],
    owners: Owners,
    source: Source,
    seed: u64,
    ordinal: u32,
}

/// Where the faces come from.
#[derive(Debug)]
#[allow(clippy::large_enum_variant, reason = "the large one is the common one and must not allocate")]
enum Source {
    /// The faces of a box or a rectangle, in the world.
    Quads([Quad; 6]),
    /// The faces of a mesh in scope coordinates, with their frames; degenerate ones have none and are never selected.
    Mesh(Arc<Mesh>, Vec<Option<FaceFrame>>),
}

/// The arm that owns each face. Up to six need no allocation: `comp` of a box is the façade path.
#[derive(Debug)]
enum Owners {
    Few([Option<u16>; 6], usize),
    Many(Vec<Option<u16>>),
}

impl Owners {
    /// *comp operation*: arms from left to right, and what one has the next can't get.
    fn choose(arms: &[Arm], faces: impl ExactSizeIterator<Item = Option<DVec3>>) -> Self {
        let count = faces.len();
        let owners = faces.enumerate().map(|(index, normal)| {
            let arm = arms.iter().position(|arm| normal.is_some_and(|normal| arm.select.takes(index, normal)));
            arm.map(|arm| arm as u16)
        });
        if count <= 6 {
            let mut few = [None; 6];
            few.iter_mut().zip(owners).for_each(|(slot, owner)| *slot = owner);
            Owners::Few(few, count)
        } else {
            Owners::Many(owners.collect())
        }
    }

    fn list(&self) -> &[Option<u16>] {
        match self {
            Owners::Few(list, count) => &list[..*count],
            Owners::Many(list) => list,
        }
    }
}

/// Gives every face of `shape` to the first arm that selects it. `Break` when a limit was reached.
fn faces<'s>(env: &mut Env, shape: &'s mut ShapeRef<'_>, arms: &'s [Arm]) -> ControlFlow<(), Parts<'s>> {
    for arm in arms {
        if let Select::Index(number) = arm.select {
            env.finite(number, "an index of `comp`");
        }
    }
    let (source, owners) = match simple(shape, arms) {
        Some((quads, count)) => {
            let to_scope = shape.scope.axes.transpose();
            let normals = quads[..count].iter().map(|quad| quad.u.cross(quad.v).normalize_or_zero());
            let normals = normals.map(|normal| Some(to_scope * normal));
            let owners = Owners::choose(arms, normals);
            (Source::Quads(quads), owners)
        }
        None => {
            let mesh = shape.to_mesh();
            env.count_vertices(&mesh)?;
            let outwards = outwards(shape.scope.size);
            let frames: Vec<_> = (0..mesh.face_count()).map(|face| frame::face_frame(&mesh, face)).collect();
            let normals = frames.iter().map(|frame| frame.as_ref().map(|frame| frame.frame.axes.z_axis * outwards));
            let owners = Owners::choose(arms, normals);
            (Source::Mesh(mesh, frames), owners)
        }
    };
    let ordinal = shape.seed.reserve(owners.list().len().min(u32::MAX as usize) as u32);
    ControlFlow::Continue(Parts { seed: shape.seed.value(), parent: shape, arms, owners, source, ordinal })
}

/// The sign that makes selectors see a shape as if it were not mirrored: a negative size turns its faces inside out, and
/// what a selector means is where they are, not where they look (*CGA changelog 2010.3*).
pub(crate) fn outwards(size: DVec3) -> f64 {
    if (0..3).filter(|&axis| size[axis] < 0.0).count() % 2 == 1 { -1.0 } else { 1.0 }
}

/// The faces of a shape that needs no mesh: a box or rectangle that is neither flat nor inside out, handed out one by one.
#[inline]
fn simple(shape: &ShapeRef<'_>, arms: &[Arm]) -> Option<([Quad; 6], usize)> {
    let size = shape.scope.size;
    let nothing = Quad { origin: DVec3::ZERO, u: DVec3::ZERO, v: DVec3::ZERO };
    if arms.iter().any(|arm| arm.mode == Mode::Together) {
        return None;
    }
    match shape.geometry {
        Geometry::Box if 0.0 < size.min_element() => Some((place::cuboid(&shape.scope).faces(), 6)),
        Geometry::Rect(axis) if (0..3).all(|at| at == axis.index() || 0.0 < size[at]) => {
            let mut quads = [nothing; 6];
            quads[0] = place::rect(&shape.scope, axis);
            Some((quads, 1))
        }
        _ => None,
    }
}

impl<'s> Parts<'s> {
    #[inline]
    fn each(&self, mut visit: impl FnMut(u32, &mut ShapeRef<'s>) -> Flow) -> Flow {
        let owners = self.owners.list();
        for (number, arm) in self.arms.iter().enumerate() {
            let mine = |owner: &&Option<u16>| **owner == Some(number as u16);
            let total = owners.iter().filter(mine).count();
            let selected = || (0..owners.len()).filter(|&face| owners[face] == Some(number as u16));
            match arm.mode {
                Mode::Each => {
                    for (index, face) in selected().enumerate() {
                        visit(number as u32, &mut self.part(arm, face, Counter::new(index, total), None))?;
                    }
                }
                Mode::Together => {
                    // *comp operation*: set up from the first selected component.
                    if let Some(first) = selected().next() {
                        let all: Vec<u32> = selected().map(|face| face as u32).collect();
                        visit(number as u32, &mut self.part(arm, first, Counter::new(0, 1), Some(&all)))?;
                    }
                }
            }
        }
        Flow::Continue(())
    }

    #[inline]
    fn part(&self, arm: &Arm, face: usize, comp: Counter, all: Option<&[u32]>) -> ShapeRef<'s> {
        let parent = self.parent;
        let (scope, pivot, geometry) = match &self.source {
            Source::Quads(quads) => {
                let scope = quad_scope(&quads[face]);
                (scope, scope.frame(), Geometry::Rect(Axis::Z))
            }
            Source::Mesh(mesh, frames) => match (&frames[face], all) {
                (Some(frame), Some(all)) => mesh_scope(parent, mesh, &frame.frame, all),
                (Some(frame), None) if frame.rectangle => {
                    let pivot = in_world(&parent.scope, &frame.frame);
                    let size = (frame.high - frame.low).extend(0.0);
                    (Scope { origin: pivot.origin, axes: pivot.axes, size }, pivot, Geometry::Rect(Axis::Z))
                }
                (Some(frame), None) => mesh_scope(parent, mesh, &frame.frame, &[face as u32]),
                // Never selected; see `Source::Mesh`.
                (None, _) => (parent.scope, parent.pivot, Geometry::Empty),
            },
        };
        ShapeRef {
            scope,
            pivot,
            geometry,
            seed: Seed::child(self.seed, Tag::Comp, self.ordinal.wrapping_add(face as u32)),
            split: parent.split,
            comp,
            selector: arm.text,
            state: parent.state.lend(),
        }
    }
}

/// The scope of a rectangular face: x along its first side, z outwards.
#[inline]
fn quad_scope(quad: &Quad) -> Scope {
    let (width, height) = (quad.u.length(), quad.v.length());
    let (x, y) = (quad.u / width, quad.v / height);
    Scope { origin: quad.origin, axes: DMat3::from_cols(x, y, x.cross(y)), size: DVec3::new(width, height, 0.0) }
}

/// Scope, pivot and geometry of some faces of a mesh, set up in the frame of the first.
fn mesh_scope(parent: &ShapeRef<'_>, mesh: &Mesh, frame: &Frame, selected: &[u32]) -> (Scope, Frame, Geometry) {
    let placed = Placed::fitted(faces::extract(mesh, selected, frame));
    let pivot = in_world(&parent.scope, frame);
    let scope = Scope { origin: pivot.to_world(placed.low), axes: pivot.axes, size: placed.size };
    (scope, pivot, Geometry::Mesh(Arc::new(placed)))
}

fn in_world(scope: &Scope, local: &Frame) -> Frame {
    Frame { origin: scope.frame().to_world(local.origin), axes: scope.axes * local.axes }
}
