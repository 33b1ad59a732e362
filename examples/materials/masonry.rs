//! Bricks, blocks of stone, plaster and paving.

use super::noise::{random, rough, smooth};
use super::surface::{Surface, Texel, mix, shade};

/// A place in a bond of stones: the number of the course, the number of the stone, and the distance in millimetres to the middle of the
/// nearest joint.
fn bond([u, v]: [f64; 2], size: [f64; 2], courses: i64, stones: i64) -> (i64, i64, f64) {
    let y = v * courses as f64;
    let course = y.floor() as i64;
    let x = u * stones as f64 + if course % 2 == 0 { 0.0 } else { 0.5 };
    let stone = (x.floor() as i64).rem_euclid(stones);
    let to_joint = |place: f64, length: f64| place.min(1.0 - place) * length;
    let across = to_joint(x - x.floor(), size[0] / stones as f64);
    let up = to_joint(y - y.floor(), size[1] / courses as f64);
    (course, stone, across.min(up))
}

/// Eight bricks across, sixteen courses: 1.8 m by 1.2 m.
pub fn brick() -> Surface {
    let size = [1800.0, 1200.0];
    let texel = move |at: [f64; 2], color: &str| {
        let (course, stone, joint) = bond(at, size, 16, 8);
        let grain = rough(1, at, 64, 3) - 0.5;
        let wear = rough(5, at, 5, 3);
        let [base, other] = match color {
            "yellow" => [[196.0, 164.0, 112.0], [168.0, 134.0, 92.0]],
            "brown" => [[128.0, 80.0, 64.0], [92.0, 58.0, 50.0]],
            _ => [[160.0, 84.0, 62.0], [126.0, 60.0, 46.0]],
        };
        let [tone, kind] = [random(9, stone, course), random(10, stone, course)];
        // A few bricks were burnt darker.
        let clay = mix(base, other, if kind < 0.12 { 1.0 } else { 0.55 * tone });
        let clay = shade(clay, 30.0 * grain + 14.0 * (wear - 0.5));
        let mortar = shade([188.0, 180.0, 166.0], 40.0 * grain + 20.0 * (wear - 0.5));
        let face = smooth(4.0, 8.0, joint + 4.0 * grain);
        Texel {
            color: mix(mortar, clay, face),
            height: 5.0 * face + 1.5 * grain + 1.5 * tone * face,
            rough: 0.95 - face * (0.1 + 0.12 * tone - 0.1 * grain),
        }
    };
    Surface { pixels: 512, size, texel: Box::new(texel) }
}

/// Blocks of hewn stone, three across and four courses: 2.7 m by 1.8 m.
pub fn ashlar() -> Surface {
    let size = [2700.0, 1800.0];
    let texel = move |at: [f64; 2], _: &str| {
        let (course, stone, joint) = bond(at, size, 4, 3);
        let (grain, cloud) = (rough(21, at, 48, 3) - 0.5, rough(25, at, 6, 4) - 0.5);
        let tone = random(29, stone, course) - 0.5;
        let face = smooth(4.0, 10.0, joint);
        let bevel = smooth(4.0, 26.0, joint);
        let block = shade([238.0, 234.0, 226.0], 26.0 * tone + 22.0 * grain + 30.0 * cloud);
        Texel {
            color: mix([176.0, 170.0, 160.0], block, face),
            height: 8.0 * bevel + 2.0 * grain + 2.0 * cloud,
            rough: 0.95 - face * (0.14 + 0.1 * tone - 0.12 * grain),
        }
    };
    Surface { pixels: 512, size, texel: Box::new(texel) }
}

/// Rough plaster: 2.4 m by 2.4 m.
pub fn plaster() -> Surface {
    let texel = |at: [f64; 2], _: &str| {
        let (grain, cloud) = (rough(41, at, 64, 3) - 0.5, rough(45, at, 4, 4) - 0.5);
        Texel {
            color: shade([241.0, 239.0, 235.0], 14.0 * grain + 34.0 * cloud),
            height: 4.0 * grain + 3.0 * cloud,
            rough: 0.95,
        }
    };
    Surface { pixels: 256, size: [2400.0; 2], texel: Box::new(texel) }
}

/// Slabs of 600 by 400 mm, three across and four courses: 1.8 m by 1.6 m.
pub fn paving() -> Surface {
    let size = [1800.0, 1600.0];
    let texel = move |at: [f64; 2], _: &str| {
        let (course, stone, joint) = bond(at, size, 4, 3);
        let (grain, cloud) = (rough(61, at, 64, 3) - 0.5, rough(65, at, 5, 4) - 0.5);
        let tone = random(69, stone, course) - 0.5;
        let face = smooth(3.0, 8.0, joint);
        let slab = shade([236.0, 233.0, 228.0], 34.0 * tone + 24.0 * grain + 24.0 * cloud);
        Texel {
            color: mix([138.0, 132.0, 122.0], slab, face),
            height: 4.0 * face + 1.0 * grain,
            rough: 0.95 - face * (0.15 + 0.12 * cloud - 0.1 * grain),
        }
    };
    Surface { pixels: 256, size, texel: Box::new(texel) }
}
