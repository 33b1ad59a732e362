//! Triangles whose edges collapse.

use glam::DVec3;

use super::PASS;
use super::quadric::Quadric;
use crate::each::Each;
use crate::mesh::pair_table::PairTable;
use crate::mesh::{FaceTag, Mesh, unit};
use crate::small_sort::SmallSort;
use crate::triangulate::Triangulator;
use crate::work;

/// Vertices with more triangles are not removed.
const MOST_AROUND: u32 = 64;

/// The cosine of the largest angle by which a collapse may turn a triangle.
const LEAST_COSINE: f64 = 0.2;

/// The cosine of the largest angle between two sides of a fold.
const FOLD_COSINE: f64 = 0.99;

/// The weight of the planes that keep borders and seams, relative to the weight of the planes of triangles.
const BORDER_WEIGHT: f64 = 8.0;

/// The weight of the length of an edge: of edges in a plane the shortest one collapses first.
const LENGTH_WEIGHT: f64 = 1e-9;

/// The mean of squared distances from planes, in a mesh with an extent of about 1, that is a rounding error.
const FLAT_ERROR: f64 = 1e-14;

/// The lowest bits of costs, which are rounded. They are a share of 1e-6, some million times the rounding errors, so that equal
/// costs are hardly ever rounded to different numbers.
const COST_BITS: u32 = 32;

/// Twice the area below which a triangle of a mesh with an extent of about 1 has no direction.
const NO_AREA: f64 = 1e-14;

pub(super) struct Surface<'m> {
    mesh: &'m Mesh,
    /// The points, scaled to an extent of about 1.
    places: Vec<DVec3>,
    /// The points of each triangle, and the corners of the mesh whose values it has there.
    points: Vec<[u32; 3]>,
    values: Vec<[u32; 3]>,
    /// The face of each triangle.
    faces: Vec<u32>,
    /// The range of the triangles of each face.
    ends: Vec<u32>,
    is_alive: Vec<bool>,
    is_changed: Vec<bool>,
    /// The triangles at each point. Some may be gone.
    around: Vec<Vec<u32>>,
    /// The number of triangles at each point that are left.
    counts: Vec<u32>,
    /// The number of triangles at each edge.
    edges: PairTable,
    /// True for points that stay, because the surface is not one sheet there.
    is_locked: Vec<bool>,
    is_border: Vec<bool>,
    quadrics: Vec<Quadric>,
    /// True if all faces have the same attributes, and no texture.
    is_plain: bool,
}

impl<'m> Surface<'m> {
    /// The triangles of a mesh; `None` if the work is to end.
    pub(super) fn of(mesh: &'m Mesh) -> Option<Self> {
        let (count, bounds) = (mesh.points.len(), mesh.bounds());
        let scale = bounds.scale_to_one();
        let (mut triangulator, mut values) = (Triangulator::new(), Vec::new());
        let (mut faces, mut ends) = (Vec::new(), Vec::with_capacity(mesh.face_count()));
        let mut is_locked = vec![false; count];
        for face in 0..mesh.face_count() {
            if !work::spend(PASS * mesh.face_corners(face).len()) {
                return None;
            }
            let before = values.len();
            triangulator.steady_face(mesh, face, &mut values);
            faces.resize(values.len(), face as u32);
            ends.push(values.len() as u32);
            if values.len() == before {
                mesh.corners[mesh.face_corners(face)].iter().for_each(|&point| is_locked[point as usize] = true);
            }
        }
        let points: Vec<[u32; 3]> =
            values.iter().map(|corners: &[u32; 3]| corners.each(|corner| mesh.corners[corner as usize])).collect();
        let edges = PairTable::with_capacity(points.len() * 2);
        // A large table takes long to make.
        if !work::spend(PASS * points.len()) {
            return None;
        }
        let is_alike = mesh.faces().all(|face| attributes(face.tag()) == attributes(mesh.tags[0]));
        let mut surface = Surface {
            mesh,
            places: mesh.points.iter().map(|&point| point * scale - bounds.low * scale).collect(),
            faces,
            ends,
            is_alive: vec![true; points.len()],
            is_changed: vec![false; mesh.face_count()],
            around: vec![Vec::new(); count],
            counts: vec![0; count],
            edges,
            is_locked,
            is_border: vec![false; count],
            quadrics: vec![Quadric::ZERO; count],
            is_plain: mesh.uvs.is_empty() && is_alike,
            points,
            values,
        };
        (surface.connect() && surface.lock_branches() && surface.weigh()).then_some(surface)
    }

