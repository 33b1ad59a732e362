//! Rasterisation of triangles.

use cga_geometry::each::Each;

/// Corners are rounded to multiples of `1 / GRID` pixels. Edge functions are then exact in `f64`, so triangles that
/// share an edge neither share nor omit a pixel.
const GRID: f64 = 256.0;

/// Calls `put` with index and nearness of each pixel whose centre is in a triangle. Corners have x and y in pixels
/// from the upper left and a third number that is interpolated. Both windings are allowed.
#[inline]
pub(crate) fn triangle(corners: [[f64; 3]; 3], width: usize, height: usize, mut put: impl FnMut(usize, f64)) {
    // Far outside the picture, products would no longer be exact; nothing there is visible.
    const FAR: f64 = 1e6;
    if corners.iter().any(|p| !(p[0].abs() < FAR && p[1].abs() < FAR)) {
        return;
    }
    let snap = |c: f64| (c * GRID) as i64 as f64 / GRID;
    let [a, mut b, mut c] = corners.each(|[x, y, q]| [snap(x), snap(y), q]);
    let mut area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if area < 0.0 {
        (b, c, area) = (c, b, -area);
    }
    if area == 0.0 {
        return;
    }
    let (low_y, high_y) = (a[1].min(b[1]).min(c[1]), a[1].max(b[1]).max(c[1]));
    let (low_x, high_x) = (a[0].min(b[0]).min(c[0]), a[0].max(b[0]).max(c[0]));
    let first = |low: f64| (low - 0.5).max(0.0).ceil() as usize;
    let after = |high: f64, size: usize| ((high - 0.5).floor() + 1.0).clamp(0.0, size as f64) as usize;
    let (y0, y1) = (first(low_y), after(high_y, height));
    let (x0, x1) = (first(low_x), after(high_x, width));
    if x1 <= x0 || y1 <= y0 {
        return;
    }
    // A pixel is inside if all three are positive, or zero for an edge on the left or the top.
    let edge = |p: [f64; 3], q: [f64; 3]| {
        let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
        let owned = dy < 0.0 || (dy == 0.0 && 0.0 < dx);
        let bias = if owned { 0.0 } else { 0.25 / (GRID * GRID) };
        let (px, py) = (x0 as f64 + 0.5 - p[0], y0 as f64 + 0.5 - p[1]);
        (dx * py - dy * px - bias, -dy, dx)
    };
    let edges = [edge(a, b), edge(b, c), edge(c, a)];
    let (q_low, q_high) = (a[2].min(b[2]).min(c[2]), a[2].max(b[2]).max(c[2]));
    // It follows from the corners before they were rounded, so that faces in one plane have the same nearness.
    let [a, b, c] = corners;
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if area == 0.0 {
        return;
    }
    let qx = ((b[2] - a[2]) * (c[1] - a[1]) - (c[2] - a[2]) * (b[1] - a[1])) / area;
    let qy = ((c[2] - a[2]) * (b[0] - a[0]) - (b[2] - a[2]) * (c[0] - a[0])) / area;
    let q0 = a[2] + qx * (x0 as f64 + 0.5 - a[0]) + qy * (y0 as f64 + 0.5 - a[1]);
    let columns = (x1 - x0) as f64;
    for y in y0..y1 {
        let dy = (y - y0) as f64;
        let (mut from, mut to) = (0.0, columns);
        for &(start, along, down) in &edges {
            let value = start + down * dy;
            if along == 0.0 {
                if value < 0.0 {
                    to = 0.0;
                }
                continue;
            }
            // The division may be off in the last digit; the edge function decides between neighbours.
            let at = (-value / along).clamp(-1.0, columns + 1.0);
            if 0.0 < along {
                let mut x = at.ceil();
                if 0.0 <= value + along * (x - 1.0) {
                    x -= 1.0;
                } else if value + along * x < 0.0 {
                    x += 1.0;
                }
                from = x.max(from);
            } else {
                let mut x = at.floor();
                if 0.0 <= value + along * (x + 1.0) {
                    x += 1.0;
                } else if value + along * x < 0.0 {
                    x -= 1.0;
                }
                to = (x + 1.0).min(to);
            }
        }
        if to <= from {
            continue;
        }
        let row = y * width + x0;
        let q_row = q0 + qy * dy;
        for x in from as usize..to as usize {
            // Slivers have steep slopes, but a pixel is never nearer or farther than all corners.
            put(row + x, (q_row + qx * x as f64).clamp(q_low, q_high));
        }
    }
}

