//! `extrude`: faces become volumes.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DVec3};

use crate::geometry::Axis;
use crate::geometry::extrude::{Extrude, extrude as extrude_mesh, vertex_normals};
use crate::geometry::extrude_wire::{extrude_wire, point_normals};
use crate::geometry::mesh::Mesh;
use crate::geometry::wire::Wire;
use crate::op::scope::align::upright;
use crate::op::{Length, leads_beyond};
use crate::run::env::Env;
use crate::shape::scope::Scope;
use crate::shape::{Geometry, Placed, Shape};

/// The direction of an extrusion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExtrudeAlong {
    /// Each face along its own normal.
    FaceNormal,
    /// Each point along the average of the normals around it.
    VertexNormal,
    /// Along the world's y axis.
    WorldUp,
    /// Along the world's y axis, to one height.
    WorldUpFlatTop,
}

/// An axis of an extrusion in the old form. With and without `world.` it is the world's axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the language defines the names")]
pub enum ExtrudeAxis {
    X,
    Y,
    Z,
    WorldX,
    WorldZ,
}

/// `extrude(distance)`, along the face normals (*extrude operation*).
pub fn extrude(env: &mut Env, shape: &mut Shape, distance: Length) {
    extrude_along(env, shape, ExtrudeAlong::FaceNormal, distance);
}

/// `extrude(face.normal | vertex.normal | world.up | world.up.flatTop, distance)` (*extrude operation*). The new
/// scope's y axis points along the extrusion, or along the normal of the first face or vertex. Its x axis stays as
/// near as possible to the old one, and the pivot stays. A distance of 0 changes nothing, except that a flat top is
/// still made.
pub fn extrude_along(env: &mut Env, shape: &mut Shape, along: ExtrudeAlong, distance: Length) {
    // Relative to the height: a shape grows along its new y axis.
    let distance = distance.of(shape.scope.size.y, env, "the distance of `extrude`");
    if distance == 0.0 && along != ExtrudeAlong::WorldUpFlatTop {
        return;
    }
    if shape.has_unmapped_caps() {
        // The sides of a cap that grows have its coordinates.
        shape.bake();
    }
    let grown = match shape.geometry {
        Geometry::Rect(axis, unit) if straight(&shape.scope, axis, along) => {
            Some((raised(&shape.scope, axis, distance), Geometry::Box(unit.grown(axis))))
        }
        _ => None,
    };
    if grown.as_ref().is_some_and(|(scope, _)| !scope.is_bounded()) {
        return leads_beyond(env, "`extrude`");
    }
    if !shape.state.coordinates().is_empty() {
        match [Axis::X, Axis::Y, Axis::Z].into_iter().find(|axis| straight(&shape.scope, *axis, along)) {
            Some(axis) => shape.raise_coordinates(axis),
            None => shape.bake(),
        }
    }
    match (&shape.geometry, grown) {
        (Geometry::Empty | Geometry::Vertex, _) => {}
        (_, Some(grown)) => {
            if distance != 0.0 {
                (shape.scope, shape.geometry) = grown;
            }
        }
        (_, None) => {
            let up = shape.scope.axes.transpose() * DVec3::Y;
            let how = match along {
                ExtrudeAlong::FaceNormal => Extrude::FaceNormal,
                ExtrudeAlong::VertexNormal => Extrude::VertexNormal,
                ExtrudeAlong::WorldUp => Extrude::Vector(up),
                ExtrudeAlong::WorldUpFlatTop => Extrude::FlatTop(up),
            };
            extrude_any(env, shape, how, distance);
        }
    }
}

/// Edges become faces (*extrude operation*, extrusion of edges).
fn extrude_edges(env: &mut Env, shape: &mut Shape, wire: &Wire, how: Extrude, distance: f64) {
    let first = |normals: &[DVec3]| normals.iter().copied().find(|normal| *normal != DVec3::ZERO);
    let up = match how {
        Extrude::Vector(up) | Extrude::FlatTop(up) => Some(up),
        Extrude::FaceNormal => first(&wire.normals),
        Extrude::VertexNormal => first(&point_normals(wire)),
    };
    if env.count_corners(4 * wire.edges.len() as u64).is_break() {
        return;
    }
    match (up, extrude_wire(wire, how, distance)) {
        (Some(up), Ok(grown)) => stand(env, shape, grown, up, distance, "`extrude`"),
        _ => leads_beyond(env, "`extrude`"),
    }
}

