//! Whether a result can be true.
//!
//! The areas add up however points are moved, so strips could only overlap where one is turned over. A strip of a straight
//! skeleton is monotone along its edge, and what is left has no crossings.

use glam::DVec2;

use super::wavefront::{Line, Wavefront, twice_area};
use super::{Left, Strip, Swept};
use crate::exact::orient;
use crate::tol::MEETING_EPSILONS;

/// So many times what touches is rounding.
const SLACK: f64 = 16.0;

impl Wavefront {
    /// Whether a result can be this wavefront's.
    pub(super) fn allows(&self, swept: &Swept) -> bool {
        let slack = SLACK * self.epsilon;
        let rounding = MEETING_EPSILONS[0] * self.extent * self.extent;
        swept.points.iter().all(|p| p.is_finite())
            && swept.strips.iter().all(|strip| {
                is_monotone(strip, &swept.points, &self.lines[strip.edge as usize], self.until, slack)
                    && -rounding <= twice_area(&swept.points, &strip.ring)
            })
            && !crosses(&swept.left, &swept.points, slack)
    }
}

/// Whether a strip runs along its edge once and comes back once, in front of it.
fn is_monotone(strip: &Strip, points: &[DVec2], line: &Line, until: f64, slack: f64) -> bool {
    let at = |i: usize| points[strip.ring[i % strip.ring.len()] as usize];
    let count = strip.ring.len();
    let along: Vec<f64> = (0..count).map(|i| line.along.dot(at(i))).collect();
    let by = |a: &usize, b: &usize| along[*a].total_cmp(&along[*b]);
    let (Some(low), Some(high)) = ((0..count).min_by(by), (0..count).max_by(by)) else { return false };
    let runs = |from: usize, to: usize, sign: f64| {
        let steps = (to + count - from) % count;
        (from..from + steps).all(|i| -slack <= sign * (along[(i + 1) % count] - along[i % count]))
    };
    let heights = (0..count).all(|i| {
        let height = line.normal().dot(at(i)) - line.at;
        -slack <= height && height <= until + slack
    });
    heights && runs(low, high, 1.0) && runs(high, low, -1.0)
}

/// Whether what is left crosses itself by more than some slack.
fn crosses(left: &[Vec<Left>], points: &[DVec2], slack: f64) -> bool {
    let mut edges: Vec<[DVec2; 2]> = Vec::new();
    for ring in left {
        let at = |i: usize| points[ring[i % ring.len()].point as usize];
        edges.extend((0..ring.len()).map(|i| [at(i), at(i + 1)]));
    }
    edges.sort_by(|e, f| e[0].x.min(e[1].x).total_cmp(&f[0].x.min(f[1].x)));
    edges.iter().enumerate().any(|(i, edge)| {
        let reach = edge[0].x.max(edge[1].x);
        let near = edges[i + 1..].iter().take_while(|other| other[0].x.min(other[1].x) <= reach);
        near.into_iter().any(|other| cross(edge, other, slack))
    })
}

fn cross(e: &[DVec2; 2], f: &[DVec2; 2], slack: f64) -> bool {
    let apart = |i: usize| e[0][i].max(e[1][i]) < f[0][i].min(f[1][i]) || f[0][i].max(f[1][i]) < e[0][i].min(e[1][i]);
    if apart(0) || apart(1) {
        return false;
    }
    let sides = |e: &[DVec2; 2], f: &[DVec2; 2]| f.map(|p| orient(e[0], e[1], p));
    let ([a, b], [c, d]) = (sides(e, f), sides(f, e));
    if a * b >= 0 || c * d >= 0 {
        return false;
    }
    // All four ends are far from the other edge.
    let away = |e: &[DVec2; 2], p: DVec2| (e[1] - e[0]).perp_dot(p - e[0]).abs() > slack * e[0].distance(e[1]);
    f.iter().all(|&p| away(e, p)) && e.iter().all(|&p| away(f, p))
}
