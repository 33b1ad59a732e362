use std::cell::Cell;
use std::rc::Rc;

use glam::{DAffine3, DVec2, DVec3};

use super::*;
use crate::mesh::{FaceTag, MeshBuilder};
use crate::primitive;
use crate::random::Rng;
use crate::work::{Supervisor, UNITS_A_QUESTION};

/// A grid of `count` times `count` points in squares, with heights.
fn terrain(count: u32, height: impl Fn(f64, f64) -> f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let places = (0..count).flat_map(|x| (0..count).map(move |z| [f64::from(x), f64::from(z)]));
    let points: Vec<u32> = places.map(|[x, z]| builder.point([x, height(x, z), -z])).collect();
    let at = |x: u32, z: u32| points[(x * count + z) as usize];
    for (x, z) in (0..count - 1).flat_map(|x| (0..count - 1).map(move |z| (x, z))) {
        builder.face(&[at(x, z), at(x + 1, z), at(x + 1, z + 1), at(x, z + 1)], &[], FaceTag::PLAIN);
    }
    builder.build().unwrap()
}

fn hills(x: f64, z: f64) -> f64 {
    6.0 * libm::sin(x * 0.11) * libm::cos(z * 0.07) + 2.0 * libm::sin(x * 0.31 + z * 0.17)
}

fn reduced(mesh: &Mesh, share: f64) -> Mesh {
    let made = reduce(mesh, share).unwrap();
    assert_eq!(made.check().into_iter().filter(|flaw| !matches!(flaw, crate::mesh::Flaw::NotPlanar { .. })).count(), 0);
    assert_eq!(made.is_closed(), mesh.is_closed());
    // No point is new.
    assert!(made.points().iter().all(|point| mesh.points().contains(point)));
    made
}

/// "16384 vertices, 16129 faces; after reduceGeometry(0.8) 3276 vertices." The reference has other numbers of faces, since its
/// polygons are not known.
#[test]
fn a_terrain_has_the_vertices_of_the_page() {
    let before = terrain(128, hills);
    assert_eq!((before.points().len(), before.face_count()), (16384, 16129));
    let made = reduce(&before, 0.8).unwrap();
    assert_eq!(made.points().len(), 3276);
    assert!((4000..6600).contains(&made.face_count()), "{}", made.face_count());
    assert_eq!([made.bounds().size().x, made.bounds().size().z], [127.0, 127.0]);
    // Heights between the points that are left.
    let mut most: f64 = 0.0;
    for face in made.faces() {
        let corners: Vec<DVec3> = face.outline().collect();
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        most = most.max((middle.y - hills(middle.x, -middle.z)).abs());
    }
    assert!(most < 0.25, "{most}");
}

#[test]
fn closed_bodies_stay_closed_and_keep_their_volume() {
    let ball = primitive::sphere(48, 24);
    for (share, error) in [(0.2, 0.01), (0.5, 0.03), (0.8, 0.08), (0.95, 0.25)] {
        let made = reduced(&ball, share);
        let count = ball.points().len() as f64;
        assert_eq!(made.points().len(), (count * (1.0 - share) + 1e-9).floor() as usize);
        assert!((made.volume() / ball.volume() - 1.0).abs() < error, "{share}: {}", made.volume() / ball.volume());
    }
    // A tetrahedron is the least.
    for body in [ball, primitive::cube(), primitive::cylinder(9)] {
        let made = reduced(&body, 1.0);
        assert_eq!((made.points().len(), made.face_count()), (4, 4));
        assert!(1e-3 < made.volume(), "{}", made.volume());
    }
}

#[test]
fn planes_keep_their_outline_and_bodies_their_faces() {
    let plane = terrain(21, |_, _| 1.0);
    let made = reduced(&plane, 0.99);
    assert_eq!((made.points().len(), made.area()), (4, 400.0));
    assert!(reduce(&made, 0.0).is_none());
    // A cube beside a ball: the ball loses its vertices, and the faces of the cube stay polygons.
    let cube = primitive::cube().map(&DAffine3::from_translation(DVec3::X * 3.0));
    let both = crate::mesh::join::join([&primitive::sphere(40, 20), &cube].into_iter());
    let made = reduced(&both, 0.5);
    assert_eq!(made.faces().filter(|face| face.outer().len() == 4 && face.area() == 1.0).count(), 6);
}

