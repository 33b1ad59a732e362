//! Faces that cross themselves.

use super::*;
use crate::mesh::{FaceTag, MeshBuilder};
use crate::random::Rng;

/// A face with random loops on a grid, which often cross and touch themselves and each other.
fn random_face(rng: &mut Rng, grid: u64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut below = |limit: u64| rng.next() % limit;
    let loops: Vec<Vec<u32>> = (0..=below(3))
        .map(|_| (0..3 + below(8)).map(|_| builder.point([below(grid) as f64, below(grid) as f64, 0.0])).collect())
        .collect();
    let holes: Vec<&[u32]> = loops[1..].iter().map(Vec::as_slice).collect();
    builder.face(&loops[0], &holes, FaceTag::PLAIN);
    builder.build().unwrap()
}

/// Such a face is refused, or it has parts that add up to it.
#[test]
fn faces_that_cross_themselves_are_refused_with_any_limit() {
    let rng = &mut Rng(7);
    let mut refused = [0; 4];
    for step in 0..2000 {
        let mesh = random_face(rng, [4, 12, 1000][step % 3]);
        for (count, longest) in refused.iter_mut().zip([f64::INFINITY, 500.0, 30.0, 3.0]) {
            let found = convexify(&mesh, longest);
            *count += found.refused.len();
            let Some((made, _)) = found.made else { continue };
            assert!(found.refused.is_empty() && made.check().is_empty(), "{step} {longest}: {:?}", made.check());
            assert!((made.area() - mesh.area()).abs() <= 1e-9 * mesh.area(), "{step} {longest}");
        }
    }
    assert!(refused.iter().all(|&count| 1500 < count), "{refused:?}");
}

#[test]
fn a_bow_is_refused_with_any_limit_and_a_spiral_with_none() {
    let polygon = |corners: &[[f64; 2]]| {
        let mut builder = MeshBuilder::new();
        let ring: Vec<u32> = corners.iter().map(|&[x, y]| builder.point([x, y, 0.0])).collect();
        builder.face(&ring, &[], FaceTag::PLAIN);
        builder.build().unwrap()
    };
    let bow = polygon(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 3.0]]);
    let spiral = polygon(&[
        [0.0, 0.0],
        [9.0, 0.0],
        [9.0, 9.0],
        [2.0, 9.0],
        [2.0, 4.0],
        [5.0, 4.0],
        [5.0, 6.0],
        [4.0, 6.0],
        [4.0, 5.0],
        [3.0, 5.0],
        [3.0, 7.0],
        [7.0, 7.0],
        [7.0, 2.0],
        [0.0, 2.0],
    ]);
    for longest in [f64::INFINITY, 100.0, 2.5, 0.1] {
        let found = convexify(&bow, longest);
        assert!(found.refused == [0] && found.made.is_none(), "{longest}");
        let found = convexify(&spiral, longest);
        assert_eq!((found.refused.len(), found.made.is_some()), (0, 1.0 < longest), "{longest}");
    }
    // Star polygons wind around their middle twice.
    let star = polygon(&[[10.0, 0.0], [-8.0, 6.0], [3.0, -9.5], [3.0, 9.5], [-8.0, -6.0]]);
    assert!([f64::INFINITY, 5.0].into_iter().all(|longest| convexify(&star, longest).refused == [0]));
}
