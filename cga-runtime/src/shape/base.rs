//! The rarely changed part of shapes, and the conversion between slim and whole shapes.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::axes::Axes;
use super::{Counter, Geometry, Placed, Shape, ShapeRef};
use crate::geometry::Axis;
use crate::geometry::uv_map::{SetMap, UvMap};
use crate::shape::look::Look;
use crate::shape::look_id::LookId;
use crate::shape::scope::Scope;
use crate::shape::texture::kept::KeptMaps;
use crate::shape::trim::Trims;
use crate::shape::unit::UnitMesh;
use crate::value::text::Text;

/// A whole shape that slim shapes borrow from. The rule or the split that made it holds it.
#[derive(Debug)]
pub struct Base {
    axes: Axes,
    /// The axes after a rectangle across z has grown.
    raised: Axes,
    pub(crate) shape: Shape,
    look: LookId,
    maps: KeptMaps,
    /// True for each axis along which all implicit coordinates are constant, now and after `projectUV`.
    constant: [bool; 3],
}

/// The geometry of a slim shape. The sizes of all forms except `Other` are 0 or more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// A rectangle in the scope's low plane across an axis.
    Rect(Axis),
    /// The scope itself.
    Box,
    Empty,
    /// The geometry of the base.
    Other,
}

impl Base {
    /// The slim shape.
    #[inline]
    pub fn shape(&self) -> ShapeRef<'_> {
        ShapeRef::of(self, self.form(), self.look)
    }

    /// The base of a shape whose look has the number `look`. Inlined, and it calls nothing that can unwind, so
    /// the shape need not be in memory before it is in its base.
    #[inline(always)]
    pub(crate) fn new(shape: Shape, look: LookId) -> Self {
        let axes = Axes::new(shape.scope.axes);
        let constant = match shape.state.has_texture_space() {
            false => [true; 3],
            true => constant(&shape),
        };
        Base { axes, raised: axes.raised(), shape, look, maps: KeptMaps::default(), constant }
    }

    /// A base at the origin for a part that is moved there, with another look, and with its axes or the axes of the world. Projections stay
    /// where they are, so they are unknown.
    pub(crate) fn at_origin(part: &ShapeRef<'_>, look: LookId, keeps_axes: bool) -> Self {
        let axes = if keeps_axes { part.axes.matrix } else { DMat3::IDENTITY };
        let mut state = part.base.shape.state.clone();
        if !state.projections().is_empty() {
            let unknown = state.projections().unknown();
            state.change().projections = unknown;
        }
        let scope = Scope { axes, ..Scope::new(part.size.get()) };
        let shape = Shape {
            scope,
            pivot: scope.frame(),
            geometry: part.geometry(),
            seed: part.seed.get(),
            split: part.split.get(),
            comp: Counter::NONE,
            selector: Text::default(),
            trims: Trims::None,
            state,
        };
        Base { constant: part.base.constant, ..Base::new(shape, look) }
    }

    /// Changes the shape of the base, which keeps its look.
    #[inline(always)]
    pub(crate) fn change(&mut self, change: impl FnOnce(&mut Shape)) {
        change(&mut self.shape);
        self.axes = Axes::new(self.shape.scope.axes);
        // Rectangles alone grow.
        if matches!(self.shape.geometry, Geometry::Rect(..)) {
            self.raised = self.axes.raised();
        }
        self.maps = KeptMaps::default();
        if self.shape.state.has_texture_space() {
            self.constant = constant(&self.shape);
        }
    }

    /// The mesh of the shape, if it is one.
    pub(crate) fn into_mesh(self) -> Option<Arc<Placed>> {
        if let Geometry::Mesh(placed) = self.shape.geometry { Some(placed) } else { None }
    }

    #[inline]
    fn form(&self) -> (Form, UnitMesh) {
        let is_plain = 0.0 <= self.shape.scope.size.min_element();
        match self.shape.geometry {
            Geometry::Rect(axis, unit) if is_plain => (Form::Rect(axis), unit),
            Geometry::Box(unit) if is_plain => (Form::Box, unit),
            Geometry::Empty if is_plain => (Form::Empty, UnitMesh::cuboid()),
            _ => (Form::Other, UnitMesh::cuboid()),
        }
    }

    /// The maps of the texture coordinate sets of a leaf below this base, sorted by set. `look` has the number `id`;
    /// `None` is the base's own look.
    #[cold]
    #[inline(never)]
    pub(crate) fn maps(&self, id: LookId, look: Option<&Look>, normal: DVec3) -> &[SetMap] {
        let coordinates = &look.unwrap_or(self.shape.state.look()).coordinates;
        if coordinates.is_empty() {
            return &[];
        }
        // A rectangle that had coordinates when it became a cap.
        let is_cap = matches!(self.shape.geometry, Geometry::Rect(_, unit) if unit.has_unmapped_caps())
            && !self.shape.state.coordinates().is_empty();
        self.maps.of(id, || {
            let map = |set| {
                let (source, change) = coordinates.resolve(set, self.shape.state.projections())?;
                let map = source.map(normal)?;
                let map = if is_cap { UvMap::ZERO } else { map.then(&change) };
                Some(SetMap { set: usize::from(set), maps: map.into() })
            };
            coordinates.sets().filter_map(map).collect()
        })
    }

    /// Returns true if slim shapes with a numbered look are the same on both bases. Texture coordinates may differ.
    pub(crate) fn differs_in_look(&self, other: &Base) -> bool {
        let (own, its) = (&self.shape, &other.shape);
        let is_alike = own.pivot == its.pivot
            && own.comp == its.comp
            && own.selector == its.selector
            && matches!((&own.trims, &its.trims), (Trims::None, Trims::None));
        is_alike
            && own.state.coordinates().is_empty()
            && its.state.coordinates().is_empty()
            && own.state.differs_in_look(&its.state)
    }

    /// The axes of this shape.
    #[inline]
    pub(crate) fn axes(&self) -> &Axes {
        &self.axes
    }

    /// True for each axis along which all implicit coordinates are constant.
    #[inline]
    pub(crate) fn constant(&self) -> [bool; 3] {
        self.constant
    }

    /// The axes of this shape after it has grown.
    #[inline]
    pub(crate) fn raised(&self) -> &Axes {
        &self.raised
    }
}

/// True for each axis of a shape along which all implicit coordinates are constant, with those that `projectUV` would
/// make.
#[cold]
#[inline(never)]
fn constant(shape: &Shape) -> [bool; 3] {
    let maps = shape.state.projections().maps().chain(shape.state.coordinates().maps());
    let mut constant = [!shape.state.coordinates().has_cube(); 3];
    for map in maps {
        for (axis, constant) in constant.iter_mut().enumerate() {
            *constant &= map.is_constant_along(shape.scope.axes.col(axis));
        }
    }
    constant
}
