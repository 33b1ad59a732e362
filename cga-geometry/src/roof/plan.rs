//! A hip or gable roof as seen from above: the faces of the straight skeleton, with the distance from the eaves as the
//! height of each point.

use glam::DVec2;

use super::arcs::{FaceArcs, arcs, joined};
use super::settle::settle;
use super::{Outline, Roof, RoofFace, RoofPart};
use crate::disjoint::DisjointSets;
use crate::nesting::extent::Extent;
use crate::skeleton::{self, SkeletonError, Speeds, Swept};
use crate::small_sort::{SmallSort, sort_owned_by};
use crate::tol::{NUDGE_EPSILONS, TIE_EPSILON, TOUCH_EPSILON};

/// A ridge is between edges whose directions differ from opposite ones by less than 45 degrees: the cosine of 135 degrees.
const RIDGE: f64 = -std::f64::consts::FRAC_1_SQRT_2;

/// Points that are each moved by less than a distance relative to their extent.
fn nudged(points: &[DVec2], by: f64) -> Vec<DVec2> {
    let Extent { low, high } = Extent::of(points.iter().copied());
    let by = by * (high - low).max_element();
    // Multiples of an irrational number, modulo 1, are spread evenly.
    let share = |i: usize, step: f64| (i as f64 * step).fract() - 0.5;
    let nudge = |i: usize| DVec2::new(share(i, 0.618_033_988_749_894_8), share(i, std::f64::consts::SQRT_2));
    points.iter().enumerate().map(|(i, p)| *p + nudge(i) * by).collect()
}

/// The face over an edge.
#[derive(Clone, Debug)]
pub(super) struct PlanFace {
    pub(super) edge: u32,
    pub(super) ring: Vec<u32>,
}

/// The faces over the edges of an outline.
#[derive(Debug)]
pub(super) struct Plan {
    /// The corners of the outline, then new points.
    pub(super) points: Vec<DVec2>,
    /// The distance of each point from the eaves, along the face; negative outside.
    pub(super) rises: Vec<f64>,
    pub(super) faces: Vec<PlanFace>,
    /// True for points that `even` has moved.
    pub(super) moved: Vec<bool>,
}

impl Plan {
    /// The whole straight skeleton, with a speed for each edge. Edges with speed 0 get upright faces.
    ///
    /// An outline whose events are too entangled is tried again with its corners moved by far less than a hair: the
    /// structure of that skeleton is right for the outline up to this distance.
    pub(super) fn of(outline: &Outline<'_>, speeds: &[f64]) -> Result<Plan, SkeletonError> {
        let speeds = Speeds::Heights(speeds);
        let mut found = skeleton::sweep_at(outline.points, outline.rings, speeds, f64::INFINITY);
        for by in NUDGE_EPSILONS {
            if found != Err(SkeletonError::Tangled) {
                break;
            }
            found = skeleton::sweep_at(&nudged(outline.points, by), outline.rings, speeds, f64::INFINITY);
        }
        let mut swept = found?;
        swept.points[..outline.points.len()].copy_from_slice(outline.points);
        settle(&mut swept, outline, speeds);
        let Swept { points, times, strips, .. } = swept;
        let faces = strips.into_iter().map(|strip| PlanFace { edge: strip.edge, ring: strip.ring }).collect();
        let moved = vec![false; points.len()];
        Ok(Plan { points, rises: times, faces, moved })
    }

    /// The largest distance from the eaves.
    pub(super) fn top(&self) -> f64 {
        self.rises.iter().copied().fold(0.0, f64::max)
    }

    pub(super) fn point(&mut self, at: DVec2, rise: f64) -> u32 {
        self.points.push(at);
        self.rises.push(rise);
        self.moved.push(false);
        self.points.len() as u32 - 1
    }

    /// Continues a ridge to a place where its planes are higher by `rise`. A ridge that was made level stays level.
    pub(super) fn beyond(&mut self, ridge: u32, at: DVec2, rise: f64) -> u32 {
        let moved = self.moved[ridge as usize];
        let point = self.point(at, self.rises[ridge as usize] + if moved { 0.0 } else { rise });
        self.moved[point as usize] = moved;
        point
    }

    /// The arcs of the faces.
    pub(super) fn face_arcs(&self) -> FaceArcs {
        FaceArcs::of(self.faces.iter().map(|face| &face.ring[..]), self.points.len())
    }

