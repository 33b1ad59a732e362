//! The occluders near the last queries of a run.
//!
//! Queries come in the order of the shapes: a façade asks for each of its tiles, a street for each of its trees. So the search in the tree of
//! occluders is made for a region around a query, and the queries that follow in that region compare the few occluders that it has found.
//! Occluders that are ancestors of all these queries are left out once.

use std::sync::Arc;

use glam::DVec3;

use super::Ghost;
use crate::geometry::mesh::Bounds;
use crate::geometry::relation::{NearOccluders, Occluders, OrientedBox, QueryGeometry, Relation};
use crate::run::tree_keys::{Kinship, Place, TreeNode};

/// The most occluders that are worth a list.
const MOST: usize = 32;

/// The first distance from a query to the border of its region, in longest extents of its box.
const FIRST_GROWTH: f64 = 3.0;

/// The least such distance.
const LEAST_GROWTH: f64 = 0.5;

/// The number of regions after which there must have been more queries than [`LEAST_QUERIES`] for each of them.
const PROBATION: u32 = 8;

/// The queries that a region must serve on the average.
const LEAST_QUERIES: u32 = 3;

/// The ghosts that a query asks.
#[derive(Clone, Copy)]
pub(crate) struct AskedGhosts<'g> {
    /// The ghost of the same initial shape.
    pub(crate) own: Option<&'g Ghost>,
    /// The ghosts of others.
    pub(crate) others: &'g [Arc<Ghost>],
}

/// A query of occluders.
#[derive(Clone, Copy)]
pub(crate) struct OcclusionQuery<'q> {
    pub(crate) wanted: Relation,
    /// The label of the shapes that count. All count without one.
    pub(crate) label: Option<&'q str>,
    /// The place of the query in the tree of its shapes.
    pub(crate) place: Option<Place<'q>>,
}

/// The occluders near the last queries.
#[derive(Debug)]
pub(crate) struct NearQueries {
    region: Option<Region>,
    growth: f64,
    regions: u32,
    queries: u32,
}

/// A part of the world, and the occluders in it.
#[derive(Debug)]
struct Region {
    bounds: Bounds,
    /// A sphere: whatever is in it has its reach in the bounds.
    centre: DVec3,
    radius: f64,
    /// All queries are below this shape of their tree, or are asked by it.
    below: TreeNode,
    /// The occluders of the same initial shape that are neither `below` nor ancestors of it; all if `has_descendants`.
    own: NearOccluders,
    /// True if some of them are below `below`, so that the place of each query decides which ones count.
    has_descendants: bool,
    /// The ghosts of other initial shapes with occluders in the region.
    others: Vec<(usize, NearOccluders)>,
}

impl Default for NearQueries {
    fn default() -> Self {
        NearQueries { region: None, growth: FIRST_GROWTH, regions: 0, queries: 0 }
    }
}

impl NearQueries {
    /// Forgets the region. Shapes of an operand that has ended are not in the tree any more.
    pub(crate) fn forget(&mut self) {
        self.region = None;
    }

    /// The wanted answers for a geometry.
    pub(crate) fn relation(
        &mut self,
        ghosts: AskedGhosts<'_>,
        geometry: &QueryGeometry<'_>,
        query: OcclusionQuery<'_>,
    ) -> Relation {
        self.queries = self.queries.saturating_add(1);
        match self.find(ghosts, geometry.bounds(), query.place) {
            Some(region) => region
                .ask(ghosts, query, |solids, near, wanted, accept| solids.query_near(near, geometry, wanted, accept)),
            None => ghosts.relation(geometry, query),
        }
    }

    /// The wanted answers for a box or a rectangle.
    #[inline]
    pub(crate) fn relation_of_box(
        &mut self,
        ghosts: AskedGhosts<'_>,
        geometry: &OrientedBox<'_>,
        query: OcclusionQuery<'_>,
    ) -> Relation {
        self.queries = self.queries.saturating_add(1);
        let region = match &mut self.region {
            Some(region) if region.has_box(geometry, query.place) => region,
            _ => match self.find(ghosts, &geometry.around(), query.place) {
                Some(region) => region,
                None => return ghosts.relation(&geometry.to_query(), query),
            },
        };
        region.ask(ghosts, query, |solids, near, wanted, accept| solids.query_box_near(near, geometry, wanted, accept))
    }

    /// The region with the occluders for a query in some bounds, if it is worth one.
    fn find(&mut self, ghosts: AskedGhosts<'_>, bounds: &Bounds, place: Option<Place<'_>>) -> Option<&mut Region> {
        let reach = ghosts.reach(bounds);
        if !self.region.as_ref().is_some_and(|region| region.has(&reach, place)) {
            self.begin_region(ghosts, &reach, place);
        }
        self.region.as_mut()
    }

    /// Makes the region of a query. If that does not pay, no further region is made.
    #[cold]
    fn begin_region(&mut self, ghosts: AskedGhosts<'_>, reach: &Bounds, place: Option<Place<'_>>) {
        self.region = None;
        if self.growth < LEAST_GROWTH {
            return;
        }
        if PROBATION < self.regions && self.queries / LEAST_QUERIES < self.regions {
            self.growth = 0.0;
            return;
        }
        self.regions += 1;
        self.region = Region::around(ghosts, reach, self.growth, place);
        if self.region.is_none() {
            self.growth *= 0.5;
        }
    }
}