/// `extrude(x | y | z | world.x | world.z, distance)`, the old form (*CGA changelog 2009.2*).
pub fn extrude_axis(env: &mut Env, shape: &mut Shape, axis: ExtrudeAxis, distance: Length) {
    let along = match axis {
        ExtrudeAxis::Y => return extrude_along(env, shape, ExtrudeAlong::WorldUp, distance),
        ExtrudeAxis::X | ExtrudeAxis::WorldX => DVec3::X,
        ExtrudeAxis::Z | ExtrudeAxis::WorldZ => DVec3::Z,
    };
    let distance = distance.of(shape.scope.size.y, env, "the distance of `extrude`");
    if distance != 0.0 && !matches!(shape.geometry, Geometry::Empty | Geometry::Vertex) {
        let along = shape.scope.axes.transpose() * along;
        shape.bake();
        extrude_any(env, shape, Extrude::Vector(along), distance);
    }
}

/// Returns true if a rectangle across `axis` grows along that axis into a box. It must have an area and not be
/// mirrored.
fn straight(scope: &Scope, axis: Axis, along: ExtrudeAlong) -> bool {
    let upwards = matches!(along, ExtrudeAlong::WorldUp | ExtrudeAlong::WorldUpFlatTop);
    let has_area = (0..3).all(|other| match other == axis.index() {
        true => scope.size[other] == 0.0,
        false => 0.0 < scope.size[other],
    });
    has_area && (!upwards || scope.axes.col(axis.index()) == DVec3::Y)
}

/// The scope of a rectangle across `axis` that has grown along it.
fn raised(scope: &Scope, axis: Axis, distance: f64) -> Scope {
    let (o, s, [x, y, z]) = (scope.origin, scope.size, [scope.axes.x_axis, scope.axes.y_axis, scope.axes.z_axis]);
    match axis {
        Axis::Y => Scope { size: DVec3::new(s.x, distance, s.z), ..*scope },
        Axis::Z => {
            Scope { origin: o + y * s.y, axes: DMat3::from_cols(x, z, -y), size: DVec3::new(s.x, distance, s.y) }
        }
        Axis::X => {
            Scope { origin: o + y * s.y, axes: DMat3::from_cols(-y, x, z), size: DVec3::new(s.y, distance, s.z) }
        }
    }
}

fn extrude_any(env: &mut Env, shape: &mut Shape, how: Extrude, distance: f64) {
    // Steps on slim shapes do not check the watch.
    if env.ask().is_break() {
        return;
    }
    if let Some(wire) = shape.to_wire() {
        return extrude_edges(env, shape, &wire, how, distance);
    }
    // Implicit texture coordinates have been raised.
    let mesh = shape.own_mesh();
    let first_normal = || mesh.faces().map(|face| face.normal()).find(|normal| *normal != DVec3::ZERO);
    let up = match how {
        Extrude::Vector(up) | Extrude::FlatTop(up) => up,
        Extrude::FaceNormal => first_normal().unwrap_or(DVec3::Y),
        Extrude::VertexNormal => {
            let normals = vertex_normals(&mesh);
            let first = mesh.corners().iter().map(|&point| normals[point as usize]).find(|it| *it != DVec3::ZERO);
            first.or_else(first_normal).unwrap_or(DVec3::Y)
        }
    };
    // Every edge gets a wall of four corners, and each face a top and a bottom.
    if env.count_corners(6 * mesh.corners().len() as u64).is_break() {
        return;
    }
    stand(env, shape, extrude_mesh(&mesh, how, distance), up, distance, "`extrude`");
}

