use super::*;
use crate::mesh::{FaceTag, MeshBuilder};
use crate::primitive;
use crate::random::Rng;

/// The meshes one after the other, with some faces turned.
fn joined(parts: &[Mesh], turn: impl Fn(usize) -> bool) -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut number = 0;
    for part in parts {
        let points: Vec<u32> = part.points().iter().map(|&point| builder.point(point)).collect();
        for face in part.faces() {
            let mut ring: Vec<u32> = face.outer().iter().map(|&point| points[point as usize]).collect();
            if turn(number) {
                ring.reverse();
            }
            number += 1;
            builder.face(&ring, &[], FaceTag::PLAIN);
        }
    }
    builder.build().unwrap()
}

fn cube(low: f64, high: f64) -> Mesh {
    let place =
        glam::DAffine3::from_translation(DVec3::splat(low)) * glam::DAffine3::from_scale(DVec3::splat(high - low));
    primitive::cube().map(&place)
}

fn conformed(mesh: &Mesh) -> Mesh {
    let found = conform(mesh, DVec3::Y);
    assert!(found.refused.is_empty());
    mesh.turned(|face| found.turned[face])
}

#[test]
fn turned_faces_of_closed_bodies_look_outwards_again() {
    let mut random = Rng(1);
    for body in [primitive::cube(), primitive::sphere(12, 6), primitive::cylinder(9)] {
        for _ in 0..20 {
            let turns: Vec<bool> = (0..body.face_count()).map(|_| random.unit() < 0.5).collect();
            let mixed = joined(std::slice::from_ref(&body), |face| turns[face]);
            let made = conformed(&mixed);
            assert!(made.is_closed() && (made.volume() - body.volume()).abs() < 1e-12);
        }
    }
}

#[test]
fn cavities_look_inwards_and_bodies_in_them_outwards() {
    let parts = [cube(0.0, 10.0), cube(1.0, 9.0), cube(2.0, 8.0), cube(20.0, 21.0), cube(3.0, 4.0)];
    let mut random = Rng(2);
    for _ in 0..10 {
        let turns: Vec<bool> = (0..30).map(|_| random.unit() < 0.5).collect();
        let made = conformed(&joined(&parts, |face| turns[face]));
        assert_eq!(made.volume().round(), 1000.0 - 512.0 + 216.0 + 1.0 - 1.0);
    }
}

#[test]
fn open_faces_look_up_and_upright_ones_stay_as_most_of_them_are() {
    // A house without a floor, a terrain, and a wall of three parts.
    let house = {
        let cube = primitive::cube();
        let floor = cube.faces().position(|face| face.normal().y < -0.5).unwrap();
        let kept: Vec<u32> = (0..6).filter(|&face| face != floor as u32).collect();
        crate::extract::extract(&cube, &kept, &crate::Frame::WORLD)
    };
    for turned in [[false; 5], [true; 5], [true, false, true, true, false]] {
        let made = conformed(&joined(std::slice::from_ref(&house), |face| turned[face]));
        assert!((0..5).all(|face| (made.face(face).normal() - house.face(face).normal()).length() < 1e-12));
    }
    let mut builder = MeshBuilder::new();
    let points: Vec<u32> = (0..8).map(|k| builder.point([f64::from(k / 2), f64::from(k % 2), 0.0])).collect();
    for k in 0..3 {
        let mut ring = [points[2 * k], points[2 * k + 2], points[2 * k + 3], points[2 * k + 1]];
        if k == 1 {
            ring.reverse();
        }
        builder.face(&ring, &[], FaceTag::PLAIN);
    }
    let wall = builder.build().unwrap();
    assert!(conformed(&wall).faces().all(|face| face.normal() == DVec3::Z));
    let mostly_back = joined(std::slice::from_ref(&wall), |face| face == 0);
    assert!(conformed(&mostly_back).faces().all(|face| face.normal() == DVec3::NEG_Z));
}

#[test]
fn a_strip_with_one_side_is_refused_and_other_parts_are_not() {
    let mut builder = MeshBuilder::new();
    let count = 16;
    let points: Vec<[u32; 2]> = (0..count)
        .map(|k| {
            let turn = f64::from(k) / f64::from(count) * std::f64::consts::TAU;
            let ((sin, cos), (rise, run)) = (libm::sincos(turn), libm::sincos(turn * 0.5));
            [-1.0, 1.0].map(|side| {
                let far = 5.0 + side * run;
                builder.point([far * cos, side * rise, far * sin])
            })
        })
        .collect();
    for k in 0..count as usize {
        let (here, mut next) = (points[k], points[(k + 1) % count as usize]);
        if k + 1 == count as usize {
            next.reverse();
        }
        builder.face(&[here[0], next[0], next[1], here[1]], &[], FaceTag::PLAIN);
    }
    let strip = builder.build().unwrap();
    let mesh = joined(&[strip, cube(20.0, 21.0)], |face| face == 18);
    let found = conform(&mesh, DVec3::Y);
    assert_eq!(found.refused, [0]);
    assert!((0..22).all(|face| found.turned[face] == (face == 18)));
}

#[test]
fn bodies_that_share_an_edge_are_turned_separately() {
    let other = cube(0.0, 1.0).map(&glam::DAffine3::from_translation(DVec3::new(1.0, 1.0, 0.0)));
    let made = conformed(&joined(&[cube(0.0, 1.0), other], |face| face % 3 == 0));
    assert!(made.is_closed() && made.volume() == 2.0);
}

#[test]
fn solids_that_touch_stay_closed() {
    // Cubes that share the points of a wall, and the same cube twice.
    for parts in [
        [cube(0.0, 1.0), cube(0.0, 1.0).map(&glam::DAffine3::from_translation(DVec3::X))],
        [cube(0.0, 1.0), cube(0.0, 1.0)],
    ] {
        let touching = joined(&parts, |_| false);
        assert!(touching.is_closed());
        let made = conformed(&touching);
        assert!(made.is_closed() && made.volume() == 2.0);
    }
}
