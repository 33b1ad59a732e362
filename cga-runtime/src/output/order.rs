//! The order in which flat faces are painted over each other.
//!
//! If two faces overlap in the picture, their depth at a common point decides. Faces that do not overlap need no
//! order, and the farther one comes first. Cycles, which only cutting could resolve, are broken at the farthest face.

/// A face in the picture. Depth grows towards the viewer.
#[derive(Debug)]
pub(crate) struct Face {
    outline: Vec<[f64; 3]>,
    low: [f64; 2],
    high: [f64; 2],
    /// The depth as a plane over the picture: the middle, and the slopes.
    middle: [f64; 3],
    slope: [f64; 2],
}

impl Face {
    /// A face from corners in the picture with depth: at least three, not on a line.
    pub(crate) fn new(outline: Vec<[f64; 3]>) -> Face {
        let (mut low, mut high, mut middle) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2], [0.0; 3]);
        for point in &outline {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
            (0..3).for_each(|i| middle[i] += point[i] / outline.len() as f64);
        }
        // The normal, as a sum over all edges.
        let mut n = [0.0; 3];
        for (i, a) in outline.iter().enumerate() {
            let b = &outline[(i + 1) % outline.len()];
            for (axis, n) in n.iter_mut().enumerate() {
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                *n += (a[u] - middle[u]) * (b[v] - middle[v]) - (a[v] - middle[v]) * (b[u] - middle[u]);
            }
        }
        let slope = if n[2] == 0.0 { [0.0; 2] } else { [-n[0] / n[2], -n[1] / n[2]] };
        Face { outline, low, high, middle, slope }
    }

    fn depth(&self, x: f64, y: f64) -> f64 {
        self.middle[2] + self.slope[0] * (x - self.middle[0]) + self.slope[1] * (y - self.middle[1])
    }
}

/// Faces that overlap by less than this, in the units of the picture, only touch.
const SLIGHT: f64 = 0.05;

/// The amount by which `a` is nearer than `b` where they overlap; 0 if they do not overlap or the order is unclear.
fn nearer(a: &Face, b: &Face) -> f64 {
    let apart = |i: usize| a.high[i] - SLIGHT <= b.low[i] || b.high[i] - SLIGHT <= a.low[i];
    if apart(0) || apart(1) {
        return 0.0;
    }
    // For small faces, the common part of the convex hulls is close enough to the common part of the faces.
    let common = clip(&a.outline, &b.outline);
    let area = area(&common).abs();
    if area < SLIGHT * SLIGHT {
        return 0.0;
    }
    let count = common.len() as f64;
    let (x, y) = common.iter().fold((0.0, 0.0), |s, p| (s.0 + p[0] / count, s.1 + p[1] / count));
    a.depth(x, y) - b.depth(x, y)
}

fn area(ring: &[[f64; 2]]) -> f64 {
    let twice: f64 =
        (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()])).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum();
    0.5 * twice
}

/// The part of one outline within another, which is treated as convex.
fn clip(subject: &[[f64; 3]], window: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let flat = |p: &[f64; 3]| [p[0], p[1]];
    let mut kept: Vec<[f64; 2]> = subject.iter().map(flat).collect();
    let around: Vec<[f64; 2]> = window.iter().map(flat).collect();
    let turn = area(&around).signum();
    for i in 0..around.len() {
        let (a, b) = (around[i], around[(i + 1) % around.len()]);
        let side = |p: [f64; 2]| turn * ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]));
        let mut next = Vec::with_capacity(kept.len() + 1);
        for j in 0..kept.len() {
            let (p, q) = (kept[j], kept[(j + 1) % kept.len()]);
            let (sp, sq) = (side(p), side(q));
            if 0.0 <= sp {
                next.push(p);
            }
            if (0.0 < sp && sq < 0.0) || (sp < 0.0 && 0.0 < sq) {
                let t = sp / (sp - sq);
                next.push([p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t]);
            }
        }
        kept = next;
    }
    kept
}

/// The indices of the faces in the order of painting.
pub(crate) fn back_to_front(faces: Vec<&Face>) -> Vec<usize> {
    // Farther middles first, as a start and wherever other rules do not decide; equal ones in their given order.
    let mut start: Vec<usize> = (0..faces.len()).collect();
    start.sort_by(|&a, &b| faces[a].middle[2].total_cmp(&faces[b].middle[2]).then(a.cmp(&b)));
    let behind = behind(&faces, &start);
    // Paints the faces behind a face before it: a depth-first walk, without recursion.
    let mut order = Vec::with_capacity(faces.len());
    let mut state = vec![0u8; faces.len()];
    let mut stack: Vec<(usize, usize)> = Vec::new();
    for &root in &start {
        if state[root] != 0 {
            continue;
        }
        state[root] = 1;
        stack.push((root, 0));
        while let Some((face, next)) = stack.pop() {
            match behind[face].get(next) {
                Some(&other) => {
                    stack.push((face, next + 1));
                    if state[other] == 0 {
                        state[other] = 1;
                        stack.push((other, 0));
                    }
                }
                None => order.push(face),
            }
        }
    }
    order
}

/// For each face the faces behind it, found among neighbours on a grid.
fn behind(faces: &[&Face], start: &[usize]) -> Vec<Vec<usize>> {
    let mut behind = vec![Vec::new(); faces.len()];
    let reach = faces.iter().fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), |(l, h), f| {
        ([l[0].min(f.low[0]), l[1].min(f.low[1])], [h[0].max(f.high[0]), h[1].max(f.high[1])])
    });
    let cells = 1.max((faces.len() as f64).sqrt() as usize / 2).min(256);
    let cell = |i: usize, v: f64| {
        (((v - reach.0[i]) / (reach.1[i] - reach.0[i]).max(1e-9) * cells as f64) as usize).min(cells - 1)
    };
    let mut grid = vec![Vec::new(); cells * cells];
    for &face in start {
        let (low, high) = (faces[face].low, faces[face].high);
        for y in cell(1, low[1])..=cell(1, high[1]) {
            for x in cell(0, low[0])..=cell(0, high[0]) {
                let list: &mut Vec<usize> = &mut grid[y * cells + x];
                for &other in list.iter() {
                    // Each pair is compared once: in the cell where the common part of their boxes begins.
                    let first = |i: usize| cell(i, faces[other].low[i].max(low[i]));
                    if (first(0), first(1)) != (x, y) {
                        continue;
                    }
                    match nearer(faces[face], faces[other]) {
                        d if 1e-9 < d => behind[face].push(other),
                        d if d < -1e-9 => behind[other].push(face),
                        _ => {}
                    }
                }
                list.push(face);
            }
        }
    }
    behind
}
