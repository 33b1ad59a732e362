//! Makes one mesh of parts that share points.

use glam::{DAffine3, DVec3};

use super::origins::Origins;
use crate::derive::{CornerValues, Derivation, FaceOrigin, Mix, PointOrigin};
use crate::each::Each;
use crate::mesh::join::join;
use crate::mesh::{Derived, Mesh, SubcomponentTagsBuilder, TagSet};
use crate::trace::{Trace, UNTRACED};
use crate::unbent::bent_along;
use crate::wire::Wire;

/// Parts that become one mesh.
#[derive(Debug, Default)]
pub struct Weld {
    meshes: Vec<Mesh>,
    /// The numbers of the points of all meshes.
    points: Vec<u32>,
    /// The tags of edges and vertices, by these numbers.
    tagger: SubcomponentTagsBuilder,
    /// The direction of bent faces.
    bent: DVec3,
}

/// A corner of a face: a corner of the part, or a point between it and the next one.
#[derive(Clone, Copy)]
struct WeldCorner {
    from: usize,
    to: usize,
    share: f64,
    point: u32,
}

impl Weld {
    /// Adds a part. `points` are the numbers of its points. Used points on its edges become corners. A loop that has fewer than
    /// three different neighbours is dropped.
    ///
    /// # Panics
    /// Panics if a point of the part has no number, or a number that `origins` does not have.
    pub fn add(&mut self, origins: &Origins, mesh: Mesh, points: &[u32]) {
        assert!(mesh.points.len() <= points.len(), "{} numbers for {} points", points.len(), mesh.points.len());
        let mut mesh = bent_along(mesh, &mut self.bent);
        mesh.trace = Trace::default();
        mesh.derived = Derived::default();
        let mut refined = Derivation::new(&mesh, CornerValues::All, mesh.corners().len());
        // The points of the refined mesh are its corners; `finish` finds the points that they are.
        let mut numbers = Vec::with_capacity(mesh.corners.len());
        let mut ring = Vec::new();
        for face in mesh.faces() {
            let mut has_loop = false;
            for (number, range) in face.loop_ranges().enumerate() {
                ring.clear();
                for from in range.clone() {
                    let to = if from + 1 == range.end { range.start } else { from + 1 };
                    let ends = [from, to].each(|corner| points[mesh.corners[corner] as usize]);
                    let mut push = |corner: WeldCorner| {
                        if ring.last().is_none_or(|last: &WeldCorner| last.point != corner.point) {
                            ring.push(corner);
                        }
                    };
                    push(WeldCorner { from, to: from, share: 0.0, point: ends[0] });
                    origins.between(ends, |point, share| push(WeldCorner { from, to, share, point }));
                    self.tag_edge(origins, &mesh, [from, to], ends);
                }
                while 1 < ring.len() && ring[0].point == ring[ring.len() - 1].point {
                    ring.pop();
                }
                if ring.len() < 3 {
                    // A face without an outline has no holes.
                    if number == 0 {
                        break;
                    }
                    continue;
                }
                has_loop = true;
                for corner in &ring {
                    let WeldCorner { from, to, share, point } = *corner;
                    let [a, b] = [from, to].each(|corner| corner as u32);
                    let mix = if a == b { Mix::One(a) } else { Mix::Two([a, b], share) };
                    numbers.push(point);
                    // Tags come from all parts, so no origin tells them.
                    let number = refined.point(DVec3::ZERO, PointOrigin::New);
                    refined.corner(number, &mix, false);
                }
                refined.end_loop();
            }
            if has_loop {
                refined.end_face(FaceOrigin::piece(&face));
            }
        }
        mesh.subcomponent_tags.vertices().for_each(|(point, set)| self.tagger.vertex(points[point as usize], set));
        self.points.extend(numbers);
        self.meshes.push(refined.finish());
    }

    /// Adds the tags of the edge between two corners, all along the edge.
    fn tag_edge(&mut self, origins: &Origins, mesh: &Mesh, corners: [usize; 2], ends: [u32; 2]) {
        if let Some(set) = mesh.edge_tags(corners.each(|corner| mesh.corners[corner])) {
            self.tag_along(origins, ends, set);
        }
    }

