//! Setbacks that leave a given area.
//!
//! The area that is left is a continuous function of the offset that all distances have in common. It never grows, and
//! between two events of the wavefront it is quadratic. Its derivative is the length of the edges that still move. So
//! Newton's method finds the offset, and bisection replaces the steps that leave the interval or do not help.

use super::region::FaceRegion;
use crate::mesh::{FaceRef, FlatFace};
use crate::work;

/// The largest difference of the areas, relative to the area that is wanted.
const AREA_EPSILON: f64 = 1e-13;

/// The limit on steps. Halving alone takes fewer to reach neighbouring numbers.
const STEPS: usize = 1100;

/// The units of work of a corner of a face, besides its setback.
pub const CORNER: usize = 64;

/// The rest of faces after a setback.
#[derive(Clone, Copy, Debug, Default)]
pub struct Rest {
    /// The area.
    pub(crate) area: f64,
    /// The length of the edges that move if the offset grows.
    pub(crate) front: f64,
}

impl Rest {
    /// The rest of a face after the turns: all of it if the face cannot be set back. `moves` returns true if a piece moves on.
    pub fn of(face: &FaceRef<'_>, turns: &[&[f64]], moves: impl Fn(usize) -> bool) -> Self {
        if !work::spend(CORNER * face.corner_count()) {
            return Rest::default();
        }
        let whole = || Rest { area: face.area(), front: 0.0 };
        let Some(plane) = FlatFace::of(face) else { return whole() };
        let mut region = FaceRegion::of(&plane, &[]);
        if turns.iter().any(|turn| region.set_back(turn).is_err()) {
            return whole();
        }
        Rest { area: region.area(), front: region.length(moves) }
    }
}

impl std::iter::Sum for Rest {
    fn sum<I: Iterator<Item = Rest>>(list: I) -> Rest {
        list.fold(Rest::default(), |sum, rest| Rest { area: sum.area + rest.area, front: sum.front + rest.front })
    }
}

/// The smallest offset, up to `most`, that leaves at most an area. 0 if already no offset leaves less, and `most` if it
/// leaves more. Any offset if the work of a [`Supervisor`](crate::work::Supervisor) ends meanwhile.
pub fn offset_for(area: f64, most: f64, left: impl Fn(f64) -> Rest) -> f64 {
    let (mut at, mut rest) = (0.0, left(0.0));
    if rest.area <= area {
        return 0.0;
    }
    if area <= left(most).area {
        return most;
    }
    let (mut low, mut high) = (0.0, most);
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        if !work::spend(0) {
            break;
        }
        let over = rest.area - area;
        if over.abs() <= AREA_EPSILON * area {
            break;
        }
        if 0.0 < over {
            low = at
        } else {
            high = at
        }
        let newton = at + over / rest.front;
        let helps = over.abs() <= 0.5 * last && low < newton && newton < high;
        let next = if helps { newton } else { low + 0.5 * (high - low) };
        if next <= low || high <= next {
            break;
        }
        last = if helps { over.abs() } else { f64::INFINITY };
        at = next;
        rest = left(at);
    }
    at
}
