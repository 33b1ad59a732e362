//! Initial shapes.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use super::{Counter, Geometry, Placed, Shape};
use crate::fault::Error;
use crate::geometry::face_frame::{self, FaceFrame};
use crate::geometry::mesh::{Bounds, Mesh};
use crate::geometry::tol::{ANGLE_EPSILON, ROUNDING_EPSILON};
use crate::geometry::{Axis, Frame};
use crate::shape::edge_attributes::EdgeAttribute;
use crate::shape::scope::Scope;
use crate::shape::seed::Seed;
use crate::shape::state::StateRef;
use crate::shape::street::Streets;
use crate::shape::trim::Trims;
use crate::shape::unit::UnitMesh;
use crate::value::text::Text;

impl Shape {
    /// A lot: a rectangle on the ground that faces up, `width` along x and `depth` along z, with a corner at the
    /// origin.
    pub fn rectangle(width: f64, depth: f64) -> Self {
        let scope = Scope::new(DVec3::new(width, 0.0, depth));
        // *comp operation*, coordinate systems: the first edge is the front, and the pivot its first vertex.
        let pivot = Frame { origin: DVec3::new(0.0, 0.0, depth), axes: DMat3::IDENTITY };
        Shape { pivot, ..Shape::with(scope, Geometry::Rect(Axis::Y, UnitMesh::rectangle(Axis::Y))) }
    }

    /// A box of that size with a corner at the origin. A run reports an error if a size is negative or not finite, as
    /// for every shape.
    pub fn cuboid(width: f64, height: f64, depth: f64) -> Self {
        Shape::with(Scope::new(DVec3::new(width, height, depth)), Geometry::Box(UnitMesh::cuboid()))
    }

    /// A straight line in the world, in metres. The x axis of its scope runs along it, the y axis is as upright as
    /// possible, and the scope has no height and no depth. Rules see an edge shape.
    ///
    /// # Errors
    /// [`Error::Shape`] if an end is not finite, or the length is 0 or not finite.
    pub fn line(from: impl Into<[f64; 3]>, to: impl Into<[f64; 3]>) -> Result<Self, Error> {
        let (from, to) = (DVec3::from_array(from.into()), DVec3::from_array(to.into()));
        let (x, length) = (crate::geometry::mesh::unit(to - from), (to - from).length());
        if !(from.is_finite() && length.is_finite() && 0.0 < length) {
            return Err(Error::Shape("a line needs two different ends, both finite".into()));
        }
        // An upright line has no side that faces up; its y axis points away from a viewer in front.
        let up = if x.x == 0.0 && x.z == 0.0 { DVec3::NEG_Z } else { DVec3::Y };
        let z = crate::geometry::mesh::unit(x.cross(up));
        let axes = DMat3::from_cols(x, z.cross(x), z);
        let scope = Scope { origin: from, axes, size: DVec3::new(length, 0.0, 0.0) };
        Ok(Shape::with(scope, Geometry::Edge))
    }

    /// A point in the world, in metres. Its scope has no size. Rules see a vertex shape. A run from a point that is
    /// not finite reports an error.
    pub fn point(at: impl Into<[f64; 3]>) -> Self {
        let scope = Scope { origin: DVec3::from_array(at.into()), ..Scope::new(DVec3::ZERO) };
        Shape::with(scope, Geometry::Vertex)
    }

    /// A footprint on the ground, with holes. Corners are (x, z) in metres, as arrays, pairs or
    /// [`DVec2`](glam::DVec2), and the first edge is the front. Outlines may have either winding; the footprint faces up.
    ///
    /// # Errors
    /// [`Error::Shape`] if the outline is not a polygon: too few corners, no area, numbers that are not finite.
    pub fn footprint<P: Copy + Into<[f64; 2]>>(outline: &[P], holes: &[Vec<P>]) -> Result<Self, Error> {
        fn corners<P: Copy + Into<[f64; 2]>>(ring: &[P]) -> Vec<[f64; 2]> {
            ring.iter().map(|&corner| corner.into()).collect()
        }
        let holes: Vec<Vec<[f64; 2]>> = holes.iter().map(|hole| corners(hole)).collect();
        Shape::footprint_of(&corners(outline), &holes)
    }

