//! Holes find their outlines, even where rounding brings them very close to each other.

use std::sync::Arc;

use crate::cut_support::{AXES, Rng};
use cga_geometry::Axis;
use cga_geometry::cut::{Plane, Slabs, halves, slabs};
use cga_geometry::glam::{DMat3, DQuat, DVec2, DVec3, EulerRot};
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};

/// A wing around a courtyard with a ridge in the middle: its outline at the ground, its depth, and the height of the
/// ridge.
fn courtyard(size: DVec2, depth: f64, height: f64, place: impl Fn(DVec3) -> DVec3) -> Arc<Mesh> {
    let mut builder = MeshBuilder::new();
    let mut ring = |inset: f64, z: f64| {
        let (low, high) = (DVec2::splat(inset), size - inset);
        [[low.x, low.y], [high.x, low.y], [high.x, high.y], [low.x, high.y]]
            .map(|[x, y]| builder.point(place(DVec3::new(x, y, z))))
    };
    let (outer, inner, ridge) = (ring(0.0, 0.0), ring(depth, 0.0), ring(depth * 0.5, height));
    let ground: Vec<u32> = outer.into_iter().rev().collect();
    builder.face(&ground, &[&inner], FaceTag::PLAIN);
    for k in 0..4 {
        let next = (k + 1) % 4;
        builder.face(&[outer[k], outer[next], ridge[next], ridge[k]], &[], FaceTag::PLAIN);
        builder.face(&[inner[next], inner[k], ridge[k], ridge[next]], &[], FaceTag::PLAIN);
    }
    let mesh = builder.build().unwrap();
    assert!(mesh.is_closed());
    Arc::new(mesh)
}

/// The area of all caps.
fn covered(cut: &Slabs) -> f64 {
    let faces = cut.parts.iter().flatten().flat_map(|part| part.faces());
    faces.filter(|face| face.tag().cap).map(|cap| cap.area()).sum()
}

#[test]
fn a_courtyard_is_open_just_below_the_ridge() {
    let building = courtyard(DVec2::splat(12.0), 4.0, 3.0, |p| p);
    let cut = slabs(&building, Axis::Z, &[3.0_f64.next_down()]);
    assert!(covered(&cut) < 1e-12);
    for part in cut.parts.iter().flatten() {
        assert_eq!(part.faces().filter(|face| face.tag().cap).map(|cap| cap.holes().len()).collect::<Vec<_>>(), [1]);
        assert!(part.check().is_empty() && part.is_closed());
    }
}

#[test]
fn courtyards_stay_open_wherever_they_stand_and_however_they_are_turned() {
    let mut rng = Rng(5);
    for round in 0..400 {
        let mut within = |low: f64, high: f64| low + (high - low) * rng.unit();
        let size = DVec2::new(within(10.0, 30.0), within(10.0, 30.0));
        let (depth, height) = (within(4.0, 7.0), within(3.0, 6.0));
        let far = DVec3::new(within(0.0, 5e5), within(0.0, 4.2e6), 0.0);
        let turn =
            DMat3::from_quat(DQuat::from_euler(EulerRot::XYZ, within(0.0, 6.0), within(0.0, 6.0), within(0.0, 6.0)));
        let about_z = DMat3::from_rotation_z(within(0.0, 6.0));
        let below = height - 1e-11 * within(0.0, 1.0);
        let upright =
            |at: f64, place: &dyn Fn(DVec3) -> DVec3| slabs(&courtyard(size, depth, height, place), Axis::Z, &[at]);
        let plane = Plane { point: turn * DVec3::new(depth * 0.5, depth * 0.5, height), normal: turn * DVec3::Z };
        let turned = courtyard(size, depth, height, |p| turn * p);
        let cuts = [
            upright(height.next_down(), &|p| p),
            upright(below, &|p| p + far),
            upright(below, &|p| about_z * p + far),
            halves(&turned, &plane, 0.0),
            halves(&turned, &plane, 4e-14),
        ];
        for (number, cut) in cuts.iter().enumerate() {
            assert!(covered(cut) < 1e-2, "round {round}, cut {number}: {}", covered(cut));
        }
    }
}

/// An upright wall from a point, 8 long and 4 high, with a window from 1 to 3 high.
fn wall(from: DVec3, along: DVec2, window: [f64; 2]) -> Arc<Mesh> {
    let mut builder = MeshBuilder::new();
    let mut at = |s: f64, z: f64| builder.point(from + (along * s).extend(z));
    let outline = [at(0.0, 0.0), at(8.0, 0.0), at(8.0, 4.0), at(0.0, 4.0)];
    let [left, right] = window;
    let hole = [at(left, 1.0), at(left, 3.0), at(right, 3.0), at(right, 1.0)];
    builder.face(&outline, &[&hole], FaceTag::PLAIN);
    Arc::new(builder.build().unwrap())
}

#[test]
fn a_window_stays_a_hole_when_the_wall_is_cut_just_beside_it() {
    let wall = wall(DVec3::new(0.0, 4.0, 0.0), DVec2::ONE, [2.0, 3.0]);
    let cut = slabs(&wall, Axis::X, &[3.0_f64.next_up()]);
    let faces: Vec<(usize, usize)> =
        cut.parts.iter().flatten().map(|part| (part.face_count(), part.face(0).holes().len())).collect();
    assert_eq!(faces, [(1, 1), (1, 0)]);
}

#[test]
fn no_piece_of_a_wall_is_turned_over() {
    let mut rng = Rng(17);
    for round in 0..3000 {
        let mut within = |low: f64, high: f64| low + (high - low) * rng.unit();
        let angle = within(0.0, 7.0);
        let along = DVec2::new(libm::cos(angle), libm::sin(angle));
        let from = DVec3::new(within(0.0, 10.0), within(0.0, 10.0), 0.0);
        let far = if round % 2 == 0 { DVec3::ZERO } else { DVec3::new(5e5, 4.2e6, 0.0) };
        let window = [within(1.0, 3.0), within(4.0, 7.0)];
        let wall = wall(from + far, along, window);
        let axis = rng.below(2);
        let mut at = (from + far)[axis] + along[axis] * window[rng.below(2)];
        for _ in 0..rng.below(5) {
            at = if rng.below(2) == 0 { at.next_up() } else { at.next_down() };
        }
        let normal = wall.face(0).normal();
        for part in slabs(&wall, AXES[axis], &[at]).parts.iter().flatten() {
            let over = part.faces().any(|face| face.normal().dot(normal) < 0.0 && 1e-6 < face.area());
            assert!(!over, "round {round}: {along} from {from} at {at}");
        }
    }
}
