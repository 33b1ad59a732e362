//! `primitiveQuad`, `primitiveDisk`, `primitiveCube`, `primitiveSphere`, `primitiveCylinder` and `primitiveCone`.
//!
//! Without sizes they fill the scope, and zero sizes follow the rules of `i`. With sizes they are in the middle of
//! the scope's xz plane on y = 0. Quad and disk are across the only axis along which the scope has no size, if there
//! is one, otherwise across y. A radius is the radius of the circle through the corners. The scope is the box of the
//! geometry.

use glam::DVec3;

use crate::fault::FaultKind;
use crate::geometry::Axis;
use crate::geometry::primitive::PrimitiveKind;
use crate::op::create::insert_fit::{centre, face_outwards, fit, flat_axes, put};
use crate::op::settle;
use crate::run::env::Env;
use crate::shape::texture::UvSource;
use crate::shape::unit::UnitMesh;
use crate::shape::{Geometry, Shape};

/// The default number of sides and divisions.
const USUAL: u32 = 16;
/// The largest number of sides. Larger numbers are reduced to it, with a fault.
const MOST_SIDES: u32 = 100_000;
/// The largest number for a sphere: it is smaller, as a sphere has a row for each division.
const MOST_OF_SPHERE: u32 = 1000;

/// `primitiveCube()`: faces are bottom, top, front, right, back, left (*primitiveCube operation*).
pub fn cube(env: &mut Env, shape: &mut Shape) {
    fit(shape, DVec3::ZERO, DVec3::ONE);
    fill_with_cube(env, shape, true);
}

/// `primitiveCube(width, height, depth)` (*primitiveCube operation*).
pub fn cube_sized(env: &mut Env, shape: &mut Shape, width: f64, height: f64, depth: f64) {
    let size =
        DVec3::new(env.finite(width, "the width"), env.finite(height, "the height"), env.finite(depth, "the depth"));
    stand(env, shape, size, Axis::Y);
    fill_with_cube(env, shape, true);
}

/// `primitiveCylinder()`, with 16 sides, along y (*primitiveCylinder operation*).
pub fn cylinder(env: &mut Env, shape: &mut Shape) {
    cylinder_sides(env, shape, f64::from(USUAL));
}

/// `primitiveCylinder(sides)` (*primitiveCylinder operation*).
pub fn cylinder_sides(env: &mut Env, shape: &mut Shape, sides: f64) {
    let sides = count(env, sides, "sides of a cylinder", 3, MOST_SIDES);
    fill(env, shape, PrimitiveKind::Cylinder { sides });
}

/// `primitiveCylinder(sides, radius, height)` (*primitiveCylinder operation*).
pub fn cylinder_sized(env: &mut Env, shape: &mut Shape, sides: f64, radius: f64, height: f64) {
    let sides = count(env, sides, "sides of a cylinder", 3, MOST_SIDES);
    fill_to_height(env, shape, PrimitiveKind::Cylinder { sides }, radius, height);
}

/// `primitiveCone()` and `primitiveCone(sides)`, along y, its tip up (*primitiveCone operation*).
pub fn cone(env: &mut Env, shape: &mut Shape, sides: f64) {
    let sides = count(env, sides, "sides of a cone", 3, MOST_SIDES);
    fill(env, shape, PrimitiveKind::Cone { sides });
}

/// `primitiveCone(sides, radius, height)` (*primitiveCone operation*).
pub fn cone_sized(env: &mut Env, shape: &mut Shape, sides: f64, radius: f64, height: f64) {
    let sides = count(env, sides, "sides of a cone", 3, MOST_SIDES);
    fill_to_height(env, shape, PrimitiveKind::Cone { sides }, radius, height);
}

fn fill_to_height(env: &mut Env, shape: &mut Shape, made: PrimitiveKind, radius: f64, height: f64) {
    let (across, height) = (2.0 * env.finite(radius, "the radius"), env.finite(height, "the height"));
    fill_to_size(env, shape, made, DVec3::new(across, height, across), Axis::Y);
}

/// `primitiveSphere()`, with 16 sides and 16 divisions (*primitiveSphere operation*).
pub fn sphere(env: &mut Env, shape: &mut Shape) {
    sphere_sides(env, shape, f64::from(USUAL), f64::from(USUAL));
}

