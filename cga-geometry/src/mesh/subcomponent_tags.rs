//! The tags of edges and vertices.
//!
//! An edge is a pair of points, so all faces at an edge agree about its tags. Edges and vertices without tags are not
//! listed, and a mesh without tagged edges and vertices has no lists at all.

use std::sync::Arc;

use super::tag::{TagSet, TagSetTable, TaggedComponents};
use crate::each::Each;
use crate::long_sort::long_sort_by;
use crate::origin::PointOrigin;
use crate::trace::UNTRACED;
use crate::work;

/// The units of work of an edge whose tags are found.
const FINDING: usize = 8;

/// The tags of the edges and vertices of a mesh or a wire, by the numbers of its points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SubcomponentTags(Option<Arc<TagLists>>);

#[derive(Debug, PartialEq)]
struct TagLists {
    sets: Arc<[TagSet]>,
    /// The tagged edges, sorted: both ends, the smaller number first, and the number of the set.
    edges: Vec<([u32; 2], u32)>,
    /// The tagged vertices, sorted: the point, and the number of the set.
    vertices: Vec<(u32, u32)>,
}

/// The ends of an edge, the smaller number first.
pub(crate) fn in_order([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

impl SubcomponentTags {
    fn of(sets: Arc<[TagSet]>, edges: Vec<([u32; 2], u32)>, vertices: Vec<(u32, u32)>) -> Self {
        let is_empty = edges.is_empty() && vertices.is_empty();
        SubcomponentTags((!is_empty).then(|| Arc::new(TagLists { sets, edges, vertices })))
    }

    /// Returns true if no edge and no vertex has a tag.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// The sets of tags. Some may be unused.
    pub fn sets(&self) -> &[TagSet] {
        self.0.as_ref().map_or(&[], |lists| &lists.sets)
    }

    /// The number of an edge's set.
    pub fn edge_set(&self, ends: [u32; 2]) -> Option<u32> {
        let edges = &self.0.as_ref()?.edges;
        let at = edges.binary_search_by_key(&in_order(ends), |edge| edge.0).ok()?;
        Some(edges[at].1)
    }

    /// The number of a vertex's set.
    pub(crate) fn vertex_set(&self, point: u32) -> Option<u32> {
        let vertices = &self.0.as_ref()?.vertices;
        let at = vertices.binary_search_by_key(&point, |vertex| vertex.0).ok()?;
        Some(vertices[at].1)
    }

    /// The tags of an edge.
    pub fn edge(&self, ends: [u32; 2]) -> Option<&TagSet> {
        self.edge_set(ends).map(|set| &self.sets()[set as usize])
    }

    /// The tags of a vertex.
    pub fn vertex(&self, point: u32) -> Option<&TagSet> {
        self.vertex_set(point).map(|set| &self.sets()[set as usize])
    }

    /// The tagged edges with the numbers of their sets, in the order of their points.
    pub fn edge_sets(&self) -> impl ExactSizeIterator<Item = ([u32; 2], u32)> + Clone {
        self.0.as_ref().map_or(&[][..], |lists| &lists.edges).iter().copied()
    }

    /// The tagged vertices with the numbers of their sets, in the order of their points.
    pub fn vertex_sets(&self) -> impl ExactSizeIterator<Item = (u32, u32)> + Clone {
        self.0.as_ref().map_or(&[][..], |lists| &lists.vertices).iter().copied()
    }

    /// The tagged edges, in the order of their points.
    pub(crate) fn edges(&self) -> impl ExactSizeIterator<Item = ([u32; 2], &TagSet)> + Clone {
        self.edge_sets().map(|(ends, set)| (ends, &self.sets()[set as usize]))
    }

    /// The tagged vertices, in the order of their points.
    pub(crate) fn vertices(&self) -> impl ExactSizeIterator<Item = (u32, &TagSet)> + Clone {
        self.vertex_sets().map(|(point, set)| (point, &self.sets()[set as usize]))
    }

    /// The tags of a part whose points have origins in the mesh with these tags. The part has the given edges, each at
    /// least once, and `points` points. Parts of an edge have the tags of the edge. Other new edges and new vertices
    /// have none. Some are missing if the work is to end.
    pub(crate) fn carried(
        &self,
        edges: &mut dyn Iterator<Item = [u32; 2]>,
        points: usize,
        origin: &dyn Fn(u32) -> PointOrigin,
    ) -> Self {
        let Some(lists) = &self.0 else { return SubcomponentTags::default() };
        let set_of = |ends: [u32; 2]| Some((in_order(ends), self.edge_set(whole_edge(ends.each(origin))?)?));
        let of_edge = |ends: [u32; 2]| if work::spend(FINDING) { set_of(ends) } else { None };
        let mut found: Vec<_> = if lists.edges.is_empty() { Vec::new() } else { edges.filter_map(of_edge).collect() };
        if !long_sort_by(&mut found, Ord::cmp) {
            return SubcomponentTags::default();
        }
        found.dedup();
        let of_vertex = |point: u32| Some((point, self.vertex_set(origin(point).old()?)?));
        let points = if lists.vertices.is_empty() { 0 } else { points as u32 };
        SubcomponentTags::of(lists.sets.clone(), found, (0..points).filter_map(of_vertex).collect())
    }

    /// These tags, and one more on each of the edges. No tags if the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile.
    pub fn with_edges(&self, edges: impl Iterator<Item = [u32; 2]>, name: &str) -> Self {
        let mut tagger = SubcomponentTagsBuilder::default();
        tagger.append(self, &|point| point);
        let mut edges: Vec<[u32; 2]> = edges.map(in_order).collect();
        if !long_sort_by(&mut edges, Ord::cmp) {
            return SubcomponentTags::default();
        }
        edges.dedup();
        let own = TagSet::new([name]);
        edges.into_iter().take_while(|_| work::spend(FINDING)).for_each(|edge| tagger.edge(edge, &own));
        tagger.finish()
    }

    /// These tags, and one more on each of the first `points` vertices. No tags if the work of a
    /// [`Supervisor`](crate::work::Supervisor) ends meanwhile.
    pub fn with_vertices(&self, points: usize, name: &str) -> Self {
        let mut tagger = SubcomponentTagsBuilder::default();
        tagger.append(self, &|point| point);
        let own = TagSet::new([name]);
        (0..points as u32).take_while(|_| work::spend(FINDING)).for_each(|point| tagger.vertex(point, &own));
        tagger.finish()
    }

    /// These tags without some tags of some components.
    pub fn without(&self, goes: &dyn Fn(&str) -> bool, components: TaggedComponents) -> Self {
        let kept: Vec<TagSet> = self.sets().iter().map(|set| set.without(goes)).collect();
        let mut tagger = SubcomponentTagsBuilder::default();
        let Some(lists) = &self.0 else { return SubcomponentTags::default() };
        let list = |is_meant: bool| if is_meant { &kept[..] } else { &lists.sets };
        let (of_edges, of_vertices) = (list(components.edges()), list(components.vertices()));
        lists.edges.iter().for_each(|(ends, set)| tagger.edge(*ends, &of_edges[*set as usize]));
        lists.vertices.iter().for_each(|(point, set)| tagger.vertex(*point, &of_vertices[*set as usize]));
        tagger.finish()
    }

    /// The tags of some components, in any order; some more than once.
    pub fn names(&self, components: TaggedComponents) -> impl Iterator<Item = &Arc<str>> {
        let mut used = vec![false; self.sets().len()];
        if let Some(lists) = &self.0 {
            let edges = lists.edges.iter().filter(|_| components.edges()).map(|edge| edge.1);
            let vertices = lists.vertices.iter().filter(|_| components.vertices()).map(|vertex| vertex.1);
            edges.chain(vertices).for_each(|set| used[set as usize] = true);
        }
        self.sets().iter().zip(used).filter(|(_, used)| *used).flat_map(|(set, _)| set.names())
    }

    /// Returns true if the lists are sorted, if all numbers exist, and if no listed set is empty.
    pub(super) fn hold(&self, points: usize) -> bool {
        let Some(lists) = &self.0 else { return true };
        let has_tags = |set: u32| lists.sets.get(set as usize).is_some_and(|set| !set.names().is_empty());
        lists.edges.windows(2).all(|pair| pair[0].0 < pair[1].0)
            && lists.vertices.windows(2).all(|pair| pair[0].0 < pair[1].0)
            && lists.edges.iter().all(|&([a, b], set)| a < b && (b as usize) < points && has_tags(set))
            && lists.vertices.iter().all(|&(point, set)| (point as usize) < points && has_tags(set))
            && !(lists.edges.is_empty() && lists.vertices.is_empty())
    }
}

/// The edge of the whole on which an edge of a part is.
pub(crate) fn whole_edge(ends: [PointOrigin; 2]) -> Option<[u32; 2]> {
    let (mut found, mut count) = ([UNTRACED; 2], 0);
    for end in ends.into_iter().flat_map(PointOrigin::ends) {
        if found[..count].contains(&end) {
            continue;
        }
        if count == 2 || end == UNTRACED {
            return None;
        }
        found[count] = end;
        count += 1;
    }
    (count == 2).then_some(found)
}

/// Collects tags of edges and vertices, in any order. Those that get tags several times have all of them.
#[derive(Clone, Debug, Default)]
pub struct SubcomponentTagsBuilder {
    sets: TagSetTable,
    edges: Vec<([u32; 2], u32)>,
    vertices: Vec<(u32, u32)>,
}

impl SubcomponentTagsBuilder {
    /// Returns true if nothing has a tag.
    pub(crate) fn is_empty(&self) -> bool {
        self.edges.is_empty() && self.vertices.is_empty()
    }

    /// Adds tags to an edge.
    pub fn edge(&mut self, ends: [u32; 2], tags: &TagSet) {
        if !tags.names().is_empty() {
            self.edges.push((in_order(ends), self.sets.number(tags)));
        }
    }

    /// Adds tags to a vertex.
    pub(crate) fn vertex(&mut self, point: u32, tags: &TagSet) {
        if !tags.names().is_empty() {
            self.vertices.push((point, self.sets.number(tags)));
        }
    }

    /// Adds all tags of a mesh whose points have new numbers.
    pub fn append(&mut self, tags: &SubcomponentTags, new: &dyn Fn(u32) -> u32) {
        let Some(lists) = &tags.0 else { return };
        // Unused sets get no number, so that they do not add up.
        let mut numbers: Vec<Option<u32>> = vec![None; lists.sets.len()];
        let sets = &mut self.sets;
        let mut number = |set: u32| {
            let number = &mut numbers[set as usize];
            *number.get_or_insert_with(|| sets.number(&lists.sets[set as usize]))
        };
        self.edges.extend(lists.edges.iter().map(|&(ends, set)| (in_order(ends.each(new)), number(set))));
        self.vertices.extend(lists.vertices.iter().map(|&(point, set)| (new(point), number(set))));
    }

    /// The tags; none if the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile.
    pub fn finish(self) -> SubcomponentTags {
        let SubcomponentTagsBuilder { mut sets, edges, vertices } = self;
        let united = (united(edges, &mut sets), united(vertices, &mut sets));
        let (Some(edges), Some(vertices)) = united else { return SubcomponentTags::default() };
        SubcomponentTags::of(sets.into_sets(), edges, vertices)
    }
}

/// The list sorted, with one element for each key. `None` if the work is to end.
fn united<K: Ord + Copy>(mut list: Vec<(K, u32)>, sets: &mut TagSetTable) -> Option<Vec<(K, u32)>> {
    if !long_sort_by(&mut list, Ord::cmp) {
        return None;
    }
    list.dedup();
    list.dedup_by(|next, kept| {
        let same = next.0 == kept.0;
        if same {
            kept.1 = sets.union(kept.1, next.1);
        }
        same
    });
    Some(list)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(names: &[&str]) -> TagSet {
        TagSet::new(names.iter().copied())
    }

    #[test]
    fn an_edge_is_found_from_both_sides() {
        let mut tagger = SubcomponentTagsBuilder::default();
        tagger.edge([7, 2], &set(&["a"]));
        tagger.edge([2, 3], &TagSet::default());
        tagger.vertex(3, &set(&["v"]));
        let tags = tagger.finish();
        assert!(tags.hold(8) && !tags.hold(7));
        assert_eq!([tags.edge([2, 7]), tags.edge([7, 2])], [Some(&set(&["a"])); 2]);
        assert_eq!((tags.edge([2, 3]), tags.vertex(2), tags.vertex(3)), (None, None, Some(&set(&["v"]))));
        assert!(SubcomponentTagsBuilder::default().finish().is_empty());
    }

    #[test]
    fn tags_that_are_given_twice_are_united() {
        let mut tagger = SubcomponentTagsBuilder::default();
        for (ends, names) in [([1, 2], &["b"][..]), ([2, 1], &["a", "c"]), ([1, 2], &["c"]), ([0, 1], &["c"])] {
            tagger.edge(ends, &set(names));
        }
        let tags = tagger.finish();
        assert_eq!(tags.edge([1, 2]), Some(&set(&["a", "b", "c"])));
        assert_eq!(tags.edges().len(), 2);
        // All of it twice, once with other numbers.
        let mut tagger = SubcomponentTagsBuilder::default();
        tagger.append(&tags, &|point| point);
        tagger.append(&tags, &|point| 3 - point);
        let tags = tagger.finish();
        assert_eq!(tags.edges().map(|edge| edge.0).collect::<Vec<_>>(), [[0, 1], [1, 2], [2, 3]]);
        assert!(tags.hold(4));
    }

    #[test]
    fn many_changes_leave_few_sets() {
        let mut tags = SubcomponentTags::default();
        for round in 0..40 {
            tags = tags.with_edges([[0, 1], [1, 2], [1, 0]].into_iter(), &format!("t.{round}"));
            tags = tags.with_vertices(3, "v").without(&|name| name == "v", TaggedComponents::All);
            assert!(tags.sets().len() <= 4 && tags.hold(3));
        }
        assert_eq!((tags.edges().len(), tags.vertices().len()), (2, 0));
        assert_eq!(tags.edge([0, 1]).unwrap().names().len(), 40);
        assert_eq!(tags.names(TaggedComponents::All).filter(|name| ***name == *"t.7").count(), 1);
        assert_eq!(tags.names(TaggedComponents::Vertices).count(), 0);
        assert!(tags.without(&|_| true, TaggedComponents::Faces) == tags);
        assert!(tags.without(&|_| true, TaggedComponents::Edges).is_empty());
    }

    #[test]
    fn parts_of_an_edge_keep_its_tags() {
        let mut tagger = SubcomponentTagsBuilder::default();
        tagger.edge([0, 1], &set(&["e"]));
        tagger.vertex(0, &set(&["v"]));
        tagger.vertex(1, &set(&["w"]));
        let tags = tagger.finish();
        // The end 0 of the edge, two points on it, a point on another edge, and a new point.
        let points = [
            PointOrigin::Old(0),
            PointOrigin::Between { ends: [0, 1], share: 0.25 },
            PointOrigin::Between { ends: [1, 0], share: 0.25 },
            PointOrigin::Between { ends: [1, 2], share: 0.5 },
            PointOrigin::New,
        ];
        let edges = [[0, 1], [1, 0], [1, 2], [2, 3], [3, 4], [4, 0]];
        let part = tags.carried(&mut edges.into_iter(), points.len(), &|point| points[point as usize]);
        assert_eq!(part.edges().map(|edge| edge.0).collect::<Vec<_>>(), [[0, 1], [1, 2]]);
        assert_eq!(part.vertices().collect::<Vec<_>>(), [(0, &set(&["v"]))]);
    }
}
