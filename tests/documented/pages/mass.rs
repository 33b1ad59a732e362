//! *footprint*, *envelope* and *innerRectangle operations*.

use cga::Shape;

use super::example::{Example, example};

/// In the order of the pages.
pub(crate) const ALL: &[Example] = &[footprint::EXAMPLE];

example! {
    /// "A schematic low-poly version of a building is created by an extrusion of the footprint."
    footprint, "footprint operation", Shape::point([0.0, 0.0, 0.0]),
    r#"Example -->
    i("building.obj")
    ShowAsset.
    Footprint(scope.sy)
Footprint(height) -->
    footprint()
    extrude(height)
    set(material.opacity, 0.25)
"#
}
