//! Faces in a plane that do not go to the side that their normals point away from.
//!
//! By that rule the two sides of a sheet, a closed piece without thickness, would be separated, and a cap in each slab
//! would have to duplicate both. The caps show this: if the rule separates faces that belong together, the edges of the
//! faces themselves have no partner on either side of the plane. So after a first pass
//!
//! - a sheet goes to the slab below as a whole. Its faces are found as two groups, one facing up and one facing down,
//!   with the same rim, all of whose edges lack partners;
//! - a face or a group changes sides if the caps would have to cover it a negative number of times: the side of a sheet
//!   that continues another face, or a face of a solid that is inside out among others that are not.
//!
//! Then the faces are cut again. Parts are closed with any result, because caps follow from the positions of faces.

use std::collections::BTreeMap;

use super::sheets::Flat;
use crate::cut::points::Location;
use crate::cut::state::CutState;
use crate::disjoint::DisjointSets;
use crate::each::Each;
use crate::mesh::Mesh;
use crate::nesting::Nest;
use crate::nesting::contour::Contour;
use crate::small_sort::{SmallSort, sort_owned_by};
use glam::DVec2;

/// Finds the faces that go to the other side, after all faces were cut by the rule. Returns whether there are any.
pub(crate) fn find(state: &mut CutState, mesh: &Mesh) -> bool {
    let mut flat = std::mem::take(&mut state.sheets.flat);
    flat.small_sort_by_key(|flat| flat.plane);
    let mut moved = Vec::new();
    // Without faces in planes there is nothing to do.
    if !flat.is_empty() && state.rim.sort(state.points.planes.len()) {
        let mut missing = Vec::new();
        for together in flat.chunk_by(|a, b| a.plane == b.plane) {
            let plane = together[0].plane as usize;
            state.rim.missing(plane, &mut missing);
            if !missing.is_empty() {
                let places = &state.points.places;
                let mut search = SheetSearch::new(mesh, places, together, &missing);
                search.match_all_sheets();
                let inverted = state.is_inverted(mesh);
                search.match_folds(&state.points.levels[plane].flat, inverted);
                moved.append(&mut search.moved);
            }
        }
    }
    moved.small_sort();
    state.sheets.moved = moved;
    !state.sheets.moved.is_empty()
}

/// An edge of a face in a plane, in the direction in which the cap below the plane would have it instead of the face.
#[derive(Clone, Copy)]
struct EdgeUse {
    edge: [u32; 2],
    flat: usize,
}

/// Connected faces, which share edges that do not lack a partner.
struct SheetGroup {
    is_above: bool,
    /// Numbers in the list of the plane, sorted.
    faces: Vec<usize>,
    /// The edges of its rim, sorted.
    rim: Vec<[u32; 2]>,
}

/// The number of rounds of grouping. Sheets that touch others become groups after the others are settled.
const ROUNDS: usize = 8;

/// The faces and the open edges of one plane.
struct SheetSearch<'f> {
    flat: &'f [Flat],
    /// The edges of the faces that are not settled.
    uses: Vec<EdgeUse>,
    groups: Vec<SheetGroup>,
    moved: Vec<u32>,
    /// The edges without partners, in the direction of the cap below, and the remaining number of each.
    missing: BTreeMap<[u32; 2], usize>,
}

impl<'f> SheetSearch<'f> {
    fn new(mesh: &Mesh, places: &[Location], flat: &'f [Flat], missing: &[[u32; 2]]) -> Self {
        let mut uses = Vec::new();
        for (number, flat) in flat.iter().enumerate() {
            for edge in mesh.face(flat.face as usize).edges() {
                let [a, b] = edge.each(|corner| places[mesh.corners[corner] as usize].number);
                uses.push(EdgeUse { edge: if flat.is_above { [a, b] } else { [b, a] }, flat: number });
            }
        }
        SheetSearch { flat, uses, groups: Vec::new(), moved: Vec::new(), missing: count(missing) }
    }

    fn left(&self, edge: [u32; 2]) -> usize {
        self.missing.get(&edge).copied().unwrap_or(0)
    }

