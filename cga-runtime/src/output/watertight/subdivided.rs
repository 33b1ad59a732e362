//! Meshes with more points in their edges.
//!
//! A face is divided as sinks divide it, but without its straight corners. Then each triangle with points in its sides is divided into
//! triangles of which none has three points in one line.

use std::cell::OnceCell;
use std::ops::Range;

use glam::{DVec2, DVec3};

use super::known_edges::KnownEdges;
use super::network::{LeafPart, Network};
use super::straight::StraightCorners;
use crate::geometry::derive::{CornerValues, Derivation, FaceOrigin};
use crate::geometry::each::Each;
use crate::geometry::mesh::{FaceRef, Mesh};
use crate::geometry::origin::PointOrigin;
use crate::geometry::triangulate::{PlaneProjection, Triangulator};
use crate::geometry::work;

/// Makes meshes with more points in their edges. It keeps its lists from mesh to mesh.
#[derive(Default)]
pub(super) struct Subdivider {
    triangulator: Triangulator,
    straight: StraightCorners,
    face: DividedFace,
    flat: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
    points: NewPoints,
}

/// The points of a mesh under construction. It keeps its lists from mesh to mesh.
#[derive(Default)]
struct NewPoints {
    /// The places of all points.
    places: Vec<DVec3>,
    /// The new points in each edge, as ranges of `points`.
    known: KnownEdges,
    points: Vec<u32>,
}

/// A face whose sides have points.
#[derive(Default)]
struct DividedFace {
    /// The corners that are not straight, loop by loop.
    corners: Vec<Corner>,
    ends: Vec<u32>,
    /// The straight corners and the points inside of edges.
    sides: Vec<u32>,
    /// The points on the way from one corner of a triangle to another one, on both sides.
    chains: [Vec<u32>; 2],
    made: Vec<[u32; 3]>,
}

/// A corner that is not straight, and the side after it.
#[derive(Clone, Debug)]
struct Corner {
    point: u32,
    /// The place of the next corner in the list.
    next: u32,
    /// The points of the side in `sides`.
    side: Range<usize>,
}

/// A mesh under construction, with points in the edges of another one.
struct EdgePoints<'a> {
    network: &'a Network,
    part: LeafPart,
    made: Derivation<'a>,
    new: &'a mut NewPoints,
}

/// A mesh whose points may be at other places.
pub(super) struct PlacedMesh<'a> {
    pub(super) mesh: &'a Mesh,
    pub(super) places: &'a [DVec3],
    /// The same as one mesh, where `places` are not its points.
    moved: Option<OnceCell<Mesh>>,
}

impl<'a> PlacedMesh<'a> {
    /// A mesh without texture coordinates and normals, with its points at other places.
    pub(super) fn at(mesh: &'a Mesh, places: &'a [DVec3]) -> Self {
        PlacedMesh { mesh, places, moved: Some(OnceCell::new()) }
    }

    pub(super) fn of(mesh: &'a Mesh) -> Self {
        PlacedMesh { mesh, places: mesh.points(), moved: None }
    }

    fn whole(&self) -> &Mesh {
        match &self.moved {
            Some(moved) => moved.get_or_init(|| self.mesh.with_points(self.places.to_vec())),
            None => self.mesh,
        }
    }
}

impl Subdivider {
    /// The mesh of a leaf in the world with all points inside of its edges as corners, and faces with such points as triangles. `near` is
    /// the distance from an edge within which a corner is in it, for a mesh that may have straight corners. `None` if the work is to end.
    pub(super) fn subdivided(
        &mut self,
        placed: &PlacedMesh<'_>,
        network: &Network,
        part: LeafPart,
        near: Option<f64>,
    ) -> Option<Mesh> {
        let PlacedMesh { mesh, places, .. } = *placed;
        let new = &mut self.points;
        new.places.clear();
        new.places.extend_from_slice(places);
        new.known.clear();
        new.points.clear();
        let inside = network.count_inside(part);
        // A face with some corners and points in its edges has two triangles less.
        let corners = 3 * (mesh.corners().len() + inside);
        let made = Derivation::new(mesh, CornerValues::All, corners).with_old_points_at(places, inside, corners);
        let mut edges = EdgePoints { network, part, made, new };
        for face in mesh.faces() {
            let is_reduced = match near {
                Some(near) => self.straight.find(&face, places, near),
                None => self.straight.has_none(),
            };
            if !is_reduced && face.corner_range().all(|corner| network.inside(part, corner).is_empty()) {
                if !work::spend(face.corner_count()) {
                    return None;
                }
                edges.made.keep(face.loop_ranges(), FaceOrigin::piece(&face));
                continue;
            }
            self.face.read(&face, &self.straight, &mut edges);
            if !work::spend(face.corner_count() + self.face.sides.len()) {
                return None;
            }
            if self.face.sides.is_empty() {
                edges.made.keep(face.loop_ranges(), FaceOrigin::piece(&face));
                continue;
            }
            self.triangles.clear();
            if is_reduced {
                let projection = PlaneProjection::along(face.normal());
                self.flat.clear();
                self.flat
                    .extend(self.face.corners.iter().map(|c| projection.apply(edges.new.places[c.point as usize])));
                self.triangulator.polygon(&self.flat, &self.face.ends, &mut self.triangles);
            } else {
                let triangles = &mut self.triangles;
                if !self.triangulator.simple_face_at(mesh, face.index(), places, triangles) {
                    self.triangulator.face(placed.whole(), face.index(), triangles);
                }
                let start = face.corner_range().start as u32;
                self.triangles.iter_mut().flatten().for_each(|corner| *corner -= start);
            }
            self.face.made.clear();
            self.triangles.iter().for_each(|triangle| self.face.divide(*triangle, &edges.new.places));
            self.face.made.iter().for_each(|triangle| edges.made.face([triangle], FaceOrigin::piece(&face)));
        }
        Some(edges.made.finish())
    }
}

