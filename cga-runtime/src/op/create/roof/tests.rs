use std::sync::Arc;

use glam::{DQuat, DVec3};

use super::*;
use crate::geometry::mesh::{FaceRef, FaceTag, Mesh, MeshBuilder};

type Op = fn(&mut Env, &mut Shape);

const ALL: [Op; 5] = [
    |env, shape| roof_hip(env, shape, 30.0, 0.0, false),
    |env, shape| roof_gable(env, shape, 30.0, 0.0, 0.0, false),
    |env, shape| roof_pyramid(env, shape, 30.0),
    |env, shape| roof_shed(env, shape, 30.0, 0.0),
    |env, shape| roof_ridge_by(env, shape, RoofValue::ByAngle, 30.0),
];

fn mesh_of(faces: &[&[[f64; 3]]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    for face in faces {
        let points: Vec<u32> = face.iter().map(|&p| builder.point(p)).collect();
        builder.face(&points, &[], FaceTag::PLAIN);
    }
    builder.build().expect("a mesh")
}

/// Runs an operation. Returns the shape and the number of faults.
fn run(shape: &Shape, op: Op) -> (Shape, usize) {
    let (env, mut made) = (&mut Env::for_tests(), shape.clone());
    op(env, &mut made);
    assert_eq!(made.pivot, shape.pivot);
    (made, env.take_faults().0.len())
}

fn is_same(a: &Shape, b: &Shape) -> bool {
    a.scope == b.scope && Arc::ptr_eq(&a.to_mesh(), &b.to_mesh()) || a.to_mesh().points() == b.to_mesh().points()
}

#[test]
fn roofs_are_closed_and_keep_the_pivot() {
    for op in ALL {
        let (shape, faults) = run(&Shape::rectangle(10.0, 8.0), op);
        let mesh = shape.to_mesh();
        assert_eq!(faults, 0);
        assert!(mesh.is_closed() && mesh.check().is_empty() && 0.0 < mesh.volume(), "{:?}", mesh.check());
        assert_eq!(shape.scope.axes.y_axis, DVec3::Y);
        assert!((mesh.bounds().size() - shape.scope.size).length() < 1e-9);
    }
}

#[test]
fn every_face_gets_a_roof_across_it() {
    // The walls and caps of a box.
    let (hip, faults) = run(&Shape::cuboid(4.0, 6.0, 8.0), ALL[0]);
    assert_eq!((hip.to_mesh().face_count(), faults), (6 * 5, 0));
    assert!(hip.to_mesh().is_closed());
    // A wall: the scope's y axis is its normal, x stays.
    let wall = mesh_of(&[&[[0.0, 0.0, 0.0], [6.0, 0.0, 0.0], [6.0, 4.0, 0.0], [0.0, 4.0, 0.0]]]);
    for op in ALL {
        let (shape, faults) = run(&Shape::mesh_axis_aligned(wall.clone()), op);
        assert_eq!((shape.scope.axes.x_axis, shape.scope.axes.y_axis, faults), (DVec3::X, DVec3::Z, 0));
        assert!(shape.to_mesh().is_closed() && 0.0 < shape.to_mesh().volume());
    }
    // A face that is not planar keeps its corners.
    let bent = mesh_of(&[&[[0.0, 0.0, 0.0], [6.0, 0.3, 0.0], [6.0, 0.0, -6.0], [0.0, 0.3, -6.0]]]);
    for op in ALL {
        let (shape, faults) = run(&Shape::mesh_axis_aligned(bent.clone()), op);
        assert!(faults == 0 && shape.to_mesh().is_closed());
    }
}

#[test]
fn hostile_input_leaves_a_fault_and_the_shape() {
    let crossing = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 0.0, -3.0], [1.0, 0.0, 1.0]];
    let flat = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [8.0, 0.0, 0.0]];
    for outline in [&crossing[..], &flat] {
        let shape = Shape::mesh_axis_aligned(mesh_of(&[outline]));
        for op in ALL {
            let (made, faults) = run(&shape, op);
            assert!(faults == 1 && is_same(&made, &shape));
        }
    }
    let lot = Shape::rectangle(10.0, 8.0);
    let values = [f64::NAN, f64::INFINITY, 0.0, 90.0, -90.0, 1e300];
    for value in values {
        let env = &mut Env::for_tests();
        for at in 0..5 {
            let mut made = lot.clone();
            match at {
                0 => roof_hip(env, &mut made, value, 0.0, false),
                1 => roof_gable(env, &mut made, value, 0.0, 0.0, false),
                2 => roof_pyramid(env, &mut made, value),
                3 => roof_shed(env, &mut made, value, 0.0),
                _ => roof_ridge_by(env, &mut made, RoofValue::ByAngle, value),
            }
            assert!(!env.take_faults().0.is_empty() && is_same(&made, &lot), "{value} {at}");
        }
    }
    // Negative numbers make the shed fall, and nothing else.
    let (shed, faults) = run(&lot, |env, shape| roof_shed_by(env, shape, RoofValue::ByHeight, -2.0, 0.0));
    assert!(faults == 0 && (shed.to_mesh().volume() - 80.0).abs() < 1e-9);
    assert_eq!(run(&lot, |env, shape| roof_hip_by(env, shape, RoofValue::ByHeight, -2.0, 0.0, false)).1, 1);
    for (overhang, faults) in [(f64::NAN, 1), (1e300, 1), (-1.0, 0)] {
        let (env, mut made) = (&mut Env::for_tests(), lot.clone());
        roof_hip(env, &mut made, 30.0, overhang, false);
        assert_eq!(env.take_faults().0.len(), faults, "{overhang}");
        assert!(made.to_mesh().check().is_empty());
    }
    for index in [f64::NAN, 1e300, -1e300, 0.5, 7.0, -7.0] {
        let (env, mut made) = (&mut Env::for_tests(), lot.clone());
        roof_shed(env, &mut made, 30.0, index);
        roof_gable_along(env, &mut lot.clone(), 30.0, 1.0, 1.0, true, index);
        assert!(made.to_mesh().is_closed() && made.to_mesh().check().is_empty());
    }
}