    /// Finds the triangles at each point and each edge. Returns false if the work is to end, as the other passes do.
    fn connect(&mut self) -> bool {
        for (triangle, points) in (0..).zip(&self.points) {
            if !work::spend(PASS) {
                return false;
            }
            for &point in points {
                self.around[point as usize].push(triangle);
                self.counts[point as usize] += 1;
            }
            edges(points).for_each(|ends| *self.edges.entry(ends[0], ends[1], 0).0 += 1);
        }
        true
    }

    fn edge_count(&self, a: u32, b: u32) -> u32 {
        self.edges.get(a.min(b), a.max(b)).unwrap_or(0)
    }

    /// Finds the points at which the surface branches, or changes its side, and those at its border.
    fn lock_branches(&mut self) -> bool {
        let mut directed = PairTable::with_capacity(self.points.len() * 3);
        if !work::spend(PASS * self.points.len()) {
            return false;
        }
        for points in &self.points {
            if !work::spend(PASS) {
                return false;
            }
            for k in 0..3 {
                *directed.entry(points[k], points[(k + 1) % 3], 0).0 += 1;
            }
        }
        for points in &self.points {
            if !work::spend(PASS) {
                return false;
            }
            for k in 0..3 {
                let [a, b] = [points[k], points[(k + 1) % 3]];
                let ends = [a, b].each(|point| point as usize);
                if self.edge_count(a, b) == 1 {
                    ends.into_iter().for_each(|end| self.is_border[end] = true);
                }
                if 1 < directed.get(a, b).unwrap_or(0) || 2 < self.edge_count(a, b) {
                    ends.into_iter().for_each(|end| self.is_locked[end] = true);
                }
            }
        }
        let mut ends: Vec<(u32, u32)> = Vec::new();
        for point in 0..self.around.len() {
            // Fans around a point are connected by their edges there.
            let triangles = &self.around[point];
            if !work::spend(PASS * (1 + triangles.len())) {
                return false;
            }
            let others =
                |triangle: u32| self.points[triangle as usize].into_iter().filter(|&other| other as usize != point);
            ends.clear();
            ends.extend(
                (0..).zip(triangles).flat_map(|(place, &triangle)| others(triangle).map(move |end| (end, place))),
            );
            ends.small_sort();
            let mut fans = crate::disjoint::DisjointSets::new(triangles.len());
            ends.windows(2).filter(|pair| pair[0].0 == pair[1].0).for_each(|pair| fans.unite(pair[0].1, pair[1].1));
            self.is_locked[point] |= (0..triangles.len() as u32).any(|place| fans.find_and_shorten(place) != 0);
        }
        true
    }

    /// Gives points the quadrics of their triangles, and of planes that keep borders and seams.
    fn weigh(&mut self) -> bool {
        for triangle in 0..self.points.len() {
            if !work::spend(PASS) {
                return false;
            }
            let points = self.points[triangle];
            let [a, b, c] = points.each(|point| self.places[point as usize]);
            let area = (b - a).cross(c - a);
            let normal = unit(area);
            let own = Quadric::of_plane(normal, a, 0.5 * area.length());
            points.into_iter().for_each(|point| self.quadrics[point as usize] += own);
            for k in 0..3 {
                let ends = [points[k], points[(k + 1) % 3]];
                if !self.is_seam(triangle, ends) {
                    continue;
                }
                let [from, to] = ends.each(|point| self.places[point as usize]);
                let across = unit((to - from).cross(normal));
                let keep = Quadric::of_plane(across, from, BORDER_WEIGHT * from.distance_squared(to));
                ends.into_iter().for_each(|point| self.quadrics[point as usize] += keep);
            }
        }
        true
    }

    /// Returns true for an edge of a triangle at a border, or with other values on its other side.
    fn is_seam(&self, triangle: usize, ends: [u32; 2]) -> bool {
        if self.edge_count(ends[0], ends[1]) != 2 {
            return true;
        }
        if self.is_plain {
            return false;
        }
        let [few, other] =
            if self.counts[ends[0] as usize] <= self.counts[ends[1] as usize] { ends } else { [ends[1], ends[0]] };
        let beside = self.around[few as usize]
            .iter()
            .copied()
            .find(|&beside| beside as usize != triangle && self.points[beside as usize].contains(&other));
        let continues = |beside: u32| ends.iter().all(|&end| self.continues(triangle as u32, beside, end));
        !beside.is_some_and(continues)
    }

    fn place_in(&self, triangle: u32, point: u32) -> usize {
        self.points[triangle as usize].iter().position(|&own| own == point).unwrap_or(0)
    }

