//! Models: all leaves of a run, in memory.
//!
//! A model is a sink too, and it can be replayed into any other sink, in the order in which it was filled. A leaf
//! takes about 140 bytes if its geometry follows from its scope, as for most leaves. A part that repeats is stored once, and takes about
//! 50 bytes at each further place. Other geometry is stored in addition.

mod leaf_store;
mod leaf_view;
mod replayed;

use std::ops::{ControlFlow, Range};
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::asset::Assets;
use crate::fault::Fault;
use crate::geometry::Axis;
use crate::geometry::mesh::{Bounds, Mesh};
use crate::material::Material;
use crate::output::leaf_numbers::Numbers;
use crate::output::near_origin::{near_origin_within, reach};
use crate::output::stats::Stats;
use crate::output::texture::leaf_uvs::LeafUvs;
use crate::output::watertight::Watertight;
use crate::run::building::Building;
use crate::run::report::Report;
use crate::run::report::{Collection, Print, Reports};
use crate::run::settings::Limits;
use crate::run::shape_tree::ShapeTree;
use crate::run::sink::{Cuboid, Filled, Flow, Leaf, Quad, Replay, Sink};
use crate::shape::base::Form;
use crate::shape::filled_scope;
use crate::shape::scope::Scope;
use crate::shape::unit::UnitMesh;
use crate::value::text::Text;

use leaf_store::{LeafStore, ModelLeaf};
pub use leaf_view::{Geometry, LeafView, Leaves};

/// The leaves of a run.
#[derive(Clone, Debug, Default)]
pub struct Model {
    store: LeafStore,
    others: Vec<Other>,
    /// The texture coordinates of rectangles and boxes, where they have any.
    uvs: LeafUvs,
    numbers: Numbers,
    /// The buildings, each with the range of its leaves.
    buildings: Vec<(Building, Range<usize>)>,
    /// The number of leaves before the building whose leaves come now.
    begun: usize,
    report: Report,
    assets: Option<Arc<Assets>>,
}

/// The source of a leaf's geometry.
#[derive(Clone, Copy, Debug)]
enum Stored {
    /// The rectangle in the scope's low plane across an axis.
    Rect(Axis, UnitMesh),
    /// The whole scope.
    Full(UnitMesh),
    /// An index in the model's list of other geometry.
    Other(u32),
    /// No faces.
    Placement,
}

/// Geometry that does not follow from the scope of its leaf.
#[derive(Clone, Debug)]
enum Other {
    Quad(Quad),
    Cuboid(Cuboid),
    Mesh(Arc<Mesh>, DAffine3),
    Instance(Arc<Mesh>, DAffine3),
}

impl Other {
    fn geometry(&self) -> Geometry<'_> {
        match self {
            Other::Quad(quad) => Geometry::Quad(*quad),
            Other::Cuboid(cuboid) => Geometry::Cuboid(*cuboid),
            Other::Mesh(mesh, placement) => Geometry::Mesh { mesh, placement },
            Other::Instance(mesh, placement) => Geometry::Instance { mesh, placement },
        }
    }
}

impl Stored {
    /// The geometry of a leaf that fills its scope.
    #[inline]
    fn filled(form: Form, unit: UnitMesh) -> Option<Self> {
        match form {
            Form::Rect(axis) => Some(Stored::Rect(axis, unit)),
            Form::Box => Some(Stored::Full(unit)),
            Form::Empty | Form::Other => None,
        }
    }
}

impl PartialEq for Model {
    /// Compares leaves and reports. Assets are not compared.
    fn eq(&self, other: &Self) -> bool {
        self.len() == other.len() && self.leaves().eq(other.leaves()) && self.report == other.report
    }
}

impl<'a> IntoIterator for &'a Model {
    type Item = LeafView<'a>;
    type IntoIter = Leaves<'a>;

    fn into_iter(self) -> Leaves<'a> {
        self.leaves()
    }
}

impl Model {
    /// The faults of single shapes, each with the rules that led there.
    pub fn faults(&self) -> &[Fault] {
        self.report.faults()
    }

    /// The reported values, sorted by key (*report operation*). `to_string` makes a table of them.
    pub fn reports(&self) -> &Reports {
        self.report.reports()
    }

    /// The values reported under one key. If they have several types, the first type, see [`Reports::of_type`].
    pub fn reported(&self, key: &str) -> Option<&Collection> {
        self.report.reported(key)
    }

    /// The lines that rules printed, breadth first; see [`Report::prints`].
    pub fn prints(&self) -> &[Print] {
        self.report.prints()
    }

    /// The report of the run: counts, faults, reported values, printed lines.
    pub fn report(&self) -> &Report {
        &self.report
    }

    pub(crate) fn with_report(self, report: Report) -> Self {
        Model { report, ..self }
    }

