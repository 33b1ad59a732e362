//! *footprint*, *envelope* and *innerRectangle operations*.

use crate::pages::{cutting, mass};

/// The union of the roofs with their eaves, and of the porch.
#[test]
fn the_footprint_of_a_building_has_its_eaves() {
    let model = mass::footprint::EXAMPLE.model(&cutting::settings());
    assert_eq!((model.count("ShowAsset"), model.count("Footprint")), (1, 1));
    let (volume, _) = model.leaves_of("Footprint").next().unwrap().mesh();
    assert!(volume.is_closed());
    // Roofs of 14 by 10 metres and of 6 by 4 in front of them, and the porch, 3 by 1 in front of the eaves.
    assert_eq!(volume.face_count(), 2 + 10);
    assert!((volume.volume() / 6.0 - (14.0 * 10.0 + 6.0 * 4.0 + 3.0)).abs() < 1e-6);
}
