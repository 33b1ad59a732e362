//! Geometries whose relations are asked for.

use std::sync::OnceLock;

use glam::{DAffine3, DMat3, DVec3, Vec3Swizzles as _};

use super::cuboid::{Cuboid, far};
use super::surface::Surface;
use crate::bounds::Bounds;
use crate::mesh::Mesh;

/// Larger coordinates overflow when they are multiplied.
pub(super) const LARGEST: f64 = 1e60;

/// A geometry to compare with [`Occluders`](super::Occluders): a mesh, a box, a rectangle, a segment or a point, in the world, in metres.
///
/// A geometry with coordinates that are not finite, or above 1e60, has no relation to any occluder; neither has a mesh without faces. A mesh
/// whose faces have no area counts as a segment or a point.
#[derive(Debug)]
pub struct QueryGeometry<'m> {
    pub(super) form: Form<'m>,
    pub(super) bounds: Bounds,
    /// The longest side.
    pub(super) extent: f64,
    /// The largest coordinate.
    pub(super) far: f64,
    /// Made when it is needed.
    surface: OnceLock<Surface>,
}

#[derive(Debug)]
pub(super) enum Form<'m> {
    Nothing,
    Cuboid(Cuboid),
    Mesh(&'m Mesh, DAffine3),
    /// A sheared box or a parallelogram.
    Faces(Vec<[DVec3; 4]>),
    Segment([DVec3; 2]),
    Point(DVec3),
}

impl<'m> QueryGeometry<'m> {
    /// A mesh that is placed in the world. Boxes and rectangles are found. A closed mesh is a volume, others are surfaces.
    pub fn mesh(mesh: &'m Mesh, placement: DAffine3) -> Self {
        if mesh.is_empty() {
            return Self::of(Form::Nothing, Bounds::EMPTY, 0.0);
        }
        let cuboid = Cuboid::of_mesh(mesh, &placement);
        let (form, bounds) = match cuboid {
            Some(cuboid) => (Form::Cuboid(cuboid), cuboid.bounds()),
            None => (Form::Mesh(mesh, placement), placed_bounds(mesh, &placement)),
        };
        let extent = cuboid.map_or(bounds.size().max_element(), |cuboid| cuboid.extent());
        Self::of(form, bounds, extent)
    }

    /// The box from (0, 0, 0) to (1, 1, 1), placed in the world. Flat boxes are rectangles, and boxes without two extents segments.
    pub fn cuboid(placement: DAffine3) -> Self {
        let sides = [placement.matrix3.x_axis, placement.matrix3.y_axis, placement.matrix3.z_axis];
        Self::of_sides(placement.translation, sides)
    }

    /// The box with a centre, orthogonal axes of length 1 and half of its extent along each. Flat boxes are rectangles, and boxes without two
    /// extents segments.
    ///
    /// ```
    /// use cga_geometry::glam::{DAffine3, DMat3, DVec3};
    /// use cga_geometry::relation::{Occluder, Occluders, QueryGeometry, Relation};
    ///
    /// let cube = Occluders::new([Occluder::cuboid(DAffine3::IDENTITY)]);
    /// let face = QueryGeometry::oriented(DVec3::new(0.5, 1.0, 0.5), DMat3::IDENTITY, DVec3::new(0.5, 0.0, 0.5));
    /// assert_eq!(cube.query(&face, Relation::ALL, &mut |_| true), Relation { overlaps: false, ..Relation::ALL });
    /// ```
    #[inline]
    pub fn oriented(centre: DVec3, axes: DMat3, half: DVec3) -> Self {
        let half = half.abs();
        let DMat3 { x_axis, y_axis, z_axis } = axes;
        let (axes, half) = match [half.x == 0.0, half.y == 0.0, half.z == 0.0] {
            [false, false, _] => (axes, half),
            // A rectangle has no extent along its last axis.
            [true, false, false] => (DMat3::from_cols(y_axis, z_axis, x_axis), half.yzx()),
            [false, true, false] => (DMat3::from_cols(z_axis, x_axis, y_axis), half.zxy()),
            _ => return Self::segment([centre - axes * half, centre + axes * half]),
        };
        let cuboid = Cuboid { centre, axes, half };
        Self::of(Form::Cuboid(cuboid), cuboid.bounds(), cuboid.extent())
    }

    /// The box around the geometry, along the axes of the world; empty for a geometry without a relation to any occluder.
    #[inline]
    pub fn bounds(&self) -> &Bounds {
        &self.bounds
    }

    /// The rectangle, or parallelogram, with a corner and two sides from it.
    pub fn rectangle(corner: DVec3, sides: [DVec3; 2]) -> Self {
        Self::of_sides(corner, [sides[0], sides[1], DVec3::ZERO])
    }