/// `primitiveSphere(sides, divisions)` (*primitiveSphere operation*).
pub fn sphere_sides(env: &mut Env, shape: &mut Shape, sides: f64, divisions: f64) {
    let made = sphere_of(env, sides, divisions);
    fill(env, shape, made);
}

/// `primitiveSphere(sides, divisions, radius)` (*primitiveSphere operation*).
pub fn sphere_sized(env: &mut Env, shape: &mut Shape, sides: f64, divisions: f64, radius: f64) {
    let made = sphere_of(env, sides, divisions);
    let size = DVec3::splat(2.0 * env.finite(radius, "the radius"));
    fill_to_size(env, shape, made, size, Axis::Y);
}

fn sphere_of(env: &mut Env, sides: f64, divisions: f64) -> PrimitiveKind {
    PrimitiveKind::Sphere {
        sides: count(env, sides, "sides of a sphere", 3, MOST_OF_SPHERE),
        divisions: count(env, divisions, "divisions of a sphere", 2, MOST_OF_SPHERE),
    }
}

/// `primitiveDisk()` and `primitiveDisk(nVertices)` (*primitiveDisk operation*).
pub fn disk(env: &mut Env, shape: &mut Shape, vertices: f64) {
    let sides = count(env, vertices, "vertices of a disk", 3, MOST_SIDES);
    let across = across(shape);
    let Some(mesh) = env.primitive(PrimitiveKind::Disk { sides, across }) else { return };
    fit_flat(shape, across);
    put(env, shape, mesh);
}

/// `primitiveDisk(nVertices, radius)` (*primitiveDisk operation*).
pub fn disk_sized(env: &mut Env, shape: &mut Shape, vertices: f64, radius: f64) {
    let sides = count(env, vertices, "vertices of a disk", 3, MOST_SIDES);
    let across = across(shape);
    let mut size = DVec3::splat(2.0 * env.finite(radius, "the radius"));
    size[across.index()] = 0.0;
    fill_to_size(env, shape, PrimitiveKind::Disk { sides, across }, size, across);
}

/// `primitiveQuad()` (*primitiveQuad operation*).
pub fn quad(env: &mut Env, shape: &mut Shape) {
    let across = across(shape);
    fit_flat(shape, across);
    put_quad(env, shape, across);
}

/// `primitiveQuad(width, length)` (*primitiveQuad operation*). The width is along x, or along y if the scope has no
/// size along x. The length is along z, or along y.
pub fn quad_sized(env: &mut Env, shape: &mut Shape, width: f64, length: f64) {
    let (width, length) = (env.finite(width, "the width"), env.finite(length, "the length"));
    let across = across(shape);
    let size = match across {
        Axis::X => DVec3::new(0.0, width, length),
        Axis::Y => DVec3::new(width, 0.0, length),
        Axis::Z => DVec3::new(width, length, 0.0),
    };
    stand(env, shape, size, across);
    put_quad(env, shape, across);
}

/// The only axis along which the scope has no size, otherwise y.
fn across(shape: &mut Shape) -> Axis {
    match flat_axes(shape) {
        [true, false, false] => Axis::X,
        [false, false, true] => Axis::Z,
        _ => Axis::Y,
    }
}

/// Sets the scope for flat geometry across an axis.
fn fit_flat(shape: &mut Shape, across: Axis) {
    if across == Axis::Y {
        fit(shape, DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0));
    }
    shape.scope.size[across.index()] = 0.0;
}

/// Makes a rectangle. Across x it needs a mesh, as rectangles without a mesh have another first edge there.
fn put_quad(env: &mut Env, shape: &mut Shape, across: Axis) {
    if across != Axis::X {
        let coordinates = UvSource::of_quad(&shape.scope, across);
        fill_plainly(env, shape, Geometry::Rect(across, UnitMesh::quad(across)), Some(coordinates));
    } else if let Some(mesh) = env.primitive(PrimitiveKind::Square { across }) {
        put(env, shape, mesh);
    }
}

/// Fills the scope with a primitive; zero sizes follow the rules of `i`.
fn fill(env: &mut Env, shape: &mut Shape, made: PrimitiveKind) {
    let Some(mesh) = env.primitive(made) else { return };
    fit(shape, DVec3::ZERO, DVec3::ONE);
    put(env, shape, mesh);
}