    /// Makes ridges level: the corners of each connected ridge get their mean height. A ridge is between two edges that
    /// run against each other, so hips and valleys do not count. Points at one place, except for rounding, are one corner.
    pub(super) fn level_ridges(&mut self, outline: &Outline<'_>) {
        let (edges, face_arcs) = (outline.edges(), self.face_arcs());
        let is_new = |point: u32| outline.points.len() <= point as usize;
        let along = |face: usize| outline.along(edges[self.faces[face].edge as usize]);
        let Extent { low, high } = Extent::of(outline.points.iter().copied());
        let near = TOUCH_EPSILON * (high - low).max_element();
        let (mut ridges, mut places) = (DisjointSets::new(self.points.len()), DisjointSets::new(self.points.len()));
        for ([a, b], face) in face_arcs.iter() {
            let Some(other) = face_arcs.left_of([b, a]) else { continue };
            if b < a || !is_new(a) || !is_new(b) {
                continue;
            }
            let is_one_place = self.points[a as usize].distance(self.points[b as usize]) <= near;
            if is_one_place {
                places.unite(a, b);
            }
            if is_one_place || along(face).dot(along(other)) < RIDGE {
                ridges.unite(a, b);
            }
        }
        let mut share = vec![1.0; self.points.len()];
        for place in places.sets().into_iter().filter(|place| 1 < place.len()) {
            place.iter().for_each(|&point| share[point as usize] = 1.0 / place.len() as f64);
        }
        for ridge in ridges.sets().into_iter().filter(|ridge| 1 < ridge.len()) {
            let sum = |value: &dyn Fn(usize) -> f64| ridge.iter().map(|&point| value(point as usize)).sum::<f64>();
            let mean = sum(&|point| self.rises[point] * share[point]) / sum(&|point| share[point]);
            for point in ridge {
                let rise = &mut self.rises[point as usize];
                self.moved[point as usize] = TIE_EPSILON * mean < (*rise - mean).abs();
                *rise = mean;
            }
        }
    }

    /// Joins regions to the faces, each of an edge and a ring. `fronts` are the arcs where the faces now begin, each with its
    /// edge, in the order of edges.
    pub(super) fn join(&mut self, regions: Vec<(u32, Vec<u32>)>, fronts: &[(u32, [u32; 2])]) {
        let own = std::mem::take(&mut self.faces).into_iter().map(|face| (face.edge, face.ring));
        let mut parts: Vec<(u32, Vec<u32>)> = own.chain(regions).collect();
        // The parts of an edge keep their order.
        sort_owned_by(&mut parts, |a, b| a.0.cmp(&b.0));
        for parts in parts.chunk_by_mut(|a, b| a.0 == b.0) {
            let edge = parts[0].0;
            let first = fronts.partition_point(|front| front.0 < edge);
            let fronts = || fronts[first..].iter().take_while(|front| front.0 == edge).map(|front| front.1);
            let rings = match parts {
                [(_, ring)] => vec![std::mem::take(ring)],
                _ => joined(parts.iter().map(|part| &part.1[..])),
            };
            for mut ring in rings {
                let first = fronts().find_map(|front| arcs(&ring).position(|arc| arc == front));
                ring.rotate_left(first.unwrap_or(0));
                self.faces.push(PlanFace { edge, ring });
            }
        }
    }

    /// Rotates faces so that they begin with the first arc at the eave, which may be longer than the edge. Faces over ends
    /// stay as they are.
    pub(super) fn begin_at_eaves(&mut self, outline: &Outline<'_>, is_end: impl Fn(u32) -> bool) {
        let edges = outline.edges();
        for face in self.faces.iter_mut().filter(|face| !is_end(face.edge)) {
            let along = outline.along(edges[face.edge as usize]);
            let at_eave = |arc: &[u32; 2]| arc.iter().all(|&point| self.rises[point as usize] == 0.0);
            let place = |arc: [u32; 2]| along.dot(self.points[arc[0] as usize]);
            let found = arcs(&face.ring).enumerate().filter(|(_, arc)| at_eave(arc));
            let first = found.min_by(|a, b| place(a.1).total_cmp(&place(b.1))).map(|found| found.0);
            face.ring.rotate_left(first.unwrap_or(0));
        }
    }

    /// Removes points between two collinear arcs of the faces over edges that `counts` selects, if no other face has them.
    pub(super) fn drop_straight(&mut self, counts: &dyn Fn(u32) -> bool) {
        let face_arcs = self.face_arcs();
        let is_straight = |point: u32| {
            let around = || face_arcs.around(point).map(|(end, face)| (end, counts(self.faces[face].edge)));
            let (mut first, mut second) = (None, None);
            for (end, _) in around().filter(|end| end.1) {
                match (first, second) {
                    (None, _) => first = Some(end),
                    (Some(a), _) if a == end => {}
                    (_, None) => second = Some(end),
                    (_, Some(b)) if b == end => {}
                    _ => return false,
                }
            }
            let (Some(a), Some(b)) = (first, second) else { return false };
            // An upright face needs the points of the arcs that it shares.
            let is_free = |end: u32| around().all(|(other, counts)| other != end || counts);
            let to = |end: u32| (self.points[end as usize] - self.points[point as usize]).normalize_or_zero();
            let (to_a, to_b) = (to(a), to(b));
            to_a.dot(to_b) < 0.0 && to_a.perp_dot(to_b).abs() < TIE_EPSILON.sqrt() && is_free(a) && is_free(b)
        };
        let is_gone: Vec<bool> = (0..self.points.len() as u32).map(is_straight).collect();
        for face in self.faces.iter_mut().filter(|face| counts(face.edge)) {
            let kept = |point: &u32| !is_gone[*point as usize];
            if 3 <= face.ring.iter().filter(|point| kept(point)).count() {
                face.ring.retain(kept);
            }
        }
    }

