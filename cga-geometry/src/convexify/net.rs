//! The corners of a mesh as linked loops, which can be cut and divided.

use glam::DVec3;

use crate::derive::Mix;
use crate::each::Each;
use crate::mesh::Mesh;
use crate::origin::PointOrigin;

/// The corners of a mesh, linked to loops. The half-edge that starts at a corner has the number of the corner.
pub(super) struct Net {
    /// The mesh, with further points, and with corners that are in none of its faces.
    pub(super) pool: Mesh,
    next: Vec<u32>,
    before: Vec<u32>,
    /// The next half-edge between the same two points, in a circle.
    mates: Vec<u32>,
    /// True for the sides of cuts.
    cuts: Vec<bool>,
    /// The number of points of the mesh, and the origins of the others.
    old_points: usize,
    origins: Vec<PointOrigin>,
    /// The divisions of edges of the mesh since the last mark: for each half-edge the corner behind it.
    divisions: Vec<Vec<[u32; 2]>>,
}

impl Net {
    pub(super) fn of(mesh: &Mesh) -> Self {
        let adjacency = mesh.adjacency();
        let corners = mesh.corners().len() as u32;
        let mut mates: Vec<u32> = (0..corners).collect();
        for edge in 0..adjacency.edge_count() {
            link(&mut mates, adjacency.uses(edge));
        }
        Net {
            pool: mesh.clone(),
            next: (0..corners).map(|corner| adjacency.next(corner)).collect(),
            before: (0..corners).map(|corner| adjacency.before(corner)).collect(),
            mates,
            cuts: vec![false; corners as usize],
            old_points: mesh.points().len(),
            origins: Vec::new(),
            divisions: Vec::new(),
        }
    }

    pub(super) fn corner_count(&self) -> usize {
        self.next.len()
    }

    pub(super) fn next(&self, corner: u32) -> u32 {
        self.next[corner as usize]
    }

    pub(super) fn before(&self, corner: u32) -> u32 {
        self.before[corner as usize]
    }

    /// The half-edge on the other side of a cut.
    pub(super) fn mate(&self, half: u32) -> u32 {
        self.mates[half as usize]
    }

    /// Returns true for a side of a cut.
    pub(super) fn is_cut(&self, half: u32) -> bool {
        self.cuts[half as usize]
    }

    pub(super) fn point(&self, corner: u32) -> u32 {
        self.pool.corners[corner as usize]
    }

    pub(super) fn position(&self, corner: u32) -> DVec3 {
        self.pool.points[self.point(corner) as usize]
    }