    /// Returns true if two triangles have the same values at a point, and the same attributes.
    fn continues(&self, one: u32, other: u32, point: u32) -> bool {
        if self.is_plain {
            return true;
        }
        let [a, b] = [one, other].each(|triangle| self.values[triangle as usize][self.place_in(triangle, point)]);
        let tag = |triangle: u32| attributes(self.mesh.tags[self.faces[triangle as usize] as usize]);
        tag(one) == tag(other) && self.mesh.has_same_texture(a, b)
    }

    /// The triangles at a point, which are dropped from its list when they are gone.
    fn triangles(&mut self, point: u32) -> Vec<u32> {
        let (is_alive, points) = (&self.is_alive, &self.points);
        let list = &mut self.around[point as usize];
        list.retain(|&triangle| is_alive[triangle as usize] && points[triangle as usize].contains(&point));
        list.clone()
    }

    /// The points that edges connect to a point, in increasing order.
    pub(super) fn neighbours(&mut self, point: u32) -> Vec<u32> {
        let triangles = self.triangles(point);
        let all = triangles.iter().flat_map(|&triangle| self.points[triangle as usize]);
        let mut near: Vec<u32> = all.filter(|&other| other != point).collect();
        near.small_sort();
        near.dedup();
        near
    }

    /// The neighbour that a point becomes at the least cost; `None` if the point stays.
    pub(super) fn best_target(&mut self, point: u32) -> Option<(f64, u32)> {
        let count = self.counts[point as usize];
        if self.is_locked[point as usize] || count == 0 || MOST_AROUND < count {
            return None;
        }
        let triangles = self.triangles(point);
        let near = self.neighbours(point);
        let from = self.places[point as usize];
        let mut sorted: Vec<(f64, u32)> = near
            .iter()
            .map(|&target| {
                let to = self.places[target as usize];
                let mut sum = self.quadrics[point as usize];
                sum += self.quadrics[target as usize];
                (cost(&sum, from, to), target)
            })
            .collect();
        sorted.small_sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        sorted.into_iter().find(|&(_, target)| self.may_become(point, target, &triangles, &near))
    }

    /// Returns true if an edge can collapse: the surface stays one sheet, no triangle turns over, and texture and attributes of all
    /// triangles continue at the target.
    fn may_become(&self, point: u32, target: u32, triangles: &[u32], near: &[u32]) -> bool {
        let (gone, kept): (Vec<u32>, Vec<u32>) =
            triangles.iter().partition(|&&triangle| self.points[triangle as usize].contains(&target));
        let is_at_border = self.edge_count(point, target) == 1;
        if gone.len() != if is_at_border { 1 } else { 2 } || (self.is_border[point as usize] && !is_at_border) {
            return false;
        }
        let is_common = |other: u32| other != target && 0 < self.edge_count(other, target);
        if near.iter().filter(|&&other| is_common(other)).count() != gone.len() || kept.is_empty() {
            return false;
        }
        kept.iter().all(|&triangle| {
            let points = self.points[triangle as usize];
            let place = self.place_in(triangle, point);
            let [next, last] = [points[(place + 1) % 3], points[(place + 2) % 3]];
            (self.is_plain || gone.iter().any(|&other| self.continues(triangle, other, point)))
                && !self.turns_over([point, next, last], target)
                && !(is_common(next) && is_common(last) && self.has_triangle([target, next, last], triangle))
        }) && !kept.iter().any(|&triangle| self.folds(triangle, point, target, &gone))
    }

    /// Returns true if a triangle is back to back with a neighbour when a point becomes another one, and was not before.
    fn folds(&self, triangle: u32, point: u32, target: u32, gone: &[u32]) -> bool {
        let normal = |triangle: u32, target: u32| {
            let place = |own: u32| self.places[if own == point { target } else { own } as usize];
            let [a, b, c] = self.points[triangle as usize].each(place);
            unit((b - a).cross(c - a))
        };
        let [before, after] = [point, target].each(|target| normal(triangle, target));
        let place = self.place_in(triangle, point);
        let [next, last] = [1, 2].each(|step| self.points[triangle as usize][(place + step) % 3]);
        // The neighbours at all three edges have one of the two other points.
        let near = [next, last].into_iter().filter(|&near| self.counts[near as usize] <= MOST_AROUND);
        near.flat_map(|near| self.around[near as usize].iter().map(move |&other| (near, other))).any(|(near, other)| {
            let points = &self.points[other as usize];
            let is_neighbour = other != triangle
                && self.is_alive[other as usize]
                && points.contains(&near)
                && !gone.contains(&other)
                && [point, target, next, last].iter().any(|end| *end != near && points.contains(end));
            is_neighbour
                && after.dot(normal(other, target)) < -FOLD_COSINE
                && -FOLD_COSINE <= before.dot(normal(other, point))
        })
    }