impl AskedGhosts<'_> {
    /// Returns true if no ghost has a closed shape.
    pub(crate) fn is_empty(&self) -> bool {
        self.own.is_none_or(|ghost| ghost.occluders().is_empty()) && self.others.is_empty()
    }

    /// The box that meets the boxes of all occluders to which geometry with these bounds can have a relation.
    #[inline]
    fn reach(&self, bounds: &Bounds) -> Bounds {
        let reach = |ghost: &Ghost| ghost.occluders().solids().reach(bounds);
        match (self.own, self.others) {
            (Some(own), []) => reach(own),
            (own, others) => {
                let own = own.map_or(Bounds::EMPTY, reach);
                others.iter().fold(own, |sum, ghost| sum.union(reach(ghost)))
            }
        }
    }

    /// The wanted answers, without a list of near occluders.
    fn relation(&self, geometry: &QueryGeometry<'_>, query: OcclusionQuery<'_>) -> Relation {
        let ask = |ghost: &Ghost, wanted: Relation, place| {
            let query = OcclusionQuery { wanted, place, ..query };
            let occluders = ghost.occluders();
            occluders.solids().query(geometry, wanted, &mut |number| occluders.counts(number, query))
        };
        let mut found = self.own.map_or(Relation::NONE, |ghost| ask(ghost, query.wanted, query.place));
        for ghost in self.others {
            if found == query.wanted {
                break;
            }
            found = found.or(ask(ghost, query.wanted.without(found), None));
        }
        found
    }
}

impl Region {
    /// The region around a query. `None` with many occluders.
    fn around(ghosts: AskedGhosts<'_>, reach: &Bounds, growth: f64, place: Option<Place<'_>>) -> Option<Self> {
        let margin = growth * reach.size().max_element();
        let bounds = Bounds { low: reach.low - margin, high: reach.high + margin };
        let mut own = match ghosts.own {
            Some(ghost) => ghost.occluders().solids().near(&bounds, MOST)?,
            None => NearOccluders::default(),
        };
        let (mut depth, mut has_descendants) = (0, false);
        if let (Some(ghost), Some(place)) = (ghosts.own, place) {
            own.retain(ghost.occluders().solids(), |number| match ghost.occluders().kinship(number, place) {
                Kinship::Above(above) => {
                    depth = depth.max(above);
                    false
                }
                Kinship::Below => {
                    has_descendants = true;
                    true
                }
                Kinship::Beside(from) => {
                    depth = depth.max(from);
                    true
                }
            });
        }
        let (mut others, mut count) = (Vec::new(), own.len());
        for (number, ghost) in ghosts.others.iter().enumerate() {
            let near = ghost.occluders().solids().near(&bounds, MOST.saturating_sub(count))?;
            count += near.len();
            if !near.is_empty() {
                others.push((number, near));
            }
        }
        let below = place.map_or_else(TreeNode::default, |place| place.ancestor(depth));
        // The tolerance grows with coordinates, so in the bounds it is at most this.
        let tolerance = (bounds.low - ghosts.reach(&bounds).low).max_element();
        let (centre, radius) = ((bounds.low + bounds.high) * 0.5, 0.5 * bounds.size().min_element() - 2.0 * tolerance);
        Some(Region { bounds, centre, radius, below, own, has_descendants, others })
    }

    /// Returns true if a box is in the sphere of the region: a quick way to see that the region has its occluders.
    #[inline]
    fn has_box(&self, geometry: &OrientedBox<'_>, place: Option<Place<'_>>) -> bool {
        let room = self.radius - geometry.radius();
        0.0 < room
            && geometry.centre().distance_squared(self.centre) < room * room
            && place.is_none_or(|place| place.is_at_or_below(self.below))
    }

    /// Returns true if the region has the occluders of a query.
    #[inline]
    fn has(&self, reach: &Bounds, place: Option<Place<'_>>) -> bool {
        let Bounds { low, high } = &self.bounds;
        low.x <= reach.low.x
            && reach.high.x <= high.x
            && low.y <= reach.low.y
            && reach.high.y <= high.y
            && low.z <= reach.low.z
            && reach.high.z <= high.z
            && place.is_none_or(|place| place.is_at_or_below(self.below))
    }

    /// The wanted answers that `ask` finds among the occluders of the region.
    #[inline]
    fn ask(
        &mut self,
        ghosts: AskedGhosts<'_>,
        query: OcclusionQuery<'_>,
        ask: impl Fn(&Occluders, &mut NearOccluders, Relation, &mut dyn FnMut(u32) -> bool) -> Relation,
    ) -> Relation {
        let place = query.place.filter(|_| self.has_descendants);
        let own = OcclusionQuery { place, ..query };
        let mut found = match ghosts.own.map(Ghost::occluders) {
            Some(ghost) if !self.own.is_empty() => {
                ask(ghost.solids(), &mut self.own, query.wanted, &mut |number| ghost.counts(number, own))
            }
            _ => Relation::NONE,
        };
        let other = OcclusionQuery { place: None, ..query };
        for (number, near) in &mut self.others {
            if found == query.wanted {
                break;
            }
            if let Some(ghost) = ghosts.others.get(*number).map(|ghost| ghost.occluders()) {
                let wanted = query.wanted.without(found);
                found = found.or(ask(ghost.solids(), near, wanted, &mut |number| ghost.counts(number, other)));
            }
        }
        found
    }
}