/// Raises the texels of a map, `width` in a row, to a triangle. Faster than [`triangle`] but not exact: it is for
/// depth maps of lights, where a missing or doubled texel does not show. The map is a square; parts outside are left out.
#[inline]
pub(crate) fn raise([a, b, c]: [[f32; 3]; 3], width: usize, map: &mut [f32]) {
    let (y_low, y_high) = (a[1].min(b[1]).min(c[1]), a[1].max(b[1]).max(c[1]));
    let (x_low, x_high) = (a[0].min(b[0]).min(c[0]), a[0].max(b[0]).max(c[0]));
    // Texel centres are at halves.
    let (y0, y1) = ((y_low + 0.5) as usize, ((y_high + 0.5) as usize).min(width));
    if y1 <= y0 || (x_low + 0.5) as usize == (x_high + 0.5) as usize {
        return;
    }
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if area == 0.0 {
        return;
    }
    let qx = ((b[2] - a[2]) * (c[1] - a[1]) - (c[2] - a[2]) * (b[1] - a[1])) / area;
    let qy = ((c[2] - a[2]) * (b[0] - a[0]) - (b[2] - a[2]) * (c[0] - a[0])) / area;
    let (q_low, q_high) = (a[2].min(b[2]).min(c[2]), a[2].max(b[2]).max(c[2]));
    let sides = [(a, b), (b, c), (c, a)].each(|(p, q)| {
        let (p, q) = if p[1] <= q[1] { (p, q) } else { (q, p) };
        (p, q[1], if p[1] < q[1] { (q[0] - p[0]) / (q[1] - p[1]) } else { 0.0 })
    });
    for y in y0..y1 {
        let at = y as f32 + 0.5;
        let (mut from, mut to) = (x_high, x_low);
        for &(p, end, slope) in &sides {
            if p[1] <= at && at <= end {
                let x = p[0] + (at - p[1]) * slope;
                from = from.min(x);
                to = to.max(x);
            }
        }
        let (first, last) = ((from.max(x_low) + 0.5) as usize, ((to.min(x_high) + 0.5) as usize).min(width));
        if last <= first {
            continue;
        }
        let q = a[2] + (at - a[1]) * qy + (first as f32 + 0.5 - a[0]) * qx;
        let Some(row) = map.get_mut(y * width + first..y * width + last) else { continue };
        for (i, texel) in row.iter_mut().enumerate() {
            // This form compiles to a minimum and two maxima without a branch.
            let q = q + i as i32 as f32 * qx;
            let q = if q < q_high { q } else { q_high };
            let q = if q_low < q { q } else { q_low };
            *texel = if *texel < q { q } else { *texel };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cover(corners: [[f64; 2]; 3], hits: &mut [u32]) {
        triangle(corners.map(|[x, y]| [x, y, 0.0]), 16, 16, |i, _| hits[i] += 1);
    }

    #[test]
    fn a_fan_covers_every_pixel_once() {
        let mut state = 1u64;
        for _ in 0..2000 {
            let mut random = || {
                state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                ((state >> 33) % 65) as f64 * 0.25
            };
            // The point common to the four may be inside, on edges, or on pixel centres.
            let m = [random(), random()];
            let corners = [[0.0, 0.0], [16.0, 0.0], [16.0, 16.0], [0.0, 16.0]];
            let mut hits = [0; 256];
            for i in 0..4 {
                cover([m, corners[i], corners[(i + 1) % 4]], &mut hits);
            }
            assert_eq!(hits, [1; 256], "{m:?}");
        }
    }

    #[test]
    fn the_third_coordinate_is_linear() {
        let plane = |x: f64, y: f64| 1.0 + 0.5 * x - 0.25 * y;
        let corners = [[1.0, 2.0], [14.0, 3.0], [6.0, 15.0]].map(|[x, y]| [x, y, plane(x, y)]);
        let mut count = 0;
        triangle(corners, 16, 16, |i, q| {
            assert!((q - plane((i % 16) as f64 + 0.5, (i / 16) as f64 + 0.5)).abs() < 1e-12);
            count += 1;
        });
        assert!(70 < count);
    }
}
