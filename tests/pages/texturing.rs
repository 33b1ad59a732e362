//! *split operation* (UV split), *tileUV*, *setupProjection*, *projectUV*, *texture* and *rotateUV operation*: the examples with
//! texture coordinates.
//!
//! The pages' own images (bricks, an ortho photo) are replaced by `builtin:uvtest.png`. Where a page leaves rules out, as in `…`, others are
//! added after an empty line.

use cga::Shape;
use cga::street::{Centerline, Network, NetworkOptions};

use super::example::{Example, example};

/// All of them, in the pages' order.
pub const ALL: &[Example] = &[
    uv_space::EXAMPLE,
    unit_space::EXAMPLE,
    street::EXAMPLE,
    bands::EXAMPLE,
    default_uv::EXAMPLE,
    tiled_badly::EXAMPLE,
    tiled_well::EXAMPLE,
    on_the_facade::EXAMPLE,
    on_each_wall::EXAMPLE,
    without_uw::EXAMPLE,
    with_uw::EXAMPLE,
    global::EXAMPLE,
    global_offsets::EXAMPLE,
    textured::EXAMPLE,
    standard_uv::EXAMPLE,
    rotated_uv::EXAMPLE,
];

fn lot() -> Shape {
    Shape::rectangle(20.0, 12.0)
}

/// The street of *tileUV operation*: seven faces, about 83 m long and 14 m wide.
///
/// # Panics
/// When the street cannot be laid out.
pub fn tiled_street() -> Shape {
    let line = [[0.0, 0.0], [12.0, 0.2], [24.0, 0.6], [36.0, 1.0], [48.0, 1.2], [60.0, 1.2], [72.0, 0.8], [83.0, 0.0]];
    streets(&[Centerline::new(&line).roadway(14.0).sidewalks(0.0, 0.0)]).remove(0)
}

/// The two segments of the street of *split operation*: a long bent one and a short one.
pub fn two_segments() -> Vec<Shape> {
    let bent = [[0.0, 0.0], [16.0, 3.5], [32.0, 8.0], [47.0, 13.5], [62.0, 17.5], [72.0, 18.0], [80.0, 16.5]];
    let straight = [[80.0, 16.5], [108.0, -8.0]];
    streets(&[Centerline::new(&bent), Centerline::new(&straight)])
}

/// The roadways of some lines, each as the graph has it.
pub(super) fn streets(lines: &[Centerline]) -> Vec<Shape> {
    let network = Network::new(lines, &NetworkOptions::default()).expect("streets");
    network.parts().iter().filter(|part| part.start_rule() == "Street").map(|part| part.shape()).collect()
}

example! {
    /// "The split happens at u = 0.5, independent of facade size."
    uv_space, "split operation, UV Split Basics: uvSpace", Shape::rectangle(20.0, 12.0),
    r##"Init-->
    extrude(scope.sx * 0.5)
    comp(f) { front : Facade }
Facade-->
    setupProjection(0, scope.xy, '1, '1)
    projectUV(0)
    texture("builtin:uvtest.png")
    split(u, uvSpace, 0) { 0.5 : X }*
"##
}

example! {
    /// "The splits happen at u = 5, dependent of facade size."
    unit_space, "split operation, UV Split Basics: unitSpace", Shape::rectangle(20.0, 12.0),
    r##"Init-->
    extrude(scope.sx * 0.5)
    comp(f) { front : Facade }
Facade-->
    setupProjection(0, scope.xy, '1, '1)
    projectUV(0)
    texture("builtin:uvtest.png")
    split(u, unitSpace, 0) { 5 : X }*
"##
}

example! {
    /// "The two street segments have different lengths but are both covered by a \[0,1\] uv space."
    street, "split operation, UV Split on Streets: test texture", two_segments().remove(0),
    r##"Street-->
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "Every 20 meters a 3 meter wide band": the rule makes one of about 3 in every 23.
    bands, "split operation, UV Split on Streets: bands", two_segments().remove(0),
    r##"Street-->
    split(u, unitSpace, 0) { ~10 : NIL | ~3 : color("#ff0000") X | ~10 : NIL}*
"##
}

