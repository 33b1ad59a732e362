//! The occluders near a region, for many queries in it.

use glam::{DMat3, DVec3};

use super::Relation;
use super::cuboid_pair::{aligned_half, relate_aligned};
use super::occluders::{Occluders, Search};
use super::oriented_box::OrientedBox;
use super::query_geometry::QueryGeometry;
use super::tolerance::{largest_tolerance, tolerance};
use crate::bounds::Bounds;
use crate::bounds_tree::overlap;

/// Some of the occluders of a list: the ones near a region.
///
/// The boxes that rules divide a façade into have the same axes, and mostly the axes of the buildings beside it. So the extents of these
/// buildings along the axes are kept for the next box.
#[derive(Clone, Debug, Default)]
pub struct NearOccluders {
    list: Vec<NearOccluder>,
    /// The axes of the last box.
    axes: DMat3,
}

#[derive(Clone, Debug)]
struct NearOccluder {
    bounds: Bounds,
    /// Its place in the list of solids.
    at: u32,
    /// The centre of a box.
    centre: DVec3,
    /// The box along the axes of the last one, if it has the same axes.
    aligned: Option<AlignedBox>,
}

/// A box in coordinates along its axes.
#[derive(Clone, Debug)]
struct AlignedBox {
    centre: DVec3,
    /// Half of the extents.
    outer: DVec3,
}

impl Occluders {
    /// The occluders whose boxes meet a region. `None` if there are more than `most`.
    ///
    /// Many queries in one place find them once: [`query_near`](Occluders::query_near).
    pub fn near(&self, region: &Bounds, most: usize) -> Option<NearOccluders> {
        let mut list = Vec::new();
        let collect = |at: u32| {
            let (bounds, solid) = (self.bounds[at as usize], &self.solids[at as usize]);
            if overlap(&bounds, region) {
                let centre = solid.cuboid.map_or(DVec3::ZERO, |cuboid| cuboid.centre);
                list.push(NearOccluder { bounds, at, centre, aligned: None });
            }
            list.len() <= most
        };
        self.tree.visit(|bounds| overlap(bounds, region), collect);
        // No box has axes of 0.
        (list.len() <= most).then_some(NearOccluders { list, axes: DMat3::ZERO })
    }

    /// The answers of [`query`](Occluders::query) for a geometry with a [`reach`](Occluders::reach) in the region of `near`.
    pub fn query_near(
        &self,
        near: &NearOccluders,
        geometry: &QueryGeometry<'_>,
        wanted: Relation,
        accept: &mut dyn FnMut(u32) -> bool,
    ) -> Relation {
        let mut search = Search { occluders: self, geometry, wanted, found: Relation::NONE };
        let reach = self.reach(geometry.bounds());
        if !search.is_over() {
            for near in &near.list {
                if overlap(&near.bounds, &reach) && !search.compare(near.at, accept) {
                    break;
                }
            }
        }
        search.found
    }

    /// The answers of [`query_near`](Occluders::query_near) for a box or a rectangle.
    #[inline]
    pub fn query_box_near(
        &self,
        near: &mut NearOccluders,
        geometry: &OrientedBox<'_>,
        wanted: Relation,
        accept: &mut dyn FnMut(u32) -> bool,
    ) -> Relation {
        if near.list.is_empty() || wanted == Relation::NONE {
            return Relation::NONE;
        }
        let far = geometry.far();
        if !geometry.is_solid_or_rectangle() || !geometry.is_in_range(far) {
            return self.query_near(near, &geometry.to_query(), wanted, accept);
        }
        if near.axes != *geometry.axes {
            self.turn(near, geometry.axes);
        }
        let (half, inverse) = (geometry.half.abs(), geometry.axes.transpose());
        let centre = inverse * geometry.centre;
        // Twice the largest tolerance, so that rounding errors of the centres are in it.
        let reach = half + 2.0 * largest_tolerance(self.far.max(far));
        let mut found = Relation::NONE;
        for near in &near.list {
            let Some(aligned) = &near.aligned else {
                let query = geometry.to_query();
                if overlap(&near.bounds, &self.reach(query.bounds())) {
                    let mut search = Search { occluders: self, geometry: &query, wanted, found };
                    let is_over = !search.compare(near.at, accept);
                    found = search.found;
                    if is_over {
                        break;
                    }
                }
                continue;
            };
            let AlignedBox { centre: other, outer } = *aligned;
            let is_near = (centre.x - other.x).abs() <= outer.x + reach.x
                && (centre.y - other.y).abs() <= outer.y + reach.y
                && (centre.z - other.z).abs() <= outer.z + reach.z;
            if !is_near {
                continue;
            }
            let solid = &self.solids[near.at as usize];
            let missing = wanted.without(found);
            let away = inverse * (geometry.centre - near.centre);
            let tolerance = tolerance([solid.extent, 2.0 * half.max_element()], solid.far.max(far));
            let relation = relate_aligned(half, outer, away, tolerance, missing).and(missing);
            if relation != Relation::NONE && accept(solid.number) {
                found = found.or(relation);
                if found == wanted {
                    break;
                }
            }
        }
        found
    }

    /// Finds the extents of near occluders along other axes.
    #[cold]
    fn turn(&self, near: &mut NearOccluders, axes: &DMat3) {
        near.axes = *axes;
        let inverse = axes.transpose();
        for near in &mut near.list {
            let outer = self.solids[near.at as usize].cuboid.and_then(|cuboid| aligned_half(&cuboid, axes));
            near.aligned = outer.map(|outer| AlignedBox { centre: inverse * near.centre, outer });
        }
    }
}

impl NearOccluders {
    /// Keeps the occluders whose numbers `keep` accepts.
    pub fn retain(&mut self, occluders: &Occluders, mut keep: impl FnMut(u32) -> bool) {
        self.list.retain(|near| occluders.solids.get(near.at as usize).is_some_and(|solid| keep(solid.number)));
    }

    /// The number of occluders.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Returns true if no occluder is near.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }
}