/// Puts a primitive, made in a box of that size, into the scope.
fn fill_to_size(env: &mut Env, shape: &mut Shape, made: PrimitiveKind, size: DVec3, across: Axis) {
    let Some(mesh) = env.primitive(made) else { return };
    stand(env, shape, mesh.bounds().size() * size, across);
    put(env, shape, mesh);
}

/// Replaces the geometry by a cube, with texture coordinates or without.
pub(in crate::op) fn fill_with_cube(env: &mut Env, shape: &mut Shape, is_textured: bool) {
    let coordinates = is_textured.then(|| UvSource::of_cube(&shape.scope));
    fill_plainly(env, shape, Geometry::Box(UnitMesh::cube()), coordinates);
}

/// Replaces the geometry by a box or a rectangle with those texture coordinates in set 0.
fn fill_plainly(env: &mut Env, shape: &mut Shape, geometry: Geometry, coordinates: Option<UvSource>) {
    shape.geometry = geometry;
    crate::op::inserted(env, shape);
    if let Some(source) = coordinates {
        shape.state.change_look().coordinates.set(0, source);
    }
    if env.initial.as_meshes || shape.geometry.unit_pressed_flat(shape.scope.size).is_some() {
        shape.hold_as_mesh();
    }
    face_outwards(shape);
    crate::op::trim(env, shape);
}

/// A number of sides or the like: an integer within limits.
fn count(env: &mut Env, wanted: f64, what: &str, least: u32, most: u32) -> u32 {
    let wanted = env.finite(wanted, format_args!("the number of {what}"));
    let count = wanted.clamp(f64::from(least), f64::from(most)) as u32;
    if f64::from(count) != wanted {
        env.fault(FaultKind::Value, format!("the number of {what} cannot be {wanted}; it is {count}"));
    }
    count
}

/// Gives the scope a size, in the middle of its old plane across an axis and on its floor.
fn stand(env: &mut Env, shape: &mut Shape, size: DVec3, across: Axis) {
    let before = shape.scope;
    centre(shape, size, across);
    settle(env, shape, &before, "the size of the primitive");
}

#[cfg(test)]
mod tests {
    use glam::DMat3;

    use super::*;
    use crate::op::{Length, size};
    use crate::shape::Shape;

    const LOT: DVec3 = DVec3::new(20.0, 0.0, 10.0);

    fn lot() -> Shape {
        Shape::rectangle(LOT.x, LOT.z).at([1.0, 2.0, 3.0])
    }

    fn sized(x: f64, y: f64, z: f64) -> Shape {
        let mut shape = Shape::cuboid(1.0, 1.0, 1.0);
        let [x, y, z] = [x, y, z].map(Length::Absolute);
        size(&mut Env::for_tests(), &mut shape, x, y, z);
        shape
    }

    type Fill = fn(&mut Env, &mut Shape);

    /// All solid primitives without sizes.
    const SOLID: [Fill; 4] =
        [cube, cylinder, |env, shape| cone(env, shape, 16.0), |env, shape| sphere_sides(env, shape, 16.0, 16.0)];

    #[test]
    fn a_primitive_on_a_flat_lot_is_as_high_as_it_is_wide_on_average() {
        for fill in SOLID {
            let (env, shape) = (&mut Env::for_tests(), &mut lot());
            fill(env, shape);
            assert_eq!(
                (shape.scope.size, shape.scope.origin),
                (DVec3::new(20.0, 15.0, 10.0), DVec3::new(1.0, 2.0, 3.0))
            );
            let mesh = shape.to_mesh();
            assert!((mesh.bounds().size() - shape.scope.size).length() < 1e-12 && mesh.is_closed());
            assert!(env.take_faults().0.is_empty());
        }
    }

    #[test]
    fn zero_sizes_follow_from_the_others() {
        for fill in SOLID {
            for (given, then) in [
                ([0.0, 0.0, 0.0], [1.0, 1.0, 1.0]),
                ([0.0, 4.0, 0.0], [4.0, 4.0, 4.0]),
                ([0.0, 4.0, 2.0], [3.0, 4.0, 2.0]),
                ([3.0, 4.0, 5.0], [3.0, 4.0, 5.0]),
                ([-3.0, 4.0, 5.0], [-3.0, 4.0, 5.0]),
            ] {
                let mut shape = sized(given[0], given[1], given[2]);
                fill(&mut Env::for_tests(), &mut shape);
                assert_eq!(shape.scope.size.to_array(), then);
            }
        }
    }

