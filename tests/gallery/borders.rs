//! The borders of scopes, which the page draws as edges.

use std::sync::Arc;

use cga::{Color, Geometry, Leaf, Material, Model, Quad, Scope, Sink, Text};

use super::captions::SCOPE;

/// The height in metres above the drawn scopes.
const LIFT: f64 = 0.02;

/// The model with black strips of that width inside the borders of its drawn scopes (*splitArea operation*, adjust
/// vs. noAdjust: `comp(e) { all : color(0, 0, 0) Edge. }`).
pub fn with_scopes(model: &Model, width: f64) -> Model {
    let mut out = Model::new();
    let _ = model.replay(&mut out);
    let mut black = Material::default();
    black.color = Some(Color::new(0.0, 0.0, 0.0));
    let material = Arc::new(black);
    for leaf in model.leaves_of(SCOPE) {
        let Geometry::Quad(rectangle) = leaf.geometry() else { continue };
        let corners = rectangle.corners();
        let lift = rectangle.u.cross(rectangle.v).normalize_or_zero() * LIFT;
        for at in 0..4 {
            let [from, to, next] = [0, 1, 2].map(|step| corners[(at + step) % 4]);
            let inwards = (next - to).normalize_or_zero() * width;
            let strip = Quad::new(from + lift, to - from, inwards);
            let scope = Scope { origin: strip.origin, ..leaf.scope() };
            let _ = out.quad(&Leaf::new(&Text::fixed("Edge"), &material, &scope), &strip);
        }
    }
    out
}
