//! The relation of a segment or a point to a closed mesh.

use glam::DVec3;

use super::Relation;
use super::budget::Budget;
use super::plane_cut::edge_planes;
use super::surface::{Place, Surface};
use crate::bounds::Bounds;
use crate::small_sort::SmallSort;

/// The places of a part of a segment that are compared until one is not on the surface, as shares of its length.
const SHARES: [f64; 5] = [0.5, 0.25, 0.75, 0.02, 0.98];

/// The relation of a segment.
pub(super) fn relate_segment(ends: [DVec3; 2], occluder: &Surface, tolerance: f64) -> Relation {
    let mut cuts = vec![0.0, 1.0];
    let mut cut = |from: f64, to: f64| {
        if (from < 0.0) != (to < 0.0) {
            cuts.push((from / (from - to)).clamp(0.0, 1.0));
        }
    };
    occluder.near(&Bounds::of(ends), tolerance, |piece| {
        let polygon = occluder.polygon(piece);
        let [from, to] = ends.map(|end| polygon.height(end));
        if from.min(to) <= tolerance && -tolerance <= from.max(to) {
            cut(from, to);
            for [a, inwards] in edge_planes(polygon.corners, polygon.normal) {
                let [from, to] = ends.map(|end| (end - a).dot(inwards));
                cut(from, to);
            }
        }
        true
    });
    cuts.small_sort_unstable_by(f64::total_cmp);
    let (budget, mut is_outside, mut overlaps) = (Budget::new(), false, false);
    for part in cuts.windows(2) {
        let at = |share: &f64| ends[0] + (ends[1] - ends[0]) * (part[0] + (part[1] - part[0]) * share);
        let places = SHARES.iter().map(|share| occluder.place(at(share), DVec3::ZERO, tolerance, &budget));
        let place = places.into_iter().find(|place| *place != Place::On);
        is_outside |= place == Some(Place::Outside);
        overlaps |= place == Some(Place::Inside);
        if is_outside && overlaps || budget.is_spent() {
            break;
        }
    }
    Relation::of(!is_outside && !budget.is_spent(), overlaps, false)
}

/// The relation of a point. On the surface it is inside, without overlapping.
pub(super) fn relate_point(point: DVec3, occluder: &Surface, tolerance: f64) -> Relation {
    let budget = Budget::new();
    match occluder.place(point, DVec3::ZERO, tolerance, &budget) {
        _ if budget.is_spent() => Relation::NONE,
        Place::Inside => Relation::ALL,
        Place::On => Relation::of(true, false, false),
        Place::Outside => Relation::NONE,
    }
}