    /// The segment between two points.
    pub fn segment(ends: [DVec3; 2]) -> Self {
        if ends[0] == ends[1] {
            return Self::point(ends[0]);
        }
        Self::of(Form::Segment(ends), Bounds::of(ends), ends[0].distance(ends[1]))
    }

    /// A point.
    pub fn point(point: DVec3) -> Self {
        Self::of(Form::Point(point), Bounds { low: point, high: point }, 0.0)
    }

    fn of_sides(corner: DVec3, sides: [DVec3; 3]) -> Self {
        let [x, y, z] = sides;
        let opposite = corner + x + y + z;
        if sides.iter().filter(|side| **side != DVec3::ZERO).count() < 2 {
            return Self::segment([corner, opposite]);
        }
        if let Some(cuboid) = Cuboid::of_sides(corner, sides) {
            return Self::of(Form::Cuboid(cuboid), cuboid.bounds(), cuboid.extent());
        }
        let faces = sheared_faces(corner, sides);
        let bounds = Bounds::of(faces.iter().flatten().copied());
        Self::of(Form::Faces(faces), bounds, bounds.size().max_element())
    }

    #[inline]
    fn of(form: Form<'m>, bounds: Bounds, extent: f64) -> Self {
        let far = match &form {
            // As for boxes that are compared without a geometry.
            Form::Cuboid(cuboid) => far(cuboid.centre, cuboid.half),
            _ => bounds.low.abs().max(bounds.high.abs()).max_element(),
        };
        // Minima and maxima of coordinates leave NaN out, and sums do not.
        let sum = bounds.low + bounds.high;
        let is_finite = (sum.x + sum.y + sum.z).is_finite() && form.is_finite();
        if !is_finite || LARGEST < far {
            let (form, bounds) = (Form::Nothing, Bounds::EMPTY);
            return QueryGeometry { form, bounds, extent: 0.0, far: 0.0, surface: OnceLock::new() };
        }
        QueryGeometry { form, bounds, extent, far, surface: OnceLock::new() }
    }

    /// The faces of the geometry.
    pub(super) fn surface(&self) -> &Surface {
        self.surface.get_or_init(|| match &self.form {
            Form::Cuboid(cuboid) => Surface::of_faces(&cuboid.faces()),
            Form::Mesh(mesh, placement) => Surface::of_mesh(mesh, placement),
            Form::Faces(faces) => Surface::of_faces(faces),
            Form::Nothing | Form::Segment(_) | Form::Point(_) => Surface::of_faces(&[]),
        })
    }
}

impl Form<'_> {
    #[inline]
    fn is_finite(&self) -> bool {
        match self {
            Form::Nothing => false,
            // Its bounds are sums of all coordinates, and so is their sum.
            Form::Cuboid(_) => true,
            Form::Mesh(mesh, placement) => is_finite(mesh, placement),
            Form::Faces(faces) => faces.iter().flatten().all(|corner| corner.is_finite()),
            Form::Segment(ends) => ends.iter().all(|end| end.is_finite()),
            Form::Point(point) => point.is_finite(),
        }
    }
}

/// The bounding box of a mesh after it is placed.
pub(super) fn placed_bounds(mesh: &Mesh, placement: &DAffine3) -> Bounds {
    Bounds::of(mesh.points().iter().map(|point| placement.transform_point3(*point)))
}

/// Returns true if all points of a placed mesh are finite.
pub(super) fn is_finite(mesh: &Mesh, placement: &DAffine3) -> bool {
    mesh.points().iter().all(|point| placement.transform_point3(*point).is_finite())
}

/// The faces of a sheared box, counter-clockwise as seen from outside if its sides are right-handed. One face if it is flat.
pub(super) fn sheared_faces(corner: DVec3, [x, y, z]: [DVec3; 3]) -> Vec<[DVec3; 4]> {
    let face = |at: DVec3, a: DVec3, b: DVec3| [at, at + a, at + a + b, at + b];
    if [x, y, z].contains(&DVec3::ZERO) {
        let flat: Vec<DVec3> = [x, y, z].into_iter().filter(|side| *side != DVec3::ZERO).collect();
        return if let [a, b] = flat[..] { vec![face(corner, a, b)] } else { Vec::new() };
    }
    let opposite = corner + x + y + z;
    let low = [face(corner, y, x), face(corner, z, y), face(corner, x, z)];
    let high = [face(opposite, -x, -y), face(opposite, -y, -z), face(opposite, -z, -x)];
    [low, high].concat()
}