    fn make_groups(&mut self) {
        let flat = self.flat;
        let ends = |edge: [u32; 2]| (edge[0].min(edge[1]), edge[0].max(edge[1]));
        let is_above = |item: &EdgeUse| flat[item.flat].is_above;
        let mut uses = self.uses.clone();
        uses.small_sort_by_key(|item| (ends(item.edge), is_above(item)));
        let mut leaders = DisjointSets::new(flat.len());
        for same in uses.chunk_by(|a, b| ends(a.edge) == ends(b.edge) && is_above(a) == is_above(b)) {
            let edge = same[0].edge;
            if self.left(edge) == 0 && self.left([edge[1], edge[0]]) == 0 {
                // One by one in the order of the mesh, so that coincident sheets stay separate.
                let [forward, backward] =
                    [true, false].each(|way| same.iter().filter(move |a| (a.edge == edge) == way));
                forward.zip(backward).for_each(|(a, b)| leaders.unite(a.flat as u32, b.flat as u32));
            }
        }
        leaders.flatten();
        let mut uses: Vec<(u32, EdgeUse)> =
            uses.into_iter().map(|item| (leaders.find(item.flat as u32), item)).collect();
        uses.small_sort_by_key(|&(leader, item)| (leader, ends(item.edge)));
        self.groups.clear();
        for group in uses.chunk_by(|a, b| a.0 == b.0) {
            let mut rim = Vec::new();
            for same in group.chunk_by(|a, b| ends(a.1.edge) == ends(b.1.edge)) {
                let edge = same[0].1.edge;
                let forward = same.iter().filter(|(_, item)| item.edge == edge).count();
                let backward = same.len() - forward;
                let net = if backward < forward { edge } else { [edge[1], edge[0]] };
                rim.extend(std::iter::repeat_n(net, forward.abs_diff(backward)));
            }
            rim.small_sort();
            if !rim.is_empty() && self.has(&rim) {
                let mut faces: Vec<usize> = group.iter().map(|(_, item)| item.flat).collect();
                faces.small_sort();
                faces.dedup();
                self.groups.push(SheetGroup { is_above: is_above(&group[0].1), faces, rim });
            }
        }
    }

    /// Returns true if all edges of a rim lack partners.
    fn has(&self, rim: &[[u32; 2]]) -> bool {
        rim.chunk_by(|a, b| a == b).all(|same| same.len() <= self.left(same[0]))
    }

    /// Removes the edges of a rim from the edges that lack partners. Returns `false`, without any change, if one of
    /// them has a partner.
    fn take(&mut self, rim: &[[u32; 2]]) -> bool {
        let has = self.has(rim);
        if has {
            for edge in rim {
                self.missing.entry(*edge).and_modify(|left| *left -= 1);
            }
        }
        has
    }

    /// Finds sheets, including sheets that touch each other.
    fn match_all_sheets(&mut self) {
        for _ in 0..ROUNDS {
            self.make_groups();
            let settled = self.match_sheets();
            if settled.is_empty() {
                return;
            }
            self.uses.retain(|item| settled.binary_search(&item.flat).is_err());
        }
    }

    /// Pairs groups with the same rim, one facing up and one facing down, and moves them below. Returns the settled
    /// faces, sorted.
    fn match_sheets(&mut self) -> Vec<usize> {
        let mut groups = std::mem::take(&mut self.groups);
        sort_owned_by(&mut groups, |a, b| a.rim.cmp(&b.rim).then(a.is_above.cmp(&b.is_above)));
        let mut settled = Vec::new();
        for same in groups.chunk_by(|a, b| a.rim == b.rim) {
            let (below, above) = same.split_at(same.partition_point(|group| !group.is_above));
            for (below, above) in below.iter().zip(above) {
                if !self.take(&above.rim) {
                    break;
                }
                self.change_sides(above);
                settled.extend(below.faces.iter().chain(&above.faces));
            }
        }
        self.groups = groups;
        settled.small_sort();
        settled
    }

    fn change_sides(&mut self, group: &SheetGroup) {
        self.moved.extend(group.faces.iter().map(|&number| self.flat[number].face));
    }

    /// Moves groups to the other side if they fill reversed loops that are inside no other loop.
    fn match_folds(&mut self, flat: &[DVec2], inverted: bool) {
        if self.groups.is_empty() {
            return;
        }
        let edges: Vec<[u32; 2]> =
            self.missing.iter().flat_map(|(&edge, &count)| std::iter::repeat_n(edge, count)).collect();
        let (mut contour, mut nest) = (Contour::default(), Nest::default());
        contour.follow(&edges, flat, |_| {});
        if contour.ends.is_empty() {
            return;
        }
        nest.sort_as(&contour.section(flat), inverted);
        let mut wrong: Vec<[u32; 2]> = Vec::new();
        for range in nest.lone_holes() {
            let ring = &contour.corners[range.clone()];
            wrong.extend(ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]));
        }
        self.missing = count(&wrong);
        // A group that is also part of a sheet goes below.
        let mut groups = std::mem::take(&mut self.groups);
        let key = |group: &SheetGroup| (!group.is_above, group.faces[0]);
        sort_owned_by(&mut groups, |a, b| key(a).cmp(&key(b)));
        for group in groups {
            if self.take(&group.rim) {
                self.change_sides(&group);
            }
        }
    }
}

/// The number of times that each edge occurs.
fn count(edges: &[[u32; 2]]) -> BTreeMap<[u32; 2], usize> {
    let mut counts = BTreeMap::new();
    edges.iter().for_each(|&edge| *counts.entry(edge).or_default() += 1);
    counts
}