    /// Sets the asset folder of the images. The model of a run has the assets of its settings. Without assets, or
    /// without a folder, files name their images, and pictures show a checker pattern.
    #[must_use]
    pub fn with_assets(self, assets: Arc<Assets>) -> Self {
        Model { assets: Some(assets), ..self }
    }

    /// The assets that contain its images.
    pub fn assets(&self) -> Option<&Arc<Assets>> {
        self.assets.as_ref()
    }

    /// A model without leaves.
    pub fn new() -> Self {
        Model::default()
    }

    /// The number of leaves.
    pub fn len(&self) -> usize {
        self.store.len()
    }

    /// Returns true if there are no leaves.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The leaves, in the order of the run.
    pub fn leaves(&self) -> Leaves<'_> {
        Leaves::of(self)
    }

    /// Adds the leaves and the report of another model: counts, faults, reported values, printed lines. Models of
    /// neighbours become one scene. The images come from the assets of this model, or from the assets of the other if this
    /// has none.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::Model;
    ///
    /// let (mut scene, house) = (Model::new(), Model::new());
    /// scene.append(&house);
    /// assert!(scene.is_empty());
    /// ```
    pub fn append(&mut self, other: &Model) {
        // A model never stops a run.
        let _ = other.replay(self);
        self.report.merge(other.report.clone(), &Limits::default());
        if self.assets.is_none() {
            self.assets.clone_from(&other.assets);
        }
    }

    /// The initial shapes whose leaves it has, in order, each with the range of its leaves in [`Model::leaves`]. The model of a run has one.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::Model;
    ///
    /// # let model = Model::new();
    /// for (building, leaves) in model.buildings() {
    ///     println!("{}: {} leaves", building.name, leaves.len());
    /// }
    /// ```
    pub fn buildings(&self) -> impl ExactSizeIterator<Item = (&Building, Range<usize>)> {
        self.buildings.iter().map(|(building, leaves)| (building, leaves.clone()))
    }

    /// The leaves of one rule, in the order of the run.
    pub fn leaves_of<'a>(&'a self, rule: &'a str) -> impl Iterator<Item = LeafView<'a>> + Clone + 'a {
        self.leaves().filter(move |leaf| leaf.rule() == rule)
    }

    /// The places of the leaves of one rule, in the order of the run, in the world: position, axes and size, in metres. Leaves without
    /// faces are there for them: the points of `scatter` and `comp(v)`, the edges of `comp(e)`.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::Model;
    ///
    /// # let model = Model::new();
    /// for scope in model.placements("Lamp") {
    ///     println!("a lamp at {}, along {}", scope.origin, scope.axes.y_axis);
    /// }
    /// ```
    pub fn placements<'a>(&'a self, rule: &'a str) -> impl Iterator<Item = Scope> + Clone + 'a {
        self.leaves_of(rule).map(|leaf| leaf.scope())
    }

    /// The names of the rules that made leaves, in the order of their first leaf.
    pub fn rules(&self) -> &[Text] {
        self.numbers.table.rules()
    }

    /// The materials of the leaves, each once.
    pub fn materials(&self) -> &[Arc<Material>] {
        self.numbers.table.materials()
    }

    /// The number of leaves of each rule, in the order of [`Model::rules`].
    pub fn counts(&self) -> Vec<(&str, usize)> {
        let mut counts: Vec<_> = self.rules().iter().map(|rule| (rule.as_str(), 0)).collect();
        for leaf in self.leaves() {
            counts[leaf.rule_index()].1 += 1;
        }
        counts
    }

    /// The model without cracks: corners of neighbours are corners of the edges that they lie in, for each initial shape on its own. See
    /// [`Watertight`].
    #[must_use]
    pub fn watertight(&self) -> Model {
        let model = match self.assets() {
            Some(assets) => Model::new().with_assets(assets.clone()),
            None => Model::new(),
        };
        let mut sink = Watertight::new(model);
        // A model takes all leaves.
        let _ = self.replay(&mut sink);
        sink.into_inner().with_report(self.report.clone())
    }

    /// The number of leaves of one rule.
    pub fn count(&self, rule: &str) -> usize {
        match self.rules().iter().position(|name| name.is(rule)) {
            Some(id) => self.leaves().filter(|leaf| leaf.rule_index() == id).count(),
            None => 0,
        }
    }

    /// The axis-aligned bounding box of all geometry, in the world.
    pub fn bounds(&self) -> Bounds {
        self.leaves().fold(Bounds::EMPTY, |sum, leaf| sum.union(leaf.bounds()))
    }

    /// The origin of coordinates in 32 bits.
    pub(super) fn near_origin(&self) -> DVec3 {
        near_origin_within(self.reach(), || self.bounds())
    }

    /// A number of metres that no coordinate exceeds; infinite if a coordinate is not a number. It takes less time than the bounds, as the
    /// leaves of a part are looked at once.
    pub(super) fn reach(&self) -> f64 {
        let others = self.others.iter().map(|other| {
            let Bounds { low, high } = other.geometry().bounds();
            reach(low.abs() + high.abs())
        });
        self.store.reach().max(others.fold(0.0, f64::max))
    }

    /// The sum of the leaves' surfaces, in square metres.
    pub fn area(&self) -> f64 {
        self.leaves().fold(0.0, |sum, leaf| sum + leaf.area())
    }

    /// The sum of the leaves' volumes, in cubic metres. Leaves that overlap count twice.
    pub fn volume(&self) -> f64 {
        self.leaves().fold(0.0, |sum, leaf| sum + leaf.volume())
    }

    /// The number of triangles that a writer makes of it.
    pub fn triangle_count(&self) -> usize {
        self.stats().total().triangles as usize
    }

    /// All counts and measures.
    pub fn stats(&self) -> Stats {
        let mut stats = Stats::new();
        // `Stats` never ends a run.
        let _ = self.replay(&mut stats);
        stats
    }

    fn push(&mut self, leaf: &Leaf<'_>, stored: Stored) -> Flow {
        let (rule, material) = self.numbers.leaf(leaf);
        self.uvs.add(self.store.len(), leaf.uvs());
        self.store.push(ModelLeaf { scope: leaf.scope(), rule, material, stored });
        ControlFlow::Continue(())
    }

    fn push_other(&mut self, leaf: &Leaf<'_>, other: Other) -> Flow {
        self.others.push(other);
        self.push(leaf, Stored::Other((self.others.len() - 1) as u32))
    }
}