    /// The roof whose planes rise by `slope` per metre. Faces over edges that `is_side` selects are upright.
    pub(super) fn roof(mut self, slope: f64, is_side: &dyn Fn(u32) -> bool) -> Roof {
        sort_owned_by(&mut self.faces, |a, b| a.edge.cmp(&b.edge));
        let part = |edge: u32| if is_side(edge) { RoofPart::Side } else { RoofPart::Top };
        let face =
            |PlanFace { edge, ring }: PlanFace| RoofFace { part: part(edge), edge: Some(edge), rings: vec![ring] };
        let faces = self.faces.into_iter().map(face).collect();
        let points = self.points.iter().zip(&self.rises).map(|(p, rise)| p.extend(rise * slope)).collect();
        Roof { points, faces, moved: self.moved, below: false }
    }
}

/// The region outside that edges sweep when each moves outwards by its distance: the strip of each edge.
pub(super) struct Outside {
    pub(super) strips: Vec<OutsideStrip>,
}

pub(super) struct OutsideStrip {
    pub(super) edge: u32,
    pub(super) ring: Vec<u32>,
    /// For each side of the ring whether it is an outer edge.
    pub(super) front: Vec<bool>,
}

impl Plan {
    /// Sweeps the outside, and adds its points to the plan, as far below the eaves as an edge with speed `eave` has moved.
    pub(super) fn outside(
        &mut self,
        outline: &Outline<'_>,
        distances: &[f64],
        eave: f64,
    ) -> Result<Outside, SkeletonError> {
        let most = distances.iter().copied().fold(0.0, f64::max);
        let (mut rings, mut edges) = (Vec::new(), Vec::new());
        for ring in outline.rings {
            let (first, count) = (edges.len() as u32, ring.len() as u32);
            // Edges in reverse order, each from its end to its start.
            rings.push((0..count).map(|i| ring[((count - i) % count) as usize]).collect::<Vec<u32>>());
            edges.extend((first..first + count).rev());
        }
        let speeds: Vec<f64> = edges.iter().map(|&edge| distances[edge as usize] / most).collect();
        let speeds = Speeds::Heights(&speeds);
        let mut swept = skeleton::sweep_at(outline.points, &rings, speeds, most)?;
        settle(&mut swept, &Outline { rings: &rings, ..*outline }, speeds);
        let given = outline.points.len();
        let new: Vec<u32> = (0..swept.points.len())
            .map(|i| if i < given { i as u32 } else { self.point(swept.points[i], -swept.times[i] * eave / most) })
            .collect();
        let strips = swept.strips.into_iter().map(|strip| OutsideStrip {
            edge: edges[strip.edge as usize],
            ring: strip.ring.iter().map(|&point| new[point as usize]).collect(),
            front: strip.front,
        });
        Ok(Outside { strips: strips.collect() })
    }
}

impl Outside {
    /// The outer edges of the strips that `counts` selects, each with the edge of its strip, in the order of edges.
    pub(super) fn fronts(&self, counts: impl Fn(&OutsideStrip) -> bool) -> Vec<(u32, [u32; 2])> {
        let counted = self.strips.iter().filter(|strip| counts(strip));
        let mut fronts: Vec<_> = counted.flat_map(|strip| strip.fronts().map(|front| (strip.edge, front))).collect();
        fronts.small_sort_by_key(|front| front.0);
        fronts
    }
}

impl OutsideStrip {
    /// The outer edges, in the direction of the edge of the outline, in their order along it.
    pub(super) fn fronts(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        arcs(&self.ring).zip(&self.front).filter(|(_, front)| **front).map(|(arc, _)| arc)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roof::{Rise, RoofForm, roof};

    const SLOPE: f64 = 0.8;

    /// Ridges get the mean height of their corners. Corners at one place count once, also where rounding divides them.
    #[test]
    fn rounding_does_not_move_level_ridges() {
        let corner = |i: u32| DVec2::from_angle(f64::from(i) * std::f64::consts::FRAC_PI_6) * 3.0;
        let top = |points: &[DVec2], form: RoofForm| {
            let outline = Outline { points, rings: &[(0..12).collect()], x: DVec2::X };
            let roof = roof(&outline, form, Rise::Slope(SLOPE)).expect("a roof");
            roof.points.iter().fold(0.0, |most: f64, point| most.max(point.z))
        };
        let hip = RoofForm::Hip { overhang: 0.0, even: true };
        for form in [hip, RoofForm::Gable { across: 0.0, along: 0.0, even: true, edge: None }] {
            let heights: Vec<f64> = (0..100)
                .map(|turn| {
                    let along = DVec2::from_angle(f64::from(turn) * 0.1);
                    let far = DVec2::new(5e5, 4e6) * f64::from(turn.min(1));
                    let points = (0..12).map(|i| corner(i) + DVec2::new(f64::from(i % 2) * 3.0, 0.0));
                    top(&points.map(|point| (along.rotate(point) + far) - far).collect::<Vec<_>>(), form)
                })
                .collect();
            assert!(heights.iter().all(|height| (height - heights[0]).abs() < 1e-6), "{form:?}: {heights:?}");
        }
    }
}
