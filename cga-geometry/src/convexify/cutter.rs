//! The cuts of one face.
//!
//! Cuts begin at reflex corners. A cut runs on in the direction of one of the two edges at its corner, to the other side of the
//! face, or joins two reflex corners if it leaves none of them reflex. The shortest possible
//! cut of all corners is made first. A cut that ends inside an edge divides it in all faces that have it.

use std::cell::Cell;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

use glam::DVec2;

use super::net::Net;
use super::obstacles::Obstacles;
use super::plane::Plane;
use super::turn::is_reflex;
use crate::each::Each;
use crate::exact::orient;
use crate::nesting::extent::Extent;
use crate::tol::{ROUNDING_EPSILON, TIE_EPSILON};
use crate::work;

/// The number of reflex corners near a corner that are tried as the other end of a cut, and the number of nodes of the tree
/// that are visited for them.
const PARTNERS: usize = 12;
const VISITED: usize = 48;

/// The number of times that a cut which was found to have another length waits again.
const WAITS: u8 = 16;

/// The limit on boxes of obstacles that are tested, for each corner, and for any face. Faces need some hundred for each corner;
/// many thousands of needles side by side need more.
const TESTS: usize = 1 << 10;
const TESTS_OF_ALL: usize = 1 << 26;

/// A face that is being cut.
pub(super) struct Cutter<'n> {
    net: &'n mut Net,
    plane: Plane,
    /// Ends of cuts that are this near to a corner are at the corner.
    near: f64,
    /// The limit on the length of cuts.
    longest: f64,
    /// All corners of the face.
    pub(super) corners: Vec<u32>,
    /// The points of the face, each with its corners.
    at: BTreeSet<[u32; 2]>,
    obstacles: Obstacles,
    /// The number of boxes of obstacles that may still be tested.
    tests_left: Cell<usize>,
}

/// The end of a cut.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Target {
    Corner(u32),
    /// A half-edge, and a share of its length.
    Edge(u32, f64),
}

/// A cut that waits, the shortest first: its length, the corner where it begins, and how often it waited.
type Waiting = Reverse<(u64, u32, u8)>;

impl<'n> Cutter<'n> {
    /// A face with some corners.
    pub(super) fn new(net: &'n mut Net, corners: &[u32], plane: Plane, longest: f64) -> Self {
        let Extent { low, high } = Extent::of(corners.iter().map(|&corner| plane.flat(net, corner)));
        let near = TIE_EPSILON * (high - low).max_element() + ROUNDING_EPSILON;
        let (at, obstacles) = (BTreeSet::new(), Obstacles::default());
        let tests_left = Cell::new(TESTS * corners.len() + TESTS_OF_ALL);
        let mut cutter = Cutter { net, plane, tests_left, near, longest, corners: Vec::new(), at, obstacles };
        corners.iter().for_each(|&corner| cutter.know(corner));
        cutter
    }

    /// Adds a corner and its half-edge to the face.
    fn know(&mut self, corner: u32) {
        self.corners.push(corner);
        self.at.insert([self.net.point(corner), corner]);
        self.block(corner);
    }

    fn block(&mut self, half: u32) {
        self.obstacles.add(half, [self.flat(half), self.flat(self.net.next(half))]);
    }

    fn flat(&self, corner: u32) -> DVec2 {
        self.plane.flat(self.net, corner)
    }

    /// The places of a corner's neighbours, with its own between them.
    fn turn(&self, corner: u32) -> [DVec2; 3] {
        [self.net.before(corner), corner, self.net.next(corner)].each(|corner| self.flat(corner))
    }

    fn is_reflex(&self, corner: u32) -> bool {
        is_reflex(self.turn(corner))
    }

