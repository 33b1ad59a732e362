//! Open surfaces and areas in one plane.

use std::slice::from_ref;

use glam::{DAffine3, DVec3};

use super::{BooleanOp, block, combine, combined};
use crate::mesh::{FaceTag, Mesh, MeshBuilder};
use crate::primitive::{quad, sphere};
use crate::random::Rng;
use crate::rotation::turn;
use BooleanOp::{Intersect, Subtract, Unify, Union};

/// A square in the plane y = height that faces up.
fn plane(low: f64, high: f64, height: f64) -> Mesh {
    let scale = DVec3::new(high - low, 1.0, high - low);
    let place = DAffine3::from_scale_rotation_translation(scale, Default::default(), DVec3::new(low, height, low));
    quad().map(&place)
}

/// The faces of a mesh without some.
fn without(mesh: &Mesh, faces: &[usize]) -> Mesh {
    let kept: Vec<u32> = (0..mesh.face_count()).filter(|face| !faces.contains(face)).map(|face| face as u32).collect();
    crate::extract::extract(mesh, &kept, &crate::Frame::WORLD)
}

fn measured(op: BooleanOp, a: &Mesh, b: &Mesh) -> (f64, bool) {
    let made = combined(op, a, b).unwrap();
    assert_eq!(made.check(), []);
    ((made.area() * 1e9).round() / 1e9, made.is_closed())
}

#[test]
fn a_plane_through_a_box_is_a_half_space() {
    let solid = block([1.0, 0.0, 1.0], [3.0, 4.0, 3.0]);
    let up = plane(0.0, 4.0, 1.0);
    let down = up.reversed();
    // The walls below are 8 m2, those above 24; the plane is 16, its part in the box 4.
    assert_eq!(measured(Union, &up, &solid), (16.0 - 4.0 + 24.0 + 4.0, false));
    assert_eq!(measured(Union, &down, &solid), (16.0 - 4.0 + 8.0 + 4.0, false));
    assert_eq!(measured(Subtract, &up, &solid), (16.0 - 4.0 + 8.0 + 4.0, false));
    assert_eq!(measured(Subtract, &down, &solid), (16.0 - 4.0 + 24.0 + 4.0, false));
    assert_eq!(measured(Subtract, &solid, &up), (24.0 + 4.0 + 4.0, true));
    assert_eq!(measured(Subtract, &solid, &down), (8.0 + 4.0 + 4.0, true));
    assert_eq!(measured(Intersect, &solid, &up), (8.0 + 4.0 + 4.0, true));
    assert_eq!(measured(Intersect, &down, &solid), (24.0 + 4.0 + 4.0, true));
    let both = |mesh: &Mesh| combine(Unify, [&[mesh.clone(), solid.clone()], &[]], 0.0).unwrap();
    assert_eq!([both(&up).area(), both(&down).area()], [16.0 - 4.0 + 40.0; 2]);
    // Whatever is cut off is closed, and the plane's part in it looks outwards.
    let low = combined(Intersect, &solid, &up).unwrap();
    assert_eq!(low.volume(), 4.0);
    assert_eq!(combined(Subtract, &solid, &up).unwrap().volume(), 12.0);
}

#[test]
fn a_plane_that_ends_in_a_box_leaves_the_box_whole() {
    let solid = block([1.0, 0.0, 1.0], [3.0, 4.0, 3.0]);
    let part = plane(0.0, 2.0, 1.0);
    let walls = solid.area();
    assert_eq!(measured(Union, &part, &solid), (walls + 3.0, false));
    assert_eq!(measured(Subtract, &part, &solid), (3.0, false));
    assert_eq!(measured(Subtract, &solid, &part), (walls + 1.0, false));
    assert_eq!(measured(Intersect, &part, &solid), (1.0, false));
    let both = combine(Unify, [&[solid, part], &[]], 0.0).unwrap();
    assert_eq!(both.area(), walls + 3.0);
}

