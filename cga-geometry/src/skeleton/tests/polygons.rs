//! Polygons for tests: unions of cells, stars, and polygons given as text.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::super::contact::to_segment;
use super::super::wavefront::twice_area;
use crate::exact::winding;
use crate::mesh::Mesh;
use crate::random::Rng;

/// Loops of points.
#[derive(Clone, Debug)]
pub(crate) struct Polygon {
    pub(crate) points: Vec<DVec2>,
    pub(crate) rings: Vec<Vec<u32>>,
}

impl Polygon {
    pub(crate) fn of(rings: &[&[(f64, f64)]]) -> Self {
        let mut polygon = Polygon { points: Vec::new(), rings: Vec::new() };
        for ring in rings {
            polygon.add(ring.iter().map(|&(x, y)| DVec2::new(x, y)).collect());
        }
        polygon
    }

    fn add(&mut self, ring: Vec<DVec2>) {
        // One position is one point, so that jitter keeps touching corners together.
        let mut number = |p: DVec2| {
            let known = self.points.iter().position(|&q| q == p);
            known.unwrap_or_else(|| {
                self.points.push(p);
                self.points.len() - 1
            }) as u32
        };
        let ring = ring.into_iter().map(&mut number).collect();
        self.rings.push(ring);
    }

    /// A star around the origin, optionally with a hole.
    pub(crate) fn star(rng: &mut Rng, corners: usize, hole: bool) -> Self {
        let mut polygon = Polygon { points: Vec::new(), rings: Vec::new() };
        let mut radial = |low: f64, high: f64| -> Vec<DVec2> {
            (0..corners)
                .map(|i| {
                    let angle = TAU * (i as f64 + 0.8 * rng.unit()) / corners as f64;
                    DVec2::new(libm::cos(angle), libm::sin(angle)) * (low + (high - low) * rng.unit())
                })
                .collect()
        };
        polygon.add(radial(0.5, 1.0));
        if hole && corners > 5 {
            let mut ring = radial(0.1, 0.3);
            ring.reverse();
            polygon.add(ring);
        }
        polygon
    }

    /// A convex polygon with corners at random positions on a circle.
    pub(crate) fn convex(rng: &mut Rng, corners: usize) -> Self {
        let step = TAU / corners as f64;
        let at = |i: usize, by: f64| (i as f64 + 0.7 * by) * step;
        let ring =
            (0..corners).map(|i| at(i, rng.unit())).map(|a| DVec2::new(libm::cos(a), 0.6 * libm::sin(a))).collect();
        let mut polygon = Polygon { points: Vec::new(), rings: Vec::new() };
        polygon.add(ring);
        polygon
    }

    /// The polygon rounded to a lattice of `lines` lines, if the result is still a polygon. This makes many events
    /// simultaneous.
    pub(crate) fn rounded(&self, lines: f64) -> Self {
        let rings =
            self.rings.iter().map(|ring| ring.iter().map(|&p| (self.points[p as usize] * lines).round() / lines));
        let rings: Vec<Vec<DVec3>> = rings.map(|ring| ring.map(|p| p.extend(0.0)).collect()).collect();
        let Ok(mesh) = Mesh::from_polygon(&rings[0], &rings[1..]) else { return self.clone() };
        if mesh.face(0).normal().z < 0.0 {
            return self.clone();
        }
        let points = mesh.points().iter().map(|p| p.truncate()).collect();
        Polygon { points, rings: mesh.face(0).loops().map(<[u32]>::to_vec).collect() }
    }

    pub(crate) fn mirrored(&self) -> Self {
        let points = self.points.iter().map(|p| DVec2::new(-p.x, p.y)).collect();
        Polygon { points, rings: self.inverted().rings }
    }

    fn edges(&self) -> impl Iterator<Item = [DVec2; 2]> {
        let at = |ring: &[u32], i: usize| self.points[ring[i % ring.len()] as usize];
        self.rings.iter().flat_map(move |ring| (0..ring.len()).map(move |i| [at(ring, i), at(ring, i + 1)]))
    }

    /// Returns true if a point is inside an outline and in no hole, for any winding.
    pub(crate) fn holds(&self, p: DVec2) -> bool {
        self.rings.iter().filter(|ring| holds(&self.points, ring, p)).count() % 2 == 1
    }

    /// The distance of a point from the outline.
    pub(crate) fn distance(&self, p: DVec2) -> f64 {
        self.edges().map(|[a, b]| to_segment(p, a, b)).fold(f64::INFINITY, f64::min).sqrt()
    }

    /// The speed of the fastest corner that is not convex, relative to the speed of edges.
    pub(crate) fn sharpest(&self) -> f64 {
        let mut most: f64 = 1.0;
        for ring in &self.rings {
            let at = |i: usize| self.points[ring[i % ring.len()] as usize];
            for i in 0..ring.len() {
                let [a, b] = [at(i + 1) - at(i), at(i + 2) - at(i + 1)].map(DVec2::normalize);
                if a.perp_dot(b) < 0.0 {
                    most = most.max(2.0 / (a + b).length());
                }
            }
        }
        most
    }

    /// The area of a convex polygon after all edges have moved inwards, computed by cuts with one edge after the other.
    pub(crate) fn clipped(&self, distance: f64) -> f64 {
        let mut rest: Vec<DVec2> = self.points.clone();
        for [a, b] in self.edges() {
            let normal = (b - a).normalize().perp();
            let height = |p: DVec2| normal.dot(p - a) - distance;
            let old = std::mem::take(&mut rest);
            for (i, &p) in old.iter().enumerate() {
                let q = old[(i + 1) % old.len()];
                if 0.0 <= height(p) {
                    rest.push(p);
                }
                if (height(p) < 0.0) != (height(q) < 0.0) {
                    rest.push(p.lerp(q, height(p) / (height(p) - height(q))));
                }
            }
        }
        let ring: Vec<u32> = (0..rest.len() as u32).collect();
        if ring.len() < 3 { 0.0 } else { 0.5 * twice_area(&rest, &ring) }
    }