example! {
    /// "The default texture coordinates."
    default_uv, "tileUV operation, Street Tiling: default", tiled_street(),
    r##"Street-->
    texture("builtin:uvtest.png")
"##
}

example! {
    /// "The tile width (in u-direction) is exactly 20 meters and the tile height is exactly 10 meters. Some tiles are cut."
    tiled_badly, "tileUV operation, Street Tiling: tiles are cut", tiled_street(),
    r##"Street-->
    texture("builtin:uvtest.png")
    tileUV(0, 20, 10)
"##
}

example! {
    /// "The tile width is roughly 20 meters, such that the whole available space is exactly filled, and exactly two tiles fit in."
    tiled_well, "tileUV operation, Street Tiling: usage of ~ and '", tiled_street(),
    r##"Street-->
    texture("builtin:uvtest.png")
    tileUV(0, ~20, '0.5)
"##
}

example! {
    /// The projection of the façade runs through all walls.
    on_the_facade, "setupProjection operation, Scope vs. setupProjection: on the facade", Shape::rectangle(9.0, 6.0),
    r##"Frontfacade -->
    setupProjection(0, scope.xy, 1.5, 1, 0, 0, 1)
    setupProjection(2, scope.xy, scope.sx, scope.sy, 0, 0, 1)
    split(y){ groundfloor_height : Floor | { ~floor_height : Floor }* }
Wall -->
    color(wallColor)
    set(material.colormap, wall_tex)
    projectUV(0) projectUV(2)

const groundfloor_height = 4
const floor_height = 3
const wallColor = "#ffffff"
const wall_tex = "builtin:uvtest.png"
@StartRule
Lot --> extrude(7) comp(f) { front : Frontfacade }
Floor --> split(x) { 1.2 : Wall | { ~3.3 : Tile }* | 1.2 : Wall }
Tile --> split(x) { ~0.9 : Wall | 1.4 : Column | ~0.9 : Wall }
Column --> split(y) { 0.8 : Wall | ~1.5 : NIL | 0.7 : Wall }
"##
}

example! {
    /// "The brick texture does not span over the whole facade anymore; there are visible seams."
    on_each_wall, "setupProjection operation, Scope vs. setupProjection: on each wall", Shape::rectangle(9.0, 6.0),
    r##"Frontfacade -->
    setupProjection(2, scope.xy, scope.sx, scope.sy, 0, 0, 1)
    split(y){ groundfloor_height : Floor | { ~floor_height : Floor }* }
Wall -->
    color(wallColor)
    setupProjection(0, scope.xy, 1.5, 1, 0, 0, 1)
    set(material.colormap, wall_tex)
    projectUV(0) projectUV(2)

const groundfloor_height = 4
const floor_height = 3
const wallColor = "#ffffff"
const wall_tex = "builtin:uvtest.png"
@StartRule
Lot --> extrude(7) comp(f) { front : Frontfacade }
Floor --> split(x) { 1.2 : Wall | { ~3.3 : Tile }* | 1.2 : Wall }
Tile --> split(x) { ~0.9 : Wall | 1.4 : Column | ~0.9 : Wall }
Column --> split(y) { 0.8 : Wall | ~1.5 : NIL | 0.7 : Wall }
"##
}

example! {
    /// Projection along w "sometimes results in artifacts like on this doorframe".
    without_uw, "setupProjection operation, Working with the z- resp. w-coordinate: uwFactor 0", lot(),
    r##"Lot --> s(6, 4, 1) primitiveCube() setupProjection(0, scope.xy, 1.5, 1, 0, 0, 0) Front

Front --> split(x) { ~1 : Wall | 2 : Door | ~1 : Wall }
Door  --> split(y) { 3 : NIL | ~1 : Wall }
Wall  --> texture("builtin:uvtest.png") projectUV(0)
"##
}

example! {
    /// "This feature is sometimes useful to bend textures around corners."
    with_uw, "setupProjection operation, Working with the z- resp. w-coordinate: uwFactor 1", lot(),
    r##"Lot --> s(6, 4, 1) primitiveCube() setupProjection(0, scope.xy, 1.5, 1, 0, 0, 1) Front

Front --> split(x) { ~1 : Wall | 2 : Door | ~1 : Wall }
Door  --> split(y) { 3 : NIL | ~1 : Wall }
Wall  --> texture("builtin:uvtest.png") projectUV(0)
"##
}

example! {
    /// The same image on all roofs: "an inverted texture along the v-axis" is "corrected with the scaleUV() operation".
    global, "setupProjection operation, Global Texture Projection", Shape::rectangle(300.0, 200.0).at([100.0, 0.0, -350.0]),
    r##"attr buildingheight = 20
@StartRule
Lot -->
    set(trim.vertical, false)
    extrude(buildingheight)
    comp(f) {top : Roof | side : Facade}
Roof -->
    setupProjection(0, world.xz, 586, 442)
    projectUV(0)
    scaleUV(0, 1, -1)
    set(material.colormap, "builtin:uvtest.png")
"##
}

example! {
    /// "Artifacts due to numerical issues can be avoided by using the offset parameters."
    global_offsets, "setupProjection operation, Global Texture Projection: with offsets",
    Shape::rectangle(300.0, 200.0).at([100.0 + 586.0 * 7.0, 0.0, 442.0 * 6.0 - 350.0]),
    r##"attr buildingheight = 20
const textureWidth = 586
const textureHeight = 442
offsetx = convert(x, scope, world, pos, 0, 0, 0) -
    (convert(x, scope, world, pos, 0, 0, 0) % textureWidth)
offsetz = convert(z, scope, world, pos, 0, 0, 0) -
    (convert(z, scope, world, pos, 0, 0, 0) % textureHeight)
@StartRule
Lot -->
    set(trim.vertical, false)
    extrude(buildingheight)
    comp(f) {top : Roof | side : Facade}
Roof -->
    setupProjection(0, world.xz, textureWidth, textureHeight, -offsetx, offsetz)
    projectUV(0)
    scaleUV(0, 1, -1)
    set(material.colormap, "builtin:uvtest.png")
"##
}

example! {
    /// Tiles of 5 m on all sides.
    textured, "texture operation", lot(),
    r##"brickMap = "builtin:uvtest.png"
randBuildingHeight = rand(3,20)
Lot -->
    s('.75,'1,'.75)
    center(xz)
    extrude(world.up, randBuildingHeight)
    comp(f){side: Facade | top: set(material.color.a, .3) Roof.}
Facade -->
    # color, uv set 0
    setupProjection(0, scope.xy, 5, 5)
    texture(brickMap)
    // = set(material.colormap,brickMap)
    projectUV(0)
"##
}

example! {
    /// "Example with standard uvs".
    standard_uv, "rotateUV operation: standard uvs", lot(),
    r##"brickMap = "builtin:uvtest.png"
randBuildingHeight = 10
Lot -->
    s('.75,'1,'.75)
    center(xz)
    extrude(world.up, randBuildingHeight)
    comp(f){side: Facade | top: set(material.color.a, .3) Roof.}
Facade -->
    setupProjection(0, scope.xy, scope.sx, scope.sy)
    texture(brickMap)
    projectUV(0)
"##
}

example! {
    /// "Rotate command after the projection." The page's buildings are 1 m high; here they are 10 m.
    rotated_uv, "rotateUV operation: rotated uvs", lot(),
    r##"brickMap = "builtin:uvtest.png"
randBuildingHeight = 10
Lot -->
    s('.75,'1,'.75)
    center(xz)
    extrude(world.up, randBuildingHeight)
    comp(f){side: Facade | top: set(material.color.a, .3) Roof.}
Facade -->
    # color, uv set 0
    setupProjection(0, scope.xy, scope.sx, scope.sy)
    texture(brickMap)
    projectUV(0) # projection of the uvs
    rotateUV(0,10) # rotate command after the projection
"##
}
