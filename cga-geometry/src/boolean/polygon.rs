//! The polygons of a result: connected sheets of one face, without the edges between them.

use std::collections::BTreeMap;

use super::budget::Budget;
use super::cell::{self, GraphLine};
use super::component_tags::EdgeTags;
use super::edge_table::{EdgeTable, NO_CORNER};
use super::facet::Facet;
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::progress::goes_on;
use super::selection::ChosenSheet;
use super::sheet::Sheets;
use crate::disjoint::DisjointSets;
use crate::each::Each;

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
pub(super) struct ResultPolygon {
    /// The facets of which it is a part.
    pub(super) sources: Vec<u32>,
    /// True if the face of the result faces the other way.
    pub(super) is_turned: bool,
    /// The outline and the holes.
    pub(super) rings: Vec<Vec<PolygonCorner>>,
}

/// Makes polygons of chosen sheets.
pub(super) struct PolygonMaker<'a> {
    pub(super) points: &'a PointSet,
    pub(super) edges: &'a EdgeTable,
    pub(super) facets: &'a [Facet],
    pub(super) sheets: &'a Sheets,
    pub(super) tags: &'a EdgeTags,
}

impl PolygonMaker<'_> {
    /// The polygons, in the order of their faces.
    pub(super) fn polygons(
        &self,
        chosen: &[ChosenSheet],
        budget: &mut Budget,
    ) -> Result<Vec<ResultPolygon>, BooleanError> {
        let mut sets = self.connected(chosen, |a, b| a.sources == b.sources).sets();
        self.unite_bent_faces(chosen, &mut sets);
        let mut made: Vec<(u32, ResultPolygon)> = Vec::new();
        for set in sets {
            let all: Vec<&ChosenSheet> = set.iter().map(|number| &chosen[*number as usize]).collect();
            goes_on(all.iter().map(|one| self.sheets.list[one.sheet as usize].rim().count()).sum())?;
            match self.rings(&all, budget) {
                Some(rings) => made.push(self.polygon(all[0], rings)),
                None => {
                    let alone = all.iter().filter_map(|one| Some(self.polygon(one, self.rings(&[one], budget)?)));
                    made.extend(alone);
                }
            }
        }
        made.sort_by_key(|(rank, polygon)| (self.facets[polygon.sources[0] as usize].face, *rank));
        Ok(made.into_iter().map(|(_, polygon)| polygon).collect())
    }

    /// True if the front of a chosen sheet is the front of its first source.
    fn is_as_source(&self, chosen: &ChosenSheet) -> bool {
        let sheet = &self.sheets.list[chosen.sheet as usize];
        let normal = |facet: u32| self.facets[facet as usize].normal;
        0.0 < normal(sheet.facet()).dot(normal(chosen.sources[0]))
    }

    fn is_turned(&self, chosen: &ChosenSheet) -> bool {
        chosen.is_reversed == self.is_as_source(chosen)
    }

    /// Unites chosen sheets with a common edge that no other chosen sheet has.
    fn connected(
        &self,
        chosen: &[ChosenSheet],
        are_alike: impl Fn(&ChosenSheet, &ChosenSheet) -> bool,
    ) -> DisjointSets {
        let mut number_of = vec![NO_CORNER; self.sheets.list.len()];
        (0..).zip(chosen).for_each(|(number, one)| number_of[one.sheet as usize] = number);
        let mut sets = DisjointSets::new(chosen.len());
        for (_, uses) in self.sheets.fans() {
            let mut here = uses.iter().map(|used| number_of[used.sheet as usize]).filter(|number| *number != NO_CORNER);
            let (Some(a), Some(b), None) = (here.next(), here.next(), here.next()) else { continue };
            let [first, second] = [a, b].each(|number| &chosen[number as usize]);
            if a != b && are_alike(first, second) && self.is_turned(first) == self.is_turned(second) {
                sets.unite(a, b);
            }
        }
        sets
    }

    /// Unites the triangles of a bent face if all of it is in the result and nothing else is at the same place.
    fn unite_bent_faces(&self, chosen: &[ChosenSheet], sets: &mut Vec<Vec<u32>>) {
        let face_of = |one: &ChosenSheet| self.facets[one.sources[0] as usize].face;
        let is_part = |one: &ChosenSheet| self.facets[one.sources[0] as usize].is_part;
        if !chosen.iter().any(is_part) {
            return;
        }
        // For each face the number of its sheets, and of its chosen ones by direction.
        let mut counts: BTreeMap<u32, [usize; 3]> = BTreeMap::new();
        for sheet in &self.sheets.list {
            let is_shared = 1 < sheet.sources.len();
            for source in &sheet.sources {
                counts.entry(self.facets[source.facet as usize].face).or_default()[0] += 1 + usize::from(is_shared);
            }
        }
        for one in chosen {
            counts.entry(face_of(one)).or_default()[1 + usize::from(self.is_turned(one))] += 1;
        }
        let is_whole = |one: &ChosenSheet| {
            let [all, straight, turned] = counts[&face_of(one)];
            is_part(one) && (straight == all || turned == all)
        };
        let mut bent: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        sets.retain(|set| {
            let one = &chosen[set[0] as usize];
            if is_whole(one) {
                bent.entry(face_of(one)).or_default().extend(set);
            }
            !is_whole(one)
        });
        sets.extend(bent.into_values());
    }

    /// The outline of united sheets, in the direction of the first source. `None` if it is not a polygon with holes.
    fn rings(&self, all: &[&ChosenSheet], budget: &mut Budget) -> Option<Vec<Vec<PolygonCorner>>> {
        let mut net: BTreeMap<[u32; 2], (i32, u32)> = BTreeMap::new();
        for one in all {
            let is_as_source = self.is_as_source(one);
            for [a, b] in self.sheets.list[one.sheet as usize].rim() {
                let [a, b] = if is_as_source { [a, b] } else { [b, a] };
                let entry = net.entry([a.min(b), a.max(b)]).or_insert((0, one.sources[0]));
                entry.0 += if a < b { 1 } else { -1 };
            }
        }
        net.retain(|_, (count, _)| *count != 0);
        let facet = &self.facets[all[0].sources[0] as usize];
        let rings = if all.len() == 1 {
            let mut rings = self.sheets.list[all[0].sheet as usize].rings.clone();
            if !self.is_as_source(all[0]) {
                rings.iter_mut().for_each(|ring| ring.reverse());
            }
            rings
        } else if facet.is_part {
            follow(&net)?
        } else {
            let lines: Vec<GraphLine<i32>> =
                net.iter().map(|(ends, (count, _))| GraphLine { ends: *ends, count: *count }).collect();
            let flat = |point: u32| facet.flat(self.points.at[point as usize]);
            let mut cells = cell::cells(&lines, &flat, budget).ok()?;
            let cell = cells.pop().filter(|cell| cell.winding == 1 && cells.is_empty())?;
            cell.rings
        };
        let corner = |point: u32, next: u32| {
            let ends = [point.min(next), point.max(next)];
            let edge = self.edges.find(ends)?;
            let owner = self.facets.get(net.get(&ends)?.1 as usize).zip(self.edges.owner(edge, net[&ends].1));
            let along = owner
                .filter(|(_, owner)| owner.corner != NO_CORNER)
                .map(|(facet, owner)| facet.edge_sources(owner.corner));
            Some(PolygonCorner { point, along: along.unwrap_or([NO_CORNER; 2]), tags: self.tags.of(edge) })
        };
        rings
            .iter()
            .map(|ring| {
                ring.iter().zip(ring.iter().cycle().skip(1)).map(|(point, next)| corner(*point, *next)).collect()
            })
            .collect()
    }

    /// The polygon, whose loops start and follow each other as in its face, and a number for its place in the face.
    fn polygon(&self, one: &ChosenSheet, mut rings: Vec<Vec<PolygonCorner>>) -> (u32, ResultPolygon) {
        let facet = &self.facets[one.sources[0] as usize];
        let rank = |corner: &PolygonCorner| {
            let start = facet.point_at(corner.along[0]).unwrap_or(corner.point);
            (corner.along[0], self.points.length([start, corner.point]), corner.point)
        };
        let earlier = |a: &PolygonCorner, b: &PolygonCorner| {
            let (a, b) = (rank(a), rank(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2))
        };
        for ring in &mut rings {
            let first = (0..ring.len()).min_by(|&a, &b| earlier(&ring[a], &ring[b])).unwrap_or(0);
            ring.rotate_left(first);
        }
        rings[1..].sort_by(|a, b| earlier(&a[0], &b[0]));
        let rank = rings[0][0].along[0];
        (rank, ResultPolygon { sources: one.sources.clone(), is_turned: self.is_turned(one), rings })
    }
}

/// Loops of directed edges, if each point starts at most one edge. The loop with the lowest point comes first.
fn follow(net: &BTreeMap<[u32; 2], (i32, u32)>) -> Option<Vec<Vec<u32>>> {
    let mut next: BTreeMap<u32, u32> = BTreeMap::new();
    for (&[a, b], (count, _)) in net {
        let [from, to] = if 0 < *count { [a, b] } else { [b, a] };
        if count.abs() != 1 || next.insert(from, to).is_some() {
            return None;
        }
    }
    let mut rings = Vec::new();
    while let Some((&first, _)) = next.first_key_value() {
        let (mut ring, mut at) = (Vec::new(), first);
        while let Some(to) = next.remove(&at) {
            ring.push(at);
            at = to;
        }
        if at != first || ring.len() < 3 {
            return None;
        }
        rings.push(ring);
    }
    (!rings.is_empty()).then_some(rings)
}