#[test]
fn a_roof_whose_overhang_leads_too_far_has_none() {
    // A turned lot with a spike on each side. The planes at its sides meet far away.
    let lot = |width: f64, turn: f64| {
        let corners = [DVec3::ZERO, DVec3::X * 10.0, DVec3::new(10.0, 0.0, -8.0), DVec3::Z * -8.0];
        let mut outline: Vec<[f64; 3]> = Vec::new();
        for i in 0..4 {
            let (from, to) = (corners[i], corners[(i + 1) % 4]);
            let along = (to - from).normalize();
            let foot = from + 3.0 * along;
            let tip = foot + 0.5 * width * along + 0.2 * along.cross(DVec3::Y);
            outline.extend(
                [from, foot, tip, foot + width * along].map(|p| DQuat::from_rotation_y(turn).mul_vec3(p).to_array()),
            );
        }
        Shape::mesh_axis_aligned(mesh_of(&[&outline]))
    };
    let overhanging: [Op; 2] = [
        |env, shape| roof_hip(env, shape, 30.0, 0.5, false),
        |env, shape| roof_gable(env, shape, 30.0, 0.5, 0.4, true),
    ];
    for op in overhanging {
        let mut without = Vec::new();
        for (width, turn) in
            [1.0, 1e-3, 1e-5, 1e-6].into_iter().flat_map(|width| [0.0, 0.3, 0.7, 1.1].map(|turn| (width, turn)))
        {
            let (env, mut made) = (&mut Env::for_tests(), lot(width, turn));
            op(env, &mut made);
            let mesh = made.to_mesh();
            assert!(16 <= mesh.face_count() && mesh.check().is_empty(), "{width} {turn}: {:?}", mesh.check());
            let faults = env.take_faults().0;
            if let Some(fault) = faults.first() {
                assert!(faults.len() == 1 && mesh.is_closed(), "{width} {turn}: {fault}");
                assert!(
                    fault.to_string().contains("face 0 has no room for its overhang; the roof has none"),
                    "{fault}"
                );
                without.push(width);
            } else {
                assert!(!mesh.is_closed(), "{width} {turn}");
            }
        }
        assert!(without.contains(&1e-6) && !without.contains(&1.0), "{without:?}");
    }
}

