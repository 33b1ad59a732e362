//! Facets: the planar faces of an arrangement.

use glam::{DVec2, DVec3};

use super::lists::{Lists, Polygons, Rings};
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::progress::goes_on;
use super::rim::{MOST_WITHOUT_TREE, RimTree};
use crate::each::Each;
use crate::exact::orient;
use crate::mesh::{Bounds, FaceRef, Mesh, unit};
use crate::triangulate::{PlaneProjection, Triangulator};

/// A planar polygon with holes: a face of the mesh, or a triangle of a bent face.
pub(super) struct Facet<'a> {
    /// The face of the mesh.
    pub(super) face: u32,
    /// True if it is only a part of the face.
    pub(super) is_part: bool,
    pub(super) origin: DVec3,
    pub(super) normal: DVec3,
    pub(super) projection: PlaneProjection,
    /// The points of the outline and the holes.
    pub(super) rings: Rings<'a, u32>,
    /// For each corner the corner of the mesh. In increasing order, except in a part of a face.
    pub(super) sources: &'a [u32],
    /// The bounding box, which is larger by epsilon on all sides.
    pub(super) bounds: Bounds,
    pub(super) is_convex: bool,
    /// A tree of the loops' edges, if there are many.
    pub(super) rim_tree: Option<RimTree>,
}

impl<'a> Facet<'a> {
    /// The place of a point in the facet's plane.
    pub(super) fn flat(&self, place: DVec3) -> DVec2 {
        self.projection.apply(place)
    }

    /// Two opposite corners of a box, in the facet's plane.
    pub(super) fn flat_box(&self, bounds: &Bounds) -> [DVec2; 2] {
        [bounds.low, bounds.high].each(|place| self.flat(place))
    }

    /// The signed distance from the facet's plane.
    pub(super) fn height(&self, place: DVec3) -> f64 {
        (place - self.origin).dot(self.normal)
    }

    /// The corners of the mesh at both ends of the edge of the loops that starts at a corner.
    pub(super) fn edge_sources(&self, corner: u32) -> [u32; 2] {
        let ends = self.rings.ends;
        let ring = ends.partition_point(|end| *end <= corner);
        let start = if ring == 0 { 0 } else { ends[ring - 1] };
        let next = if corner + 1 == ends[ring] { start } else { corner + 1 };
        [corner, next].each(|corner| self.sources[corner as usize])
    }

    /// The point at a corner of the mesh, if that is a corner of the facet.
    pub(super) fn point_at(&self, source: u32) -> Option<u32> {
        // Only triangles of bent faces have their corners in another order.
        let place = match self.is_part {
            true => self.sources.iter().position(|known| *known == source),
            false => self.sources.binary_search(&source).ok(),
        };
        place.map(|place| self.rings.corners[place])
    }

    /// The places of an edge of the loops in the facet's plane.
    fn flat_edge(&self, points: &PointSet, edge: [usize; 2]) -> [DVec2; 2] {
        edge.each(|corner| self.flat(points.at[self.rings.corners[corner] as usize]))
    }

    /// The number of times that the loops wind around a place, and the number of edges that were compared.
    pub(super) fn winding(&self, points: &PointSet, place: DVec2) -> (i32, usize) {
        let mut turns = 0;
        let mut pass = |edge: [usize; 2]| {
            let [a, b] = self.flat_edge(points, edge);
            if a.y <= place.y && place.y < b.y {
                turns += i32::from(0 < orient(a, b, place));
            } else if b.y <= place.y && place.y < a.y {
                turns -= i32::from(orient(a, b, place) < 0);
            }
        };
        let compared = match &self.rim_tree {
            // Edges that are on the left of the place do not count.
            Some(tree) => tree.visit(place, DVec2::new(f64::INFINITY, place.y), pass),
            None => {
                self.rings.rim().for_each(&mut pass);
                self.rings.corners.len()
            }
        };
        (turns, compared)
    }

    /// The signed distance of a place from the line of an edge, positive on the left.
    pub(super) fn left_of(&self, points: &PointSet, edge: [usize; 2], place: DVec2) -> f64 {
        let [a, b] = self.flat_edge(points, edge);
        (b - a).perp_dot(place - a) / (b - a).length()
    }

