//! The ends of sections that are too short for the mitre at a corner.
//!
//! At a corner inside a section the strips of both edges meet in a mitre. If the section ends soon after the corner, the end of its
//! last strip would cut off a part of the strip before the corner. There the last piece stays where it is, and the section is the
//! section that ends at the corner: its strip ends on the last edge and covers what the last piece would sweep. So the area of a
//! section never falls while it grows past a corner. At blunt corners strips end on the bisector, not on the neighbour, so all
//! pieces move.

use glam::DVec3;

use crate::geometry::mesh::{FaceRef, unit};
use crate::geometry::offset::region::EdgeCut;
use crate::geometry::skeleton::BLUNT;
use crate::geometry::tol::{ANGLE_EPSILON, TIE_EPSILON};

/// The pieces of the outline and the holes of a face.
pub(super) struct FacePieces {
    pieces: Vec<FacePiece>,
}

/// A piece of an edge.
#[derive(Clone, Copy, Debug)]
struct FacePiece {
    length: f64,
    /// The numbers of the pieces before it and after it.
    neighbours: [usize; 2],
    /// The shares of a depth that the strips of the neighbours need of its length, at its start and its end. 0 at corners that
    /// are reflex or blunt.
    needs: [f64; 2],
}

impl FacePieces {
    /// The pieces of a face whose edges are divided by cuts.
    pub(super) fn of(face: &FaceRef<'_>, cuts: &[EdgeCut]) -> Self {
        let (first, mut cuts) = (face.corner_range().start, cuts.iter().peekable());
        let (mut pieces, mut edges, normal) = (Vec::new(), face.edges(), face.normal());
        for ring in face.loop_ranges() {
            let start = pieces.len();
            let mut points: Vec<DVec3> = Vec::new();
            for [a, b] in edges.by_ref().take(ring.len()) {
                let [from, to] = [face.position(a), face.position(b)];
                points.push(from);
                while let Some((_, share)) = cuts.next_if(|cut| cut.0 == a - first) {
                    points.push(from.lerp(to, *share));
                }
            }
            let count = points.len();
            let along = |i: usize| points[(i + 1) % count] - points[i % count];
            let need = |i: usize| needed(unit(along(i + count - 1)), unit(along(i)), normal);
            pieces.extend((0..count).map(|i| FacePiece {
                length: along(i).length(),
                neighbours: [i + count - 1, i + 1].map(|other| start + other % count),
                needs: [need(i), need(i + 1)],
            }));
        }
        FacePieces { pieces }
    }

    /// Lets pieces stay that are ends of those that move, and too short for the strip at their other end. The shortest end
    /// stays first.
    pub(super) fn keep_short_ends(&self, moves: &mut [bool], depth: f64) {
        let is_short = |moves: &[bool], number: usize| {
            let FacePiece { length, neighbours, needs } = self.pieces[number];
            let inner = match neighbours.map(|other| moves[other]) {
                [true, false] => needs[0],
                [false, true] => needs[1],
                _ => 0.0,
            };
            moves[number] && length < depth * inner * (1.0 - TIE_EPSILON)
        };
        let length = |number: usize| self.pieces[number].length;
        let shortest = |moves: &[bool]| {
            let short = (0..moves.len()).filter(|&number| is_short(moves, number));
            // Rounding does not choose between ends of one length: the first one stays.
            short.reduce(|best, number| if length(number) < length(best) * (1.0 - TIE_EPSILON) { number } else { best })
        };
        while let Some(short) = shortest(moves) {
            moves[short] = false;
        }
    }
}

/// The share of a depth that strips of that depth need of both edges at a corner: the length of the mitre, or the part of an edge
/// on which the strip of the other edge ends. 0 if the corner is reflex or blunt.
fn needed(to: DVec3, from: DVec3, normal: DVec3) -> f64 {
    let (sine, cosine) = (to.cross(from).dot(normal), to.dot(from));
    if sine <= ANGLE_EPSILON || BLUNT < cosine {
        return 0.0;
    }
    // The mitre is the tangent of half of the angle by which the outline turns.
    (1.0 - cosine.min(0.0)) / sine
}
