//! Facets in one plane that overlap.
//!
//! They have one arrangement of lines: a line that divides one of them divides all facets that are there. If each had its own, the
//! work for `n` facets over each other would grow with the third power of `n`.

use super::budget::Budget;
use super::cell::{self, Cell, GraphLine, double_area};
use super::edge_table::{EdgeOwner, EdgeTable, NO_CORNER};
use super::facet::Facet;
use super::meeting::dividing_edges;
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::sheet::SheetSource;
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
        facets: &mut Vec<Facet>,
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
            groups.take_lines(points, edges, facets, number, budget)?;
        }
        // Facets in nearly one plane are not always in one group.
        for &pair in overlapping.iter().filter(|pair| groups.group(pair[0]) != groups.group(pair[1])) {
            for [giver, taker] in [pair, [pair[1], pair[0]]] {
                for ends in dividing_edges(points, edges, facets, [giver, taker], budget)? {
                    let direction = points.at[ends[1] as usize] - points.at[ends[0] as usize];
                    let facet = groups.group(taker);
                    edges.add(facets, ends, direction, EdgeOwner { facet, count: 0, corner: NO_CORNER });
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
        facets: &mut Vec<Facet>,
        set: &[u32],
        budget: &mut Budget,
    ) -> Result<(), BooleanError> {
        let area = |number: u32| (facets[number as usize].double_area(points).abs(), number);
        let mut by_area: Vec<(f64, u32)> = set.iter().copied().map(area).collect();
        by_area.small_sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut set: Vec<u32> = by_area.into_iter().map(|(_, facet)| facet).collect();
        while 1 < set.len() {
            budget.spend(set.iter().map(|facet| facets[*facet as usize].corners.len()).sum())?;
            let plane = &facets[set[0] as usize];
            let is_on = |point: &u32| plane.height(points.at[*point as usize]).abs() <= 2.0 * points.epsilon;
            let (mut members, others): (Vec<u32>, Vec<u32>) =
                set.iter().partition(|facet| facets[**facet as usize].corners.iter().all(is_on));
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
        facets: &mut [Facet],
        number: usize,
        budget: &Budget,
    ) -> Result<(), BooleanError> {
        let group = (self.first + number) as u32;
        for &member in &self.members[number] {
            for line in std::mem::take(&mut facets[member as usize].lines) {
                let edge = &edges.list[line as usize];
                let (ends, direction) = (edge.ends, edge.direction);
                if edges.owner(line, member).is_some_and(|owner| owner.count != 0) {
                    facets[member as usize].lines.push(line);
                } else {
                    edges.disown(line, member);
                }
                edges.add(facets, ends, direction, EdgeOwner { facet: group, count: 0, corner: NO_CORNER });
            }
            budget.check(edges, points)?;
        }
        Ok(())
    }

    /// The cells of all groups, with the first facet of each as its front.
    pub(super) fn cells(
        &self,
        points: &PointSet,
        edges: &EdgeTable,
        facets: &[Facet],
        budget: &mut Budget,
    ) -> Result<Vec<Cell<Vec<SheetSource>>>, BooleanError> {
        let mut all = Vec::new();
        let (mut areas, mut lengths) = (vec![0.0; self.first], vec![0.0; self.first]);
        for (plane, members) in facets[self.first..].iter().zip(&self.members) {
            let line = |line: &u32| {
                let edge = &edges.list[*line as usize];
                let own = edge.owners.iter().filter(|owner| owner.count != 0);
                let inside = own.filter(|owner| members.binary_search(&owner.facet).is_ok());
                let count = inside.map(|owner| SheetSource { facet: owner.facet, winding: owner.count }).collect();
                GraphLine { ends: edge.ends, count }
            };
            let lines: Vec<GraphLine<Vec<SheetSource>>> = plane.lines.iter().map(line).collect();
            let mut cells = cell::cells(&lines, &|point| plane.flat(points.at[point as usize]), budget)?;
            for cell in &mut cells {
                cell.inner.iter_mut().for_each(|line| *line = plane.lines[*line as usize]);
                let area = double_area(points, plane, &cell.rings);
                let length = rim_length(points, &cell.rings);
                for source in &cell.winding {
                    areas[source.facet as usize] += f64::from(source.winding) * area;
                    lengths[source.facet as usize] += length;
                }
                let front = facets[cell.winding[0].facet as usize].normal;
                if front.dot(plane.normal) < 0.0 {
                    cell.rings.iter_mut().for_each(|ring| ring.reverse());
                    cell.winding.iter_mut().for_each(|source| source.winding = -source.winding);
                }
            }
            for &member in members {
                let facet = &facets[member as usize];
                let rings: Vec<Vec<u32>> = facet.loops().map(|ring| facet.corners[ring].to_vec()).collect();
                // Lines that were led through points move by up to epsilon. A lost cell is much larger.
                let most = 8.0 * points.epsilon * (lengths[member as usize] + rim_length(points, &rings));
                if most < (areas[member as usize] - double_area(points, plane, &rings)).abs() {
                    return Err(BooleanError::Tangled);
                }
            }
            all.append(&mut cells);
        }
        Ok(all)
    }
}

fn rim_length(points: &PointSet, rings: &[Vec<u32>]) -> f64 {
    let length = |ring: &Vec<u32>| -> f64 {
        ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| points.length([*a, *b])).sum()
    };
    rings.iter().map(length).sum()
}
