//! The current shape: scope, pivot, geometry and inherited state.
//!
//! A shape is a value. Its geometry fills its scope: rectangles and boxes consist of the scope alone, and a mesh is
//! shared and stretched lazily. So a copy for a rule costs a few machine words.

pub(crate) mod axes;
pub(crate) mod base;
pub(crate) mod body;
pub(crate) mod direction;
pub(crate) mod edge_attributes;
pub(crate) mod filled_scope;
#[cfg(feature = "geo-types")]
mod geo;
mod initial;
pub(crate) mod look;
pub(crate) mod look_changes;
pub(crate) mod look_id;
pub(crate) mod look_table;
pub(crate) mod lot;
mod placed;
mod point_origins;
mod sampled_outline;
pub mod scope;
pub(crate) mod scope_distance;
pub(crate) mod seed;
pub(crate) mod slim;
pub(crate) mod state;
pub(crate) mod step_bases;
pub(crate) mod street;
mod tags;
pub(crate) mod texture;
pub(crate) mod trim;
pub(crate) mod unit;
pub(crate) mod view;

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use crate::geometry::mesh::Mesh;
use crate::geometry::tol::ROUNDING_EPSILON;
use crate::geometry::wire::Wire;
use crate::geometry::{Axis, Frame};
use crate::material::{Color, Material};
use crate::shape::scope::Scope;
use crate::shape::seed::Seed;
use crate::shape::state::StateRef;
use crate::shape::texture::Coordinates;
use crate::shape::trim::Trims;
use crate::shape::unit::UnitMesh;
use crate::value::text::Text;

pub use edge_attributes::EdgeAttribute;
pub(crate) use placed::{Inserted, Placed, PlacedWire};
pub use slim::ShapeRef;

/// A whole shape: the initial shape of a run, and the shape that operations change.
#[derive(Clone, Debug)]
pub struct Shape {
    pub(crate) scope: Scope,
    pub(crate) pivot: Frame,
    pub(crate) geometry: Geometry,
    pub(crate) seed: Seed,
    pub(crate) split: Counter,
    pub(crate) comp: Counter,
    /// `comp.sel`.
    pub(crate) selector: Text,
    pub(crate) trims: Trims,
    pub(crate) state: StateRef,
}

/// `split.index` and `split.total`, or `comp.index` and `comp.total`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Counter {
    /// Index and total in one word, which is written and read as such.
    word: u64,
}

impl Counter {
    /// Before the first operation the index is -1 and the total 0 (*split attribute*, *comp attribute*).
    pub(crate) const NONE: Counter = Counter::of(-1, 0);

    #[inline]
    pub(crate) fn new(index: usize, total: usize) -> Self {
        let cap = |n: usize| n.min(i32::MAX as usize);
        Counter::of(cap(index) as i32, cap(total) as u32)
    }

    /// A counter with these numbers.
    #[inline]
    pub(crate) const fn of(index: i32, total: u32) -> Self {
        Counter { word: index as u32 as u64 | (total as u64) << 32 }
    }

    #[inline]
    pub(crate) fn index(self) -> i32 {
        self.word as u32 as i32
    }

    #[inline]
    pub(crate) fn total(self) -> u32 {
        (self.word >> 32) as u32
    }
}

/// The geometry in a scope.
#[derive(Clone, Debug)]
pub(crate) enum Geometry {
    /// No geometry: an empty slot, or the result of an operation that failed.
    Empty,
    /// A point, at the scope's origin.
    Vertex,
    /// A line from the scope's origin to the end of its x axis.
    Edge,
    /// Edges, or points alone, that do not fill the scope as above.
    Wire(Arc<PlacedWire>),
    /// A rectangle in the scope's low plane across an axis, with its normal along that axis.
    Rect(Axis, UnitMesh),
    /// The scope itself, closed.
    Box(UnitMesh),
    /// Any mesh.
    Mesh(Arc<Placed>),
}

impl Geometry {
    /// The unit mesh of a box or a rectangle, if a scope of that size flattens it.
    pub(crate) fn unit_pressed_flat(&self, size: DVec3) -> Option<UnitMesh> {
        match *self {
            Geometry::Rect(across, unit) => {
                (0..3).any(|axis| axis != across.index() && size[axis] == 0.0).then_some(unit)
            }
            Geometry::Box(unit) => size.cmpeq(DVec3::ZERO).any().then_some(unit),
            Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) | Geometry::Mesh(_) => None,
        }
    }

    /// Returns true if there may be faces.
    pub(crate) fn has_surface(&self) -> bool {
        matches!(self, Geometry::Rect(..) | Geometry::Box(_) | Geometry::Mesh(_))
    }

    /// The geometry as a mesh, and the box that the scope stretches, for all signs of the sizes. `None` without faces.
    pub(crate) fn placed(&self) -> Option<Placed> {
        match self {
            Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => None,
            Geometry::Mesh(placed) => Some(Placed::clone(placed)),
            Geometry::Box(unit) | Geometry::Rect(_, unit) => Some(Placed::unit(*unit)),
        }
    }

    /// The state of the geometry since its insertion.
    pub(crate) fn inserted(&self) -> Inserted {
        match self {
            Geometry::Rect(_, unit) | Geometry::Box(unit) if unit.is_inserted() => Inserted::Plain,
            Geometry::Mesh(placed) => placed.inserted,
            _ => Inserted::No,
        }
    }
}

