//! Roofs that are planes over the outline: pyramid, shed and ridge.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use super::arcs::rings_of;
use super::{Outline, Rise, Roof, RoofFace, RoofPart};
use crate::each::Each;
use crate::nesting::extent::Extent;
use crate::nesting::polygons::NestedRings;
use crate::small_sort::SmallSort;
use crate::tol::{ANGLE_EPSILON, TIE_EPSILON};

/// A triangle for each edge, to an apex over the mean of all corners. An angle is measured at the first triangle. If the apex is
/// over the line of the first edge, no height gives this triangle an angle, so the next edge decides.
pub(super) fn pyramid(outline: &Outline<'_>, rise: Rise) -> Roof {
    let edges = outline.edges();
    let mean = edges.iter().map(|edge| outline.at(edge[0])).sum::<DVec2>() / edges.len() as f64;
    let height = match rise {
        Rise::Slope(slope) => {
            let Extent { low, high } = Extent::of(edges.iter().map(|edge| outline.at(edge[0])));
            let least = TIE_EPSILON * (high - low).max_element();
            let distance = |edge: &[u32; 2]| outline.along(*edge).perp_dot(mean - outline.at(edge[0])).abs();
            slope * edges.iter().map(distance).find(|distance| least < *distance).unwrap_or(0.0)
        }
        Rise::Height(height) => height,
    };
    let mut roof = Roof::over(outline);
    let apex = roof.point(mean.extend(height));
    // An outline whose edges are all on one line has no roof.
    for (number, [a, b]) in (0..).zip(edges).filter(|_| height != 0.0) {
        roof.face(RoofPart::Top, number, vec![a, b, apex]);
    }
    roof
}

/// One plane that rises from an edge, with an upright side at each other edge. The plane stands in the order of edges for
/// the edge. The lowest corner is in the polygon, also if the edge is not the lowest one. If the plane falls, the roof is
/// below the polygon.
pub(super) fn shed(outline: &Outline<'_>, edge: usize, rise: Rise) -> Roof {
    let edges = outline.edges();
    let along = outline.along(edges[edge]);
    let ahead = |p: DVec2| along.perp_dot(p - outline.at(edges[edge][0]));
    let distances = || edges.iter().map(|edge| ahead(outline.at(edge[0])));
    let low = distances().fold(f64::INFINITY, f64::min);
    let high = distances().fold(f64::NEG_INFINITY, f64::max);
    let slope = rise.slope(high - low);
    let mut raised = Raised::over(outline, slope * (high - low), |p| slope * (ahead(p) - low));
    let rings: Vec<Vec<u32>> =
        outline.rings.iter().map(|ring| ring.iter().map(|&p| raised.top[p as usize]).collect()).collect();
    let mut faces = raised.sides(outline, &BTreeMap::new());
    let mut top = RoofFace { part: RoofPart::Top, edge: Some(edge as u32), rings };
    if edge < outline.rings[0].len() {
        top.rings[0].rotate_left(edge);
    }
    let place = faces.iter().position(|(of, _)| edge <= *of).unwrap_or(faces.len());
    faces.insert(place, (edge, top));
    raised.roof.faces = faces.into_iter().map(|(_, face)| face).collect();
    raised.roof.below = slope < 0.0;
    raised.roof
}

/// Two planes that rise from the outermost points across a direction and meet half way between them, with an upright side
/// at each edge. The planes come first, then the sides in the order of edges.
pub(super) fn ridge(outline: &Outline<'_>, along: DVec2, rise: Rise) -> Roof {
    let across = along.perp();
    let Extent { low, high } = Extent::of(outline.edges().iter().map(|edge| {
        let p = outline.at(edge[0]);
        DVec2::new(along.dot(p), across.dot(p))
    }));
    let (middle, half) = ((low.y + high.y) * 0.5, (high.y - low.y) * 0.5);
    let slope = rise.slope(half);
    let height = |p| slope * (half - (across.dot(p) - middle).abs()).max(0.0);
    let mut raised = Raised::over(outline, slope * half, height);
    let near = ANGLE_EPSILON * (high - low).max_element();
    let side = |p: DVec2| {
        let s = across.dot(p) - middle;
        if s.abs() <= near { 0 } else { s.signum() as i32 }
    };
    // The points where edges cross the ridge.
    let mut crossings: BTreeMap<u32, u32> = BTreeMap::new();
    for (number, edge) in (0..).zip(outline.edges()) {
        let [a, b] = edge.each(|point| outline.at(point));
        if side(a) * side(b) < 0 {
            let [s, t] = [a, b].each(|p| across.dot(p) - middle);
            let at = a.lerp(b, s / (s - t));
            crossings.insert(number, raised.roof.point(at.extend(slope * half)));
        }
    }
    let mut tops = Vec::new();
    for half in [-1, 1] {
        tops.extend(half_of(outline, &raised, &crossings, &side, along, half));
    }
    let sides = raised.sides(outline, &crossings);
    raised.roof.faces = tops.into_iter().chain(sides.into_iter().map(|(_, face)| face)).collect();
    raised.roof
}

/// A polygon whose corners are raised.
struct Raised {
    roof: Roof,
    /// The raised point over each corner. A corner that is not raised is its own.
    top: Vec<u32>,
}

