//! The tags of edges and vertices (*Geometry tagging*, edge and vertex tag propagation).
//!
//! Vertices at old points have their tags. An edge has the tags of the old edge that it is, or is a part of. An edge from an old
//! vertex to the point that was moved from there, or to a new point, has the tags of the vertex. Operations may say otherwise.

use std::collections::BTreeMap;

use super::{EdgeOrigin, EdgeSource, PointOrigin};
use crate::geometry::mesh::{Mesh, SubcomponentTagger, SubcomponentTags, TagSet, whole_edge};
use crate::value::each::Each;
use crate::value::small_sort::SmallSort;

/// The origins of edges that operations have given.
#[derive(Default)]
pub(super) struct EdgeOrigins {
    list: Vec<([u32; 2], EdgeOrigin)>,
}

fn in_order([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

impl EdgeOrigins {
    pub(super) fn add(&mut self, ends: [u32; 2], origin: EdgeOrigin) {
        self.list.push((in_order(ends), origin));
    }

    /// Renumbers points: `before` are their old numbers. Edges that are no longer there are dropped.
    pub(super) fn renumber(&mut self, before: &[u32]) {
        let numbers: BTreeMap<u32, u32> = before.iter().copied().zip(0..).collect();
        self.list.retain_mut(|(ends, _)| match ends.each(|end| numbers.get(&end)) {
            [Some(a), Some(b)] => {
                *ends = in_order([*a, *b]);
                true
            }
            _ => false,
        });
    }

    /// The tags of the edges and vertices of a mesh whose points have origins in a source.
    pub(super) fn tags(mut self, source: &Mesh, made: &Mesh, origins: &[PointOrigin]) -> SubcomponentTags {
        let old = &source.subcomponent_tags;
        let mut tagger = SubcomponentTagger::default();
        if old.is_empty() && self.list.is_empty() {
            return tagger.finish();
        }
        self.list.small_sort_by_key(|entry| entry.0);
        // The sets of edges with a tag of the operation, by the number of the source's set.
        let mut renewed: BTreeMap<(Option<u32>, &'static str), TagSet> = BTreeMap::new();
        for ends in made.face_edges() {
            let from = self.list.partition_point(|entry| entry.0 < in_order(ends));
            let mut given = self.list[from..].iter().take_while(|entry| entry.0 == in_order(ends)).peekable();
            if given.peek().is_none()
                && let Some(set) = set_of(old, implied(ends.each(|end| origins[end as usize])))
            {
                tagger.edge(ends, &old.sets()[set as usize]);
            }
            for (_, EdgeOrigin { source, tag }) in given {
                let set = set_of(old, *source);
                if let Some(tag) = tag {
                    let plain = TagSet::default();
                    let own = || set.map_or(&plain, |set| &old.sets()[set as usize]);
                    tagger.edge(ends, renewed.entry((set, tag)).or_insert_with(|| own().renewed(tag)));
                } else if let Some(set) = set {
                    tagger.edge(ends, &old.sets()[set as usize]);
                }
            }
        }
        for (point, origin) in (0..).zip(origins) {
            if let Some(tags) = origin.old().and_then(|vertex| old.vertex(vertex)) {
                tagger.vertex(point, tags);
            }
        }
        tagger.finish()
    }
}

/// The number of the set of a component.
fn set_of(tags: &SubcomponentTags, source: EdgeSource) -> Option<u32> {
    match source {
        EdgeSource::Edge(ends) => tags.edge_set(ends),
        EdgeSource::Vertex(point) => tags.vertex_set(point),
        EdgeSource::New => None,
    }
}

/// The source of the edge between two points.
fn implied(ends: [PointOrigin; 2]) -> EdgeSource {
    match ends {
        [PointOrigin::Old(vertex), PointOrigin::New] | [PointOrigin::New, PointOrigin::Old(vertex)] => {
            EdgeSource::Vertex(vertex)
        }
        [PointOrigin::Old(vertex), PointOrigin::Moved(from)] | [PointOrigin::Moved(from), PointOrigin::Old(vertex)] => {
            if vertex == from {
                EdgeSource::Vertex(vertex)
            } else {
                EdgeSource::New
            }
        }
        _ => whole_edge(ends).map_or(EdgeSource::New, EdgeSource::Edge),
    }
}