#[test]
fn seams_of_textures_and_borders_of_materials_stay() {
    // Two halves with different groups, and a texture that jumps across another line.
    let flat = terrain(21, |_, _| 0.0);
    let mut mesh = flat.alike(0);
    mesh.groups = ["a", "b"].map(String::from).to_vec().into();
    mesh.points.clone_from(&flat.points);
    let mut uvs = Vec::new();
    for face in flat.faces() {
        mesh.corners.extend_from_slice(face.outer());
        mesh.end_loop();
        let middle = face.outline().sum::<DVec3>() / 4.0;
        mesh.end_face(FaceTag { group: u32::from(8.0 < middle.x), tags: FaceTag::NONE, ..FaceTag::PLAIN });
        uvs.extend(
            face.outline()
                .map(|p| DVec2::new(p.x, -p.z) * 0.1 + if middle.z < -13.0 { DVec2::X * 5.0 } else { DVec2::ZERO }),
        );
    }
    let mesh = mesh.with_uv_set(0, uvs);
    let made = reduced(&mesh, 0.97);
    let area = |group: u32| made.faces().filter(|face| face.tag().group == group).map(|face| face.area()).sum::<f64>();
    assert_eq!([area(0), area(1)], [160.0, 240.0]);
    for face in made.faces() {
        let is_high = face.outline().all(|point| point.z <= -13.0);
        assert!(is_high || face.outline().all(|point| -13.0 <= point.z));
        for corner in face.corner_range() {
            let at = face.position(corner);
            let expected = DVec2::new(at.x, -at.z) * 0.1 + if is_high { DVec2::X * 5.0 } else { DVec2::ZERO };
            assert!((made.uvs()[corner] - expected).length() < 1e-12);
        }
    }
    // The points of the outline, and those at which the lines meet it and each other.
    assert_eq!(made.points().len(), 13);
}

#[test]
fn hostile_meshes_have_a_result() {
    let mut random = Rng(3);
    for _ in 0..150 {
        let mut builder = MeshBuilder::new();
        let points: Vec<u32> =
            (0..12).map(|_| builder.point([0; 3].map(|_: i32| (random.unit() * 5.0).floor()))).collect();
        for _ in 0..20 {
            let count = 3 + (random.unit() * 3.0) as usize;
            let ring: Vec<u32> = (0..count).map(|_| points[(random.unit() * 12.0) as usize]).collect();
            builder.face(&ring, &[], FaceTag::PLAIN);
        }
        let Ok(mesh) = builder.build() else { continue };
        for share in [0.1, 0.5, 1.0] {
            if let Some(made) = reduce(&mesh, share) {
                assert!(!made.is_empty());
                assert!(!mesh.is_closed() || made.is_closed());
            }
        }
    }
    // Sizes far from 1, and a wheel with thousands of spokes.
    for size in [1e-150, 1e150] {
        let ball = primitive::sphere(12, 6).map(&DAffine3::from_scale(DVec3::splat(size)));
        assert_eq!(reduced(&ball, 0.5).points().len(), ball.points().len() / 2);
    }
    let wheel = triangulated_disk(5000);
    assert_eq!(reduced(&wheel, 0.9).points().len(), 500);
    assert!(reduce(&Mesh::default(), 0.5).is_none());
}

fn triangulated_disk(sides: u32) -> Mesh {
    let mut builder = MeshBuilder::new();
    let middle = builder.point([0.0; 3]);
    let at = |k: u32| libm::sincos(f64::from(k) * std::f64::consts::TAU / f64::from(sides));
    let rim: Vec<u32> = (0..sides).map(|k| builder.point([at(k).1, 0.0, -at(k).0])).collect();
    for k in 0..sides as usize {
        builder.face(&[middle, rim[k], rim[(k + 1) % sides as usize]], &[], FaceTag::PLAIN);
    }
    builder.build().unwrap()
}

#[test]
fn surfaces_that_branch_stay_together() {
    // Two boxes that share an edge, and a strip with one side.
    let boxes =
        [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)].map(|place| primitive::cube().map(&DAffine3::from_translation(place)));
    let mut builder = MeshBuilder::new();
    for body in &boxes {
        let points: Vec<u32> = body.points().iter().map(|&point| builder.point(point)).collect();
        for face in body.faces() {
            let ring: Vec<u32> = face.outer().iter().map(|&point| points[point as usize]).collect();
            builder.face(&ring, &[], FaceTag::PLAIN);
        }
    }
    let touching = builder.build().unwrap();
    let made = reduced(&touching, 1.0);
    let shared = touching.points().iter().filter(|point| point.x == 1.0 && point.y == 1.0);
    assert!(made.is_closed() && shared.clone().count() == 2);
    assert!(shared.clone().all(|point| made.points().contains(point)));
}