/// Only `extrude` and `taper` are said to keep them (*roofHip operation*).
#[test]
fn texture_coordinates_go() {
    use crate::geometry::Axis;
    use crate::geometry::primitive::PrimitiveKind;
    let quad = PrimitiveKind::Square { across: Axis::Y }.mesh();
    assert!(!quad.uvs().is_empty());
    for op in ALL {
        let (roof, _) = run(&Shape::mesh_axis_aligned(quad.clone()), op);
        assert!(roof.to_mesh().uvs().is_empty() && roof.to_mesh().normals().is_empty());
    }
}

#[test]
fn tags_of_the_face_stay_and_old_roof_tags_go() {
    let (shape, _) = run(&Shape::rectangle(10.0, 8.0), ALL[1]);
    let (again, _) = run(&shape, ALL[0]);
    let mesh = again.to_mesh();
    let tags = |face: usize| mesh.tag_sets()[mesh.face(face).tag().tags as usize].names().len();
    assert!((0..mesh.face_count()).all(|face| tags(face) == 1));
}

/// An end that goes around a corner has no overhang: its outer edge would cut off the corner.
#[test]
fn overhangs_along_an_edge_cover_the_face() {
    let triangle = [[9.77, 0.0], [-4.6, 7.96], [-4.56, -7.9]];
    let hexagon = [[9.6, 0.0], [4.75, 8.23], [-4.76, 8.24], [-9.42, 0.0], [-4.5, -7.8], [4.97, -8.6]];
    let dense = [[0.0, 0.0], [12.0, 0.0], [12.0, 3.0], [12.001, 5.0], [12.0, 8.0], [0.0, 8.0]];
    for lot in [&triangle[..], &hexagon, &dense] {
        let shape = Shape::footprint(lot, &[]).expect("a lot");
        let area = shape.to_mesh().area();
        for index in 0..lot.len() {
            for [across, along] in [[0.0, 0.3], [0.5, 0.3], [3.0, 2.0]] {
                let (env, mut made) = (&mut Env::for_tests(), shape.clone());
                roof_gable_along(env, &mut made, 35.0, across, along, false, index as f64);
                let mesh = made.to_mesh();
                let areas = || mesh.faces().map(|face| 0.5 * face.area_vector().y);
                let [up, down] = [areas().map(|y| y.max(0.0)).sum::<f64>(), areas().map(|y| y.min(0.0)).sum::<f64>()];
                let case = format!("{} corners, edge {index}, {across} {along}: {up} {down}", lot.len());
                assert!(env.take_faults().0.is_empty() && mesh.check().is_empty(), "{case}");
                assert!((down + area).abs() < 1e-9 && area * (1.0 - 1e-9) <= up, "{case}");
                assert_eq!(mesh.face_count(), lot.len() + 1, "{case}");
                // Both straight ends have an overhang, also the one with a point that is a little outside.
                if lot == dense && index == 0 && across == 0.0 {
                    assert!((up - area - 2.0 * 8.0 * along).abs() < 0.01, "{case}");
                }
            }
        }
    }
}

/// `index` is for convex faces. Over others, overhangs that would bend planes or open the roof are left out.
#[test]
fn overhangs_along_an_edge_bend_no_plane() {
    let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
    let hole = vec![[4.0, 5.0], [5.0, 6.0], [6.0, 5.0], [5.0, 4.0]];
    let wings = [[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [5.0, 5.0], [5.0, 10.0], [0.0, 10.0]];
    for shape in [Shape::footprint(&square, &[hole]), Shape::footprint(&wings, &[])].map(|lot| lot.expect("a lot")) {
        for overhang in [0.5, 1.0, 1e12] {
            let (env, mut made) = (&mut Env::for_tests(), shape.clone());
            roof_gable_along(env, &mut made, 40.0, overhang, overhang, false, 0.0);
            let (mesh, faults) = (made.to_mesh(), env.take_faults().0.len());
            assert!(mesh.check().is_empty() && (faults == 0 || mesh.is_closed()), "{overhang} {:?}", mesh.check());
            assert!(overhang < 1e12 || faults == 1, "{overhang} {faults}");
            let off = |face: FaceRef<'_>| {
                face.outline()
                    .map(|at| (at - face.position(face.corner_range().start)).dot(face.normal()).abs())
                    .fold(0.0, f64::max)
            };
            assert!(mesh.faces().map(off).fold(0.0, f64::max) < 1e-6, "{overhang}");
        }
    }
}

