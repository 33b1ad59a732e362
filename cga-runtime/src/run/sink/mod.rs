//! Sinks: the consumers of leaves.
//!
//! A run passes every leaf to a [`Sink`] as soon as it is known, in an order that depends on the rules alone.
//! A sink may end the run by returning `ControlFlow::Break(())`.

pub(crate) mod corners;
mod leaf_tables;

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3, DVec4};

use self::corners::PlacedBox;

use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::geometry::uv_map::{self, FaceMaps, SetMap};
use crate::material::Material;
use crate::run::building::Building;
use crate::shape::base::{Base, Form};
use crate::shape::filled_scope;
use crate::shape::look_id::LookId;
use crate::shape::scope::Scope;
use crate::shape::{Shape, ShapeRef};
use crate::value::text::Text;

pub use crate::run::template::{PartId, Replay};
pub use crate::shape::axes::Axes;
pub use crate::shape::filled_scope::{Cuboid, Quad};
pub(crate) use leaf_tables::LeafTables;

/// Continue, or stop the run.
pub type Flow = ControlFlow<()>;

/// A leaf without its geometry: its rule, its material and its scope.
#[derive(Clone, Copy, Debug)]
pub struct Leaf<'a> {
    /// The name of the rule or leaf symbol, without the dot. Within a grammar, equal names have equal addresses.
    pub rule: &'a Text,
    /// The material set by rules. Unset attributes come from the mesh's own material, otherwise they have their
    /// defaults.
    pub material: &'a Arc<Material>,
    source: LeafSource<'a>,
}

/// The source of a leaf's scope and texture coordinates. Most sinks do not need them, so they are made on demand.
#[derive(Clone, Copy, Debug)]
enum LeafSource<'a> {
    Known(&'a Scope, &'a [SetMap]),
    Filled(&'a Filled<'a>),
}

impl<'a> Leaf<'a> {
    /// A leaf of that rule with that scope, in the world, for sinks that are filled by hand.
    pub fn new(rule: &'a Text, material: &'a Arc<Material>, scope: &'a Scope) -> Self {
        Leaf { rule, material, source: LeafSource::Known(scope, &[]) }
    }

    /// Adds texture coordinates for a rectangle or a box, sorted by set, each set once. A mesh has its own sets.
    #[must_use]
    pub fn with_uvs(self, uvs: &'a [SetMap]) -> Self {
        match self.source {
            LeafSource::Known(scope, _) => Leaf { source: LeafSource::Known(scope, uvs), ..self },
            LeafSource::Filled(_) => self,
        }
    }

    /// The leaf's scope, in the world.
    pub fn scope(&self) -> Scope {
        match self.source {
            LeafSource::Known(scope, _) => *scope,
            LeafSource::Filled(leaf) => leaf.scope(),
        }
    }

    /// The texture coordinates of a set on a rectangle or a box; `None` if it does not have the set. A mesh contains
    /// its sets.
    pub fn uv(&self, set: usize) -> Option<&'a FaceMaps> {
        uv_map::find(self.uvs(), set)
    }

    /// The maps of all sets of a rectangle or a box, sorted by set. A mesh contains its sets.
    #[inline]
    pub fn uvs(&self) -> &'a [SetMap] {
        match self.source {
            LeafSource::Known(_, uvs) => uvs,
            LeafSource::Filled(leaf) => leaf.uvs(),
        }
    }
}

/// A leaf that fills its scope: a rectangle in the low plane across an axis, or the box itself. Rule and material are
/// numbers of the run, and normals are known, so a sink need not compute or look them up.
#[derive(Clone, Copy, Debug)]
pub struct Filled<'a> {
    /// A rectangle or a box.
    pub(crate) shape: &'a ShapeRef<'a>,
    pub(crate) tables: &'a LeafTables,
    pub(crate) rule: u32,
}

