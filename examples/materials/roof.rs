//! Tiles and slates of roofs. v runs up the slope.

use super::noise::{random, rough, smooth};
use super::surface::{Surface, Texel, mix, shade};

/// A place in rows that cover each other: the row, the column, and the place in the visible part, 0..1 across and up from its lower edge.
/// The borders of the image run through the middle of parts.
fn courses([u, v]: [f64; 2], rows: i64, columns: i64, offset: f64) -> (i64, i64, [f64; 2]) {
    let y = v * rows as f64 + 0.5;
    let row = (y.floor() as i64).rem_euclid(rows);
    let x = u * columns as f64 + 0.5 + if row % 2 == 0 { 0.0 } else { offset };
    (row, (x.floor() as i64).rem_euclid(columns), [x - x.floor(), y - y.floor()])
}

/// Clay pantiles: eight across and six rows on 2 m by 2 m.
pub fn tile() -> Surface {
    let texel = |at: [f64; 2], color: &str| {
        let (row, column, [across, up]) = courses(at, 6, 8, 0.0);
        let (grain, cloud) = (rough(81, at, 64, 3) - 0.5, rough(85, at, 4, 4) - 0.5);
        let tone = random(89, column, row) - 0.5;
        // A roll on the left of a flat pan.
        let roll = (smooth(0.0, 0.22, across) - smooth(0.26, 0.5, across)) + 0.12 * smooth(0.9, 1.0, across);
        let edge = smooth(0.0, 0.06, up);
        let clay = if color == "red" { [172.0, 88.0, 64.0] } else { [226.0, 222.0, 216.0] };
        let color = shade(clay, 44.0 * tone + 26.0 * grain + 34.0 * cloud + 20.0 * roll);
        Texel {
            color: mix([92.0, 88.0, 84.0], color, edge),
            height: 34.0 * roll + 20.0 * (1.0 - up) * edge + 2.0 * grain,
            rough: 0.95 - edge * (0.16 + 0.14 * tone - 0.1 * grain),
        }
    };
    Surface { pixels: 256, size: [2000.0; 2], texel: Box::new(texel) }
}

/// Slates: eight across and ten rows on 2 m by 2 m.
pub fn slate() -> Surface {
    let texel = |at: [f64; 2], _: &str| {
        let (row, column, [across, up]) = courses(at, 10, 8, 0.5);
        let (grain, cloud) = (rough(101, at, 64, 3) - 0.5, rough(105, at, 4, 4) - 0.5);
        let tone = random(109, column, row) - 0.5;
        let gap = smooth(0.0, 0.03, across.min(1.0 - across));
        let edge = gap * smooth(0.0, 0.07, up);
        let color = shade([228.0, 230.0, 234.0], 56.0 * tone + 24.0 * grain + 24.0 * cloud);
        Texel {
            color: mix([84.0, 86.0, 90.0], color, edge),
            height: 12.0 * (1.0 - up) * edge + 1.5 * grain,
            rough: 0.9 - edge * (0.3 + 0.14 * tone - 0.2 * grain),
        }
    };
    Surface { pixels: 256, size: [2000.0; 2], texel: Box::new(texel) }
}
