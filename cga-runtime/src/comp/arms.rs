//! Operations with arms other than `comp`: they make faces, and each face goes to an arm.

use std::ops::ControlFlow;

use super::faces::{Faces, by_shape};
use super::select::Word;
use super::source::ComponentSource;
use super::{Align, Arm, AssignedComponents, Candidate, Components, Mode, Select, never};
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::seed::{self, Tag};
use crate::shape::{Shape, ShapeRef};

/// The condition of an arm, by number, for a component.
pub(crate) type ArmTest<'w> = dyn FnMut(&mut Env, u32, &mut Candidate<'_>) -> bool + 'w;

/// The arms of an operation, and the shape that it divides.
pub struct Arms<'a> {
    shape: &'a Shape,
    arms: &'a [Arm],
    when: &'a mut ArmTest<'a>,
}

impl<'a> Arms<'a> {
    pub(crate) fn new(shape: &'a Shape, arms: &'a [Arm], when: &'a mut ArmTest<'a>) -> Self {
        Arms { shape, arms, when }
    }

    /// The shape that is divided.
    pub fn shape(&self) -> &Shape {
        self.shape
    }

    /// The first arm that selects parts by that word.
    pub fn of(&self, word: Word) -> Option<u32> {
        self.arms.iter().position(|arm| arm.select == Select::Word(word)).map(|arm| arm as u32)
    }

    /// The first arm that selects each edge of each face, by corner, in the order of `comp(fe)`; indices wrap (*setback
    /// operation*). Selectors in texture space mean a set of coordinates. `Break` when a limit was reached.
    pub fn edges(&mut self, env: &mut Env, uv_set: usize) -> ControlFlow<(), Vec<Option<u32>>> {
        let count = self.shape.to_mesh().corners().len() as f64;
        let wrapped = |arm: &Arm| match arm.select {
            Select::Index(index) if index.is_finite() && 0.0 < count => {
                Arm { select: Select::Index(index.rem_euclid(count)), ..arm.clone() }
            }
            _ => arm.clone(),
        };
        let arms: Vec<Arm> = self.arms.iter().map(wrapped).collect();
        edges(env, self.shape, &arms, uv_set, &mut *self.when)
    }
}

/// The first word that selects each edge of each face of a shape, by corner.
pub(crate) fn face_edges(
    env: &mut Env,
    shape: &Shape,
    words: impl IntoIterator<Item = Word>,
) -> ControlFlow<(), Vec<Option<u32>>> {
    let arm = |word: Word| Arm { select: Select::Word(word), mode: Mode::Each, text: "".into() };
    let arms: Vec<Arm> = words.into_iter().map(arm).collect();
    edges(env, shape, &arms, 0, &mut never)
}

fn edges(
    env: &mut Env,
    shape: &Shape,
    arms: &[Arm],
    uv_set: usize,
    when: &mut ArmTest<'_>,
) -> ControlFlow<(), Vec<Option<u32>>> {
    let (kind, align) = (Components::FaceEdges, Align::ZUp);
    let mut source = ComponentSource::of(env, shape, kind, align, arms)?;
    if let ComponentSource::Mesh(parts) = &mut source {
        parts.uv_set = uv_set;
    }
    let parts = AssignedComponents::assigned(env, shape, kind, align, arms, when, source);
    let mut edges = vec![None; parts.owners.len()];
    for arm in 0..arms.len() {
        parts.owners.of(arm as u16).for_each(|edge| edges[edge as usize] = Some(arm as u32));
    }
    ControlFlow::Continue(edges)
}

/// Divides a shape into the faces that `make` gives, and calls `visit` with the arm and the shape of each part: arms in
/// writing order, the faces of an arm by number. Parts keep the pivot and the axes of the shape; their scopes fit their
/// geometry. `number` counts the children that the rule makes.
pub fn divide<C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    number: u32,
    arms: &[Arm],
    when: &mut ArmTest<'_>,
    make: impl FnOnce(&mut Env, &mut Arms<'_>) -> ControlFlow<(), Faces>,
    visit: &mut dyn FnMut(&mut Cx<'_, C>, u32, &ShapeRef<'_>) -> Flow,
) -> Flow {
    cx.env.ask()?;
    let mut whole = cx.env.whole(&shape.child(seed::key(Tag::Comp, number)));
    whole.bake();
    cx.env.divide_trace(&mut whole);
    let made = make(cx.env, &mut Arms::new(&whole, arms, when))?;
    cx.env.count_corners(made.mesh.corners().len() as u64)?;
    let by_arm = made.by_arm(arms.len());
    for (number, arm) in arms.iter().enumerate() {
        for faces in by_shape(by_arm.of(number), arm.mode) {
            let part = made.shape(&whole, faces, whole.seed.part(faces[0], 0));
            let base = cx.env.base(part);
            visit(cx, number as u32, &base.shape())?;
        }
    }
    Flow::Continue(())
}
