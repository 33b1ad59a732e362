//! Faces that are not planar, as heights above the plane in which they are offset.
//!
//! Corners of the face keep their heights, to the bit. A new point is equally far from the edges whose strips meet in it, and
//! its height is the mean of theirs, each taken at the end or the place between that is nearest to the point. So no height
//! leaves those of the face, the smaller the distance the nearer is a moved corner to its own height, and where the face is
//! level along an edge, its strip is level near it.

use glam::DVec2;

use crate::geometry::skeleton::Swept;

/// The heights of all points of what a face sweeps, from those of its own, which come first. Rings are as they were swept.
pub(super) fn heights(own: &[f64], rings: &[Vec<u32>], swept: &Swept) -> Vec<f64> {
    let edges: Vec<[u32; 2]> =
        rings.iter().flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]])).collect();
    let near = |edge: u32, point: u32| {
        let [a, b] = edges[edge as usize];
        let share = share(swept.points[point as usize], [a, b].map(|end| swept.points[end as usize]));
        own[a as usize] * (1.0 - share) + own[b as usize] * share
    };
    let mut sums = vec![(0.0, 0u32); swept.points.len()];
    let add = |sums: &mut [(f64, u32)], edge: u32, point: u32| {
        let (sum, count) = &mut sums[point as usize];
        *sum += near(edge, point);
        *count += 1;
    };
    for strip in &swept.strips {
        strip.ring.iter().for_each(|&point| add(&mut sums, strip.edge, point));
    }
    // Where strips are too thin to be any, the edges that have moved there.
    for ring in &swept.left {
        let missing: Vec<usize> = (0..ring.len()).filter(|&i| sums[ring[i].point as usize].1 == 0).collect();
        for i in missing {
            let before = ring[(i + ring.len() - 1) % ring.len()].edge;
            [before, ring[i].edge].into_iter().for_each(|edge| add(&mut sums, edge, ring[i].point));
        }
    }
    let mean = |(sum, count): (f64, u32)| if count == 0 { 0.0 } else { sum / f64::from(count) };
    own.iter().copied().chain(sums.into_iter().skip(own.len()).map(mean)).collect()
}

/// Where the nearest point of a segment is between its ends.
fn share(p: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let along = b - a;
    let length = along.length_squared();
    if length == 0.0 { 0.5 } else { ((p - a).dot(along) / length).clamp(0.0, 1.0) }
}
