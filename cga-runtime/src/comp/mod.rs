//! The component split: which component goes to which arm, and the shapes they make.

mod candidate;
mod mesh_parts;
pub(crate) mod orientation;
mod owners;
mod part;
mod roof;
pub(crate) mod select;
mod source;
#[cfg(test)]
mod tests;
mod value;
mod wire_parts;

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::fault::FaultKind;
use crate::geometry::Frame;
use crate::run::context::Cx;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::scope::Scope;
use crate::shape::seed::{self, Seed, Tag};
use crate::shape::trim::{Surface, Trims};
use crate::shape::{Counter, Geometry, Shape, ShapeRef};

pub(crate) use candidate::Candidate;
pub use candidate::{is_tagged, is_tagged_at};
pub use select::Subcomponent;
pub use value::comp_values;

use orientation::Looks;
use owners::Owners;
use part::Component;
use select::Word;
use source::{ComponentSource, Quads};

/// What a shape is divided into (*comp operation*).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Components {
    /// Faces.
    Faces,
    /// Edges, shared ones once.
    Edges,
    /// Edges of each face.
    FaceEdges,
    /// Vertices, shared ones once.
    Vertices,
    /// Vertices of each face.
    FaceVertices,
    /// Groups of an asset; faces without a group are the last one.
    Groups,
    /// Faces of one material; those without are the last ones.
    Materials,
    /// Holes of faces, as faces that fill them.
    Holes,
}

/// The coordinate system of the components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// `zUp`: their own.
    ZUp,
    /// `noAlign`: pivot and axes of the shape.
    Keep,
}

/// One `selector : …`, `selector = …` or `selector =: …` of a comp.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    /// Which components it takes.
    pub select: Select,
    /// How many shapes they make.
    pub mode: Mode,
    /// `comp.sel`.
    pub text: &'static str,
}

/// Which components an arm takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Select {
    /// Those that a word says.
    Word(Word),
    /// By number, counted from 0. What is no whole number or too large takes nothing.
    Index(f64),
    /// Those for which the arm's condition holds.
    When,
}

/// The operator of an arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// `:`, one shape a component.
    Each,
    /// `=`, one shape for all.
    Together,
    /// `=:`, one shape for those that are connected: by edges of faces, else by points.
    Connected,
}

impl Arm {
    /// Whether it can be decided without knowing what is next to what.
    fn looks_only(&self) -> bool {
        let looks = match self.select {
            Select::Word(word) => matches!(word.sense(), select::Sense::All | select::Sense::Looks(..)),
            Select::Index(_) => true,
            Select::When => false,
        };
        looks && self.mode != Mode::Connected
    }
}

/// No arm has a condition.
pub fn never(_: &mut Env, _: u32, _: &mut Candidate<'_>) -> bool {
    false
}

/// Divides a shape into its components and calls `visit` with every part's arm and shape: arms in writing order, the
/// components of each by number (*comp operation*). `when` says whether the condition of an arm holds; `number` counts the
/// children that the rule makes.
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
    let whole = cx.env.whole(&shape.child(seed::key(Tag::Comp, number)));
    let parts = AssignedComponents::of(cx.env, &whole, components, align, arms, when)?;
    if let ComponentSource::Quads(quads) = &parts.source {
        return parts.each_side(quads, cx, visit);
    }
    parts.each(|arm, _, part| {
        let base = cx.env.base(part);
        visit(cx, arm, &base.shape())
    })
}

/// The components of a shape, each given to an arm, ready to be handed out.
#[derive(Debug)]
struct AssignedComponents<'s> {
    parent: &'s Shape,
    align: Align,
    arms: &'s [Arm],
    owners: Owners,
    source: ComponentSource,
    /// Whether each arm takes edges as those of a roof.
    as_roof: Vec<bool>,
    trims: Option<Arc<Surface>>,
}

impl<'s> AssignedComponents<'s> {
    /// Gives every component to the first arm that selects it. The seed of the shape is that of the step: components have theirs
    /// from it. `Break` when a limit was reached.
    #[inline]
    fn of(
        env: &mut Env,
        shape: &'s Shape,
        components: Components,
        align: Align,
        arms: &'s [Arm],
        mut when: impl FnMut(&mut Env, u32, &mut Candidate<'_>) -> bool,
    ) -> ControlFlow<(), Self> {
        for arm in arms {
            if let Select::Index(number) = arm.select
                && !number.is_finite()
            {
                env.fault(FaultKind::Value, format!("an index of `comp` is {number}; it takes nothing"));
            }
        }
        let source = ComponentSource::of(env, shape, components, align, arms)?;
        let count = source.len();
        let parent = shape;
        let looks = Looks::of(env, parent);
        let mut as_roof = Vec::new();
        let owners = Owners::choose(count, |number| {
            let mut candidate = Candidate::new(&source, &looks, parent, number);
            let arm = arms.iter().enumerate().position(|(arm, Arm { select, .. })| {
                candidate.as_roof = false;
                match *select {
                    Select::Word(word) => candidate.is(word),
                    // What is degenerate is never selected.
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
            arm.map(|arm| arm as u16)
        });
        let trims = match &source {
            // *comp operation*: only faces, and only with `:`.
            ComponentSource::Mesh(parts)
                if components == Components::Faces && arms.iter().any(|arm| arm.mode == Mode::Each) =>
            {
                let up = (align == Align::Keep).then(|| parent.scope.axes.transpose() * parent.pivot.axes.y_axis);
                Some(Arc::new(Surface::new(parts.mesh.clone(), parent.scope.frame(), up)))
            }
            _ => None,
        };
        ControlFlow::Continue(AssignedComponents { parent, align, arms, owners, source, as_roof, trims })
    }

    /// Calls with every part: its arm, the numbers of its components, and its shape.
    #[inline]
    fn each(&self, mut visit: impl FnMut(u32, &[u32], Shape) -> Flow) -> Flow {
        for (number, arm) in self.arms.iter().enumerate() {
            let mine = || self.owners.of(number as u16);
            match arm.mode {
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
        }
        Flow::Continue(())
    }

    /// The façade path: calls with the sides of a box one by one. Bases are made where they stay: what is copied right after it
    /// was written has to wait until all that was written before is in the cache.
    #[inline]
    fn each_side<C>(
        &self,
        quads: &Quads,
        cx: &mut Cx<'_, C>,
        visit: &mut dyn FnMut(&mut Cx<'_, C>, u32, &ShapeRef<'_>) -> Flow,
    ) -> Flow {
        let material = cx.env.leaf_tables.looks.id(self.parent.state.look());
        for number in 0..self.arms.len() {
            let mine = || self.owners.of(number as u16);
            let total = mine().count();
            for (index, component) in mine().enumerate() {
                let side = self.side(quads, number, Counter::new(index, total), component);
                let base = cx.env.base_painted(side, material);
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
        let Component { scope, pivot, geometry } = self.source.part(parent, self.align, components, as_roof);
        let own = match &self.trims {
            Some(surface) if arm.mode == Mode::Each => Trims::Face(surface.clone(), components[0]),
            _ => Trims::None,
        };
        self.shape(arm, comp, components[0], scope, pivot, geometry, own)
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
            seed: Seed::new(seed::part(parent.seed.value(), component, 0)),
            split: parent.split,
            comp,
            selector: arm.text,
            trims: parent.trims.with(&parent.pivot, own, &pivot),
            state: parent.state.clone(),
        }
    }
}
