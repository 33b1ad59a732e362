//! The components with tags that a query matches, and those that inherit these tags (*comp operation*, isTagged).

use crate::geometry::mesh::{SubcomponentTags, TagSet};

/// The matches of a query in a mesh or a wire.
#[derive(Debug, Default)]
pub(super) struct FoundTags {
    query: String,
    /// True for each set of tags of faces that has a match.
    faces: Vec<bool>,
    /// True for each set of tags of edges and vertices that has a match.
    subcomponents: Vec<bool>,
    /// True for each point whose vertex has a match, or an edge there. Empty if there are none.
    points: Vec<bool>,
}

impl FoundTags {
    /// Searches for a query, unless it was the last one. `points` is the number of points.
    pub(super) fn search(&mut self, query: &str, faces: &[TagSet], tags: &SubcomponentTags, points: usize) {
        let has_lists = self.faces.len() == faces.len() && self.subcomponents.len() == tags.sets().len();
        if self.query == query && has_lists {
            return;
        }
        let matches = |sets: &[TagSet]| sets.iter().map(|set| set.matches(query)).collect::<Vec<bool>>();
        *self = FoundTags {
            query: query.to_owned(),
            faces: matches(faces),
            subcomponents: matches(tags.sets()),
            points: Vec::new(),
        };
        if self.subcomponents.contains(&true) {
            let mut found = vec![false; points];
            tags.vertices().filter(|(_, set)| set.matches(query)).for_each(|(point, _)| found[point as usize] = true);
            let edges = tags.edges().filter(|(_, set)| set.matches(query));
            edges.flat_map(|(ends, _)| ends).for_each(|end| found[end as usize] = true);
            self.points = found;
        }
    }

    /// Returns true if nothing matches.
    pub(super) fn is_empty(&self) -> bool {
        !self.faces.contains(&true) && self.points.is_empty()
    }

    /// Returns true if a set of tags of faces has a match.
    pub(super) fn face(&self, set: u32) -> bool {
        self.faces.get(set as usize) == Some(&true)
    }

    /// Returns true if an edge has a match of its own.
    pub(super) fn edge(&self, tags: &SubcomponentTags, ends: [u32; 2]) -> bool {
        !self.points.is_empty() && tags.edge_set(ends).is_some_and(|set| self.subcomponents[set as usize])
    }

    /// Returns true if a vertex has a match of its own, or an edge at it.
    pub(super) fn point(&self, point: u32) -> bool {
        self.points.get(point as usize) == Some(&true)
    }
}