#[test]
fn an_open_box_counts_as_closed_unless_its_border_is_crossed() {
    // Faces of the cube: bottom, top, front, right, back, left.
    let solid = block([0.0; 3], [10.0; 3]);
    let other = block([2.0; 3], [12.0; 3]);
    let front_open = without(&other, &[2]);
    let left_open = without(&other, &[5]);
    // As with the closed box, except at its front.
    let closed = combined(Union, &solid, &other).unwrap().area();
    assert_eq!(measured(Union, &solid, &front_open), (closed - 100.0, false));
    // The border crosses the solid, which stays whole; the bottom and the back are partly in it.
    assert_eq!(measured(Union, &solid, &left_open), (solid.area() + left_open.area() - 2.0 * 64.0, false));
}

#[test]
fn a_box_in_a_nearly_closed_one_is_inside() {
    let room = without(&block([0.0; 3], [10.0; 3]), &[2]);
    let small = block([4.0, 4.0, 2.0], [6.0, 6.0, 3.0]);
    assert_eq!(measured(Union, &room, &small), (500.0, false));
    assert_eq!(measured(Intersect, &small, &room), (small.area(), true));
    // Below a plane that it does not meet, it is not.
    let roof = plane(0.0, 10.0, 8.0);
    assert_eq!(measured(Union, &roof, &small), (100.0 + small.area(), false));
    assert_eq!(measured(Subtract, &small, &roof), (small.area(), true));
}

#[test]
fn areas_in_a_plane_are_combined() {
    for (place, far) in [(DVec3::ZERO, 0.0), (DVec3::new(4e5, 10.0, -5e5), 37.0)] {
        let to = DAffine3 { matrix3: turn(far, far, 0.0), translation: place };
        let (a, b) = (plane(0.0, 4.0, 0.0).map(&to), plane(1.0, 6.0, 0.0).map(&to));
        for b in [b.clone(), b.reversed()] {
            let area = |op, first: &Mesh, second: &Mesh| {
                let made = combined(op, first, second).unwrap();
                assert_eq!(made.check(), []);
                let up = first.face(0).normal();
                assert!(made.faces().all(|face| 0.9 < face.normal().dot(up)), "faces look as the first operand");
                ((made.area() * 1e6).round() / 1e6, made.face_count())
            };
            assert_eq!(area(Union, &a, &b), (16.0 + 25.0 - 9.0, 3));
            assert_eq!(area(Subtract, &a, &b), (7.0, 1));
            assert_eq!(area(Subtract, &b, &a), (16.0, 1));
            assert_eq!(area(Intersect, &a, &b), (9.0, 1));
        }
    }
}

#[test]
fn an_area_in_another_makes_a_hole() {
    let (a, b) = (plane(0.0, 4.0, 0.0), plane(1.0, 2.0, 0.0));
    let ring = combined(Subtract, &a, &b).unwrap();
    assert_eq!((ring.area(), ring.face_count(), ring.face(0).holes().len()), (15.0, 1, 1));
    // The hole is filled again; its edges stay.
    let filled = combined(Union, &ring, &b).unwrap();
    assert_eq!((filled.area(), filled.face_count(), filled.points().len()), (16.0, 2, 8));
    let unchanged = combined(Subtract, &ring, &b).unwrap();
    assert!(unchanged.corners() == ring.corners() && unchanged.points() == ring.points());
}

