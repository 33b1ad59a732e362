//! *primitive operations*: their texture coordinates, shown by the test texture.

use cga::Shape;

use super::example::{Example, example};

/// All of them, in the page's order.
pub const ALL: &[Example] = &[
    quad::EXAMPLE,
    quad_sized::EXAMPLE,
    disk::EXAMPLE,
    disk_sized::EXAMPLE,
    cube::EXAMPLE,
    cube_sized::EXAMPLE,
    sphere::EXAMPLE,
    sphere_sized::EXAMPLE,
    cylinder::EXAMPLE,
    cylinder_sized::EXAMPLE,
    cone::EXAMPLE,
    cone_sized::EXAMPLE,
];

fn lot() -> Shape {
    Shape::rectangle(25.0, 20.0)
}

example! {
    /// "The inserted quad is fit into the current scope yz dimension."
    quad, "primitiveQuad operation: fitted", lot(),
    r##"Lot-->
    rotateScope(0, 0, 90) // scope.sx is 0
    primitiveQuad()
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted quad has a width of 10, a length of 20 and is positioned in the yz center."
    quad_sized, "primitiveQuad operation: with a size", lot(),
    r##"Lot-->
    rotateScope(0, 0, 90) // scope.sx is 0
    primitiveQuad(10,20)
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted disk has 16 vertices and is fit into the current scope xy dimension."
    disk, "primitiveDisk operation: fitted", lot(),
    r##"Lot-->
    rotateScope(-90, 0, 0) // scope.sz is 0
    primitiveDisk()
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted disk has 8 vertices, a radius of 10 and is positioned in the xy center."
    disk_sized, "primitiveDisk operation: with a radius", lot(),
    r##"Lot-->
    rotateScope(-90, 0, 0) // scope.sz is 0
    primitiveDisk(8,10)
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The scope's zero size is modified relative to the average of the two non-zero sizes."
    cube, "primitiveCube operation: fitted", lot(),
    r##"Lot-->
    primitiveCube()
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted cube has a width of 10, a height of 15, a depth of 20 and is positioned in the xz center."
    cube_sized, "primitiveCube operation: with sizes", lot(),
    r##"Lot-->
    primitiveCube(10,15,20)
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted sphere has 16 sides, 16 divisions and is fit into the current scope."
    sphere, "primitiveSphere operation: fitted", lot(),
    r##"Lot-->
    primitiveSphere()
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted sphere has 8 sides, 4 divisions, a radius of 10 and is positioned in the xz center."
    sphere_sized, "primitiveSphere operation: with a radius", lot(),
    r##"Lot-->
    primitiveSphere(8,4,10)
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted cylinder has 16 sides and is fit into the current scope."
    cylinder, "primitiveCylinder operation: fitted", lot(),
    r##"Lot-->
    primitiveCylinder()
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted cylinder has 8 sides, a radius of 10, a height of 15 and is positioned in the xz center."
    cylinder_sized, "primitiveCylinder operation: with sizes", lot(),
    r##"Lot-->
    primitiveCylinder(8,10,15)
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted cone has 16 sides and is fit into the current scope."
    cone, "primitiveCone operation: fitted", lot(),
    r##"Lot-->
    primitiveCone()
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The inserted cone has 8 sides, a radius of 10, a height of 15 and is positioned in the xz center."
    cone_sized, "primitiveCone operation: with sizes", lot(),
    r##"Lot-->
    primitiveCone(8,10,15)
    texture("builtin:uvtest.png")
"##
}
