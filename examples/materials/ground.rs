//! Grass, asphalt, bark, leaves and water.

use super::noise::{cell, random, rough, smooth, soft};
use super::surface::{Surface, Texel, mix, shade};

/// A lawn: 4 m by 4 m.
pub fn grass() -> Surface {
    let texel = |at: [f64; 2], _: &str| {
        let (blades, cloud) = (soft(121, at, [160, 80]), rough(125, at, 4, 5));
        let tuft = rough(131, at, 32, 3);
        let color = mix([152.0, 168.0, 120.0], [255.0, 255.0, 224.0], 0.55 * blades + 0.45 * tuft);
        Texel {
            color: shade(mix(color, [252.0, 226.0, 160.0], 0.5 * smooth(0.5, 0.75, cloud)), 40.0 * (cloud - 0.5)),
            height: 22.0 * blades + 30.0 * tuft,
            rough: 1.0,
        }
    };
    Surface { pixels: 256, size: [4000.0; 2], texel: Box::new(texel) }
}

/// Asphalt with stones: 3 m by 3 m.
pub fn asphalt() -> Surface {
    let texel = |at: [f64; 2], _: &str| {
        let (key, [near, _]) = cell(141, at, [72, 72]);
        let cloud = rough(145, at, 4, 4) - 0.5;
        let stone = 1.0 - smooth(0.2, 0.5, near);
        let tone = random(149, key[0], key[1]);
        Texel {
            color: shade(mix([196.0, 196.0, 200.0], [255.0, 252.0, 248.0], stone * tone), 50.0 * cloud),
            height: 4.0 * stone,
            rough: 0.95 - 0.2 * stone * tone,
        }
    };
    Surface { pixels: 256, size: [3000.0; 2], texel: Box::new(texel) }
}

/// Bark with ridges along the stem: 0.8 m by 0.8 m.
pub fn bark() -> Surface {
    let texel = |at: [f64; 2], _: &str| {
        let bend = 0.06 * (rough(161, at, 4, 2) - 0.5);
        let (_, [near, second]) = cell(165, [at[0] + bend, at[1]], [12, 4]);
        let ridge = smooth(0.02, 0.3, second - near);
        let grain = rough(169, at, 32, 3) - 0.5;
        Texel {
            color: shade(mix([120.0, 112.0, 104.0], [244.0, 238.0, 230.0], ridge), 50.0 * grain),
            height: 14.0 * ridge + 3.0 * grain,
            rough: 1.0,
        }
    };
    Surface { pixels: 256, size: [800.0; 2], texel: Box::new(texel) }
}

/// The leaves of a crown or a hedge: 1 m by 1 m.
pub fn leaves() -> Surface {
    let texel = |at: [f64; 2], _: &str| {
        // Leaves in layers, the highest first. Deeper ones are in the shade of the others.
        let layers = 6;
        let found = (0..layers).find_map(|layer: u64| leaf(layer, at).map(|leaf| (layer, leaf)));
        let (layer, (tone, rise)) = found.unwrap_or((layers, (0.0, 0.0)));
        let depth = layer as f64 / layers as f64;
        let bright = 236.0 - 130.0 * depth - 40.0 * tone + 20.0 * rise;
        // Young leaves are yellower.
        let color = [bright + 12.0 * tone, bright + 14.0 * tone, bright - 50.0 * tone];
        Texel { color, height: 14.0 * rise + 60.0 * (1.0 - depth), rough: 0.85 - 0.15 * rise }
    };
    Surface { pixels: 256, size: [1000.0; 2], texel: Box::new(texel) }
}

/// The tone and the height of a leaf of a layer at a place, if there is one: an ellipse in each cell of a grid.
fn leaf(layer: u64, [u, v]: [f64; 2]) -> Option<(f64, f64)> {
    let cells = 11;
    let (x, y) = (u * cells as f64, v * cells as f64);
    let (left, low) = (x.floor() as i64, y.floor() as i64);
    (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy))).find_map(|(dx, dy)| {
        let key = [(left + dx).rem_euclid(cells), (low + dy).rem_euclid(cells)];
        let number = |part: u64| random(300 + 8 * layer + part, key[0], key[1]);
        let (px, py) = (x - (left + dx) as f64 - number(0), y - (low + dy) as f64 - number(1));
        // A direction of any angle, without a sine.
        let (a, b) = (number(2) - 0.5, number(3) - 0.5);
        let length = (a * a + b * b).sqrt().max(1e-6);
        let (along, across) = ((px * a + py * b) / length, (py * a - px * b) / length);
        let (long, wide) = (0.62, 0.3);
        let inside = 1.0 - (along / long) * (along / long) - (across / wide) * (across / wide);
        // The two halves rise to the sides of the middle rib.
        (0.0 < inside).then(|| (number(4), inside.sqrt() * 0.5 + across.abs()))
    })
}

/// Water with small waves: 6 m by 6 m.
pub fn water() -> Surface {
    let texel = |at: [f64; 2], _: &str| {
        let wave = rough(201, at, 6, 4);
        Texel { color: shade([244.0; 3], 24.0 * (wave - 0.5)), height: 90.0 * wave, rough: 0.08 }
    };
    Surface { pixels: 256, size: [6000.0; 2], texel: Box::new(texel) }
}