impl EdgePoints<'_> {
    /// The points inside of the edge that begins at a corner, as a range of `points`, and true if they come from its second end to its
    /// first.
    fn of_edge(&mut self, corner: usize, [from, to]: [u32; 2]) -> (Range<usize>, bool) {
        let inside = self.network.inside(self.part, corner);
        if inside.is_empty() {
            return (0..0, false);
        }
        let ends = [from.min(to), from.max(to)];
        let NewPoints { places, known, points } = &mut *self.new;
        if let Some(range) = known.get(ends) {
            return (range, to < from);
        }
        let is_turned = self.network.is_turned(self.part, ends);
        let start = points.len();
        let [low, high] = ends.each(|end| places[end as usize]);
        let length = (high - low).length();
        for &point in inside {
            let place = self.network.place(point);
            let share = ((place - low).length() / length).clamp(0.0, 1.0);
            points.push(self.made.point(place, PointOrigin::Between { ends, share }));
            places.push(place);
        }
        if is_turned {
            points[start..].reverse();
        }
        let range = start..points.len();
        known.add(ends, range.clone());
        (range, to < from)
    }
}

impl DividedFace {
    /// Reads the corners and sides of a face.
    fn read(&mut self, face: &FaceRef<'_>, straight: &StraightCorners, edges: &mut EdgePoints<'_>) {
        self.corners.clear();
        self.ends.clear();
        self.sides.clear();
        for (ring, range) in face.loops().zip(face.loop_ranges()) {
            let first = self.corners.len();
            let is_straight = |at: usize| straight.has(range.start - face.corner_range().start + at % ring.len());
            let start = (0..ring.len()).find(|at| !is_straight(*at)).unwrap_or_default();
            for at in start..start + ring.len() {
                let [point, next] = [at, at + 1].each(|at| ring[at % ring.len()]);
                if is_straight(at) {
                    self.sides.push(point);
                } else {
                    self.end_side(first);
                    let end = self.sides.len();
                    self.corners.push(Corner { point, next: first as u32, side: end..end });
                }
                let (points, is_turned) = edges.of_edge(range.start + at % ring.len(), [point, next]);
                let start = self.sides.len();
                self.sides.extend(&edges.new.points[points]);
                if is_turned {
                    self.sides[start..].reverse();
                }
            }
            self.end_side(first);
            if let Some(last) = self.corners[first..].last_mut() {
                last.next = first as u32;
            }
            self.ends.push(self.corners.len() as u32);
        }
    }

    /// Ends the side after the last corner of the loop that begins with a corner.
    fn end_side(&mut self, first: usize) {
        let (next, end) = (self.corners.len() as u32, self.sides.len());
        if let Some(last) = self.corners[first..].last_mut() {
            (last.next, last.side.end) = (next, end);
        }
    }

    /// Divides a triangle of corners at all points of its sides.
    fn divide(&mut self, triangle: [u32; 3], places: &[DVec3]) {
        let corners = triangle.each(|corner| &self.corners[corner as usize]);
        let side = |k: usize| match corners[k].next == triangle[(k + 1) % 3] {
            true => &self.sides[corners[k].side.clone()],
            false => &[],
        };
        let point = |k: usize| corners[k % 3].point;
        let Some(k) = (0..3).find(|k| !side(*k).is_empty()) else {
            self.made.push([point(0), point(1), point(2)]);
            return;
        };
        // From one end of a side to the other: along the side, and along the two others. The first and the last triangle have an end,
        // and the others have points of both ways, which are never three on one line.
        let [right, left] = &mut self.chains;
        right.clear();
        right.extend(side(k));
        left.clear();
        left.extend(side((k + 2) % 3).iter().rev());
        left.push(point(k + 2));
        left.extend(side((k + 1) % 3).iter().rev());
        let distance = |a: u32, b: u32| places[a as usize].distance_squared(places[b as usize]);
        let made = &mut self.made;
        let mut add = |triangle: [u32; 3]| {
            let [a, b, c] = triangle;
            if a != b && b != c && c != a {
                made.push(triangle);
            }
        };
        let (mut r, mut l) = (0, 0);
        add([point(k), right[r], left[l]]);
        while r + 1 < right.len() || l + 1 < left.len() {
            let is_right_next = l + 1 == left.len()
                || (r + 1 < right.len() && distance(right[r + 1], left[l]) <= distance(right[r], left[l + 1]));
            if is_right_next {
                add([right[r], right[r + 1], left[l]]);
                r += 1;
            } else {
                add([right[r], left[l + 1], left[l]]);
                l += 1;
            }
        }
        add([right[r], point(k + 1), left[l]]);
    }
}
