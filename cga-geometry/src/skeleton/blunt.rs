//! Blunt corners between edges of different speeds.
//!
//! Two lines of different speeds meet far beyond a blunt corner, or far before it: the faster edge would sweep a spike
//! in front of its neighbour. There a third line, which stays, divides the corner along its bisector, so that each edge
//! ends as if its neighbour were as fast.

use super::wavefront::{MovingLine, Wavefront, WavefrontVertex};
use crate::each::Each;
use crate::tol::TIE_EPSILON;

/// A corner is blunt if the cosine of the angle between the normals of its edges is larger: less than 45 degrees. Rounding does not decide
/// at 45 degrees, the corners of octagons and of cut mitres: they are not blunt.
pub const BLUNT: f64 = std::f64::consts::FRAC_1_SQRT_2 + TIE_EPSILON;

/// The line that divides a corner between two edges of different speeds, if the corner is blunt.
fn divider(a: &MovingLine, b: &MovingLine, corner: glam::DVec2) -> Option<MovingLine> {
    if a.speed == b.speed || a.along.dot(b.along) <= BLUNT {
        return None;
    }
    let bisector = (a.normal() + b.normal()).normalize();
    let along = if b.speed < a.speed { -bisector } else { bisector };
    Some(MovingLine { along, at: along.perp().dot(corner), speed: 0.0 })
}

impl Wavefront {
    /// Divides the blunt corners among the given vertices, which start now, where speeds differ and only places count.
    /// Returns the additional vertices.
    pub(super) fn part_speeds(&mut self, made: &[u32]) -> Vec<u32> {
        let mut added = Vec::new();
        for &number in if self.flat { made } else { &[] } {
            let WavefrontVertex { node, before, after, last, next, .. } = self.vertices[number as usize];
            let [a, b] = [before, after].each(|line| self.lines[line as usize]);
            let Some(line) = divider(&a, &b, self.nodes[node as usize]) else { continue };
            let (between, new) = (self.lines.len() as u32, self.vertices.len() as u32);
            self.lines.push(line);
            self.arcs.line();
            let [first, second] = [(before, between), (between, after)].each(|(a, b)| self.vertex(node, a, b));
            self.vertices[number as usize] = WavefrontVertex { last, next: new, ..first };
            self.push(WavefrontVertex { last: number, next, ..second });
            self.vertices[next as usize].last = new;
            self.alive.push(new);
            added.push(new);
        }
        added
    }
}