impl Shape {
    /// The place and the size of the shape in the world.
    pub fn scope(&self) -> &Scope {
        &self.scope
    }

    /// Moves, turns or resizes the scope and the geometry in it.
    pub fn set_scope(&mut self, scope: Scope) {
        self.resize(scope.size);
        let before = self.scope;
        self.scope = scope;
        self.carry(&before);
    }

    /// The pivot, in the world.
    pub fn pivot(&self) -> &Frame {
        &self.pivot
    }

    /// Moves the pivot. Scope, geometry and trim planes stay.
    pub(crate) fn set_pivot(&mut self, pivot: Frame) {
        self.trims = self.trims.with(&self.pivot, Trims::None, &pivot);
        self.pivot = pivot;
    }

    /// The seed of this shape, from which its random choices follow.
    pub fn seed_value(&self) -> u64 {
        self.seed.value()
    }

    /// The material, with the attributes that rules have set.
    pub fn material(&self) -> &Material {
        self.state.material()
    }

    /// The geometry's own material. If faces have several, the first one.
    pub(crate) fn own_material(&self) -> Option<&Material> {
        let Geometry::Mesh(placed) = &self.geometry else { return None };
        let mesh = &placed.mesh;
        mesh.face_attributes().find_map(|tag| mesh.materials::<Material>().get(tag.material as usize))
    }

    /// Changes the material of this shape and of all shapes derived from it.
    pub fn change_material(&mut self, change: impl FnOnce(&mut Material)) {
        change(Arc::make_mut(&mut self.state.change_look().material));
    }

    /// Sets the diffuse colour.
    pub fn set_color(&mut self, color: Color) {
        self.change_material(|material| material.color = Some(color));
    }

    /// Returns true if the faces look inwards because a negative size mirrors them. Selectors then go by the places
    /// of faces (*CGA changelog 2010.3*).
    pub(crate) fn looks_inwards(&self) -> bool {
        let (mut stretch, mut mirrored) = (self.scope.size, false);
        match &self.geometry {
            Geometry::Rect(axis, _) => stretch[axis.index()] = 1.0,
            Geometry::Mesh(placed) => (stretch, mirrored) = (placed.stretch(stretch), placed.mirrored),
            _ => {}
        }
        let odd = stretch.cmplt(DVec3::ZERO).bitmask().count_ones() % 2 == 1;
        odd != mirrored
    }

    /// The geometry as a mesh in scope coordinates: metres from the scope's origin corner, along its axes. It has all
    /// texture coordinates as explicit sets.
    pub fn to_mesh(&self) -> Arc<Mesh> {
        self.in_scope(|mesh, to_scope| self.baked(mesh, to_scope))
    }

    /// The number of corners of this mesh, which may be a copy of a large one.
    pub(crate) fn corner_count(&self) -> usize {
        match &self.geometry {
            Geometry::Mesh(placed) => placed.mesh.corners().len(),
            _ => self.to_mesh().corners().len(),
        }
    }

    /// The same mesh with its own texture coordinates. The implicit ones stay with the shape, so this is the mesh for
    /// geometry whose shape keeps them.
    pub(crate) fn own_mesh(&self) -> Arc<Mesh> {
        self.in_scope(|mesh, _| self.without_hidden_sets(mesh))
    }

    /// A mesh in scope coordinates, with the texture coordinates that `textured` gives it before it is stretched.
    fn in_scope(&self, textured: impl FnOnce(&Arc<Mesh>, &DAffine3) -> Arc<Mesh>) -> Arc<Mesh> {
        match &self.geometry {
            Geometry::Empty | Geometry::Vertex | Geometry::Edge | Geometry::Wire(_) => Arc::default(),
            Geometry::Rect(_, unit) | Geometry::Box(unit) => {
                textured(&filled_scope::mesh(*unit, self.scope.size), &DAffine3::IDENTITY)
            }
            Geometry::Mesh(placed) => {
                let place = placed.to_scope(self.scope.size);
                let mesh = textured(&placed.mesh, &place);
                if place == DAffine3::IDENTITY { mesh } else { Arc::new(mesh.map(&place)) }
            }
        }
    }

