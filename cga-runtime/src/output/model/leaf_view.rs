//! The leaves of a model, one by one.

use std::ops::Range;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::leaf_store::{LeafCursor, ModelLeaf};
use super::{Model, Stored};
use crate::geometry::mesh::{Bounds, Mesh};
use crate::geometry::uv_map::SetMap;
use crate::material::Material;
use crate::output::measure::{cuboid_area, cuboid_volume, mesh_area, mesh_volume, quad_area};
use crate::run::shape_tree::ShapeNode;
use crate::run::sink::{Cuboid, Flow, Leaf, Quad, Sink, cuboid_mesh, quad_mesh};
use crate::shape::filled_scope;
use crate::shape::scope::Scope;
use crate::value::text::Text;

/// The geometry of a leaf, in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Geometry<'a> {
    /// No faces: a point or edges. The scope is the place of what a program puts there.
    Placement,
    /// A rectangle.
    Quad(Quad),
    /// A closed box.
    Cuboid(Cuboid),
    /// A mesh that belongs to this leaf.
    Mesh {
        /// The mesh in local coordinates.
        mesh: &'a Arc<Mesh>,
        /// The map from local coordinates to the world.
        placement: &'a DAffine3,
    },
    /// An inserted asset that nothing has cut, possibly shared by many leaves.
    Instance {
        /// The mesh in local coordinates.
        mesh: &'a Arc<Mesh>,
        /// The map from local coordinates to the world.
        placement: &'a DAffine3,
    },
}

/// A leaf of a model.
#[derive(Clone, Copy, Debug)]
pub struct LeafView<'a> {
    model: &'a Model,
    record: ModelLeaf,
    number: usize,
}

impl<'a> LeafView<'a> {
    pub(super) fn of(model: &'a Model, number: usize, record: ModelLeaf) -> Self {
        LeafView { model, record, number }
    }

    /// The name of the rule or leaf symbol, without the dot.
    pub fn rule(&self) -> &'a str {
        self.name()
    }

    fn name(&self) -> &'a Text {
        &self.model.numbers.table.rules()[self.record.rule as usize]
    }

    /// The material set by rules.
    pub fn material(&self) -> &'a Arc<Material> {
        &self.model.numbers.table.materials()[self.record.material as usize]
    }

    /// The index of the material in [`Model::materials`].
    pub fn material_index(&self) -> usize {
        self.record.material as usize
    }

    /// The place and the size, in the world.
    pub fn scope(&self) -> Scope {
        self.record.scope
    }

    /// The index of the rule in [`Model::rules`].
    pub fn rule_index(&self) -> usize {
        self.record.rule as usize
    }

    /// The shape in the tree of its building, if the run has kept it; see [`Settings::tree`](crate::run::settings::Settings::tree).
    pub fn node(&self) -> Option<ShapeNode<'a>> {
        let buildings = &self.model.buildings;
        let at = buildings.partition_point(|(_, leaves)| leaves.end <= self.number);
        let (building, leaves) = buildings.get(at)?;
        building.tree.as_deref()?.of_leaf(self.number.checked_sub(leaves.start)?)
    }

    /// The size of the scope, in metres; a negative size mirrors.
    pub fn size(&self) -> DVec3 {
        self.record.scope.size
    }

    /// The geometry.
    pub fn geometry(&self) -> Geometry<'a> {
        let index = match self.record.stored {
            Stored::Rect(axis, unit) => return Geometry::Quad(filled_scope::rectangle(&self.record.scope, axis, unit)),
            Stored::Full(unit) => return Geometry::Cuboid(filled_scope::cuboid(&self.record.scope, unit)),
            Stored::Placement => return Geometry::Placement,
            Stored::Other(index) => index,
        };
        self.model.others[index as usize].geometry()
    }

    /// The maps of the texture coordinate sets of a rectangle or a box, sorted by set. A mesh contains its sets.
    pub fn uvs(&self) -> &'a [SetMap] {
        self.model.uvs.of(self.number)
    }

    /// The signed enclosed volume, in cubic metres: 0 for a rectangle, negative for geometry that is inside out. It
    /// has no meaning for a mesh that is not closed.
    pub fn volume(&self) -> f64 {
        match self.geometry() {
            Geometry::Placement | Geometry::Quad(_) => 0.0,
            Geometry::Cuboid(cuboid) => cuboid_volume(&cuboid),
            Geometry::Mesh { mesh, placement } | Geometry::Instance { mesh, placement } => mesh_volume(mesh, placement),
        }
    }

    /// The surface in square metres; for a closed box the area of all six faces.
    pub fn area(&self) -> f64 {
        match self.geometry() {
            Geometry::Placement => 0.0,
            Geometry::Quad(quad) => quad_area(&quad),
            Geometry::Cuboid(cuboid) => cuboid_area(&cuboid),
            Geometry::Mesh { mesh, placement } | Geometry::Instance { mesh, placement } => mesh_area(mesh, placement),
        }
    }

    fn leaf(&self) -> Leaf<'_> {
        Leaf::new(self.name(), self.material(), &self.record.scope).with_uvs(self.uvs())
    }

    /// The geometry as a mesh with its texture coordinates, and the map from the mesh's coordinates to the world.
    /// Created for a rectangle or a box, shared otherwise. Without faces it is empty.
    pub fn mesh(&self) -> (Arc<Mesh>, DAffine3) {
        match self.geometry() {
            Geometry::Placement => (Arc::default(), DAffine3::IDENTITY),
            Geometry::Quad(quad) => (quad_mesh(&self.leaf(), &quad), DAffine3::IDENTITY),
            Geometry::Cuboid(cuboid) => (cuboid_mesh(&self.leaf(), &cuboid), DAffine3::IDENTITY),
            Geometry::Mesh { mesh, placement } | Geometry::Instance { mesh, placement } => (mesh.clone(), *placement),
        }
    }

    /// The axis-aligned bounding box of the faces, in the world; the empty box without faces.
    pub fn bounds(&self) -> Bounds {
        self.geometry().bounds()
    }

    /// Passes the leaf to a sink.
    pub fn replay<S: Sink + ?Sized>(&self, sink: &mut S) -> Flow {
        let leaf = self.leaf();
        match self.geometry() {
            Geometry::Placement => sink.placement(&leaf),
            Geometry::Quad(quad) => sink.quad(&leaf, &quad),
            Geometry::Cuboid(cuboid) => sink.cuboid(&leaf, &cuboid),
            Geometry::Mesh { mesh, placement } => sink.mesh(&leaf, mesh, placement),
            Geometry::Instance { mesh, placement } => sink.instance(&leaf, mesh, placement),
        }
    }
}

