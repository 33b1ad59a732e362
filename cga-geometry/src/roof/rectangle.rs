//! Hip and gable roofs over a rectangle, by formula: most roofs are. The result is the one of the straight skeleton, which takes ten
//! times as long.

use glam::DVec2;

use super::hip::overhang_in_plan;
use super::{Outline, Rise, Roof, RoofForm, RoofPart};
use crate::each::Each;
use crate::tol::ANGLE_EPSILON;

/// Sides whose lengths differ by less than this share, but are not equal, are left to the skeleton: it decides where the ridge runs.
const NEARLY_SQUARE: f64 = 1e-6;

/// Slopes between this and its inverse have a formula.
const FLATTEST: f64 = 1e-6;

/// Overhangs up to this multiple of the longer side have a formula.
const FARTHEST: f64 = 1e3;

/// A rectangle, anticlockwise. Its sides are numbered from the first corner.
struct Rectangle {
    corners: [DVec2; 4],
    /// The numbers of the corners in the outline.
    points: [u32; 4],
    /// The unit normals of the sides, inwards.
    inwards: [DVec2; 4],
    /// The lengths of the first two sides.
    lengths: [f64; 2],
}

impl Rectangle {
    fn of(outline: &Outline<'_>) -> Option<Self> {
        let [ring] = outline.rings else { return None };
        let points: [u32; 4] = ring.as_slice().try_into().ok()?;
        let corners = points.each(|point| outline.at(point));
        let along = |side: usize| corners[(side + 1) % 4] - corners[side];
        let (u, v) = (along(0), along(1));
        let lengths = [u.length(), v.length()];
        let near = ANGLE_EPSILON * lengths[0].max(lengths[1]);
        let is_rectangle = 0.0 < u.perp_dot(v)
            && lengths.iter().all(|&length| near < length)
            && u.dot(v).abs() <= ANGLE_EPSILON * lengths[0] * lengths[1]
            && (u + along(2)).abs().max_element() <= near;
        let [x, y] = [u / lengths[0], v / lengths[1]];
        is_rectangle.then_some(Rectangle {
            corners,
            points,
            inwards: [x.perp(), y.perp(), -x.perp(), -y.perp()],
            lengths,
        })
    }

    fn middle(&self, side: usize) -> DVec2 {
        self.corners[side].midpoint(self.corners[(side + 1) % 4])
    }

    /// The sides that the ridge runs between, the lower number first: the shorter ones. `None` if that is not certain.
    fn ends(&self) -> Option<[usize; 2]> {
        let [first, second] = self.lengths;
        let difference = (first - second).abs() / first.max(second);
        if ANGLE_EPSILON < difference && difference < NEARLY_SQUARE {
            return None;
        }
        Some(if self.is_square() || second < first { [1, 3] } else { [0, 2] })
    }

    fn is_square(&self) -> bool {
        let [first, second] = self.lengths;
        (first - second).abs() <= ANGLE_EPSILON * first.max(second)
    }
}

/// A hip or gable roof over a rectangle. `None` for other outlines and other forms, and for extreme numbers.
pub(super) fn roof_by_formula(outline: &Outline<'_>, form: RoofForm, rise: Rise) -> Option<Roof> {
    let (overhangs, is_gable, edge) = match form {
        RoofForm::Hip { overhang, .. } => ([overhang, 0.0], false, None),
        RoofForm::Gable { across, along, edge, .. } => ([across, along], true, edge),
        RoofForm::Pyramid | RoofForm::Shed { .. } | RoofForm::Ridge => return None,
    };
    let rectangle = Rectangle::of(outline)?;
    let ends = match edge {
        Some(edge) => [[1, 3], [0, 2]][outline.edge(edge) % 2],
        None => rectangle.ends()?,
    };
    let half = 0.5 * rectangle.lengths[ends[0] % 2];
    let slope = rise.slope(half);
    let eave = overhang_in_plan(overhangs[0], slope);
    // A hip roof has eaves all around.
    let beyond = if is_gable { overhangs[1] } else { eave };
    let far = FARTHEST * rectangle.lengths[0].max(rectangle.lengths[1]);
    if !((FLATTEST..=1.0 / FLATTEST).contains(&slope) && [eave, beyond].iter().all(|by| (0.0..=far).contains(by))) {
        return None;
    }
    let mut roof = Roof::over(outline);
    let height = half * slope;
    // The ends of the ridge, at the ends of the rectangle.
    let setback = if is_gable { 0.0 } else { half };
    let ridge_end = |side: usize| rectangle.middle(side) + setback * rectangle.inwards[side];
    let mut ridge = [0; 4];
    // The numbers follow the skeleton: the first corner's side comes first.
    let [near, far] = if ends[0] == 1 { [3, 1] } else { [0, 2] };
    if !is_gable && rectangle.is_square() {
        ridge = [roof.point(rectangle.corners[0].midpoint(rectangle.corners[2]).extend(height)); 4];
    } else {
        ridge[near] = roof.point(ridge_end(near).extend(height));
        ridge[far] = roof.point(ridge_end(far).extend(height));
    }
    let pediment = ridge;
    let is_end = |side: usize| side % 2 == ends[0] % 2;
    let by = |side: usize| if is_end(side) { beyond } else { eave };
    let mut outer = rectangle.points;
    if 0.0 < eave || 0.0 < beyond {
        for corner in [0, 3, 2, 1] {
            let before = (corner + 3) % 4;
            let away = by(before) * rectangle.inwards[before] + by(corner) * rectangle.inwards[corner];
            outer[corner] = roof.point((rectangle.corners[corner] - away).extend(-eave * slope));
        }
        if is_gable && 0.0 < beyond {
            for end in ends {
                ridge[end] = roof.point((rectangle.middle(end) - beyond * rectangle.inwards[end]).extend(height));
            }
        }
    }
    for side in 0..4 {
        let (next, before) = ((side + 1) % 4, (side + 3) % 4);
        let number = side as u32;
        if is_gable && is_end(side) {
            let ring = vec![rectangle.points[side], rectangle.points[next], pediment[side]];
            roof.face(RoofPart::Side, number, ring);
        } else if is_end(side) || ridge[next] == ridge[before] {
            let top = if is_end(side) { ridge[side] } else { ridge[next] };
            roof.face(RoofPart::Top, number, vec![outer[side], outer[next], top]);
        } else if is_gable && beyond == 0.0 && 0.0 < eave {
            // The eave continues beside the pediments.
            let [a, b] = [rectangle.points[side], rectangle.points[next]];
            roof.face(RoofPart::Top, number, vec![outer[side], outer[next], b, ridge[next], ridge[before], a]);
        } else {
            roof.face(RoofPart::Top, number, vec![outer[side], outer[next], ridge[next], ridge[before]]);
        }
    }
    roof.moved = vec![false; roof.points.len()];
    Some(roof)
}
