//! Closed parts stay closed, and faces do not cross themselves.

use glam::{DAffine3, DVec3};

use super::*;
use crate::boolean::{BooleanOp, combine};
use crate::convexify::convexify;
use crate::mesh::{FaceTag, MeshBuilder, SubcomponentTagsBuilder, TagSet};
use crate::primitive;

const ALL: Parts = Parts { vertices: true, edges: true, faces: true };
const FACES: Parts = Parts { vertices: false, edges: false, faces: true };
const VERTICES: Parts = Parts { vertices: true, edges: false, faces: false };
const EDGES: Parts = Parts { vertices: false, edges: true, faces: false };

fn polygon(corners: &[[f64; 2]]) -> Mesh {
    Mesh::from_polygon(&corners.iter().map(|[x, z]| DVec3::new(*x, 0.0, -z)).collect::<Vec<_>>(), &[]).unwrap()
}

fn block(low: [f64; 3], size: [f64; 3]) -> Mesh {
    let place = DAffine3::from_translation(low.into()) * DAffine3::from_scale(size.into());
    primitive::cube().map(&place)
}

#[test]
fn a_solid_thinner_than_the_tolerance_stays_closed() {
    let plate = block([0.0; 3], [9.0, 0.05, 4.0]);
    for parts in [FACES, ALL] {
        let made = cleanup(&plate, parts, 0.1).unwrap();
        assert_eq!((made.is_closed(), made.face_count(), made.volume()), (true, 2, 0.0));
    }
    // A sheet with two sides before the cleanup keeps one of them.
    let sheet = cleanup(&plate, FACES, 0.1).unwrap();
    assert_eq!(cleanup(&sheet, FACES, 0.1).unwrap().face_count(), 1);
}

#[test]
fn points_stay_where_a_face_would_cross_itself() {
    // The corner in the notch would go to the other side of the upper edge.
    let dart = polygon(&[[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [5.0, 5.0], [5.2, 4.6], [4.9, 4.0], [0.0, 5.0]]);
    for steps in 0..40 {
        let tolerance = f64::from(steps) / 40.0;
        let made = cleanup(&dart, VERTICES, tolerance).unwrap_or_else(|| dart.clone());
        assert!(convexify(&made, f64::INFINITY).refused.is_empty(), "{tolerance}");
        assert!((made.area() - dart.area()).abs() < 2.5, "{tolerance}: {}", made.area());
    }
}

#[test]
fn lengths_and_angles_equal_to_the_tolerance_are_beyond_it_wherever_the_shape_is() {
    let strips = crate::mesh::join::join(
        [[0.0, 1.0], [1.1, 2.0]].map(|[low, high]| polygon(&[[low, 0.0], [high, 0.0], [high, 1.0], [low, 1.0]])).iter(),
    );
    // Sides that meet at 10 degrees, and a triangle of 0.5 square metres.
    let prism = primitive::cylinder(36).map(&DAffine3::from_scale(DVec3::new(20.0, 3.0, 20.0)));
    let plate = polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    for step in 0..60 {
        let angle = f64::from(step) * 0.37;
        let matrix3 = glam::DMat3::from_axis_angle(DVec3::new(0.3, 0.9, 0.2).normalize(), angle);
        let place = DAffine3 { matrix3, translation: DVec3::new(11.3, -7.1, 0.9) * f64::from(step) };
        let is_same = |mesh: &Mesh, parts, tolerance| cleanup(&mesh.map(&place), parts, tolerance).is_none();
        assert!(is_same(&strips, VERTICES, 0.1), "{step}");
        assert!(is_same(&plate, FACES, 0.5), "{step}");
        assert!(is_same(&prism, Parts { edges: true, ..Parts::default() }, 1.0), "{step}");
        assert!(!is_same(&strips, VERTICES, 0.1 + 1e-6) && !is_same(&plate, FACES, 0.5 + 1e-6), "{step}");
    }
}

#[test]
fn spikes_of_merged_points_vanish_with_their_tags() {
    // A notch whose sides are 0.01 apart, with tags on all edges.
    let notched = polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.01, 3.0], [2.005, 1.0], [2.0, 3.0], [0.0, 3.0]]);
    let mut tagged = notched.clone();
    let mut tagger = SubcomponentTagsBuilder::default();
    let tags = TagSet::default().with("bool.cut");
    (0..7).for_each(|point| tagger.edge([point, (point + 1) % 7], &tags));
    tagged.subcomponent_tags = tagger.finish();
    for mesh in [notched, tagged] {
        let made = cleanup(&mesh, VERTICES, 0.1).unwrap();
        let corners = made.face(0).outer();
        assert!(!corners.contains(&4) && made.check().is_empty(), "{corners:?}");
        assert!((made.area() - 12.0).abs() < 0.05);
    }
    // A bridge to a hole that had tags from the start stays.
    let mut builder = MeshBuilder::new();
    let at = [[0., 0.], [9., 0.], [9., 9.], [0., 9.], [3., 3.], [3., 6.], [6., 6.], [6., 3.]];
    let points = at.map(|[x, y]| builder.point([x, y, 0.0]));
    builder.face(&[0, 1, 2, 3, 0, 4, 5, 6, 7, 4].map(|k: usize| points[k]), &[], FaceTag::PLAIN);
    builder.edge_tags([points[0], points[4]], &tags);
    assert!(cleanup(&builder.build().unwrap(), VERTICES, 0.0).is_none());
}

