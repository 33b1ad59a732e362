//! Thin dark lines along silhouettes and creases.
//!
//! Nearness is linear in the picture over a plane, so the plane of a surface goes on beyond its edge. Two surfaces whose planes cross
//! between two samples meet in a crease; others are at a step. Normals give the strength of creases.

use cga_geometry::each::Each;
use glam::DVec3;

use crate::scene::Scene;
use crate::viewport::Viewport;
use crate::visible::{GROUND, SKY, VisibilityBuffer};

/// The lines that are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lines {
    /// No lines.
    None,
    /// Silhouettes and creases.
    Edges,
    /// Silhouettes, creases, and the borders between leaves in one plane.
    Leaves,
    /// Silhouettes, creases, and all borders between faces and with the ground, on transparent surfaces too.
    Faces,
}

/// The strength of the line at each sample, 0 to 1.
pub(crate) fn lines(scene: &Scene, view: &Viewport, layer: &VisibilityBuffer, lines: Lines) -> Vec<f32> {
    let (width, height) = (layer.width, layer.height);
    let mut dark = vec![0.0f32; width * height];
    let planes = layer.planes(scene);
    for y in 0..height {
        for x in 0..width {
            let a = y * width + x;
            // The sample to the right and the one below.
            for (step, at, count) in [(1, x, width), (width, y, height)] {
                let b = a + step;
                if count <= at + 1 || layer.seen[a] == layer.seen[b] {
                    continue;
                }
                let border = border(scene, [layer.seen[a], layer.seen[b]], lines);
                let strength = match planes[a] == planes[b] {
                    true if border == 0.0 => continue,
                    true => border,
                    false => {
                        let (before, after) = (a.checked_sub(step), b + step);
                        let (before, after) = (before.filter(|_| 0 < at), (at + 2 < count).then_some(after));
                        strength(scene, view, layer, [a, b], [before, after]).max(border)
                    }
                };
                // The line is on the nearer side, where the edge is.
                let near = if layer.near[a] < layer.near[b] { b } else { a };
                let far = if near == a { b } else { a };
                dark[near] = dark[near].max(strength);
                dark[far] = dark[far].max(0.5 * strength);
            }
        }
    }
    dark
}

/// The least strength of the line between two samples, for the leaves or faces that they show.
fn border(scene: &Scene, seen: [u32; 2], lines: Lines) -> f32 {
    let [a, b] = seen.each(|seen| scene.triangles.get(seen as usize));
    match (lines, a, b) {
        (Lines::Leaves, Some(a), Some(b)) if a.plane == b.plane && a.leaf != b.leaf => 0.5,
        (Lines::Faces, Some(a), Some(b)) if a.face != b.face => 0.8,
        (Lines::Faces, Some(_), None) | (Lines::Faces, None, Some(_)) => 1.0,
        _ => 0.0,
    }
}

fn normal(scene: &Scene, seen: u32) -> Option<DVec3> {
    match seen {
        SKY => None,
        GROUND => Some(DVec3::Y),
        seen => Some(scene.triangles[seen as usize].normal()),
    }
}

/// The strength of the line between two samples, with the samples before and after them.
fn strength(
    scene: &Scene,
    view: &Viewport,
    layer: &VisibilityBuffer,
    [a, b]: [usize; 2],
    [before, after]: [Option<usize>; 2],
) -> f32 {
    // The ground fades into the backdrop.
    if matches!([layer.seen[a], layer.seen[b]], [SKY, GROUND] | [GROUND, SKY]) {
        return 0.0;
    }
    let (Some(na), Some(nb)) = (normal(scene, layer.seen[a]), normal(scene, layer.seen[b])) else { return 1.0 };
    // A step: neither surface, extended, meets the other.
    let (qa, qb) = (layer.near[a], layer.near[b]);
    let plane = |from: usize, at: usize| {
        let triangle = scene.triangles.get(layer.seen[from] as usize)?;
        let pixel = [(at % layer.width) as f64 + 0.5, (at / layer.width) as f64 + 0.5];
        let near = view.plane_nearness(triangle.corners()[0], triangle.normal(), pixel) as f32;
        near.is_finite().then_some(near)
    };
    // The ground has no triangle, so its plane follows from two samples.
    let sampled = |from: usize, side: Option<usize>, other: f32| match side {
        Some(side) if layer.seen[side] == layer.seen[from] => (2.0 * layer.near[from] - layer.near[side] - other).abs(),
        _ => (layer.near[from] - other).abs(),
    };
    let gap = match (plane(b, a), plane(a, b)) {
        (Some(other_at_a), Some(own_at_b)) => {
            let (at_a, at_b) = (qa - other_at_a, own_at_b - qb);
            let is_met = at_a * at_b <= 0.0;
            if is_met { 0.0 } else { at_a.abs().min(at_b.abs()) }
        }
        _ => sampled(a, before, qb).min(sampled(b, after, qa)),
    };
    let step = gap / qa.abs().max(qb.abs()).max(1e-12);
    let step = (step * 800.0 - 0.4).clamp(0.0, 1.0);
    // A crease: surfaces that meet at an angle. The facets of a round surface do not count.
    let crease = ((0.94 - na.dot(nb).abs()) * 4.0).clamp(0.0, 1.0) as f32;
    step.max(0.75 * crease)
}