impl<'a> Filled<'a> {
    /// The name of the rule or leaf symbol, without the dot.
    #[inline]
    pub fn rule(&self) -> &'a Text {
        self.tables.names.get(self.rule as usize).unwrap_or(Text::EMPTY)
    }

    /// The number of the name. Equal names of a run have equal numbers, from 0.
    #[inline]
    pub fn rule_number(&self) -> u32 {
        self.rule
    }

    /// The material set by rules.
    #[inline]
    pub fn material(&self) -> &'a Arc<Material> {
        self.of_id(self.shape.look.get())
    }

    /// The material of the look with a number; without a number, the material of the leaf's base.
    #[inline]
    pub(crate) fn of_id(&self, id: LookId) -> &'a Arc<Material> {
        match self.tables.looks.lasting(id) {
            Some(look) => &look.material,
            None => rare_material(self.tables, self.shape.base, id),
        }
    }

    /// The number of the look: the material with its texture coordinates. Leaves of a run with equal numbers have equal
    /// materials. `None` for a look that few leaves have, such as a random colour.
    #[inline]
    pub fn material_number(&self) -> Option<u32> {
        Some(self.shape.look.get()).filter(|id| id.is_lasting()).map(LookId::index)
    }

    /// The texture coordinates of a set; `None` if the leaf does not have the set. Leaves of a run with equal
    /// material numbers have the same sets.
    pub fn uv(&self, set: usize) -> Option<&'a FaceMaps> {
        uv_map::find(self.uvs(), set)
    }

    /// The maps of all sets of the leaf, sorted by set.
    #[inline]
    pub fn uvs(&self) -> &'a [SetMap] {
        self.uvs_of(self.shape.look.get())
    }

    /// The maps that the leaf has with another look of the run.
    #[inline]
    pub(crate) fn uvs_of(&self, look: LookId) -> &'a [SetMap] {
        if !look.may_have_coordinates() {
            return &[];
        }
        let normal = match self.shape.form {
            Form::Rect(axis) => self.shape.axes.along(axis).truncate(),
            Form::Box | Form::Empty | Form::Other => DVec3::ZERO,
        };
        self.shape.base.maps(look, self.tables.looks.get(look).map(|found| &**found), normal)
    }

    /// The scope, in the world.
    #[inline]
    pub fn scope(&self) -> Scope {
        self.shape.scope()
    }

    /// The axes of the scope, with normals in the form for sinks.
    #[inline]
    pub fn axes(&self) -> &'a Axes {
        self.shape.axes
    }

    /// The number of its vertices if faces share none.
    #[inline]
    pub fn corner_count(&self) -> usize {
        4 * self.shape.unit.get().face_count()
    }

    /// The leaf as a whole shape.
    pub(crate) fn whole(&self) -> Shape {
        self.tables.whole(self.shape)
    }

    /// Passes the leaf to a sink as a rectangle or a box.
    #[inline]
    pub fn pass_to<S: Sink + ?Sized>(&self, sink: &mut S) -> Flow {
        let leaf = Leaf { rule: self.rule(), material: self.material(), source: LeafSource::Filled(self) };
        // Both forms have a position.
        let (placed, unit) = (PlacedBox::of(self.shape), self.shape.unit.get());
        let (origin, [x, y, z]) = (placed.origin.truncate(), placed.sides.each(DVec4::truncate));
        match self.shape.form {
            Form::Rect(axis) => sink.quad(&leaf, &filled_scope::low_side(origin, [x, y, z], axis, unit)),
            Form::Box => sink.cuboid(&leaf, &Cuboid { origin, sides: DMat3::from_cols(x, y, z), unit }),
            Form::Empty | Form::Other => Flow::Continue(()),
        }
    }
}

/// A consumer of the leaves of a run. Only [`Sink::mesh`] is required; other methods make a mesh by default.
pub trait Sink {
    /// A run begins: numbers of rules and materials are now numbers of this run. A sink that passes [`Filled`] or
    /// [`Replay`] on to another sink must pass this call on too, otherwise the other sink confuses the numbers of two
    /// runs.
    fn begin(&mut self) {}