impl Sink for Model {
    fn begin(&mut self) {
        self.numbers.begin();
    }

    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        if let Some(stored) = Stored::filled(leaf.shape.form, leaf.shape.unit.get()) {
            let (rule, material) = self.numbers.filled(leaf);
            self.uvs.add(self.store.len(), leaf.uvs());
            self.store.push(ModelLeaf { scope: leaf.scope(), rule, material, stored });
        }
        ControlFlow::Continue(())
    }

    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        if replay.has_uvs() {
            return replay.each(self);
        }
        self.store.replay(replay, &mut self.numbers);
        ControlFlow::Continue(())
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let scope = leaf.scope();
        let implied = [Axis::Z, Axis::Y, Axis::X]
            .into_iter()
            .find(|&axis| *quad == filled_scope::rectangle(&scope, axis, quad.unit));
        match implied {
            Some(axis) => self.push(leaf, Stored::Rect(axis, quad.unit)),
            None => self.push_other(leaf, Other::Quad(*quad)),
        }
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        if *cuboid == filled_scope::cuboid(&leaf.scope(), cuboid.unit) {
            return self.push(leaf, Stored::Full(cuboid.unit));
        }
        self.push_other(leaf, Other::Cuboid(*cuboid))
    }

    fn instance(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.push_other(leaf, Other::Instance(mesh.clone(), *placement))
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        self.push_other(leaf, Other::Mesh(mesh.clone(), *placement))
    }

    fn placement(&mut self, leaf: &Leaf<'_>) -> Flow {
        self.push(leaf, Stored::Placement)
    }

    fn begin_building(&mut self, _: &str, _: u64) {
        self.begun = self.store.len();
    }

    fn end_building(&mut self, building: &dyn Fn() -> Building) {
        let (mut building, own) = (building(), self.begun..self.store.len());
        building.tree = building.tree.take().filter(|tree| self.is_tree_of(tree, own.clone()));
        self.buildings.push((building, own));
        self.begun = self.store.len();
    }
}

impl Model {
    /// Returns true if the leaves of a tree are some leaves of this model: not if a sink in between has left out some, or if Rust code in
    /// rules was different in the run that made the tree.
    fn is_tree_of(&self, tree: &ShapeTree, leaves: Range<usize>) -> bool {
        /// Templates compute scopes in another way.
        const ROUNDING: f64 = 1e-6;
        let is_near = |a: &Scope, b: &Scope| {
            let size = 1.0 + a.size.abs().max_element() + a.origin.abs().max_element();
            a.origin.abs_diff_eq(b.origin, ROUNDING * size)
                && a.size.abs_diff_eq(b.size, ROUNDING * size)
                && a.axes.abs_diff_eq(b.axes, ROUNDING)
        };
        let is_leaf = |(number, own): (usize, LeafView<'_>)| {
            let node = tree.of_leaf(number);
            node.is_some_and(|node| node.rule() == own.rule() && is_near(node.scope(), &own.scope()))
        };
        tree.leaf_count() == leaves.len()
            && self.leaves().skip(leaves.start).take(leaves.len()).enumerate().all(is_leaf)
    }
}
