//! The component split: the arms of components, and the shapes that they make.

mod arms;
mod candidate;
mod faces;
mod found_tags;
mod mesh_parts;
pub(crate) mod orientation;
mod owners;
mod part;
mod points;
mod roof;
mod sections;
pub(crate) mod select;
mod single_faces;
mod source;
#[cfg(test)]
mod tests;
mod uv_edges;
mod value;
mod wire_parts;

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::fault::FaultKind;
use crate::geometry::Frame;
use crate::geometry::work;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::base::Base;
use crate::shape::body::Body;
use crate::shape::scope::Scope;
use crate::shape::seed::{self, Tag};
use crate::shape::trim::{Surface, Trims};
use crate::shape::{Counter, Geometry, Shape, ShapeRef};
use crate::value::text::Text;

pub use arms::divide;
pub(crate) use arms::{Arms, face_edges};
pub use candidate::Candidate;
pub use candidate::{is_tagged, is_tagged_at};
pub(crate) use faces::Faces;
pub(crate) use points::Points;
pub use points::each;
pub use sections::sections;
pub(crate) use sections::{Section, Sections};
pub use select::Subcomponent;
pub use value::comp_values;

use orientation::Orientation;
use owners::ArmOwners;
use part::ComponentPart;
use select::Word;
use source::{ComponentSource, Quads};

/// The components of a box, which do not count as work, and the units of work of another component.
const SIDES: usize = 6;
const COMPONENT: usize = 16;

/// The kind of components (*comp operation*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Components {
    /// Faces.
    Faces,
    /// Edges; a shared edge counts once.
    Edges,
    /// The edges of each face.
    FaceEdges,
    /// Vertices; a shared vertex counts once.
    Vertices,
    /// The vertices of each face.
    FaceVertices,
    /// Groups of an asset. Faces without a group form the last one.
    Groups,
    /// The faces of each material. Faces without a material come last.
    Materials,
    /// Holes of faces, as faces that fill them.
    Holes,
}

/// The coordinate system of the components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// `zUp`: their own system.
    ZUp,
    /// `noAlign`: the pivot and the axes of the shape.
    Keep,
}

/// A `selector : …`, `selector = …` or `selector =: …` of a comp.
#[derive(Clone, Debug)]
pub struct Arm {
    /// The components that it takes.
    pub select: Select,
    /// The shapes that it makes of them.
    pub mode: Mode,
    /// `comp.sel`.
    pub text: Text,
}

/// The components that an arm takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Select {
    /// The components that a word matches.
    Word(Word),
    /// The component with a number, from 0. A number that is not an integer or out of range takes nothing.
    Index(f64),
    /// The components for which the arm's condition holds.
    When,
}

/// The operator of an arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// `:`, one shape for each component.
    Each,
    /// `=`, one shape for all components.
    Together,
    /// `=:`, one shape for each connected set: by edges of faces, otherwise by points.
    Connected,
}

impl Arm {
    /// Returns true if the arm can be decided without the adjacency of the mesh.
    fn looks_only(&self) -> bool {
        let looks = match self.select {
            Select::Word(word) => matches!(word.0, select::Sense::All | select::Sense::Looks(..)),
            Select::Index(_) => true,
            Select::When => false,
        };
        looks && self.mode != Mode::Connected
    }
}

/// The condition of arms that have none.
pub fn never(_: &mut Env, _: u32, _: &mut Candidate<'_>) -> bool {
    false
}

/// Divides a shape into its components and calls `visit` with every part's arm and shape: arms in writing order, the
/// components of each by number (*comp operation*). `when` returns true if the condition of an arm holds. `number`
/// counts the children of the rule.
#[allow(clippy::too_many_arguments, reason = "generated code calls it")]
pub fn comp<C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    number: u32,
    components: Components,
    align: Align,
    arms: &[Arm],
    when: &mut dyn FnMut(&mut Env, u32, &mut Candidate<'_>) -> bool,
    visit: &mut dyn FnMut(&mut Cx<'_, C>, u32, &ShapeRef<'_>) -> Flow,
) -> Flow {
    let whole = to_divide(cx, shape, number);
    cx.env.collect_divided(|| Body::from(&whole));
    let parts = AssignedComponents::of(cx.env, &whole, components, align, arms, when)?;
    if let ComponentSource::Quads(quads) = &parts.source {
        return parts.each_side(quads, cx, visit);
    }
    parts.each_successor(cx, visit)
}

