//! Images that examples draw: walls, roofs, windows and streets. Each continues at its borders where that matters.
#![allow(dead_code, unreachable_pub, reason = "each example uses some")]

use cga::sink::picture::Image;

/// A repeatable random number in 0..1 for each place.
pub fn noise(x: i64, y: i64) -> f64 {
    let mut state = (x as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (y as u64).wrapping_mul(0xc2b2_ae3d_27d4_eb4f);
    state = (state ^ (state >> 31)).wrapping_mul(0xd6e8_feb8_6659_fd93);
    ((state ^ (state >> 32)) >> 40) as f64 / (1u64 << 24) as f64
}

/// A lighter or darker colour.
pub fn shade([r, g, b]: [u8; 3], by: f64) -> [u8; 4] {
    let channel = |value: u8| (f64::from(value) + by).clamp(0.0, 255.0) as u8;
    [channel(r), channel(g), channel(b), 255]
}

/// A surface of fine grains.
pub fn grain(size: usize, color: [u8; 3], depth: i64) -> Image {
    let mut image = Image::filled(size, size, [0; 4]);
    for (at, pixel) in image.rgba.as_chunks_mut::<4>().0.iter_mut().enumerate() {
        let (x, y) = ((at % size) as i64, (at / size) as i64);
        *pixel = shade(color, (noise(x, y) - 0.5) * depth as f64 * 2.0);
    }
    image
}

/// Courses of bricks, each moved by half a brick: 8 wide, 16 high.
pub fn bricks() -> Image {
    let mut image = grain(512, [196, 188, 176], 8);
    for course in 0..16 {
        for brick in -1..8_i64 {
            let tone = noise(brick.rem_euclid(8), course) * 36.0 - 18.0;
            let (x, y) = (brick * 64 + (course % 2) * 32, course * 32);
            image.rectangle(x + 2, y + 2, 60, 28, shade([156, 82, 62], tone));
            image.rectangle(x + 2, y + 2, 60, 2, shade([156, 82, 62], tone + 22.0));
        }
    }
    image
}

/// A window with a cross of bars.
pub fn window() -> Image {
    let mut image = Image::filled(256, 384, [238, 234, 224, 255]);
    for (column, row) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let (x, y, height) = (22 + column * 112, 22 + row * 130, if row == 0 { 112 } else { 210 });
        image.rectangle(x, y, 100, height, [52, 72, 86, 255]);
        for step in 0..40 {
            image.rectangle(x + step * 2, y + 40 - step, 4, 12, shade([72, 98, 114], 30.0 - step as f64));
        }
    }
    image
}

/// A shop window above a plinth.
pub fn shop() -> Image {
    let mut image = Image::filled(256, 512, [70, 52, 44, 255]);
    image.rectangle(16, 16, 224, 380, [96, 118, 122, 255]);
    image.rectangle(16, 16, 224, 60, [126, 146, 148, 255]);
    image.rectangle(16, 300, 224, 96, [150, 128, 92, 255]);
    image
}

/// Rows of roof tiles.
pub fn tiles() -> Image {
    let mut image = Image::filled(256, 256, [92, 46, 38, 255]);
    for row in 0..8 {
        for tile in -1..8_i64 {
            let tone = noise(tile.rem_euclid(8), 100 + row) * 30.0 - 15.0;
            image.rectangle(tile * 32 + (row % 2) * 16 + 1, row * 32 + 2, 30, 27, shade([150, 74, 58], tone));
        }
    }
    image
}

/// Square slabs.
pub fn slabs() -> Image {
    let mut image = grain(256, [146, 140, 130], 10);
    for (column, row) in (0..9).map(|slab| (slab % 3, slab / 3)) {
        let tone = noise(column, 50 + row) * 18.0 - 9.0;
        image.rectangle(column * 85 + 2, row * 85 + 2, 82, 82, shade([188, 182, 170], tone));
    }
    image
}