    /// The corners of a loop.
    pub(super) fn ring(&self, head: u32) -> impl Iterator<Item = u32> + '_ {
        let after = move |&corner: &u32| Some(self.next(corner)).filter(|&next| next != head);
        std::iter::successors(Some(head), after)
    }

    /// The position on a half-edge, at a share of its length.
    pub(super) fn along(&self, half: u32, share: f64) -> DVec3 {
        self.position(half).lerp(self.position(self.next(half)), share)
    }

    /// The origin of a point in the mesh.
    pub(super) fn origin(&self, point: u32) -> PointOrigin {
        match (point as usize).checked_sub(self.old_points) {
            None => PointOrigin::Old(point),
            Some(new) => self.origins[new],
        }
    }

    /// The origin of a new point on a half-edge.
    fn origin_along(&self, half: u32, share: f64) -> PointOrigin {
        if self.is_cut(half) {
            return PointOrigin::New;
        }
        let [from, to] = [half, self.next(half)].each(|corner| self.origin(self.point(corner)));
        // The whole edge on which this part is.
        let all = [from.ends(), to.ends()].concat();
        let (Some(&low), Some(&high)) = (all.iter().min(), all.iter().max()) else { return PointOrigin::New };
        let place = |point: PointOrigin| match point {
            PointOrigin::Between { ends: [a, _], share } if a == low => share,
            PointOrigin::Between { share, .. } => 1.0 - share,
            other => f64::from(u8::from(other.ends()[0] == high)),
        };
        let (from, to) = (place(from), place(to));
        PointOrigin::Between { ends: [low, high], share: from + (to - from) * share }
    }

    /// Divides an edge in all loops that have it. Returns the new corner in the loop of `half`.
    pub(super) fn divide(&mut self, half: u32, share: f64) -> u32 {
        let start = self.point(half);
        self.origins.push(self.origin_along(half, share));
        let point = self.pool.add_point(self.along(half, share));
        let after = |&other: &u32| Some(self.mate(other)).filter(|&next| next != half);
        let all: Vec<u32> = std::iter::successors(Some(half), after).collect();
        let (mut near, mut far) = (Vec::with_capacity(all.len()), Vec::with_capacity(all.len()));
        let mut own = half;
        let mut division = Vec::with_capacity(all.len());
        for other in all {
            let along = self.point(other) == start;
            let corner = self.insert(other, point, if along { share } else { 1.0 - share });
            if other == half {
                own = corner;
            }
            division.push([other, corner]);
            let (to_start, to_end) = if along { (other, corner) } else { (corner, other) };
            near.push(to_start);
            far.push(to_end);
        }
        link(&mut self.mates, &near);
        link(&mut self.mates, &far);
        if !self.is_cut(half) {
            self.divisions.push(division);
        }
        own
    }

    /// Forgets the divisions of edges, so that they stay.
    pub(super) fn mark(&mut self) {
        self.divisions.clear();
    }

    /// Undoes the divisions of edges since the last mark. No cut ends there any more.
    pub(super) fn join_divided(&mut self) {
        while let Some(division) = self.divisions.pop() {
            division.iter().for_each(|&[half, corner]| self.chain(half, self.next(corner)));
            link(&mut self.mates, &division.iter().map(|pair| pair[0]).collect::<Vec<_>>());
        }
    }

    /// Adds a corner after another one, with values between the values of its neighbours.
    fn insert(&mut self, from: u32, point: u32, share: f64) -> u32 {
        let to = self.next(from);
        self.pool.corners.push(point);
        self.pool.add_own_mixed(&Mix::Two([from, to], share));
        let corner = self.add(self.cuts[from as usize]);
        self.chain(from, corner);
        self.chain(corner, to);
        corner
    }

    /// Adds a corner with the point and the values of another one. A cut begins there.
    fn copy(&mut self, corner: u32) -> u32 {
        self.pool.corners.push(self.pool.corners[corner as usize]);
        self.pool.add_own_mixed(&Mix::One(corner));
        self.add(true)
    }

    /// Adds a corner whose values were added, without links.
    fn add(&mut self, is_cut: bool) -> u32 {
        let corner = self.next.len() as u32;
        self.before.push(corner);
        self.next.push(corner);
        self.mates.push(corner);
        self.cuts.push(is_cut);
        corner
    }

    /// Cuts from a corner to another one that is not its neighbour. Returns the new half-edges at the first and at the second
    /// corner. The old corners keep the half-edges that start there.
    pub(super) fn cut(&mut self, a: u32, b: u32) -> [u32; 2] {
        let [to_a, to_b] = [a, b].each(|corner| self.before(corner));
        let [from_a, from_b] = [a, b].each(|corner| self.copy(corner));
        self.chain(to_a, from_a);
        self.chain(from_a, b);
        self.chain(to_b, from_b);
        self.chain(from_b, a);
        link(&mut self.mates, &[from_a, from_b]);
        [from_a, from_b]
    }

    /// Removes an edge between two faces, or two sides of one face. A corner at which only this edge ends is in no loop
    /// afterwards.
    pub(super) fn remove(&mut self, half: u32) {
        let other = self.mate(half);
        let [to_half, to_other] = [half, other].each(|half| self.before(half));
        let [after_half, after_other] = [half, other].each(|half| self.next(half));
        if after_other != half {
            self.chain(to_half, after_other);
        }
        if after_half != other {
            self.chain(to_other, after_half);
        }
    }

    /// Returns true for a corner in a loop.
    pub(super) fn is_alive(&self, corner: u32) -> bool {
        self.before(self.next(corner)) == corner && self.next(self.before(corner)) == corner
    }

    /// Gives each first corner the incoming half-edge that the second one has.
    pub(super) fn exchange(&mut self, pairs: &[[u32; 2]]) {
        let incoming: Vec<u32> = pairs.iter().map(|&[_, from]| self.before(from)).collect();
        pairs.iter().zip(incoming).for_each(|(&[to, _], half)| self.chain(half, to));
    }

    /// Makes a corner the next one of another corner.
    pub(super) fn chain(&mut self, from: u32, to: u32) {
        self.next[from as usize] = to;
        self.before[to as usize] = from;
    }

    /// Makes a triangle of corners. Each is a corner, and whether its half-edge keeps its number; otherwise a cut begins at a copy of
    /// the corner. Returns the corners of the new loop.
    pub(super) fn ring_of(&mut self, corners: &[(u32, bool); 3]) -> [u32; 3] {
        let ring = corners.each(|(corner, keeps)| if keeps { corner } else { self.copy(corner) });
        (0..3).for_each(|k| self.chain(ring[k], ring[(k + 1) % 3]));
        ring
    }

    /// Makes two half-edges the two sides of one edge.
    pub(super) fn join(&mut self, a: u32, b: u32) {
        link(&mut self.mates, &[a, b]);
    }
}

/// Makes a circle of some half-edges.
fn link(mates: &mut [u32], circle: &[u32]) {
    for (k, &half) in circle.iter().enumerate() {
        mates[half as usize] = circle[(k + 1) % circle.len()];
    }
}