/// Random polygons of unit squares in a plane; the truth is counted.
#[test]
fn areas_of_squares_on_a_grid_add_up() {
    const SIZE: usize = 8;
    for seed in 0..60 {
        let rng = &mut Rng(seed);
        let to = DAffine3 { matrix3: turn(seed as f64 * 7.0, 3.0, 1.0), translation: DVec3::new(1e5, 2e5, 3e5) };
        let mut operand = || {
            let mut builder = MeshBuilder::new();
            let mut cells = [[false; SIZE]; SIZE];
            for _ in 0..3 {
                let [x, z] = [(); 2].map(|()| (rng.unit() * 6.0) as usize);
                let [w, d] = [(); 2].map(|()| 1 + (rng.unit() * 2.99) as usize);
                let (w, d) = (w.min(SIZE - x), d.min(SIZE - z));
                (x..x + w).for_each(|x| (z..z + d).for_each(|z| cells[x][z] = true));
                let at = |x: usize, z: usize| to.transform_point3(DVec3::new(x as f64, 0.0, z as f64)).to_array();
                let ring = [at(x, z), at(x, z + d), at(x + w, z + d), at(x + w, z)].map(|p| builder.point(p));
                builder.face(&ring, &[], FaceTag::PLAIN);
            }
            (builder.build().unwrap(), cells)
        };
        let ((a, first), (b, second)) = (operand(), operand());
        for op in [Union, Subtract, Intersect] {
            let cells = first.iter().flatten().zip(second.iter().flatten());
            let truth = cells.filter(|(a, b)| op.keeps([**a, **b])).count() as f64;
            let made = combined(op, &a, &b).unwrap();
            assert!((made.area() - truth).abs() < 1e-6, "{seed} {op:?}: {} of {truth}", made.area());
            assert_eq!(made.check(), [], "{seed} {op:?}");
        }
    }
}

#[test]
fn a_solid_that_only_touches_changes_nothing() {
    let solid = block([0.0; 3], [4.0; 3]);
    for other in [block([4.0, 1.0, 1.0], [5.0, 2.0, 2.0]), block([4.0, 4.0, 0.0], [5.0; 3]), block([4.0; 3], [5.0; 3])]
    {
        let made = combined(Subtract, &solid, &other).unwrap();
        assert!(made.corners() == solid.corners() && made.points() == solid.points());
        assert!(combined(Intersect, &solid, &other).unwrap().is_empty());
    }
}

#[test]
fn one_mesh_that_does_not_meet_itself_stays_as_it_is() {
    for mesh in [block([0.0; 3], [1.0, 2.0, 3.0]), sphere(9, 7), plane(0.0, 1.0, 0.5), without(&sphere(9, 7), &[3, 4])]
    {
        let made = combine(Unify, [from_ref(&mesh), &[]], 0.0).unwrap();
        assert!(made.corners() == mesh.corners() && made.points() == mesh.points());
    }
}

#[test]
fn a_cavity_stays_and_a_solid_inside_out_is_turned() {
    let (outer, inner) = (block([0.0; 3], [4.0; 3]), block([1.0; 3], [3.0; 3]));
    let hollow = combined(Subtract, &outer, &inner).unwrap();
    assert_eq!(hollow.volume(), 56.0);
    let filled = combined(Union, &hollow, &block([1.0; 3], [2.0, 3.0, 3.0])).unwrap();
    assert_eq!((filled.volume(), filled.is_closed()), (60.0, true));
    assert_eq!(combined(Intersect, &hollow, &outer).unwrap().volume(), 56.0);
    assert_eq!(combined(Subtract, &outer, &inner.reversed()).unwrap().volume(), 56.0);
}

#[test]
fn hollow_solids_that_coincide_keep_their_cavity() {
    let hollow = combined(Subtract, &block([0.0; 3], [4.0; 3]), &block([1.0; 3], [3.0; 3])).unwrap();
    for op in [Union, Intersect] {
        assert_eq!(combined(op, &hollow, &hollow).unwrap().volume(), 56.0, "{op:?}");
    }
    assert!(combined(Subtract, &hollow, &hollow).unwrap().is_empty());
    // A cavity that coincides with the outside of the other operand.
    let inner = block([1.0; 3], [3.0; 3]);
    assert_eq!(combined(Union, &inner, &hollow).unwrap().volume(), 64.0);
    assert_eq!(combined(Union, &hollow, &inner).unwrap().volume(), 64.0);
    assert!(combined(Intersect, &inner, &hollow).unwrap().is_empty());
}