    fn tag_along(&mut self, origins: &Origins, ends: [u32; 2], set: &TagSet) {
        let mut last = ends[0];
        origins.between(ends, |point, _| self.tagger.edge([std::mem::replace(&mut last, point), point], set));
        self.tagger.edge([last, ends[1]], set);
    }

    /// Adds the tags of a part without faces, whose edges and points faces have, too. `points` are the numbers of its points.
    pub fn add_tags(&mut self, origins: &Origins, part: &Wire, points: &[u32]) {
        let number = |point: u32| points.get(point as usize).copied().unwrap_or(UNTRACED);
        for (ends, set) in part.tags.edges().map(|(ends, set)| (ends.each(number), set)) {
            if !ends.contains(&UNTRACED) {
                self.tag_along(origins, ends, set);
            }
        }
        part.tags.vertices().for_each(|(point, set)| self.tagger.vertex(number(point), set));
    }

    /// The number of corners so far.
    pub fn corner_count(&self) -> u64 {
        self.points.len() as u64
    }

    /// The mesh, with points at `places`, seen through `map`, and the numbers of its points. `places` has a place for each number.
    ///
    /// # Panics
    /// Panics if a point of a part has no place.
    pub fn finish(self, places: &[DVec3], map: &DAffine3) -> (Mesh, Vec<u32>) {
        let mut sum = join(self.meshes.iter());
        let (points, numbers) = renumbered(&self.points, places, map, &mut sum.corners);
        sum.points = points;
        let origin = |point: u32| PointOrigin::Old(numbers[point as usize]);
        let tags = self.tagger.finish().carried(&mut sum.face_edges(), sum.points.len(), &origin);
        sum.subcomponent_tags = tags;
        sum.derived = Derived::default();
        (sum.checked(), numbers)
    }
}

/// The points that corners use, in the order of their first use, and their numbers. Corners are indices into `ids`.
fn renumbered(ids: &[u32], places: &[DVec3], map: &DAffine3, corners: &mut [u32]) -> (Vec<DVec3>, Vec<u32>) {
    let mut new = vec![UNTRACED; places.len()];
    let (mut points, mut numbers) = (Vec::new(), Vec::new());
    for corner in corners {
        let id = ids[*corner as usize];
        let number = &mut new[id as usize];
        if *number == UNTRACED {
            *number = points.len() as u32;
            points.push(map.transform_point3(places[id as usize]) + 0.0);
            numbers.push(id);
        }
        *corner = *number;
    }
    (points, numbers)
}

/// The wire of several wires that share points, with points at `places`, seen through `map`, and the numbers of its points. Each
/// wire comes with the numbers of its points.
///
/// # Panics
/// Panics if a point of a wire has no number, or a number has no place.
pub fn welded_wire(parts: &[(Wire, Vec<u32>)], places: &[DVec3], map: &DAffine3) -> (Wire, Vec<u32>) {
    let has_edges = parts.iter().any(|(wire, _)| !wire.edges.is_empty());
    let (mut ids, mut normals, mut ends) = (Vec::new(), Vec::new(), Vec::new());
    for (wire, own) in parts.iter().filter(|(wire, _)| wire.edges.is_empty() != has_edges) {
        let first = ids.len() as u32;
        ids.extend_from_slice(own);
        normals.extend_from_slice(&wire.normals);
        match has_edges {
            true => ends.extend(wire.edges.iter().flatten().map(|end| first + end)),
            false => ends.extend(first..ids.len() as u32),
        }
    }
    let (points, numbers) = renumbered(&ids, places, map, &mut ends);
    if !has_edges {
        normals.truncate(points.len());
    }
    let edges: Vec<[u32; 2]> =
        if has_edges { ends.chunks_exact(2).map(|ends| [ends[0], ends[1]]).collect() } else { Vec::new() };
    let mut tagger = SubcomponentTagsBuilder::default();
    parts.iter().for_each(|(wire, own)| tagger.append(&wire.tags, &|point| own[point as usize]));
    let origin = |point: u32| PointOrigin::Old(numbers[point as usize]);
    let tags = tagger.finish().carried(&mut edges.iter().copied(), points.len(), &origin);
    (Wire { points, edges, normals, tags, trace: Trace::default() }, numbers)
}
