//! The first edge of a piece. The x axis of a face is along it, so it must survive a cut.
//!
//! A piece begins with the remaining part of the face's first edge. If no part remains, it begins with the cut edge
//! that replaces it: the edge between the last node before the first edge and the first node after it. So the walls of every storey of a building have their x axis along the
//! ground edge.

use std::ops::Range;

use crate::cut::points::PieceCorner;

/// The index of the node that a piece begins with. `outline` is the range of the face's outline; other nodes, such as
/// corners of holes, are skipped.
#[inline]
pub(crate) fn first_node<'a>(
    nodes: impl DoubleEndedIterator<Item = &'a PieceCorner> + Clone,
    outline: &Range<usize>,
) -> usize {
    let mut before = nodes.clone().next_back().and_then(|node| step(node, outline));
    let mut least: Option<(u32, usize)> = None;
    let mut last = 0;
    for (place, node) in nodes.enumerate() {
        last = place;
        let here = step(node, outline);
        if let Some(at) = here {
            // If one edge has several crossings, the first one on it counts: the node before it is on another edge.
            let better = least.is_none_or(|(least, _)| at < least || (at == least && before != Some(at)));
            if better {
                least = Some((at, place));
            }
        }
        before = here;
    }
    match least {
        // Corner 0, or a crossing of edge 0.
        Some((0 | 1, place)) => place,
        Some((_, 0)) => last,
        Some((_, place)) => place - 1,
        None => 0,
    }
}

/// The position of a node along the outline: 2i for corner i, 2i + 1 for a crossing of the edge after it.
#[inline]
fn step(node: &PieceCorner, outline: &Range<usize>) -> Option<u32> {
    let (a, b) = (node.from.min(node.to) as usize, node.from.max(node.to) as usize);
    if a < outline.start || outline.end <= b {
        return None;
    }
    let edge = match b - a {
        0 => return Some(2 * (a - outline.start) as u32),
        1 => a,
        _ => b,
    };
    Some(2 * (edge - outline.start) as u32 + 1)
}
