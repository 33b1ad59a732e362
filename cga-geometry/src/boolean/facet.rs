//! Facets: the planar faces of an arrangement.

use glam::{DVec2, DVec3};

use super::operation::BooleanError;
use super::point_set::PointSet;
use super::progress::goes_on;
use super::rim::{MOST_WITHOUT_TREE, RimTree};
use crate::each::Each;
use crate::exact::orient;
use crate::mesh::{Bounds, FaceRef, Mesh, unit};
use crate::triangulate::{PlaneProjection, Triangulator};

/// A planar polygon with holes: a face of the mesh, or a triangle of a bent face.
pub(super) struct Facet {
    /// The face of the mesh.
    pub(super) face: u32,
    /// True if it is only a part of the face.
    pub(super) is_part: bool,
    pub(super) origin: DVec3,
    pub(super) normal: DVec3,
    pub(super) projection: PlaneProjection,
    /// The points of the outline and the holes.
    pub(super) corners: Vec<u32>,
    /// For each corner the corner of the mesh. In increasing order, except in a part of a face.
    pub(super) sources: Vec<u32>,
    /// The end of each loop in `corners`.
    pub(super) ends: Vec<u32>,
    /// The bounding box, which is larger by epsilon on all sides.
    pub(super) bounds: Bounds,
    pub(super) is_convex: bool,
    /// The edges in its plane.
    pub(super) lines: Vec<u32>,
    /// A tree of the loops' edges, if there are many.
    pub(super) rim_tree: Option<RimTree>,
}

impl Facet {
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