    #[test]
    fn primitives_with_sizes_stand_in_the_middle() {
        let (env, shape) = (&mut Env::for_tests(), &mut lot());
        cone_sized(env, shape, 8.0, 10.0, 15.0);
        // The radius is the radius of the circumcircle; eight sides, one in front, do not reach as far.
        let wide = 20.0 * libm::cos(std::f64::consts::PI / 8.0);
        assert!((shape.scope.size - DVec3::new(wide, 15.0, wide)).length() < 1e-12);
        let middle = DVec3::new(11.0, 9.5, 8.0);
        assert!((shape.scope.centre() - middle).length() < 1e-12);
        cylinder_sized(env, shape, 8.0, 10.0, 15.0);
        assert!((shape.scope.size - DVec3::new(wide, 15.0, wide)).length() < 1e-12);
        assert!((shape.scope.centre() - middle).length() < 1e-12);
        sphere_sized(env, shape, 8.0, 4.0, 10.0);
        assert!((shape.scope.size - DVec3::new(wide, 20.0, wide)).length() < 1e-12);
        assert!((shape.scope.centre() - DVec3::new(11.0, 12.0, 8.0)).length() < 1e-12);
        let far = |p: &DVec3| (shape.scope.frame().to_world(*p).distance(DVec3::new(11.0, 12.0, 8.0)) - 10.0).abs();
        assert!(shape.to_mesh().points().iter().all(|p| far(p) < 1e-12));
        cube_sized(env, shape, 10.0, 15.0, 20.0);
        assert!((shape.scope.centre() - middle).length() < 1e-12 && matches!(shape.geometry, Geometry::Box(_)));
        assert!(env.take_faults().0.is_empty());
    }

    #[test]
    fn flat_ones_lie_where_the_scope_is_flat() {
        // *primitiveQuad*, *primitiveDisk*: a scope without a size along one axis.
        for (flat, disk_size, quad_size) in [
            ([0.0, 20.0, 30.0], [0.0, 16.0, 16.0], [0.0, 10.0, 20.0]),
            ([20.0, 0.0, 30.0], [16.0, 0.0, 16.0], [10.0, 0.0, 20.0]),
            ([20.0, 30.0, 0.0], [16.0, 16.0, 0.0], [10.0, 20.0, 0.0]),
        ] {
            let axis = flat.iter().position(|size| *size == 0.0).unwrap();
            for (name, made, want) in [
                ("disk", (|env, shape| disk(env, shape, 16.0)) as Fill, flat),
                ("disk", |env, shape| disk_sized(env, shape, 4.0, 8.0 * std::f64::consts::SQRT_2), disk_size),
                ("quad", quad, flat),
                ("quad", |env, shape| quad_sized(env, shape, 10.0, 20.0), quad_size),
            ] {
                let shape = &mut sized(flat[0], flat[1], flat[2]);
                let centre = shape.scope.centre();
                made(&mut Env::for_tests(), shape);
                assert!((shape.scope.size - DVec3::from_array(want)).length() < 1e-12, "{name} {flat:?}");
                assert!((shape.scope.centre() - centre).length() < 1e-12);
                let mesh = shape.to_mesh();
                assert_eq!(mesh.face_count(), 1);
                assert!((mesh.face(0).normal() - DMat3::IDENTITY.col(axis)).length() < 1e-12);
            }
        }
        // Across x, they begin at the far top: u is opposite to y, v to z.
        let shape = &mut sized(0.0, 2.0, 3.0);
        quad(&mut Env::for_tests(), shape);
        let first: Vec<DVec3> = shape.to_mesh().points()[..2].to_vec();
        assert_eq!(first, [DVec3::new(0.0, 2.0, 3.0), DVec3::new(0.0, 0.0, 3.0)]);
        let shape = &mut sized(2.0, 3.0, 4.0);
        disk(&mut Env::for_tests(), shape, 16.0);
        assert_eq!(shape.scope.size.to_array(), [2.0, 0.0, 4.0]);
        let shape = &mut sized(0.0, 0.0, 0.0);
        disk(&mut Env::for_tests(), shape, 16.0);
        assert_eq!(shape.scope.size.to_array(), [1.0, 0.0, 1.0]);
    }

