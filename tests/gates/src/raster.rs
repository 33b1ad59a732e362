//! Pixels of triangles, with a margin around or inside of their edges.

/// A pixel belongs to a triangle if its middle is at least `inset` pixels inside; a negative number adds pixels around the edges, which
/// closes cracks between triangles whose edges meet. The third number of a corner is interpolated.
pub(crate) fn pixels(corners: [[f64; 3]; 3], size: [usize; 2], inset: f64, put: &mut impl FnMut(usize, f64)) {
    let [a, mut b, mut c] = corners;
    let mut area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if area < 0.0 {
        (b, c, area) = (c, b, -area);
    }
    // Seen from its edge, a triangle has no pixels.
    if area < 1e-9 {
        return;
    }
    let least = |axis: usize| a[axis].min(b[axis]).min(c[axis]);
    let most = |axis: usize| a[axis].max(b[axis]).max(c[axis]);
    let first = |axis: usize| (least(axis) - 0.5 + inset).ceil().max(0.0) as usize;
    let after = |axis: usize| ((most(axis) - 0.5 - inset).floor() + 1.0).clamp(0.0, size[axis] as f64) as usize;
    let edges = [(a, b), (b, c), (c, a)].map(|(p, q)| {
        let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
        let length = libm::hypot(dx, dy).max(1e-12);
        let [nx, ny] = [-dy / length, dx / length];
        [nx, ny, -(nx * p[0] + ny * p[1]) - inset]
    });
    let qx = ((b[2] - a[2]) * (c[1] - a[1]) - (c[2] - a[2]) * (b[1] - a[1])) / area;
    let qy = ((c[2] - a[2]) * (b[0] - a[0]) - (b[2] - a[2]) * (c[0] - a[0])) / area;
    let (low, high) = (least(2), most(2));
    for y in first(1)..after(1) {
        let middle = y as f64 + 0.5;
        let offsets = edges.map(|[_, ny, d]| ny * middle + d);
        let is_in =
            |x: usize| edges.iter().zip(offsets).all(|([nx, ..], offset)| 0.0 <= nx * (x as f64 + 0.5) + offset);
        // Rounding is less than the pixel at both ends.
        let (mut begin, mut end) = (first(0) as f64, after(0) as f64);
        for ([nx, ..], offset) in edges.iter().zip(offsets) {
            let zero = -offset / nx - 0.5;
            if 0.0 < *nx {
                begin = begin.max(zero - 1.0);
            } else if *nx < 0.0 {
                end = end.min(zero + 2.0);
            }
        }
        for x in (begin as usize..end.max(0.0) as usize).filter(|x| is_in(*x)) {
            let q = a[2] + qx * (x as f64 + 0.5 - a[0]) + qy * (middle - a[1]);
            put(y * size[0] + x, q.clamp(low, high));
        }
    }
}

/// Pixels of a triangle by the rules of graphics cards: corners are rounded to a grid of `grid` places in a pixel, and of two triangles with
/// a common edge, one has the pixels whose middle is on it.
pub(crate) fn snapped(corners: [[f64; 3]; 3], grid: f64, size: usize, put: &mut impl FnMut(usize, f64)) {
    let snap = |c: f64| (c * grid).round() as i64;
    let [a, mut b, mut c] = corners.map(|[x, y, q]| (snap(x), snap(y), q));
    let cross =
        |p: (i64, i64, f64), q: (i64, i64, f64), r: (i64, i64)| (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0);
    let mut area = cross(a, b, (c.0, c.1));
    if area < 0 {
        (b, c, area) = (c, b, -area);
    }
    if area == 0 {
        return;
    }
    let half = (grid * 0.5) as i64;
    let cell = grid as i64;
    let range = |values: [i64; 3]| {
        let (low, high) = (values.iter().min().copied().unwrap_or(0), values.iter().max().copied().unwrap_or(0));
        [(low - half).div_euclid(cell).max(0), ((high - half).div_euclid(cell) + 1).min(size as i64)]
    };
    let [xs, ys] = [range([a.0, b.0, c.0]), range([a.1, b.1, c.1])];
    // Edges on the left and on the top own their pixels.
    let owned = |p: (i64, i64, f64), q: (i64, i64, f64)| q.1 < p.1 || (q.1 == p.1 && p.0 < q.0);
    let edges = [(a, b), (b, c), (c, a)];
    for y in ys[0]..ys[1] {
        for x in xs[0]..xs[1] {
            let middle = (x * cell + half, y * cell + half);
            let values = edges.map(|(p, q)| cross(p, q, middle));
            let is_in = edges.iter().zip(values).all(|(&(p, q), value)| 0 < value || (value == 0 && owned(p, q)));
            if is_in {
                let [c_share, a_share, b_share] = values.map(|value| value as f64 / area as f64);
                put(y as usize * size + x as usize, a.2 * a_share + b.2 * b_share + c.2 * c_share);
            }
        }
    }
}