/// Gives the shape the extruded mesh, in the coordinates of its old scope, with a scope whose y axis is `up`.
pub(in crate::op) fn stand(env: &mut Env, shape: &mut Shape, grown: Mesh, up: DVec3, distance: f64, what: &str) {
    stand_along(env, shape, grown, upright(&DMat3::IDENTITY, up, 1), distance, what);
}

/// Gives the shape the extruded mesh, in the coordinates of its old scope, with a scope along other axes in these coordinates.
pub(in crate::op) fn stand_along(
    env: &mut Env,
    shape: &mut Shape,
    mut grown: Mesh,
    turn: DMat3,
    distance: f64,
    what: &str,
) {
    if grown.is_empty() {
        // Nothing moved.
        return;
    }
    shape.hand_trace_to(&mut grown);
    let axes = shape.scope.axes;
    let local = grown.into_mapped(&DAffine3 { matrix3: turn.transpose(), translation: DVec3::ZERO });
    let mut placed = Placed::fitted(local);
    let axes = axes * turn;
    let mut size = placed.size;
    let mut origin = shape.scope.origin + axes * placed.low;
    if distance < 0.0 && size.y != 0.0 {
        // *extrude operation*: a negative distance gives a negative height, and the faces look inwards.
        let flip = DAffine3::from_scale(DVec3::new(1.0, -1.0, 1.0));
        placed = Placed::fitted(placed.mesh.map(&flip));
        origin += axes.y_axis * size.y;
        size.y = -size.y;
    }
    let scope = Scope { origin, axes, size };
    if !scope.is_bounded() {
        return leads_beyond(env, what);
    }
    shape.scope = scope;
    shape.geometry = Geometry::Mesh(Arc::new(placed));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::op::rotate;
    use crate::shape::Shape;

    const ALL: [ExtrudeAlong; 4] =
        [ExtrudeAlong::FaceNormal, ExtrudeAlong::VertexNormal, ExtrudeAlong::WorldUp, ExtrudeAlong::WorldUpFlatTop];

    #[test]
    fn a_run_that_has_ended_extrudes_no_mesh() {
        let (env, mut shape) = (&mut Env::for_tests(), slope());
        assert!(env.limit::<()>(crate::fault::LimitKind::Shapes, 1).is_break());
        let before = shape.to_mesh();
        extrude(env, &mut shape, Length::Absolute(1.0));
        extrude_axis(env, &mut shape, ExtrudeAxis::X, Length::Absolute(1.0));
        assert_eq!(before.points(), shape.to_mesh().points());
    }

    /// A lot on a slope, from 0 to 3 metres high, 4 by 5 metres as seen from above.
    fn slope() -> Shape {
        let corners = [[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [4.0, 3.0, 0.0], [0.0, 3.0, 0.0]].map(DVec3::from_array);
        Shape::mesh_axis_aligned(Mesh::from_polygon(&corners, &[]).expect("a rectangle")).at([7.0, 8.0, 9.0])
    }

    fn grown(mut shape: Shape, along: ExtrudeAlong, distance: f64) -> Shape {
        let env = &mut Env::for_tests();
        let before = shape.clone();
        extrude_along(env, &mut shape, along, Length::Absolute(distance));
        assert!(env.take_faults().0.is_empty());
        assert_eq!(shape.pivot, before.pivot);
        let (axes, mesh) = (shape.scope.axes, shape.to_mesh());
        assert!((axes.transpose() * axes).abs_diff_eq(DMat3::IDENTITY, 1e-12) && 0.0 < axes.determinant());
        // The scope fits. Its size along y is negative for a negative distance.
        let (low, high) = (DVec3::ZERO.min(shape.scope.size), DVec3::ZERO.max(shape.scope.size));
        assert!((mesh.bounds().low - low).length() < 1e-9 && (mesh.bounds().high - high).length() < 1e-9);
        assert_eq!(shape.scope.size.y < 0.0, distance < 0.0);
        shape
    }

    #[test]
    fn upright_extrusion_follows_the_slope_or_ends_flat() {
        use ExtrudeAlong::{WorldUp, WorldUpFlatTop};
        // *extrude operation*, along the world's axis: the height above the ground, top and bottom in the world.
        for (along, distance, volume, low, high) in [
            (WorldUp, 10.0, 200.0, 0.0, 13.0),
            (WorldUpFlatTop, 10.0, 170.0, 0.0, 10.0),
            (WorldUpFlatTop, 2.0, 30.0, 0.0, 3.0),
            (WorldUpFlatTop, 0.0, 30.0, 0.0, 3.0),
            (WorldUpFlatTop, -2.0, -30.0, 0.0, 3.0),
            (WorldUpFlatTop, -10.0, -170.0, -7.0, 3.0),
            (WorldUp, -1.0, -20.0, -1.0, 3.0),
        ] {
            for [x, y, z] in [[0.0; 3], [0.0, 40.0, 0.0]] {
                let (env, mut start) = (&mut Env::for_tests(), slope());
                rotate(env, &mut start, x, y, z);
                let shape = grown(start, along, distance);
                let mesh = shape.to_mesh();
                assert!(mesh.is_closed() && mesh.check().is_empty());
                assert!((mesh.volume() - volume).abs() < 1e-9, "{along:?} {distance}: {}", mesh.volume());
                assert!((shape.scope.axes.y_axis - DVec3::Y).length() < 1e-12);
                let ends = [shape.scope.origin.y, shape.scope.origin.y + shape.scope.size.y].map(|y| y - 8.0);
                assert!((ends[0].min(ends[1]) - low).abs() < 1e-9 && (ends[0].max(ends[1]) - high).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn the_first_normal_is_the_new_y_axis() {
        for along in [ExtrudeAlong::FaceNormal, ExtrudeAlong::VertexNormal] {
            let normal = slope().to_mesh().face(0).normal();
            for distance in [2.0, -2.0] {
                let shape = grown(slope(), along, distance);
                assert!((shape.scope.axes.y_axis - normal).length() < 1e-12);
                assert_eq!((shape.scope.axes.x_axis, shape.scope.size.y.abs() - 2.0 < 1e-12), (DVec3::X, true));
            }
        }
    }

    #[test]
    fn level_rectangles_become_boxes() {
        for along in ALL {
            let shape = grown(Shape::rectangle(4.0, 5.0), along, 6.0);
            assert!(matches!(shape.geometry, Geometry::Box(_)) && shape.scope.size == DVec3::new(4.0, 6.0, 5.0));
            let shape = grown(Shape::rectangle(4.0, 5.0), along, 0.0);
            assert!(matches!(shape.geometry, Geometry::Rect(Axis::Y, _)));
        }
    }

    #[test]
    fn the_old_form_names_an_axis_of_the_world() {
        let wall = || {
            let (env, mut wall) = (&mut Env::for_tests(), Shape::rectangle(4.0, 5.0));
            rotate(env, &mut wall, 90.0, 0.0, 0.0);
            wall
        };
        for (axis, along, volume) in [
            (ExtrudeAxis::Z, DVec3::Z, 40.0),
            (ExtrudeAxis::WorldZ, DVec3::Z, 40.0),
            (ExtrudeAxis::X, DVec3::X, 0.0),
            (ExtrudeAxis::WorldX, DVec3::X, 0.0),
            (ExtrudeAxis::Y, DVec3::Y, 0.0),
        ] {
            let (env, mut shape) = (&mut Env::for_tests(), wall());
            extrude_axis(env, &mut shape, axis, Length::Absolute(2.0));
            assert!((shape.scope.axes.y_axis - along).length() < 1e-12, "{axis:?}");
            assert!((shape.to_mesh().volume() - volume).abs() < 1e-12 && shape.to_mesh().is_closed());
            extrude_axis(env, &mut shape, axis, Length::Absolute(f64::NAN));
            assert_eq!(env.take_faults().0.len(), 1);
        }
    }

    #[test]
    fn distances_beyond_all_bounds_change_nothing() {
        for along in ALL {
            for huge in [1e308_f64, -1e308] {
                let (env, mut shape) = (&mut Env::for_tests(), slope());
                shape.resize(DVec3::splat(huge.abs()));
                extrude_along(env, &mut shape, along, Length::Absolute(huge));
                extrude_along(env, &mut shape, along, Length::Relative(huge));
                assert!(shape.scope.size.is_finite() && shape.scope.origin.is_finite());
                assert!(shape.to_mesh().points().iter().all(|p| p.is_finite()));
            }
        }
    }

    #[test]
    fn rectangles_that_would_be_too_high_stay_with_a_fault() {
        for distance in [1e150, -1e150, 1e300, -1e300] {
            let (env, mut shape) = (&mut Env::for_tests(), Shape::rectangle(3.0, 4.0));
            extrude(env, &mut shape, Length::Absolute(distance));
            assert_eq!((shape.scope.size, shape.to_mesh().area()), (DVec3::new(3.0, 0.0, 4.0), 12.0), "{distance}");
            assert_eq!(env.take_faults().0.len(), 1, "{distance}");
            extrude(env, &mut shape, Length::Absolute(1e149_f64.copysign(distance)));
            assert!(shape.to_mesh().area().is_finite() && env.take_faults().0.is_empty());
        }
    }

    #[test]
    fn axes_stay_axes_where_x_is_upright_but_for_rounding() {
        for degrees in 0..360 {
            let (env, mut start) = (&mut Env::for_tests(), slope());
            rotate(env, &mut start, 0.0, f64::from(degrees), 0.0);
            rotate(env, &mut start, 0.0, 0.0, 90.0);
            for (along, volume) in [(ExtrudeAlong::WorldUp, 2.0), (ExtrudeAlong::WorldUpFlatTop, 2.0)] {
                let grown = grown(start.clone(), along, volume);
                assert!(1.0 < grown.to_mesh().area());
            }
        }
    }

    #[test]
    fn edges_become_faces() {
        // Two edges at a right angle that look up and aside, like edges of a comp.
        let wire = Wire {
            points: vec![DVec3::ZERO, DVec3::X * 3.0, DVec3::new(3.0, 0.0, -2.0)],
            edges: vec![[0, 1], [1, 2]],
            normals: vec![DVec3::Y, DVec3::X],
            ..Wire::default()
        };
        let mut shape = Shape::cuboid(1.0, 1.0, 1.0);
        shape.set_wire(wire);
        for (along, points, area) in [
            (ExtrudeAlong::FaceNormal, 7, 20.0),
            (ExtrudeAlong::VertexNormal, 6, 0.0),
            (ExtrudeAlong::WorldUp, 6, 20.0),
            (ExtrudeAlong::WorldUpFlatTop, 6, 20.0),
        ] {
            let (env, mut own) = (&mut Env::for_tests(), shape.clone());
            extrude_along(env, &mut own, along, Length::Absolute(4.0));
            let mesh = own.to_mesh();
            assert_eq!((mesh.face_count(), mesh.points().len()), (2, points), "{along:?}");
            // Along the normals of vertices the faces are twisted.
            if along != ExtrudeAlong::VertexNormal {
                assert!((mesh.area() - area).abs() < 1e-9 && mesh.check().is_empty());
            }
            assert!((own.scope.axes.y_axis - DVec3::Y).length() < 1e-9);
            assert!(mesh.tag_sets()[0].has("extrude.side"));
        }
        let (env, mut line) = (&mut Env::for_tests(), Shape::line([0.0; 3], [2.0, 0.0, 0.0]).unwrap());
        extrude(env, &mut line, Length::Absolute(3.0));
        assert!((line.to_mesh().area() - 6.0).abs() < 1e-12);
        // Its front looks along the new z axis, and its first edge is the line.
        assert!((line.to_mesh().face(0).normal() - DVec3::Z).length() < 1e-12);
        let along_z = line.scope.axes.y_axis;
        assert!((along_z - DVec3::Z).length() < 1e-12, "an edge looks along its z axis");
    }
}
