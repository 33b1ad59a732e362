use glam::DVec2;

use super::*;
use crate::extrude::{Extrude, extrude};
use crate::mesh::{FaceTag, MeshBuilder};

/// An outline read from a picture, in pixels with y up.
const PICTURE: [[f64; 2]; 10] = [
    [70.0, -41.0],
    [70.0, -81.0],
    [29.0, -85.0],
    [24.0, -163.0],
    [105.0, -159.0],
    [110.0, -204.0],
    [193.0, -207.0],
    [197.0, -128.0],
    [235.0, -124.0],
    [240.0, -34.0],
];

fn polygon(outline: &[[f64; 2]], holes: &[&[[f64; 2]]], height: impl Fn(f64, f64) -> f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut ring = |points: &[[f64; 2]]| -> Vec<u32> {
        points.iter().map(|&[x, y]| builder.point([x, height(x, y), -y])).collect()
    };
    let outer = ring(outline);
    let holes: Vec<Vec<u32>> = holes.iter().map(|hole| ring(hole)).collect();
    builder.face(&outer, &holes.iter().map(Vec::as_slice).collect::<Vec<_>>(), FaceTag::PLAIN);
    builder.build().unwrap()
}

fn seen_from_above(mesh: &Mesh) -> Vec<DVec2> {
    mesh.points().iter().map(|point| DVec2::new(point.x, -point.z)).collect()
}

#[test]
fn the_outline_of_the_picture_gets_right_angles() {
    let lot = polygon(&PICTURE, &[], |_, _| 0.0);
    let made = rectify(&lot, 15.0).unwrap().unwrap();
    assert_eq!(made.check(), []);
    let points = seen_from_above(&made);
    // Each edge goes through its middle, as the picture shows to the pixel.
    let shown = [
        [70.5, -37.0],
        [70.5, -84.0],
        [26.5, -84.0],
        [26.5, -160.0],
        [108.5, -160.0],
        [108.5, -205.0],
        [194.5, -205.0],
        [194.5, -126.0],
        [237.5, -126.0],
        [237.5, -37.0],
    ];
    for (point, shown) in points.iter().zip(shown) {
        assert!((*point - DVec2::from(shown)).abs().max_element() <= 1.5, "{point} {shown:?}");
    }
    for (k, point) in points.iter().enumerate() {
        let step = points[(k + 1) % 10] - *point;
        assert!(step.x == 0.0 || step.y == 0.0, "{step}");
    }
    // With a small angle only the edges that deviate less turn.
    let made = rectify(&lot, 3.0).unwrap().unwrap();
    let steps = |mesh: &Mesh| {
        let points = seen_from_above(mesh);
        (0..10).filter(|&k| (points[(k + 1) % 10] - points[k]).abs().min_element() < 1e-9).count()
    };
    assert_eq!((steps(&made), steps(&lot)), (5, 1));
    assert!(matches!(rectify(&lot, 0.0), Ok(None)));
}

#[test]
fn an_edge_turns_if_it_deviates_by_less_than_the_angle() {
    for (degrees, limit, turns) in [(9.9, 10.0, true), (10.1, 10.0, false), (44.9, 45.0, true), (45.0, 45.0, false)] {
        let rise = 4.0 * libm::tan(f64::to_radians(degrees));
        let lot = polygon(
            &[[0.0, 0.0], [10.0, 0.0], [10.0, 6.0 + rise], [6.0, 6.0 + rise], [2.0, 6.0], [0.0, 6.0]],
            &[],
            |_, _| 0.0,
        );
        let made = rectify(&lot, limit).unwrap();
        assert_eq!(made.is_some(), turns, "{degrees}");
        if let Some(made) = made {
            // The lines of three edges are one: the middles are weighted by their lengths.
            let height = (4.0 * (6.0 + rise) + 4.0 * (6.0 + 0.5 * rise) + 2.0 * 6.0) / 10.0;
            assert!(
                (made.bounds().high.z - 0.0).abs() < 1e-12 && (-made.bounds().low.z - height).abs() < 1e-9,
                "{degrees}"
            );
        }
    }
}