    /// The area of a convex polygon that has grown: its own area, a rectangle per edge, a kite per corner.
    pub(crate) fn mitred(&self, distance: f64) -> f64 {
        let ring = &self.rings[0];
        let at = |i: usize| self.points[ring[i % ring.len()] as usize];
        let mut area = 0.5 * twice_area(&self.points, ring);
        for i in 0..ring.len() {
            let (a, b) = (at(i + 1) - at(i), at(i + 2) - at(i + 1));
            let turn = libm::atan2(a.perp_dot(b), a.dot(b));
            area += a.length() * distance + distance * distance * libm::tan(turn / 2.0);
        }
        area
    }

    /// The region outside: the reversed loops.
    pub(crate) fn inverted(&self) -> Self {
        let mut polygon = self.clone();
        polygon.rings.iter_mut().for_each(|ring| ring.reverse());
        polygon
    }

    pub(crate) fn turned(&self, angle: f64, away: f64) -> Self {
        let turn = DVec2::new(libm::cos(angle), libm::sin(angle));
        let map = |p: &DVec2| turn.rotate(*p) + DVec2::splat(away);
        Polygon { points: self.points.iter().map(map).collect(), rings: self.rings.clone() }
    }

    pub(crate) fn jittered(&self, by: f64, rng: &mut Rng) -> Self {
        let mut polygon = self.clone();
        polygon.points.iter_mut().for_each(|p| *p += (DVec2::new(rng.unit(), rng.unit()) - 0.5) * by);
        polygon
    }
}

/// Returns true if a loop winds around a point.
pub(crate) fn holds(points: &[DVec2], ring: &[u32], p: DVec2) -> bool {
    let ring: Vec<DVec2> = ring.iter().map(|&i| points[i as usize]).collect();
    winding(&ring, p).is_some_and(|turns| turns != 0)
}

/// Cells of a chessboard.
#[derive(Clone, Debug)]
pub(crate) struct Cells {
    size: i32,
    full: Vec<bool>,
}

impl Cells {
    pub(crate) fn random(rng: &mut Rng, size: i32) -> Self {
        let share = 0.3 + 0.6 * rng.unit();
        let full = (0..size * size).map(|_| rng.unit() < share).collect();
        Cells { size, full }
    }

    fn at(&self, x: i32, y: i32) -> bool {
        (0..self.size).contains(&x) && (0..self.size).contains(&y) && self.full[(y * self.size + x) as usize]
    }

    /// The outline of the cells, with corners at turns. Outlines touch where cells meet only at a corner.
    pub(crate) fn polygon(&self) -> Polygon {
        let mut edges: Vec<[(i32, i32); 2]> = Vec::new();
        for y in 0..self.size {
            for x in 0..self.size {
                if self.at(x, y) {
                    let c = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
                    let around = [(x, y - 1), (x + 1, y), (x, y + 1), (x - 1, y)];
                    (0..4)
                        .filter(|&i| !self.at(around[i].0, around[i].1))
                        .for_each(|i| edges.push([c[i], c[(i + 1) % 4]]));
                }
            }
        }
        let mut polygon = Polygon { points: Vec::new(), rings: Vec::new() };
        while let Some(start) = edges.pop() {
            let mut ring = vec![start];
            while ring[ring.len() - 1][1] != start[0] {
                let last = ring[ring.len() - 1];
                let along = (last[1].0 - last[0].0, last[1].1 - last[0].1);
                // Left, straight, right: a corner that is visited twice is passed on the inner side.
                let turns = [(-along.1, along.0), along, (along.1, -along.0)];
                let next = turns.iter().find_map(|turn| {
                    edges.iter().position(|e| e[0] == last[1] && (e[1].0 - e[0].0, e[1].1 - e[0].1) == *turn)
                });
                ring.push(edges.swap_remove(next.expect("loops close")));
            }
            let along = |e: &[(i32, i32); 2]| (e[1].0 - e[0].0, e[1].1 - e[0].1);
            let count = ring.len();
            let corners = (0..count).filter(|&i| along(&ring[i]) != along(&ring[(i + count - 1) % count]));
            let ring: Vec<DVec2> =
                corners.map(|i| DVec2::new(f64::from(ring[i][0].0), f64::from(ring[i][0].1))).collect();
            polygon.add(ring);
        }
        polygon
    }

    /// The area after `eighths` eighths, counted on a raster. For the region outside, the negative of the area that
    /// does not remain.
    pub(crate) fn eroded(&self, eighths: usize, outside: bool) -> f64 {
        let (e, margin) = (eighths as i32, 2);
        let cell = |v: i32| v.div_euclid(8);
        let full = |x: i32, y: i32| self.at(cell(x), cell(y)) != outside;
        let (low, high) = (-8 * margin, 8 * (self.size + margin));
        let side = (high - low + 2 * e) as usize;
        let mut rows = vec![false; side * side];
        let index = |x: i32, y: i32| (y - low + e) as usize * side + (x - low + e) as usize;
        for y in low - e..high + e {
            for x in low..high {
                rows[index(x, y)] = (x - e..=x + e).all(|x| full(x, y));
            }
        }
        let mut count = 0;
        for y in low..high {
            for x in low..high {
                let is_left = (y - e..=y + e).all(|y| rows[index(x, y)]);
                count += if outside { -i32::from(!is_left) } else { i32::from(is_left) };
            }
        }
        f64::from(count) / 64.0
    }
}
