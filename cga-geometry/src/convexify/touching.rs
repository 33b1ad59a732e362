//! Loops that touch, linked so that each corner is one angle of the face.
//!
//! Where loops of a face touch, the corner of the outline contains the corner of the hole. Cuts need corners that share the angles
//! of the face at a point among them, so the half-edges there are paired by angle.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use glam::DVec2;

use super::net::Net;
use crate::exact::orient;
use crate::small_sort::SmallSort;

/// Corners at touching points, each with the corner whose incoming half-edge it has now.
pub(super) struct Relinked(Vec<[u32; 2]>);

/// A half-edge at a point: the place of its other end, true if it leaves the point, and its corner there.
type Spoke = (DVec2, bool, u32);

impl Relinked {
    /// Pairs the half-edges at points with several of the given corners. Points where this is not possible are left alone.
    pub(super) fn at_points(net: &mut Net, corners: &[u32], flat: impl Fn(&Net, u32) -> DVec2) -> Self {
        let mut at: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for &corner in corners {
            at.entry(net.point(corner)).or_default().push(corner);
        }
        let mut pairs = Vec::new();
        for list in at.values().filter(|list| 1 < list.len()) {
            let centre = flat(net, list[0]);
            let mut spokes: Vec<Spoke> = Vec::with_capacity(2 * list.len());
            for &corner in list {
                spokes.push((flat(net, net.next(corner)), true, corner));
                spokes.push((flat(net, net.before(corner)), false, corner));
            }
            // Of two half-edges in one direction, the angle that ends there comes before the one that begins there.
            spokes.small_sort_by(|a, b| by_angle(centre, a.0, b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
            let first = spokes.iter().position(|spoke| spoke.1).unwrap_or(0);
            spokes.rotate_left(first);
            if spokes.iter().enumerate().all(|(k, spoke)| spoke.1 == (k % 2 == 0)) {
                pairs.extend(spokes.chunks(2).map(|pair| [pair[0].2, pair[1].2]).filter(|[to, from]| to != from));
            }
        }
        net.exchange(&pairs);
        Relinked(pairs)
    }

    /// Makes the loops as they were, with the points that divide their edges now.
    pub(super) fn undo(&self, net: &mut Net) {
        net.exchange(&self.0.iter().map(|&[to, from]| [from, to]).collect::<Vec<_>>());
    }
}

/// The order of directions from a point, anticlockwise from the direction of the first axis on.
fn by_angle(centre: DVec2, a: DVec2, b: DVec2) -> Ordering {
    let is_low = |p: DVec2| p.y < centre.y || (p.y == centre.y && p.x < centre.x);
    is_low(a).cmp(&is_low(b)).then_with(|| 0.cmp(&orient(centre, a, b)))
}
