//! A row of town houses.

use cga::{Shape, cga};

use super::scene::{Scene, Start, View, grammar_text};

cga! {
    // The images are made by `examples/materials.rs`.
    @Allow(missing_asset)
    /// A town house: steps to a raised ground floor, a bay window, a cornice on brackets, dormers in a steep roof.
    pub grammar TownHouse;

    /// The number of storeys, the raised ground floor included.
    @Group("Size", 1) @Order(1) @Range(min = 2, max = 5, stepsize = 1)
    attr storeys = rint(rand(2.6, 4.4))
    /// The height of a storey in metres.
    @Order(2) @Distance @Range(min = 2.8, max = 4.5)
    attr storey = 3.5
    /// The depth of the front garden in metres.
    @Order(3) @Distance @Range(min = 3, max = 8)
    attr garden = 4
    /// True for a bay window beside the door.
    @Group("Front", 2) @Order(1)
    attr hasBay = p(0.65)
    /// The width of a window in metres.
    @Order(2) @Range(min = 0.9, max = 1.6)
    attr window = 1.15
    @Group("Colours", 3) @Enum("red", "brown", "yellow")
    attr brick = 50% : "red" 25% : "brown" else : "yellow"
    @Color
    attr stone = "#e6dcc8"
    @Color
    attr slate = "#66707c"

    const plinth = 1.2
    const iron = "#24282b"
    door = 30% : "#27475c" 30% : "#5c2328" 20% : "#2f4a37" else : "#1f1f22"
    light = 18% : "#f4d79a" else : "#3d5563"

    @StartRule
    Lot     --> split(z) { ~1 : Yard | 11 : Building | garden : Garden | 2.6 : Pavement | 0.2 : color(stone) extrude(0.12) Kerb. | 5 : Road }
    Pavement --> Paved(0.12, "#c6beb0", "paving", 1.8, 1.6)
    Road    --> Paved(0.02, "#6a6b70", "asphalt", 3, 3)
    Yard    --> Lawn
    Lawn    --> Paved(0.12, "#8aa862", "grass", 4, 4)
    Paved(height, tint, material, u, v) -->
                extrude(height) color(tint) texture(material + ".png") set(material.normalmap, material + "_normal.png") set(material.roughnessmap, material + "_rough.png")
                modify(f) { side : setupProjection(0, scope.xy, u, v) projectUV(0) | all : setupProjection(0, world.xz, u, v) projectUV(0) } Paved.
    Building --> extrude(plinth + storeys * storey + 0.8)
                comp(f) { front : Face(true) | back : Face(false) | side : setupProjection(0, scope.xy, 1.8, 1.2) Wall | top : Attic }
    // The bricks of a face continue around its openings.
    Face(isFront) --> setupProjection(0, scope.xy, 1.8, 1.2) Openings(isFront)
    Openings(isFront) --> case isFront : Front else : Back
    Back    --> split(y) { plinth : Wall | { ~storey : split(x) { { ~1 : Wall | window : Opening | ~1 : Wall }* } }* | 0.8 : Wall }

    // The front: door on the right, a bay or windows on the left, windows above.
    Front   --> split(y) { ~1 : split(x) { ~1.7 : BaySide | ~1 : DoorSide } | 0.8 : Cornice }
    DoorSide --> split(y) { plinth : Base | storey : Entrance | ~1 : Storeys }
    BaySide --> split(y) { plinth : Base | ~1 : Bays }
    Bays    --> case hasBay : split(y) { (scope.sy - storey) : split(x) { ~1 : Plain | ^0.7 : Bay | ~1 : Plain } | ~1 : Floor }
                else        : Storeys
    Base    --> color(stone) extrude(0.12) texture("stone.png") set(material.normalmap, "stone_normal.png") set(material.roughnessmap, "stone_rough.png")
                modify(f) { all : setupProjection(0, scope.xy, 2.7, 1.8) projectUV(0) } Base.
    Storeys --> split(y) { { ~storey : Floor }* }
    Floor   --> split(y) { ~1 : split(x) { { ~0.6 : Wall | window : Opening | ~0.6 : Wall }* } | 0.16 : String }
    Plain   --> split(y) { { ~storey - 0.16 : Wall | 0.16 : String }* }
    String  --> color(stone) extrude(0.08) Band.
    Wall    --> texture("brick_" + brick + ".png") set(material.normalmap, "brick_normal.png") set(material.roughnessmap, "brick_rough.png") projectUV(0) Wall.

    // An opening has a sill, a lintel with a keystone, and a sash window deep in the wall.
    Opening --> split(y) { ^0.22 : Wall | 0.12 : Sill | ~1 : Window | 0.28 : Lintel | ^0.12 : Wall }
    Sill    --> color(stone) s(scope.sx + 0.2, ^1, 0) center(x) extrude(0.16) Sill.
    Lintel  --> color(stone) [ s(scope.sx + 0.24, ^1, 0) center(x) extrude(0.06) Lintel. ]
                s(0.22, 0.36, 0) center(x) extrude(0.12) Keystone.
    Window  --> [ Recess(0.18) ] t(0, 0, -0.18) color(light) split(x) { 0.08 : Frame | ~1 : Sash | 0.08 : Frame }
    Recess(depth) --> set(trim.vertical, false) t(0, 0, -depth) s(^1, ^1, depth) primitiveCube reverseNormals comp(f) { front : NIL | back : NIL | all : Reveal }
    Reveal  --> color("#f1ece0") Reveal.
    Sash    --> split(y) { 0.08 : Frame | ~1 : Panes | 0.07 : Frame | ~1 : Panes | 0.08 : Frame }
    Panes   --> split(x) { ~1 : Pane | 0.04 : Frame | ~1 : Pane }
    Pane    --> set(material.roughness, 0.1) Glass.
    Frame   --> color("#f6f2e8") extrude(0.07) Frame.

    // The bay: the scope of a face that was extruded has y outwards, so the front of the bay is its top, and y of its sides is turned up.
    Bay     --> extrude(0.9) comp(f) { top : BayWall(false) | world.up : color(slate) Lead. | left : Flank | right : Flank | all : Panel }
    Flank   --> alignScopeToAxes(y) BayWall(true)
    BayWall(isSide) --> split(y) { { ~storey : split(y) { 0.8 : Panel | ~1 : BayWindows(isSide) | 0.4 : Panel } }* }
    BayWindows(isSide) -->
                case isSide : split(x) { 0.2 : Panel | ~1 : [ Recess(0.18) ] t(0, 0, -0.18) color(light) SideSash | 0.2 : Panel }
                else        : split(x) { 0.14 : Frame | { ~1.1 : Window | 0.14 : Frame }* }
    SideSash --> split(x) { 0.08 : Frame | ~1 : split(y) { 0.08 : Frame | ~1 : Pane | 0.07 : Frame | ~1 : Pane | 0.08 : Frame } | 0.08 : Frame }
    Panel   --> color(stone) Panel.

    // The entrance: two leaves below a fanlight, between pilasters that carry a hood.
    Entrance --> split(y) { ~1 : split(x) { ~1 : Wall | 0.3 : Pilaster | 1.25 : Portal | 0.3 : Pilaster | ~1 : Wall } | 0.3 : Hood | 0.14 : Wall | 0.16 : String }
                t(0, -plinth, 0.12) s(1.9, plinth, 2.48) center(x) primitiveCube split(y) { { ~0.17 : Step(split.index, split.total) }* }
    Pilaster --> color(stone) extrude(0.16) Pilaster.
    Hood    --> [ Wall ] color(stone) s(2.3, ^1, 0) center(x) extrude(0.55) Hood.
    Portal  --> [ Recess(0.2) ] t(0, 0, -0.2) split(y) { ~1 : color(door) split(x) { ~1 : Leaf | 0.03 : Leaf | ~1 : Leaf } | 0.08 : Frame | 0.5 : color("#3d5563") Panes }
    Leaf    --> extrude(0.05) Door.
    Step(n, total) --> split(z) { (0.9 + 1.7 * (1 - n / (total - 1))) : color(stone) Step. | ~1 : NIL }

    Cornice --> [ Wall ] color(stone) [ split(y) { ~1 : split(x) { { 0.16 : Bracket | ~0.5 : NIL }* | 0.16 : Bracket } | 0.3 : NIL } ]
                split(y) { ~1 : extrude(0.1) Frieze. | 0.3 : extrude(0.5) Cornice. }
    Bracket --> extrude(0.36) Bracket.

    // A mansard with dormers, between party walls with chimneys.
    Attic   --> split(x) { 0.35 : Party | ~1 : Mansard | 0.35 : Party }
    Party   --> [ extrude(3.2) Brickwork ] alignScopeToAxes(y) t(0, 3.28, 0) s(^1, 1.5, 1.6) center(z) primitiveCube Brickwork
    Brickwork --> comp(f) { top : color(stone) extrude(0.08) Coping. | bottom : NIL | all : setupProjection(0, scope.xy, 1.8, 1.2) Wall }
    Mansard --> envelope(normal, 2.9, 0, 68, 0, 68, 0, 90)
                comp(f) { bottom : NIL | top : color("#8b8d8f") Flat. | object.front : Slope | all : Slate }
    Slate   --> setupProjection(0, scope.xy, 2, 2) color(slate) texture("slate.png") set(material.normalmap, "slate_normal.png") set(material.roughnessmap, "slate_rough.png") projectUV(0) Slate.
    Slope   --> [ Slate ] split(x) { { ~1 : NIL | window : Dormer | ~1 : NIL }* }
    Dormer  --> alignScopeToAxes(y) t(0, 0.45, 0.1) s(^1, 1.6, 1.05) primitiveCube
                comp(f) { front : DormerFront | side : Reveal | top : color(slate) roofGable(35, 0.1) DormerRoof. }
    DormerFront --> split(x) { 0.1 : Reveal | ~1 : split(y) { 0.1 : Reveal | ~1 : Window | 0.1 : Reveal } | 0.1 : Reveal }

    Garden  --> split(x) { ~1.7 : Bed | ~1 : split(x) { ~1 : Bed | 1.9 : Path | ~1 : Bed } }
    Path    --> Paved(0.1, "#c6beb0", "paving", 1.8, 1.6)
    Bed     --> case scope.sx < 1 : Lawn else : split(z) { ~1 : Planted | 0.3 : Fence }
    Planted --> [ Lawn ] Shrubs
    Shrubs  --> case scope.sx < 2 : NIL
                else              : s(scope.sx - 1, 0, scope.sz - 1) center(xz) scatter(surface, ceil(2.5 * scope.sx), uniform) { Shrub }
    Shrub   --> s(0.9, rand(0.5, 1.1), 0.9) center(xz) primitiveSphere(12, 8) scaleUV(0, 3, 1.5) color("#7da052")
                texture("leaves.png") set(material.normalmap, "leaves_normal.png") Shrub.
    Fence   --> [ extrude(0.5) color(stone) Kerb. ] t(0, 0.5, 0.13) s(^1, 0.9, 0.04) primitiveCube color(iron)
                split(x) { { 0.04 : Bar. | ~0.13 : split(y) { ~1 : NIL | 0.04 : Rail. | 0.12 : NIL } }* | 0.04 : Bar. }
}

pub fn scene() -> Scene<()> {
    let mut x = 0.0;
    let mut shapes = Vec::new();
    for (seed, width) in [(5, 7.2), (11, 6.6), (4, 7.6), (23, 6.8)] {
        shapes.push(Start::new("Lot", Shape::rectangle(width, 20.0).at([x, 0.0, 0.0]).seed(seed)));
        x += width;
    }
    Scene {
        name: "town_house",
        title: "Town houses",
        sentence: "Four lots, one grammar: chance, seeded by each lot, decides storeys, brick, bay and door.",
        rules: grammar_text(include_str!("town_house.rs")),
        grammar: (),
        shapes,
        view: View {
            azimuth: 30.0,
            elevation: 10.0,
            region: Some([[0.0, 0.5, 4.0], [28.2, 20.0, 18.5]]),
            ..View::default()
        },
    }
}