#[test]
fn slanted_lots_stay_in_their_plane_and_upright_edges_upright() {
    let slope = |x: f64, y: f64| 0.3 * x - 0.2 * y + 4.0;
    let made = rectify(&polygon(&PICTURE, &[], slope), 15.0).unwrap().unwrap();
    assert!(made.points().iter().all(|p| (p.y - slope(p.x, -p.z)).abs() < 1e-9 * 200.0));
    let block = extrude(&polygon(&PICTURE, &[], |_, _| 0.0), Extrude::FaceNormal, 30.0);
    let made = rectify(&block, 15.0).unwrap().unwrap();
    assert!(made.is_closed() && made.check().is_empty() && made.face_count() == block.face_count());
    assert!(
        (made.volume() - 30.0 * rectify(&polygon(&PICTURE, &[], |_, _| 0.0), 15.0).unwrap().unwrap().area()).abs()
            < 1e-6
    );
}

#[test]
fn holes_turn_too_and_those_that_vanish_are_removed() {
    let outline = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]];
    let bent = [[5.0, 5.0], [5.5, 9.0], [9.0, 9.5], [9.0, 5.0]];
    let sliver = [[12.0, 12.0], [15.0, 12.2], [18.0, 12.0]];
    let made = rectify(&polygon(&outline, &[&bent, &sliver], |_, _| 0.0), 15.0).unwrap().unwrap();
    assert_eq!((made.face(0).loops().len(), made.check()), (2, Vec::new()));
    // x from 5.25 to 9, y from 5 to 9.25.
    assert!((made.area() - (400.0 - 3.75 * 4.25)).abs() < 1e-9, "{}", made.area());
}

#[test]
fn a_face_that_would_vanish_is_reported() {
    let sliver = polygon(&[[0.0, 0.0], [10.0, 0.0], [10.0, 1.0]], &[], |_, _| 0.0);
    assert!(rectify(&sliver, 3.0).is_ok());
    let flat = polygon(&[[0.0, 0.0], [10.0, 0.0], [5.0, 1.0]], &[], |_, _| 0.0);
    assert_eq!(rectify(&flat, 45.0).err(), Some(Collapsed { face: 0 }));
    assert!(matches!(rectify(&Mesh::default(), 45.0), Ok(None)));
}

#[test]
fn a_face_that_crosses_itself_does_not_vanish() {
    let bow = |size: f64| polygon_of(&[[0.0, 0.0], [size, 0.75 * size], [size, 0.0], [0.0, 0.75 * size]]);
    for size in [1.0, 4.0, 1e-6, 1e9] {
        assert_eq!(rectify(&bow(size), 45.0).err(), Some(Collapsed { face: 0 }), "{size}");
    }
    // With a smaller limit no edge moves far.
    assert!(rectify(&bow(4.0), 20.0).unwrap().is_none_or(|made| made.face_count() == 1));
    // Beside a face that stays.
    let mut builder = MeshBuilder::new();
    let mut add = |corners: [[f64; 2]; 4]| {
        let ring = corners.map(|[x, y]| builder.point([x, 0.0, -y]));
        builder.face(&ring, &[], FaceTag::PLAIN);
    };
    add([[10.0, 0.0], [14.0, 0.2], [14.0, 4.0], [10.0, 4.0]]);
    add([[0.0, 0.0], [4.0, 3.0], [4.0, 0.0], [0.0, 3.0]]);
    assert_eq!(rectify(&builder.build().unwrap(), 45.0).err(), Some(Collapsed { face: 1 }));
}

/// A polygon that may cross itself.
fn polygon_of(outline: &[[f64; 2]]) -> Mesh {
    let mut builder = MeshBuilder::new();
    let ring: Vec<u32> = outline.iter().map(|[x, y]| builder.point([*x, 0.0, -y])).collect();
    builder.face(&ring, &[], FaceTag::PLAIN);
    builder.build().unwrap()
}
