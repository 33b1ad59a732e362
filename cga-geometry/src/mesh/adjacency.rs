//! The adjacency of a mesh: the faces at each edge and at each point. Computed on demand and shared by copies.

use super::Mesh;
use crate::buckets::Buckets;
use crate::each::Each;
use crate::small_sort::SmallSort;

/// The units of work of a corner.
const CORNER: usize = 4;

/// The points whose edges are sorted between two counts of work.
const POINTS: usize = 1024;

/// Adjacency in a mesh. Edges are numbered in the order of the first corner that starts them; a shared edge has one
/// number. Corners are numbered as in [`Mesh::corners`].
///
/// Its methods panic if a corner, an edge or a point with the number does not exist.
#[derive(Debug, Default)]
pub struct Adjacency {
    /// The face of each corner.
    faces: Vec<u32>,
    /// The next and the previous corner in the loop, for each corner.
    next: Vec<u32>,
    before: Vec<u32>,
    /// The edge that starts at each corner.
    edges: Vec<u32>,
    /// For each edge the corners that start it.
    uses: Buckets,
    /// For each point the corners at it.
    at: Buckets,
}

impl Adjacency {
    /// `None` if the work is to end: `spend` counts units of work, and returns false then.
    pub(super) fn of(mesh: &Mesh, spend: impl Fn(usize) -> bool) -> Option<Self> {
        let corners = mesh.corners.len();
        if !spend(CORNER * corners) {
            return None;
        }
        let [mut faces, mut next, mut before] = [(); 3].each(|()| Vec::with_capacity(corners));
        for face in mesh.faces() {
            for ring in face.loop_ranges() {
                faces.resize(ring.end, face.index() as u32);
                next.extend((ring.start + 1..ring.end).chain([ring.start]).map(|corner| corner as u32));
                before.extend([ring.end - 1].into_iter().chain(ring.start..ring.end - 1).map(|corner| corner as u32));
            }
        }
        let at = Buckets::by(mesh.points.len(), mesh.corners.iter().copied());
        if !spend(CORNER * corners) {
            return None;
        }
        let edges = number_edges(mesh, &next, &spend)?;
        let count = edges.iter().max().map_or(0, |&last| last as usize + 1);
        let uses = Buckets::by(count, edges.iter().copied());
        Some(Adjacency { faces, next, before, edges, uses, at })
    }

    /// The number of edges. A shared edge counts once.
    pub fn edge_count(&self) -> usize {
        self.uses.len()
    }

    /// The face of a corner.
    pub fn face(&self, corner: u32) -> u32 {
        self.faces[corner as usize]
    }

    /// The next corner in a corner's loop.
    pub fn next(&self, corner: u32) -> u32 {
        self.next[corner as usize]
    }

    /// The previous corner in a corner's loop.
    pub fn before(&self, corner: u32) -> u32 {
        self.before[corner as usize]
    }

    /// The corners that start an edge, one per loop that has the edge; at least one.
    pub fn uses(&self, edge: usize) -> &[u32] {
        self.uses.of(edge)
    }

    /// The corners at a point.
    pub(crate) fn at(&self, point: usize) -> &[u32] {
        self.at.of(point)
    }

    /// The edge that starts at a corner.
    pub fn edge(&self, corner: u32) -> usize {
        self.edges[corner as usize] as usize
    }

    /// The faces at an edge, without repetitions.
    pub fn faces_at(&self, edge: usize) -> impl Iterator<Item = u32> + '_ {
        self.distinct(self.uses(edge))
    }

    /// The faces at a point, without repetitions.
    pub fn faces_around(&self, point: usize) -> impl Iterator<Item = u32> + '_ {
        self.distinct(self.at(point))
    }

    /// The faces of corners, without repetitions. The corners are in the order of their faces.
    fn distinct<'a>(&'a self, corners: &'a [u32]) -> impl Iterator<Item = u32> + 'a {
        let mut last = None;
        corners.iter().map(|&corner| self.face(corner)).filter(move |&face| last.replace(face) != Some(face))
    }

    /// Returns true if exactly one face has an edge.
    pub fn is_border(&self, edge: usize) -> bool {
        self.faces_at(edge).nth(1).is_none()
    }
}

/// For each corner the number of the edge that starts there. Edges are grouped by their lower point, then by the other
/// point.
fn number_edges(mesh: &Mesh, next: &[u32], spend: &impl Fn(usize) -> bool) -> Option<Vec<u32>> {
    let ends = |corner: u32| {
        let [a, b] = [corner, next[corner as usize]].each(|corner| mesh.corners[corner as usize]);
        (a.min(b), a.max(b))
    };
    let mut around = Buckets::by(mesh.points.len(), (0..next.len() as u32).map(|corner| ends(corner).0));
    // The first corner that starts the same edge.
    let mut first: Vec<u32> = vec![0; next.len()];
    for point in 0..mesh.points.len() {
        if point % POINTS == 0 && !spend(CORNER * POINTS) {
            return None;
        }
        let range = around.range(point);
        let here = &mut around.items[range];
        // Usually few corners are at a point, but in a fan there are many, so they are sorted.
        here.small_sort_by_key(|&corner| (ends(corner).1, corner));
        for same in here.chunk_by(|&a, &b| ends(a).1 == ends(b).1) {
            same.iter().for_each(|&corner| first[corner as usize] = same[0]);
        }
    }
    if !spend(CORNER * first.len()) {
        return None;
    }
    let mut count = 0;
    for corner in 0..first.len() {
        first[corner] = if first[corner] as usize == corner {
            count += 1;
            count - 1
        } else {
            // The first corner has its number already.
            first[first[corner] as usize]
        };
    }
    Some(first)
}

#[cfg(test)]
mod tests {
    use crate::mesh::{Mesh, MeshBuilder};
    use crate::primitive;

    #[test]
    fn edges_are_numbered_by_their_first_corner() {
        let cube = primitive::cube();
        let adjacency = cube.adjacency();
        assert_eq!(adjacency.edge_count(), 12);
        let mut seen = 0;
        for corner in 0..cube.corners().len() as u32 {
            let edge = adjacency.edge(corner);
            assert!(edge <= seen);
            seen = seen.max(edge + 1);
            assert!(adjacency.uses(edge).contains(&corner));
            assert_eq!(adjacency.faces_at(edge).count(), 2);
            assert!(!adjacency.is_border(edge));
        }
        assert!((0..8).all(|point| adjacency.faces_around(point).count() == 3));
    }

    #[test]
    fn of_a_fold_and_a_fin_all_faces_are_known() {
        let mut builder = MeshBuilder::new();
        let hinge = [0.0, 1.0].map(|y| builder.point([0.0, y, 0.0]));
        for end in [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]] {
            let tip = builder.point(end);
            builder.face(&[hinge[0], hinge[1], tip], &[], Default::default());
        }
        let mesh = builder.build().unwrap();
        let adjacency = mesh.adjacency();
        assert_eq!(adjacency.faces_at(0).collect::<Vec<_>>(), [0, 1, 2]);
        assert_eq!((1..7).filter(|&edge| adjacency.is_border(edge)).count(), 6);
    }

    #[test]
    fn of_nothing_there_is_nothing() {
        assert_eq!(Mesh::default().adjacency().edge_count(), 0);
    }
}
