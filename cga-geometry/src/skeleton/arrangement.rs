//! The arrangement of a wavefront at an event: clusters of vertices, and the segments into which they divide edges.

use crate::small_sort::SmallSort;
use std::collections::BTreeMap;

use super::NONE;
use super::contact::Contacts;
use super::meeting::Meeting;
use super::wavefront::Wavefront;

/// An end of a segment: a vertex that does not change, or a cluster where the wavefront changes, named by its first
/// vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum SegmentEnd {
    Vertex(u32),
    Cluster(u32),
}

impl SegmentEnd {
    pub(super) fn vertex(self) -> u32 {
        let (SegmentEnd::Vertex(vertex) | SegmentEnd::Cluster(vertex)) = self;
        vertex
    }

    fn is_cluster(self) -> bool {
        matches!(self, SegmentEnd::Cluster(_))
    }
}

/// An edge of the wavefront, or the part of an edge between clusters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Segment {
    pub(super) from: SegmentEnd,
    pub(super) to: SegmentEnd,
    pub(super) edge: u32,
    /// The number of its line.
    pub(super) line: u32,
}

/// A segment that ends or begins at a cluster.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Incidence {
    cluster: u32,
    segment: usize,
}

/// The numbers of the segments that end and begin at a cluster.
#[derive(Clone, Copy, Debug)]
pub(super) struct Star<'a> {
    incoming: &'a [Incidence],
    outgoing: &'a [Incidence],
}

impl Star<'_> {
    pub(super) fn incoming(&self) -> impl ExactSizeIterator<Item = usize> {
        self.incoming.iter().map(|incidence| incidence.segment)
    }

    pub(super) fn outgoing(&self) -> impl ExactSizeIterator<Item = usize> {
        self.outgoing.iter().map(|incidence| incidence.segment)
    }
}

/// All segments with a cluster at one end or both. The lists keep their memory from event to event.
#[derive(Debug, Default)]
pub(super) struct Arrangement {
    /// The segments, in the order of edges, then along each edge.
    pub(super) segments: Vec<Segment>,
    /// Pairs of opposite segments between the same two clusters, which are removed from the segments.
    pub(super) cancelled: Vec<[Segment; 2]>,
    /// The clusters where the wavefront changes, sorted.
    clusters: Vec<u32>,
    /// Sorted.
    incoming: Vec<Incidence>,
    outgoing: Vec<Incidence>,
    /// The segments that each continue with another one. [`rejoin`](super::rejoin) fills the list.
    pub(super) pairs: Vec<[usize; 2]>,
    /// For each of `clusters`, in the same order.
    meetings: Vec<Meeting>,
    nodes: Vec<u32>,
    /// For each vertex whether it names a cluster where the wavefront changes. All false between calls.
    changes: Vec<bool>,
    /// The places where clusters divide edges: the edge, the distance along its line, the cluster.
    divisions: Vec<(u32, f64, u32)>,
    edges: Vec<u32>,
}

impl Arrangement {
    /// Divides the edges that touch clusters.
    pub(super) fn divide(&mut self, front: &Wavefront, contacts: &Contacts) {
        let cluster = |vertex: u32| contacts.cluster(vertex);
        let next = |edge: u32| front.vertices[edge as usize].next;
        let vertices = contacts.vertices();
        let Arrangement { changes, divisions, edges, .. } = self;
        changes.resize(front.vertices.len(), false);
        // Vertices without a contact do not change.
        for &vertex in vertices.iter().filter(|&&vertex| cluster(vertex) != vertex) {
            changes[cluster(vertex) as usize] = true;
        }
        contacts.tips().for_each(|vertex| changes[cluster(vertex) as usize] = true);
        divisions.clear();
        for [edge, vertex] in contacts.on_edges() {
            let here = cluster(vertex);
            if here != cluster(edge) && here != cluster(next(edge)) {
                changes[here as usize] = true;
                let along = front.lines[front.vertices[edge as usize].after as usize].along;
                divisions.push((edge, along.dot(front.positions[here as usize]), here));
            }
        }
        divisions.small_sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        divisions.dedup_by_key(|division| (division.0, division.2));
        let changing = vertices.iter().filter(|&&vertex| changes[cluster(vertex) as usize]);
        edges.clear();
        edges.extend(changing.flat_map(|&v| [v, front.vertices[v as usize].last]));
        edges.extend(divisions.iter().map(|division| division.0));
        edges.small_sort();
        edges.dedup();
        let end = |vertex: u32| {
            let cluster = cluster(vertex);
            if changes[cluster as usize] { SegmentEnd::Cluster(cluster) } else { SegmentEnd::Vertex(vertex) }
        };
        self.segments.clear();
        for &edge in &*edges {
            let first = divisions.partition_point(|division| division.0 < edge);
            let on = divisions[first..].iter().take_while(|division| division.0 == edge);
            let mut from = end(edge);
            for to in on.map(|division| SegmentEnd::Cluster(division.2)).chain([end(next(edge))]) {
                if from != to {
                    self.segments.push(Segment { from, to, edge, line: front.vertices[edge as usize].after });
                }
                from = to;
            }
        }
        self.clusters.clear();
        self.clusters.extend(vertices.iter().copied().filter(|&vertex| changes[vertex as usize]));
        self.clusters.iter().for_each(|&cluster| changes[cluster as usize] = false);
        cancel(&mut self.segments, &mut self.cancelled);
        self.join_to_clusters();
    }