    /// [`Shape::footprint`], compiled once.
    fn footprint_of(outline: &[[f64; 2]], holes: &[Vec<[f64; 2]>]) -> Result<Self, Error> {
        let on_ground = |ring: &[[f64; 2]]| ring.iter().map(|p| DVec3::new(p[0], 0.0, p[1])).collect::<Vec<_>>();
        let mut outer = on_ground(outline);
        // Seen from above, with x to the right and z towards the viewer, the area of a counter-clockwise outline is
        // negative.
        let twice_area: f64 = (0..outline.len())
            .map(|i| (outline[i], outline[(i + 1) % outline.len()]))
            .map(|(a, b)| a[0] * b[1] - b[0] * a[1])
            .sum();
        if 0.0 < twice_area {
            // Reverses the winding but keeps the first edge in front.
            outer.reverse();
            let turn = 2.min(outer.len());
            outer.rotate_right(turn);
        }
        let holes: Vec<Vec<DVec3>> = holes.iter().map(|hole| on_ground(hole)).collect();
        let mesh = Mesh::from_polygon(&outer, &holes).map_err(|error| Error::Shape(error.to_string()))?;
        Ok(match face_frame::face_frame(&mesh, 0) {
            Some(found) if found.rectangle => Shape::rectangular_lot(&found),
            _ => Shape::mesh(mesh),
        })
    }

    /// A lot that is a rectangle.
    fn rectangular_lot(found: &FaceFrame) -> Self {
        let pivot = face_frame::object(found);
        let size = DVec3::new(found.high.x - found.low.x, 0.0, found.high.y - found.low.y);
        let scope = Scope { origin: pivot.origin - pivot.axes.z_axis * size.z, axes: pivot.axes, size };
        Shape { pivot, ..Shape::with(scope, Geometry::Rect(Axis::Y, UnitMesh::rectangle(Axis::Y))) }
    }

    /// A mesh in world coordinates, aligned to its first face as CityEngine aligns initial shapes (*CGA essentials*,
    /// object coordinate system; *alignScopeToGeometryBBox operation*, initial shape).
    ///
    /// The x axis of scope and pivot runs along the first edge of the first face, the y axis along the normal of that
    /// face. The pivot is at the start of the edge, and the scope is the box of the mesh along these axes. Rules that
    /// split along y or select `top` work in this frame. This suits lots and roofs. The first face of a solid is
    /// often another one: if it is a wall, y points out of the wall, and if it is the bottom, y points down. Use
    /// [`Shape::mesh_axis_aligned`] for solids that are upright in the world.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::mesh::FaceTag;
    /// use cga::{MeshBuilder, Shape};
    ///
    /// // A wall 4 m long and 3 m high that runs along the world's z axis.
    /// let mut builder = MeshBuilder::new();
    /// let corners = [[0., 0., 4.], [0., 0., 0.], [0., 3., 0.], [0., 3., 4.]].map(|corner| builder.point(corner));
    /// builder.face(&corners, &[], FaceTag::PLAIN);
    /// let wall = builder.build().unwrap();
    ///
    /// let aligned = Shape::mesh(wall.clone());
    /// assert_eq!(aligned.scope().axes.x_axis.to_array(), [0.0, 0.0, -1.0]); // along the first edge
    /// assert_eq!(aligned.scope().axes.y_axis.to_array(), [1.0, 0.0, 0.0]); // out of the face
    /// assert_eq!(aligned.scope().size.to_array(), [4.0, 0.0, 3.0]);
    /// assert_eq!(aligned.pivot().origin.to_array(), [0.0, 0.0, 4.0]);
    ///
    /// let upright = Shape::mesh_axis_aligned(wall);
    /// assert_eq!(upright.scope().size.to_array(), [0.0, 3.0, 4.0]);
    /// ```
    ///
    /// Faces without an area and edges without a length are skipped. A mesh without other faces is aligned to the
    /// world's axes.
    pub fn mesh(mesh: Mesh) -> Self {
        let Some(pivot) = face_frame::object_of(&mesh) else { return Shape::mesh_axis_aligned(mesh) };
        let to_local = pivot.axes.transpose();
        let local = mesh.map(&DAffine3 { matrix3: to_local, translation: -(to_local * pivot.origin) });
        let placed = Placed::fitted(flat_on_ground(local, mesh.bounds()));
        let scope = Scope { origin: pivot.to_world(placed.low), axes: pivot.axes, size: placed.size };
        Shape { pivot, ..Shape::with(scope, Geometry::Mesh(Arc::new(placed))) }
    }

    /// A mesh in world coordinates, with its bounding box along the world's axes as scope. The pivot is at the lowest
    /// corner of the box. [`Shape::mesh`] aligns to the first face instead, as CityEngine does.
    pub fn mesh_axis_aligned(mesh: Mesh) -> Self {
        let placed = Placed::fitted(mesh);
        let scope = Scope { origin: placed.low, axes: DMat3::IDENTITY, size: placed.size };
        Shape::with(scope, Geometry::Mesh(Arc::new(placed)))
    }