/// A face that `even` bends is one face, also in parts that a cut does not touch. Cut along any axis, parts are closed, and their volumes
/// and areas add up. So do results of boolean operations.
#[test]
fn even_roofs_add_up() {
    use std::slice::from_ref;

    use crate::geometry::boolean::{BooleanOp, combine};
    use crate::geometry::cut::slabs;
    use crate::geometry::primitive::cube;
    use crate::geometry::{Axis, mesh::Bounds};
    use crate::op::face::setback::tests::random_lot;
    use crate::op::face::swept_edges::tests::{lots, polygon, random};

    let forms: [Op; 3] = [
        |env, shape| roof_hip(env, shape, 40.0, 0.0, true),
        |env, shape| roof_hip(env, shape, 65.0, 0.0, true),
        |env, shape| roof_gable(env, shape, 40.0, 0.0, 0.0, true),
    ];
    let state = &mut 7;
    let quadrilateral = polygon(&[[0.0, 0.0], [12.0, 0.0], [12.0, 5.0], [0.0, 9.0]]);
    let mut shapes = vec![quadrilateral];
    shapes.extend(lots());
    shapes.extend((0..40).map(|number| random_lot(number, state)));
    let mut bent = 0;
    for (number, shape) in shapes.iter().enumerate() {
        let lot = shape.to_mesh();
        let edges: usize = lot.faces().map(|face| face.corner_count()).sum();
        for (form, op) in forms.iter().enumerate() {
            let (made, _) = run(shape, *op);
            let mesh = made.to_mesh();
            let name = format!("{number} {form}");
            assert!(mesh.is_closed() && mesh.check().is_empty(), "{name}: {:?}", mesh.check());
            assert_eq!(mesh.face_count(), edges + 1, "{name}");
            bent += mesh.faces().filter(|face| face.is_bent()).count();
            let (volume, area) = (mesh.volume(), mesh.area());
            let Bounds { low, high } = mesh.bounds();
            for (axis, i) in [(Axis::X, 0), (Axis::Y, 1), (Axis::Z, 2)] {
                let at = |share: f64| low[i] + (high[i] - low[i]) * share;
                let offsets = [at(0.2 + 0.2 * random(state)), at(0.5), at(0.6 + 0.3 * random(state))];
                let parts: Vec<Arc<Mesh>> = slabs(&mesh, axis, &offsets).parts.into_iter().flatten().collect();
                let flaws: Vec<_> = parts.iter().filter(|part| !part.is_closed()).collect();
                assert!(flaws.is_empty(), "{name} {axis:?}");
                let sum: f64 = parts.iter().map(|part| part.volume()).sum();
                assert!((sum - volume).abs() < 1e-9 * volume, "{name} {axis:?}: {sum} of {volume}");
                let own =
                    |part: &Arc<Mesh>| part.faces().filter(|face| !face.tag().cap).map(|face| face.area()).sum::<f64>();
                let sum: f64 = parts.iter().map(own).sum();
                assert!((sum - area).abs() < 1e-9 * area, "{name} {axis:?}: {sum} of {area}");
                // Again across another axis.
                for part in &parts {
                    let Bounds { low, high } = part.bounds();
                    let (axis, i) = if i == 2 { (Axis::X, 0) } else { (Axis::Z, 2) };
                    let halves = slabs(part, axis, &[0.5 * (low[i] + high[i])]).parts;
                    let sum: f64 = halves.iter().flatten().map(|half| half.volume()).sum();
                    assert!((sum - part.volume()).abs() < 1e-9 * volume, "{name} {axis:?}: {sum} of {}", part.volume());
                }
            }
            if number < 8 {
                let size = high - low;
                let place = glam::DAffine3::from_scale_rotation_translation(
                    0.6 * size,
                    glam::DQuat::IDENTITY,
                    low + 0.31 * size,
                );
                let block = cube().map(&place);
                let of = |op| combine(op, [from_ref(&*mesh), from_ref(&block)], 0.0).expect("a result");
                let [union, rest, common] =
                    [BooleanOp::Union, BooleanOp::Subtract, BooleanOp::Intersect].map(|op| of(op).volume());
                assert!((rest + common - volume).abs() < 1e-7 * volume, "{name}: {rest} + {common} of {volume}");
                assert!((union - rest - block.volume()).abs() < 1e-7 * volume, "{name}: {union}");
            }
        }
    }
    assert!(40 < bent, "{bent}");
}
