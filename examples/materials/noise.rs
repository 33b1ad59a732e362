//! Repeatable noise that continues at its borders.

/// A repeatable random number in 0..1 for each place of a layer.
pub fn random(layer: u64, x: i64, y: i64) -> f64 {
    let mut state = (x as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (y as u64).wrapping_mul(0xc2b2_ae3d_27d4_eb4f);
    state ^= layer.wrapping_mul(0x1656_67b1_9e37_79f9);
    state = (state ^ (state >> 31)).wrapping_mul(0xd6e8_feb8_6659_fd93);
    state = (state ^ (state >> 29)).wrapping_mul(0x9fb2_1c65_1e98_df25);
    ((state ^ (state >> 32)) >> 40) as f64 / (1u64 << 24) as f64
}

/// From 0 to 1 without a bend at either end.
pub fn smooth(low: f64, high: f64, value: f64) -> f64 {
    let t = ((value - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Soft noise in 0..1: `cells` across and up the image, at a place with coordinates in 0..1.
pub fn soft(layer: u64, [u, v]: [f64; 2], cells: [i64; 2]) -> f64 {
    let (x, y) = (u * cells[0] as f64, v * cells[1] as f64);
    let (left, low) = (x as i64, y as i64);
    let (fx, fy) = (smooth(0.0, 1.0, x - left as f64), smooth(0.0, 1.0, y - low as f64));
    let next = |cell: i64, cells: i64| if cell + 1 == cells { 0 } else { cell + 1 };
    let (right, high) = (next(left, cells[0]), next(low, cells[1]));
    let row = |y: i64| {
        let start = random(layer, left, y);
        start + (random(layer, right, y) - start) * fx
    };
    let start = row(low);
    start + (row(high) - start) * fy
}

/// Noise of several sizes in 0..1: `cells` along a side of the largest, `octaves` of half the size each.
pub fn rough(layer: u64, at: [f64; 2], cells: i64, octaves: u32) -> f64 {
    let (mut sum, mut whole) = (0.0, 0.0);
    for octave in 0..octaves {
        let weight = 1.0 / f64::from(1 << octave);
        sum += weight * soft(layer + u64::from(octave), at, [cells << octave; 2]);
        whole += weight;
    }
    sum / whole
}

/// The cell of the nearest of scattered points, also outside of the image, and the distances to the nearest and to the second: `cells` across and up.
pub fn cell(layer: u64, [u, v]: [f64; 2], cells: [i64; 2]) -> ([i64; 2], [f64; 2]) {
    let (x, y) = (u * cells[0] as f64, v * cells[1] as f64);
    let (left, low) = (x.floor() as i64, y.floor() as i64);
    let (mut nearest, mut distances) = ([0, 0], [f64::INFINITY; 2]);
    for (dx, dy) in (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (dx, dy))) {
        let key = [(left + dx).rem_euclid(cells[0]), (low + dy).rem_euclid(cells[1])];
        let at = |layer, start: i64, key: [i64; 2]| start as f64 + 0.1 + 0.8 * random(layer, key[0], key[1]);
        let (px, py) = (at(layer, left + dx, key), at(layer + 1, low + dy, key));
        let distance = ((px - x) * (px - x) + (py - y) * (py - y)).sqrt();
        if distance < distances[0] {
            (nearest, distances) = (key, [distance, distances[0]]);
        } else if distance < distances[1] {
            distances[1] = distance;
        }
    }
    (nearest, distances)
}