    fn with(scope: Scope, geometry: Geometry) -> Self {
        let mut shape = Shape {
            scope,
            pivot: scope.frame(),
            geometry,
            seed: Seed::new(0),
            split: Counter::NONE,
            comp: Counter::NONE,
            selector: Text::default(),
            trims: Trims::None,
            state: StateRef::UNSET,
        };
        if shape.geometry.unit_pressed_flat(scope.size).is_some() {
            shape.hold_as_mesh();
        }
        shape
    }

    /// Moves the shape by an offset in metres, in the world.
    pub fn at(mut self, offset: impl Into<[f64; 3]>) -> Self {
        let offset = DVec3::from_array(offset.into());
        self.scope.origin += offset;
        self.pivot.origin += offset;
        self
    }

    /// Sets the seed. Every random choice of a run follows from it.
    pub fn seed(mut self, seed: u64) -> Self {
        self.seed = Seed::new(seed);
        self
    }

    /// Sets the name, which rules read as `initialShape.name`.
    pub fn named(mut self, name: impl Into<Text>) -> Self {
        self.state.change().name = name.into();
        self
    }

    /// Sets the streets: the width in metres of the street at each edge of the first face, from the first edge on. An
    /// edge with 0, or beyond the end of the list, has no street. The selectors `street.front` and so on use the
    /// streets (*comp operation*, street selectors). Without any street they equal the selectors of the object.
    pub fn streets(mut self, widths: impl Into<Arc<[f64]>>) -> Self {
        self.state.change().street_widths = widths.into();
        self
    }

    /// Sets an attribute of the edges: a value for each edge of each face, from the first edge of the first face on. An edge
    /// that two faces share has a value for each of them. Rules read it with `edgeAttr.getString(name)` and its like, and make
    /// tags of it with `setTagsFromEdgeAttrs`. Edges beyond the end of the list have no value.
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::Shape;
    ///
    /// let lot = Shape::rectangle(20.0, 15.0).edge_attribute("use", ["street", "garden", "garden", "path"]);
    /// ```
    pub fn edge_attribute(mut self, name: impl Into<Text>, values: impl Into<EdgeAttribute>) -> Self {
        Arc::make_mut(&mut self.state.change().edge_attributes).insert(name.into(), values.into());
        self
    }

    /// Makes a run hold every box and rectangle as a mesh. No result depends on it; tests compare both.
    #[doc(hidden)]
    pub fn held_as_meshes(mut self) -> Self {
        self.state.change().as_meshes = true;
        self.hold_as_mesh();
        self
    }

    /// The classes of the edges by their streets.
    pub(crate) fn find_streets(&self) -> Option<Arc<Streets>> {
        let widths = self.state.get().map(|state| &*state.street_widths).filter(|widths| !widths.is_empty())?;
        let mesh = self.to_mesh();
        let frame = self.scope.frame();
        let streets = Streets::of(&mesh.faces().next()?, widths, |point| frame.to_world(point));
        streets.map(Arc::new)
    }

    /// Checks that a run can use the shape: orthonormal axes, finite and bounded sizes and positions.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let scope = &self.scope;
        let square = (scope.axes.transpose() * scope.axes).abs_diff_eq(DMat3::IDENTITY, 1e-9);
        if !square {
            Err(Error::Shape("the axes of the shape are not at right angles and of length 1".into()))
        } else if scope.is_bounded() {
            Ok(())
        } else {
            Err(Error::Shape("a size or position of the initial shape is NaN, infinite or too large".into()))
        }
    }

    /// Checks that a run can start with the shape. A negative size mirrors a shape inside a run, but an initial shape
    /// has none. A mapped mesh may have coordinates that are NaN, which no bounding box shows.
    pub(crate) fn check_initial(&self) -> Result<(), Error> {
        if self.scope.size.min_element() < 0.0 {
            let message = format!("the initial shape has a negative size: {}", self.scope.size);
            return Err(Error::Shape(message));
        }
        if let Geometry::Mesh(placed) = &self.geometry
            && !placed.mesh.points().iter().all(|point| point.is_finite())
        {
            return Err(Error::Shape("a coordinate of the initial shape is NaN or infinite".into()));
        }
        self.check()
    }
}

/// A mesh in the frame of its first face. If all points are in the plane of that face except for rounding, their y
/// becomes exactly 0, as operations test for sizes of zero. `world` is the box of the points before, which gives the
/// size of the rounding.
fn flat_on_ground(mesh: Mesh, world: Bounds) -> Mesh {
    let bounds = mesh.bounds();
    let largest = world.low.abs().max(world.high.abs()).max_element();
    let near = ANGLE_EPSILON * bounds.size().max_element() + ROUNDING_EPSILON * largest;
    let height = bounds.low.y.abs().max(bounds.high.y.abs());
    if height == 0.0 || near < height {
        return mesh;
    }
    let points = mesh.points().iter().map(|&point| DVec3 { y: 0.0, ..point }).collect();
    mesh.with_points(points)
}