    /// Makes all cuts. Returns false if there are too many, because coordinates are too near to each other, or if they take too
    /// long.
    pub(super) fn cut(&mut self) -> bool {
        let mut cuts_left = 2 * self.corners.len() + 16;
        let mut waiting: BinaryHeap<Waiting> = BinaryHeap::new();
        for k in 0..self.corners.len() {
            self.wait(self.corners[k], 0, &mut waiting);
            if self.tests_left.get() == 0 {
                return false;
            }
        }
        // Corners whose cuts are too long, until other cuts may have made them shorter.
        let mut too_long = Vec::new();
        let mut has_cut = false;
        loop {
            while let Some(Reverse((key, corner, waits))) = waiting.pop() {
                if self.tests_left.get() == 0 {
                    return false;
                }
                let Some((length, target)) = self.best(corner) else { continue };
                if key_of(length) != key && waits < WAITS {
                    waiting.push(Reverse((key_of(length), corner, waits + 1)));
                    continue;
                }
                if self.longest <= length {
                    too_long.push(corner);
                    continue;
                }
                let Some(left) = cuts_left.checked_sub(1) else { return false };
                cuts_left = left;
                has_cut = true;
                for new in self.make(corner, target) {
                    self.wait(new, 0, &mut waiting);
                }
            }
            if !has_cut || too_long.is_empty() {
                return true;
            }
            has_cut = false;
            std::mem::take(&mut too_long).into_iter().for_each(|corner| self.wait(corner, 0, &mut waiting));
        }
    }

    fn wait(&self, corner: u32, waits: u8, waiting: &mut BinaryHeap<Waiting>) {
        waiting.extend(self.best(corner).map(|(length, _)| Reverse((key_of(length), corner, waits))));
    }

    /// Makes a cut. Returns the corners that may be reflex afterwards.
    fn make(&mut self, corner: u32, target: Target) -> [u32; 4] {
        let other = match target {
            Target::Corner(other) => other,
            Target::Edge(half, share) => self.divide(half, share),
        };
        let [one, two] = self.net.cut(corner, other);
        self.know(one);
        self.know(two);
        [corner, one, other, two]
    }

    /// Divides an edge. Returns the new corner on the given side.
    fn divide(&mut self, half: u32, share: f64) -> u32 {
        let from = self.net.corner_count() as u32;
        let own = self.net.divide(half, share);
        // Other loops of this face may have the edge too.
        let others: Vec<u32> = (from..self.net.corner_count() as u32)
            .filter(|&corner| {
                let before = self.net.before(corner);
                corner == own || self.at.contains(&[self.net.point(before), before])
            })
            .collect();
        others.into_iter().for_each(|corner| self.know(corner));
        own
    }

    /// The shortest cut from a corner, and its length. `None` if the corner is not reflex.
    fn best(&self, corner: u32) -> Option<(f64, Target)> {
        let [before, here, next] = self.turn(corner);
        if !is_reflex([before, here, next]) {
            return None;
        }
        let from = self.net.position(corner);
        let measured = |target: Target| {
            let to = match target {
                Target::Corner(other) => self.net.position(other),
                Target::Edge(half, share) => self.net.along(half, share),
            };
            ((to - from).length(), target)
        };
        let onwards = [[before, here], [next, here]].each(|line| self.shoot(corner, line).map(measured));
        let mut best = match onwards {
            [Some(one), Some(two)] => {
                let numbers = [self.net.before(corner), self.net.next(corner)].each(|corner| self.net.point(corner));
                Some(if is_first(one, two, numbers) { one } else { two })
            }
            [one, two] => one.or(two),
        };
        let radius = best.map_or(f64::INFINITY, |best| best.0 * self.plane.scale * (1.0 + TIE_EPSILON));
        let mut tried = 0;
        self.obstacles.near(here, radius, VISITED, |other| {
            let (length, target) = measured(Target::Corner(other));
            let is_shorter = best.is_none_or(|best| length <= best.0 * (1.0 + TIE_EPSILON));
            if is_shorter && self.may_join(corner, other) {
                tried += 1;
                if self.sees(corner, other) {
                    best = Some((length, target));
                    return false;
                }
            }
            tried < PARTNERS
        });
        best
    }

    /// Returns true if a cut between two reflex corners would leave neither of them reflex.
    fn may_join(&self, corner: u32, other: u32) -> bool {
        let apart = self.net.point(corner) != self.net.point(other) && !self.are_neighbours(corner, other);
        apart && self.is_reflex(other) && {
            let [from, to] = [corner, other].each(|corner| self.flat(corner));
            let mends = |corner: u32, to: DVec2| {
                let [before, here, next] = self.turn(corner);
                0 <= orient(before, here, to) && 0 <= orient(to, here, next)
            };
            mends(corner, to) && mends(other, from)
        }
    }

