//! Heights of faces that are not planar, relative to the plane of their offset.
//!
//! Corners of the face keep their heights, bit for bit. A new point is equally far from the edges whose strips meet at
//! it. Its height is the mean over these edges of the height at the edge's nearest point. So all heights are within the
//! range of the face. For small distances a moved corner is close to its own height. If the face is level along an
//! edge, its strip is level near the edge.

use crate::each::Each;
use crate::segment::nearest_share;
use crate::skeleton::Swept;

/// The heights of all points of a swept face, from the heights of its own points, which come first. `rings` are in
/// swept order.
pub(super) fn heights(own: &[f64], rings: &[Vec<u32>], swept: &Swept) -> Vec<f64> {
    if own.iter().all(|height| *height == 0.0) {
        return vec![0.0; swept.points.len()];
    }
    let edges: Vec<[u32; 2]> =
        rings.iter().flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]])).collect();
    let near = |[a, b]: [u32; 2], point: u32| {
        let share = nearest_share(swept.points[point as usize], [a, b].each(|end| swept.points[end as usize]));
        own[a as usize] * (1.0 - share) + own[b as usize] * share
    };
    let mut sums = vec![(0.0, 0u32); swept.points.len()];
    let add = |sums: &mut [(f64, u32)], edge: u32, point: u32| {
        // A line that divides a corner is on no edge.
        let Some(&edge) = edges.get(edge as usize) else { return };
        let (sum, count) = &mut sums[point as usize];
        *sum += near(edge, point);
        *count += 1;
    };
    for strip in &swept.strips {
        strip.ring.iter().for_each(|&point| add(&mut sums, strip.edge, point));
    }
    // Points without a strip, because the strips are too thin: the edges that have moved there count.
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
