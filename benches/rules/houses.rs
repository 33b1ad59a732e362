//! Houses with the same leaves and other rules.

use cga::{Grammar, cga};

/// The houses of a table, with their names.
type Houses = Vec<(&'static str, Box<dyn Grammar>)>;

/// A house whose façades have a window in each tile: the rules that differ are the arguments.
macro_rules! house {
    ($name:ident, [$($attributes:tt)*], [$($facade:tt)*], [$($window:tt)*], [$($roof:tt)*]) => {
        cga! {
            grammar $name;
            $($attributes)*
            Lot    --> comp(f) { side : Facade | top : Roof }
            @Allow(missing_asset)
            Facade --> $($facade)* split(y) { 4 : Shop. | { ~3 : Floor }* }
            Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
            Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
            Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
            Window --> $($window)*
            Roof   --> $($roof)*
        }
    };
}

house!(Constant, [], [], [color("#ff0000") extrude(0.1) Window.], [Roof.]);

cga! {
    grammar WidthArgument;
    Lot      --> comp(f) { side : Facade(1.2) | top : Roof. }
    Facade(w) --> split(y) { 4 : Shop. | { ~3 : Floor(w) }* }
    Floor(w) --> split(x) { 0.5 : Wall. | { ~2.5 : Tile(w) }* | 0.5 : Wall. }
    Tile(w)  --> split(x) { ~1 : Wall. | w : Mid | ~1 : Wall. }
    Mid      --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window   --> color("#ff0000") extrude(0.1) Window.
}

cga! {
    grammar ColourArgument;
    Lot       --> comp(f) { side : Facade("#ff0000") | top : Roof. }
    Facade(c) --> split(y) { 4 : Shop. | { ~3 : Floor(c) }* }
    Floor(c)  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile(c) }* | 0.5 : Wall. }
    Tile(c)   --> split(x) { ~1 : Wall. | 1.2 : Mid(c) | ~1 : Wall. }
    Mid(c)    --> split(y) { ~1 : Wall. | 1.5 : Window(c) | ~0.8 : Wall. }
    Window(c) --> color(c) extrude(0.1) Window.
}

cga! {
    grammar SetAttribute;
    attr w = 1.2
    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> set(w, 1.3) split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | w : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> color("#ff0000") extrude(0.1) Window.
}

/// Values that are passed from rule to rule.
pub(crate) fn arguments() -> Houses {
    vec![
        ("constants", Box::new(Constant::default())),
        ("a width as an argument", Box::new(WidthArgument::default())),
        ("a colour as an argument", Box::new(ColourArgument::default())),
        ("an attribute that a rule sets", Box::new(SetAttribute::default())),
    ]
}

house!(Plain, [], [color("#d8c8a8")], [Window.], [Roof.]);
house!(Coloured, [], [color("#d8c8a8")], [color("#ff0000") extrude(0.1) Window.], [Roof.]);
house!(DrawnAttribute, [attr wall = 60% : "#d8c8a8" 30% : "#b08060" else : "#90a0a8"], [color(wall)],
    [color("#ff0000") extrude(0.1) Window.], [Roof.]);
house!(DrawnFunction, [tint = 60% : "#d8c8a8" 30% : "#b08060" else : "#90a0a8"], [color(tint)],
    [color("#ff0000") extrude(0.1) Window.], [Roof.]);
house!(DrawnAndSet, [tint = 60% : "#d8c8a8" 30% : "#b08060" else : "#90a0a8"], [color(tint)],
    [color("#ff0000") set(material.roughness, 0.1) extrude(0.1) Window.], [Roof.]);
house!(Random, [], [color(rand(1), 0.5, 0.5)], [color("#ff0000") extrude(0.1) Window.], [Roof.]);
house!(Projected, [], [setupProjection(0, scope.xy, 2, 1) projectUV(0)], [color("#ff0000") extrude(0.1) Window.], [Roof.]);
house!(Textured, [], [setupProjection(0, scope.xy, 2, 1) projectUV(0) texture("wall.png")],
    [color("#ff0000") extrude(0.1) Window.], [Roof.]);