    #[test]
    fn a_size_that_is_zero_except_for_rounding_counts_as_zero() {
        let flat: [Fill; 4] = [
            quad,
            |env, shape| quad_sized(env, shape, 10.0, 20.0),
            |env, shape| disk(env, shape, 6.0),
            |env, shape| disk_sized(env, shape, 6.0, 8.0),
        ];
        for axis in 0..3 {
            let size = |rounding: f64| [0, 1, 2].map(|other| if other == axis { rounding } else { 3.0 });
            for fill in SOLID.into_iter().chain(flat) {
                let [exact, plus, minus] = [0.0, 7e-16, -3e-10].map(|rounding| {
                    let [x, y, z] = size(rounding);
                    let mut shape = sized(x, y, z);
                    fill(&mut Env::for_tests(), &mut shape);
                    (shape.scope, shape.to_mesh().points().to_vec())
                });
                assert_eq!(exact, plus);
                assert_eq!(exact, minus);
            }
        }
    }

    #[test]
    fn odd_numbers_leave_a_fault_and_a_shape() {
        for (sides, divisions, faces, faults) in [
            (0.0, 0.0, 6, 2),
            (-7.0, 2.0, 6, 1),
            (3.5, 2.0, 6, 1),
            (f64::NAN, f64::INFINITY, 6, 4),
            (1e300, 2.0, 2000, 1),
            (3.0, 1e300, 3000, 1),
        ] {
            let (env, shape) = (&mut Env::for_tests(), &mut lot());
            sphere_sides(env, shape, sides, divisions);
            assert_eq!(
                (shape.to_mesh().face_count(), env.take_faults().0.len()),
                (faces, faults),
                "{sides} {divisions}"
            );
        }
        for radius in [f64::NAN, 1e308, -1e308, 0.0] {
            let (env, shape) = (&mut Env::for_tests(), &mut lot());
            sphere_sized(env, shape, 8.0, 8.0, radius);
            cone_sized(env, shape, 8.0, radius, radius);
            disk_sized(env, shape, 8.0, radius);
            assert!(shape.scope.size.is_finite() && shape.scope.origin.is_finite());
            assert!(shape.to_mesh().points().iter().all(|p| p.is_finite()));
            assert_eq!(env.take_faults().0.is_empty(), radius == 0.0);
        }
    }

    #[test]
    fn faces_look_outwards_in_every_scope() {
        let with_sizes: [Fill; 4] = [
            |env, shape| cube_sized(env, shape, 1.0, -2.0, 3.0),
            |env, shape| cylinder_sized(env, shape, 8.0, 1.0, -3.0),
            |env, shape| cone_sized(env, shape, 8.0, 1.0, -3.0),
            |env, shape| sphere_sized(env, shape, 8.0, 8.0, -1.0),
        ];
        for flips in 0..8 {
            let side = |axis: usize| if flips >> axis & 1 == 1 { -2.0 } else { 2.0 };
            for fill in SOLID.into_iter().chain(with_sizes) {
                let (env, shape) = (&mut Env::for_tests(), &mut sized(side(0), side(1), side(2)));
                fill(env, shape);
                let mesh = shape.to_mesh();
                assert!(mesh.is_closed() && 0.1 < mesh.volume(), "{flips}: {}", mesh.volume());
                assert_eq!(mesh.check(), []);
                assert!(!shape.looks_inwards());
            }
            // Flat ones look along the axis of the scope.
            for axis in 0..3 {
                for fill in [quad as Fill, |env, shape| disk(env, shape, 5.0)] {
                    let size = |other: usize| if other == axis { 0.0 } else { side(other) };
                    let (env, shape) = (&mut Env::for_tests(), &mut sized(size(0), size(1), size(2)));
                    fill(env, shape);
                    assert!((shape.to_mesh().face(0).normal() - DMat3::IDENTITY.col(axis)).length() < 1e-12);
                }
            }
        }
    }
}