    /// The edges and points of geometry without faces, in scope coordinates.
    pub(crate) fn to_wire(&self) -> Option<Wire> {
        match &self.geometry {
            Geometry::Vertex => Some(Wire::point()),
            Geometry::Edge => Some(Wire::edge(self.scope.size.x)),
            Geometry::Wire(placed) => Some(placed.in_scope(self.scope.size)),
            Geometry::Empty | Geometry::Rect(..) | Geometry::Box(_) | Geometry::Mesh(_) => None,
        }
    }

    /// Turns a box or a rectangle into a mesh.
    pub(crate) fn hold_as_mesh(&mut self) {
        if let Geometry::Rect(_, unit) | Geometry::Box(unit) = self.geometry {
            self.geometry = Geometry::Mesh(Arc::new(Placed::unit(unit)));
            // A size of zero flattens the mesh.
            self.resize(self.scope.size);
        }
    }

    /// Replaces the geometry by a mesh in scope coordinates with its own texture coordinates. The scope becomes its
    /// bounding box. A size that is only a rounding error is zero, and the points are flat along that axis.
    pub fn set_mesh(&mut self, mesh: Mesh) {
        let placed = Placed::flattened(mesh);
        self.scope.origin += self.scope.axes * placed.low;
        self.scope.size = placed.size;
        self.geometry = Geometry::Mesh(Arc::new(placed));
        if !self.state.coordinates().is_empty() {
            self.state.change_look().coordinates = Coordinates::default();
        }
    }

    /// Replaces the geometry by a mesh in scope coordinates with its own texture coordinates, in the scope as it is.
    pub(crate) fn put_mesh(&mut self, mesh: Mesh) {
        let is_box =
            |placed: &Placed, mesh: &Mesh| placed.low == mesh.bounds().low && placed.size == mesh.bounds().size();
        // A scope that is not the box of its geometry, as after a split with `noAdjust`, stays that way.
        let was_box = self.geometry.placed().is_none_or(|placed| is_box(&placed, &placed.mesh));
        let mirrored = self.looks_inwards();
        let placed = Placed { mirrored, ..Placed::fitted(mesh) };
        let (low, high) = (DVec3::ZERO.min(self.scope.size), DVec3::ZERO.max(self.scope.size));
        let bounds = placed.mesh.bounds();
        let near = ROUNDING_EPSILON * high.max(-low).max_element();
        let fits = was_box && bounds.low.abs_diff_eq(low, near) && bounds.high.abs_diff_eq(high, near);
        let whole = Placed { low: DVec3::ZERO, size: self.scope.size, ..placed.clone() };
        let is_upright = 0.0 <= self.scope.size.min_element();
        self.geometry = Geometry::Mesh(Arc::new(if fits && is_upright { placed } else { whole }));
        if !self.state.coordinates().is_empty() {
            self.state.change_look().coordinates = Coordinates::default();
        }
    }

    /// Replaces the geometry by a wire in scope coordinates. The scope becomes its bounding box.
    pub(crate) fn set_wire(&mut self, wire: Wire) {
        let placed = PlacedWire::flattened(wire);
        self.scope.origin += self.scope.axes * placed.low;
        self.scope.size = placed.size;
        self.geometry = Geometry::Wire(Arc::new(placed));
    }

    /// Sets the size. A size of zero flattens the geometry permanently.
    pub(crate) fn resize(&mut self, size: DVec3) {
        let flattens = self.scope.size.cmpne(DVec3::ZERO) & size.cmpeq(DVec3::ZERO);
        if flattens.any() {
            // Points that become one may have different coordinates.
            self.bake();
        }
        let before = self.scope;
        if let Some(unit) = self.geometry.unit_pressed_flat(size) {
            // Geometry that fills its scope would grow again with the scope; a flat mesh stays flat.
            self.geometry = Geometry::Mesh(Arc::new(Placed::unit(unit)));
        }
        if let Geometry::Mesh(placed) = &self.geometry {
            let flat = |axis: usize| size[axis] == 0.0 && placed.size[axis] != 0.0;
            if flat(0) || flat(1) || flat(2) {
                let keep = DVec3::select(size.cmpeq(DVec3::ZERO), DVec3::ZERO, DVec3::ONE);
                let move_low = DAffine3 { matrix3: DMat3::from_diagonal(keep), translation: -placed.low * keep };
                let mesh = Arc::new(placed.mesh.map(&move_low));
                let flattened = Placed { mesh, low: DVec3::ZERO, size: placed.size * keep, ..Placed::clone(placed) };
                self.geometry = Geometry::Mesh(Arc::new(flattened));
            }
        }
        self.scope.size = size;
        self.carry(&before);
    }

    /// The shape as the start of a run: trim planes of earlier operations do not cut.
    pub(crate) fn without_trim_planes(&self) -> Shape {
        Shape { trims: Trims::None, ..self.clone() }
    }
}