    fn join_to_clusters(&mut self) {
        self.incoming.clear();
        self.outgoing.clear();
        for (segment, &Segment { from, to, .. }) in self.segments.iter().enumerate() {
            if from.is_cluster() {
                self.outgoing.push(Incidence { cluster: from.vertex(), segment });
            }
            if to.is_cluster() {
                self.incoming.push(Incidence { cluster: to.vertex(), segment });
            }
        }
        self.incoming.small_sort();
        self.outgoing.small_sort();
    }

    /// The index of a cluster where the wavefront changes.
    fn number(&self, cluster: u32) -> Option<usize> {
        self.clusters.binary_search(&cluster).ok()
    }

    /// Makes the node of the skeleton at each cluster where the wavefront changes.
    pub(super) fn put_nodes(&mut self, front: &mut Wavefront, contacts: &Contacts) {
        let mut meetings = std::mem::take(&mut self.meetings);
        meetings.clear();
        meetings.resize(self.clusters.len(), Meeting::default());
        for &vertex in contacts.vertices() {
            if let Some(number) = self.number(contacts.cluster(vertex)) {
                meetings[number].add(front, vertex);
            }
        }
        self.nodes.clear();
        self.nodes.extend(meetings.iter().map(|meeting| meeting.node(front)));
        self.meetings = meetings;
    }

    /// The node at a cluster; [`NONE`] where nothing changes.
    pub(super) fn node(&self, cluster: u32) -> u32 {
        self.number(cluster).map_or(NONE, |number| self.nodes[number])
    }

    /// The segments at each cluster where the wavefront changes, in the order of clusters.
    pub(super) fn stars(&self) -> impl Iterator<Item = Star<'_>> {
        let (mut incoming, mut outgoing) = (&self.incoming[..], &self.outgoing[..]);
        self.clusters.iter().map(move |&cluster| Star {
            incoming: take(&mut incoming, cluster),
            outgoing: take(&mut outgoing, cluster),
        })
    }
}

/// Takes the incidences of a cluster from the beginning of a list.
fn take<'a>(incidences: &mut &'a [Incidence], cluster: u32) -> &'a [Incidence] {
    let count = incidences.iter().take_while(|incidence| incidence.cluster == cluster).count();
    let (taken, rest) = incidences.split_at(count);
    *incidences = rest;
    taken
}

/// Moves pairs of opposite segments between the same two clusters to another list.
fn cancel(segments: &mut Vec<Segment>, cancelled: &mut Vec<[Segment; 2]>) {
    cancelled.clear();
    if !segments.iter().any(|segment| segment.from.is_cluster() && segment.to.is_cluster()) {
        return;
    }
    // For each pair of clusters the segments from one to the other that are not cancelled, last first.
    let mut between: BTreeMap<[SegmentEnd; 2], Vec<usize>> = BTreeMap::new();
    for (number, segment) in segments.iter().enumerate().rev() {
        if let (SegmentEnd::Cluster(_), SegmentEnd::Cluster(_)) = (segment.from, segment.to) {
            between.entry([segment.from, segment.to]).or_default().push(number);
        }
    }
    let mut gone = vec![false; segments.len()];
    for number in 0..segments.len() {
        let segment = segments[number];
        if gone[number] {
            continue;
        }
        if let Some(against) = between.get_mut(&[segment.to, segment.from]).and_then(Vec::pop) {
            if let Some(own) = between.get_mut(&[segment.from, segment.to]) {
                own.pop();
            }
            (gone[number], gone[against]) = (true, true);
            cancelled.push([segment, segments[against]]);
        }
    }
    let mut gone = gone.into_iter();
    segments.retain(|_| gone.next() == Some(false));
}