impl Geometry<'_> {
    /// The axis-aligned bounding box; the empty box without faces.
    pub(super) fn bounds(&self) -> Bounds {
        match *self {
            Geometry::Placement => Bounds::EMPTY,
            Geometry::Quad(Quad { origin, u, v, .. }) => spanned(origin, [u, v, DVec3::ZERO]),
            Geometry::Cuboid(Cuboid { origin, sides, .. }) => {
                spanned(origin, [sides.x_axis, sides.y_axis, sides.z_axis])
            }
            Geometry::Mesh { mesh, placement } | Geometry::Instance { mesh, placement } => {
                Bounds::of(mesh.points().iter().map(|&point| placement.transform_point3(point)))
            }
        }
    }
}

/// The bounding box of a corner and the sides from there.
fn spanned(origin: DVec3, sides: [DVec3; 3]) -> Bounds {
    let (low, high) = sides
        .iter()
        .fold((origin, origin), |(low, high), side| (low + side.min(DVec3::ZERO), high + side.max(DVec3::ZERO)));
    Bounds { low, high }
}

impl PartialEq for LeafView<'_> {
    /// Compares rule, material, scope, geometry and texture coordinates.
    fn eq(&self, other: &Self) -> bool {
        self.rule() == other.rule()
            && self.material() == other.material()
            && self.scope() == other.scope()
            && self.geometry() == other.geometry()
            && self.uvs() == other.uvs()
    }
}

/// The leaves of a model, in the order of the run.
#[derive(Clone, Debug)]
pub struct Leaves<'a> {
    model: &'a Model,
    numbers: Range<usize>,
    cursor: LeafCursor<'a>,
}

impl<'a> Leaves<'a> {
    pub(super) fn of(model: &'a Model) -> Self {
        Leaves { model, numbers: 0..model.len(), cursor: LeafCursor::new(&model.store) }
    }

    fn view(&mut self, number: usize) -> LeafView<'a> {
        LeafView::of(self.model, number, self.cursor.at(number))
    }
}

impl<'a> Iterator for Leaves<'a> {
    type Item = LeafView<'a>;

    fn next(&mut self) -> Option<LeafView<'a>> {
        let number = self.numbers.next()?;
        Some(self.view(number))
    }

    fn nth(&mut self, n: usize) -> Option<LeafView<'a>> {
        let number = self.numbers.nth(n)?;
        Some(self.view(number))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.numbers.size_hint()
    }
}

impl DoubleEndedIterator for Leaves<'_> {
    fn next_back(&mut self) -> Option<Self::Item> {
        let number = self.numbers.next_back()?;
        Some(self.view(number))
    }
}

impl ExactSizeIterator for Leaves<'_> {}