/// Colours of façades above windows with a constant colour.
pub(crate) fn colours() -> Houses {
    vec![
        ("constant, plain windows", Box::new(Plain::default())),
        ("constant", Box::new(Coloured::default())),
        ("an attribute with chance", Box::new(DrawnAttribute::default())),
        ("a function with chance", Box::new(DrawnFunction::default())),
        ("a function with chance, two changes", Box::new(DrawnAndSet::default())),
        ("a random number", Box::new(Random::default())),
        ("a projection", Box::new(Projected::default())),
        ("a projection with a texture", Box::new(Textured::default())),
    ]
}

house!(Unread, [attr height = 60% : 1 else : 2], [], [color("#ff0000") extrude(0.1) Window.], [extrude(height) Roof.]);
house!(Read, [attr depth = 60% : 0.1 else : 0.2], [], [color("#ff0000") extrude(depth) Window.], [Roof.]);

/// Attributes that differ from house to house.
pub(crate) fn chances() -> Houses {
    vec![
        ("no attribute", Box::new(Constant::default())),
        ("one that the roof reads", Box::new(Unread::default())),
        ("one that windows read", Box::new(Read::default())),
    ]
}

/// Houses with one more operation in each window.
macro_rules! windows {
    ($($name:ident $text:literal [$($operations:tt)*];)*) => {
        $(house!($name, [], [], [$($operations)*], [Roof.]);)*

        /// Operations in the windows.
        pub(crate) fn operations() -> Houses {
            vec![$(($text, Box::new($name::default()))),*]
        }
    };
}

windows! {
    PlainWindow "nothing" [Window.];
    Extruded "`extrude`" [extrude(0.1) Window.];
    ByArea "`case` on `geometry.area`" [case geometry.area > 1.0 : Window. else : Other.];
    ByForm "`case` on `geometry.isRectangular`" [case geometry.isRectangular(1) : Window. else : Other.];
    Turned "`r`" [r(10, 0, 0) Window.];
    Tagged "`tag`" [tag("window") Window.];
    Cube "`primitiveCube`" [s(1, 1, 0.2) primitiveCube() Window.];
    Cylinder "`primitiveCylinder`" [s(1, 1, 0.2) primitiveCylinder(8) Window.];
    Sphere "`primitiveSphere`" [s(1, 1, 0.2) primitiveSphere(8, 4) Window.];
    Tapered "`taper`" [taper(0.2) Window.];
    InnerRectangle "`innerRectangle`" [innerRectangle(scope) { shape : Window. }];
    Hip "`roofHip`" [roofHip(30) Window.];
    Gable "`roofGable`" [roofGable(30, 0.1, 0.1) Window.];
    ShapeL "`shapeL`" [shapeL(0.2, 0.3) { shape : Window. }];
    Setback "`setback`" [setback(0.1) { all : Window. | remainder : Other. }];
    Offset "`offset` and `comp`" [offset(-0.1) comp(f) { all : Window. }];
    Edges "`comp(fe)`" [comp(fe) { all : Window. }];
    Chance "a chance" [50% : Window. else : Other.];
    ChancePart "a sphere in a part, by chance" [50% : split(x) { ~1 : s(1, 1, 0.2) primitiveSphere(8, 4) Window. } else : Other.];
    Index "`split.index`" [case split.index == 0 : Window. else : Other.];
    Elevation "`scope.elevation`" [case scope.elevation > 9 : Window. else : Other.];
    RandomColour "a random colour" [color(rand(1), 0.5, 0.5) Window.];
    Projection "`setupProjection`, `projectUV`" [setupProjection(0, scope.xy, 1, 1) projectUV(0) Window.];
    Reported "`report`" [report("windows", 1) Window.];
    World "`comp(f) { world.up … }`" [extrude(0.1) comp(f) { world.up : Window. | all : Other. }];
    Aligned "`alignScopeToAxes`" [alignScopeToAxes(y) Window.];
}
