//! Moves the points of a straight skeleton into the planes that meet in them.
//!
//! A node is the mean of vertices that met within the contact distance. The planes of its faces determine it more
//! accurately: the nearest point, with its time, that is closest to all of them.

use glam::{DMat3, DVec2, DVec3};

use super::Outline;
use crate::buckets::Buckets;
use crate::nesting::extent::Extent;
use crate::skeleton::{Speeds, Strip, Swept};
use crate::tol::{MEETING_EPSILONS, SETTLE_DAMPING};

/// Repetitions, each of which reduces the effect of the damping.
const ROUNDS: usize = 3;

/// Moves the new points of a whole straight skeleton. Points that would move by more than a contact distance stay.
pub(super) fn settle(swept: &mut Swept, outline: &Outline<'_>, speeds: Speeds<'_>) {
    let given = outline.points.len();
    let Extent { low, high } = Extent::of(outline.points.iter().copied());
    let farthest = MEETING_EPSILONS.iter().copied().fold(0.0, f64::max) * (high - low).max_element();
    let edges = outline.edges();
    // The plane of each strip: the normal and the speed, and a place on the edge.
    let plane = |strip: &Strip| {
        let edge = edges[strip.edge as usize];
        let speed = speeds.of(strip.edge as usize);
        (outline.along(edge).perp().extend(-speed), outline.at(edge[0]))
    };
    let all: Vec<(DVec3, DVec2)> = swept.strips.iter().map(plane).collect();
    // Each new point of each strip, with the number of the strip.
    let mut corners: Vec<[u32; 2]> = Vec::new();
    for (number, strip) in (0..).zip(&swept.strips) {
        corners.extend(strip.ring.iter().filter_map(|&point| Some([point.checked_sub(given as u32)?, number])));
    }
    let around = Buckets::by(swept.points.len() - given, corners.iter().map(|corner| corner[0]));
    for point in given..swept.points.len() {
        let around = around.of(point - given);
        if around.len() < 3 {
            continue;
        }
        let planes = || around.iter().map(|&corner| &all[corners[corner as usize][1] as usize]);
        let from = swept.points[point].extend(swept.times[point]);
        let outer = |v: DVec3| DMat3::from_cols(v * v.x, v * v.y, v * v.z);
        let damped = DMat3::from_diagonal(DVec3::splat(SETTLE_DAMPING));
        let inverse = planes().fold(damped, |sum, plane| sum + outer(plane.0)).inverse();
        let mut at = from;
        for _ in 0..ROUNDS {
            let miss = |(normal, place): &(DVec3, DVec2)| normal * -normal.dot(at - place.extend(0.0));
            at += inverse * planes().map(miss).sum::<DVec3>();
        }
        if (at - from).length() <= farthest {
            (swept.points[point], swept.times[point]) = (at.truncate(), at.z);
        }
    }
}