    fn are_neighbours(&self, corner: u32, other: u32) -> bool {
        self.net.next(corner) == other || self.net.next(other) == corner
    }

    /// Returns true if nothing is between two corners.
    fn sees(&self, corner: u32, other: u32) -> bool {
        self.shoot(corner, [self.flat(corner), self.flat(other)]) == Some(Target::Corner(other))
    }

    /// The first obstacle from a corner on, in the direction of a line through it.
    fn shoot(&self, corner: u32, [from, to]: [DVec2; 2]) -> Option<Target> {
        let (here, way) = (self.flat(corner), to - from);
        let length = way.length();
        if length == 0.0 {
            return None;
        }
        let least = self.near / length;
        let mut reach = f64::INFINITY;
        let mut found = None;
        let at_corner = |half: u32| (self.flat(half) - here).dot(way) / way.length_squared();
        let tested = self.obstacles.along(here, way, self.near, &mut reach, |half, reach| {
            let next = self.net.next(half);
            let [p, q] = [half, next].each(|corner| self.flat(corner));
            let [side_p, side_q] = [p, q].each(|p| orient(from, to, p));
            let mut meet = |along: f64, half: u32, share: Option<f64>| {
                // The same place may be the end of one edge and the start of the next one.
                if least < along && (along < *reach || (share.is_none() && along <= *reach)) {
                    *reach = along;
                    found = Some((half, share));
                }
            };
            if side_p == 0 {
                meet(at_corner(half), half, None);
            }
            if side_q == 0 {
                meet(at_corner(next), next, None);
            }
            if side_p < 0 && 0 < side_q {
                let edge = q - p;
                let [along, share] =
                    [(p - here).perp_dot(edge), (p - here).perp_dot(way)].each(|area| area / way.perp_dot(edge));
                let share = share.clamp(0.0, 1.0);
                let long = edge.length();
                if share * long <= self.near {
                    meet(at_corner(half), half, None);
                } else if (1.0 - share) * long <= self.near {
                    meet(at_corner(next), next, None);
                } else {
                    meet(along, half, Some(share));
                }
            }
        });
        self.tests_left.set(if work::spend(tested) { self.tests_left.get().saturating_sub(tested) } else { 0 });
        match found? {
            (half, Some(share)) => Some(Target::Edge(half, share)),
            (other, None) => self.corner_towards(other, corner).map(Target::Corner),
        }
    }

    /// The corner at the point of `other` whose side of the face contains the direction to `corner`.
    fn corner_towards(&self, other: u32, corner: u32) -> Option<u32> {
        let (point, to) = (self.net.point(other), self.flat(corner));
        let looks = |&candidate: &u32| {
            let [before, here, next] = self.turn(candidate);
            let [in_front, behind] = [orient(before, here, to), orient(here, next, to)];
            let turn = orient(before, here, next);
            let contains = match turn {
                1 => 0 < in_front && 0 < behind,
                -1 => 0 < in_front || 0 < behind,
                _ if 0.0 <= (here - before).dot(next - here) => 0 < in_front,
                _ => true,
            };
            contains && !self.are_neighbours(candidate, corner)
        };
        self.at.range([point, 0]..=[point, u32::MAX]).map(|&[_, corner]| corner).find(looks)
    }
}

/// Returns true if the first of two cuts is to be made: the shorter one. Of two with the same length it is the one that needs no
/// new point, or the one with the lower number, so that the two ends of a prism are cut alike.
fn is_first(one: (f64, Target), two: (f64, Target), numbers: [u32; 2]) -> bool {
    let is_tie = (one.0 - two.0).abs() <= TIE_EPSILON * one.0.max(two.0);
    let [first, second] = [one, two].each(|cut| matches!(cut.1, Target::Corner(_)));
    match is_tie {
        true if first != second => first,
        true => numbers[0] < numbers[1],
        false => one.0 < two.0,
    }
}

/// A number that sorts like the lengths, equal for lengths that differ by rounding errors only.
fn key_of(length: f64) -> u64 {
    const ROUNDED: u32 = 22;
    (length.to_bits() + (1 << (ROUNDED - 1))) >> ROUNDED
}