    /// The ranges of the loops in `corners`.
    pub(super) fn loops(&self) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, end)| start as usize..*end as usize)
    }

    /// The edges of the loops, as the numbers of their corners.
    pub(super) fn rim(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.loops().flat_map(|ring| {
            let (start, end) = (ring.start, ring.end);
            ring.map(move |corner| [corner, if corner + 1 == end { start } else { corner + 1 }])
        })
    }

    /// The corners of the mesh at both ends of the edge of the loops that starts at a corner.
    pub(super) fn edge_sources(&self, corner: u32) -> [u32; 2] {
        let ring = self.ends.partition_point(|end| *end <= corner);
        let start = if ring == 0 { 0 } else { self.ends[ring - 1] };
        let next = if corner + 1 == self.ends[ring] { start } else { corner + 1 };
        [corner, next].each(|corner| self.sources[corner as usize])
    }

    /// The point at a corner of the mesh, if that is a corner of the facet.
    pub(super) fn point_at(&self, source: u32) -> Option<u32> {
        // Only triangles of bent faces have their corners in another order.
        let place = match self.is_part {
            true => self.sources.iter().position(|known| *known == source),
            false => self.sources.binary_search(&source).ok(),
        };
        place.map(|place| self.corners[place])
    }

    /// The places of an edge of the loops in the facet's plane.
    fn flat_edge(&self, points: &PointSet, edge: [usize; 2]) -> [DVec2; 2] {
        edge.each(|corner| self.flat(points.at[self.corners[corner] as usize]))
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
                self.rim().for_each(&mut pass);
                self.corners.len()
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
        self.rim().map(distance).fold(f64::INFINITY, f64::min)
    }

    fn of(points: &PointSet, face: u32, is_part: bool, normal: DVec3, rings: &[Vec<[u32; 2]>]) -> Option<Facet> {
        let (mut corners, mut sources, mut ends) = (Vec::new(), Vec::new(), Vec::new());
        for ring in rings {
            let start = corners.len();
            for [point, source] in ring {
                if corners.len() == start || corners.last() != Some(point) {
                    corners.push(*point);
                    sources.push(*source);
                }
            }
            while start + 1 < corners.len() && corners[start] == corners[corners.len() - 1] {
                corners.pop();
                sources.pop();
            }
            if corners.len() < start + 3 {
                corners.truncate(start);
                sources.truncate(start);
            } else {
                ends.push(corners.len() as u32);
            }
        }
        let origin = points.at[*corners.first()? as usize];
        let box_of = Bounds::of(corners.iter().map(|point| points.at[*point as usize]));
        let bounds = Bounds { low: box_of.low - points.epsilon, high: box_of.high + points.epsilon };
        let projection = PlaneProjection::along(normal);
        let mut facet = Facet {
            face,
            is_part,
            origin,
            normal,
            projection,
            corners,
            sources,
            ends,
            bounds,
            is_convex: false,
            lines: Vec::new(),
            rim_tree: None,
        };
        facet.is_convex = facet.find_convex(points);
        let around: f64 = facet.rim().map(|edge| points.length(edge.each(|corner| facet.corners[corner]))).sum();
        if facet.double_area(points).abs() <= points.epsilon * around {
            return None;
        }
        if MOST_WITHOUT_TREE < facet.corners.len() {
            let at = |corner: usize| facet.flat(points.at[facet.corners[corner] as usize]);
            facet.rim_tree = Some(RimTree::new(facet.rim().collect(), at, points.epsilon));
        }
        Some(facet)
    }

    /// Twice the area in projection.
    pub(super) fn double_area(&self, points: &PointSet) -> f64 {
        let from = self.flat(self.origin);
        self.rim().map(|edge| self.flat_edge(points, edge)).map(|[a, b]| (a - from).perp_dot(b - from)).sum()
    }

    /// A facet of the same plane without an outline and without lines.
    pub(super) fn without_outline(&self) -> Self {
        let Facet { face, is_part, origin, normal, projection, bounds, .. } = *self;
        Facet {
            face,
            is_part,
            origin,
            normal,
            projection,
            corners: Vec::new(),
            sources: Vec::new(),
            ends: Vec::new(),
            bounds,
            is_convex: false,
            lines: Vec::new(),
            rim_tree: None,
        }
    }

    /// Returns true if the outline turns left at every corner and only once around.
    fn find_convex(&self, points: &PointSet) -> bool {
        let count = self.corners.len();
        if self.ends.len() != 1 {
            return false;
        }
        let at = |corner: usize| self.flat(points.at[self.corners[corner % count] as usize]);
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

/// The facets of all faces with an area, in their order. `numbers` gives the point of the arrangement for each point of the
/// mesh.
pub(super) fn facets_of(mesh: &Mesh, points: &PointSet, numbers: &[u32]) -> Result<Vec<Facet>, BooleanError> {
    let (mut facets, mut triangulator, mut triangles) = (Vec::new(), Triangulator::new(), Vec::new());
    for face in mesh.faces() {
        goes_on(FACET * face.corner_count())?;
        let corner = |corner: usize| [numbers[mesh.corners()[corner] as usize], corner as u32];
        let normal = face.normal();
        if is_planar(&face, points, numbers, normal) {
            let rings: Vec<Vec<[u32; 2]>> = face.loop_ranges().map(|ring| ring.map(corner).collect()).collect();
            facets.extend(Facet::of(points, face.index() as u32, false, normal, &rings));
            continue;
        }
        triangles.clear();
        triangulator.face(mesh, face.index(), &mut triangles);
        for triangle in &triangles {
            let ring = triangle.each(|number| corner(number as usize));
            let [a, b, c] = ring.each(|[point, _]| points.at[point as usize]);
            let normal = unit((b - a).cross(c - a));
            facets.extend(Facet::of(points, face.index() as u32, true, normal, &[ring.to_vec()]));
        }
    }
    Ok(facets)
}

fn is_planar(face: &FaceRef<'_>, points: &PointSet, numbers: &[u32], normal: DVec3) -> bool {
    let range = face.corner_range();
    let at = |corner: usize| points.at[numbers[face.mesh.corners()[corner] as usize] as usize];
    let from = at(range.start);
    range.len() == 3 || range.clone().all(|corner| (at(corner) - from).dot(normal).abs() <= points.epsilon)
}