    /// The least distance of a place from an edge of the loops.
    pub(super) fn distance_from_rim(&self, points: &PointSet, place: DVec2) -> f64 {
        let distance = |edge: [usize; 2]| {
            let [a, b] = self.flat_edge(points, edge);
            let share = ((place - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            place.distance(a + (b - a) * share)
        };
        self.rings.rim().map(distance).fold(f64::INFINITY, f64::min)
    }

    /// The facet with an outline. `None` if it has no area.
    fn of(points: &PointSet, outline: Outline, rings: Rings<'a, u32>, sources: &'a [u32]) -> Option<Self> {
        let origin = points.at[*rings.corners.first()? as usize];
        let box_of = Bounds::of(rings.corners.iter().map(|point| points.at[*point as usize]));
        let bounds = Bounds { low: box_of.low - points.epsilon, high: box_of.high + points.epsilon };
        let Outline { face, is_part, normal } = outline;
        let projection = PlaneProjection::along(normal);
        let mut facet = Facet {
            face,
            is_part,
            origin,
            normal,
            projection,
            rings,
            sources,
            bounds,
            is_convex: false,
            rim_tree: None,
        };
        facet.is_convex = facet.find_convex(points);
        let around: f64 = rings.edges().map(|edge| points.length(edge)).sum();
        if facet.double_area(points, rings).abs() <= points.epsilon * around {
            return None;
        }
        if MOST_WITHOUT_TREE < rings.corners.len() {
            let at = |corner: usize| facet.flat(points.at[rings.corners[corner] as usize]);
            facet.rim_tree = Some(RimTree::new(rings.rim().collect(), at, points.epsilon));
        }
        Some(facet)
    }

    /// Twice the area of a polygon in the facet's plane, in projection.
    pub(super) fn double_area(&self, points: &PointSet, rings: Rings<'_, u32>) -> f64 {
        let from = rings.corners.first().map_or(DVec2::ZERO, |first| self.flat(points.at[*first as usize]));
        let ends = rings.edges().map(|edge| edge.each(|point| self.flat(points.at[point as usize]) - from));
        ends.map(|[a, b]| a.perp_dot(b)).sum()
    }

    /// A facet of the same plane without an outline.
    pub(super) fn without_outline(&self) -> Self {
        Facet { rings: Rings::EMPTY, sources: &[], is_convex: false, rim_tree: None, ..*self }
    }

    /// Returns true if the outline turns left at every corner and only once around.
    fn find_convex(&self, points: &PointSet) -> bool {
        let count = self.rings.corners.len();
        if self.rings.ends.len() != 1 {
            return false;
        }
        let at = |corner: usize| self.flat(points.at[self.rings.corners[corner % count] as usize]);
        let turns_left = (0..count).all(|corner| 0 <= orient(at(corner), at(corner + 1), at(corner + 2)));
        let rises = |corner: usize| at(corner).y < at(corner + 1).y;
        turns_left && (0..count).filter(|&corner| rises(corner) && !rises(corner + 1)).count() <= 1
    }
}

impl PointSet {
    /// The distance between two points.
    pub(super) fn length(&self, [a, b]: [u32; 2]) -> f64 {
        self.at[a as usize].distance(self.at[b as usize])
    }
}

/// The steps of work of a corner of a new facet.
const FACET: usize = 4;

/// The plane of an outline.
#[derive(Clone, Copy)]
struct Outline {
    face: u32,
    is_part: bool,
    normal: DVec3,
}

/// The outlines of facets.
#[derive(Default)]
pub(super) struct Outlines {
    list: Vec<Outline>,
    rings: Polygons<u32>,
    sources: Lists<u32>,
    /// The corners of a ring.
    ring: Vec<[u32; 2]>,
}

impl Outlines {
    /// The outlines of all faces, in their order. `numbers` gives the point of the arrangement for each point of the mesh.
    pub(super) fn of(mesh: &Mesh, points: &PointSet, numbers: &[u32]) -> Result<Self, BooleanError> {
        let (mut outlines, mut triangulator, mut triangles) = (Outlines::default(), Triangulator::new(), Vec::new());
        let point = |corner: usize| numbers[mesh.corners()[corner] as usize];
        for face in mesh.faces() {
            goes_on(FACET * face.corner_count())?;
            let (number, normal) = (face.index() as u32, face.normal());
            if is_planar(&face, points, numbers, normal) {
                face.loop_ranges()
                    .for_each(|ring| outlines.add_ring(ring.map(|corner| [point(corner), corner as u32])));
                outlines.end(Outline { face: number, is_part: false, normal });
                continue;
            }
            triangles.clear();
            triangulator.face(mesh, face.index(), &mut triangles);
            for triangle in &triangles {
                let ring = triangle.each(|corner| [point(corner as usize), corner]);
                let [a, b, c] = ring.each(|[point, _]| points.at[point as usize]);
                outlines.add_ring(ring);
                outlines.end(Outline { face: number, is_part: true, normal: unit((b - a).cross(c - a)) });
            }
        }
        Ok(outlines)
    }

    /// Adds a ring of points and corners of the mesh. Corners at one point are one.
    fn add_ring(&mut self, ring: impl IntoIterator<Item = [u32; 2]>) {
        self.ring.clear();
        self.ring.extend(ring);
        self.ring.dedup_by_key(|[point, _]| *point);
        while 1 < self.ring.len() && self.ring.first().map(|first| first[0]) == self.ring.last().map(|last| last[0]) {
            self.ring.pop();
        }
        if 3 <= self.ring.len() {
            self.rings.add_ring(self.ring.iter().map(|[point, _]| *point));
            self.ring.iter().for_each(|[_, source]| self.sources.push(*source));
        }
    }

    fn end(&mut self, outline: Outline) {
        self.list.push(outline);
        self.rings.end();
        self.sources.end();
    }

    /// The facets of all outlines with an area, in their order.
    pub(super) fn facets(&self, points: &PointSet) -> Result<Vec<Facet<'_>>, BooleanError> {
        let mut facets = Vec::with_capacity(self.list.len());
        for (outline, (rings, sources)) in self.list.iter().zip(self.rings.iter().zip(self.sources.iter())) {
            goes_on(rings.corners.len())?;
            facets.extend(Facet::of(points, *outline, rings, sources));
        }
        Ok(facets)
    }
}

fn is_planar(face: &FaceRef<'_>, points: &PointSet, numbers: &[u32], normal: DVec3) -> bool {
    let range = face.corner_range();
    let at = |corner: usize| points.at[numbers[face.mesh.corners()[corner] as usize] as usize];
    let from = at(range.start);
    range.len() == 3 || range.clone().all(|corner| (at(corner) - from).dot(normal).abs() <= points.epsilon)
}