/// As [`comp`] for the operand of `modify`: then passes the geometry that no arm takes to the sink. Edges, vertices and holes leave
/// all faces (*modify operation*).
#[allow(clippy::too_many_arguments, reason = "generated code calls it")]
pub fn comp_and_rest<C>(
    cx: &mut Cx<'_, C>,
    shape: &ShapeRef<'_>,
    number: u32,
    components: Components,
    align: Align,
    arms: &[Arm],
    when: &mut dyn FnMut(&mut Env, u32, &mut Candidate<'_>) -> bool,
    visit: &mut dyn FnMut(&mut Cx<'_, C>, u32, &ShapeRef<'_>) -> Flow,
) -> Flow {
    let whole = to_divide(cx, shape, number);
    let parts = AssignedComponents::of(cx.env, &whole, components, align, arms, when)?;
    parts.each_successor(cx, visit)?;
    let mut rest = parts.rest(components);
    cx.env.begin_part(&mut rest);
    cx.sink.keep(&|| rest.clone()).unwrap_or(Flow::Continue(()))
}

/// The shape whose components are the next children of its rule.
#[inline]
fn to_divide<C>(cx: &mut Cx<'_, C>, shape: &ShapeRef<'_>, number: u32) -> Shape {
    let mut whole = cx.env.whole(&shape.child(seed::key(Tag::Comp, number)));
    cx.env.divide_trace(&mut whole);
    whole
}

/// The components of a shape, each assigned to an arm.
#[derive(Debug)]
struct AssignedComponents<'s> {
    parent: &'s Shape,
    align: Align,
    arms: &'s [Arm],
    owners: ArmOwners,
    source: ComponentSource,
    /// True for each arm that takes edges as edges of a roof.
    as_roof: Vec<bool>,
    trims: Option<Arc<Surface>>,
}