    /// Returns true if a triangle turns far, or loses its area, when its first point becomes another one.
    fn turns_over(&self, [first, next, last]: [u32; 3], target: u32) -> bool {
        let [from, to, b, c] = [first, target, next, last].each(|point| self.places[point as usize]);
        let [before, after] = [from, to].each(|a| (b - a).cross(c - a));
        let size = before.length();
        NO_AREA < size && before.dot(after) <= (LEAST_COSINE * size * after.length()).max(NO_AREA * size)
    }

    /// Returns true if another triangle has the same points.
    fn has_triangle(&self, points: [u32; 3], except: u32) -> bool {
        let few = points.into_iter().min_by_key(|&point| self.around[point as usize].len()).unwrap_or(points[0]);
        self.around[few as usize].iter().any(|&triangle| {
            let own = &self.points[triangle as usize];
            triangle != except && self.is_alive[triangle as usize] && points.iter().all(|point| own.contains(point))
        })
    }

    /// Makes a point one of its neighbours.
    pub(super) fn collapse(&mut self, point: u32, target: u32) {
        let triangles = self.triangles(point);
        let (gone, kept): (Vec<u32>, Vec<u32>) =
            triangles.iter().partition(|&&triangle| self.points[triangle as usize].contains(&target));
        for &triangle in &kept {
            let model = gone.iter().copied().find(|&other| self.continues(triangle, other, point));
            let place = self.place_in(triangle, point);
            if let Some(model) = model {
                self.values[triangle as usize][place] = self.values[model as usize][self.place_in(model, target)];
            }
        }
        for &triangle in &triangles {
            edges(&self.points[triangle as usize]).for_each(|[a, b]| *self.edges.entry(a, b, 0).0 -= 1);
            self.is_changed[self.faces[triangle as usize] as usize] = true;
        }
        for &triangle in &gone {
            self.is_alive[triangle as usize] = false;
            self.points[triangle as usize].into_iter().for_each(|point| self.counts[point as usize] -= 1);
        }
        for &triangle in &kept {
            let place = self.place_in(triangle, point);
            self.points[triangle as usize][place] = target;
            edges(&self.points[triangle as usize]).for_each(|[a, b]| *self.edges.entry(a, b, 0).0 += 1);
        }
        self.counts[target as usize] += kept.len() as u32;
        self.counts[point as usize] = 0;
        self.around[target as usize].extend(&kept);
        self.around[point as usize] = Vec::new();
        let own = self.quadrics[point as usize];
        self.quadrics[target as usize] += own;
    }

    /// Returns true if a face does not have all its points any more.
    pub(super) fn is_changed(&self, face: usize) -> bool {
        self.is_changed[face]
    }

    /// The triangles that are left of a face: their points, and the corners of the mesh with their values.
    pub(super) fn triangles_of(&self, face: usize) -> impl Iterator<Item = ([u32; 3], [u32; 3])> + '_ {
        let start = if face == 0 { 0 } else { self.ends[face - 1] };
        let all = start as usize..self.ends[face] as usize;
        all.filter(|&triangle| self.is_alive[triangle]).map(|triangle| (self.points[triangle], self.values[triangle]))
    }
}

/// The cost of moving a point to a place. Costs that differ by rounding are equal, so that ties of a turned shape are ties, too.
fn cost(sum: &Quadric, from: DVec3, to: DVec3) -> f64 {
    let error = sum.at(to);
    let error = if error <= FLAT_ERROR * sum.weight { 0.0 } else { error };
    let cost = error + LENGTH_WEIGHT * sum.weight * from.distance_squared(to);
    f64::from_bits((cost.to_bits() + (1 << (COST_BITS - 1))) >> COST_BITS << COST_BITS)
}

/// The group and the material of a face.
fn attributes(tag: FaceTag) -> FaceTag {
    FaceTag { tags: FaceTag::NONE, ..tag.uncapped() }
}

/// The edges of a triangle, with the smaller point first.
fn edges(points: &[u32; 3]) -> impl Iterator<Item = [u32; 2]> + use<> {
    let [a, b, c] = *points;
    [[a, b], [b, c], [c, a]].into_iter().map(|[a, b]| [a.min(b), a.max(b)])
}
