//! The arrangement of a wavefront at an event: clusters of vertices, and the segments into which they divide edges.

use std::collections::BTreeMap;

use super::contact::Contacts;
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

/// The numbers of the segments that end and begin at a cluster.
#[derive(Debug)]
pub(super) struct Incidence {
    pub(super) cluster: u32,
    pub(super) incoming: Vec<usize>,
    pub(super) outgoing: Vec<usize>,
}

/// All segments with a cluster at one end or both.
#[derive(Debug)]
pub(super) struct Arrangement {
    /// The segments, in the order of edges, then along each edge.
    pub(super) segments: Vec<Segment>,
    /// Pairs of opposite segments between the same two clusters, which are removed from the segments.
    pub(super) cancelled: Vec<[Segment; 2]>,
    /// One entry per cluster where the wavefront changes, in the order of their first vertices.
    pub(super) incidences: Vec<Incidence>,
}

impl Arrangement {
    /// Divides the edges that touch clusters.
    pub(super) fn of(front: &Wavefront, contacts: &Contacts) -> Self {
        let cluster = |vertex: u32| contacts.cluster(vertex);
        let next = |edge: u32| front.vertices[edge as usize].next;
        let vertices = contacts.vertices();
        // Vertices without a contact do not change.
        let mut changes = vec![false; front.vertices.len()];
        for &vertex in vertices.iter().filter(|&&vertex| cluster(vertex) != vertex) {
            changes[cluster(vertex) as usize] = true;
        }
        contacts.tips().for_each(|vertex| changes[cluster(vertex) as usize] = true);
        let mut divisions: Vec<(u32, f64, u32)> = Vec::new();
        for [edge, vertex] in contacts.on_edges() {
            let here = cluster(vertex);
            if here != cluster(edge) && here != cluster(next(edge)) {
                changes[here as usize] = true;
                let along = front.lines[front.vertices[edge as usize].after as usize].along;
                divisions.push((edge, along.dot(front.positions[here as usize]), here));
            }
        }
        divisions.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        divisions.dedup_by_key(|division| (division.0, division.2));
        let changing = vertices.iter().filter(|&&vertex| changes[cluster(vertex) as usize]);
        let mut edges: Vec<u32> = changing.flat_map(|&v| [v, front.vertices[v as usize].last]).collect();
        edges.extend(divisions.iter().map(|division| division.0));
        edges.sort_unstable();
        edges.dedup();
        let end = |vertex: u32| {
            let cluster = cluster(vertex);
            if changes[cluster as usize] { SegmentEnd::Cluster(cluster) } else { SegmentEnd::Vertex(vertex) }
        };
        let mut segments: Vec<Segment> = Vec::new();
        for &edge in &edges {
            let first = divisions.partition_point(|division| division.0 < edge);
            let on = divisions[first..].iter().take_while(|division| division.0 == edge);
            let mut from = end(edge);
            for to in on.map(|division| SegmentEnd::Cluster(division.2)).chain([end(next(edge))]) {
                if from != to {
                    segments.push(Segment { from, to, edge, line: front.vertices[edge as usize].after });
                }
                from = to;
            }
        }
        let cancelled = cancel(&mut segments);
        let clusters = vertices.iter().copied().filter(|&vertex| changes[vertex as usize]);
        let incidences = incidences(clusters, &segments);
        Arrangement { segments, cancelled, incidences }
    }

    /// The index of a cluster where the wavefront changes.
    pub(super) fn number(&self, cluster: u32) -> Option<usize> {
        number(&self.incidences, cluster)
    }
}

fn number(incidences: &[Incidence], cluster: u32) -> Option<usize> {
    incidences.binary_search_by_key(&cluster, |incidence| incidence.cluster).ok()
}

fn incidences(clusters: impl Iterator<Item = u32>, segments: &[Segment]) -> Vec<Incidence> {
    let none = |cluster| Incidence { cluster, incoming: Vec::new(), outgoing: Vec::new() };
    let mut incidences: Vec<Incidence> = clusters.map(none).collect();
    for (segment, &Segment { from, to, .. }) in segments.iter().enumerate() {
        let at = |end: SegmentEnd| match end {
            SegmentEnd::Cluster(cluster) => number(&incidences, cluster),
            SegmentEnd::Vertex(_) => None,
        };
        let ends = [at(from), at(to)];
        if let Some(from) = ends[0] {
            incidences[from].outgoing.push(segment);
        }
        if let Some(to) = ends[1] {
            incidences[to].incoming.push(segment);
        }
    }
    incidences
}

/// Removes pairs of opposite segments between the same two clusters.
fn cancel(segments: &mut Vec<Segment>) -> Vec<[Segment; 2]> {
    // For each pair of clusters the segments from one to the other that are not cancelled, last first.
    let mut between: BTreeMap<[SegmentEnd; 2], Vec<usize>> = BTreeMap::new();
    for (number, segment) in segments.iter().enumerate().rev() {
        if let (SegmentEnd::Cluster(_), SegmentEnd::Cluster(_)) = (segment.from, segment.to) {
            between.entry([segment.from, segment.to]).or_default().push(number);
        }
    }
    let mut gone = vec![false; segments.len()];
    let mut cancelled = Vec::new();
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
    cancelled
}