impl Raised {
    /// A polygon and the height over each place. `most` is the height of the whole roof: the corners of a rectangle are not
    /// raised below a ridge, except by rounding.
    fn over(outline: &Outline<'_>, most: f64, height: impl Fn(DVec2) -> f64) -> Self {
        let mut roof = Roof::over(outline);
        let top = (0..).zip(outline.points).map(|(point, &p)| {
            let height = height(p);
            let is_raised = TIE_EPSILON * most.abs() < height.abs();
            if is_raised { roof.point(p.extend(height)) } else { point }
        });
        let top = top.collect();
        Raised { roof, top }
    }

    /// The upright face at each edge, from its start to its end and back over the crossing with the ridge, with the number
    /// of the edge. An edge at height 0 has none.
    fn sides(&self, outline: &Outline<'_>, crossings: &BTreeMap<u32, u32>) -> Vec<(usize, RoofFace)> {
        let mut sides = Vec::new();
        let outer = outline.rings[0].len();
        for (number, [a, b]) in outline.edges().into_iter().enumerate() {
            let mut ring = vec![a, b];
            ring.extend(Some(self.top[b as usize]).filter(|top| *top != b));
            ring.extend(crossings.get(&(number as u32)));
            ring.extend(Some(self.top[a as usize]).filter(|top| *top != a));
            if 3 <= ring.len() {
                let part = if number < outer { RoofPart::Outer } else { RoofPart::Inner };
                sides.push((number, RoofFace { part, edge: Some(number as u32), rings: vec![ring] }));
            }
        }
        sides
    }
}

/// The roof plane on one side of the ridge, -1 or 1: its connected parts.
fn half_of(
    outline: &Outline<'_>,
    raised: &Raised,
    crossings: &BTreeMap<u32, u32>,
    side: &impl Fn(DVec2) -> i32,
    along: DVec2,
    half: i32,
) -> Vec<RoofFace> {
    let flat = |point: u32| raised.roof.points[point as usize].truncate();
    let mut arcs: Vec<[u32; 2]> = Vec::new();
    let mut on_ridge: Vec<u32> = crossings.values().copied().collect();
    for (number, [a, b]) in (0..).zip(outline.edges()) {
        let (sides, tops) = ([a, b].each(|p| side(outline.at(p))), [a, b].each(|p| raised.top[p as usize]));
        if sides[0] == 0 {
            on_ridge.push(tops[0]);
        }
        match (crossings.get(&number), sides) {
            (Some(&crossing), _) if sides[0] == half => arcs.push([tops[0], crossing]),
            (Some(&crossing), _) => arcs.push([crossing, tops[1]]),
            // An edge in the ridge belongs to the half on its left.
            (None, [0, 0]) if along.dot(outline.along([a, b])).signum() as i32 == half => arcs.push(tops),
            (None, [0, 0]) => {}
            (None, _) if sides.contains(&half) => arcs.push(tops),
            (None, _) => {}
        }
    }
    // Along the ridge, arcs close the half where the polygon is beside it.
    let place = |point: u32| along.dot(flat(point));
    on_ridge.small_sort_by(|&p, &q| place(p).total_cmp(&place(q)).then(p.cmp(&q)));
    on_ridge.dedup();
    let balance =
        |point: u32| arcs.iter().map(|arc| i32::from(arc[1] == point) - i32::from(arc[0] == point)).sum::<i32>();
    let balances: Vec<i32> = on_ridge.iter().map(|&point| balance(point)).collect();
    let mut open = 0;
    for (pair, balance) in on_ridge.windows(2).zip(&balances) {
        open += balance * half;
        if 0 < open {
            arcs.push(if half == 1 { [pair[0], pair[1]] } else { [pair[1], pair[0]] });
        }
    }
    nested(&raised.roof.points, rings_of(arcs.into_iter()))
}

/// Rings as faces with holes. Each begins with its lowest edge.
fn nested(points: &[DVec3], mut rings: Vec<Vec<u32>>) -> Vec<RoofFace> {
    let height = |point: u32| points[point as usize].z;
    for ring in &mut rings {
        let low = |i: usize| height(ring[i]) + height(ring[(i + 1) % ring.len()]);
        let first = (0..ring.len()).min_by(|&i, &k| low(i).total_cmp(&low(k)));
        ring.rotate_left(first.unwrap_or(0));
    }
    let flat: Vec<DVec2> = points.iter().map(|point| point.truncate()).collect();
    let nested = NestedRings::of(&flat, rings.into_iter());
    let rings = nested.polygons().map(|rings| rings.map(<[u32]>::to_vec).collect());
    rings.map(|rings| RoofFace { part: RoofPart::Top, edge: None, rings }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roof::{RoofForm, roof};

    const SLOPE: f64 = 0.8;

    /// The corners of a rectangle stay in its plane below a ridge, however it is turned.
    #[test]
    fn a_ridge_over_a_turned_rectangle_has_two_planes_and_two_triangles() {
        for turn in 0..360 {
            let along = DVec2::from_angle(f64::from(turn).to_radians());
            let from = DVec2::new(13.0, -6.5);
            let corners = [DVec2::ZERO, DVec2::new(20.0, 0.0), DVec2::new(20.0, 15.0), DVec2::new(0.0, 15.0)];
            let points = corners.map(|corner| from + along.rotate(corner));
            let outline = Outline { points: &points, rings: &[vec![0, 1, 2, 3]], x: along };
            let roof = roof(&outline, RoofForm::Ridge, Rise::Slope(SLOPE)).expect("a roof");
            let corners: Vec<usize> = roof.faces.iter().map(|face| face.rings[0].len()).collect();
            assert_eq!((corners, roof.points.len()), (vec![4, 4, 3, 3], 6), "{turn}");
        }
    }
}