    /// A rectangle or a box that fills its scope. By default it becomes a [`Sink::quad`] or a [`Sink::cuboid`]. A
    /// sink that writes many of them saves time with the axes and numbers that are known here.
    #[inline]
    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        leaf.pass_to(self)
    }

    /// The leaves of a part that repeats. By default they go one by one to [`Sink::filled`]. A sink that writes many
    /// of them saves time with all of them at once.
    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        replay.each(self)
    }

    /// A rectangle, with the texture coordinates of [`Leaf::uvs`].
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.mesh(leaf, &quad_mesh(leaf, quad), &DAffine3::IDENTITY)
    }

    /// A box, with the texture coordinates of [`Leaf::uvs`].
    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.mesh(leaf, &cuboid_mesh(leaf, cuboid), &DAffine3::IDENTITY)
    }

    /// An inserted asset that nothing has cut: the same mesh many times, each with its own placement.
    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.mesh(leaf, mesh, placement)
    }

    /// Any mesh, in local coordinates; `placement` maps them to the world.
    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow;

    /// A leaf without faces: a point, as of `scatter` or `comp(v)`, or edges, as of `comp(e)`. It is a place for what programs put
    /// there, such as lamps and prefabs: [`Leaf::scope`] has its position, axes and size. By default nothing happens.
    fn placement(&mut self, _leaf: &Leaf<'_>) -> Flow {
        Flow::Continue(())
    }

    /// The leaves that follow belong to an initial shape with this name, empty if it has none, and this seed. By default nothing happens.
    /// A sink that passes leaves on to another sink must pass this call and [`Sink::end_building`] on too.
    fn begin_building(&mut self, _name: &str, _seed: u64) {}

    /// The leaves since [`Sink::begin_building`] were all leaves of this initial shape. By default nothing happens, and the building is
    /// not made.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::{Building, Sink};
    /// # fn names(sink: &mut dyn Sink) {
    /// sink.begin_building("Mill Street 4", 7);
    /// sink.end_building(&|| Building::new("Mill Street 4", 7));
    /// # }
    /// # names(&mut cga::Model::new());
    /// ```
    fn end_building(&mut self, _building: &dyn Fn() -> Building) {}

    /// Returns false if the sink makes nothing of [`Building::tree`], so that the run need not derive it. True by default.
    fn keeps_tree(&self) -> bool {
        true
    }

    /// Takes a leaf as a whole shape, with or without faces; `None` if the sink takes its geometry. Operations that go on
    /// with leaves take shapes.
    #[doc(hidden)]
    fn keep(&mut self, _shape: &dyn Fn() -> Shape) -> Option<Flow> {
        None
    }

    /// Takes a shape that `NIL` has removed from an operand. It is not a leaf.
    #[doc(hidden)]
    fn gone(&mut self, _shape: &Shape) -> Flow {
        Flow::Continue(())
    }

    /// Passes on the data that the sink still holds. No leaves follow.
    ///
    /// The owner of a sink calls this once, after the last run. A run never calls it, as a sink may take the leaves
    /// of many runs. [`parallel`](crate::grammar::parallel) owns the sinks of its stretches and finishes each, unless
    /// a run ended with an error. `Break` ends the further work of the owner.
    fn finish(&mut self) -> Flow {
        Flow::Continue(())
    }
}

/// The material of a look without a lasting number. The leaf itself is not passed, so that it need not be in memory.
#[cold]
#[inline(never)]
fn rare_material<'a>(tables: &'a LeafTables, base: &'a Base, id: LookId) -> &'a Arc<Material> {
    tables.looks.get(id).map_or(base.shape.state.material(), |look| &look.material)
}

/// A rectangle as a mesh in the world, with the texture coordinates of the leaf.
#[cold]
#[inline(never)]
pub(crate) fn quad_mesh(leaf: &Leaf<'_>, quad: &Quad) -> Arc<Mesh> {
    Arc::new(quad.to_mesh().with_uvs(leaf.uvs()))
}

/// A box as a mesh in the world, with the texture coordinates of the leaf.
#[cold]
#[inline(never)]
pub(crate) fn cuboid_mesh(leaf: &Leaf<'_>, cuboid: &Cuboid) -> Arc<Mesh> {
    Arc::new(cuboid.to_mesh().with_uvs(leaf.uvs()))
}

impl<S: Sink + ?Sized> Sink for &mut S {
    fn finish(&mut self) -> Flow {
        (**self).finish()
    }

    fn begin(&mut self) {
        (**self).begin();
    }

    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        (**self).filled(leaf)
    }

    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        (**self).replay(replay)
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        (**self).quad(leaf, quad)
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        (**self).cuboid(leaf, cuboid)
    }

    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        (**self).instance(leaf, mesh, placement)
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        (**self).mesh(leaf, mesh, placement)
    }

    fn placement(&mut self, leaf: &Leaf<'_>) -> Flow {
        (**self).placement(leaf)
    }

    fn begin_building(&mut self, name: &str, seed: u64) {
        (**self).begin_building(name, seed);
    }

    fn end_building(&mut self, building: &dyn Fn() -> Building) {
        (**self).end_building(building);
    }

    fn keeps_tree(&self) -> bool {
        (**self).keeps_tree()
    }

    fn keep(&mut self, shape: &dyn Fn() -> Shape) -> Option<Flow> {
        (**self).keep(shape)
    }

    fn gone(&mut self, shape: &Shape) -> Flow {
        (**self).gone(shape)
    }
}
