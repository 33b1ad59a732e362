//! Levels of detail: frames, sills and mouldings are shown near the camera, and fade out far away.

use bevy::camera::visibility::VisibilityRange;
use bevy::prelude::*;
use bevy_cga::{CgaGenerated, CgaMesh};

/// The rules of small parts. Walls, glass and roofs are shown at any distance.
const SMALL: [&str; 8] = ["Frame", "Timber", "Sill", "Lintel", "Moulding", "Step", "Wheels", "Pole"];

/// The distances in metres between which small parts fade out.
const FADES: std::ops::Range<f32> = 130.0..150.0;

/// Lets the small parts of a new model fade out.
pub(crate) fn fade(
    event: On<CgaGenerated>,
    children: Query<&Children>,
    meshes: Query<&CgaMesh>,
    mut commands: Commands,
) {
    for child in children.iter_descendants(event.root) {
        let rule = meshes.get(child).ok().and_then(|mesh| mesh.rule.as_deref());
        if rule.is_some_and(|rule| SMALL.contains(&rule)) {
            commands.entity(child).insert(VisibilityRange {
                start_margin: 0.0..0.0,
                end_margin: FADES,
                use_aabb: true,
            });
        }
    }
}
