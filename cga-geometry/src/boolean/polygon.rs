//! The polygons of a result: connected sheets of one face, without the edges between them.

use std::collections::{BTreeMap, BTreeSet};

use super::budget::Budget;
use super::cell::{Cells, FacetWinding, GraphLines};
use super::component_tags::EdgeTags;
use super::edge_table::{EdgeTable, NO_CORNER};
use super::facet::Facet;
use super::lists::{Lists, Polygons, Rings};
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::progress::goes_on;
use super::selection::ChosenSheets;
use super::sheet::{Sheet, Sheets};
use crate::buckets::Buckets;
use crate::disjoint::DisjointSets;
use crate::long_sort::long_sort_by;
use crate::mesh::in_order;
use crate::small_sort::{SmallSort, sort_owned_by};

/// A corner of a polygon, and the edge that starts there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PolygonCorner {
    pub(super) point: u32,
    /// The ends, as corners of the mesh, of the edge of the face that contains this edge. [`NO_CORNER`] for an edge inside
    /// the face.
    pub(super) along: [u32; 2],
    /// The number of the edge's tags.
    pub(super) tags: u32,
}

/// A face of the result, in the direction of its first facet.
#[derive(Clone, Copy)]
pub(super) struct ResultPolygon<'a> {
    /// The facets of which it is a part.
    pub(super) sources: &'a [u32],
    /// True if the face of the result faces the other way.
    pub(super) is_turned: bool,
    /// The outline and the holes.
    pub(super) rings: Rings<'a, PolygonCorner>,
}

/// The faces of a result, in their order.
#[derive(Default)]
pub(super) struct ResultPolygons<'a> {
    faces: Vec<ResultFace<'a>>,
    rings: Polygons<PolygonCorner>,
}

struct ResultFace<'a> {
    /// The face of the mesh, the place in it, and the number of the polygon.
    order: [u32; 3],
    sources: &'a [u32],
    is_turned: bool,
}

impl ResultPolygons<'_> {
    pub(super) fn iter(&self) -> impl Iterator<Item = ResultPolygon<'_>> {
        self.faces.iter().map(|&ResultFace { order, sources, is_turned }| ResultPolygon {
            sources,
            is_turned,
            rings: self.rings.of(order[2]),
        })
    }

    /// Keeps the corners that `stays` accepts, rings with three corners, and polygons with an outline.
    pub(super) fn retain(&mut self, stays: impl Fn(&PolygonCorner) -> bool) -> Result<(), BooleanError> {
        let (old, mut ring) = (std::mem::take(&mut self.rings), Vec::new());
        for face in &mut self.faces {
            let rings = old.of(face.order[2]);
            goes_on(rings.corners.len())?;
            for corners in rings.iter() {
                ring.clear();
                ring.extend(corners.iter().copied().filter(&stays));
                if 3 <= ring.len() {
                    self.rings.add_ring(ring.iter().copied());
                } else if self.rings.open_rings() == 0 {
                    break;
                }
            }
            face.order[2] = if self.rings.open_rings() == 0 { NO_CORNER } else { self.rings.len() };
            if face.order[2] != NO_CORNER {
                self.rings.end();
            }
        }
        self.faces.retain(|face| face.order[2] != NO_CORNER);
        Ok(())
    }
}

/// Makes polygons of chosen sheets.
pub(super) struct PolygonMaker<'a, 'c> {
    pub(super) points: &'a PointSet,
    pub(super) edges: &'a EdgeTable,
    pub(super) facets: &'a [Facet<'a>],
    pub(super) sheets: &'a Sheets,
    pub(super) tags: &'a EdgeTags,
    pub(super) chosen: &'c ChosenSheets,
}

/// An edge of the outline of united sheets.
#[derive(Clone, Copy)]
struct NetEdge {
    ends: [u32; 2],
    /// The place among the edges of all sheets.
    place: u32,
    /// The first facet of the first sheet with the edge.
    source: u32,
    /// The number of times that sheets follow it from the first point to the second, less the number of times backwards.
    count: i32,
}

