//! Facets in one plane that overlap.
//!
//! They have one arrangement of lines: a line that divides one of them divides all facets that are there. If each had its own, the
//! work for `n` facets over each other would grow with the third power of `n`.

use super::budget::Budget;
use super::cell::{Cells, FacetWinding, GraphLines};
use super::edge_table::{ArrangedEdge, EdgeOwner, EdgeTable, NO_CORNER};
use super::facet::Facet;
use super::lists::Rings;
use super::meeting::dividing_edges;
use super::operation::BooleanError;
use super::point_set::PointSet;
use crate::disjoint::DisjointSets;
use crate::small_sort::SmallSort;

/// The groups of overlapping facets. While lines are divided, each group is a facet behind the facets proper, which has the lines
/// of all its members; members have the lines of their outlines alone.
pub(super) struct PlaneGroups {
    /// The number of facets proper.
    first: usize,
    members: Vec<Vec<u32>>,
    /// The group of each facet, as a number of a facet.
    group_of: Vec<Option<u32>>,
}

impl PlaneGroups {
    /// Groups facets, of which some pairs overlap, and adds the facets of the groups.
    pub(super) fn of(
        points: &PointSet,
        edges: &mut EdgeTable,
        facets: &mut Vec<Facet<'_>>,
        overlapping: &[[u32; 2]],
        budget: &mut Budget,
    ) -> Result<Self, BooleanError> {
        let first = facets.len();
        let mut groups = PlaneGroups { first, members: Vec::new(), group_of: vec![None; first] };
        let mut sets = DisjointSets::new(first);
        overlapping.iter().for_each(|[a, b]| sets.unite(*a, *b));
        for set in sets.sets().into_iter().filter(|set| 1 < set.len()) {
            groups.divide(points, facets, &set, budget)?;
        }
        for number in 0..groups.members.len() {
            groups.take_lines(points, edges, number, budget)?;
        }
        // Facets in nearly one plane are not always in one group.
        for &pair in overlapping.iter().filter(|pair| groups.group(pair[0]) != groups.group(pair[1])) {
            for [giver, taker] in [pair, [pair[1], pair[0]]] {
                for ends in dividing_edges(points, edges, facets, [giver, taker], budget)? {
                    let direction = points.at[ends[1] as usize] - points.at[ends[0] as usize];
                    let facet = groups.group(taker);
                    edges.add(ends, direction, EdgeOwner { facet, count: 0, corner: NO_CORNER });
                }
                budget.check(edges, points)?;
            }
        }
        Ok(groups)
    }

    /// The facet that has the lines of a facet: its group, or itself.
    fn group(&self, facet: u32) -> u32 {
        self.group_of[facet as usize].unwrap_or(facet)
    }

    /// Returns true for a facet whose lines its group has.
    pub(super) fn is_member(&self, facet: u32) -> bool {
        self.group_of.get(facet as usize).is_some_and(Option::is_some)
    }

    /// Divides connected facets into groups whose facets are all in the plane of the largest one.
    fn divide(
        &mut self,
        points: &PointSet,
        facets: &mut Vec<Facet<'_>>,
        set: &[u32],
        budget: &mut Budget,
    ) -> Result<(), BooleanError> {
        let area =
            |number: u32| (facets[number as usize].double_area(points, facets[number as usize].rings).abs(), number);
        let mut by_area: Vec<(f64, u32)> = set.iter().copied().map(area).collect();
        by_area.small_sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut set: Vec<u32> = by_area.into_iter().map(|(_, facet)| facet).collect();
        while 1 < set.len() {
            budget.spend(set.iter().map(|facet| facets[*facet as usize].rings.corners.len()).sum())?;
            let plane = &facets[set[0] as usize];
            let is_on = |point: &u32| plane.height(points.at[*point as usize]).abs() <= 2.0 * points.epsilon;
            let (mut members, others): (Vec<u32>, Vec<u32>) =
                set.iter().partition(|facet| facets[**facet as usize].rings.corners.iter().all(is_on));
            if 1 < members.len() {
                members.small_sort();
                let number = facets.len() as u32;
                members.iter().for_each(|facet| self.group_of[*facet as usize] = Some(number));
                facets.push(plane.without_outline());
                self.members.push(members);
            }
            set = others;
        }
        Ok(())
    }

    /// Moves the lines of members to a group. Members keep the lines of their outlines.
    fn take_lines(
        &self,
        points: &PointSet,
        edges: &mut EdgeTable,
        number: usize,
        budget: &Budget,
    ) -> Result<(), BooleanError> {
        let group = (self.first + number) as u32;
        for &member in &self.members[number] {
            for line in edges.lines(member).to_vec() {
                let ArrangedEdge { ends, direction, .. } = edges.list[line as usize];
                if edges.owner(line, member).is_none_or(|owner| owner.count == 0) {
                    edges.disown(line, member);
                }
                edges.add(ends, direction, EdgeOwner { facet: group, count: 0, corner: NO_CORNER });
            }
            edges.drop_foreign(member);
            budget.check(edges, points)?;
        }
        Ok(())
    }

    /// The cells of all groups, with the first facet of each as its front.
    pub(super) fn cells(
        &self,
        points: &PointSet,
        edges: &EdgeTable,
        facets: &[Facet<'_>],
        budget: &mut Budget,
    ) -> Result<Cells, BooleanError> {
        let mut cells = Cells::default();
        let (mut areas, mut lengths) = (vec![0.0; self.first], vec![0.0; self.first]);
        for (number, (plane, members)) in (self.first as u32..).zip(facets[self.first..].iter().zip(&self.members)) {
            let mut lines = GraphLines::default();
            for &line in edges.lines(number) {
                let own = edges.owners(line).iter().filter(|owner| owner.count != 0);
                let inside = own.filter(|owner| members.binary_search(&owner.facet).is_ok());
                let count = inside.map(|owner| FacetWinding { facet: owner.facet, winding: owner.count });
                lines.push(line, edges.list[line as usize].ends, count);
            }
            let first = cells.len();
            cells.add(&lines, &|point| plane.flat(points.at[point as usize]), budget)?;
            for cell in first..cells.len() {
                let rings = cells.rings.of(cell);
                let (area, length) = (plane.double_area(points, rings), rim_length(points, rings));
                let windings = cells.windings.of_mut(cell);
                for FacetWinding { facet, winding } in &*windings {
                    areas[*facet as usize] += f64::from(*winding) * area;
                    lengths[*facet as usize] += length;
                }
                if facets[windings[0].facet as usize].normal.dot(plane.normal) < 0.0 {
                    windings.iter_mut().for_each(|source| source.winding = -source.winding);
                    cells.rings.reverse(cell);
                }
            }
            for &member in members {
                let rings = facets[member as usize].rings;
                // Lines that were led through points move by up to epsilon. A lost cell is much larger.
                let most = 8.0 * points.epsilon * (lengths[member as usize] + rim_length(points, rings));
                if most < (areas[member as usize] - plane.double_area(points, rings)).abs() {
                    return Err(BooleanError::Tangled);
                }
            }
        }
        Ok(cells)
    }
}

fn rim_length(points: &PointSet, rings: Rings<'_, u32>) -> f64 {
    rings.edges().map(|ends| points.length(ends)).sum()
}
