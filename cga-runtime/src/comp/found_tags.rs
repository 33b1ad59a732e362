//! The components with tags that a query matches, and those that inherit these tags (*comp operation*, isTagged).

use std::cell::OnceCell;

use cga_split::tags::matches;

use crate::geometry::each::Each;
use crate::geometry::mesh::{SubcomponentTags, TagSet};

/// The number of queries whose matches are kept: each arm of a comp has one for all components.
const KEPT: usize = 16;

/// The matches of the last queries in a mesh or a wire.
#[derive(Debug, Default)]
pub(super) struct TagQueries {
    list: Vec<FoundTags>,
}

/// The matches of a query in a mesh or a wire.
#[derive(Debug)]
pub(super) struct FoundTags {
    query: String,
    /// True for each set of tags of faces that has a match.
    faces: Vec<bool>,
    /// True for each set of tags of edges and vertices that has a match.
    subcomponents: Vec<bool>,
    /// True if a set of faces has a match, and if a set of edges and vertices has one.
    has: [bool; 2],
    /// True for each point whose vertex has a match, or an edge there.
    points: OnceCell<Vec<bool>>,
}

impl TagQueries {
    /// The matches of a query.
    pub(super) fn found(&mut self, query: &str, faces: &[TagSet], tags: &SubcomponentTags) -> &FoundTags {
        let known = self.list.iter().position(|found| found.query == query);
        let at = known.unwrap_or_else(|| {
            if self.list.len() == KEPT {
                self.list.remove(0);
            }
            let matches = |sets: &[TagSet]| {
                let has = |set: &TagSet| set.names().iter().any(|name| matches(query, name));
                sets.iter().map(has).collect::<Vec<bool>>()
            };
            let (faces, subcomponents) = (matches(faces), matches(tags.sets()));
            let has = [&faces, &subcomponents].each(|list| list.contains(&true));
            self.list.push(FoundTags { query: query.to_owned(), faces, subcomponents, has, points: OnceCell::new() });
            self.list.len() - 1
        });
        &self.list[at]
    }
}

impl FoundTags {
    /// Returns true if nothing matches.
    pub(super) fn is_empty(&self) -> bool {
        self.has == [false; 2]
    }

    /// Returns true if a set of tags of faces has a match.
    pub(super) fn face(&self, set: u32) -> bool {
        self.faces.get(set as usize) == Some(&true)
    }

    /// Returns true if an edge has a match of its own.
    pub(super) fn edge(&self, tags: &SubcomponentTags, ends: [u32; 2]) -> bool {
        tags.edge_set(ends).is_some_and(|set| self.subcomponents[set as usize])
    }

    /// Returns true if a vertex has a match of its own, or an edge at it. `points` is the number of points.
    pub(super) fn point(&self, tags: &SubcomponentTags, points: usize, point: u32) -> bool {
        self.has[1] && self.points(tags, points)[point as usize]
    }

    fn points(&self, tags: &SubcomponentTags, points: usize) -> &[bool] {
        self.points.get_or_init(|| {
            let mut found = vec![false; points];
            tags.vertex_sets().filter(|(_, set)| self.subcomponents[*set as usize]).for_each(|(point, _)| {
                found[point as usize] = true;
            });
            let edges = tags.edge_sets().filter(|(_, set)| self.subcomponents[*set as usize]);
            edges.flat_map(|(ends, _)| ends).for_each(|end| found[end as usize] = true);
            found
        })
    }
}