#[test]
fn turning_a_box_or_a_prism_turns_the_result() {
    let bodies = [
        primitive::cube(),
        primitive::cylinder(5),
        primitive::cube().map(&DAffine3::from_scale(DVec3::new(3.0, 2.0, 5.0))),
    ];
    for (number, body) in bodies.iter().enumerate() {
        for step in 1..40 {
            let matrix3 = glam::DMat3::from_axis_angle(DVec3::new(0.3, 0.9, 0.2).normalize(), f64::from(step) * 0.37);
            let place = DAffine3 { matrix3, translation: DVec3::new(11.3, -7.1, 0.9) * f64::from(step) };
            for share in [0.1, 0.25, 0.5, 0.75, 1.0] {
                let [straight, turned] = [reduce(body, share), reduce(&body.map(&place), share)];
                assert_eq!(straight.is_some(), turned.is_some());
                let (Some(straight), Some(turned)) = (straight, turned) else { continue };
                let is_near = |(a, b): (&DVec3, &DVec3)| place.transform_point3(*a).distance(*b) < 1e-9 * 500.0;
                let are_near = straight.points().iter().zip(turned.points()).all(is_near);
                assert!(straight.corners() == turned.corners() && are_near, "{number} {step} {share}");
            }
        }
    }
}

/// Reduces a mesh until the question after number `last`. Returns the result and the number of questions.
fn reduced_until(mesh: &Mesh, share: f64, last: u64) -> (Option<Mesh>, u64) {
    let count = Rc::new(Cell::new(0));
    let asked = count.clone();
    let _supervisor = Supervisor::new(move |_| asked.replace(asked.get() + 1) < last);
    let made = reduce(mesh, share);
    (made, count.get())
}

#[test]
fn every_pass_over_a_large_mesh_can_end() {
    let mesh = terrain(128, hills);
    // One vertex goes.
    let share = 1.5 / mesh.points().len() as f64;
    let (made, questions) = reduced_until(&mesh, share, u64::MAX);
    assert!(made.is_some());
    let searches = ((mesh.points().len() + 16) * SEARCH) as u64 / UNITS_A_QUESTION;
    assert!(searches + 40 < questions, "{questions} questions, {searches} of them in searches");
    for last in [0, 5, 10, 20, 30, questions - 20, questions - 10, questions - 1] {
        let (made, asked) = reduced_until(&mesh, share, last);
        assert!(made.is_none() && asked == last + 1, "question {last}");
    }
}

#[test]
fn rounding_does_not_change_which_vertices_of_a_face_go() {
    // A wall with notches, and a triangle with corners on its edges.
    let notch = |k: u32| {
        let x = f64::from(k) * 2.469_156_9;
        [(x, 0.0), (x + 1.749_748, 0.0), (x + 1.749_748, 0.133), (x + 2.469_156_9, 0.133)]
    };
    let end = 6.0 * 2.469_156_9;
    let notched: Vec<DVec3> =
        (0..6).flat_map(notch).chain([(end, 0.377), (0.0, 0.377)]).map(|(x, y)| DVec3::new(x, y, 0.0)).collect();
    let corners = [DVec3::new(0.313, 2.0, 0.7), DVec3::new(1.0, 0.0, 0.3), DVec3::new(-0.5, 1.0, -0.7)];
    let along = |k: usize| [0.0, 0.2713, 0.613].map(|share| corners[k].lerp(corners[(k + 1) % 3], share));
    let divided = (0..3).flat_map(along).collect();
    let mut random = Rng(5);
    for (outline, share) in [(notched, 0.4173), (divided, 0.3)] {
        let mut reduced = |noise: f64| {
            let mut nudge = || (random.unit() - 0.5) * noise;
            let mut points: Vec<DVec3> = outline.clone();
            points.iter_mut().for_each(|point| *point += DVec3::new(nudge(), nudge(), nudge()));
            let mesh = Mesh::from_polygon(&points, &[]).unwrap();
            let made = reduce(&mesh, share).unwrap();
            let old = |point| points.iter().position(|old| old == point);
            (made.points().iter().map(old).collect::<Vec<_>>(), made.corners().to_vec())
        };
        let expected = reduced(0.0);
        for _ in 0..100 {
            assert_eq!(reduced(1e-15), expected, "{share}");
        }
    }
}
