//! `footprint`: the outline of the geometry as seen from above.

use crate::fault::FaultKind;
use crate::geometry::footprint::footprint as footprint_of;
use crate::geometry::overlay::OverlayError;
use crate::run::env::Env;
use crate::shape::Shape;

/// `footprint()`: replaces the geometry by its projection along the scope's y axis to the plane y = 0 of the scope, as faces
/// that look up (*footprint operation*). Faces that overlap are one, and places that no face covers are holes; each connected
/// part is a face. The scope is fitted to the result; its axes and the pivot stay. Tags, groups, materials of faces and texture
/// coordinates are lost.
///
/// Corners at which the outline runs straight on are dropped. Parts and holes that are narrower than 1e-7 of the geometry's
/// extent are dropped as rounding errors.
///
/// The geometry stays, with a fault, if it covers no area as seen from above, or if its edges cross so often that the result
/// would take seconds. The time grows with the number of edges that are next to each other as seen from above.
pub fn footprint(env: &mut Env, shape: &mut Shape) {
    if !shape.geometry.has_surface() {
        return;
    }
    let refuse = |env: &mut Env, why: &str| {
        env.fault(FaultKind::Geometry, format!("`footprint`: {why}; the geometry stays as it is"));
    };
    let mesh = shape.to_mesh();
    let made = footprint_of(&mesh);
    if env.spend(0).is_break() {
        return;
    }
    match made {
        Ok(made) if made.is_empty() => refuse(env, "the geometry covers no area"),
        Ok(made) => {
            if env.count_corners(made.corners().len() as u64).is_continue() {
                shape.set_mesh(made);
            }
        }
        Err(OverlayError::TooMany) => refuse(env, "too many edges cross"),
        Err(OverlayError::Tangled) => refuse(env, "edges are too near to each other"),
    }
}

#[cfg(test)]
mod tests;