impl<'s> AssignedComponents<'s> {
    /// Assigns every component to the first arm that selects it. The seed of the shape must be the seed of the step;
    /// seeds of components follow from it. `Break` when a limit is reached.
    #[inline]
    fn of(
        env: &mut Env,
        shape: &'s Shape,
        components: Components,
        align: Align,
        arms: &'s [Arm],
        when: impl FnMut(&mut Env, u32, &mut Candidate<'_>) -> bool,
    ) -> ControlFlow<(), Self> {
        let source = ComponentSource::of(env, shape, components, align, arms)?;
        ControlFlow::Continue(Self::assigned(env, shape, components, align, arms, when, source))
    }

    /// Assigns the components of a source.
    #[inline]
    fn assigned(
        env: &mut Env,
        shape: &'s Shape,
        components: Components,
        align: Align,
        arms: &'s [Arm],
        mut when: impl FnMut(&mut Env, u32, &mut Candidate<'_>) -> bool,
        source: ComponentSource,
    ) -> Self {
        for arm in arms {
            if let Select::Index(number) = arm.select
                && !number.is_finite()
            {
                env.fault(FaultKind::Value, format!("an index of a component is {number}; it takes nothing"));
            }
        }
        let parent = shape;
        let looks = Orientation::of(env, parent);
        let mut as_roof = Vec::new();
        let may_end = |number: usize| SIDES <= number && !work::spend(COMPONENT);
        let mut arm_of = |number: usize| {
            let mut candidate = Candidate::new(&source, &looks, parent, number);
            let arm = arms.iter().enumerate().position(|(arm, Arm { select, .. })| {
                candidate.as_roof = false;
                match *select {
                    Select::Word(word) => candidate.is(word),
                    // Degenerate components are never selected.
                    Select::Index(index) => index == number as f64 && candidate.is(Word::All),
                    Select::When => candidate.is(Word::All) && when(env, arm as u32, &mut candidate),
                }
            });
            if candidate.as_roof
                && let Some(arm) = arm
            {
                as_roof.resize(arms.len(), false);
                as_roof[arm] = true;
            }
            arm
        };
        let count = source.len();
        let arm = |arm: usize| arm as u16;
        let owners = match &source {
            ComponentSource::Mesh(parts)
                if parts.kind == Components::Faces && arms.iter().all(|arm| arm.select != Select::When) =>
            {
                let arm_of = |number| parts.arm_of_face(&looks, number, arms);
                ArmOwners::choose(count, |number| if may_end(number) { None } else { arm_of(number).map(arm) })
            }
            _ => ArmOwners::choose(count, |number| if may_end(number) { None } else { arm_of(number).map(arm) }),
        };
        let trims = match &source {
            // *comp operation*: only faces, and only with `:`.
            ComponentSource::Mesh(parts)
                if components == Components::Faces && arms.iter().any(|arm| arm.mode == Mode::Each) =>
            {
                Some(Arc::new(Surface::new(parts.mesh.clone(), parent.scope.frame())))
            }
            _ => None,
        };
        AssignedComponents { parent, align, arms, owners, source, as_roof, trims }
    }

    /// Calls `visit` with every part: its arm, the numbers of its components, and its shape.
    #[inline]
    fn each(&self, mut visit: impl FnMut(u32, &[u32], Shape) -> Flow) -> Flow {
        (0..self.arms.len()).try_for_each(|number| self.each_of(number, &mut visit))
    }

    /// The same for the parts of an arm.
    #[inline]
    fn each_of(&self, number: usize, mut visit: impl FnMut(u32, &[u32], Shape) -> Flow) -> Flow {
        let mine = || self.owners.of(number as u16);
        match self.arms[number].mode {
            Mode::Each => {
                let total = mine().count();
                for (index, component) in mine().enumerate() {
                    let counter = Counter::new(index, total);
                    visit(number as u32, &[component], self.part(number, counter, &[component]))?;
                }
            }
            Mode::Together => {
                let all: Vec<u32> = mine().collect();
                if !all.is_empty() {
                    visit(number as u32, &all, self.part(number, Counter::new(0, 1), &all))?;
                }
            }
            Mode::Connected => {
                let sets = owners::connected(&self.source, mine());
                for (index, set) in sets.iter().enumerate() {
                    let counter = Counter::new(index, sets.len());
                    visit(number as u32, set, self.part(number, counter, set))?;
                }
            }
        }
        Flow::Continue(())
    }

    /// Calls `visit` with the arm and the shape of every part.
    #[inline]
    fn each_successor<C>(
        &self,
        cx: &mut Cx<'_, C>,
        visit: &mut dyn FnMut(&mut Cx<'_, C>, u32, &ShapeRef<'_>) -> Flow,
    ) -> Flow {
        let mut last = None;
        for number in 0..self.arms.len() {
            if let Some(parts) = self.faces_of(number)
                && cx.env.recompositions.is_empty()
            {
                self.each_face(parts, number, &mut last, cx, visit)?;
                continue;
            }
            self.each_of(number, |arm, _, mut part| {
                cx.env.begin_part(&mut part);
                let base = cx.env.base(part);
                visit(cx, arm, &base.shape())
            })?;
        }
        Flow::Continue(())
    }

    /// The geometry that no arm takes. Edges, vertices and holes take none.
    fn rest(&self, components: Components) -> Shape {
        let mut rest = self.parent.clone();
        let takes = matches!(components, Components::Faces | Components::Groups | Components::Materials);
        if takes && !matches!(self.source, ComponentSource::Wire(_)) {
            let left: Vec<u32> = self.owners.left().collect();
            rest.geometry = Geometry::Empty;
            if !left.is_empty() {
                let part = self.source.kept(self.parent, &left, false);
                (rest.scope, rest.geometry) = (part.scope, part.geometry);
            }
        }
        rest
    }

    /// The façade path: calls `visit` with the sides of a box one by one. Bases are made in their final place: a copy
    /// right after writing would have to wait until all earlier stores are in the cache.
    #[inline]
    fn each_side<C>(
        &self,
        quads: &Quads,
        cx: &mut Cx<'_, C>,
        visit: &mut dyn FnMut(&mut Cx<'_, C>, u32, &ShapeRef<'_>) -> Flow,
    ) -> Flow {
        let look = cx.env.look_id(self.parent.state.look());
        for number in 0..self.arms.len() {
            let mine = || self.owners.of(number as u16);
            let total = mine().count();
            for (index, component) in mine().enumerate() {
                let side = self.side(quads, number, Counter::new(index, total), component);
                let base = Base::new(side, look);
                visit(cx, number as u32, &base.shape())?;
            }
        }
        Flow::Continue(())
    }

    /// The shape of a side of a box.
    #[inline(always)]
    fn side(&self, quads: &Quads, number: usize, comp: Counter, component: u32) -> Shape {
        let scope = quads.scope(&self.parent.scope, component as usize);
        let own = if quads.is_rectangle() { Trims::None } else { Trims::Side(scope.size.truncate()) };
        self.shape(&self.arms[number], comp, component, scope, scope.frame(), quads.alone(component as usize), own)
    }

    #[inline]
    fn part(&self, number: usize, comp: Counter, components: &[u32]) -> Shape {
        let (parent, arm) = (self.parent, &self.arms[number]);
        if let ComponentSource::Quads(quads) = &self.source {
            return self.side(quads, number, comp, components[0]);
        }
        let as_roof = self.as_roof.get(number) == Some(&true);
        let ComponentPart { scope, pivot, geometry } = self.source.part(parent, self.align, components, as_roof);
        self.shape(arm, comp, components[0], scope, pivot, geometry, self.own_trims(arm, components[0]))
    }

    /// The trim planes of a part itself.
    #[inline]
    fn own_trims(&self, arm: &Arm, component: u32) -> Trims {
        match &self.trims {
            Some(surface) if arm.mode == Mode::Each => Trims::Face(surface.clone(), component),
            _ => Trims::None,
        }
    }

    #[allow(clippy::too_many_arguments, reason = "they are what a shape is made of")]
    #[inline(always)]
    fn shape(
        &self,
        arm: &Arm,
        comp: Counter,
        component: u32,
        scope: Scope,
        pivot: Frame,
        geometry: Geometry,
        own: Trims,
    ) -> Shape {
        let parent = self.parent;
        Shape {
            scope,
            pivot,
            geometry,
            seed: parent.seed.part(component, 0),
            split: parent.split,
            comp,
            selector: arm.text.clone(),
            trims: parent.trims.with(&parent.pivot, own, &pivot),
            state: parent.state.clone(),
        }
    }
}
