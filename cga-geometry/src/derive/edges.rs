//! The tags of edges and vertices.
//!
//! Vertices at old points have their tags. An edge has the tags of the old edge that it is, or is a part of. An edge from an old
//! vertex to the point that was moved from there, or to a point that grew out of the face, has the tags of the vertex. Operations
//! may say otherwise.

use std::collections::BTreeMap;

use super::{EdgeOrigin, EdgeSource, PointOrigin};
use crate::each::Each;
use crate::long_sort::long_sort_by;
use crate::mesh::{Mesh, SubcomponentTags, SubcomponentTagsBuilder, TagSet, TagSetTable, in_order, whole_edge};
use crate::trace::UNTRACED;
use crate::work;

/// The units of work of an edge whose tags are found.
const EDGE: usize = 16;

/// The origins of edges that operations have given, and the tags that they have added.
#[derive(Default)]
pub(super) struct EdgeOrigins {
    edges: Vec<([u32; 2], EdgeOrigin)>,
    vertices: Vec<(u32, u32)>,
    /// The sets of [`EdgeSource::Own`] and of vertices.
    own: TagSetTable,
}

impl EdgeOrigins {
    /// Gives the origin of an edge. Several ones give it the tags of all.
    pub(super) fn add(&mut self, ends: [u32; 2], origin: EdgeOrigin) {
        self.edges.push((in_order(ends), origin));
    }

    pub(super) fn tag_edge(&mut self, ends: [u32; 2], tags: &TagSet) {
        let source = EdgeSource::Own(self.own.number(tags));
        self.add(ends, EdgeOrigin { source, tag: None });
    }

    pub(super) fn tag_vertex(&mut self, point: u32, tags: &TagSet) {
        self.vertices.push((point, self.own.number(tags)));
    }

    /// Renumbers points: `before` are their old numbers. Edges and vertices without a new number are dropped.
    pub(super) fn renumber(&mut self, before: &[u32]) {
        if self.edges.is_empty() && self.vertices.is_empty() {
            return;
        }
        let mut numbers = vec![UNTRACED; before.iter().max().map_or(0, |most| *most as usize + 1)];
        before.iter().zip(0..).for_each(|(old, new)| numbers[*old as usize] = new);
        let number = |old: u32| numbers.get(old as usize).copied().filter(|new| *new != UNTRACED);
        self.edges.retain_mut(|(ends, _)| match ends.each(number) {
            [Some(a), Some(b)] => {
                *ends = in_order([a, b]);
                true
            }
            _ => false,
        });
        self.vertices.retain_mut(|(point, _)| number(*point).map(|number| *point = number).is_some());
    }

    /// The tags of the edges and vertices of a mesh whose points have origins in a source.
    pub(super) fn tags(mut self, source: &Mesh, made: &Mesh, origins: &[PointOrigin]) -> SubcomponentTags {
        let old = &source.subcomponent_tags;
        if old.is_empty() && self.edges.is_empty() && self.vertices.is_empty() {
            return SubcomponentTags::default();
        }
        let mut tags = SubcomponentTagsBuilder::default();
        // Origins of one edge stay in their order.
        let mut order: Vec<([u32; 2], u32)> = self.edges.iter().map(|entry| entry.0).zip(0..).collect();
        if !long_sort_by(&mut order, Ord::cmp) {
            return SubcomponentTags::default();
        }
        let (own, plain) = (std::mem::take(&mut self.own).into_sets(), TagSet::default());
        let set_of = |source: EdgeSource| match source {
            EdgeSource::Edge(ends) => old.edge(ends),
            EdgeSource::Vertex(point) => old.vertex(point),
            EdgeSource::Own(number) => own.get(number as usize),
            EdgeSource::New => None,
        };
        // The sets of edges with a tag of the operation.
        let mut renewed: BTreeMap<(&TagSet, &'static str), TagSet> = BTreeMap::new();
        for ends in made.face_edges() {
            if !work::spend(EDGE) {
                return SubcomponentTags::default();
            }
            let from = order.partition_point(|entry| entry.0 < in_order(ends));
            let given = order[from..].iter().take_while(|entry| entry.0 == in_order(ends));
            let given = given.map(|entry| &self.edges[entry.1 as usize].1);
            let is_given = given.clone().any(|origin| !matches!(origin.source, EdgeSource::Own(_)));
            if !is_given
                && !old.is_empty()
                && let Some(set) = set_of(implied(ends.each(|end| origins[end as usize])))
            {
                tags.edge(ends, set);
            }
            for EdgeOrigin { source, tag } in given {
                let set = set_of(*source).unwrap_or(&plain);
                match tag {
                    Some(tag) => tags.edge(ends, renewed.entry((set, tag)).or_insert_with(|| set.renewed(tag))),
                    None => tags.edge(ends, set),
                }
            }
        }
        for (point, origin) in (0..).zip(origins) {
            if !work::spend(EDGE) {
                return SubcomponentTags::default();
            }
            if let Some(set) = origin.old().and_then(|vertex| old.vertex(vertex)) {
                tags.vertex(point, set);
            }
        }
        self.vertices.iter().for_each(|(point, set)| tags.vertex(*point, &own[*set as usize]));
        tags.finish()
    }
}

/// The source of the edge between two points.
fn implied(ends: [PointOrigin; 2]) -> EdgeSource {
    match ends {
        [PointOrigin::Old(vertex), PointOrigin::Grown] | [PointOrigin::Grown, PointOrigin::Old(vertex)] => {
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
