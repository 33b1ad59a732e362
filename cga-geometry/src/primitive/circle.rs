//! Regular polygons about the centre of the unit square.

use std::f64::consts::{FRAC_1_SQRT_2, TAU};

use glam::DVec2;

/// The number of sides: at least three, at most 2^20.
pub(super) fn sides(wanted: usize) -> usize {
    wanted.clamp(3, 1 << 20)
}

/// The corners of a regular polygon as (x, z), on the circle, counter-clockwise as seen from above, from the left end
/// of the front edge on.
pub(super) fn corners(sides: usize) -> impl Iterator<Item = DVec2> {
    let half_turns = 2 * sides;
    (0..sides).map(move |i| {
        let (sin, cos) = sin_cos(2 * i + half_turns - 1, half_turns);
        DVec2::new(0.5 + 0.5 * sin, 0.5 + 0.5 * cos)
    })
}

/// The texture coordinates of a point (x, z) of the square, for a texture that covers it, as seen from above.
pub(super) fn from_above(p: DVec2) -> DVec2 {
    DVec2::new(p.x, 1.0 - p.y)
}

/// The sine and cosine of `part / whole` turns, with the symmetries of the circle exact to the last bit.
pub(super) fn sin_cos(part: usize, whole: usize) -> (f64, f64) {
    let part = part % whole;
    let (quarter, rest) = (4 * part / whole, 4 * part % whole);
    // `rest` parts of a quarter turn.
    let small = |rest: usize| libm::sincos(TAU * rest as f64 / (4.0 * whole as f64));
    let (sin, cos) = match (2 * rest).cmp(&whole) {
        std::cmp::Ordering::Less => small(rest),
        std::cmp::Ordering::Equal => (FRAC_1_SQRT_2, FRAC_1_SQRT_2),
        std::cmp::Ordering::Greater => {
            let (cos, sin) = small(whole - rest);
            (sin, cos)
        }
    };
    match quarter {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// The area of the polygon.
#[cfg(test)]
pub(super) fn area(sides: usize) -> f64 {
    sides as f64 / 8.0 * libm::sin(TAU / sides as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_those_of_the_library_and_quarters_are_exact() {
        for whole in [1, 3, 4, 7, 8, 24, 1000] {
            for part in 0..2 * whole {
                let (sin, cos) = sin_cos(part, whole);
                let (s, c) = libm::sincos(TAU * part as f64 / whole as f64);
                assert!((sin - s).abs() < 1e-14 && (cos - c).abs() < 1e-14, "{part}/{whole}");
            }
        }
        assert_eq!([0, 1, 2, 3].map(|part| sin_cos(part, 4)), [(0.0, 1.0), (1.0, -0.0), (-0.0, -1.0), (-1.0, 0.0)]);
    }

    #[test]
    fn polygons_are_their_own_mirror_images() {
        for sides in [3, 4, 8, 12, 31] {
            let all: Vec<DVec2> = corners(sides).map(|p| p - 0.5).collect();
            let has = |p: DVec2| all.iter().any(|q| p.distance(*q) < 1e-16);
            assert!(all.iter().all(|p| has(DVec2::new(-p.x, p.y))));
            assert!(sides % 4 != 0 || all.iter().all(|p| has(p.perp())));
        }
    }
}
