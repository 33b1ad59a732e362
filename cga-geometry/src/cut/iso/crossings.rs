//! Crossings of edges with lines. An edge owns its crossings: the first face that needs them makes them, the other
//! faces find them.

use glam::DVec3;

use super::coordinate::Coordinate;
use super::sites::Sites;
use crate::cut::class::ClassRange;
use crate::cut::edges::Edges;
use crate::cut::points::{Location, PieceCorner};
use crate::cut::segment::{Segment, comes_first};
use crate::each::Each;
use crate::mesh::Mesh;
use crate::origin::PointOrigin;

/// All crossings of a cut. They are numbered after the points of the mesh.
pub(super) struct Crossings {
    pub(super) coordinate: Coordinate,
    /// The lines within the range of the mesh.
    pub(super) lines: Vec<f64>,
    /// The positions of crossings.
    pub(super) points: Vec<DVec3>,
    /// The relative positions of crossings on their edges, from the lexicographically first end.
    shares: Vec<f64>,
    /// The points of the mesh between which crossings are, from the lexicographically first. Kept only for meshes that
    /// need origins.
    pub(super) ends: Vec<[u32; 2]>,
    /// For each edge between sites the first of its crossings, which is on the lowest line.
    edges: Edges,
    /// The number of the first crossing.
    base: u32,
}

impl Crossings {
    pub(super) fn new(coordinate: Coordinate, lines: Vec<f64>, sites: usize, points: usize) -> Self {
        let mut edges = Edges::default();
        edges.reset(sites);
        Crossings {
            coordinate,
            lines,
            points: Vec::new(),
            shares: Vec::new(),
            ends: Vec::new(),
            edges,
            base: points as u32,
        }
    }

    /// Appends the crossings of the edge from one corner to another, in the order along the edge.
    pub(super) fn cross(
        &mut self,
        mesh: &Mesh,
        sites: &Sites,
        from: PieceCorner,
        to: PieceCorner,
        nodes: &mut Vec<PieceCorner>,
    ) {
        let lines = ClassRange::between(from.class(), to.class()).planes();
        if lines.is_empty() {
            return;
        }
        let rises = from.class() < to.class();
        let [from, to] = [from, to].each(|corner| corner.from as usize);
        let (number, new) = self.edges.entry(sites.site(from), sites.site(to), self.points.len() as u32);
        let at = |corner: usize| mesh.points[mesh.corners[corner] as usize];
        if new {
            let ends = [from, to].each(|corner| (at(corner), sites.value(corner)));
            let segment = Segment::between(ends[0], ends[1]);
            for line in lines.clone() {
                let (point, share) = segment.meet(self.lines[line as usize]);
                self.points.push(point + 0.0);
                self.shares.push(share);
            }
            if mesh.needs_origins() {
                let ends = if comes_first(at(from), at(to)) { [from, to] } else { [to, from] };
                let ends = ends.each(|corner| mesh.corners[corner]);
                self.ends.extend(lines.clone().map(|_| ends));
            }
        }
        // The values of corners are interpolated from the same end as the position.
        let [first, last] = if comes_first(at(from), at(to)) { [from, to] } else { [to, from] };
        let (first_line, first_crossing) = (lines.start, self.base + number);
        let node = |line: u32| {
            let place = Location::on(line, first_crossing + (line - first_line));
            PieceCorner { place, from: first as u32, to: last as u32 }
        };
        if rises {
            nodes.extend(lines.map(node));
        } else {
            nodes.extend(lines.rev().map(node));
        }
    }

    /// The origin of a point of the mesh or of a crossing.
    pub(super) fn origin(&self, point: u32) -> PointOrigin {
        let Some(crossing) = point.checked_sub(self.base) else { return PointOrigin::Old(point) };
        let found = self.ends.get(crossing as usize).zip(self.shares.get(crossing as usize));
        found.map_or(PointOrigin::New, |(ends, share)| PointOrigin::Between { ends: *ends, share: *share })
    }

    /// The relative position of a crossing on its edge.
    pub(super) fn share(&self, place: Location) -> f64 {
        self.shares[(place.number - self.base) as usize]
    }

    /// The position of a corner of a piece.
    pub(super) fn position(&self, mesh: &Mesh, number: u32) -> DVec3 {
        match number.checked_sub(self.base) {
            Some(crossing) => self.points[crossing as usize],
            None => mesh.points[number as usize],
        }
    }
}
