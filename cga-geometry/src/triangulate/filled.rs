//! Polygons that triangles fill.

use glam::DVec2;

use super::Triangulator;
use crate::each::Each;
use crate::tol::TOUCH_EPSILON;

/// Returns true if holes look the other way than the outline and triangles fill the polygon: none of them is turned over, and their
/// areas add up to the area of the polygon, except for a share of it. A polygon whose hole is outside of its outline is not filled.
pub(crate) fn is_filled(loops: &[Vec<DVec2>]) -> bool {
    filling(loops).is_some()
}

/// The triangles of a polygon that they fill.
pub(crate) fn filling(loops: &[Vec<DVec2>]) -> Option<Vec<[DVec2; 3]>> {
    let ends: Vec<u32> = loops.iter().scan(0, |end, ring| (*end += ring.len() as u32, Some(*end)).1).collect();
    let places = loops.concat();
    let mut triangles = Vec::new();
    Triangulator::new().polygon(&places, &ends, &mut triangles);
    let triangles: Vec<_> = triangles.into_iter().map(|triangle| triangle.each(|k| places[k as usize])).collect();
    let (mut front, mut back) = (0.0, 0.0);
    for &[a, b, c] in &triangles {
        let doubled = (b - a).perp_dot(c - a);
        *(if 0.0 < doubled { &mut front } else { &mut back }) += doubled;
    }
    let rings: Vec<f64> = loops.iter().map(|ring| doubled_area(ring)).collect();
    let whole: f64 = rings.iter().sum();
    let rounding = TOUCH_EPSILON * rings[0];
    let is_filled =
        rings[1..].iter().all(|&hole| hole <= 0.0) && -rounding <= back && (front - whole).abs() <= rounding;
    is_filled.then_some(triangles)
}

/// Twice the area of a loop, positive if it is anticlockwise.
pub(crate) fn doubled_area(ring: &[DVec2]) -> f64 {
    let at = |k: usize| ring[k] - ring[0];
    (1..ring.len().saturating_sub(1)).map(|k| at(k).perp_dot(at(k + 1))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(corners: &[[f64; 2]]) -> Vec<DVec2> {
        corners.iter().map(|&corner| corner.into()).collect()
    }

    #[test]
    fn a_polygon_is_filled_if_its_holes_are_inside() {
        let outline = ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        let hole = |x: f64| ring(&[[x, 1.0], [x, 2.0], [x + 1.0, 2.0], [x + 1.0, 1.0]]);
        assert!(is_filled(std::slice::from_ref(&outline)) && is_filled(&[outline.clone(), hole(1.0)]));
        assert!(!is_filled(&[outline.clone(), hole(3.5)]) && !is_filled(&[outline.clone(), hole(5.0)]));
        let back = hole(1.0).into_iter().rev().collect();
        assert!(!is_filled(&[outline, back]));
        assert!(!is_filled(&[ring(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 3.0]])]));
    }
}