/// Found by trial runs: a frame less a turned block, divided in two halves.
#[test]
fn parts_of_boolean_results_are_convex_after_a_cleanup() {
    let holes = [[1.8, -0.5, 1.5], [1.2, -0.5, 1.0]];
    for (seed, low) in (0..).zip(holes) {
        let body = block([0.0; 3], [6.0, 4.0, 5.0]);
        let hole = block(low, [1.8, 6.0, 1.5]);
        let made = combine(BooleanOp::Subtract, [&[body], &[hole]], 1e-15).unwrap();
        let halves = [[0.0, 2.4], [2.4, 3.6]]
            .map(|[x, width]| {
                combine(
                    BooleanOp::Intersect,
                    [std::slice::from_ref(&made), &[block([x, 0.0, 0.0], [width, 4.0, 5.0])]],
                    1e-15,
                )
            })
            .map(Result::unwrap);
        let joined = crate::mesh::join::join(halves.iter());
        for tolerance in [0.0, 0.1, 0.5, 0.6, 0.7, 1.0] {
            for parts in [VERTICES, FACES, ALL] {
                let clean = cleanup(&joined, parts, tolerance).unwrap_or_else(|| joined.clone());
                let cut = convexify(&clean, f64::INFINITY);
                assert!(clean.is_closed() && cut.refused.is_empty(), "{seed} {tolerance} {parts:?}");
                let (convex, _) = cut.made.unwrap_or_else(|| (clean.clone(), Vec::new()));
                assert!(convex.is_closed() && convex.check().is_empty(), "{seed} {tolerance} {parts:?}");
                assert!(convex.faces().all(|face| face.holes().len() == 0), "{seed} {tolerance} {parts:?}");
                assert!((convex.area() - clean.area()).abs() < 1e-9 && (convex.volume() - clean.volume()).abs() < 1e-9);
            }
        }
    }
}

/// A face whose points have these numbers, with a hole.
fn plate(points: &[[f64; 2]], outline: &[usize], hole: &[[f64; 2]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    let points: Vec<u32> = points.iter().map(|[x, y]| builder.point([*x, *y, 0.0])).collect();
    let hole: Vec<u32> = hole.iter().map(|[x, y]| builder.point([*x, *y, 0.0])).collect();
    let holes: &[&[u32]] = if hole.is_empty() { &[] } else { &[&hole] };
    builder.face(&outline.iter().map(|&k| points[k]).collect::<Vec<_>>(), holes, FaceTag::PLAIN);
    builder.build().unwrap()
}

#[test]
fn holes_stay_inside_of_their_face() {
    // The lower edge would move past the hole: its ends are near the first and the second point.
    let points = [[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [0.0, 10.0], [0.0, -0.8], [20.0, -0.8]];
    let merged = |hole: &[[f64; 2]]| {
        let made = cleanup(&plate(&points, &[0, 4, 5, 1, 2, 3], hole), VERTICES, 1.0).unwrap();
        (made.corners().len(), made.bounds().low.y)
    };
    assert_eq!(merged(&[]), (4, 0.0));
    assert_eq!(merged(&[[5.0, -0.6], [10.0, -0.1], [15.0, -0.6]]), (7, -0.8));
    assert_eq!(merged(&[[5.0, 4.0], [10.0, 6.0], [15.0, 4.0]]), (7, 0.0));
    // A lower edge of four parts, which one edge above the hole would replace.
    let points = [[0.0, 0.0], [20.0, -0.6], [40.0, -0.9], [60.0, -0.6], [80.0, 0.0], [80.0, 30.0], [0.0, 30.0]];
    let straight = |hole: &[[f64; 2]]| cleanup(&plate(&points, &[0, 1, 2, 3, 4, 5, 6], hole), VERTICES, 1.0);
    assert_eq!(straight(&[]).unwrap().corners().len(), 4);
    assert!(straight(&[[37.0, -0.7], [40.0, -0.1], [43.0, -0.7]]).is_none());
    assert_eq!(straight(&[[37.0, 5.0], [40.0, 9.0], [43.0, 5.0]]).unwrap().corners().len(), 7);
}

#[test]
fn a_ramp_above_itself_stays_divided() {
    let ramp = |count: u32| {
        let mut builder = MeshBuilder::new();
        let rungs: Vec<[u32; 2]> = (0..=count)
            .map(|k| {
                let (sin, cos) = libm::sincos(f64::from(k) * std::f64::consts::TAU / 16.0);
                // The joined face grows from the largest one, in the middle.
                let outer = if k == 10 { 20.5 } else { 20.0 };
                [outer, 14.0].map(|radius| builder.point([radius * cos, 0.075 * f64::from(k), -radius * sin]))
            })
            .collect();
        for pair in rungs.windows(2) {
            builder.face(&[pair[0][1], pair[0][0], pair[1][0], pair[1][1]], &[], FaceTag::PLAIN);
        }
        builder.build().unwrap()
    };
    assert_eq!(cleanup(&ramp(12), EDGES, 1.0).unwrap().face_count(), 1);
    assert!(cleanup(&ramp(20), EDGES, 1.0).is_none());
}