impl<'a, 'c> PolygonMaker<'a, 'c> {
    /// The polygons, in the order of their faces.
    pub(super) fn polygons(&self, budget: &mut Budget) -> Result<ResultPolygons<'c>, BooleanError> {
        let (mut made, sets) = (ResultPolygons::default(), self.sets());
        for set in sets.iter() {
            goes_on(set.iter().map(|one| self.sheet(*one).rings.corners.len()).sum())?;
            if self.add(set, &mut made, budget).is_none() {
                goes_on(0)?;
                set.iter().for_each(|one| _ = self.add(&[*one], &mut made, budget));
            }
        }
        sort_owned_by(&mut made.faces, |a, b| a.order.cmp(&b.order));
        Ok(made)
    }

    fn sheet(&self, chosen: u32) -> Sheet<'a> {
        self.sheets.at(self.chosen.at(chosen).sheet)
    }

    /// The first facet of a chosen sheet.
    fn facet(&self, chosen: u32) -> &'a Facet<'a> {
        &self.facets[self.chosen.at(chosen).sources[0] as usize]
    }

    /// True if the front of a chosen sheet is the front of its first source.
    fn is_as_source(&self, chosen: u32) -> bool {
        let front = self.facets[self.sheet(chosen).facet() as usize].normal;
        0.0 < front.dot(self.facet(chosen).normal)
    }

    fn is_turned(&self, chosen: u32) -> bool {
        self.chosen.at(chosen).is_reversed == self.is_as_source(chosen)
    }

    /// The chosen sheets of each polygon, in order: connected sheets, then all triangles of each bent face that is whole.
    fn sets(&self) -> Lists<u32> {
        let mut connected = self.connected();
        connected.flatten();
        let connected = Buckets::by(self.chosen.len() as usize, (0..self.chosen.len()).map(|one| connected.find(one)));
        let whole = self.whole_bent_faces();
        let (mut sets, mut bent): (_, BTreeMap<u32, Vec<u32>>) = (Lists::default(), BTreeMap::new());
        for set in (0..connected.len()).map(|first| connected.of(first)).filter(|set| !set.is_empty()) {
            let face = self.facet(set[0]).face;
            if whole.contains(&face) {
                bent.entry(face).or_default().extend(set);
            } else {
                sets.add(set.iter().copied());
            }
        }
        bent.into_values().for_each(|set| sets.add(set));
        sets
    }

    /// Unites chosen sheets with a common edge that no other chosen sheet has.
    fn connected(&self) -> DisjointSets {
        let mut number_of = vec![NO_CORNER; self.sheets.len() as usize];
        (0..).zip(self.chosen.iter()).for_each(|(number, one)| number_of[one.sheet as usize] = number);
        let mut sets = DisjointSets::new(self.chosen.len() as usize);
        for (_, uses) in self.sheets.fans() {
            let mut here = uses.iter().map(|used| number_of[used.sheet as usize]).filter(|number| *number != NO_CORNER);
            let (Some(a), Some(b), None) = (here.next(), here.next(), here.next()) else { continue };
            let have_equal_sources = self.chosen.at(a).sources == self.chosen.at(b).sources;
            if a != b && have_equal_sources && self.is_turned(a) == self.is_turned(b) {
                sets.unite(a, b);
            }
        }
        sets
    }

    /// The bent faces of which all triangles are in the result and nothing else is at the same place.
    fn whole_bent_faces(&self) -> BTreeSet<u32> {
        if !(0..self.chosen.len()).any(|one| self.facet(one).is_part) {
            return BTreeSet::new();
        }
        // For each face the number of its sheets, and of its chosen ones by direction.
        let mut counts: BTreeMap<u32, [usize; 3]> = BTreeMap::new();
        for sheet in self.sheets.iter() {
            let is_shared = 1 < sheet.sources.len();
            for source in sheet.sources {
                let facet = &self.facets[source.facet as usize];
                if facet.is_part {
                    counts.entry(facet.face).or_default()[0] += 1 + usize::from(is_shared);
                }
            }
        }
        for one in (0..self.chosen.len()).filter(|one| self.facet(*one).is_part) {
            counts.entry(self.facet(one).face).or_default()[1 + usize::from(self.is_turned(one))] += 1;
        }
        let is_whole = |[all, straight, turned]: &[usize; 3]| straight == all || turned == all;
        counts.into_iter().filter(|(_, counts)| is_whole(counts)).map(|(face, _)| face).collect()
    }

    /// The edges of united sheets in the direction of their first sources, in the order of their points. Edges that cancel are left
    /// out. `None` if the work is to end.
    fn net(&self, set: &[u32]) -> Option<Vec<NetEdge>> {
        let mut net: Vec<NetEdge> = Vec::new();
        for &one in set {
            let (source, is_as_source) = (self.chosen.at(one).sources[0], self.is_as_source(one));
            for [a, b] in self.sheet(one).rings.edges() {
                let count = if (a < b) == is_as_source { 1 } else { -1 };
                net.push(NetEdge { ends: in_order([a, b]), place: net.len() as u32, source, count });
            }
        }
        if !long_sort_by(&mut net, |a, b| a.ends.cmp(&b.ends).then(a.place.cmp(&b.place))) {
            return None;
        }
        net.dedup_by(|next, kept| {
            let is_same = next.ends == kept.ends;
            kept.count += if is_same { next.count } else { 0 };
            is_same
        });
        net.retain(|edge| edge.count != 0);
        Some(net)
    }

    /// Adds the polygon of united sheets, in the direction of the first source. Its rings start and follow each other as in its face.
    /// `None` if it is not a polygon with holes.
    fn add(&self, set: &[u32], made: &mut ResultPolygons<'c>, budget: &mut Budget) -> Option<()> {
        let (first, facet, net) = (set[0], self.facet(set[0]), self.net(set)?);
        let (mut cells, mut followed) = (Cells::default(), Polygons::default());
        let rings = if set.len() == 1 {
            self.sheet(first).rings
        } else if facet.is_part {
            follow(&net, &mut followed)?;
            followed.of(0)
        } else {
            let mut lines = GraphLines::default();
            for edge in &net {
                lines.push(NO_CORNER, edge.ends, [FacetWinding { facet: 0, winding: edge.count }]);
            }
            cells.add(&lines, &|point| facet.flat(self.points.at[point as usize]), budget).ok()?;
            if cells.len() != 1 || cells.windings.of(0)[0].winding != 1 {
                return None;
            }
            cells.rings.of(0)
        };
        let is_reversed = set.len() == 1 && !self.is_as_source(first);
        let rank = |corner: &PolygonCorner| {
            let start = facet.point_at(corner.along[0]).unwrap_or(corner.point);
            (corner.along[0], self.points.length([start, corner.point]), corner.point)
        };
        let earlier = |a: &PolygonCorner, b: &PolygonCorner| {
            let (a, b) = (rank(a), rank(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2))
        };
        let mut turned = Lists::default();
        for ring in rings.iter() {
            let at = |place: usize| ring[if is_reversed { ring.len() - 1 - place } else { place }];
            let corner = |place: usize| self.corner(&net, at(place), at((place + 1) % ring.len()));
            let corners = (0..ring.len()).map(corner).collect::<Option<Vec<PolygonCorner>>>()?;
            let start = (0..ring.len()).min_by(|&a, &b| earlier(&corners[a], &corners[b])).unwrap_or(0);
            turned.add(corners[start..].iter().chain(&corners[..start]).copied());
        }
        let mut holes: Vec<u32> = (1..turned.len()).collect();
        holes.small_sort_by(|a, b| earlier(&turned.of(*a)[0], &turned.of(*b)[0]));
        for ring in [0].into_iter().chain(holes) {
            made.rings.add_ring(turned.of(ring).iter().copied());
        }
        let order = [facet.face, turned.of(0)[0].along[0], made.rings.len()];
        let sources = self.chosen.at(first).sources;
        made.faces.push(ResultFace { order, sources, is_turned: self.is_turned(first) });
        made.rings.end();
        Some(())
    }

    /// The corner at a point, before another one.
    fn corner(&self, net: &[NetEdge], point: u32, next: u32) -> Option<PolygonCorner> {
        let ends = in_order([point, next]);
        let source = net[net.binary_search_by_key(&ends, |edge| edge.ends).ok()?].source;
        let edge = self.edges.find(ends)?;
        let owner = self.edges.owner(edge, source).filter(|owner| owner.corner != NO_CORNER);
        let along = owner.map_or([NO_CORNER; 2], |owner| self.facets[source as usize].edge_sources(owner.corner));
        Some(PolygonCorner { point, along, tags: self.tags.of(edge) })
    }
}

/// Adds the polygon of directed edges, if each point starts at most one edge. The loop with the lowest point comes first.
fn follow(net: &[NetEdge], made: &mut Polygons<u32>) -> Option<()> {
    let mut next: BTreeMap<u32, u32> = BTreeMap::new();
    for &NetEdge { ends: [a, b], count, .. } in net {
        let [from, to] = if 0 < count { [a, b] } else { [b, a] };
        if count.abs() != 1 || next.insert(from, to).is_some() {
            return None;
        }
    }
    while let Some((&first, _)) = next.first_key_value() {
        let (mut ring, mut at) = (Vec::new(), first);
        while let Some(to) = next.remove(&at) {
            ring.push(at);
            at = to;
        }
        if at != first || ring.len() < 3 {
            return None;
        }
        made.add_ring(ring);
    }
    let has_rings = made.open_rings() != 0;
    made.end();
    has_rings.then_some(())
}
